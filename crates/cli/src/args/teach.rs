//! Arguments of `seamwright teach`.

use super::reduce::MethodArg;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright teach examples/oblique-girth.toml --frames simulated --seed 7 -o taught.toml
  seamwright teach examples/saddle.toml --frames simulated --tack 100,106 --record frames -o taught.toml
  seamwright teach examples/saddle.toml --frames frames -o again.toml
  seamwright teach examples/saddle.toml --semi-manual touched.csv -o taught.toml
The job says which machine, where the seam nominally is, and speed and process of the program. A folder of frames has images and
frames.csv: file,t_s, a column for each axis, perhaps height_mm. Beside the program are its report, FILE.report.json, and
FILE.svg. Exit code 1: the joint was lost or the machine could go no further; program and report hold what was found."
)]
pub(crate) struct TeachArgs {
    /// Job file: the machine and the nominal seam
    pub(crate) job: PathBuf,
    /// Folder of recorded frames, or the word simulated
    #[arg(long, value_name = "DIR|simulated", required_unless_present = "semi_manual")]
    pub(crate) frames: Option<String>,
    /// Points on the joint that the operator has jogged to (CSV: x_mm,y_mm,z_mm in the machine's work frame), the nominal seam
    /// between them, instead of frames
    #[arg(long, value_name = "POINTS.csv", conflicts_with = "frames")]
    pub(crate) semi_manual: Option<PathBuf>,
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
    /// How far the program's lines and arcs may be from the line that was found, mm
    #[arg(long, value_name = "MM", default_value_t = 0.05)]
    pub(crate) tolerance_mm: f64,
    /// How far the torch's direction may be from the one that was found, degrees
    #[arg(long, value_name = "DEG", default_value_t = 0.5)]
    pub(crate) attitude_deg: f64,
    /// How the line is cut into lines and arcs
    #[arg(long, value_enum, default_value_t = MethodArg::Greedy)]
    pub(crate) method: MethodArg,
    /// Simulation: seed of where the seam actually is, and of the noise
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// Simulation: how far the part is shifted (mm), turned (degrees) and bent (mm)
    #[arg(long, value_name = "MM,DEG,MM", value_delimiter = ',', default_values_t = [1.0, 0.3, 1.0])]
    pub(crate) distortion: Vec<f64>,
    /// Simulation: a tack hides the joint between these path lengths, mm; may be given again
    #[arg(long, value_name = "FROM,TO")]
    pub(crate) tack: Vec<String>,
    /// Simulation: no focus or stripe tells the height of the work; it is taken as nominal
    #[arg(long)]
    pub(crate) no_height: bool,
    /// Simulation: also write the frames to this folder, to be played again
    #[arg(long, value_name = "DIR")]
    pub(crate) record: Option<PathBuf>,
    /// Print the report as JSON instead of a summary
    #[arg(long)]
    pub(crate) json: bool,
}
