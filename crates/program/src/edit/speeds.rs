//! Speeds of cubics in a document: a line for each point, as points have them.

use super::draft::{PointsDraft, Row};
use super::merge::take_out;
use super::rows::{RowRun, Written};
use crate::points::Points;
use toml_edit::{Array, Item, TableLike};

/// Rows of each part, by how many there are in it; the first one has index 1.
pub(super) fn row_runs(counts: impl Iterator<Item = usize>) -> Vec<RowRun> {
    let mut next = 1;
    let run = |count: usize| {
        next += count;
        RowRun { first: next - count, count }
    };
    counts.map(run).collect()
}

/// The speeds of a pass as they are written: all of its cubics in a row.
pub(super) struct WrittenSpeeds {
    written: Written,
    points: Vec<RowRun>,
    /// Rows of speeds of each span.
    speeds: Vec<RowRun>,
    /// Rows that are in the new document: a second copy does not repeat their comments.
    used: Vec<bool>,
}

impl WrittenSpeeds {
    /// `arrays` are those of the spans.
    pub(super) fn new(before: &Points, after: &PointsDraft, arrays: &[Option<Array>]) -> Self {
        let rows = before.spans.iter().flat_map(|span| &span.speeds);
        let numbers = std::iter::once(Vec::new()).chain(rows.map(|row| row.iter().map(|n| n.get()).collect()));
        let numbers: Vec<Vec<f64>> = numbers.collect();
        let names: Vec<String> = after.place_columns().into_iter().map(|i| after.columns[i].clone()).collect();
        Self {
            used: vec![false; numbers.len()],
            written: Written::new(None, arrays, numbers, &names, &names),
            points: row_runs(before.spans.iter().map(|span| span.points.len())),
            speeds: row_runs(before.spans.iter().map(|span| span.speeds.len())),
        }
    }

    /// Writes the speeds of span `i` into its table, if it is a cubic.
    pub(super) fn write(&mut self, table: &mut dyn TableLike, after: &PointsDraft, i: usize) {
        let span = &after.spans[i];
        if !span.is_cubic() {
            return take_out(table, "speeds");
        }
        let places = std::iter::once(after.before_span(i)).chain(&span.rows);
        let row = |(place, numbers): (&Row, Vec<f64>)| {
            let from = span.from.zip(place.from).and_then(|(span, point)| self.from(span, point));
            Row { from, ..Row::new(numbers) }
        };
        let rows: Vec<Row> = places.zip(span.all_speeds()).map(row).collect();
        let speeds = table.entry("speeds").or_insert_with(|| Item::Value(Array::new().into()));
        if let Some(array) = speeds.as_array_mut() {
            self.written.write(array, &rows, span.from.map(|span| self.speeds[span]));
        }
    }

    /// The row of speeds at a point of a span, or at its start, if it is not used yet.
    fn from(&mut self, span: usize, point: usize) -> Option<usize> {
        let (points, speeds) = (self.points[span], self.speeds[span]);
        let k = (point + 1).checked_sub(points.first).filter(|k| *k <= points.count && *k < speeds.count)?;
        let row = speeds.first + k;
        (!std::mem::replace(&mut self.used[row], true)).then_some(row)
    }
}
