use super::reduction::Tolerances;
use glam::DVec3;
use std::cell::Cell;

/// Permitted deviation of the further columns, in units of their tolerance: grows from `at_start` by `growth` over a
/// run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Allowance {
    pub(super) at_start: f64,
    pub(super) growth: f64,
}

/// The points to reduce with their further columns, and the tolerances of a span.
pub(super) struct Track<'a> {
    pub(super) points: &'a [DVec3],
    pub(super) axes: &'a [Vec<f64>],
    /// Maximum distance of a point from its span, mm.
    pub(super) near: f64,
    /// Maximum deviation of a further column from its linear course.
    pub(super) axis_near: f64,
    /// Squared distance of each point to the next.
    chords: Vec<f64>,
    /// Path length up to each point, if there are further columns.
    lengths: Vec<f64>,
    /// Number of points checked so far: the measure of effort.
    work: Cell<u64>,
}

impl<'a> Track<'a> {
    pub(super) fn new(points: &'a [DVec3], axes: &'a [Vec<f64>], tolerances: Tolerances) -> Self {
        let Tolerances { path_mm: near, columns: axis_near } = tolerances;
        let chords: Vec<f64> = points.windows(2).map(|w| w[0].distance_squared(w[1])).collect();
        let mut lengths = Vec::new();
        if !axes.is_empty() {
            let mut sum = 0.0;
            lengths.push(sum);
            lengths.extend(chords.iter().map(|c| {
                sum += c.sqrt();
                sum
            }));
        }
        Self { points, axes, near, axis_near, chords, lengths, work: Cell::new(0) }
    }

    /// Index of the last point.
    pub(super) fn end(&self) -> usize {
        self.points.len() - 1
    }

    /// Squared length of the chord from point `k` to the next.
    pub(super) fn chord(&self, k: usize) -> f64 {
        self.chords[k]
    }

    /// Sample position by number: 2k is point k, 2k + 1 the middle between points k and k + 1.
    pub(super) fn place(&self, number: usize) -> DVec3 {
        let point = self.points[number / 2];
        if number.is_multiple_of(2) { point } else { point.midpoint(self.points[number / 2 + 1]) }
    }

    pub(super) fn add_work(&self, points: usize) {
        self.work.set(self.work.get() + points as u64);
    }

    pub(super) fn work(&self) -> u64 {
        self.work.get()
    }

    /// Fraction of the way from `first` to `last` before `k`, by path length along the points; by their number if all
    /// coincide.
    fn part(&self, first: usize, last: usize, k: usize) -> f64 {
        let whole = self.lengths[last] - self.lengths[first];
        if whole > 0.0 {
            (self.lengths[k] - self.lengths[first]) / whole
        } else {
            (k - first) as f64 / (last - first) as f64
        }
    }

    /// Maximum deviation of the further columns at `k` from the linear course between `first` and `last`, at its
    /// fraction `part`.
    pub(super) fn axis_error(&self, first: usize, last: usize, k: usize, part: f64) -> f64 {
        let error = |column: &Vec<f64>| (column[k] - (column[first] + part * (column[last] - column[first]))).abs();
        self.axes.iter().map(error).fold(0.0, f64::max)
    }

    /// Whether the further columns stay within the allowance of their linear course; `seen` is a point to try first,
    /// and on return the worst violation.
    pub(super) fn axes_hold(&self, first: usize, last: usize, allowance: Allowance, seen: &mut Option<usize>) -> bool {
        if self.axes.is_empty() {
            return true;
        }
        let over = |k: usize| {
            let part = self.part(first, last, k);
            self.axis_error(first, last, k, part)
                - self.axis_near * (allowance.at_start + allowance.growth * part) * (1.0 + 1e-12)
        };
        if seen.is_some_and(|k| first < k && k < last && over(k) > 0.0) {
            return false;
        }
        self.add_work(last - first);
        let mut worst = 0.0;
        for k in first + 1..last {
            let over = over(k);
            if over > worst {
                (worst, *seen) = (over, Some(k));
            }
        }
        worst <= 0.0
    }
}
