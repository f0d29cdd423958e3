use super::fit::{Fit, Seen, parabola};
use super::outliers::{GATE, STEEPEST};
use super::ring::Ring;
use arrayvec::ArrayVec;
use glam::DVec2;
use std::ops::Range;

/// Cells per look-ahead distance.
pub(super) const CELLS: f64 = 64.0;
/// Stored span in look-ahead distances: one ahead of the torch, the others behind it for reversing.
const LEADS: f64 = 4.0;
/// Number of cells in the ring.
const SLOTS: usize = (LEADS * CELLS) as usize;
/// Number of stored seam jumps.
const BREAKS: usize = 4;
/// Sufficient measurements to each side of a position; with fewer than `FEWEST` the search extends beyond the reach.
const ENOUGH: u32 = 6;
const FEWEST: u32 = 3;
/// Standard deviation of the seam's second derivative against the taught path, 1/mm: where measured, over a gap, and
/// for a line.
pub(super) const BENT: f64 = 0.1;
const BRIDGED: f64 = 0.005;
pub(super) const STRAIGHT: f64 = 1e-4;
/// Maximum number of measurements averaged in a cell, so that the latest count while the torch is held.
const MAX_PER_CELL: u32 = 8;

/// Measured deviations by path length; measurements in the same cell are averaged.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    ring: Ring<Cell>,
    pub(super) cell_mm: f64,
    /// Index of the farthest occupied cell.
    front: Option<i64>,
    breaks: [f64; BREAKS],
    next_break: usize,
}

#[derive(Debug, Clone, Copy)]
struct Cell {
    seen: Seen,
    count: u32,
    t: f64,
}

/// Measurements found to one side of a position.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Side {
    /// Number of cells to use.
    cells: i64,
    count: u32,
    /// The nearest occupied cell lies farther than half the reach.
    gap: bool,
    /// The side ends at a seam jump or at the last measurement.
    ends: bool,
}

/// A local parabola and the kind of data behind it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Local {
    pub(super) fit: Fit,
    /// The position lies in a gap, which is bridged.
    pub(super) bridged: bool,
}

impl Cells {
    pub(super) fn new(lead_mm: f64) -> Self {
        let cell_mm = lead_mm / CELLS;
        let ring = Ring::new(SLOTS);
        Self { ring, cell_mm, front: None, breaks: [f64::NAN; BREAKS], next_break: 0 }
    }

    pub(super) fn len(&self) -> i64 {
        self.ring.len()
    }

    pub(super) fn index(&self, s: f64) -> i64 {
        (s / self.cell_mm).floor() as i64
    }

    /// Path length of the farthest measurement, mm.
    pub(super) fn front(&self) -> Option<f64> {
        self.ring.get(self.front?).map(|c| c.seen.s)
    }

    /// Adds a measurement taken at time `t`. The variance of the old mean in its cell grows by `drift` (mm^2/s) with
    /// its age.
    pub(super) fn add(&mut self, seen: Seen, t: f64, drift: f64) {
        let i = self.index(seen.s);
        let cell = match self.ring.get(i) {
            Some(old) if !self.is_between(old.seen.s, seen.s) => merged(old, seen, t, drift),
            _ => Cell { seen, count: 1, t },
        };
        self.ring.put(i, cell);
        // A cell far behind may overwrite the slot of one far ahead, which is then unknown.
        self.front = Some(self.front.map_or(i, |front| front.max(i).min(i + self.ring.len() - 1)));
        while let Some(front) = self.front.filter(|f| self.ring.get(*f).is_none()) {
            self.front = Some(front - 1);
        }
    }

    /// Removes all measurements and jumps.
    pub(super) fn clear(&mut self) {
        self.ring.clear();
        self.front = None;
        self.breaks = [f64::NAN; BREAKS];
    }

    pub(super) fn clear_from(&mut self, s: f64) {
        let Some(front) = self.front else { return };
        let first = self.index(s);
        (first..=front).for_each(|i| self.ring.remove(i));
        self.front = (first - self.ring.len()..first).rev().find(|i| self.ring.get(*i).is_some());
    }

    /// Records a seam jump at `s`; fits do not smooth across it.
    pub(super) fn add_break(&mut self, s: f64) {
        self.breaks[self.next_break % BREAKS] = s;
        self.next_break += 1;
    }

    fn is_between(&self, a: f64, b: f64) -> bool {
        self.breaks.iter().any(|at| (a < *at) != (b < *at) && at.is_finite())
    }

