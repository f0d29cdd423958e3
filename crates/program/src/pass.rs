use crate::arc_time::ArcTime;
use crate::at_corner::AtCorner;
use crate::bead::Bead;
use crate::keyed::Keyed;
use crate::oscillation::Oscillation;
use crate::points::Points;
use crate::repeat::Repeat;
use crate::sequence::Sequence;
use crate::span::Span;
use crate::span_value::SpanValue;
use crate::spare_axes::SpareAxes;
use crate::step_over::StepOver;
use crate::tolerance::Tolerance;
use crate::torch::Torch;
use crate::weave::Weave;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, named_enum};
use serde::{Deserialize, Serialize};

/// One progression along the seam. Its own path length counts from where it begins, and is the way along the seam, also
/// where its bead lies beside that.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pass {
    /// Name, for people.
    pub name: String,
    /// Role of the pass in a weld of several passes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub role: Option<Role>,
    /// Number of times that the pass is welded in succession.
    #[serde(default, skip_serializing_if = "Repeat::is_once")]
    pub repeat: Repeat,
    /// The copy of the seam that it is welded on, counted from 0 in `copies`.
    #[serde(default, skip_serializing_if = "is_first")]
    pub copy: usize,
    /// Path length on the seam at which it begins, mm from the start of the weld.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub begin_mm: NonNegative,
    /// True if it runs against the weld's direction.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub reverse: bool,
    /// Behaviour where an axis cannot keep the requested speed.
    #[serde(default)]
    pub on_limit: OnLimit,
    /// The procedure's minimum speed while the arc is on, mm/s; less than the requested speed. Acceleration and
    /// deceleration phases are exempt.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least_speed_mm_s: Option<Positive>,
    /// Behaviour at a corner inside the weld.
    #[serde(default, skip_serializing_if = "AtCorner::is_usual")]
    pub corner: AtCorner,
    /// Process sequence before and after the travel.
    #[serde(default)]
    pub sequence: Sequence,
    /// Torch angles.
    #[serde(default)]
    pub torch: Torch,
    /// Tolerances of the finished weld.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// Use of redundant axes.
    #[serde(default, skip_serializing_if = "SpareAxes::is_usual")]
    pub spare_axes: SpareAxes,
    /// Position of the bead beside the seam; on the seam if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bead: Option<Bead>,
    /// Step-overs to the lines of further beads, in the order of travel, on a seam welded all round: all are welded without
    /// stopping the arc.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub step_overs: Vec<StepOver>,
    /// Weave of the torch; no weave if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weave: Option<Weave>,
    /// Oscillation of the beam during travel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub oscillation: Option<Oscillation>,
    /// The points it goes through, if it does not run along the seam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<Points>,
    /// Parts of the pass, one after the other without a gap; of a pass through points they follow from these.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub spans: Vec<Span>,
}

fn is_first(copy: &usize) -> bool {
    *copy == 0
}

fn is_zero(number: &NonNegative) -> bool {
    number.get() == 0.0
}

named_enum! {
    /// Role of a pass in a weld of several passes.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "snake_case")]
    pub enum Role {
        /// It holds the parts together until they are welded.
        Tack => "tack", "program-role-tack";
        /// It joins the parts.
        Root => "root", "program-role-root";
        /// It fills the joint.
        Fill => "fill", "program-role-fill";
        /// It is the weld's surface.
        Cap => "cap", "program-role-cap";
        /// It smooths the surface of the finished weld, with a weak or wide beam.
        Cosmetic => "cosmetic", "program-role-cosmetic";
    }
}

