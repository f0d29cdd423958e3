use schemars::JsonSchema;
use seamwright_document::Positive;
use serde::{Deserialize, Serialize};

/// Moves with the arc off, before, between and after passes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct TransferMoves {
    /// Distance by which the torch retracts along itself before a weld starts and after it ends, mm; 30 if missing.
    pub retract_mm: Positive,
}

impl Default for TransferMoves {
    fn default() -> Self {
        Self { retract_mm: Positive::new(30.0).unwrap_or(Positive::TEN) }
    }
}

impl TransferMoves {
    /// True if all values are the defaults.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}
