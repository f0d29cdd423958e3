use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A planned program.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct WorkView {
    /// Number of this plan: another one, another program.
    #[ts(type = "number")]
    pub id: u64,
    /// Name of the job in the folder of jobs.
    pub job: String,
    /// Its title.
    pub title: String,
    /// Name of the machine that it is for.
    pub machine: String,
    /// Names of process values, ending in their units.
    pub values: Vec<String>,
    /// Passes in order.
    pub passes: Vec<PassView>,
    /// Ways through the air, one more than passes: tips.
    pub air: Vec<Vec<[f64; 3]>>,
    /// The part and the fixtures.
    pub part: Vec<SolidView>,
    /// See `part`.
    pub fixtures: Vec<SolidView>,
    /// What is to be said of it.
    pub findings: Vec<FindingView>,
    /// It can be welded: no finding forbids it.
    pub good: bool,
    /// Time in all, s.
    pub time_s: f64,
    /// It goes on where a power failure or a stop left it: pass from 1, and path length.
    pub from: Option<(u32, f64)>,
    /// How many heads are tracked.
    pub tracked: usize,
    /// How the simulated part differs from the planned one: TOML, as of `simulate --distortion`.
    pub distortion: Option<String>,
}

/// A pass.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct PassView {
    /// What it is: `root`, `fill`, `cap` ..; empty if the program does not say.
    pub role: String,
    /// Path length, mm.
    pub length_mm: f64,
    /// Time from gas to gas, s.
    pub time_s: f64,
    /// Speed that is asked for at its begin, mm/s.
    pub speed_mm_s: f64,
    /// It ends where it begins.
    pub closed: bool,
    /// Samples all along.
    pub path: Vec<PathPoint>,
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
    /// Speed along the path, mm/s.
    pub speed_mm_s: f64,
    /// Axes, mm or degrees.
    pub axes: Vec<f64>,
    /// Process values; null where there is none.
    pub values: Vec<Option<f64>>,
}

/// Something that is wrong or worth knowing.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FindingView {
    /// Stable kind: `reach`, `range`, `speed`, ...
    pub kind: String,
    /// With the value found and the value allowed.
    pub message: String,
    /// From 1.
    pub pass: u32,
    /// Path length, mm.
    pub from_mm: f64,
    /// See `from_mm`.
    pub to_mm: f64,
    /// What would cure it.
    pub cure: String,
    /// The weld can be made nevertheless.
    pub allowed: bool,
}

/// A solid, in the work frame with all axes at zero.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SolidView {
    /// Name.
    pub name: String,
    /// What it is.
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

/// What a text of a job is, asked before it is kept: see `POST /api/plan`.
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
        /// What and where, with what is allowed.
        message: String,
        /// From 1, if it is known.
        line: Option<usize>,
        /// Key, if it is known.
        key: Option<String>,
    },
}

/// `POST /api/plan`, `PUT /api/jobs/NAME`.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobText {
    /// TOML of a job or program.
    pub text: String,
}

/// A row of `GET /api/jobs`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct JobRow {
    /// Name, ends in `.toml`.
    pub name: String,
    /// Title, or what is wrong with it.
    pub title: String,
    /// One of those that ship: it can be copied, not changed.
    pub example: bool,
}

/// `GET /api/distortions`: how a simulated part can lie.
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
    /// Where to begin, if not at the begin: pass from 1 and the path length up to which it is welded.
    pub from: Option<(u32, f64)>,
    /// Name of the part that is welded, for the record.
    pub part: Option<String>,
    /// How the simulated part differs from the planned one: TOML, as of `simulate --distortion`. It is tracked then.
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
    /// How it was proven, a line each.
    pub proof: Vec<String>,
}

/// The answer of `POST /api/edit`, which takes `{ text, operations }` as `seamwright edit --script` does.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct EditAnswer {
    /// The text as it is now.
    pub text: String,
    /// What was done, in words.
    pub words: Vec<String>,
}
