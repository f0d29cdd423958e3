//! Single points: their numbers, new ones, fewer of them.

use super::draft::{Draft, PointRange, PointsDraft, Row, RowSpan};
use super::report::Report;
use crate::arc_through::ArcThrough;
use crate::points::{Along, numbers_for_columns};
use glam::DVec3;
use schemars::JsonSchema;
use seamwright_document::{Direction, DocumentError, Finite};
use seamwright_message::{Argument, Message};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Sets numbers of a point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SetPoint {
    /// The pass, from 1.
    pub pass: usize,
    /// The point; 0 is the start.
    pub point: usize,
    /// Numbers by the names of their columns; others stay.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub set: BTreeMap<String, Finite>,
    /// Speeds there, a second, of the cubics that end and begin at the point, by the names of the columns of the place.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub speeds: BTreeMap<String, Finite>,
}

/// Inserts a point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InsertPoint {
    /// The pass, from 1.
    pub pass: usize,
    /// The point after which it comes; 0 is the start.
    pub after: usize,
    /// A number for each column. Without: halfway to the next point, straight or round its arc, which then are two; the time
    /// is shared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub numbers: Option<Vec<Finite>>,
}

/// Deletes points after the start.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeletePoints {
    /// The pass, from 1.
    pub pass: usize,
    /// The first one.
    pub from: usize,
    /// The last one; without it only the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<usize>,
}

impl SetPoint {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let count = draft.points(self.pass)?.count();
        if self.point > count {
            let allowed = Message::new("program-start-to-point").number("max", count as f64, 0);
            return Err(draft.wrong_in(self.pass, no_point(self.point), allowed));
        }
        if self.set.is_empty() && self.speeds.is_empty() {
            let message = Message::new("program-no-number-given");
            return Err(draft.wrong_in(self.pass, message, Message::new("program-at-least-one-column")));
        }
        for (name, value) in &self.set {
            let points = draft.points(self.pass)?;
            let Some(column) = points.column(name) else { return Err(unknown_column(draft, self.pass, name)) };
            if let Some(row) = points.rows_mut().nth(self.point) {
                row.numbers[column] = value.get();
            }
        }
        self.set_speeds(draft)?;
        let speed = |name: &String| Message::new("program-edit-speed-of").key("column", name);
        let speeds = self.speeds.keys().map(|name| Argument::Message(Box::new(speed(name))));
        let columns = self.set.keys().map(|name| Argument::Key(name.clone())).chain(speeds);
        let words = Message::new("program-edit-point").pass("pass", self.pass);
        let words = words.number("point", self.point as f64, 0).list("columns", columns);
        Ok(Report::new(words).points(self.pass, self.point, self.point))
    }

    fn set_speeds(&self, draft: &mut Draft) -> Result<(), DocumentError> {
        for (name, speed) in &self.speeds {
            let points = draft.points(self.pass)?;
            let places = points.place_columns();
            let Some(k) = points.column(name).and_then(|column| places.iter().position(|c| *c == column)) else {
                let names: Vec<String> = places.iter().map(|c| points.columns[*c].clone()).collect();
                let message = Message::new("program-column-without-speed").key("column", name);
                return Err(draft.wrong_in(self.pass, message, names.join(", ")));
            };
            let at_point = points.speeds_at(self.point);
            if at_point.is_empty() {
                let message = Message::new("program-no-cubic-at-point").number("point", self.point as f64, 0);
                return Err(draft.wrong_in(self.pass, message, Message::new("program-point-of-cubic")));
            }
            at_point.into_iter().for_each(|speeds| speeds[k] = speed.get());
        }
        Ok(())
    }
}

/// The fault of an edit of a point that the pass does not have.
pub(super) fn no_point(point: usize) -> Message {
    Message::new("program-no-point").number("point", point as f64, 0)
}

/// The column `name` is not among those of a pass through points.
pub(super) fn unknown_column(draft: &mut Draft, pass: usize, name: &str) -> DocumentError {
    let columns = draft.points(pass).map(|points| points.columns.clone()).unwrap_or_default();
    let known: Vec<&str> = columns.iter().map(String::as_str).collect();
    draft.file.unknown_name(&format!("passes[{}].points.columns", pass - 1), name, &known)
}

