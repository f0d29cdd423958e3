//! The fastest law under limits of speed and acceleration alone, by reachability (Pham and Pham, T-RO 2018).

use super::cells::broken;
use super::channels::Channels;
use super::error::LawError;

/// Places in each cell where limits are imposed, as parts of its width.
const PLACES: [f64; 3] = [0.0, 0.5, 1.0];
/// Part of each limit kept in reserve for what lies between those places.
const RESERVE: f64 = 1e-4;
/// What may be used of a limit in the end.
const ALLOWED: f64 = 1.0 - 0.2 * RESERVE;
/// Times the law is solved again with less room where a limit was passed.
const ROUNDS: usize = 6;
/// Most steps of Newton's method for one station: it descends to its zero in two or three.
const STEPS: usize = 60;

/// Squared speeds at the stations `u` of `path`, linear between them, of the fastest law from rest to rest under speeds and
/// accelerations; and the asked ones at both ends of each cell.
///
/// In each cell the acceleration `a` is constant, and with `x` the squared speed at its start every limit at every place
/// bounds the two by a slab. A backward pass finds the highest `x` from which the rest of the path can be finished, a
/// forward pass takes the most. Guarantee: no speed and acceleration is exceeded (between the places accelerations by a
/// parabola, which is exact on cubic splines, squared speeds by cubics, and a reserve); nowhere faster than asked.
///
/// # Errors
/// As [`super::cells::Cells::new`].
pub(crate) fn fastest(path: &dyn Channels, u: &[f64]) -> Result<(Vec<f64>, Vec<[f64; 2]>), LawError> {
    let mut slabs = Slabs::new(path, u)?;
    let mut b = Vec::new();
    let mut worst = 1.0;
    for _ in 0..ROUNDS {
        b = slabs.forward(&slabs.backward());
        worst = slabs.lessen(&b);
        if worst <= ALLOWED {
            return Ok((b, slabs.asked));
        }
    }
    // Slowing the whole law lessens its squared speeds and accelerations alike.
    b.iter_mut().for_each(|b| *b *= ALLOWED / worst);
    Ok((b, slabs.asked))
}

/// A bound of the acceleration from one side: `at0 + slope x`.
#[derive(Debug, Clone, Copy)]
struct Line {
    at0: f64,
    slope: f64,
}

impl Line {
    fn at(self, x: f64) -> f64 {
        self.at0 + self.slope * x
    }
}

/// What bounds squared speeds at stations and accelerations in cells.
struct Slabs {
    widths: Vec<f64>,
    channels: usize,
    /// Square of every channel's acceleration by its speed.
    by_speed: Vec<f64>,
    /// First and second derivative of every channel at every place of every cell, by its acceleration.
    derivatives: Vec<[f64; 2]>,
    /// As many slabs: `|a - slope x| <= at0`.
    slabs: Vec<Line>,
    /// Highest squared speed by the channels at every place of each cell.
    caps: Vec<[f64; 3]>,
    /// Asked squared speed at both ends of each cell.
    asked: Vec<[f64; 2]>,
    /// The part of the limits each cell may use.
    room: Vec<f64>,
}

