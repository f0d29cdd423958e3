use crate::{AtCorner, ProcessValues, Sequence, SpareAxes, Tolerance, Torch};
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
    /// The procedure's least speed while the arc is on, mm/s; less than the asked speed. Run-up and run-down are not
    /// held against it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least_speed_mm_s: Option<Positive>,
    /// What to do at a corner inside the weld.
    #[serde(default, skip_serializing_if = "AtCorner::is_usual")]
    pub corner: AtCorner,
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
    /// Process values over the span, each a number or a ramp `{ from = .., to = .. }` linear in path length.
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

    /// The process value `name` while the arc is on: at path length `s`, `since_on` s after the arc went on and
    /// `until_off` s before it goes off (infinite where only the travel is meant). None if the pass has no such
    /// value.
    pub fn process_at(&self, name: &str, s: f64, (since_on, until_off): (f64, f64)) -> Option<f64> {
        let span = self.span_at(s)?;
        let (from, to) = (span.from_mm.get(), span.to_mm.get());
        let mut value = span.process.get(name)?.at(((s - from) / (to - from)).clamp(0.0, 1.0));
        for (slope, away) in [(&self.sequence.upslope, since_on), (&self.sequence.downslope, until_off)] {
            value = slope.as_ref().map_or(value, |slope| slope.at(name, value, away));
        }
        Some(value)
    }
}
