//! Arguments of `seamwright vision scan`.

use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright vision scan scan/series.csv --job job.toml
  seamwright vision scan scan/series.csv --job job.toml --after-layer 1 -o job-2.toml
  seamwright vision scan images.csv --job job.toml --machine dual-laser-10axis --sensor left --toml >> job.toml
A series is CSV with the columns s_mm,file or x_mm,y_mm,z_mm,file: a row a profile (CSV with y_mm,z_mm) or an image of
the stripe, named from the folder of the series, in any order. An empty file is a missing profile. y runs from the second
part to the first, z to the sensor. Out: a row a profile with each value and its standard uncertainty (_u_). Exit code 1
if no profile shows the joint over more than --bridge-mm; standard error says where."
)]
pub(crate) struct ScanArgs {
    /// Table of the profiles along the seam
    pub(crate) series: PathBuf,
    /// Job with the seam and the drawn joint, or the name of an example
    #[arg(long, value_name = "JOB")]
    pub(crate) job: PathBuf,
    /// Number of complete layers in the groove
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) after_layer: u16,
    /// Machine with the sensor of images
    #[arg(long, value_name = "M", requires = "sensor", conflicts_with = "mm_per_px")]
    pub(crate) machine: Option<String>,
    /// Sensor of the images: its map converts pixels to mm
    #[arg(long, value_name = "NAME", requires = "machine")]
    pub(crate) sensor: Option<String>,
    /// Scale of images with square pixels, mm
    #[arg(long, value_name = "S")]
    pub(crate) mm_per_px: Option<f64>,
    /// y runs from the first part to the second
    #[arg(long)]
    pub(crate) mirrored: bool,
    /// Angle of the sensor from the middle between the groove's edges, degrees, positive to the first part; known within 15
    #[arg(long, value_name = "T", default_value_t = 0.0)]
    pub(crate) turn_deg: f64,
    /// Maximum length of seam between two measured profiles, mm: the groove is linear there
    #[arg(long, value_name = "L", default_value_t = 60.0)]
    pub(crate) bridge_mm: f64,
    /// Print [[joint.fit_up]] tables instead of CSV
    #[arg(long, conflicts_with = "json")]
    pub(crate) toml: bool,
    /// Write the job with the measured groove to this file
    #[arg(short, long, value_name = "NEW.toml")]
    pub(crate) output: Option<PathBuf>,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}