impl Slabs {
    fn new(path: &dyn Channels, u: &[f64]) -> Result<Self, LawError> {
        let (count, channels) = (u.len() - 1, path.limits().len());
        let rates: Vec<[f64; 2]> = path.limits().iter().map(|l| [1.0 / l.speed, 1.0 / l.acceleration]).collect();
        let mut built = Self {
            widths: u.windows(2).map(|w| w[1] - w[0]).collect(),
            channels,
            by_speed: path.limits().iter().map(|l| (l.acceleration / l.speed).powi(2)).collect(),
            derivatives: Vec::with_capacity(count * PLACES.len() * channels),
            slabs: Vec::with_capacity(count * PLACES.len() * channels),
            caps: vec![[f64::INFINITY; 3]; count],
            asked: vec![[f64::INFINITY; 2]; count],
            room: vec![1.0 - RESERVE; count],
        };
        let mut row = vec![[0.0; 3]; channels];
        for cell in 0..count {
            let asked = path.asked(0.5 * (u[cell] + u[cell + 1]));
            for (place, part) in PLACES.into_iter().enumerate() {
                let at = if place == 2 { u[cell + 1] } else { u[cell] + part * built.widths[cell] };
                let tip = path.derivatives(at, place > 0, &mut row).abs();
                let good = asked > 0.0 && tip.is_finite() && row.iter().all(|d| (d[0] + d[1]).is_finite());
                if !good {
                    return Err(broken(path, at, &row));
                }
                built.add(cell, place, &row, &rates);
                if tip > 0.0 && place != 1 {
                    built.asked[cell][place / 2] = (asked / tip).powi(2);
                }
            }
        }
        let bounded = built.caps.iter().flatten().chain(built.asked.iter().flatten()).any(|cap| cap.is_finite());
        if bounded { Ok(built) } else { Err(LawError::Still { from: u[0], to: u[count] }) }
    }

    /// Adds the channels' derivatives `row` at a place; `rates` are one by their speeds and accelerations.
    fn add(&mut self, cell: usize, place: usize, row: &[[f64; 3]], rates: &[[f64; 2]]) {
        let along = 2.0 * PLACES[place] * self.widths[cell];
        let mut speed: f64 = 0.0;
        for ([q1, q2, _], [by_speed, by_acceleration]) in row.iter().zip(rates) {
            speed = speed.max(q1.abs() * by_speed);
            let (q1, q2) = (q1 * by_acceleration, q2 * by_acceleration);
            self.derivatives.push([q1, q2]);
            // |q'' (x + along a) + q' a| <= 1.
            let a = q1 + along * q2;
            if a.abs() > 1e-12 * (along * q2).abs() {
                let by = 1.0 / a;
                self.slabs.push(Line { at0: by.abs(), slope: -q2 * by });
            } else {
                self.slabs.push(Line { at0: f64::INFINITY, slope: 0.0 });
                self.caps[cell][0] = self.caps[cell][0].min(1.0 / q2.abs());
            }
        }
        self.caps[cell][place] = self.caps[cell][place].min(1.0 / (speed * speed));
    }

    /// Number of cells.
    fn count(&self) -> usize {
        self.widths.len()
    }

    /// Highest squared speed at station `i` by itself; large if nothing moves just there.
    fn cap(&self, i: usize) -> f64 {
        let of = |cell: usize, end: usize| {
            let room = self.room[cell];
            self.asked[cell][end].min(self.caps[cell][2 * end] * room * room)
        };
        let before = if i > 0 { of(i - 1, 1) } else { f64::INFINITY };
        before.min(if i < self.count() { of(i, 0) } else { f64::INFINITY }).min(f64::MAX.sqrt())
    }

    /// The tightest upper and lower bound on the acceleration in cell `i` from the squared speed `x` on, if the next
    /// station's is to be at most `next`.
    fn bounds(&self, i: usize, next: f64, x: f64) -> (Line, Line) {
        let (slope, room) = (-0.5 / self.widths[i], self.room[i]);
        let lower = Line { at0: 0.0, slope };
        let ends = Line { at0: -slope * next, slope };
        let middle = Line { at0: -2.0 * slope * room * room * self.caps[i][1], slope: 2.0 * slope };
        let mut upper = if middle.at(x) < ends.at(x) { middle } else { ends };
        let (mut lower, mut least, mut most) = (lower, upper.at(x), lower.at(x));
        let each = PLACES.len() * self.channels;
        for slab in &self.slabs[i * each..][..each] {
            let (middle, half) = (slab.slope * x, slab.at0 * room);
            if middle + half < least {
                least = middle + half;
                upper = Line { at0: half, slope: slab.slope };
            }
            if middle - half > most {
                most = middle - half;
                lower = Line { at0: -half, slope: slab.slope };
            }
        }
        (upper, lower)
    }

