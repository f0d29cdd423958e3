use super::MessageView;
use schemars::JsonSchema;
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Orders to the teaching by camera, see [`super::ToCell::Teach`].
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub enum TeachOrder {
    /// Starts the camera over the seam of the program in the cell and discards earlier taught points.
    Open {
        /// Longest step from frame to frame, mm: 1 to 100.
        step_mm: f64,
        /// Longest tack that is passed without asking, mm: above 0, up to 100.
        longest_tack_mm: f64,
        /// Simulation: seed of where the seam actually is, and of the noise.
        seed: u32,
        /// Simulation: a tack hides the joint between these path lengths, mm.
        tack_mm: Option<(f64, f64)>,
    },
    /// The joint is here: the crawl begins, or goes on where it was lost. The machine moves.
    Here {
        /// A pixel of the newest picture, right and down.
        px: Option<[f64; 2]>,
        /// A position in the work frame, mm. Neither: the position at which the camera looks.
        at: Option<[f64; 3]>,
    },
    /// The joint ends where it was lost.
    End {},
    /// Pauses; so does a pressed jog key.
    Pause {},
    /// Goes on.
    Resume {},
    /// Ends the crawl; what was taught so far is kept.
    Stop {},
}

impl TeachOrder {
    /// Returns the order for the audit log.
    pub(crate) fn message(&self) -> Message {
        match self {
            Self::Open { step_mm, longest_tack_mm, seed, tack_mm } => {
                let code = if tack_mm.is_some() { "server-audit-teach-open-tack" } else { "server-audit-teach-open" };
                let message = Message::new(code).value("step", *step_mm, Unit::Mm);
                let message = message.value("tacks", *longest_tack_mm, Unit::Mm).number("seed", f64::from(*seed), 0);
                tack_mm.iter().fold(message, |message, (from, to)| {
                    message.value("from", *from, Unit::Mm).value("to", *to, Unit::Mm)
                })
            }
            Self::Here { px: Some([x, y]), .. } => {
                Message::new("server-audit-teach-pixel").number("x", *x, 1).number("y", *y, 1)
            }
            Self::Here { at: Some([x, y, z]), .. } => {
                let message = Message::new("server-audit-teach-point").quantity("x", *x, Unit::Mm, 2);
                message.quantity("y", *y, Unit::Mm, 2).quantity("z", *z, Unit::Mm, 2)
            }
            Self::Here { .. } => Message::new("server-audit-teach-middle"),
            Self::End {} => Message::new("server-audit-teach-end"),
            Self::Pause {} => Message::new("server-audit-teach-pause"),
            Self::Resume {} => Message::new("server-audit-teach-resume"),
            Self::Stop {} => Message::new("server-audit-teach-stop"),
        }
    }
}

/// Phase of teaching by camera.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, TS, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TeachPhase {
    /// Teaching is closed.
    #[default]
    Closed,
    /// The seam of the program is looked up.
    Plans,
    /// The camera is open and waits for the start of the joint.
    Places,
    /// It crawls.
    Runs,
    /// It stands still until it is resumed.
    Paused,
    /// It has lost the joint and asks.
    Asks,
    /// It has ended.
    Ended,
}

/// State of teaching by camera: to all connections, whenever it changes.
#[derive(Debug, Clone, Default, PartialEq, Serialize, TS, JsonSchema)]
pub struct TeachView {
    /// Phase.
    pub phase: TeachPhase,
    /// Name of the job whose seam it is.
    pub job: String,
    /// Why it is paused: `operator`, `hand`, `control`, `mode`; how it ended: `closed`, `joint-end`, `operator`, `lost`, `limit`,
    /// `too-long`, `stopped`, `failed`.
    pub key: Option<String>,
    /// More of that.
    pub why: Option<MessageView>,
    /// Way along the joint that was taught, and length of the nominal seam, mm.
    pub way_mm: f64,
    /// See `way_mm`.
    pub nominal_mm: f64,
    /// Frames so far.
    pub frames: u32,
    /// Mean confidence of the last frame, and the least of all, 0 to 1.
    pub confidence: f64,
    /// See `confidence`.
    pub least_confidence: f64,
    /// Number of the newest picture; 0: no picture yet.
    pub picture: u32,
    /// Width and height of a picture, pixels.
    pub size_px: (u32, u32),
}

/// `GET /api/teach`: what was taught so far.
#[derive(Debug, Clone, Default, PartialEq, Serialize, TS, JsonSchema)]
pub struct TaughtView {
    /// Points of the joint, about 1 mm apart.
    pub points: Vec<TaughtPointView>,
    /// A row for each frame.
    pub looks: Vec<TaughtLook>,
}

/// A point of the joint.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TaughtPointView {
    /// Way along the joint, mm.
    pub s_mm: f64,
    /// In the work frame, mm.
    pub at: [f64; 3],
    /// 0 to 1.
    pub confidence: f64,
    /// Distance across the nominal seam and above it, mm; null far away from it.
    pub from_nominal_mm: Option<(f64, f64)>,
}

/// A frame that was looked at.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TaughtLook {
    /// Length along the joint up to the position at which the camera looked, mm.
    pub s_mm: f64,
    /// That position in the work frame, mm.
    pub at: [f64; 3],
    /// The machine's axes then, mm or degrees.
    pub axes: Vec<f64>,
    /// Mean confidence of its rows, 0 to 1.
    pub confidence: f64,
    /// It agrees with the frames before.
    pub believed: bool,
}

/// `POST /api/teach/program`: how what was taught becomes a program.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TeachProgram {
    /// Maximum distance of the curves from the taught line, mm: above 0, up to 5.
    pub tolerance_mm: f64,
    /// Maximum angle of the torch's direction from the one that was found, degrees: above 0, up to 90.
    pub attitude_deg: f64,
    /// `greedy`, `fewest`: lines and arcs; `spline`.
    pub method: String,
}

/// Its answer.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TaughtProgram {
    /// TOML of the program.
    pub text: String,
    /// Numbers of lines, arcs, and pieces of a spline.
    pub counts: [usize; 3],
    /// Its length, mm.
    pub length_mm: f64,
    /// Maximum distance of the taught line from its curves, mm.
    pub error_mm: f64,
    /// Maximum distance of a point as it was seen, mm.
    pub raw_error_mm: Option<f64>,
    /// Maximum distance from the nominal seam, across it and above or below it, mm.
    pub from_nominal_mm: Option<(f64, f64)>,
    /// Length that the camera did not see, mm.
    pub bridged_mm: f64,
    /// Simulation: maximum distance from the actual seam, across it and above or below it, mm.
    pub truth_mm: Option<(f64, f64)>,
    /// Points of its path in the work frame, mm.
    pub path: Vec<[f64; 3]>,
}
