//! Spans: the way to their points, in two, together.

use super::draft::{Body, Draft, PointsDraft, Row, RowSpan, SeamSpan, from_to};
use super::report::Report;
use crate::pass::Pass;
use crate::path_length::{is_before, is_beyond};
use crate::path_range::PathRange;
use crate::points::Along;
use crate::span::Span;
use crate::span_value::{Ramp, SpanValue};
use schemars::JsonSchema;
use seamwright_document::{Direction, DocumentError, Finite, NonNegative, Point, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// Slopes and values of ramps that differ by less than this part of the value go on into each other.
const SAME: f64 = 1e-9;

/// Changes the way to the points of a span.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Interpolate {
    /// The pass, from 1.
    pub pass: usize,
    /// The span, from 1.
    pub span: usize,
    /// The way to each of its points.
    pub along: Along,
    /// The point that an arc goes through, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub via_mm: Option<Point>,
    /// Axis of a helix.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normal: Option<Direction>,
    /// Time or speed to each of its points, if they were reached by rapid before.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pace: Option<Positive>,
}

/// Splits a span: at a point, or along the seam at a path length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SplitSpan {
    /// The pass, from 1.
    pub pass: usize,
    /// The last point of the first part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<usize>,
    /// Path length from the start of the pass, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub s_mm: Option<Finite>,
}

/// Joins a span with the next one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JoinSpans {
    /// The pass, from 1.
    pub pass: usize,
    /// The first of the two, from 1.
    pub span: usize,
}

fn index(draft: &Draft, pass: usize, span: usize, count: usize) -> Result<usize, DocumentError> {
    if (1..=count).contains(&span) {
        return Ok(span - 1);
    }
    let allowed = if count == 0 { Message::new("program-pass-of-more-spans") } else { from_to(1, count) };
    Err(draft.wrong_in(pass, Message::new("program-no-span").number("span", span as f64, 0), allowed))
}

impl Interpolate {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let count = draft.points(self.pass)?.spans.len();
        let i = index(draft, self.pass, self.span, count)?;
        let span = &mut draft.points(self.pass)?.spans[i];
        let rapid = span.along == Along::Rapid;
        if self.along == Along::Rapid && !rapid && draft.points(self.pass)?.arc {
            let message = Message::new("program-rapid-with-arc");
            return Err(draft.wrong_in(self.pass, message, Message::new("program-ways-or-no-arc")));
        }
        if self.along == Along::Cubic && !draft.points(self.pass)?.timed() {
            let message = Message::new("program-cubic-needs-times");
            return Err(draft.wrong_in(self.pass, message, Message::new("program-pass-with-times")));
        }
        let span = &mut draft.points(self.pass)?.spans[i];
        if self.along == Along::Arc && (self.via_mm.is_none() || span.rows.len() != 1) {
            let message = Message::new("program-arc-of-points").count("points", span.rows.len());
            return Err(draft.wrong_in(self.pass, message, Message::new("program-split-first")));
        }
        if self.along != Along::Arc && (self.via_mm.is_some() || self.normal.is_some()) {
            let message = Message::new("program-via-of-arcs").text("along", self.along.name());
            return Err(draft.wrong_in(self.pass, message, Message::new("program-leave-out")));
        }
        if rapid && self.along != Along::Rapid && self.pace.is_none() {
            let message = Message::new("program-rapid-without-pace");
            return Err(draft.wrong_in(self.pass, message, Message::new("program-pace")));
        }
        if self.pace.is_some() && (!rapid || self.along == Along::Rapid) {
            return Err(draft.wrong_in(self.pass, Message::new("program-pace-given"), Message::new("program-no-pace")));
        }
        (span.along, span.via, span.normal) = (self.along, self.via_mm.map(Point::get), self.normal);
        let pace = if self.along == Along::Rapid { Some(0.0) } else { self.pace.map(Positive::get) };
        if let Some(pace) = pace {
            span.rows.iter_mut().for_each(|row| *row.pace() = pace);
        }
        let points = draft.points(self.pass)?;
        let speeds = (self.along == Along::Cubic).then(|| points.smooth_speeds(i));
        let span = &mut points.spans[i];
        match speeds {
            Some(speeds) => span.set_speeds(speeds),
            None => span.forget_speeds(),
        }
        let words = Message::new("program-edit-along").pass("pass", self.pass).number("span", self.span as f64, 0);
        Ok(Report::new(words.text("along", self.along.name())).spans(self.pass, self.span, self.span))
    }
}

impl SplitSpan {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let span = match (&draft.pass(self.pass)?.body, self.point, self.s_mm) {
            (Body::Points(_), Some(point), None) => {
                let points = draft.points(self.pass)?;
                let count = points.count();
                match (1..count).contains(&point).then(|| points.split(point)).flatten() {
                    Some(span) => span,
                    None => {
                        let message = Message::new("program-no-split-at-point").number("point", point as f64, 0);
                        return Err(draft.wrong_in(self.pass, message, Message::new("program-point-within-span")));
                    }
                }
            }
            (Body::Seam(_), None, Some(s)) => {
                let pass = draft.pass(self.pass)?;
                match pass.split(s.get()) {
                    Some(span) => span,
                    None => {
                        let message = Message::new("program-no-split-at-length").value("s", s.get(), Unit::Mm);
                        return Err(draft.wrong_in(self.pass, message, Message::new("program-length-within-span")));
                    }
                }
            }
            _ => {
                let message = Message::new("program-split-unclear");
                return Err(draft.wrong_in(self.pass, message, Message::new("program-split-keys")));
            }
        };
        let words =
            Message::new("program-edit-span-split").pass("pass", self.pass).number("span", (span + 1) as f64, 0);
        Ok(Report::new(words).spans(self.pass, span + 1, span + 2))
    }
}

