use super::cell::AxisView;
use super::certificate::CertificateView;
use super::message::MessageView;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A planned program.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct WorkView {
    /// Number of this plan; each plan has its own.
    #[ts(type = "number")]
    pub id: u64,
    /// Name of the job in the folder of jobs.
    pub job: String,
    /// Its title.
    pub title: String,
    /// Name of the job's machine; the cell's may be another.
    pub machine: String,
    /// Axes of that machine, in the order of [`PathPoint::axes`].
    pub axes: Vec<AxisView>,
    /// Names of process values, ending in their units.
    pub values: Vec<String>,
    /// Passes in order.
    pub passes: Vec<PassView>,
    /// Transfer moves, one more than passes: positions of the tip.
    pub air: Vec<Vec<[f64; 3]>>,
    /// Times of the transfer moves, s.
    pub air_s: Vec<f64>,
    /// The part and the fixtures.
    pub part: Vec<SolidView>,
    /// See `part`.
    pub fixtures: Vec<SolidView>,
    /// Cross-sections of the joint at stations along the seam.
    pub sections: Vec<SectionView>,
    /// Findings about it.
    pub findings: Vec<FindingView>,
    /// It can be welded: no finding prevents it.
    pub good: bool,
    /// Total time, s.
    pub time_s: f64,
    /// Start of a resumed weld: pass from 1, and path length.
    pub from: Option<(u32, f64)>,
    /// Number of tracked heads.
    pub tracked: usize,
    /// Distortion of the simulated part against the planned one: TOML, as of `simulate --distortion`.
    pub distortion: Option<String>,
}

/// A pass.
#[derive(Debug, Clone, PartialEq, Default, Serialize, TS, JsonSchema)]
pub struct PassView {
    /// Its name in the program; empty if it has none.
    pub name: String,
    /// Role: `root`, `fill`, `cap` ..; empty if the program does not say.
    pub role: String,
    /// Path length, mm.
    pub length_mm: f64,
    /// Time from the gas preflow to the end of the postflow, s.
    pub time_s: f64,
    /// Overlap onto the finished weld after a stop, mm.
    pub overlap_mm: f64,
    /// Requested speed at its start, mm/s.
    pub speed_mm_s: f64,
    /// It is closed.
    pub closed: bool,
    /// Samples all along.
    pub path: Vec<PathPoint>,
    /// Start and end of each span, path lengths in mm: of a pass along the seam, or of runs of points.
    pub spans: Vec<[f64; 2]>,
    /// Path lengths at which its points are reached, mm, the start first; empty along a seam.
    pub points_mm: Vec<f64>,
    /// Its certificate; none if it cannot be welded as requested.
    pub certificate: Option<CertificateView>,
    /// Smallest clearance of the pass; none if nothing comes near.
    pub nearest: Option<NearView>,
    /// Path length of the smallest clearance, mm.
    pub nearest_at_mm: Option<f64>,
    /// Configurations of the arm along the pass: at its start and where it changes; empty for other machines.
    pub arm: Vec<ArmAt>,
}

/// Configuration of the arm from a path length on.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ArmAt {
    /// Path length, mm.
    pub s_mm: f64,
    /// The configuration. Its margin is the smallest one up to the next change.
    pub arm: super::ArmView,
}

/// The nearest pair of bodies with a minimum clearance.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct NearView {
    /// Their distance, mm; less than 0 where a zone is left.
    pub distance_mm: f64,
    /// Minimum clearance, mm.
    pub least_mm: f64,
    /// Names of the two.
    pub between: [String; 2],
    /// Their nearest points in the work frame, mm.
    pub at: [[f64; 3]; 2],
}

/// A sample of a pass.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct PathPoint {
    /// Path length, mm.
    pub s_mm: f64,
    /// Tip in the work frame, mm.
    pub tip: [f64; 3],
    /// Unit vector out of the work along the torch.
    pub torch: [f64; 3],
    /// Speed along the path, mm/s; the requested one if the pass cannot be welded.
    pub speed_mm_s: f64,
    /// Axes, mm or degrees; empty if it cannot be welded, as `used`.
    pub axes: Vec<f64>,
    /// Speed, acceleration and jerk of each axis in per cent of its limits.
    pub used: Vec<[u8; 3]>,
    /// Process values; null if missing.
    pub values: Vec<Option<f64>>,
    /// Minimum distance of the watched pairs, mm; null if none is near.
    pub clearance_mm: Option<f64>,
}

