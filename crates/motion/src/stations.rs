//! Where along the path the speed law looks at the axes.

use crate::JointPath;
use seamwright_machine::Machine;

/// Places inside a cell, as parts of its length, where limits are imposed besides its two ends.
pub(crate) const INSIDE: [f64; 4] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];

/// The axes' limits are taken this much smaller, to cover what happens between the places where they are imposed.
const MARGIN: f64 = 1e-5;

/// Limits at one place in a cell; each axis' derivatives are divided by its highest acceleration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// Distance from the cell's start, mm.
    pub(crate) offset: f64,
    /// Asked speed, squared, mm^2/s^2.
    pub(crate) asked: f64,
    /// Highest squared speed from the axes' speeds.
    pub(crate) axes: f64,
    /// First and last row in [`Stations::rows`].
    pub(crate) rows: (usize, usize),
}

/// A place where the axes cannot hold the asked speed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slow {
    /// Path length, mm.
    pub(crate) s: f64,
    /// True if it is the end of a cell: the limits before it count.
    pub(crate) cell_end: bool,
    /// Asked speed, mm/s.
    pub(crate) asked: f64,
    /// Speed that the axes could hold, mm/s.
    pub(crate) holds: f64,
}

/// Cells between stations with the limits in them.
pub(crate) struct Stations {
    /// Stations, mm, from 0 to the path's length.
    pub(crate) s: Vec<f64>,
    /// Places of each cell, [`INSIDE`] long each.
    pub(crate) places: Vec<Place>,
    /// Rows (q'/A, q''/A) of the axes.
    pub(crate) rows: Vec<(f64, f64)>,
}

/// Least length of a cell where speed starts from rest or jumps, mm: a run-up within it is not resolved.
const FINEST_MM: f64 = 1e-3;
/// Neighbouring cells grow by this factor away from such places.
const GROWTH: f64 = 1.15;
/// Least number of cells between two panel edges.
const CELLS_A_PANEL: f64 = 12.0;
/// Cells that an even division of the path would have.
const CELLS: f64 = 1000.0;

impl Stations {
    /// Stations along `path`: at panel edges and at `breaks` (ends of spans), fine near rest and breaks.
    pub(crate) fn new(machine: &Machine, path: &JointPath, breaks: &[f64], asked: &dyn Fn(f64) -> f64) -> Self {
        let length = path.length();
        let mut fixed: Vec<f64> = path.edges();
        fixed.extend(breaks.iter().copied().filter(|b| *b > 0.0 && *b < length));
        fixed.sort_by(f64::total_cmp);
        fixed.dedup_by(|a, b| (*a - *b).abs() < 1e-9 * length);
        if let Some(last) = fixed.last_mut() {
            *last = length;
        }
        let mut fine: Vec<f64> = vec![0.0, length];
        fine.extend_from_slice(breaks);
        let widest = length / CELLS;
        let mut s = vec![0.0];
        for w in fixed.windows(2) {
            // Panels follow the features of the path: each gets cells enough to resolve its own.
            divide(&mut s, w[0], w[1], widest.min((w[1] - w[0]) / CELLS_A_PANEL), &fine);
        }
        let mut built = Self { s, places: Vec::new(), rows: Vec::new() };
        for i in 0..built.s.len() - 1 {
            let (a, b) = (built.s[i], built.s[i + 1]);
            for part in INSIDE {
                built.add_place(machine, path, a, b, part, asked);
            }
        }
        built
    }

    fn add_place(
        &mut self,
        machine: &Machine,
        path: &JointPath,
        a: f64,
        b: f64,
        part: f64,
        asked: &dyn Fn(f64) -> f64,
    ) {
        let offset = part * (b - a);
        let at = if part >= 1.0 { b } else { a + offset };
        // At a cell's end the limits of this cell count, not those of the next one.
        let p = path.point(at, part >= 1.0);
        let first = self.rows.len();
        let asked = asked(0.5 * (a + b));
        let mut axes = f64::INFINITY;
        let room = 1.0 - MARGIN;
        for (i, axis) in machine.axes.iter().enumerate() {
            axes = axes.min(room * axis.max_speed / p.d1[i].abs());
            let limit = room * axis.max_acceleration;
            self.rows.push((p.d1[i] / limit, p.d2[i] / limit));
        }
        let rows = (first, self.rows.len());
        self.places.push(Place { offset, asked: asked * asked, axes: axes * axes, rows });
    }

    /// Number of cells.
    pub(crate) fn cells(&self) -> usize {
        self.s.len() - 1
    }

    /// Length of cell `i`, mm.
    pub(crate) fn width(&self, i: usize) -> f64 {
        self.s[i + 1] - self.s[i]
    }

    /// Places of cell `i`.
    pub(crate) fn places(&self, i: usize) -> &[Place] {
        &self.places[i * INSIDE.len()..][..INSIDE.len()]
    }

    /// Highest squared speed at a place that the axes can hold steadily.
    pub(crate) fn steady(&self, place: &Place) -> f64 {
        self.rows(place).iter().map(|r| 1.0 / r.1.abs()).fold(place.axes, f64::min)
    }

    /// Places where the axes cannot hold the asked speed, with their cells: path length, whether it is the end of its
    /// cell, and the speed they could hold, mm/s.
    pub(crate) fn slow(&self) -> Vec<Slow> {
        let places = (0..self.cells()).flat_map(|i| self.places(i).iter().map(move |p| (i, p)));
        // An axis asked for exactly its limit falls short by the margin only: that is no finding.
        let slow = places.filter(|(_, p)| self.steady(p) < p.asked * (1.0 - 2.5 * MARGIN));
        slow.map(|(i, p)| Slow {
            s: self.s[i] + p.offset,
            cell_end: p.offset >= self.width(i),
            asked: p.asked.sqrt(),
            holds: self.steady(p).sqrt(),
        })
        .collect()
    }

    /// The speed (mm/s) that the axes can hold at every place.
    pub(crate) fn everywhere(&self) -> f64 {
        self.places.iter().map(|p| self.steady(p)).fold(f64::INFINITY, f64::min).sqrt()
    }

    /// Tightens the axes' limits in cell `i` and its neighbours by `factor`, more than 1.
    pub(crate) fn tighten(&mut self, i: usize, factor: f64) {
        let cells = i.saturating_sub(1)..(i + 2).min(self.cells());
        let places = cells.start * INSIDE.len()..cells.end * INSIDE.len();
        for place in &mut self.places[places.clone()] {
            place.axes /= factor;
        }
        let rows = self.places[places.start].rows.0..self.places[places.end - 1].rows.1;
        for row in &mut self.rows[rows] {
            *row = (row.0 * factor, row.1 * factor);
        }
    }

    /// Rows of a place.
    pub(crate) fn rows(&self, place: &Place) -> &[(f64, f64)] {
        &self.rows[place.rows.0..place.rows.1]
    }
}

/// Adds stations in (a, b], no wider than `widest` and fine near the places in `fine`.
fn divide(s: &mut Vec<f64>, a: f64, b: f64, widest: f64, fine: &[f64]) {
    let distance = |x: f64| fine.iter().map(|f| (x - f).abs()).fold(f64::INFINITY, f64::min);
    let width = |x: f64| (FINEST_MM + (GROWTH - 1.0) * distance(x)).min(widest);
    let mut x = a;
    loop {
        // Towards a fine place the next cell must be as fine as it will be there.
        let mut step = width(x);
        step = step.min(width(x + step) * GROWTH).max(FINEST_MM.min(widest));
        if x + 1.5 * step >= b {
            s.push(b);
            return;
        }
        x += step;
        s.push(x);
    }
}