impl PointsDraft {
    /// Splits the span of `point` behind it, if it is not its last; the index of the first part.
    pub(super) fn split(&mut self, point: usize) -> Option<usize> {
        let (span, k) = self.place(point);
        let rows = &mut self.spans[span].rows;
        if k + 1 >= rows.len() {
            return None;
        }
        let rest: Vec<Row> = rows.drain(k + 1..).collect();
        let begin_speeds = rows[k].speeds.clone();
        self.spans.insert(span + 1, RowSpan { rows: rest, begin_speeds, ..self.spans[span].clone() });
        Some(span)
    }
}

impl super::draft::PassDraft {
    /// Splits the span along the seam at path length `s` (mm), if that lies within one; its index.
    pub(super) fn split(&mut self, s: f64) -> Option<usize> {
        let Body::Seam(spans) = &mut self.body else { return None };
        let inside = |span: &SeamSpan| is_beyond(s, span.span.from_mm.get()) && is_before(s, span.span.to_mm.get());
        let i = spans.iter().position(inside)?;
        let (from, to) = (spans[i].span.from_mm.get(), spans[i].span.to_mm.get());
        let alone = Pass { spans: vec![spans[i].span.clone()], ..self.pass.clone() };
        let part = |from_mm: f64, to_mm: f64| alone.piece(PathRange { from_mm, to_mm }, None).spans.into_iter().next();
        let (first, second) = (part(from, s)?, part(s, to)?);
        // Values are those of the pieces, path lengths the ones meant.
        let first = Span { from_mm: spans[i].span.from_mm, to_mm: Positive::new(s)?, ..first };
        let second = Span { from_mm: NonNegative::new(s)?, to_mm: spans[i].span.to_mm, ..second };
        spans[i].span = first;
        spans.insert(i + 1, SeamSpan { span: second, from: spans[i].from });
        Some(i)
    }
}

/// `message` with a span, counted from 1, and the next one.
fn two_spans(message: Message, span: usize) -> Message {
    message.number("first", span as f64, 0).number("second", (span + 1) as f64, 0)
}

impl JoinSpans {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let count = match &draft.pass(self.pass)?.body {
            Body::Seam(spans) => spans.len(),
            Body::Points(points) => points.spans.len(),
        };
        let i = index(draft, self.pass, self.span, count.saturating_sub(1))?;
        let joined = match &mut draft.pass(self.pass)?.body {
            Body::Seam(spans) => joined(&spans[i].span, &spans[i + 1].span).map(|span| {
                spans[i].span = span;
                spans.remove(i + 1);
            }),
            Body::Points(points) => points.join(i),
        };
        if joined.is_none() {
            let message = two_spans(Message::new("program-spans-not-joined"), self.span);
            return Err(draft.wrong_in(self.pass, message, Message::new("program-spans-that-join")));
        }
        let words = two_spans(Message::new("program-edit-spans-joined").pass("pass", self.pass), self.span);
        Ok(Report::new(words).spans(self.pass, self.span, self.span))
    }
}

impl PointsDraft {
    /// Joins span `i` with the next, if both go the same way.
    pub(super) fn join(&mut self, i: usize) -> Option<()> {
        let (first, second) = (&self.spans[i], self.spans.get(i + 1)?);
        if first.along != second.along || first.stops != second.stops || first.along == Along::Arc {
            return None;
        }
        let end = &first.rows[first.rows.len() - 1].speeds;
        let goes_on = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME * a.abs().max(b.abs());
        if !end.iter().zip(&second.begin_speeds).all(goes_on) {
            return None;
        }
        let rows = self.spans.remove(i + 1).rows;
        self.spans[i].rows.extend(rows);
        Some(())
    }
}

/// Two spans as one, if speed and process values go on.
fn joined(first: &Span, second: &Span) -> Option<Span> {
    let lengths = [first, second].map(|span| span.to_mm.get() - span.from_mm.get());
    let speed_mm_s = one(first.speed_mm_s, second.speed_mm_s, lengths)?;
    let same_names = first.process.keys().eq(second.process.keys());
    let values = first.process.iter().zip(second.process.values());
    let process = values.map(|((name, a), b)| Some((name.clone(), one(*a, *b, lengths)?)));
    let process = process.collect::<Option<_>>().filter(|_| same_names)?;
    Some(Span { from_mm: first.from_mm, to_mm: second.to_mm, speed_mm_s, process })
}

/// Two values over spans of these lengths as one, if they are the same or one ramp.
fn one<T: Copy + Into<f64> + PartialEq>(
    first: SpanValue<T>,
    second: SpanValue<T>,
    [l1, l2]: [f64; 2],
) -> Option<SpanValue<T>> {
    match (first, second) {
        (SpanValue::Steady(a), SpanValue::Steady(b)) => (a == b).then_some(first),
        (SpanValue::Ramp(Ramp { from, .. }), SpanValue::Ramp(Ramp { to, .. })) => {
            let ((a, b), (c, d)) = (first.ends(), second.ends());
            let scale = SAME * a.abs().max(b.abs()).max(d.abs());
            let through = a + (d - a) * l1 / (l1 + l2);
            ((b - c).abs() <= scale && (b - through).abs() <= scale).then_some(SpanValue::Ramp(Ramp { from, to }))
        }
        _ => None,
    }
}
