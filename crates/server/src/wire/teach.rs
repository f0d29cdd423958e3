use super::message::MessageView;
use schemars::JsonSchema;
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Commands for teaching by camera, see [`super::ToCell::Teach`].
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub enum TeachOrder {
    /// Starts the camera over the seam of the program in the cell; discards earlier taught points.
    Open {
        /// Maximum step from frame to frame, mm: 1 to 100.
        step_mm: f64,
        /// Maximum length of a tack that is bridged without a question, mm: above 0, up to 100.
        longest_tack_mm: f64,
        /// Simulation: seed of the actual position of the seam, and of the noise.
        seed: u32,
        /// Simulation: a tack hides the joint between these path lengths, mm.
        tack_mm: Option<(f64, f64)>,
    },
    /// Gives the position of the joint, and starts or continues the following. The machine moves.
    Here {
        /// Pixel of the newest picture, right and down.
        px: Option<[f64; 2]>,
        /// Position in the work frame, mm. If both are missing: the centre of the picture.
        at: Option<[f64; 3]>,
    },
    /// Ends the joint at the position of its loss.
    End {},
    /// Pauses, as any jog key does.
    Pause {},
    /// Continues.
    Resume {},
    /// Ends the following; keeps the taught points.
    Stop {},
}

impl TeachOrder {
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
    /// The motion along the seam is being planned.
    Plans,
    /// The camera is open and waits for the start of the joint.
    Places,
    /// The camera follows the joint.
    Runs,
    /// Paused until a command to continue.
    Paused,
    /// The joint is lost; the session waits for its position.
    Asks,
    /// The session has ended.
    Ended,
}

/// State of teaching by camera: to all connections, whenever it changes.
#[derive(Debug, Clone, Default, PartialEq, Serialize, TS, JsonSchema)]
pub struct TeachView {
    /// Phase.
    pub phase: TeachPhase,
    /// Name of the job with the seam.
    pub job: String,
    /// Reason of a pause: `operator`, `hand`, `control`, `mode`; result of the session: `closed`, `joint-end`,
    /// `operator`, `lost`, `limit`, `too-long`, `stopped`, `failed`.
    pub key: Option<String>,
    /// Details of `key`.
    pub why: Option<MessageView>,
    /// Taught length along the joint, and length of the nominal seam, mm.
    pub way_mm: f64,
    /// See `way_mm`.
    pub nominal_mm: f64,
    /// Number of frames.
    pub frames: u32,
    /// Mean confidence of the last frame, and the minimum over all points, 0 to 1.
    pub confidence: f64,
    /// See `confidence`.
    pub least_confidence: f64,
    /// Number of the newest picture; 0: no picture yet.
    pub picture: u32,
    /// Width and height of a picture, pixels.
    pub size_px: (u32, u32),
}

/// `GET /api/teach`: taught points and frames.
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
    /// Path length along the joint, mm.
    pub s_mm: f64,
    /// In the work frame, mm.
    pub at: [f64; 3],
    /// 0 to 1.
    pub confidence: f64,
    /// Lateral and height deviation from the nominal seam, mm; null if far from it.
    pub from_nominal_mm: Option<(f64, f64)>,
}

/// An evaluated frame.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TaughtLook {
    /// Path length along the joint at the centre of the frame, mm.
    pub s_mm: f64,
    /// That position in the work frame, mm.
    pub at: [f64; 3],
    /// Positions of the axes at that time, mm or degrees.
    pub axes: Vec<f64>,
    /// Mean confidence of its rows, 0 to 1.
    pub confidence: f64,
    /// The frame agrees with the earlier ones.
    pub believed: bool,
}

/// `POST /api/teach/program`: settings for a program of the taught points.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TeachProgram {
    /// Maximum distance of the curves from the taught line, mm: above 0, up to 5.
    pub tolerance_mm: f64,
    /// Maximum deviation of the torch attitude from the one found, degrees: above 0, up to 90.
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
    /// Maximum distance of an unsmoothed point from its curves, mm.
    pub raw_error_mm: Option<f64>,
    /// Maximum lateral and height deviation from the nominal seam, mm.
    pub from_nominal_mm: Option<(f64, f64)>,
    /// Total length of unseen stretches, mm.
    pub bridged_mm: f64,
    /// Simulation: maximum lateral and height deviation from the actual seam, mm.
    pub truth_mm: Option<(f64, f64)>,
    /// Points of its path in the work frame, mm.
    pub path: Vec<[f64; 3]>,
}
