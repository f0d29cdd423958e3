use super::fit::{Fit, Seen, parabola};
use super::ring::Ring;
use super::suspects::{GATE, STEEPEST};
use arrayvec::ArrayVec;
use glam::DVec2;
use std::ops::Range;

/// Cells to a lead.
pub(super) const CELLS: f64 = 64.0;
/// Leads that are remembered: one ahead of the torch, the others behind it, to go back over.
const LEADS: f64 = 4.0;
/// Cells that there is room for.
const SLOTS: usize = (LEADS * CELLS) as usize;
/// Jumps of the seam that are remembered.
const BREAKS: usize = 4;
/// Measurements to each side that are enough for a place, and fewest without which it is looked for further away.
const ENOUGH: u32 = 6;
const FEWEST: u32 = 3;
/// Second derivative of a seam against the taught path, one standard deviation, 1/mm: where it was seen, over a gap,
/// and that of a line.
pub(super) const BENT: f64 = 0.1;
const BRIDGED: f64 = 0.005;
pub(super) const STRAIGHT: f64 = 1e-4;
/// As many measurements as a cell counts at most: where the torch is held, the latest count.
const MOST: u32 = 8;

/// What was seen, by path length: what falls into the same cell is averaged.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    ring: Ring<Cell>,
    pub(super) cell_mm: f64,
    /// Number of the farthest cell with anything in it.
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

/// What lies to one side of a place.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Side {
    /// Cells to look into.
    cells: i64,
    count: u32,
    /// The first one with anything in it lies further than it should.
    gap: bool,
    /// The seam jumps there, or nothing was seen beyond.
    ends: bool,
}

/// A local parabola, and what there was for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Local {
    pub(super) fit: Fit,
    /// Nothing was seen near the place: it is bridged.
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

    /// The farthest place that was seen, mm.
    pub(super) fn front(&self) -> Option<f64> {
        self.ring.get(self.front?).map(|c| c.seen.s)
    }

    /// Adds a measurement taken at `t`; what was in its cell before counts less by `drift` (mm^2/s) since.
    pub(super) fn add(&mut self, seen: Seen, t: f64, drift: f64) {
        let i = self.index(seen.s);
        let cell = match self.ring.get(i) {
            Some(old) if !self.is_between(old.seen.s, seen.s) => merged(old, seen, t, drift),
            _ => Cell { seen, count: 1, t },
        };
        self.ring.put(i, cell);
        // A cell far behind takes the slot of one far ahead: then that is not known any more.
        self.front = Some(self.front.map_or(i, |front| front.max(i).min(i + self.ring.len() - 1)));
        while let Some(front) = self.front.filter(|f| self.ring.get(*f).is_none()) {
            self.front = Some(front - 1);
        }
    }

    /// Forgets everything.
    pub(super) fn clear(&mut self) {
        self.ring.clear();
        self.front = None;
        self.breaks = [f64::NAN; BREAKS];
    }

    /// Forgets what was seen from `s` on.
    pub(super) fn clear_from(&mut self, s: f64) {
        let Some(front) = self.front else { return };
        let first = self.index(s);
        (first..=front).for_each(|i| self.ring.remove(i));
        self.front = (first - self.ring.len()..first).rev().find(|i| self.ring.get(*i).is_some());
    }

    /// The seam jumps at `s`: nothing is smoothed across.
    pub(super) fn add_break(&mut self, s: f64) {
        self.breaks[self.next_break % BREAKS] = s;
        self.next_break += 1;
    }

    fn is_between(&self, a: f64, b: f64) -> bool {
        self.breaks.iter().any(|at| (a < *at) != (b < *at) && at.is_finite())
    }

    /// What lies behind (-1) or ahead (1) of the beginning of cell `i`, without crossing a jump: enough of it within
    /// the usual reach, or the next that there is.
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
                // The other side of a gap must be known well to see across.
                (gap, least) = (true, k + reach);
            }
            count += cell.count;
            if (count >= ENOUGH && k >= least) || (count >= FEWEST && k >= reach.max(least)) {
                return Side { cells: k + 1, count, gap, ends: false };
            }
        }
        Side { cells: self.ring.len(), count, gap, ends: true }
    }

    /// The joint at the beginning of cell `i`. None if nothing is known ahead of it yet, or, unless it is `urgent`, too
    /// little.
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
        // Of a side that ends early the other makes up for what it lacks.
        let [back, on] = [(behind, ahead), (ahead, behind)].map(|(side, other)| match other.ends {
            true if side.count < 2 * ENOUGH => side.cells.max(reach),
            _ => side.cells,
        });
        let fit = self.fit(i as f64 * self.cell_mm, i - back..i + on, if bridged { BRIDGED } else { BENT })?;
        Some(Local { fit, bridged })
    }

    /// The parabola at `s` through what lies in these cells, on the same side of every jump.
    pub(super) fn fit(&self, s: f64, cells: Range<i64>, bend: f64) -> Option<Fit> {
        // Gathered once: it is gone through four times.
        let seen = cells.filter_map(|k| self.ring.get(k)).map(|c| c.seen);
        let near: ArrayVec<Seen, SLOTS> = seen.filter(|seen| !self.is_between(s, seen.s)).take(SLOTS).collect();
        let mut hull = Hull::default();
        near.iter().for_each(|p| hull.add(p, s));
        let fit = parabola(s, hull.farthest + self.cell_mm, bend, &near.iter())?;
        Some(Fit { value: hull.clamped(fit.value), slope: fit.slope.clamp_length_max(STEEPEST), ..fit })
    }
}

/// What was seen around a place, by its extremes.
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

    /// No seam is steeper than it can be from the nearest place where it was seen.
    fn clamped(&self, value: DVec2) -> DVec2 {
        let room = DVec2::splat(STEEPEST * self.nearest);
        value.max(self.low - room).min(self.high + room)
    }
}

fn merged(old: &Cell, seen: Seen, t: f64, drift: f64) -> Cell {
    let count = (old.count + 1).min(MOST);
    let doubt = 1.0 / seen.weight + 1.0 / old.seen.weight;
    if (seen.value - old.seen.value).abs().max_element() > GATE * doubt.sqrt() {
        // The seam has moved since.
        return Cell { seen, count: 1, t };
    }
    // No more weight than that of as many measurements as are counted.
    let faded = 1.0 / (1.0 / old.seen.weight + drift * (t - old.t).max(0.0));
    let before = faded.min(seen.weight * f64::from(MOST - 1));
    let part = seen.weight / (before + seen.weight);
    let mean = Seen {
        s: old.seen.s + part * (seen.s - old.seen.s),
        value: old.seen.value.lerp(seen.value, part),
        weight: before + seen.weight,
    };
    Cell { seen: mean, count, t: t.max(old.t) }
}
