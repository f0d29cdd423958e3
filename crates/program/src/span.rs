use crate::process::ProcessValues;
use crate::span_value::SpanValue;
use schemars::JsonSchema;
use seamwright_document::{NonNegative, Positive};
use serde::{Deserialize, Serialize};

/// Part of a pass along the seam with its speed and process values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Span {
    /// Path length at which it begins, mm from the start of the pass.
    pub from_mm: NonNegative,
    /// Path length at which it ends, mm.
    pub to_mm: Positive,
    /// Speed of the torch tip along its way, relative to the work, mm/s: a number or a ramp `{ from = .., to = .. }`
    /// linear in path length.
    pub speed_mm_s: SpanValue<Positive>,
    /// Process values over the span, each a number or a ramp `{ from = .., to = .. }` linear in path length.
    #[serde(default, skip_serializing_if = "ProcessValues::is_empty")]
    pub process: ProcessValues,
}

impl Span {
    /// The part of the span, from 0 to 1, that lies before path length `s`.
    pub fn part(&self, s: f64) -> f64 {
        let (from, to) = (self.from_mm.get(), self.to_mm.get());
        ((s - from) / (to - from)).clamp(0.0, 1.0)
    }
}
