use super::message::MessageView;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// `GET /api/parameters`: axes, drives and tools in the machine file of the cell's job.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ParametersView {
    /// Title of the machine.
    pub machine: String,
    /// The file, among the jobs, in which changes are kept.
    pub file: String,
    /// A change is not in force yet: it takes effect when the job is loaded again with the drives off.
    pub pending: bool,
    /// In the order of the machine's axes.
    pub axes: Vec<AxisParameters>,
    /// Torches, beams or lasers.
    pub heads: Vec<HeadView>,
}

/// A torch, beam or laser.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct HeadView {
    /// Its name.
    pub name: String,
    /// Its tip in the last frame of its steps, mm.
    pub tip_mm: [f64; 3],
}

/// An axis with its drive.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct AxisParameters {
    /// Its name.
    pub name: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// The machine file describes its drive.
    pub has_drive: bool,
    /// All possible values, with the keys of machine files.
    pub values: Vec<ParameterView>,
    /// Notch filters of the speed command: frequency, Hz, depth (gain at the centre), width, Hz.
    pub notches: Vec<[f64; 3]>,
}

/// A number of the machine file.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ParameterView {
    /// Its key.
    pub key: String,
    /// `axis`, `loop`, `feedforward`, `mechanics`.
    pub group: String,
    /// Its value; none: the key is missing.
    pub value: Option<f64>,
    /// Value in force without the key. None: the key is required, or the thing it belongs to is missing (a drive, a
    /// second mass, a compensation, gains of the machine's own).
    pub without: Option<f64>,
}

/// `PUT /api/parameters`: numbers of an axis and its drive, all checked as the loader checks them.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterChange {
    /// Name of the axis.
    pub axis: String,
    /// Keys with their new values; null takes the key away.
    pub values: Vec<(String, Option<f64>)>,
    /// Notch filters that replace the present ones, if they change.
    pub notches: Option<Vec<[f64; 3]>>,
}

/// `POST /api/tool`: one fixed point was touched with the tip of a head from several attitudes.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolTouches {
    /// The head, from 0.
    pub head: u32,
    /// Positions of all axes at each touch, mm or degrees.
    pub touches: Vec<Vec<f64>>,
}

/// Its answer; nothing is saved.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ToolAnswer {
    /// The tip in the last frame of the head's steps, mm: before and as found.
    pub was_mm: [f64; 3],
    /// See `was_mm`.
    pub tip_mm: [f64; 3],
    /// The point that was touched, in the work frame, mm.
    pub point_mm: [f64; 3],
    /// Distance of the tip from that point at each touch, mm.
    pub residuals_mm: Vec<f64>,
    /// Touches that are far off the others.
    pub outliers: Vec<bool>,
    /// Root of the mean square of the residuals, mm.
    pub rms_mm: f64,
    /// Standard deviation of the tip, estimated from the residuals, mm.
    pub deviation_mm: [f64; 3],
    /// Largest angle between two attitudes, degrees.
    pub apart_deg: f64,
    /// Directions in the head's frame that the poses leave undetermined: there the tip stays as it was.
    pub unseen: Vec<[f64; 3]>,
    /// `good`; `unseen`: good, but undetermined in some directions; `far`: the tip moved by more than a tool bends;
    /// `poor`: the touches do not agree.
    pub verdict: String,
}

/// `PUT /api/tool`: new position of a tip.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolTip {
    /// The head, from 0.
    pub head: u32,
    /// In the last frame of its steps, mm.
    pub tip_mm: [f64; 3],
}

/// `GET /api/sensors`: sensors in the machine file of the cell's job.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SensorsView {
    /// The file, among the jobs, in which changes are kept.
    pub file: String,
    /// See [`ParametersView::pending`].
    pub pending: bool,
    /// Its devices are simulated: so is the picture of a grid.
    pub simulated: bool,
    /// All of them.
    pub sensors: Vec<SensorSetUp>,
}

/// A sensor as the machine file has it.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SensorSetUp {
    /// Its name.
    pub name: String,
    /// `stripe`, `camera`.
    pub kind: String,
    /// Columns and rows of its images.
    pub size_px: [u32; 2],
    /// All possible values, with the keys of machine files.
    pub values: Vec<SensorValue>,
    /// Of a camera: its maps of planes square to its axis.
    pub heights: Vec<HeightView>,
}

