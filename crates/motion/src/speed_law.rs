use crate::stations::{Slow, Stations};
use crate::{JointPath, SpeedReport};
use seamwright_machine::Machine;

/// The speed along a path by path length and by time.
///
/// The squared speed `b = v^2` is piecewise linear over cells between stations, so the acceleration along the path is
/// constant in each cell and time follows in closed form. It is the fastest such law from rest to rest that stays under
/// the asked speed and within every axis' speed and acceleration limits (reachability analysis: Pham and Pham,
/// T-RO 2018, with each cell's limits imposed at both ends and two places inside; solved without an LP solver, because
/// in the plane of squared speed and acceleration each axis is a slab). After the solve the law is checked at more
/// places; where a limit is exceeded, limits there are tightened by that little and the law is solved again.
///
/// Guarantee: at every place checked (nine a cell, 65 where a limit is near) no axis exceeds its speed or acceleration.
/// Weakness: the acceleration jumps between cells; jerk is not limited.
#[derive(Debug, Clone)]
pub struct SpeedLaw {
    cells: Vec<Cell>,
    duration: f64,
    length: f64,
    /// Where the axes cannot hold the asked speed, and the speed they can hold everywhere, mm/s.
    pub(crate) slow: Vec<Slow>,
    pub(crate) everywhere: f64,
}

#[derive(Debug, Clone, Copy)]
struct Cell {
    s: f64,
    t: f64,
    v: f64,
    /// Acceleration along the path, mm/s^2.
    a: f64,
    /// True if the speed at its start is the asked one, or what the axes can hold there.
    full: bool,
}

/// Rounds of tightening limits where they were exceeded.
const ROUNDS: usize = 8;
/// Part of a limit from which on a cell is looked at closely.
const NEAR: f64 = 0.99;

/// The law at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawPoint {
    /// Path length, mm.
    pub s: f64,
    /// Speed along the path, mm/s.
    pub v: f64,
    /// Acceleration along the path, mm/s^2.
    pub a: f64,
}

impl SpeedLaw {
    /// The fastest law up to `asked` (mm/s by path length, constant between `breaks`).
    pub fn new(machine: &Machine, path: &JointPath, breaks: &[f64], asked: &dyn Fn(f64) -> f64) -> Self {
        let mut stations = Stations::new(machine, path, breaks, asked);
        let mut b = forward(&stations, &backward(&stations));
        for _ in 0..ROUNDS {
            let excess: Vec<f64> =
                (0..stations.cells()).map(|i| cell_excess(machine, path, &stations, &b, i)).collect();
            if excess.iter().all(|e| *e <= 1.0) {
                return Self::timed(&stations, &b);
            }
            for (i, e) in excess.iter().enumerate().filter(|(_, e)| **e > 1.0) {
                stations.tighten(i, 1.0 + 1.5 * (e - 1.0));
            }
            b = forward(&stations, &backward(&stations));
        }
        // What is left is taken off the whole law: slowing it never violates symmetric limits.
        let excess = (0..stations.cells()).map(|i| cell_excess(machine, path, &stations, &b, i)).fold(1.0, f64::max);
        b.iter_mut().for_each(|v| *v /= excess);
        Self::timed(&stations, &b)
    }

    fn timed(stations: &Stations, b: &[f64]) -> Self {
        let mut cells = Vec::with_capacity(b.len());
        let mut t = 0.0;
        for i in 0..stations.cells() {
            let (v, v1, h) = (b[i].sqrt(), b[i + 1].sqrt(), stations.width(i));
            let place = &stations.places(i)[0];
            let full = b[i] >= (1.0 - 1e-6) * place.asked.min(stations.steady(place));
            cells.push(Cell { s: stations.s[i], t, v, a: (b[i + 1] - b[i]) / (2.0 * h), full });
            t += 2.0 * h / (v + v1);
        }
        let length = stations.s[stations.cells()];
        Self { cells, duration: t, length, slow: stations.slow(), everywhere: stations.everywhere() }
    }

