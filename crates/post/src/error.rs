use thiserror::Error;

/// Reason why a part program cannot be written.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Error {
    /// An axis has no letter that the control knows.
    #[error(
        "axis {axis} has no letter for part programs: give it `letter = \"...\"` in the machine file (A B C U V W X Y Z)"
    )]
    NoLetter {
        /// Name of the axis.
        axis: String,
    },
    /// The letter's kind does not fit the axis: the control counts A, B, C in degrees and the others in mm.
    #[error(
        "axis {axis} is {kind} but its letter {letter} is one of {others}: choose another `letter` in the machine file"
    )]
    WrongLetter {
        /// Name of the axis.
        axis: String,
        /// Its letter.
        letter: char,
        /// `linear` or `rotary`.
        kind: &'static str,
        /// The kind of letter it has.
        others: &'static str,
    },
    /// Tip-level blocks need three linear axes X, Y and Z.
    #[error(
        "tip-level blocks need a machine with axes X, Y and Z, and kinematics to match in the control; use joint level"
    )]
    NoTip,
    /// The planned transfer moves between passes are straight in axis space.
    #[error("the air moves between passes are planned for the axes: use joint level, or post one pass at a time")]
    TipPasses,
    /// Blocks are cut for one torch.
    #[error("two torches that weld at once cannot be posted: blocks are checked for one of them only")]
    TwoTorches,
    /// A part program without motion.
    #[error("nothing moves in the part program: it needs at least one block with G1, G2, G3 or G0 that goes elsewhere")]
    Nothing,
    /// The tolerance cannot be kept.
    #[error("the tolerance needs blocks too short for the control near s = {s:.3} mm: allow more")]
    TooFine {
        /// Where, mm.
        s: f64,
    },
    /// The control cannot take a step.
    #[error("step {step}{pass}: {what}\n   cure: {cure}")]
    Unwritable {
        /// Number of the step, from 1.
        step: usize,
        /// The pass that it is in, if it is in one.
        pass: String,
        /// Feature that the control lacks.
        what: String,
        /// Operator action.
        cure: &'static str,
    },
}
