use seamwright_message::{Message, Unit, display_by_message};

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
        }
    }
}