/// A finding.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FindingView {
    /// Stable kind: `reach`, `range`, `speed`, ...
    pub kind: String,
    /// Text with the value found and the value allowed.
    pub message: MessageView,
    /// From 1.
    pub pass: u32,
    /// Path length, mm.
    pub from_mm: f64,
    /// See `from_mm`.
    pub to_mm: f64,
    /// Operator action, if one is needed.
    pub cure: Option<MessageView>,
    /// The weld can be made in spite of it.
    pub allowed: bool,
    /// Positions of the axes there, in the order of [`WorkView::axes`]; empty if unknown.
    pub axes: Vec<f64>,
    /// The pair nearest to its minimum clearance there.
    pub nearest: Option<NearView>,
}

/// A solid, in the work frame with all axes at zero.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SolidView {
    /// Name.
    pub name: String,
    /// Its shape.
    pub shape: ShapeView,
    /// Its frame, row by row (3 x 4), mm.
    pub frame: [f64; 12],
    /// The link that it moves with, as an index into [`super::Status::links`].
    pub link: usize,
}

/// A shape in its own frame, mm.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum ShapeView {
    /// About its middle.
    Box {
        /// Lengths of its sides.
        size: [f64; 3],
    },
    /// About its middle.
    Sphere {
        /// Radius.
        radius: f64,
    },
    /// Along z, from 0; a cylinder is a cone of two equal radii.
    Cone {
        /// At 0.
        radius: f64,
        /// At `length`.
        top_radius: f64,
        /// Along z.
        length: f64,
    },
    /// Along z, from 0 to `length`, ends included.
    Capsule {
        /// Radius.
        radius: f64,
        /// Along z.
        length: f64,
    },
    /// About its middle.
    Ellipsoid {
        /// Along x, y, z.
        semi_axes: [f64; 3],
    },
    /// Everything below z = 0.
    HalfSpace {},
    /// Triangles: nine numbers each.
    Mesh {
        /// Corners.
        triangles: Vec<f32>,
    },
}

/// A cross-section of the joint: mm, x to the first part's side, y up.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SectionView {
    /// Path length along the seam, mm.
    pub s_mm: f64,
    /// Angle between the two faces, degrees.
    pub dihedral_deg: f64,
    /// Root gap and misalignment of the second part, mm.
    pub root_gap_mm: f64,
    /// See `root_gap_mm`.
    pub mismatch_mm: f64,
    /// Area of the groove, and of the cap over it, mm^2.
    pub area_mm2: f64,
    /// See `area_mm2`.
    pub cap_mm2: f64,
    /// Outlines of the metal beside and behind the groove: the first and the second part, then the weld on the other side
    /// and the backing, if they are there.
    pub parts: Vec<Vec<[f64; 2]>>,
    /// Fusion faces of the two parts, from the root to the toe.
    pub edges: [Vec<[f64; 2]>; 2],
    /// Beads in the order of welding.
    pub beads: Vec<BeadView>,
}

/// A bead in a cross-section.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct BeadView {
    /// First part of the names of its passes, such as `fill 2.1`.
    pub name: String,
    /// `root`, `fill`, `cap` ..
    pub role: String,
    /// Area, mm^2.
    pub area_mm2: f64,
    /// Outline, mm.
    pub outline: Vec<[f64; 2]>,
    /// Point on which the wire points, mm.
    pub tip: [f64; 2],
    /// Unit vector from there to the torch.
    pub back: [f64; 2],
}

/// Drawing of a job's text before any motion is planned: see `POST /api/draft`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum DraftAnswer {
    /// It can be read.
    Drawn {
        /// The part and the fixtures.
        part: Vec<SolidView>,
        /// See `part`.
        fixtures: Vec<SolidView>,
        /// The joint.
        sections: Vec<SectionView>,
    },
    /// The text is wrong.
    Wrong {
        /// Fault and position, with the allowed values.
        message: MessageView,
    },
}

