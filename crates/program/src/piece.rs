//! Parts of a pass, and a pass the other way round.

use crate::{Pass, ProcessValues, Ramp, SAME_POSITION_MM, Span, SpanValue, is_beyond};
use seamwright_document::{Finite, NonNegative, Positive};

impl Pass {
    /// The part of the pass between two of its own path lengths, mm, with the values of the pass at every position. On
    /// a seam welded all round `turn` is its length, mm, and the part may go on beyond the pass' end: there the values
    /// are those of a turn before. Any other part ends with the pass.
    pub fn piece(&self, (from, to): (f64, f64), turn: Option<f64>) -> Self {
        let end = self.length();
        let again = turn.filter(|turn| to > end && !is_beyond(*turn, end)).into_iter().flat_map(|turn| {
            let after = move |span: &Span| clipped(span, turn, (end.max(from), to));
            self.spans.iter().filter_map(after).collect::<Vec<_>>()
        });
        let own = self.spans.iter().filter_map(|span| clipped(span, 0.0, (from, to.min(end))));
        let spans = own.chain(again).map(|span| moved(span, -from)).collect();
        Self { begin_mm: begin(self.seam_s(from), turn), spans, ..self.clone() }
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
        Self { begin_mm: begin(self.seam_s(length), turn), reverse: !self.reverse, spans, ..self.clone() }
    }
}

fn begin(s: f64, turn: Option<f64>) -> NonNegative {
    let s = turn.map_or(s, |turn| s.rem_euclid(turn));
    NonNegative::new(s.max(0.0)).unwrap_or_default()
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

/// The part of `span`, moved on by `by`, between two path lengths; `None` if it is empty.
fn clipped(span: &Span, by: f64, (from, to): (f64, f64)) -> Option<Span> {
    let (from, to) = (from.max(span.from_mm.get() + by), to.min(span.to_mm.get() + by));
    if to - from <= SAME_POSITION_MM {
        return None;
    }
    let ends = (span.part(from - by), span.part(to - by));
    let process: ProcessValues =
        span.process.iter().map(|(name, value)| (name.clone(), between(*value, ends, Finite::new))).collect();
    Some(Span {
        from_mm: NonNegative::new(from)?,
        to_mm: Positive::new(to)?,
        speed_mm_s: between(span.speed_mm_s, ends, Positive::new),
        process,
    })
}

/// A value between two parts of its span.
fn between<T: Copy + Into<f64>>(
    value: SpanValue<T>,
    (from, to): (f64, f64),
    new: impl Fn(f64) -> Option<T>,
) -> SpanValue<T> {
    let ramp = || Some(Ramp { from: new(value.at(from))?, to: new(value.at(to))? });
    if value.is_ramp() { ramp().map_or(value, SpanValue::Ramp) } else { value }
}
