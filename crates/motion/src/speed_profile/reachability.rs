//! The fastest profile under limits of speed and acceleration alone, by reachability (Pham and Pham, T-RO 2018).

use super::cells::broken;
use super::channels::Channels;
use super::error::SpeedProfileError;
use super::lanes::{LANES, Lanes, larger, smaller};
use seamwright_machine::AxisLimits;

/// Points of each cell at which limits are imposed, as fractions of its width.
const PLACES: [f64; 3] = [0.0, 0.5, 1.0];
/// Distance from the cell's ends at which requested speeds are sampled, as a fraction of the distance to its middle.
const INSET: f64 = 1e-6;
/// Fraction of each limit kept in reserve for values between those points.
const RESERVE: f64 = 1e-4;
/// Maximum use of a limit by the final profile.
const ALLOWED: f64 = 1.0 - 0.2 * RESERVE;
/// Maximum number of repeated solutions with less room in cells that exceed a limit.
const ROUNDS: usize = 6;
/// Maximum number of Newton steps for one station: usually it converges in two or three.
const STEPS: usize = 60;

/// Computes squared speeds at the stations `u` of `path`, linear between them, of the fastest profile from rest to rest
/// under speeds and accelerations; and the requested ones at both ends of each cell.
///
/// In each cell the acceleration `a` is constant. With `x` the squared speed at its start, every limit at every point
/// bounds the two by a slab. A backward pass finds the maximum `x` from which the rest of the path can be finished, a
/// forward pass takes the maximum acceleration. Guarantee: no speed or acceleration is exceeded, and the tip is never
/// faster than requested. Between the points accelerations are bounded by a parabola, exact on cubic splines, squared
/// speeds by cubics, and a reserve.
pub(crate) fn fastest(path: &dyn Channels, u: &[f64]) -> Result<(Vec<f64>, Vec<[f64; 2]>), SpeedProfileError> {
    let mut slabs = Slabs::new(path, u)?;
    let mut profile = Profile::new(slabs.count());
    for _ in 0..ROUNDS {
        slabs.backward(&mut profile);
        slabs.forward(&mut profile);
        if !slabs.lessen(&mut profile) {
            return Ok((profile.b, slabs.asked));
        }
    }
    // Slowing the whole profile reduces its squared speeds and accelerations by the same factor.
    let worst = profile.peaks.iter().copied().fold(ALLOWED, f64::max);
    profile.b.iter_mut().for_each(|b| *b *= ALLOWED / worst);
    Ok((profile.b, slabs.asked))
}

/// A profile with flags for the parts to recompute: a round changes few cells.
struct Profile {
    /// Maximum squared speed at each station from which the path can be finished.
    reach: Vec<f64>,
    /// Squared speeds at stations.
    b: Vec<f64>,
    /// Stations at which `reach` and `b` have just changed.
    changed: [Vec<bool>; 2],
    /// Cells whose room was just reduced.
    lessened: Vec<bool>,
    /// Maximum use of a limit in each cell; only an upper bound up to [`ALLOWED`].
    peaks: Vec<f64>,
}

