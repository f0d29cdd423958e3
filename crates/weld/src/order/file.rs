use schemars::JsonSchema;
use seamwright_document::{NonNegative, Positive};
use serde::{Deserialize, Serialize};

/// The order in which copies of the seam, and the parts of each, are welded.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WeldOrder {
    /// Which copy comes after which.
    pub rule: Rule,
    /// Whether a copy gets all its passes before the next one is welded.
    pub passes: Turns,
    /// The parts in which each pass is welded.
    pub parts: Parts,
    /// Overlap of a part onto the one that it meets, mm; not at corners.
    pub tie_in_mm: NonNegative,
    /// True: where that makes the transfer moves shorter, a copy is welded from the seam's end to its start. On seams that
    /// are not welded all round.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub either_end: bool,
}

impl Default for WeldOrder {
    fn default() -> Self {
        Self {
            rule: Rule::default(),
            passes: Turns::default(),
            parts: Parts::default(),
            tie_in_mm: NonNegative::new(5.0).unwrap_or_default(),
            either_end: false,
        }
    }
}

/// Which copy comes after which.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Rule {
    /// As they are listed.
    #[default]
    InTurn,
    /// Each in another row than the one before it, as far as there are enough in the rows; under that with short air
    /// moves.
    BackAndForth,
    /// In each row every n-th, then those between.
    Skip(usize),
    /// With short transfer moves.
    Shortest,
}

/// Order of passes and copies where several passes are welded on several copies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Turns {
    /// All passes of a copy, then the next copy.
    #[default]
    CopyByCopy,
    /// A pass on all copies, then the next pass.
    PassByPass,
}

/// The parts in which each pass is welded.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Parts {
    /// In one go.
    #[default]
    Whole,
    /// Quarters of the seam's length, each followed by the one opposite it. On seams welded all round.
    Quadrants,
    /// Pieces from corner to corner: at a corner the torch's direction may jump with the arc off.
    AtCorners,
    /// Equal pieces of at most this length, mm, one after the other along the weld, each welded against its direction.
    BackStepMm(Positive),
}
