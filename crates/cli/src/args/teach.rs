//! Arguments of `seamwright teach`.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright teach examples/oblique-girth.toml --frames simulated --seed 7 -o taught.toml
  seamwright teach examples/saddle.toml --frames simulated --tack 100,106 --record frames -o taught.toml
  seamwright teach examples/saddle.toml --frames frames --method spline -o again.toml
  seamwright teach examples/saddle.toml --frames tcp://scanner:5025 --drive -o taught.toml
  seamwright teach examples/saddle.toml --semi-manual touched.csv -o taught.toml
The job has the machine, the nominal seam, the torch's angles, and speed and process of the program. A folder of
frames has images and frames.csv: file,t_s, a column for each axis, optionally height_mm. Beside the program are its report,
FILE.report.json, FILE.svg, and FILE.png: the last frame with the detected joint. Where the joint is lost the operator is
asked, if standard input is a terminal or with --ask. Exit code 1: the joint was lost or the machine could go no further;
program and report hold the joint up to there."
)]
pub(crate) struct TeachArgs {
    /// Job file, or the name of an example: the machine and the nominal seam
    pub(crate) job: PathBuf,
    /// Folder of recorded frames, the address of a sender of frames, or the word simulated
    #[arg(long, value_name = "DIR|tcp://HOST:PORT|simulated", required_unless_present = "semi_manual")]
    pub(crate) frames: Option<String>,
    /// Points on the joint instead of frames (CSV: x_mm,y_mm,z_mm in the machine's work frame), with the nominal seam between
    /// them
    #[arg(long, value_name = "POINTS.csv", conflicts_with_all = ["frames", "drive", "timeout_s", "sensor", "start", "direction",
        "step_mm", "longest_tack_mm", "ask", "record"])]
    pub(crate) semi_manual: Option<PathBuf>,
    /// Command the camera's moves before each frame; otherwise the sender of frames moves it
    #[arg(long)]
    pub(crate) drive: bool,
    /// Timeout for the sender's next frame, s
    #[arg(long, value_name = "S", default_value_t = 10.0)]
    pub(crate) timeout_s: f64,
    /// Write the program to this file
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: PathBuf,
    /// Camera of the machine [default: its only one]
    #[arg(long, value_name = "NAME")]
    pub(crate) sensor: Option<String>,
    /// Start of the joint in the machine's work frame, mm [default: the start of the simulated operator; the
    /// middle of the first frame]
    #[arg(long, value_name = "X,Y,Z", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) start: Option<Vec<f64>>,
    /// Approximate direction of the joint there [default: that of the nominal seam]
    #[arg(long, value_name = "X,Y,Z", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) direction: Option<Vec<f64>>,
    /// Maximum step from frame to frame, mm
    #[arg(long, value_name = "MM", default_value_t = 8.0)]
    pub(crate) step_mm: f64,
    /// Maximum length of a tack that is crossed without a question, mm
    #[arg(long, value_name = "MM", default_value_t = 10.0)]
    pub(crate) longest_tack_mm: f64,
    /// Ask on standard input when the joint is lost, also without a terminal: a line with X,Y,Z (work frame, mm) or
    /// X,Y,Z,DX,DY,DZ continues there, end ends the joint, stop gives up
    #[arg(long)]
    pub(crate) ask: bool,
    /// Maximum distance of the program's curves from the taught line, mm
    #[arg(long, value_name = "MM", default_value_t = 0.05)]
    pub(crate) tolerance_mm: f64,
    /// Maximum deviation of the torch's direction from the taught one, degrees
    #[arg(long, value_name = "DEG", default_value_t = 0.5)]
    pub(crate) attitude_deg: f64,
    /// Curves of the program
    #[arg(long, value_enum, default_value_t = TeachMethod::Greedy)]
    pub(crate) method: TeachMethod,
    /// Simulation: seed of the seam's displacement and of the noise [default: 1]
    #[arg(long)]
    pub(crate) seed: Option<u64>,
    /// Simulation: shift (mm), turn (degrees) and bend (mm) of the part [default: 1,0.3,1]
    #[arg(long, value_name = "MM,DEG,MM", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) distortion: Option<Vec<f64>>,
    /// Simulation: a tack hides the joint between these path lengths, mm; may be repeated
    #[arg(long, value_name = "FROM,TO", allow_hyphen_values = true)]
    pub(crate) tack: Vec<String>,
    /// Simulation: the height of the work is not measured, the nominal height is used
    #[arg(long)]
    pub(crate) no_height: bool,
    /// Also write the frames to this folder, for replay
    #[arg(long, value_name = "DIR")]
    pub(crate) record: Option<PathBuf>,
    /// Print the report as JSON instead of a summary
    #[arg(long)]
    pub(crate) json: bool,
}

/// Curves of a taught program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum TeachMethod {
    /// Lines and arcs: the longest run from the start, then the next (EBW-2004)
    Greedy,
    /// Lines and arcs, the minimum number
    Fewest,
    /// A cubic B-spline through few of its points
    Spline,
}