    /// The highest squared speed at each station from which the path can be finished.
    fn backward(&self) -> Vec<f64> {
        let n = self.count();
        let mut reach = vec![0.0; n + 1];
        for i in (0..n).rev() {
            let mut x = self.cap(i);
            // Upper less lower bound is concave in x: Newton's method descends to its zero without passing it.
            for _ in 0..STEPS {
                let (upper, lower) = self.bounds(i, reach[i + 1], x);
                let closing = lower.slope - upper.slope;
                if upper.at(x) >= lower.at(x) || closing <= 0.0 {
                    break;
                }
                let next = ((upper.at0 - lower.at0) / closing).max(0.0);
                if next >= x {
                    break;
                }
                x = next;
            }
            reach[i] = x;
        }
        reach
    }

    /// From rest, the highest acceleration in each cell.
    fn forward(&self, reach: &[f64]) -> Vec<f64> {
        let mut b = vec![0.0; reach.len()];
        for i in 0..self.count() {
            let (upper, lower) = self.bounds(i, reach[i + 1], b[i]);
            let a = upper.at(b[i]).max(lower.at(b[i]));
            let next = (b[i] + 2.0 * self.widths[i] * a).max(0.0);
            // A cruise stays exactly at its speed.
            b[i + 1] = if next > (1.0 - 1e-12) * reach[i + 1] { reach[i + 1] } else { next };
        }
        b
    }

    /// Lessens the room of cells in which the law with squared speeds `b` uses more than is allowed; the greatest use.
    fn lessen(&mut self, b: &[f64]) -> f64 {
        let mut worst: f64 = 0.0;
        for i in 0..self.count() {
            let most = self.peak(i, b[i], b[i + 1]);
            worst = worst.max(most);
            if most > ALLOWED {
                self.room[i] *= (1.0 - RESERVE) / most;
            }
        }
        worst
    }

    /// The greatest use of a limit in cell `i` with squared speeds `from` and `to` at its ends.
    fn peak(&self, i: usize, from: f64, to: f64) -> f64 {
        let width = self.widths[i];
        let (a, b) = (0.5 * (to - from) / width, [from, 0.5 * (from + to), to]);
        let each = PLACES.len() * self.channels;
        let (start, rest) = self.derivatives[i * each..][..each].split_at(self.channels);
        let (middle, end) = rest.split_at(self.channels);
        let mut most: f64 = 0.0;
        for (((d0, d1), d2), by_speed) in start.iter().zip(middle).zip(end).zip(&self.by_speed) {
            let used = |d: &[f64; 2], b: f64| d[1] * b + d[0] * a;
            let [u0, u1, u2] = [used(d0, b[0]), used(d1, b[1]), used(d2, b[2])];
            let speed = |d: &[f64; 2], b: f64| d[0] * d[0] * b * by_speed;
            let speeds = [speed(d0, b[0]), speed(d1, b[1]), speed(d2, b[2])];
            // The slope of its square, times a third of half a cell; a cubic stays below its Bernstein coefficients.
            let third = |d: &[f64; 2], used: f64| d[0] * used * by_speed * width / 3.0;
            let [t0, t1, t2] = [third(d0, u0), third(d1, u1), third(d2, u2)];
            let beside = [speeds[0] + t0, speeds[1] - t1, speeds[1] + t1, speeds[2] - t2];
            most = speeds.into_iter().chain(beside).fold(most, f64::max).max(greatest([u0, u1, u2]));
        }
        most
    }
}

/// Greatest size of the parabola through three evenly spaced values, from the first to the last.
fn greatest([first, middle, last]: [f64; 3]) -> f64 {
    let ends = first.abs().max(middle.abs()).max(last.abs());
    let (slope, second) = (0.5 * (last - first), first + last - 2.0 * middle);
    if slope.abs() < second.abs() { ends.max((middle - 0.5 * slope * slope / second).abs()) } else { ends }
}
