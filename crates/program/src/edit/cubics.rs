//! Speeds of cubics: each point of a span has its own, and so has the start of the span.

use super::draft::{PointRange, PointsDraft, Row, RowSpan};
use crate::points::Along;
use glam::DVec3;
use seamwright_geometry::CubicSpline;

/// Speeds that are worked out have so many parts of a unit, as a person would read them.
const PARTS: f64 = 1e9;

fn rounded(speed: f64) -> f64 {
    (speed * PARTS).round() / PARTS
}

impl RowSpan {
    pub(super) fn is_cubic(&self) -> bool {
        self.along == Along::Cubic
    }

    /// Speeds at the start and at each point, as files have them; empty unless it is a cubic.
    pub(super) fn all_speeds(&self) -> Vec<Vec<f64>> {
        if !self.is_cubic() {
            return Vec::new();
        }
        std::iter::once(&self.begin_speeds).chain(self.rows.iter().map(|row| &row.speeds)).cloned().collect()
    }

    /// The same for as many as [`Self::all_speeds`] has.
    pub(super) fn set_speeds(&mut self, speeds: Vec<Vec<f64>>) {
        let mut speeds = speeds.into_iter();
        self.begin_speeds = speeds.next().unwrap_or_default();
        self.rows.iter_mut().zip(speeds).for_each(|(row, speeds)| row.speeds = speeds);
    }

    /// Removes the speeds of a span that is no cubic any more.
    pub(super) fn forget_speeds(&mut self) {
        self.begin_speeds.clear();
        self.rows.iter_mut().for_each(|row| row.speeds.clear());
    }

    /// Speeds at the start and at each point; empty unless it is a cubic.
    pub(super) fn each_speeds(&mut self) -> impl Iterator<Item = &mut Vec<f64>> {
        let all = std::iter::once(&mut self.begin_speeds).chain(self.rows.iter_mut().map(|row| &mut row.speeds));
        all.filter(|speeds| !speeds.is_empty())
    }

    /// Every speed times a factor.
    pub(super) fn scale_speeds(&mut self, factor: f64) {
        self.each_speeds().flatten().for_each(|speed| *speed *= factor);
    }
}

impl PointsDraft {
    /// The position's columns, in the order of a cubic's speeds.
    pub(super) fn place_columns(&self) -> Vec<usize> {
        let known = self.known();
        let of_pose = crate::points::POSE_COLUMNS[..known.pose].iter().filter_map(|name| self.column(name));
        let mut columns: Vec<usize> = of_pose.chain(known.axes.iter().map(|(_, column)| *column)).collect();
        columns.sort_unstable();
        columns
    }

    /// Indices of some columns among a cubic's speeds; `None` if one of them holds no position.
    pub(super) fn among_speeds(&self, columns: [usize; 3]) -> Option<[usize; 3]> {
        let places = self.place_columns();
        let [x, y, z] = columns.map(|column| places.iter().position(|c| *c == column));
        Some([x?, y?, z?])
    }

    pub(super) fn before_span(&self, i: usize) -> &Row {
        self.spans[..i].iter().rev().find_map(|span| span.rows.last()).unwrap_or(&self.start)
    }

    /// Speeds for span `i` as a cubic by time: those of the natural spline through its points, which goes the same way; 0
    /// where the torch stops.
    pub(super) fn smooth_speeds(&self, i: usize) -> Vec<Vec<f64>> {
        let span = &self.spans[i];
        let columns = self.place_columns();
        let rows: Vec<&Row> = std::iter::once(self.before_span(i)).chain(&span.rows).collect();
        let mut at = vec![0.0];
        for row in &span.rows {
            at.push(at[at.len() - 1] + row.numbers[row.numbers.len() - 1]);
        }
        let spline = |column: &usize| {
            let points: Vec<(f64, f64)> = at.iter().zip(&rows).map(|(at, row)| (*at, row.numbers[*column])).collect();
            CubicSpline::natural(&points).ok().filter(|_| !span.stops)
        };
        let splines: Vec<Option<CubicSpline>> = columns.iter().map(spline).collect();
        let speeds =
            |at: &f64| splines.iter().map(|of| of.as_ref().map_or(0.0, |spline| rounded(spline.at(*at).1))).collect();
        at.iter().map(speeds).collect()
    }

