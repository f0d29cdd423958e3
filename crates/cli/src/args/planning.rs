use clap::Args;
use seamwright_report::Extent;

/// Limits of planning.
#[derive(Debug, Args)]
pub(crate) struct PlanningArgs {
    /// Time limit of planning's searches over all passes, s; at the limit the findings report the progress
    #[arg(long, value_name = "S", default_value_t = 60.0)]
    pub(crate) time_limit: f64,
}

/// Content of the report.
#[derive(Debug, Args)]
pub(crate) struct AppendixArgs {
    /// Add an appendix to report.html: curves of axes, speed and torch, more cross-sections, and the text of the job
    #[arg(long)]
    appendix: bool,
}

impl AppendixArgs {
    pub(crate) fn extent(&self) -> Extent {
        if self.appendix { Extent::WithAppendix } else { Extent::Summary }
    }
}

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  echo 'x,y,z,a,c
7.1077,33.3687,32.0754,8,60' | seamwright machine kinematics table-tilting-xyzac --forward
  echo 'x_mm,y_mm,z_mm,ax,ay,az
10,5,0,0,0,-1' | seamwright machine kinematics ellipse-xy --inverse"
)]
pub(crate) struct KinematicsArgs {
    /// Shipped machine, or a machine file
    pub(crate) machine: String,
    /// Axis positions (mm, degrees) to torch tip and direction in the work frame
    #[arg(long, group = "way", required_unless_present = "inverse")]
    pub(crate) forward: bool,
    /// Torch tip and direction to axis positions
    #[arg(long, group = "way")]
    pub(crate) inverse: bool,
    /// Head of a machine with two heads [default: the first]
    #[arg(long, value_name = "NAME")]
    pub(crate) head: Option<String>,
    /// With --inverse: the rows are one path; solve each row near the previous one, counting turns
    #[arg(long, requires = "inverse")]
    pub(crate) continuous: bool,
    /// With --inverse: every branch of every row, with the number of its row
    #[arg(long, requires = "inverse", conflicts_with = "continuous")]
    pub(crate) branches: bool,
    /// The direction across the torch too (ux, uy, uz), so that a row is a whole frame
    #[arg(long)]
    pub(crate) frame: bool,
    /// Configuration of an arm: shoulder, elbow, wrist, whole turns of its axes, and the arm angle of seven axes
    #[arg(long)]
    pub(crate) configuration: bool,
    /// With --inverse: arm angle of a seven-axis arm; its third axis stays at home if missing
    #[arg(long, requires = "inverse", value_name = "A", allow_negative_numbers = true)]
    pub(crate) arm_angle_deg: Option<f64>,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}
