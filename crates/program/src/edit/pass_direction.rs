//! The order in which a pass runs: the other way round, or from another point.

use super::draft::{Body, Draft, PointsDraft, Row, SeamSpan, from_to, through_points};
use super::points::no_point;
use super::reordered_events::reordered;
use super::report::Report;
use crate::path_length::is_before;
use schemars::JsonSchema;
use seamwright_document::{DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// Maximum distance between end and start of a closed run of points, in every number of a position: mm, degrees.
const CLOSED: f64 = 1e-6;

/// Turns a pass to run from its end to its start. Times and speeds, stepped values and block numbers stay with the way
/// between two points, and `stops` with its span; what is switched on stays on over the same ways.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReversePass {
    /// The pass, from 1.
    pub pass: usize,
    /// Of a pass along a seam welded all round: the length of the seam, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seam_length_mm: Option<Positive>,
}

/// Shifts where something begins: exactly one of `point`, `begin_mm`, `phi_deg`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShiftStart {
    /// The pass, from 1; none with `phi_deg`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pass: Option<usize>,
    /// The point at which a closed run of points is to begin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<usize>,
    /// New start of a pass on the seam, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub begin_mm: Option<NonNegative>,
    /// New start of the weld on the seam, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_deg: Option<Finite>,
}

impl ReversePass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let pass = draft.pass(self.pass)?;
        let end = pass.pass().map_or(0.0, |pass| pass.length());
        let begin = pass.pass.begin_mm.get();
        match &mut pass.body {
            Body::Points(points) => {
                if self.seam_length_mm.is_some() {
                    let message = Message::new("program-points-without-seam");
                    return Err(draft.wrong_in(self.pass, message, Message::new("program-no-seam-length")));
                }
                points.reverse();
            }
            Body::Seam(_) if self.seam_length_mm.is_none() && pass.pass.reverse && is_before(begin, end) => {
                let message = Message::new("program-pass-over-start");
                return Err(draft.wrong_in(self.pass, message, Message::new("program-seam-length")));
            }
            Body::Seam(spans) => {
                let from: Vec<Option<usize>> = spans.iter().rev().map(|span| span.from).collect();
                let Some(whole) = pass.pass() else {
                    return Err(draft.wrong_in(self.pass, Message::new("program-number-not-finite"), ""));
                };
                let mut turned = whole.turned(self.seam_length_mm.map(Positive::get));
                let spans = std::mem::take(&mut turned.spans);
                let spans = spans.into_iter().zip(from).map(|(span, from)| SeamSpan { span, from });
                (pass.body, pass.pass) = (Body::Seam(spans.collect()), turned);
            }
        }
        Ok(Report::new(Message::new("program-edit-reversed").pass("pass", self.pass)).pass(self.pass))
    }
}

impl PointsDraft {
    /// The numbers of a position with those of the way to another: the columns of ways come from `way`.
    fn with_way(&self, place: &Row, way: &Row) -> Row {
        let mut row = place.clone();
        self.way_columns().into_iter().for_each(|i| row.numbers[i] = way.numbers[i]);
        row.speeds.clear();
        row
    }

    fn reverse(&mut self) {
        let rows: Vec<Row> = self.rows().cloned().collect();
        let last = rows.len() - 1;
        let mut at = last;
        let mut spans = std::mem::take(&mut self.spans);
        spans.reverse();
        for span in &mut spans {
            let mut speeds = span.all_speeds();
            speeds.reverse();
            for row in &mut span.rows {
                *row = self.with_way(&rows[at - 1], &rows[at]);
                at -= 1;
            }
            span.set_speeds(speeds);
            span.scale_speeds(-1.0);
        }
        self.spans = spans;
        self.start = self.with_way(&rows[last], &rows[0]);
        self.events = reordered(&self.events, last, |i| last - 1 - i, |after| last - after);
    }

    /// Whether it ends where it starts.
    fn is_closed(&self) -> bool {
        let ways = self.way_columns();
        let known = self.known();
        let place = |i: &usize| !ways.contains(i) && !known.process.iter().any(|(_, column)| column == i);
        let last = self.rows().last().unwrap_or(&self.start);
        let near = |i: usize| (last.numbers[i] - self.start.numbers[i]).abs() <= CLOSED;
        (0..self.columns.len()).filter(place).all(near)
    }

    /// Begins at point `k`, which is neither the start nor the last one.
    fn rotate(&mut self, k: usize) {
        let count = self.count();
        self.split(k);
        let (span, _) = self.place(k);
        let at = self.rows().nth(k).unwrap_or(&self.start);
        self.start = self.with_way(at, &self.start);
        self.spans.rotate_left(span + 1);
        let new_point = |after: usize| if after < k { after + count - k } else { after - k };
        self.events = reordered(&self.events, count, |i| (i + k) % count, new_point);
    }
}

impl ShiftStart {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        match (self.pass, self.point, self.begin_mm, self.phi_deg) {
            (Some(pass), Some(point), None, None) => Self::at_point(draft, pass, point),
            (Some(pass), None, Some(begin), None) => {
                let there = draft.pass(pass)?;
                if matches!(there.body, Body::Points(_)) {
                    return Err(draft.wrong_in(pass, through_points(pass), Message::new("program-start-point")));
                }
                there.pass.begin_mm = begin;
                let words =
                    Message::new("program-edit-pass-start").pass("pass", pass).value("s", begin.get(), Unit::Mm);
                Ok(Report::new(words).pass(pass))
            }
            (None, None, None, Some(phi)) => {
                if draft.head.seam.is_none() {
                    return Err(draft.wrong(Message::new("program-start-without-seam"), "`pass`, `point`"));
                }
                draft.head.start.phi_deg = phi;
                Ok(Report::new(Message::new("program-edit-weld-start").value("phi", phi.get(), Unit::Deg)))
            }
            _ => Err(draft.wrong(Message::new("program-start-unclear"), Message::new("program-start-keys"))),
        }
    }

    fn at_point(draft: &mut Draft, pass: usize, point: usize) -> Result<Report, DocumentError> {
        let points = draft.points(pass)?;
        let count = points.count();
        if !points.is_closed() {
            let message = Message::new("program-points-not-closed");
            return Err(draft.wrong_in(pass, message, Message::new("program-closed-points")));
        }
        if point > count {
            return Err(draft.wrong_in(pass, no_point(point), from_to(0, count)));
        }
        if (1..count).contains(&point) {
            points.rotate(point);
        }
        let words = Message::new("program-edit-pass-start-point").pass("pass", pass).number("point", point as f64, 0);
        Ok(Report::new(words).pass(pass))
    }
}