impl InsertPoint {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let file = draft.file;
        let points = draft.points(self.pass)?;
        let (count, width, after) = (points.count(), points.columns.len(), self.after);
        let refused = |message: Message, max: usize| {
            let allowed = Message::new("program-after-start-to-point").number("max", max as f64, 0);
            Err(file.error_at("passes", message, allowed))
        };
        if after > count {
            return refused(no_point(after), count);
        }
        match &self.numbers {
            Some(numbers) if numbers.len() != width => {
                let (message, allowed) = numbers_for_columns(numbers.len(), &draft.points(self.pass)?.columns);
                return Err(draft.wrong_in(self.pass, message, allowed));
            }
            Some(numbers) => {
                let mut row = Row::new(numbers.iter().map(|n| n.get()).collect());
                let (span, k) = if after == count {
                    (points.spans.len() - 1, points.spans[points.spans.len() - 1].rows.len())
                } else {
                    points.place(after + 1)
                };
                if points.spans[span].along == Along::Arc {
                    // An arc has one point: before it, or behind it, goes a line.
                    let new = RowSpan {
                        via: None,
                        normal: None,
                        begin_speeds: Vec::new(),
                        along: Along::Line,
                        rows: vec![row],
                        stops: false,
                        from: None,
                    };
                    points.spans.insert(span + k, new);
                } else {
                    if points.spans[span].is_cubic() {
                        let before = points.rows().nth(after).unwrap_or(&points.start);
                        row.speeds = points.speeds_between(before, &row, points.spans[span].rows.get(k));
                    }
                    points.spans[span].rows.insert(k, row);
                }
            }
            None if after == count => {
                return refused(Message::new("program-no-next-point"), count - 1);
            }
            None => points.insert_halfway(after),
        }
        draft.points(self.pass)?.move_events(|event| if event > after { event + 1 } else { event });
        let words = Message::new("program-edit-point-inserted").pass("pass", self.pass);
        Ok(Report::new(words.number("after", after as f64, 0)).points(self.pass, after + 1, after + 1))
    }
}

impl PointsDraft {
    /// Puts a point halfway between `after` and the next one.
    fn insert_halfway(&mut self, after: usize) {
        let (span, k) = self.place(after + 1);
        let (Some(before), Some(next)) = (self.rows().nth(after).cloned(), self.rows().nth(after + 1).cloned()) else {
            return;
        };
        let half = |(a, b): (&f64, &f64)| a + 0.5 * (b - a);
        let mut row = Row::new(before.numbers.iter().zip(&next.numbers).map(half).collect());
        for column in self.way_columns() {
            row.numbers[column] = next.numbers[column];
        }
        if let Some(n) = self.column(crate::points::NUMBER_COLUMN) {
            row.numbers[n] = 0.0;
        }
        self.set_direction(&mut row, &before);
        if self.spans[span].is_cubic() {
            let begin = if k == 0 { &self.spans[span].begin_speeds } else { &before.speeds };
            self.set_halfway(&mut row, &before, begin, &next);
        }
        if self.timed() {
            *row.pace() *= 0.5;
            *self.spans[span].rows[k].pace() = 0.5 * *next.clone().pace();
        }
        let places = self.places();
        let there = &mut self.spans[span];
        let arc = places.zip(there.via).and_then(|(columns, via)| {
            let way =
                ArcThrough::new(before.place(columns), via, next.place(columns), there.normal.map(Direction::unit))?;
            Some((columns, way))
        });
        match arc {
            Some((columns, way)) => {
                row.set_place(columns, way.at(0.5));
                there.via = Some(way.at(0.75));
                let first = RowSpan { via: Some(way.at(0.25)), rows: vec![row], from: None, ..there.clone() };
                self.spans.insert(span, first);
            }
            None => there.rows.insert(k, row),
        }
    }

    /// Opposite torch directions have no mean: then the direction before is used.
    fn set_direction(&self, row: &mut Row, before: &Row) {
        let Some(columns) = self.directions() else { return };
        let mean = row.place(columns);
        let usual = before.place(columns).normalize_or_zero();
        row.set_place(columns, mean.try_normalize().filter(|_| mean.length() > 1e-6).unwrap_or(usual));
    }

    /// Columns of the torch's direction.
    pub(super) fn directions(&self) -> Option<[usize; 3]> {
        let [x, y, z] = ["ax", "ay", "az"].map(|name| self.column(name));
        Some([x?, y?, z?])
    }

    /// Direction of the torch at a point; straight down without a direction.
    pub(super) fn direction(&self, row: &Row) -> DVec3 {
        self.directions().map_or(-DVec3::Z, |columns| row.place(columns).normalize_or_zero())
    }

    pub(super) fn move_events(&mut self, to: impl Fn(usize) -> usize) {
        self.events.iter_mut().for_each(|event| event.event.after = to(event.event.after));
    }

    /// Deletes a point after the start; its time goes to the next one.
    fn delete(&mut self, point: usize) {
        let (span, k) = self.place(point);
        let mut row = self.spans[span].rows.remove(k);
        let was_rapid = self.spans[span].along == Along::Rapid;
        if self.spans[span].rows.is_empty() {
            self.spans.remove(span);
        }
        if self.timed() && !was_rapid && point <= self.count() {
            let (span, k) = self.place(point);
            if self.spans[span].along != Along::Rapid {
                *self.spans[span].rows[k].pace() += *row.pace();
            }
        }
    }
}

impl DeletePoints {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let PointRange { from, to } = draft.range(self.pass, Some([self.from, self.to.unwrap_or(self.from)]), 1)?;
        let points = draft.points(self.pass)?;
        let deleted = to - from + 1;
        if deleted == points.count() {
            let message = Message::new("program-no-point-left");
            return Err(draft.wrong_in(self.pass, message, Message::new("program-keep-a-point")));
        }
        (0..deleted).for_each(|_| points.delete(from));
        points.move_events(|after| if after > to { after - deleted } else { after.min(from - 1) });
        let words = Message::new("program-edit-points-deleted").pass("pass", self.pass);
        let words = words.number("from", from as f64, 0).number("to", to as f64, 0);
        Ok(Report::new(words).points(self.pass, from - 1, from - 1))
    }
}