impl Profile {
    fn new(cells: usize) -> Self {
        let mut profile = Self {
            reach: vec![f64::NAN; cells + 1],
            b: vec![f64::NAN; cells + 1],
            changed: [vec![false; cells + 1], vec![false; cells + 1]],
            lessened: vec![true; cells],
            peaks: vec![0.0; cells],
        };
        (profile.reach[cells], profile.b[0]) = (0.0, 0.0);
        profile
    }
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

/// Bounds of squared speeds at stations and of accelerations in cells.
struct Slabs {
    widths: Vec<f64>,
    /// Every channel's squared ratio of acceleration limit to speed limit, in lanes.
    by_speed: Vec<[f64; LANES]>,
    /// Bounds of all channels at every point of each cell. One allocation, which repeated profiles reuse without zeroed
    /// pages.
    lanes: Vec<Lanes>,
    /// Maximum squared speed by the channels at every point of each cell.
    caps: Vec<[f64; 3]>,
    /// Requested squared speed at both ends of each cell.
    asked: Vec<[f64; 2]>,
    /// Fraction of the limits that each cell may use.
    room: Vec<f64>,
}

impl Slabs {
    fn new(path: &dyn Channels, u: &[f64]) -> Result<Self, SpeedProfileError> {
        let count = u.len() - 1;
        let rates: Vec<[[f64; LANES]; 2]> = path
            .limits()
            .chunks(LANES)
            .map(|limits| {
                let by = |limit: fn(&AxisLimits) -> f64| {
                    std::array::from_fn(|k| limits.get(k).map_or(0.0, |l| 1.0 / limit(l)))
                };
                [by(|l| l.speed), by(|l| l.acceleration)]
            })
            .collect();
        let by_speed = path
            .limits()
            .chunks(LANES)
            .map(|limits| std::array::from_fn(|k| limits.get(k).map_or(0.0, |l| (l.acceleration / l.speed).powi(2))));
        let by_speed: Vec<_> = by_speed.collect();
        let mut built = Self {
            widths: u.windows(2).map(|w| w[1] - w[0]).collect(),
            lanes: Vec::with_capacity(count * PLACES.len() * by_speed.len()),
            by_speed,
            caps: vec![[f64::INFINITY; 3]; count],
            asked: vec![[f64::INFINITY; 2]; count],
            room: vec![1.0 - RESERVE; count],
        };
        let breaks = path.breaks();
        let mut row = vec![[0.0; 3]; path.limits().len()];
        let mut tip = 0.0;
        for cell in 0..count {
            let middle = 0.5 * (u[cell] + u[cell + 1]);
            for (place, part) in PLACES.into_iter().enumerate() {
                let at = if place == 2 { u[cell + 1] } else { u[cell] + part * built.widths[cell] };
                // Stays on this side of a break.
                let asked = path.asked(at + INSET * (middle - at));
                // Most cells start with the derivatives at the end of the previous one.
                if place > 0 || cell == 0 || breaks.binary_search_by(|b| b.total_cmp(&at)).is_ok() {
                    tip = path.derivatives(at, place > 0, &mut row).abs();
                }
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
        if bounded { Ok(built) } else { Err(SpeedProfileError::Still { from: u[0], to: u[count] }) }
    }

    /// Adds the channels' derivatives `row` at a point; `rates` are the reciprocals of their speeds and accelerations.
    fn add(&mut self, cell: usize, place: usize, row: &[[f64; 3]], rates: &[[[f64; LANES]; 2]]) {
        let along = 2.0 * PLACES[place] * self.widths[cell];
        let (mut speeds, mut steepest) = ([0.0; LANES], 0.0);
        for (row, [by_speed, by_acceleration]) in row.chunks(LANES).zip(rates) {
            // Arrays of a known length stay in registers.
            let lanes = |d: usize| std::array::from_fn::<f64, LANES, _>(|k| row.get(k).map_or(0.0, |row| row[d]));
            let (mut first, mut second) = (lanes(0), lanes(1));
            for k in 0..LANES {
                speeds[k] = larger(speeds[k], first[k].abs() * by_speed[k]);
                first[k] *= by_acceleration[k];
                second[k] *= by_acceleration[k];
            }
            let (lanes, flat) = Lanes::new(first, second, along);
            self.lanes.push(lanes);
            steepest = larger(steepest, flat);
        }
        let speed = speeds.into_iter().fold(0.0, larger);
        self.caps[cell][0] = self.caps[cell][0].min(1.0 / steepest);
        self.caps[cell][place] = self.caps[cell][place].min(1.0 / (speed * speed));
    }

    fn cell(&self, i: usize) -> &[Lanes] {
        let each = PLACES.len() * self.by_speed.len();
        &self.lanes[i * each..][..each]
    }

    fn count(&self) -> usize {
        self.widths.len()
    }

    /// Maximum squared speed at station `i` alone; large if no channel moves there.
    fn cap(&self, i: usize) -> f64 {
        let of = |cell: usize, end: usize| {
            let room = self.room[cell];
            self.asked[cell][end].min(self.caps[cell][2 * end] * room * room)
        };
        let before = if i > 0 { of(i - 1, 1) } else { f64::INFINITY };
        before.min(if i < self.count() { of(i, 0) } else { f64::INFINITY }).min(f64::MAX.sqrt())
    }

    /// Upper bounds on the acceleration in cell `i` from a squared speed of at most `next` at the next station, and
    /// from the cap in the middle; and the lower bound from a squared speed of at least 0.
    fn ends(&self, i: usize, next: f64) -> ([Line; 2], Line) {
        let (slope, room) = (-0.5 / self.widths[i], self.room[i]);
        let end = Line { at0: -slope * next, slope };
        let middle = Line { at0: -2.0 * slope * room * room * self.caps[i][1], slope: 2.0 * slope };
        ([middle, end], Line { at0: 0.0, slope })
    }

    /// Tightest upper and lower bound on the acceleration in cell `i` from the squared speed `x`, with the bounds of
    /// [`Slabs::ends`].
    fn extent(&self, i: usize, (upper, lower): &([Line; 2], Line), x: f64) -> [f64; 2] {
        let room = self.room[i];
        let (mut least, mut most) = ([f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]);
        for Lanes { half, slope, .. } in self.cell(i) {
            for k in 0..LANES {
                let (middle, half) = (slope[k] * x, half[k] * room);
                least[k] = smaller(least[k], middle + half);
                most[k] = larger(most[k], middle - half);
            }
        }
        let least = least.into_iter().chain(upper.iter().map(|line| line.at(x))).fold(f64::INFINITY, f64::min);
        [least, most.into_iter().fold(lower.at(x), f64::max)]
    }

    /// Lines of the tightest bounds at `x`.
    fn lines(&self, i: usize, (upper, lower): &([Line; 2], Line), x: f64, [least, most]: [f64; 2]) -> (Line, Line) {
        let slabs = self.cell(i).iter().flat_map(|lanes| lanes.slope.iter().zip(&lanes.half));
        let mut lines = slabs.map(|(slope, half)| (Line { at0: half * self.room[i], slope: *slope }, slope * x));
        let by_end = |line: &Line| line.at(x) <= least;
        let slab = lines.clone().find(|(line, middle)| middle + line.at0 <= least).map(|(line, _)| line);
        let upper = upper.iter().find(|line| by_end(line)).copied().or(slab).unwrap_or(upper[1]);
        let slab = lines.find(|(line, middle)| middle - line.at0 >= most);
        let slab = slab.filter(|_| lower.at(x) < most).map(|(line, _)| Line { at0: -line.at0, ..line });
        (upper, slab.unwrap_or(*lower))
    }

    /// Finds the maximum squared speed at each station from which the path can be finished.
    fn backward(&self, profile: &mut Profile) {
        for i in (0..self.count()).rev() {
            let lessened = profile.lessened[i] || (i > 0 && profile.lessened[i - 1]);
            profile.changed[0][i] = false;
            if lessened || profile.changed[0][i + 1] {
                let x = self.highest(i, profile.reach[i + 1]);
                profile.changed[0][i] = x.to_bits() != profile.reach[i].to_bits();
                profile.reach[i] = x;
            }
        }
    }

    /// Maximum squared speed at station `i` from which the next one can be reached with at most `next`.
    fn highest(&self, i: usize, next: f64) -> f64 {
        let ends = self.ends(i, next);
        let mut x = self.cap(i);
        // Upper less lower bound is concave in x: Newton's method descends to its zero without overshoot.
        for _ in 0..STEPS {
            let extent = self.extent(i, &ends, x);
            if extent[0] >= extent[1] {
                break;
            }
            let (upper, lower) = self.lines(i, &ends, x, extent);
            let closing = lower.slope - upper.slope;
            let next = ((upper.at0 - lower.at0) / closing).max(0.0);
            if closing <= 0.0 || next >= x {
                break;
            }
            x = next;
        }
        x
    }

    /// Takes the maximum acceleration in each cell, from rest.
    fn forward(&self, profile: &mut Profile) {
        for i in 0..self.count() {
            let old = profile.b[i + 1];
            if profile.lessened[i] || profile.changed[0][i + 1] || profile.changed[1][i] {
                let [least, most] = self.extent(i, &self.ends(i, profile.reach[i + 1]), profile.b[i]);
                let next = (profile.b[i] + 2.0 * self.widths[i] * least.max(most)).max(0.0);
                // A cruise keeps exactly its speed.
                let cruises = next > (1.0 - 1e-12) * profile.reach[i + 1];
                profile.b[i + 1] = if cruises { profile.reach[i + 1] } else { next };
            }
            profile.changed[1][i + 1] = profile.b[i + 1].to_bits() != old.to_bits();
        }
    }

    /// Reduces the room of cells in which the profile exceeds the allowed use. Returns true if there are any.
    fn lessen(&mut self, profile: &mut Profile) -> bool {
        for i in 0..self.count() {
            if profile.changed[1][i] || profile.changed[1][i + 1] {
                profile.peaks[i] = self.peak(i, profile.b[i], profile.b[i + 1]);
            }
            profile.lessened[i] = profile.peaks[i] > ALLOWED;
            if profile.lessened[i] {
                self.room[i] *= (1.0 - RESERVE) / profile.peaks[i];
            }
        }
        profile.lessened.contains(&true)
    }

    /// Maximum use of a limit in cell `i` with squared speeds `from` and `to` at its ends; an upper bound of it if no
    /// limit is exceeded.
    fn peak(&self, i: usize, from: f64, to: f64) -> f64 {
        let width = self.widths[i];
        let (a, b) = (0.5 * (to - from) / width, [from, 0.5 * (from + to), to]);
        let groups = self.by_speed.len();
        let (start, rest) = self.cell(i).split_at(groups);
        let (middle, end) = rest.split_at(groups);
        let mut most = 0.0;
        for (((l0, l1), l2), by_speed) in start.iter().zip(middle).zip(end).zip(&self.by_speed) {
            let (mut used, mut speed, mut bound) = ([[0.0; 3]; LANES], [0.0; LANES], [0.0; LANES]);
            for k in 0..LANES {
                let [f0, f1, f2] = [l0.first[k], l1.first[k], l2.first[k]];
                let u0 = l0.second[k] * b[0] + f0 * a;
                let u1 = l1.second[k] * b[1] + f1 * a;
                let u2 = l2.second[k] * b[2] + f2 * a;
                used[k] = [u0, u1, u2];
                // The slope of the speed's square, times a third of half a cell; a cubic stays below its Bernstein
                // coefficients.
                let by = by_speed[k];
                let third = by * width / 3.0;
                let [t0, t1, t2] = [f0 * u0 * third, (f1 * u1 * third).abs(), f2 * u2 * third];
                let speeds = [f0 * f0 * b[0] * by, f1 * f1 * b[1] * by, f2 * f2 * b[2] * by];
                let ends = larger(speeds[0] + larger(t0, 0.0), speeds[2] - smaller(t2, 0.0));
                speed[k] = larger(ends, speeds[1] + t1);
                // The parabola of accelerations has the same kind of bound.
                let beside = (2.0 * u1 - 0.5 * (u0 + u2)).abs();
                bound[k] = larger(larger(speed[k], beside), larger(u0.abs(), u2.abs()));
            }
            let bound = bound.into_iter().fold(0.0, larger);
            let exact = || used.into_iter().map(greatest).chain(speed).fold(0.0, larger);
            most = larger(most, if bound <= ALLOWED { bound } else { exact() });
        }
        most
    }
}

/// Maximum absolute value of the parabola through three evenly spaced values, from the first to the last.
fn greatest([first, middle, last]: [f64; 3]) -> f64 {
    let ends = first.abs().max(middle.abs()).max(last.abs());
    let (slope, second) = (0.5 * (last - first), first + last - 2.0 * middle);
    if slope.abs() < second.abs() { ends.max((middle - 0.5 * slope * slope / second).abs()) } else { ends }
}
