//! Arguments of `seamwright vision stripe`.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright vision stripe frame.png --joint fillet --machine dual-laser-10axis --sensor left --overlay seen.png
  seamwright vision stripe frame.png --joint v --mm-per-px 0.05
  seamwright vision stripe profile.csv --joint lap --thickness-mm 2 --json
A profile is CSV with the columns y_mm,z_mm; places without numbers are missing. An image is PNG, JPEG or PNM, its
stripe runs from left to right. Out: a row a feature, then a row a value with where it belongs. Without --machine or
--mm-per-px lengths are in pixels. Exit code 1 if there is no such joint, or it is too uncertain to be followed; the last
line on standard error says why."
)]
pub(crate) struct StripeArgs {
    /// Image of the stripe, or CSV of its profile (- for standard input)
    pub(crate) input: PathBuf,
    /// Expected joint
    #[arg(long, value_enum)]
    pub(crate) joint: JointArg,
    /// Machine with the sensor
    #[arg(long, value_name = "M", requires = "sensor", conflicts_with = "mm_per_px")]
    pub(crate) machine: Option<String>,
    /// Sensor of the image: its map converts pixels to mm
    #[arg(long, value_name = "NAME", requires = "machine")]
    pub(crate) sensor: Option<String>,
    /// Scale of an image with square pixels, mm; its centre is the origin
    #[arg(long, value_name = "S")]
    pub(crate) mm_per_px: Option<f64>,
    /// Thickness of a lap joint's upper sheet, for the gap below it; without a map in pixels
    #[arg(long, value_name = "T")]
    pub(crate) thickness_mm: Option<f64>,
    /// Draw the detected stripe over the image to this PNG
    #[arg(long, value_name = "FILE.png")]
    pub(crate) overlay: Option<PathBuf>,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}

/// Joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum JointArg {
    /// Two faces at 60 to 120 degrees
    Fillet,
    /// V groove
    V,
    /// One sheet on another
    Lap,
    /// Two plates end to end
    Butt,
    /// U groove
    U,
    /// J groove
    J,
}
