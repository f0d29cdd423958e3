use super::Row;
use super::block::{Block, Shape};
use seamwright_geometry::CubicSpline;

/// A block before its position on the path is known.
pub(super) struct Timed {
    pub(super) block: Block,
    /// Duration, s.
    pub(super) seconds: f64,
    /// Index of the point it ends at.
    pub(super) point: usize,
}

pub(super) struct Knots {
    pub(super) rows: Vec<Row>,
    /// Their numbers among the span's points, 0 at its start.
    pub(super) points: Vec<usize>,
    /// Time at each, s.
    pub(super) at: Vec<f64>,
    /// Duration, s, and length, mm, of the chords from each knot to the next.
    pub(super) chords: Vec<(f64, f64)>,
    /// The torch stops at each.
    pub(super) stops: bool,
}

impl Knots {
    /// The natural spline by time, in pieces.
    pub(super) fn pieces(&self) -> Vec<Timed> {
        let Self { rows, at, stops, .. } = self;
        let slopes = self.slopes();
        let piece = |k: usize| {
            let seconds = at[k + 1] - at[k];
            let cubic = [slopes[k], slopes[k + 1]].map(|row| row.map(|slope| slope * seconds));
            let shape = Shape::Cubic(Box::new(cubic));
            let (from, to, is_continued) = (0.0, 0.0, k > 0 && !stops);
            let block = Block { from, to, start: rows[k], end: rows[k + 1], shape, stops: *stops, is_continued };
            Timed { block, seconds, point: self.points[k + 1] }
        };
        (0..rows.len() - 1).map(piece).collect()
    }

    /// Times each piece by its length, `ways` in mm, at the speed of its chords. Returns the maximum change, as a part.
    pub(super) fn retime(&mut self, ways: &[f64]) -> f64 {
        let (mut now, mut change) = (0.0, 0.0f64);
        for (k, ((seconds, chord), way)) in self.chords.iter().zip(ways).enumerate() {
            let new = if *chord > 0.0 { seconds * way / chord } else { *seconds };
            let old = self.at[k + 1] - now;
            now = self.at[k + 1];
            self.at[k + 1] = self.at[k] + new;
            change = change.max((new - old).abs() / old);
        }
        change
    }

    /// Slopes by time.
    fn slopes(&self) -> Vec<Row> {
        let column = |k: usize| {
            let points: Vec<(f64, f64)> = self.at.iter().zip(&self.rows).map(|(at, row)| (*at, row[k])).collect();
            CubicSpline::natural(&points).ok()
        };
        let columns: Vec<Option<CubicSpline>> = (0..Row::default().len()).map(column).collect();
        let slope = |at: f64, k: usize| columns[k].as_ref().map_or(0.0, |spline| spline.at(at).1);
        self.at.iter().map(|at| std::array::from_fn(|k| slope(*at, k))).collect()
    }
}
