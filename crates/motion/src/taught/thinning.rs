use glam::DVec3;
use seamwright_machine::{Joints, MAX_AXES};

/// Positions of all axes and of the tip in the work frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Taught {
    pub(crate) q: Joints,
    pub(crate) tip: DVec3,
}

/// A kept point, and the points omitted since the previous kept one.
#[derive(Debug, Clone)]
pub(crate) struct Kept {
    pub(crate) point: Taught,
    pub(crate) left_out: Vec<Taught>,
}

/// Maximum distance of a path from the points that it omits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tolerance {
    /// Of the tip, mm.
    pub(crate) tip: f64,
    /// Of each axis, mm or rad.
    pub(crate) axes: Joints,
}

/// Maximum distance of equal points, of their tips (mm) and of their axes (mm or rad).
pub(crate) const SAME: f64 = 1e-6;

/// Maximum number of consecutive omitted points.
const MAX_OMITTED: usize = 64;
/// Maximum ratio of a distance between kept points to the next one; above it omitted points are put back.
const SHRINK: f64 = 2.5;

/// Omits points within a tolerance of the straight line between kept ones, in axis space and at the tip. Distances of
/// kept points change gradually, since a spline swings if a long piece meets a short one.
pub(crate) struct Thinned<I> {
    points: I,
    /// Maximum distance of an omitted point from the line.
    tolerance: Tolerance,
    /// The last kept point, and the points since.
    kept: Option<Taught>,
    run: Vec<Taught>,
    ready: std::collections::VecDeque<Kept>,
    /// Points omitted between the last two kept ones, and the first of the two.
    before: Option<(Taught, Vec<Taught>)>,
    ended: bool,
}

impl<I> Thinned<I> {
    pub(crate) fn new(points: I, tolerance: Tolerance) -> Self {
        Self {
            points,
            tolerance,
            kept: None,
            run: Vec::with_capacity(MAX_OMITTED),
            ready: std::collections::VecDeque::new(),
            before: None,
            ended: false,
        }
    }

    /// True if every point since the last kept one is near the line from there to `to`.
    fn is_straight(&self, from: &Taught, to: &Taught) -> bool {
        let chord = to.tip - from.tip;
        let square = chord.length_squared();
        // The fraction along it follows from the tip, or from the axis that moves most if the tip rests.
        let lead = (0..MAX_AXES).fold(0, |a, b| if moved(from, to, b) > moved(from, to, a) { b } else { a });
        self.run.iter().all(|p| {
            let part = if square > SAME * SAME {
                (p.tip - from.tip).dot(chord) / square
            } else {
                (p.q[lead] - from.q[lead]) / (to.q[lead] - from.q[lead])
            };
            let off = (from.tip + part * chord).distance(p.tip);
            let axes = (0..MAX_AXES).all(|i| {
                let line = from.q[i] + part * (to.q[i] - from.q[i]);
                (line - p.q[i]).abs() <= self.tolerance.axes[i]
            });
            (0.0..=1.0).contains(&part) && off <= self.tolerance.tip && axes
        })
    }

    /// Keeps `point`; if its distance is much shorter than the previous one, omitted points are put back.
    fn keep(&mut self, point: Taught, left_out: Vec<Taught>) {
        let Some(last) = self.kept.replace(point) else { return };
        let mut since = Vec::new();
        if let Some((first, skipped)) = self.before.take() {
            let mut reach = SHRINK * apart(&last, &point).max(SAME);
            let mut back = vec![false; skipped.len()];
            let mut beside = last;
            for (p, back) in skipped.iter().zip(&mut back).rev() {
                if apart(&beside, p) >= reach && apart(p, &first) > 0.5 * reach {
                    *back = true;
                    (beside, reach) = (*p, SHRINK * apart(&beside, p));
                }
            }
            for (point, back) in skipped.into_iter().zip(back) {
                if back {
                    self.ready.push_back(Kept { point, left_out: std::mem::take(&mut since) });
                } else {
                    since.push(point);
                }
            }
        }
        self.ready.push_back(Kept { point: last, left_out: since });
        self.before = Some((last, left_out));
    }
}

fn moved(a: &Taught, b: &Taught, axis: usize) -> f64 {
    (a.q[axis] - b.q[axis]).abs()
}

/// Distance of two points: the maximum move of the tip and the axes.
fn apart(a: &Taught, b: &Taught) -> f64 {
    (0..MAX_AXES).map(|i| moved(a, b, i)).fold(a.tip.distance(b.tip), f64::max)
}

impl<I: Iterator<Item = Taught>> Iterator for Thinned<I> {
    type Item = Kept;

    fn next(&mut self) -> Option<Kept> {
        loop {
            if let Some(ready) = self.ready.pop_front() {
                return Some(ready);
            }
            if self.ended {
                let left_out = self.before.take().map(|(_, left_out)| left_out).unwrap_or_default();
                return self.kept.take().map(|point| Kept { point, left_out });
            }
            let Some(point) = self.points.next() else {
                self.ended = true;
                if let Some(last) = self.run.pop() {
                    let left_out = std::mem::take(&mut self.run);
                    self.keep(last, left_out);
                }
                continue;
            };
            let Some(kept) = self.kept else {
                self.kept = Some(point);
                continue;
            };
            if apart(self.run.last().unwrap_or(&kept), &point) <= SAME {
                continue;
            }
            if (self.run.len() >= MAX_OMITTED || !self.is_straight(&kept, &point))
                && let Some(last) = self.run.pop()
            {
                let left_out = std::mem::take(&mut self.run);
                self.keep(last, left_out);
            }
            self.run.push(point);
        }
    }
}
