use crate::{ProcessValues, SpareAxes, Tolerance, Torch};
use schemars::JsonSchema;
use seamwright_document::{NonNegative, Positive};
use serde::{Deserialize, Serialize};

/// One progression along the seam.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pass {
    /// Name, for people.
    pub name: String,
    /// What to do where an axis cannot keep the asked speed.
    #[serde(default)]
    pub on_limit: OnLimit,
    /// What happens before and after the travel.
    #[serde(default)]
    pub sequence: Sequence,
    /// Torch angles.
    #[serde(default)]
    pub torch: Torch,
    /// How far from what was asked the weld may be.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// What to do with axes to spare.
    #[serde(default, skip_serializing_if = "SpareAxes::is_usual")]
    pub spare_axes: SpareAxes,
    /// Parts of the pass, one after the other without a gap.
    pub spans: Vec<Span>,
}

/// Part of a pass along the seam with its speed and process values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Span {
    /// Path length at which it begins, mm from the start of the weld.
    pub from_mm: NonNegative,
    /// Path length at which it ends, mm.
    pub to_mm: Positive,
    /// Speed of the torch tip along the seam, relative to the work, mm/s.
    pub speed_mm_s: Positive,
    /// Process values that hold over the span.
    #[serde(default, skip_serializing_if = "ProcessValues::is_empty")]
    pub process: ProcessValues,
}

/// What to do where an axis cannot keep the asked speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OnLimit {
    /// Do not weld; list where, which axis, and which speed it could hold.
    #[default]
    Refuse,
    /// Go as fast as the axes can there; list the same.
    Slow,
}

/// What happens before and after the travel.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sequence {
    /// Gas flows before the arc (or beam) is switched on, s.
    #[serde(default)]
    pub preflow_s: NonNegative,
    /// The arc (or beam) is on before the torch travels, s.
    #[serde(default)]
    pub travel_delay_s: NonNegative,
    /// The torch rests at the end with the arc on, to fill the crater, s.
    #[serde(default)]
    pub crater_s: NonNegative,
    /// Gas flows after the arc is off, s.
    #[serde(default)]
    pub postflow_s: NonNegative,
    /// A restart after a hold begins this far before the end of the bead, mm.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub overlap_mm: NonNegative,
    /// What the process does when the torch is held on the seam.
    #[serde(default, skip_serializing_if = "AtHold::is_usual")]
    pub at_hold: AtHold,
}

/// What the process does when the torch is held on the seam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AtHold {
    /// The arc stays on until the torch stands still and fills the crater for `crater_s`.
    #[default]
    Crater,
    /// The beam goes off as soon as the torch slows down.
    Off,
}

impl AtHold {
    fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}

fn is_zero(value: &NonNegative) -> bool {
    value.get() <= 0.0
}

impl Pass {
    /// Length of the pass, mm.
    pub fn length(&self) -> f64 {
        self.spans.last().map_or(0.0, |s| s.to_mm.get())
    }

    /// The span at path length `s` (the later one where two meet; the first or last outside the pass).
    pub fn span_at(&self, s: f64) -> Option<&Span> {
        let i = self.spans.partition_point(|span| span.to_mm.get() <= s);
        self.spans.get(i).or(self.spans.last())
    }
}
