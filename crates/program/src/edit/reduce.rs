//! Points joined by lines as lines and arcs.

use super::draft::{Draft, PointRange, PointsDraft, Row, RowSpan};
use super::report::Report;
use crate::arc_through::ArcThrough;
use crate::points::Along;
use glam::{DQuat, DVec3};
use schemars::JsonSchema;
use seamwright_document::{DocumentError, Positive};
use seamwright_geometry::reduce::{Method, Shape, Span, Tolerances, reduce};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Points joined by lines become as few lines and arcs as the tolerance lets them; ends of spans, points with events and
/// those at which a stepped value changes stay. Every point is within the tolerance of its line or arc, every further
/// number goes along linearly; times add up, speeds become those that take as long.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Reduce {
    /// The pass, from 1.
    pub pass: usize,
    /// Maximum distance of a point from its line or arc, mm.
    pub tolerance_mm: Positive,
    /// Maximum deviation of a further number from its linear course, in its own unit; the number of `tolerance_mm` if
    /// missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis_tolerance: Option<Positive>,
}

impl Reduce {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let tolerances = (self.tolerance_mm.get(), self.axis_tolerance.unwrap_or(self.tolerance_mm).get());
        let points = draft.points(self.pass)?;
        let before = points.count();
        let Some(columns) = points.places() else {
            let message = Message::new("program-points-without-xyz");
            return Err(draft.wrong_in(self.pass, message, Message::new("program-poses-or-xyz")));
        };
        if let Err(error) = points.reduce(columns, tolerances) {
            let allowed = Message::new("program-positions-within").value("max", 1e9, Unit::Mm);
            return Err(draft.wrong_in(self.pass, error.message(), allowed));
        }
        let after = draft.points(self.pass)?.count();
        let words = Message::new("program-edit-reduced").pass("pass", self.pass);
        Ok(Report::new(words.count("before", before).count("after", after)).points(self.pass, 0, after))
    }
}

impl PointsDraft {
    fn reduce(&mut self, columns: [usize; 3], tolerances: (f64, f64)) -> Result<(), seamwright_geometry::Error> {
        let rows: Vec<Row> = self.rows().cloned().collect();
        let (mut first, mut spans, mut kept) = (0, Vec::new(), vec![0]);
        for span in std::mem::take(&mut self.spans) {
            let last = first + span.rows.len();
            if span.along != Along::Line || span.stops {
                kept.extend(first + 1..=last);
                spans.push(span);
            } else {
                let mut from = span.from;
                for stretch in self.stretches(&rows, PointRange { from: first, to: last }) {
                    let rows = &rows[stretch.from..=stretch.to];
                    for part in self.reduced(rows, columns, tolerances)? {
                        kept.push(stretch.from + part.last);
                        self.push(&mut spans, rows, part, columns, &mut from);
                    }
                }
            }
            first = last;
        }
        self.spans = spans;
        self.move_events(|after| kept.binary_search(&after).unwrap_or_else(|i| i));
        Ok(())
    }

    /// Parts of a run of lines that are reduced on their own.
    fn stretches(&self, rows: &[Row], run: PointRange) -> Vec<PointRange> {
        let stepped: Vec<usize> = self.stepped.iter().filter_map(|name| self.column(name)).collect();
        let is_kept = |i: &usize| {
            let event = self.events.iter().any(|event| event.event.after == *i);
            event || stepped.iter().any(|c| (rows[*i].numbers[*c] - rows[i + 1].numbers[*c]).abs() > 0.0)
        };
        let mut ends = vec![run.from];
        ends.extend((run.from + 1..run.to).filter(is_kept));
        ends.push(run.to);
        ends.windows(2).map(|pair| PointRange { from: pair[0], to: pair[1] }).collect()
    }

    /// Lines and arcs through `rows`, by their indices.
    fn reduced(
        &self,
        rows: &[Row],
        columns: [usize; 3],
        tolerances: (f64, f64),
    ) -> Result<Vec<Span>, seamwright_geometry::Error> {
        let ways = self.way_columns();
        let further = (0..self.columns.len()).filter(|i| !ways.contains(i) && !columns.contains(i));
        let further: Vec<Vec<f64>> = further.map(|i| rows.iter().map(|row| row.numbers[i]).collect()).collect();
        let places: Vec<DVec3> = rows.iter().map(|row| row.place(columns)).collect();
        let tolerances = Tolerances { path_mm: tolerances.0, columns: tolerances.1 };
        Ok(reduce(&places, &further, tolerances, Method::Fewest)?.spans)
    }

    /// Adds a line or arc between two of `rows` as a point more of the last span, or a span of its own.
    fn push(&self, spans: &mut Vec<RowSpan>, rows: &[Row], part: Span, columns: [usize; 3], from: &mut Option<usize>) {
        let Span { first, last, .. } = part;
        let [start, end] = [first, last].map(|i| rows[i].place(columns));
        let arc = via(part.shape, start, end).and_then(|via| Some((via, ArcThrough::new(start, via, end, None)?)));
        let length = arc.as_ref().map_or_else(|| (end - start).length(), |(_, way)| way.length());
        let mut row = rows[last].clone();
        if last > first + 1 {
            *row.pace() = self.pace(&rows[first..=last], length, columns);
        }
        let is_first = from.is_some();
        if let (None, false, Some(there)) = (&arc, is_first, spans.last_mut())
            && (there.along, there.stops) == (Along::Line, false)
        {
            there.rows.push(row);
            return;
        }
        let along = if arc.is_some() { Along::Arc } else { Along::Line };
        let via = arc.map(|(via, _)| via);
        spans.push(RowSpan {
            along,
            stops: false,
            via,
            normal: None,
            begin_speeds: Vec::new(),
            rows: vec![row],
            from: from.take(),
        });
    }

    /// Time or speed of a way of this length, which replaces those between the points.
    fn pace(&self, rows: &[Row], length: f64, columns: [usize; 3]) -> f64 {
        let pace = |row: &Row| row.numbers[row.numbers.len() - 1];
        if self.timed() {
            return rows[1..].iter().map(pace).sum();
        }
        let way = |pair: &[Row]| (pair[1].place(columns) - pair[0].place(columns)).length() / pace(&pair[1]);
        let seconds: f64 = rows.windows(2).map(way).sum();
        let speed = length / seconds;
        if speed.is_finite() && speed > 0.0 { speed } else { pace(&rows[rows.len() - 1]) }
    }
}

/// The point halfway round an arc; `None` for a line.
fn via(shape: Shape, start: DVec3, end: DVec3) -> Option<DVec3> {
    let Shape::Arc { centre, normal, .. } = shape else { return None };
    let (from, to) = (start - centre, end - centre);
    let sweep = normal.dot(from.cross(to)).atan2(from.dot(to)).rem_euclid(TAU);
    Some(centre + DQuat::from_axis_angle(normal, 0.5 * sweep) * from)
}