/// Numbers of a sensor.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SensorValue {
    /// Keys from the sensor's table on, with dots between.
    pub key: String,
    /// `pose`, `map`, `timing`.
    pub group: String,
    /// Number of values of the key.
    pub count: u32,
    /// Its values; empty if the key is missing.
    pub numbers: Vec<f64>,
}

/// View of a camera on one plane square to its axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeightView {
    /// The plane's z in the sensor's frame, mm: towards the camera.
    pub z_mm: f64,
    /// mm a column, and mm a row.
    pub mm_per_px: [f64; 2],
    /// Column and row of the optical axis; none: the middle.
    pub centre_px: Option<[f64; 2]>,
    /// Turn of the picture's x from the sensor's x towards its rows, degrees.
    pub rotation_deg: f64,
    /// Shift along the picture's x per mm down the picture, mm.
    pub shear: f64,
    /// Relative radial displacement of pixels half a width from the centre by distortion.
    pub barrel: f64,
}

/// `PUT /api/sensor`: new values of a sensor, all checked as the loader checks them.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SensorChange {
    /// Name of the sensor.
    pub name: String,
    /// Keys with their new numbers; none takes the key away.
    pub values: Vec<(String, Vec<f64>)>,
    /// Planes of a camera that replace the present ones, if they change.
    pub heights: Option<Vec<HeightView>>,
}

/// `POST /api/sensor`, a picture of a grid of dots: the camera's map from it; nothing is saved.
#[derive(Debug, Clone, PartialEq, Default, Serialize, TS, JsonSchema)]
pub struct SensorAnswer {
    /// `good`; `far`: the scale differs by more than a lens is moved; else the reason for no map: `picture`, `size`,
    /// `plain`, `few`, `tangled`, `corner`, `residual`, `map`.
    pub verdict: String,
    /// Details of the verdict.
    pub of: Vec<String>,
    /// Description with the allowed values; empty if it is good.
    #[serde(flatten)]
    pub message: MessageView,
    /// The plane at that height as in the machine file, and as found; none if not found.
    pub was: Option<HeightView>,
    /// See `was`.
    pub found: Option<HeightView>,
    /// Each dot: measured column and row, and its residual in the map from there, pixels.
    pub dots: Vec<[f64; 4]>,
    /// Root mean square of the residuals, and their maximum, pixels.
    pub rms_px: f64,
    /// See `rms_px`.
    pub max_px: f64,
}

/// `GET /api/frames`: frames in the machine file of the cell's job.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FramesView {
    /// The file, among the jobs, in which changes are kept.
    pub file: String,
    /// See [`ParametersView::pending`].
    pub pending: bool,
    /// The machine is an arm: its tool frame has an orientation about the torch.
    pub arm: bool,
    /// All of them.
    pub frames: Vec<FrameEntry>,
}

/// A frame.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FrameEntry {
    /// Identifier in [`FrameChange`].
    pub id: String,
    /// `base`, `mount` (between axes), `flange`, `adapter`, `tool`, `tcp` (tool centre point), `table` (of a positioner),
    /// `work`, `user`.
    pub kind: String,
    /// Name of a user frame.
    pub name: String,
    /// The frame in which it is given: `base`, `flange`, `work`, or `before` (that of the step before it in the file).
    pub within: String,
    /// Row by row (3 x 4), mm.
    pub frame: [f64; 12],
    /// It can be changed.
    pub editable: bool,
    /// The frame before the last change of the file, if it was another one.
    pub before: Option<[f64; 12]>,
}

/// `PUT /api/frames`.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FrameChange {
    /// See [`FrameEntry::id`]; `user NAME` adds a user frame.
    pub id: String,
    /// The frame, row by row (3 x 4), mm; none removes a user frame.
    pub frame: Option<[f64; 12]>,
}

/// `POST /api/frames/teach`: the tip has touched the origin, a point on the x axis, and a point of the plane on the side
/// of y.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FramePoints {
    /// Positions of all axes at each touch, mm or degrees.
    pub touches: Vec<Vec<f64>>,
}

/// Its answer.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FrameTaught {
    /// In the base frame, row by row (3 x 4), mm.
    pub frame: [f64; 12],
    /// Smaller distance of the two points from the origin, mm.
    pub apart_mm: f64,
    /// Angle between the directions to them, degrees.
    pub angle_deg: f64,
}