/// Behaviour where an axis cannot keep the requested speed.
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
    /// Role of the pass: the given one, or that named by the first word of its name.
    pub fn known_role(&self) -> Option<Role> {
        let word = self.name.split_whitespace().next();
        self.role.or_else(|| Role::ALL.into_iter().find(|role| word == Some(role.name())))
    }

    /// Whether arc or beam is on while it travels.
    pub fn has_arc(&self) -> bool {
        self.points.as_ref().is_none_or(|points| points.arc)
    }

    /// Length of the pass, mm.
    pub fn length(&self) -> f64 {
        self.spans.last().map_or(0.0, |s| s.to_mm.get())
    }

    /// The span at path length `s` (the later one where two meet; the first or last outside the pass).
    pub fn span_at(&self, s: f64) -> Option<&Span> {
        self.spans.get(self.spans.partition_point(|span| span.to_mm.get() <= s)).or(self.spans.last())
    }

    /// Path length on the seam, from the start of the weld, at the pass' own path length `s`, mm. On a seam welded all
    /// round it counts on beyond a turn, or back below 0.
    pub fn seam_s(&self, s: f64) -> f64 {
        let begin = self.begin_mm.get();
        if self.reverse { begin - s } else { begin + s }
    }

    /// Asked speed of the torch tip at path length `s`, mm/s.
    pub fn speed_at(&self, s: f64) -> f64 {
        self.span_at(s).map_or(f64::INFINITY, |span| span.speed_mm_s.at(span.part(s)))
    }

    /// Minimum and maximum programmed speed of the torch tip, mm/s.
    pub fn speeds(&self) -> (f64, f64) {
        let ends = self.spans.iter().flat_map(|span| <[f64; 2]>::from(span.speed_mm_s.ends()));
        ends.fold((f64::INFINITY, 0.0), |(least, most), v| (v.min(least), v.max(most)))
    }

    /// The process value `name` at path length `s` and an instant at which the arc is on; at a side of the weave that of
    /// the side. `None` if the pass has no such value.
    pub fn process_at(&self, name: &str, s: f64, time: ArcTime) -> Option<f64> {
        let span = self.span_at(s)?;
        let mut value = span.process.get(name)?.at(span.part(s));
        if let Some(side) = self.weave.as_ref().and_then(|weave| weave.at_sides.get(name)) {
            let out = self.swing_at(s).powi(2);
            value = (1.0 - out) * value + out * side.at(span.part(s));
        }
        let slopes = [(&self.sequence.upslope, time.since_on_s), (&self.sequence.downslope, time.until_off_s)];
        for (slope, away) in slopes {
            value = slope.as_ref().map_or(value, |slope| slope.at(name, value, away));
        }
        Some(value)
    }

    /// Minimum and maximum of the process value `name` over the pass, with slopes and sides of the weave; all values
    /// between are within these. `None` if the pass has no such value.
    pub fn process_range(&self, name: &str) -> Option<(f64, f64)> {
        let spans = self.spans.iter().filter_map(|span| span.process.get(name));
        let sides = self.weave.iter().filter_map(|weave| weave.at_sides.get(name));
        let ends = spans.chain(sides).flat_map(|value| [value.at(0.0), value.at(1.0)]);
        let slopes = [&self.sequence.upslope, &self.sequence.downslope].into_iter().flatten();
        let far = slopes.filter_map(|slope| slope.process.get(name)).map(|value| value.get());
        let wider = |range: Option<(f64, f64)>, v: f64| {
            let (low, high) = range.unwrap_or((v, v));
            Some((low.min(v), high.max(v)))
        };
        ends.fold(None, wider).map(|range| far.fold(Some(range), wider).unwrap_or(range))
    }
}

impl Pass {
    /// Refuses keys that only passes along a seam have, in a pass through points at `path` of a file. Fails with the
    /// key's address.
    pub(crate) fn check_through_points<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let given = [
            ("spans", !self.spans.is_empty()),
            ("begin_mm", self.begin_mm.get() > 0.0),
            ("reverse", self.reverse),
            ("least_speed_mm_s", self.least_speed_mm_s.is_some()),
            ("torch", self.torch != Torch::default()),
            ("bead", self.bead.is_some()),
            ("step_overs", !self.step_overs.is_empty()),
            ("weave", self.weave.is_some()),
            ("oscillation", self.oscillation.is_some()),
        ];
        if let Some((key, _)) = given.into_iter().find(|(_, given)| *given) {
            let message = Message::new("program-key-of-seam-passes");
            let allowed = Message::new("program-leave-out-key-or-points");
            return Err(file.error_at(&format!("{path}.{key}"), message, allowed));
        }
        let tolerance = Keyed { key: &format!("{path}.tolerance"), value: &self.tolerance };
        self.corner.check(file, &format!("{path}.corner"), tolerance)?;
        let process = self.points.as_ref().map(Points::known_columns).into_iter().flat_map(|c| c.process);
        let process = process.map(|(name, _)| (name, SpanValue::Steady(Finite::default()))).collect();
        self.sequence.check(file, &format!("{path}.sequence"), &process)
    }
}