/// `POST /api/place`: position of the part from touched points.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlaceText {
    /// TOML of a job.
    pub text: String,
    /// Method of placing.
    pub method: PlaceMethod,
    /// Radius of the probe's ball, mm; 0: the tip itself was on the surface.
    pub probe_radius_mm: f64,
    /// Touched points.
    pub points: Vec<TouchedPoint>,
}

/// Methods of placing a part by touched points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PlaceMethod {
    /// Points anywhere on the nozzle and on the body: features `nozzle`, `body`.
    BestFit,
    /// Points on three faces: features `plane`, `line`, `point`.
    PlaneLinePoint,
    /// Points on a plane and two marks on it: features `plane`, `origin`, `direction`.
    ThreePoints,
    /// Points on a face and on a round about the axis of the chuck that holds it: features `face`, `round`.
    Chuck,
}

/// A touched point.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TouchedPoint {
    /// Touched feature.
    pub feature: String,
    /// The tip in the work frame, mm.
    pub tip: [f64; 3],
}

/// Its answer; nothing is saved.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct PlaceAnswer {
    /// The job with the offset in force.
    pub text: String,
    /// Translation of the part, mm.
    pub move_mm: [f64; 3],
    /// Rotation of the part, degrees.
    pub angle_deg: f64,
    /// Distance of each point from its nominal surface with this offset, mm: positive outside.
    pub residuals_mm: Vec<f64>,
    /// Points that are far off the others.
    pub outliers: Vec<bool>,
    /// Root of their mean square, mm.
    pub rms_mm: f64,
    /// Directions that the points leave undetermined, and other remarks.
    pub notes: Vec<MessageView>,
}

/// Plan of a job's text before it is saved: see `POST /api/plan`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum PlanAnswer {
    /// It was planned, perhaps with findings that forbid it.
    Planned {
        /// The plan.
        work: Box<WorkView>,
    },
    /// The text is wrong.
    Wrong {
        /// Fault and position, with the allowed values.
        message: MessageView,
        /// The same in parts, if the fault is in a file.
        at: Option<Box<WrongView>>,
    },
}

/// Fault of a file, in parts.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct WrongView {
    /// Name of the file, if it is not the job's own text.
    pub file: Option<String>,
    /// From 1, in the job's own text.
    pub line: Option<usize>,
    /// Path of the key, like `weld.speed_mm_s`; may be empty.
    pub key: String,
    /// Value as written; may be empty.
    pub value: String,
    /// Description of the fault.
    pub what: MessageView,
    /// Allowed values.
    pub allowed: Option<MessageView>,
    /// A suggestion.
    pub help: Option<MessageView>,
}

/// `POST /api/plan`, `POST /api/draft`, `GET /api/jobs/NAME`.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobText {
    /// TOML of a job or program.
    pub text: String,
}

/// A running plan of a page: see `GET /api/planning`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct PlanningView {
    /// `draft`, `plan`, `recorded`, `report`, `post`, `load`, `place` or `reach`.
    pub kind: String,
    /// Time since the request, s.
    pub elapsed_s: f64,
    /// Work done, of a request that knows it: placements of the grid.
    #[ts(type = "number | null")]
    pub done: Option<u64>,
    /// All of it.
    #[ts(type = "number | null")]
    pub total: Option<u64>,
}

/// `PUT /api/jobs/NAME`.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobKept {
    /// TOML of a job or program.
    pub text: String,
    /// Text that the page expects to replace; empty for a new job. If the stored text differs, the request is refused
    /// (`other`), so that no changes of other users are lost. If missing, any stored text is replaced.
    #[serde(default)]
    pub over: Option<String>,
}

/// A row of `GET /api/jobs`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct JobRow {
    /// Name, ends in `.toml`.
    pub name: String,
    /// Title, or its fault.
    pub title: String,
    /// A supplied example: it can be copied, not changed.
    pub example: bool,
}

/// `GET /api/distortions`: a distortion of the simulated part.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct DistortionRow {
    /// Its name.
    pub name: String,
    /// TOML, as of `simulate --distortion`.
    pub text: String,
}

