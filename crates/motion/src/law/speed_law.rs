use super::cells::Cells;
use super::channels::{Channels, Limits};
use super::grid::stations;
use super::jerk_limited::plan;
use super::rest::RestToRest;

/// The law at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LawPoint {
    /// The path's parameter: path length, mm, where the tip moves.
    pub s: f64,
    /// Its speed, 1/s.
    pub v: f64,
    /// Its acceleration, 1/s^2.
    pub a: f64,
    /// Its jerk, 1/s^3.
    pub j: f64,
}

/// The speed along a path by its parameter and by time, from rest to rest.
#[derive(Debug, Clone)]
pub struct SpeedLaw {
    pieces: Vec<RestToRest>,
    cells: Vec<Cell>,
    duration: f64,
    end: f64,
}

/// A cell of the law: `d2 tau / dt2 = a + w tau` from its start on.
#[derive(Debug, Clone, Copy)]
struct Cell {
    piece: u32,
    tau: f64,
    t: f64,
    v: f64,
    a: f64,
    w: f64,
}

impl SpeedLaw {
    /// The fastest law along `path`.
    pub fn new(path: &dyn Channels) -> Self {
        let (from, to) = path.range();
        let mut ends = vec![from];
        ends.extend(path.stops().into_iter().filter(|u| *u > from && *u < to));
        ends.push(to);
        let mut law = Self { pieces: Vec::new(), cells: Vec::new(), duration: 0.0, end: to };
        for w in ends.windows(2) {
            law.add(path, (w[0], w[1]));
        }
        law
    }

    fn add(&mut self, path: &dyn Channels, piece: (f64, f64)) {
        let limits: Vec<Limits> = path.limits().to_vec();
        let (map, tau) = stations(path, &limits, piece, 60.0);
        let (cells, c) = plan(path, map, tau, &limits);
        self.append(&cells, &c);
    }

    fn append(&mut self, cells: &Cells, c: &[f64]) {
        let piece = self.pieces.len() as u32;
        self.pieces.push(cells.map);
        for i in 0..cells.count() {
            let w = cells.weights(i);
            let dot = |w: &[f64; 3]| w[0] * c[i] + w[1] * c[i + 1] + w[2] * c[i + 2];
            let (b, d, e, h) = (dot(&w.value), dot(&w.first), dot(&w.second), cells.width(i));
            let cell = Cell { piece, tau: cells.tau[i], t: self.duration, v: b.sqrt(), a: 0.5 * d, w: 0.5 * e };
            let end = (b + h * (d + 0.5 * h * e)).max(0.0).sqrt();
            self.duration += crossing(cell.w, h / (cell.v + end));
            self.cells.push(cell);
        }
    }

    /// Time from rest to rest, s.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The law at time `t` (s); `cursor` remembers the cell, so that a rising `t` costs no search.
    pub fn at(&self, t: f64, cursor: &mut usize) -> LawPoint {
        if t >= self.duration {
            return LawPoint { s: self.end, ..LawPoint::default() };
        }
        let t = t.max(0.0);
        if self.cells.get(*cursor).is_none_or(|c| c.t > t) {
            *cursor = self.cells.partition_point(|c| c.t <= t).saturating_sub(1);
        }
        while self.cells.get(*cursor + 1).is_some_and(|c| c.t <= t) {
            *cursor += 1;
        }
        let c = &self.cells[*cursor];
        let (travelled, v) = c.after(t - c.t);
        let (a, j) = (c.a + c.w * travelled, c.w * v);
        let [u, m1, m2, m3] = self.pieces[c.piece as usize].at(c.tau + travelled, false);
        LawPoint { s: u, v: m1 * v, a: m2 * v * v + m1 * a, j: m3 * v * v * v + 3.0 * m2 * v * a + m1 * j }
    }
}

impl Cell {
    /// How far it has gone `t` after its start, and how fast it is then.
    fn after(&self, t: f64) -> (f64, f64) {
        let x = self.w * t * t;
        // sinh(sqrt(x)) / sqrt(x) and (cosh(sqrt(x)) - 1) / x, for either sign of x.
        let (s, c) = if x.abs() < 1e-2 {
            let s = 1.0 + x / 6.0 * (1.0 + x / 20.0 * (1.0 + x / 42.0 * (1.0 + x / 72.0)));
            (s, 0.5 + x / 24.0 * (1.0 + x / 30.0 * (1.0 + x / 56.0 * (1.0 + x / 90.0))))
        } else if x > 0.0 {
            let r = x.sqrt();
            (r.sinh() / r, (r.cosh() - 1.0) / x)
        } else {
            let r = (-x).sqrt();
            (r.sin() / r, (r.cos() - 1.0) / x)
        };
        (t * (self.v * s + self.a * t * c), self.v * (1.0 + x * c) + self.a * t * s)
    }
}

/// Time over a cell whose width is `mean` times the sum of the speeds at its ends, where the acceleration grows by `w` a
/// unit of way: both ways of moving, `sinh` and `cosh` about its middle, cover `tanh(sqrt(w) t / 2) / sqrt(w)` a unit of
/// that sum.
fn crossing(w: f64, mean: f64) -> f64 {
    let x = w * mean * mean;
    if x.abs() < 1e-4 {
        // atanh(y) / y with y^2 = x.
        2.0 * mean * (1.0 + x * (1.0 / 3.0 + x * (0.2 + x / 7.0)))
    } else if x > 0.0 {
        2.0 * x.sqrt().atanh() / w.sqrt()
    } else {
        2.0 * (-x).sqrt().atan() / (-w).sqrt()
    }
}