    /// Speeds at a point between two others of a cubic, or behind its last: those of the parabola by time through all
    /// three, or of the way to it.
    pub(super) fn speeds_between(&self, before: &Row, there: &Row, next: Option<&Row>) -> Vec<f64> {
        let seconds = |row: &Row| row.numbers[row.numbers.len() - 1];
        let mean = |from: &Row, to: &Row, column: usize| (to.numbers[column] - from.numbers[column]) / seconds(to);
        let speed = |column: usize| {
            let behind = mean(before, there, column);
            let Some(next) = next else { return rounded(behind) };
            let (h0, h1) = (seconds(there), seconds(next));
            rounded((behind * h1 + mean(there, next, column) * h0) / (h0 + h1))
        };
        self.place_columns().into_iter().map(speed).collect()
    }

    /// Sets position and speeds of a point halfway in time of a cubic to those of the cubic, so both halves go the same
    /// way. The cubic leaves the point `before` with `begin_speeds`.
    pub(super) fn set_halfway(&self, row: &mut Row, before: &Row, begin_speeds: &[f64], next: &Row) {
        let seconds = next.numbers[next.numbers.len() - 1];
        row.speeds.clear();
        for (k, column) in self.place_columns().into_iter().enumerate() {
            let (a, b) = (before.numbers[column], next.numbers[column]);
            let (va, vb) = (begin_speeds[k], next.speeds[k]);
            row.numbers[column] = 0.5 * (a + b) + 0.125 * seconds * (va - vb);
            row.speeds.push(1.5 * (b - a) / seconds - 0.25 * (va + vb));
        }
    }

    /// Speeds of the cubics that end and start at a point.
    pub(super) fn speeds_at(&mut self, point: usize) -> Vec<&mut Vec<f64>> {
        let mut first = 0;
        let mut out = Vec::new();
        for span in &mut self.spans {
            let last = first + span.rows.len();
            if span.is_cubic() && (first..=last).contains(&point) {
                out.extend(span.each_speeds().nth(point - first));
            }
            first = last;
        }
        out
    }

    /// Scales the speeds of cubics over the ways to a range of points. They are split at the ends of this range: the
    /// point in between has one speed before it and another behind it.
    pub(super) fn scale_cubics(&mut self, range: PointRange, factor: f64) {
        let PointRange { from, to } = range;
        for point in [from - 1, to] {
            if point > 0 && self.spans[self.place(point).0].is_cubic() {
                // At the end of a span there is no cubic to split.
                let _ = self.split(point);
            }
        }
        let mut first = 0;
        for span in &mut self.spans {
            let last = first + span.rows.len();
            if from <= first + 1 && last <= to {
                span.scale_speeds(factor);
            }
            first = last;
        }
    }

    /// Speeds of cubics follow points that have moved by `by` (the start first): they change by how fast the move
    /// changes along the way.
    pub(super) fn follow(&mut self, by: &[DVec3], columns: [usize; 3]) {
        let Some(among) = self.among_speeds(columns) else { return };
        let mut first = 0;
        for span in &mut self.spans {
            let last = first + span.rows.len();
            if span.is_cubic() {
                let seconds: Vec<f64> = span.rows.iter_mut().map(|row| *row.pace()).collect();
                let rates = rates(&by[first..=last], &seconds);
                let mut speeds = span.all_speeds();
                for (speeds, rate) in speeds.iter_mut().zip(rates) {
                    among.into_iter().zip(rate.to_array()).for_each(|(k, rate)| speeds[k] = rounded(speeds[k] + rate));
                }
                span.set_speeds(speeds);
            }
            first = last;
        }
    }
}

/// Rates of values that follow each other after `seconds`: of the parabola through each and its neighbours.
fn rates(values: &[DVec3], seconds: &[f64]) -> Vec<DVec3> {
    let n = seconds.len();
    let mean: Vec<DVec3> = (0..n).map(|k| (values[k + 1] - values[k]) / seconds[k]).collect();
    let inner = |k: usize| (mean[k - 1] * seconds[k] + mean[k] * seconds[k - 1]) / (seconds[k - 1] + seconds[k]);
    let rate = |k: usize| match k {
        _ if n == 1 => mean[0],
        0 => 2.0 * mean[0] - inner(1),
        k if k == n => 2.0 * mean[n - 1] - inner(n - 1),
        k => inner(k),
    };
    (0..=n).map(rate).collect()
}