    /// Time from rest to rest, s.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The law at time `t` (s); `cursor` remembers the cell, so that a rising `t` costs no search.
    pub fn at(&self, t: f64, cursor: &mut usize) -> LawPoint {
        if t >= self.duration {
            return LawPoint { s: self.length, v: 0.0, a: 0.0 };
        }
        let t = t.max(0.0);
        if self.cells.get(*cursor).is_none_or(|c| c.t > t) {
            *cursor = self.cells.partition_point(|c| c.t <= t).saturating_sub(1);
        }
        while self.cells.get(*cursor + 1).is_some_and(|c| c.t <= t) {
            *cursor += 1;
        }
        let c = &self.cells[*cursor];
        let d = t - c.t;
        LawPoint { s: (c.s + d * (c.v + 0.5 * c.a * d)).min(self.length), v: (c.v + c.a * d).max(0.0), a: c.a }
    }

    /// Speed at path length `s`, mm/s.
    pub fn speed(&self, s: f64) -> f64 {
        let i = self.cells.partition_point(|c| c.s <= s).saturating_sub(1);
        let c = &self.cells[i];
        (c.v * c.v + 2.0 * c.a * (s - c.s)).max(0.0).sqrt()
    }

    /// Time at which path length `s` is reached, s.
    pub fn time(&self, s: f64) -> f64 {
        let i = self.cells.partition_point(|c| c.s <= s).saturating_sub(1);
        let c = &self.cells[i];
        let v = self.speed(s);
        if s >= self.length { self.duration } else { c.t + if s > c.s { 2.0 * (s - c.s) / (c.v + v) } else { 0.0 } }
    }

    /// The band of the planned speed between run-up and run-down.
    pub fn report(&self) -> SpeedReport {
        let rising = self.cells.iter().take_while(|c| c.a > 0.0 && !c.full).count();
        let falling = self.cells.iter().rev().take_while(|c| c.a < 0.0 && !c.full).count();
        // The cell that begins at full speed and falls from there is the first of the run-down.
        let begins = self.cells.iter().rev().nth(falling).is_some_and(|c| c.a < 0.0);
        let falling = falling + usize::from(begins);
        let first = rising.min(self.cells.len() - 1);
        let last = self.cells.len() - falling;
        let start_of = |i: usize| self.cells.get(i).map_or(self.length, |c| c.s);
        let speeds = || self.cells[first..].iter().take((last + 1).saturating_sub(first).max(1)).map(|c| c.v);
        SpeedReport {
            run_up_end: start_of(first),
            run_down_start: start_of(last).max(start_of(first)),
            least: speeds().fold(f64::INFINITY, f64::min),
            greatest: speeds().fold(0.0, f64::max),
        }
    }
}

/// A line `value = at0 + slope * x` that bounds the acceleration u from one side, with x the squared speed.
#[derive(Clone, Copy)]
struct Bounding {
    at0: f64,
    slope: f64,
}

impl Bounding {
    fn at(self, x: f64) -> f64 {
        self.at0 + self.slope * x
    }
}

