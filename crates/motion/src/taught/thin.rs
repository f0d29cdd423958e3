use glam::DVec3;
use seamwright_machine::{Joints, MAX_AXES};

/// Positions of all axes and of the tip in the work frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Taught {
    pub(crate) q: Joints,
    pub(crate) tip: DVec3,
}

/// A point that is kept, and those left out since the one kept before.
#[derive(Debug, Clone)]
pub(crate) struct Kept {
    pub(crate) point: Taught,
    pub(crate) left_out: Vec<Taught>,
}

/// Points whose tips are nearer than this (mm) and whose axes too (mm or rad) are the same point: the length that
/// counts as nothing in all rooms.
pub(crate) const SAME: f64 = 1e-6;

/// Most points left out one after the other.
const MOST: usize = 64;
/// A distance between kept points may be this many times the next one; else points left out come back.
const SHRINK: f64 = 2.5;

/// Leaves out points that the straight line between those kept passes within a tolerance, in axis space and at the tip,
/// and lets the distances of those kept change gradually: a spline through them swings where a long piece meets a short
/// one.
pub(crate) struct Thinned<I> {
    points: I,
    /// How far (mm for the tip and linear axes, rad for rotary ones) a point left out may be from the line.
    tolerance: (f64, Joints),
    /// The last point kept, and those since.
    kept: Option<Taught>,
    run: Vec<Taught>,
    /// Points to be given, in order.
    ready: std::collections::VecDeque<Kept>,
    /// Points left out between the last two kept, and the first of the two.
    before: Option<(Taught, Vec<Taught>)>,
    ended: bool,
}

impl<I> Thinned<I> {
    pub(crate) fn new(points: I, tolerance: (f64, Joints)) -> Self {
        Self {
            points,
            tolerance,
            kept: None,
            run: Vec::with_capacity(MOST),
            ready: std::collections::VecDeque::new(),
            before: None,
            ended: false,
        }
    }

    /// Whether every point since the last one kept is near the line from there to `to`.
    fn is_straight(&self, from: &Taught, to: &Taught) -> bool {
        let chord = to.tip - from.tip;
        let square = chord.length_squared();
        // How far along it: by the tip, or by the axis that moves most if the tip stands still.
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
                (line - p.q[i]).abs() <= self.tolerance.1[i]
            });
            (0.0..=1.0).contains(&part) && off <= self.tolerance.0 && axes
        })
    }

    /// Keeps `point`; where the way to it is much shorter than the one before, points left out before come back.
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

/// How far two points are apart: the way of the tip or of the axis that moves most.
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
            if (self.run.len() >= MOST || !self.is_straight(&kept, &point))
                && let Some(last) = self.run.pop()
            {
                let left_out = std::mem::take(&mut self.run);
                self.keep(last, left_out);
            }
            self.run.push(point);
        }
    }
}
