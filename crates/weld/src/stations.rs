use schemars::JsonSchema;
use seamwright_document::{Finite, NonNegative, Positive};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Values of the weld at one place; between places they are linear in path length, before the first and after the last
/// one they stay.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Station {
    /// Path length from the start of the weld, mm.
    pub s_mm: NonNegative,
    /// Speed there, mm/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed_mm_s: Option<Positive>,
    /// Process values there, of those in `[weld.process]`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub process: BTreeMap<String, Finite>,
}
