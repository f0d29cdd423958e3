//! Sensors on the machine that detect the joint.

use glam::DAffine3;
use schemars::JsonSchema;
use seamwright_document::{Finite, Positive, Transform};
use seamwright_geometry::{HeightTable, Homography};
use serde::Deserialize;

/// A sensor in the machine file.
///
/// A sensor has a frame of its own: x along the seam, away from the torch; y across the seam; z from the work to the
/// sensor. So `at` has the distance by which the sensor leads the torch.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SensorFile {
    /// What it is.
    pub kind: SensorKind,
    /// The link that carries it: an axis (what it moves), `base`, `work`, `torch` or a head.
    pub on: String,
    /// The sensor's frame in that link's frame.
    #[serde(default)]
    pub at: Transform,
    /// Columns and rows of its images.
    pub size_px: [u16; 2],
    /// How pixels become mm: in the plane of a stripe sensor's laser, on the work before a camera.
    pub map: Option<PixelMapFile>,
    /// Time from frame to frame, ms; 100 if missing.
    pub period_ms: Option<Positive>,
    /// Time from an exposure until what was seen is known, ms; 15 if missing.
    pub latency_ms: Option<Positive>,
    /// Standard deviation of the joint's place as it is seen, mm; 0.02 if missing.
    pub noise_mm: Option<Positive>,
    /// Where a camera's frames come from on the machine: `tcp://HOST:PORT`, a stream (docs/reference/vision-sources.md). Without it
    /// frames are simulated, or come from where a command is told.
    pub frames: Option<String>,
}

/// Kinds of sensors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SensorKind {
    /// A laser throws a stripe across the joint, in the plane x = 0 of the sensor's frame; a camera sees it at an angle.
    Stripe,
    /// A picture of the work, seen along z from above: of a camera, or of an electron beam that scans it. The picture's x is
    /// that of the sensor's frame, its rows count against y.
    Camera,
}

/// How pixels (column, row; rows count downwards) become mm. Of a stripe sensor: y and z in the plane of its laser.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum PixelMapFile {
    /// A camera without distortion that looks at the origin of the sensor's frame, its rows along y.
    Camera {
        /// Distance of its pinhole from the origin, mm.
        distance_mm: Positive,
        /// Angle at which it looks at the plane of the laser, degrees: between its axis and that plane.
        angle_deg: Positive,
        /// Focal length, pixels.
        focal_px: Positive,
        /// Column and row where its axis meets the image; the middle if missing.
        centre_px: Option<[Finite; 2]>,
    },
    /// The first eight numbers of a calibrated homography, row after row, the ninth is 1: with w = h7 column + h8 row + 1,
    /// y = (h1 column + h2 row + h3) / w and z = (h4 column + h5 row + h6) / w, mm.
    Homography([Finite; 8]),
    /// The same scale everywhere: y grows with the column, z against the row; negative numbers turn that round.
    Scale {
        /// mm a column, and mm a row.
        mm_per_px: [Finite; 2],
        /// Column and row of the origin; the middle if missing.
        origin_px: Option<[Finite; 2]>,
    },
    /// Of a camera: its scale on planes square to its axis; between them everything is linear. One row is for every height.
    Heights(Vec<HeightRowFile>),
}

/// How a camera sees one plane square to its axis.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeightRowFile {
    /// The plane's z in the sensor's frame, mm: towards the camera.
    #[serde(default)]
    pub z_mm: Finite,
    /// mm a column, and mm a row.
    pub mm_per_px: [Positive; 2],
    /// Column and row of the sensor's z axis; the middle if missing.
    pub centre_px: Option<[Finite; 2]>,
    /// By which angle the picture's x lies turned from the sensor's x towards its rows, degrees.
    #[serde(default)]
    pub rotation_deg: Finite,
    /// By how many mm a step of 1 mm down the picture also goes along its x.
    #[serde(default)]
    pub shear: Finite,
    /// The part by which half a width from the centre pixels lie further out than without distortion: negative in a
    /// barrel, positive in a cushion.
    #[serde(default)]
    pub barrel: Finite,
}

/// A sensor on a machine.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensor {
    /// Name, as in the machine file.
    pub name: String,
    /// The link that carries it, as an index into [`crate::LinkFrames`].
    pub link: usize,
    /// Its frame in the work frame with all axes at zero.
    pub zero: DAffine3,
    /// Columns and rows of its images.
    pub size_px: [usize; 2],
    /// Time from frame to frame, s.
    pub period_s: f64,
    /// Latency from the exposure to the result, s.
    pub latency_s: f64,
    /// Standard deviation of the measured joint position, mm.
    pub noise_mm: f64,
    /// Kind of measurement.
    pub sight: Sight,
    /// Host and port of a camera's stream of frames.
    pub frames: Option<String>,
}

/// Measurement of a sensor, by its kind.
#[derive(Debug, Clone, PartialEq)]
pub enum Sight {
    /// A laser stripe across the joint.
    Stripe(StripeSensor),
    /// The work from above.
    Camera(CameraSensor),
}

/// A stripe sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripeSensor {
    /// Maps (column, row) to (y, z) in the sensor's frame, mm. It is defined for every pixel of the image.
    pub to_mm: Homography,
}

/// A camera, or a beam that scans the work.
#[derive(Debug, Clone, PartialEq)]
pub struct CameraSensor {
    /// Maps pixels to the *camera's frame*, mm: x to the right in the picture, y down, z away from the camera; it is
    /// the sensor's frame turned about x by half a turn.
    pub table: HeightTable,
}
