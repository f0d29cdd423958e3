use crate::robot::{MAX_SET_POINTS, RobotLanguage};
use seamwright_message::{Argument, Message, Unit, display_by_message};

/// Reason why a part program cannot be written.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// An axis has no letter that the control knows.
    NoLetter {
        /// Name of the axis.
        axis: String,
    },
    /// The letter's kind does not fit the axis: the control counts A, B, C in degrees and the others in mm.
    WrongLetter {
        /// Name of the axis.
        axis: String,
        /// Its letter.
        letter: char,
        /// Whether the axis is rotary, and the letter one of linear axes.
        rotary: bool,
    },
    /// Tip-level blocks need three linear axes X, Y and Z.
    NoTip,
    /// The planned transfer moves between passes are straight in axis space.
    TipPasses,
    /// Blocks are cut for one torch.
    TwoTorches,
    /// A part program without motion.
    Nothing,
    /// The tolerance cannot be kept.
    TooFine {
        /// Path length, mm.
        s: f64,
    },
    /// The control cannot take a step.
    Unwritable {
        /// Number of the step, from 1.
        step: usize,
        /// The pass that it is in, if it is in one.
        pass: Option<String>,
        /// Feature that the control lacks.
        what: Message,
        /// Operator action.
        cure: Message,
    },
    /// Robot languages need a six-axis arm with one torch.
    NotAnArm {
        /// Name of the machine.
        machine: String,
        /// The language.
        language: RobotLanguage,
    },
    /// A text that is read has another frame of tool or work than the machine.
    OtherFrames {
        /// Name of the machine.
        machine: String,
        /// `tool` or `work`.
        frame: &'static str,
    },
    /// The arm's wrist is not of the kind that the language describes.
    WrongArm {
        /// Name of the machine.
        machine: String,
        /// The language.
        language: RobotLanguage,
    },
    /// More external axes than the language has.
    ExternalAxes {
        /// Name of the machine.
        machine: String,
        /// The language.
        language: RobotLanguage,
        /// Names of the external axes.
        axes: Vec<String>,
        /// How many of them the language has.
        max: usize,
    },
    /// A stream of set-points in a language without one.
    NoStream {
        /// The language.
        language: RobotLanguage,
    },
    /// More set-points than a program takes.
    TooManySetPoints {
        /// Their number.
        count: usize,
        /// The period of the stream, ms.
        period_ms: f64,
    },
    /// A robot program that is a stream of set-points, which is not converted to a weld program.
    StreamRead,
    /// An axis that carries the arm and is not linear along an axis of the base frame, for INFORM.
    BaseAxis {
        /// Name of the machine.
        machine: String,
        /// Name of the axis.
        axis: String,
    },
    /// A frame of the tool or the work has an infinite or undefined number.
    FrameNotFinite {
        /// Name of the machine.
        machine: String,
    },
    /// The torch turns while its tip stands still.
    TurnsAtRest {
        /// Path length, mm.
        s: f64,
    },
    /// The tolerance needs lines that a robot control does not pass without slowing down.
    BriefBlocks {
        /// Path length, mm.
        s: f64,
        /// Duration of the line, s.
        time_s: f64,
        /// Minimum duration, s.
        min_s: f64,
    },
    /// Robot languages have no slopes of process values at rest.
    Slopes {
        /// Name of the pass.
        pass: String,
    },
    /// Robot programs have no events inside a pass.
    PassEvents {
        /// Name of the pass.
        pass: String,
    },
}

display_by_message!(Error);

impl Error {
    /// Returns the description of the reason.
    pub fn message(&self) -> Message {
        let new = Message::new;
        match self {
            Self::NoLetter { axis } => new("post-no-letter").axis("axis", axis),
            Self::WrongLetter { axis, letter, rotary } => {
                let code = if *rotary { "post-letter-of-linear-axes" } else { "post-letter-of-rotary-axes" };
                new(code).axis("axis", axis).text("letter", *letter)
            }
            Self::NoTip => new("post-no-tip-level"),
            Self::TipPasses => new("post-tip-passes"),
            Self::TwoTorches => new("post-two-torches"),
            Self::Nothing => new("post-nothing-moves"),
            Self::TooFine { s } => new("post-tolerance-too-small").quantity("s", *s, Unit::Mm, 3),
            Self::Unwritable { step, pass, what, cure } => {
                let message = match pass {
                    Some(pass) => new("post-unwritable-in-pass").text("pass", pass),
                    None => new("post-unwritable"),
                };
                let message = message.text("step", step.to_string()).message("what", what.clone());
                message.message("cure", cure.clone())
            }
            Self::NotAnArm { machine, language } => {
                new("post-robot-no-arm").text("machine", machine).text("language", language.title())
            }
            Self::OtherFrames { machine, frame } => {
                new("post-robot-other-frames").text("machine", machine).text("frame", *frame)
            }
            Self::WrongArm { machine, language } => {
                let code = match language.has_parallel_axes() {
                    true => "post-robot-not-parallel",
                    false => "post-robot-not-spherical",
                };
                new(code).text("machine", machine).text("language", language.title())
            }
            Self::NoStream { language } => new("post-robot-no-stream").text("language", language.title()),
            Self::TooManySetPoints { count, period_ms } => new("post-robot-set-points")
                .count("count", *count)
                .value("period", *period_ms, Unit::Ms)
                .count("max", MAX_SET_POINTS),
            Self::StreamRead => new("post-robot-stream-read"),
            Self::BaseAxis { machine, axis } => {
                new("post-robot-base-axis").text("machine", machine).axis("axis", axis.as_str())
            }
            Self::ExternalAxes { machine, language, axes, max } => {
                let message =
                    new("post-robot-external-axes").text("machine", machine).text("language", language.title());
                let axes = axes.iter().map(|axis| Argument::Axis(axis.clone()));
                message.list("axes", axes).count("max", *max)
            }
            Self::FrameNotFinite { machine } => new("post-robot-frame").text("machine", machine),
            Self::TurnsAtRest { s } => new("post-robot-turns-at-rest").quantity("s", *s, Unit::Mm, 3),
            Self::BriefBlocks { s, time_s, min_s } => {
                let message = new("post-robot-brief").quantity("s", *s, Unit::Mm, 3);
                message.quantity("time", *time_s, Unit::S, 4).value("min", *min_s, Unit::S)
            }
            Self::Slopes { pass } => new("post-robot-slopes").text("pass", pass),
            Self::PassEvents { pass } => new("post-robot-events").text("pass", pass),
        }
    }
}