/// `POST /api/load`.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// Name of a job.
    pub job: String,
    /// Start of a resumed weld: pass from 1, and the path length up to which it is welded.
    pub from: Option<(u32, f64)>,
    /// Overlap onto the finished weld before `from`, mm: the start needs no confirmation for it.
    #[serde(default)]
    #[ts(optional = nullable)]
    pub overlap_mm: Option<f64>,
    /// Name of the part that is welded, for the record.
    pub part: Option<String>,
    /// Distortion of the simulated part against the planned one: TOML, as of `simulate --distortion`. It is tracked
    /// then.
    #[serde(default)]
    #[ts(optional = nullable)]
    pub distortion: Option<String>,
}

/// `POST /api/post`: a part program for a control.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PostText {
    /// TOML of a job or program.
    pub text: String,
    /// `sinumerik`, `linuxcnc`, `grblhal`, `pmac`.
    pub dialect: String,
}

/// Its answer.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct PostAnswer {
    /// The part program.
    pub text: String,
    /// Proof, a message for each check.
    pub proof: Vec<MessageView>,
}

/// The answer of `POST /api/edit`, which takes `{ text, operations }` as `seamwright edit --script` does.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct EditAnswer {
    /// The text as it is now.
    pub text: String,
    /// Description of the edits.
    pub words: Vec<MessageView>,
}

/// `POST /api/reach`: search for the placement with the largest margin of the axes' ranges.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReachText {
    /// TOML of a job.
    pub text: String,
    /// The moved body: `work`, in the work frame, or `base`, the machine's base in the base frame.
    pub moved: String,
    /// First and last displacement along x, y and z (mm) and rotation about the vertical (degrees), from the present
    /// placement.
    pub ranges: [[f64; 2]; 4],
    /// Number of places of each of them in the grid, 1 or more; 2000 in all at most.
    pub cells: [u32; 4],
    /// Time for search and plans, 1 to 240 s.
    pub budget_s: f64,
}

/// Its answer; nothing is saved.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ReachAnswer {
    /// Name of the machine.
    pub machine: String,
    /// See [`ReachText::moved`].
    pub moved: String,
    /// Displacements of the grid along x, y, z (mm) and its rotations (degrees).
    pub grid: [Vec<f64>; 4],
    /// Everything that was judged: the present placement first, then the grid, the local search, the planned ones.
    pub places: Vec<ReachCell>,
    /// Placements whose plan failed, with the reason.
    pub failed: Vec<ReachCell>,
    /// The best placement that the planner has planned; none: no placement can be welded.
    pub best: Option<ReachBest>,
    /// The time was over before everything was judged.
    pub cut_off: bool,
}

/// A judged placement.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ReachCell {
    /// Displacement along x, y, z (mm) and rotation (degrees) from the present placement.
    pub at: [f64; 4],
    /// Its cell of the grid; none beside the grid.
    pub cell: Option<[u32; 4]>,
    /// Smallest distance of an axis from an end of its range, as a part of the range; none if it cannot be welded.
    pub margin: Option<f64>,
    /// Kind of the reason why it cannot be welded: `reach`, `range`, `jump`, `speed`, `position`.
    pub fault: Option<String>,
    /// The axis with the margin, or that is the reason.
    pub axis: Option<String>,
    /// Pass of that station, from 1.
    pub pass: Option<u32>,
    /// Path length of that station, mm.
    pub s_mm: Option<f64>,
    /// Reason why it cannot be welded.
    pub reason: Option<MessageView>,
}

/// The best placement.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ReachBest {
    /// The placement.
    pub place: ReachCell,
    /// Margin in its plan.
    pub planned_margin: f64,
    /// The axis with that margin; none if no axis has a range.
    pub planned_axis: Option<String>,
    /// Smallest clearance of its plan, mm; none if nothing comes near.
    pub clearance_mm: Option<f64>,
    /// The job with this placement, or the machine file with its base there.
    pub text: String,
    /// Key that holds the placement, and its value: displacement (mm), direction of the axis of rotation and angle (degrees).
    pub key: String,
    /// See `key`.
    pub move_mm: [f64; 3],
    /// See `key`.
    pub turn: Option<[f64; 3]>,
    /// See `key`.
    pub angle_deg: f64,
}
