//! Parts of a pass, and a pass the other way round.

use crate::pass::Pass;
use crate::path_length::{SAME_POSITION_MM, is_beyond};
use crate::path_range::PathRange;
use crate::process::ProcessValues;
use crate::span::Span;
use crate::span_value::{Ramp, SpanValue};
use seamwright_document::{Finite, NonNegative, Positive};

impl Pass {
    /// The part of the pass in a range of its own path length, with the values of the pass at every position. On a seam
    /// welded all round `turn` is its length, mm, and the part may go on beyond the pass' end: there the values are
    /// those of a turn before. Any other part ends with the pass.
    pub fn piece(&self, range: PathRange, turn: Option<f64>) -> Self {
        let PathRange { from_mm: from, to_mm: to } = range;
        let end = self.length();
        let again = turn.filter(|turn| to > end && !is_beyond(*turn, end)).into_iter().flat_map(|turn| {
            let after = move |span: &Span| clipped(span, turn, PathRange { from_mm: end.max(from), to_mm: to });
            self.spans.iter().filter_map(after).collect::<Vec<_>>()
        });
        let within = PathRange { from_mm: from, to_mm: to.min(end) };
        let own = self.spans.iter().filter_map(|span| clipped(span, 0.0, within));
        let spans = own.chain(again).map(|span| moved(span, -from)).collect();
        let (bead, step_overs) = self.step_overs_within(range);
        Self { begin_mm: begin(self.seam_s(from), turn), bead, step_overs, spans, ..self.clone() }
    }

    /// The same pass from its end to its start; on a seam welded all round `turn` is its length, mm.
    pub fn turned(&self, turn: Option<f64>) -> Self {
        let length = self.length();
        let mirrored = |span: &Span| {
            let (from, to) = (length - span.to_mm.get(), length - span.from_mm.get());
            Span {
                from_mm: NonNegative::new(from.max(0.0)).unwrap_or_default(),
                to_mm: Positive::new(to).unwrap_or(span.to_mm),
                speed_mm_s: swapped(span.speed_mm_s),
                process: span.process.iter().map(|(name, value)| (name.clone(), swapped(*value))).collect(),
            }
        };
        let spans = self.spans.iter().rev().map(mirrored).collect();
        let (bead, step_overs) = self.step_overs_turned();
        let begin_mm = begin(self.seam_s(length), turn);
        Self { begin_mm, reverse: !self.reverse, bead, step_overs, spans, ..self.clone() }
    }
}

fn begin(s: f64, turn: Option<f64>) -> NonNegative {
    NonNegative::new(turn.map_or(s, |turn| s.rem_euclid(turn)).max(0.0)).unwrap_or_default()
}

fn swapped<T: Copy>(value: SpanValue<T>) -> SpanValue<T> {
    match value {
        SpanValue::Steady(value) => SpanValue::Steady(value),
        SpanValue::Ramp(Ramp { from, to }) => SpanValue::Ramp(Ramp { from: to, to: from }),
    }
}

fn moved(span: Span, by: f64) -> Span {
    let from = (span.from_mm.get() + by).max(0.0);
    Span {
        from_mm: NonNegative::new(from).unwrap_or_default(),
        to_mm: Positive::new(span.to_mm.get() + by).unwrap_or(span.to_mm),
        ..span
    }
}

/// The part of `span`, moved on by `by`, in a range of path length; `None` if it is empty.
fn clipped(span: &Span, by: f64, range: PathRange) -> Option<Span> {
    let (from, to) = (range.from_mm.max(span.from_mm.get() + by), range.to_mm.min(span.to_mm.get() + by));
    if to - from <= SAME_POSITION_MM {
        return None;
    }
    let parts = [span.part(from - by), span.part(to - by)];
    let process: ProcessValues =
        span.process.iter().map(|(name, value)| (name.clone(), between(*value, parts, Finite::new))).collect();
    Some(Span {
        from_mm: NonNegative::new(from)?,
        to_mm: Positive::new(to)?,
        speed_mm_s: between(span.speed_mm_s, parts, Positive::new),
        process,
    })
}

/// A value over a part of its span; `parts` are the parts of the span before the start and before the end of it.
fn between<T: Copy + Into<f64>>(value: SpanValue<T>, parts: [f64; 2], new: impl Fn(f64) -> Option<T>) -> SpanValue<T> {
    let ramp = || Some(Ramp { from: new(value.at(parts[0]))?, to: new(value.at(parts[1]))? });
    if value.is_ramp() { ramp().map_or(value, SpanValue::Ramp) } else { value }
}
