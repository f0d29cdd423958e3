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
The job says which machine, where the seam nominally is, the torch's angles, and speed and process of the program. A folder of
frames has images and frames.csv: file,t_s, a column for each axis, perhaps height_mm. Beside the program are its report,
FILE.report.json, FILE.svg, and FILE.png: the last frame with what was found in it. Where the joint is lost the operator is
asked, if standard input is a terminal or with --ask. Exit code 1: the joint was lost or the machine could go no further;
program and report hold what was found."
)]
pub(crate) struct TeachArgs {
    /// Job file, or the name of an example: the machine and the nominal seam
    pub(crate) job: PathBuf,
    /// Folder of recorded frames, the address of a sender of frames, or the word simulated
    #[arg(long, value_name = "DIR|tcp://HOST:PORT|simulated", required_unless_present = "semi_manual")]
    pub(crate) frames: Option<String>,
    /// Points on the joint that the operator has jogged to (CSV: x_mm,y_mm,z_mm in the machine's work frame), the nominal seam
    /// between them, instead of frames
    #[arg(long, value_name = "POINTS.csv", conflicts_with_all = ["frames", "drive", "timeout_s", "sensor", "start", "direction",
        "step_mm", "longest_tack_mm", "ask", "record"])]
    pub(crate) semi_manual: Option<PathBuf>,
    /// Tell the sender of frames where to move before each frame; without it the moves are somebody else's
    #[arg(long)]
    pub(crate) drive: bool,
    /// How long to wait for the sender's next frame, s
    #[arg(long, value_name = "S", default_value_t = 10.0)]
    pub(crate) timeout_s: f64,
    /// Write the program to this file
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: PathBuf,
    /// Camera of the machine [default: its only one]
    #[arg(long, value_name = "NAME")]
    pub(crate) sensor: Option<String>,
    /// Where the joint begins, in the machine's work frame, mm [default: where the operator of the simulation puts the cross; the
    /// middle of the first frame]
    #[arg(long, value_name = "X,Y,Z", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) start: Option<Vec<f64>>,
    /// Roughly where it goes from there [default: as the nominal seam]
    #[arg(long, value_name = "X,Y,Z", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) direction: Option<Vec<f64>>,
    /// Longest step from frame to frame, mm
    #[arg(long, value_name = "MM", default_value_t = 8.0)]
    pub(crate) step_mm: f64,
    /// Longest tack that is passed without asking, mm
    #[arg(long, value_name = "MM", default_value_t = 10.0)]
    pub(crate) longest_tack_mm: f64,
    /// Ask on standard input where the joint is lost, though it is no terminal: a line with X,Y,Z (work frame, mm) or
    /// X,Y,Z,DX,DY,DZ goes on there, end says that the joint ends, stop gives up
    #[arg(long)]
    pub(crate) ask: bool,
    /// How far the program's curves may be from the line that was found, mm
    #[arg(long, value_name = "MM", default_value_t = 0.05)]
    pub(crate) tolerance_mm: f64,
    /// How far the torch's direction may be from the one that was found, degrees
    #[arg(long, value_name = "DEG", default_value_t = 0.5)]
    pub(crate) attitude_deg: f64,
    /// What the line is reduced to
    #[arg(long, value_enum, default_value_t = TeachMethod::Greedy)]
    pub(crate) method: TeachMethod,
    /// Simulation: seed of where the seam actually is, and of the noise [default: 1]
    #[arg(long)]
    pub(crate) seed: Option<u64>,
    /// Simulation: how far the part is shifted (mm), turned (degrees) and bent (mm) [default: 1,0.3,1]
    #[arg(long, value_name = "MM,DEG,MM", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) distortion: Option<Vec<f64>>,
    /// Simulation: a tack hides the joint between these path lengths, mm; may be given again
    #[arg(long, value_name = "FROM,TO", allow_hyphen_values = true)]
    pub(crate) tack: Vec<String>,
    /// Simulation: no focus or stripe tells the height of the work; it is taken as nominal
    #[arg(long)]
    pub(crate) no_height: bool,
    /// Also write the frames to this folder, to be played again
    #[arg(long, value_name = "DIR")]
    pub(crate) record: Option<PathBuf>,
    /// Print the report as JSON instead of a summary
    #[arg(long)]
    pub(crate) json: bool,
}

/// What a taught line is reduced to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum TeachMethod {
    /// Lines and arcs: the longest run from the start, then the next (EBW-2004)
    Greedy,
    /// Lines and arcs, as few as can be
    Fewest,
    /// A cubic B-spline through few of its points
    Spline,
}
