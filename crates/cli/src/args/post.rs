//! Arguments of `seamwright post`.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PostTargetArg {
    /// Siemens Sinumerik 840D
    Sinumerik,
    /// LinuxCNC 2.8 or newer
    Linuxcnc,
    /// grblHAL
    Grblhal,
    /// Turbo PMAC motion program
    Pmac,
    /// ABB RAPID with RobotWare Arc
    Rapid,
    /// KUKA KRL
    Krl,
    /// FANUC teach pendant program as text
    FanucLs,
    /// Universal Robots URScript
    Urscript,
    /// Yaskawa INFORM job
    Inform,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FeedArg {
    /// Times of blocks: G93; PMAC: TM
    InverseTime,
    /// mm/min along the path of the control: G94; PMAC: mm/s
    PerMinute,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum InterpolationArg {
    /// Positions and speeds in time
    Pvt,
    /// Splines with equal times
    Spline1,
    /// Lines and arcs
    Linear,
    /// Polynomials of the third degree: POLY
    Poly,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum LevelArg {
    /// Axis positions; identity kinematics in the control
    Joint,
    /// Torch tip in the work frame and rotary axes; matching kinematics in the control
    Tip,
}

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Example: seamwright post examples/saddle.toml --dialect linuxcnc > saddle.ngc"
)]
pub(crate) struct PostArgs {
    /// Program or job file, or the name of an example
    pub(crate) job: PathBuf,
    #[command(flatten)]
    pub(crate) planning: super::planning::PlanningArgs,
    /// The control
    #[arg(long, value_enum)]
    pub(crate) dialect: PostTargetArg,
    /// Meaning of the blocks' words; not for robots [default: joint]
    #[arg(long, value_enum)]
    pub(crate) level: Option<LevelArg>,
    /// Feed words of blocks; not for robots [default: inverse-time]
    #[arg(long, value_enum)]
    pub(crate) feed: Option<FeedArg>,
    /// Type of blocks: pvt, spline1 or linear for PMAC [default: pvt], linear or poly for Sinumerik [default: linear]; not
    /// for robots
    #[arg(long, value_enum)]
    pub(crate) interpolation: Option<InterpolationArg>,
    /// Maximum distance of the blocks' path from the seam, mm [default: 0.01; robots: 0.05]
    #[arg(long, value_name = "MM")]
    pub(crate) tolerance_mm: Option<f64>,
    /// Maximum deviation of the tip's speed inside blocks longer than 10 ms, outside acceleration and deceleration phases,
    /// percent of the planned speed; not for weaving passes [default: 1; robots: 2]
    #[arg(long, value_name = "PERCENT")]
    pub(crate) speed_percent: Option<f64>,
    /// URScript: set-points every MS ms (servoj) in the place of lines and arcs, 2 to 40 in steps of 2
    #[arg(long, value_name = "MS")]
    pub(crate) servo_ms: Option<f64>,
    /// Look-ahead time of the set-points, s, 0.03 to 0.2 [default: 0.1]
    #[arg(long, value_name = "S")]
    pub(crate) lookahead_s: Option<f64>,
    /// Gain of the set-points, 100 to 2000 [default: 300]
    #[arg(long, value_name = "GAIN")]
    pub(crate) gain: Option<f64>,
    /// Retract distance of the torch along its axis before and after the weld, mm [default: the job's air.retract_mm]
    #[arg(long, value_name = "MM")]
    pub(crate) retract_mm: Option<f64>,
    /// Print the comparison of the part program, read back, with the plan; a program that differs is never written
    #[arg(long)]
    pub(crate) verify: bool,
    /// Write this comparison to this file, as JSON
    #[arg(long, value_name = "FILE")]
    pub(crate) proof: Option<PathBuf>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}
