//! Arguments of `seamwright vision joint`.

use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright vision joint frame.png --start 40,256 --direction-deg 0 > midline.csv
  seamwright vision joint frame.png --start 40,256 --direction-deg 0 --width-px 6 --overlay seen.png
  seamwright vision joint frame.png --start 40,256 --direction-deg 0 --zone-px 0,200,511,320 --json
Pixel centres have whole coordinates, x to the right, y down, 0,0 the first; directions turn from x to y, clockwise as
seen. The last line on standard error says why the line ends: left-image, joint-end, closed or lost. Exit code 1 if
there is no joint at the start."
)]
pub(crate) struct FindJointArgs {
    /// Image, PNG, JPEG or PNM (- for standard input): the joint is a dark line on lighter metal
    pub(crate) image: PathBuf,
    /// Position on the joint, pixels
    #[arg(long, value_delimiter = ',', num_args = 1, allow_hyphen_values = true, value_name = "X,Y", required = true)]
    pub(crate) start: Vec<f64>,
    /// Rough direction of the joint there, degrees
    #[arg(long, value_name = "D")]
    pub(crate) direction_deg: f64,
    /// Width of the joint at half its depth, pixels, 1 to 400 [default: found at the start]
    #[arg(long, value_name = "W")]
    pub(crate) width_px: Option<f64>,
    /// Detection zone: left, top, right, bottom [default: the whole image]
    #[arg(long, value_delimiter = ',', num_args = 1, allow_hyphen_values = true, value_name = "LEFT,TOP,RIGHT,BOTTOM")]
    pub(crate) zone_px: Option<Vec<f64>>,
    /// Draw midline, start, motion and detection zone over the image to this PNG
    #[arg(long, value_name = "FILE.png")]
    pub(crate) overlay: Option<PathBuf>,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}