/// The tightest upper and lower bound on u at squared speed `x` in cell `i`, given the next station's reach.
fn bounds(stations: &Stations, i: usize, next: f64, x: f64) -> (Bounding, Bounding) {
    let h = stations.width(i);
    // Arrive between standing and what the rest of the path can take over.
    let mut upper = Bounding { at0: next / (2.0 * h), slope: -1.0 / (2.0 * h) };
    let mut lower = Bounding { at0: 0.0, slope: -1.0 / (2.0 * h) };
    let mut tighten = |line: Bounding, is_upper: bool| {
        let side = if is_upper { &mut upper } else { &mut lower };
        if (line.at(x) < side.at(x)) == is_upper {
            *side = line;
        }
    };
    for place in stations.places(i) {
        if place.offset > 0.0 {
            tighten(
                Bounding {
                    at0: place.asked.min(place.axes) / (2.0 * place.offset),
                    slope: -1.0 / (2.0 * place.offset),
                },
                true,
            );
        }
        for &(d1, d2) in stations.rows(place) {
            // |q'' (x + 2 u offset) + q' u| <= A, divided by A.
            let u = d1 + 2.0 * place.offset * d2;
            if u.abs() > 1e-12 * d2.abs().max(1e-12) {
                let (limit, slope) = (1.0 / u.abs(), -d2 / u);
                tighten(Bounding { at0: limit, slope }, true);
                tighten(Bounding { at0: -limit, slope }, false);
            }
        }
    }
    (upper, lower)
}

/// Highest squared speed at the start of cell `i` that the axes' speeds, the asked speed and centripetal accelerations
/// allow.
fn cap(stations: &Stations, i: usize) -> f64 {
    let place = &stations.places(i)[0];
    let steady = stations.rows(place).iter().filter(|r| r.0.abs() < 1e-12).map(|r| 1.0 / r.1.abs());
    steady.fold(place.asked.min(place.axes), f64::min)
}

/// Backward pass: the highest squared speed at each station from which the path can be finished.
fn backward(stations: &Stations) -> Vec<f64> {
    let n = stations.cells();
    let mut reach = vec![0.0; n + 1];
    for i in (0..n).rev() {
        let mut x = cap(stations, i);
        // The cell before must also end under its own cap.
        if i > 0 {
            let before = stations.places(i - 1);
            let end = &before[before.len() - 1];
            x = x.min(end.asked.min(end.axes));
        }
        // Upper less lower bound is concave in x: Newton descends to its zero without passing it.
        for _ in 0..50 {
            let (upper, lower) = bounds(stations, i, reach[i + 1], x);
            let gap = upper.at(x) - lower.at(x);
            if gap >= 0.0 {
                break;
            }
            let closing = lower.slope - upper.slope;
            if closing <= 0.0 {
                x = 0.0;
                break;
            }
            x = (x + gap / closing).max(0.0);
        }
        reach[i] = x;
    }
    reach
}

/// Forward pass: from rest, the highest acceleration in each cell.
fn forward(stations: &Stations, reach: &[f64]) -> Vec<f64> {
    let n = stations.cells();
    let mut b = vec![0.0; n + 1];
    for i in 0..n {
        let x = b[i];
        let (upper, lower) = bounds(stations, i, reach[i + 1], x);
        let u = upper.at(x).max(lower.at(x));
        b[i + 1] = (x + 2.0 * stations.width(i) * u).clamp(0.0, reach[i + 1]);
    }
    b
}

/// The largest factor by which squared speed or acceleration exceeds a limit within cell `i`, or comes near it: nine
/// places, and 65 if one of them is near a limit.
fn cell_excess(machine: &Machine, path: &JointPath, stations: &Stations, b: &[f64], i: usize) -> f64 {
    let h = stations.width(i);
    let u = (b[i + 1] - b[i]) / (2.0 * h);
    let worst_of = |parts: u32| {
        let at = |k: u32| {
            let d = h * f64::from(k) / f64::from(parts);
            let p = path.point(stations.s[i] + d, k == parts);
            let x = b[i] + 2.0 * u * d;
            let ratios = machine.axes.iter().enumerate().map(|(j, axis)| {
                let speed = p.d1[j] * p.d1[j] * x / (axis.max_speed * axis.max_speed);
                let acceleration = (p.d2[j] * x + p.d1[j] * u).abs() / axis.max_acceleration;
                speed.max(acceleration)
            });
            ratios.fold(0.0, f64::max)
        };
        (0..=parts).map(at).fold(0.0, f64::max)
    };
    let coarse = worst_of(8);
    if coarse < NEAR { coarse } else { worst_of(64) }
}