    /// Searches behind (`sense` -1) or ahead (1) of the start of cell `i`, up to a jump. Stops at enough measurements
    /// within the reach, or at the next ones beyond it.
    fn side(&self, i: i64, sense: i64, reach: i64) -> Side {
        let s = i as f64 * self.cell_mm;
        let (mut least, mut count, mut gap) = (reach / 4, 0, false);
        let front = self.front.unwrap_or(i);
        for k in 0..self.ring.len() {
            let at = if sense > 0 { i + k } else { i - 1 - k };
            if at > front {
                return Side { cells: k, count, gap, ends: true };
            }
            let Some(cell) = self.ring.get(at) else { continue };
            if self.is_between(s, cell.seen.s) {
                return Side { cells: k, count, gap, ends: true };
            }
            if count == 0 && k > reach / 2 {
                // Bridging needs more measurements on the far side of the gap.
                (gap, least) = (true, k + reach);
            }
            count += cell.count;
            if (count >= ENOUGH && k >= least) || (count >= FEWEST && k >= reach.max(least)) {
                return Side { cells: k + 1, count, gap, ends: false };
            }
        }
        Side { cells: self.ring.len(), count, gap, ends: true }
    }

    /// Fits the joint at the start of cell `i`. Returns `None` if no measurement lies ahead yet, or, unless `urgent`,
    /// too few do.
    pub(super) fn local(&self, i: i64, reach: i64, urgent: bool) -> Option<Local> {
        let front = self.front?;
        let [behind, ahead] = [-1, 1].map(|sense| self.side(i, sense, reach));
        if ahead.count == 0 && front < i {
            return None;
        }
        let jumps = ahead.ends && i + ahead.cells <= front;
        if !urgent && !jumps && (front < i + reach || ahead.ends) {
            return None;
        }
        let bridged = behind.gap || ahead.gap;
        // If one side ends early, the other side uses more cells.
        let [back, on] = [(behind, ahead), (ahead, behind)].map(|(side, other)| match other.ends {
            true if side.count < 2 * ENOUGH => side.cells.max(reach),
            _ => side.cells,
        });
        let fit = self.fit(i as f64 * self.cell_mm, i - back..i + on, if bridged { BRIDGED } else { BENT })?;
        Some(Local { fit, bridged })
    }

    /// Fits the parabola at `s` to the measurements in `cells` that no jump separates from `s`.
    pub(super) fn fit(&self, s: f64, cells: Range<i64>, bend: f64) -> Option<Fit> {
        // Collected once, because it is iterated four times.
        let seen = cells.filter_map(|k| self.ring.get(k)).map(|c| c.seen);
        let near: ArrayVec<Seen, SLOTS> = seen.filter(|seen| !self.is_between(s, seen.s)).take(SLOTS).collect();
        let mut hull = Hull::default();
        near.iter().for_each(|p| hull.add(p, s));
        let fit = parabola(s, hull.farthest + self.cell_mm, bend, &near.iter())?;
        Some(Fit { value: hull.clamped(fit.value), slope: fit.slope.clamp_length_max(STEEPEST), ..fit })
    }
}

/// Extremes of the measurements around a position.
#[derive(Debug, Clone, Copy)]
struct Hull {
    low: DVec2,
    high: DVec2,
    nearest: f64,
    farthest: f64,
}

impl Default for Hull {
    fn default() -> Self {
        let (low, high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        Self { low, high, nearest: f64::INFINITY, farthest: 0.0 }
    }
}

impl Hull {
    fn add(&mut self, seen: &Seen, s: f64) {
        let away = (seen.s - s).abs();
        (self.low, self.high) = (self.low.min(seen.value), self.high.max(seen.value));
        (self.nearest, self.farthest) = (self.nearest.min(away), self.farthest.max(away));
    }

    /// Clamps `value` to the measured range, widened by the maximum slope over the distance to the nearest measurement.
    fn clamped(&self, value: DVec2) -> DVec2 {
        let room = DVec2::splat(STEEPEST * self.nearest);
        value.max(self.low - room).min(self.high + room)
    }
}

fn merged(old: &Cell, seen: Seen, t: f64, drift: f64) -> Cell {
    let count = (old.count + 1).min(MAX_PER_CELL);
    let doubt = 1.0 / seen.weight + 1.0 / old.seen.weight;
    if (seen.value - old.seen.value).abs().max_element() > GATE * doubt.sqrt() {
        // The seam has moved since.
        return Cell { seen, count: 1, t };
    }
    // The old mean weighs at most as much as `MAX_PER_CELL - 1` measurements like this one.
    let faded = 1.0 / (1.0 / old.seen.weight + drift * (t - old.t).max(0.0));
    let before = faded.min(seen.weight * f64::from(MAX_PER_CELL - 1));
    let part = seen.weight / (before + seen.weight);
    let mean = Seen {
        s: old.seen.s + part * (seen.s - old.seen.s),
        value: old.seen.value.lerp(seen.value, part),
        weight: before + seen.weight,
    };
    Cell { seen: mean, count, t: t.max(old.t) }
}
