use super::cells::NEARLY;
use super::channels::Channels;
use super::jerk_limited::RESERVE;
use super::profile::{ProfilePoint, SpeedProfile};
use seamwright_geometry::numeric::bisect;
use serde::{Deserialize, Serialize};

/// Limit that bounds the speed of the tip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Bound {
    /// The requested speed: the tip reaches it.
    Asked,
    /// The speed of a channel.
    Speed(usize),
    /// The acceleration of a channel.
    Acceleration(usize),
    /// The jerk of a channel.
    Jerk(usize),
    /// No limit: the requested speed changes, and the profile rounds the change off.
    Change,
}

/// A stretch of the path with one bound.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    /// Parameters of its start and end.
    pub from: f64,
    /// See [`Interval::from`].
    pub to: f64,
    /// Minimum and maximum speed of the tip in it, mm/s.
    pub speed: (f64, f64),
    /// Parameter of the minimum speed.
    pub least_at: f64,
    /// Minimum ratio of reached to requested speed in it, and its parameter.
    pub reached: (f64, f64),
    /// The binding limit.
    pub bound: Bound,
    /// False in acceleration and deceleration phase.
    pub between: bool,
}

/// Maximum fraction of each limit that a channel uses, over the whole path.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Use {
    /// Of its speed.
    pub speed: f64,
    /// Of its acceleration.
    pub acceleration: f64,
    /// Of its jerk.
    pub jerk: f64,
}

/// Result of a speed profile: reached speeds and binding limits. It can be verified from the set-points and the limits.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// Stretches in order, from the first parameter to the last.
    pub intervals: Vec<Interval>,
    /// For every channel.
    pub uses: Vec<Use>,
    /// Fraction of the path on which the tip has the requested speed.
    pub at_asked: f64,
    /// Speed of the tip (mm/s) that all channels can hold everywhere.
    pub everywhere: f64,
}

/// Sample points in every cell of the profile, as fractions of its time.
const PARTS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Distance of the outer samples from the cell's borders, as a fraction of its time. At a border jerk may jump, and
/// rounding would decide on the side.
const INSET: f64 = 1e-6;
/// Minimum used fraction of a binding limit.
const BINDS: f64 = 0.9;
/// Relative tolerance of the requested speed; [`NEARLY`] applies if the requested speed by the parameter changes.
const AS_ASKED: f64 = 1e-6;

impl Certificate {
    /// Computes the certificate of the speed profile `profile` along `path`.
    pub fn new(path: &dyn Channels, profile: &SpeedProfile) -> Self {
        let channels = path.limits().len();
        let mut built = Self {
            intervals: Vec::new(),
            uses: vec![Use::default(); channels],
            at_asked: 0.0,
            everywhere: f64::INFINITY,
        };
        let mut derivatives = vec![[0.0; 3]; channels];
        let band = profile.report();
        let mut cells = Vec::with_capacity(profile.cells());
        for cell in 0..profile.cells() {
            let (begin, end) = (profile.in_cell(cell, 0.0), profile.in_cell(cell, 1.0));
            let mut worst = (f64::NEG_INFINITY, Bound::Asked);
            let (mut least, mut greatest, mut reached) = ((f64::INFINITY, begin.s), 0.0f64, (f64::INFINITY, begin.s));
            let (mut slowest, mut fastest) = (f64::INFINITY, 0.0f64);
            let turn = turning(profile, cell);
            for part in PARTS.into_iter().chain(turn) {
                let p = profile.in_cell(cell, part.clamp(INSET, 1.0 - INSET));
                let tip = path.derivatives(p.s, part > 0.5, &mut derivatives);
                let here = profile.in_cell(cell, part);
                let (speed, asked) = (tip * here.v, path.asked(p.s));
                least = lesser(least, (speed, here.s));
                reached = lesser(reached, (speed / asked, here.s));
                greatest = greatest.max(speed);
                (slowest, fastest) = (slowest.min(asked / tip), fastest.max(asked / tip));
                built.steady(path, &derivatives, tip);
                let bound = built.at(path, &derivatives, p);
                if bound.0 > worst.0 {
                    worst = bound;
                }
            }
            let changes = slowest < (1.0 - AS_ASKED) * fastest;
            let nearly = changes && worst.0 < BINDS && reached.0 >= 1.0 - NEARLY;
            let bound = if nearly || reached.0 >= 1.0 - AS_ASKED { Bound::Asked } else { worst.1 };
            let between = begin.s >= band.run_up_end && end.s <= band.run_down_start;
            let speed = (least.0, greatest);
            let (from, to, least_at) = (begin.s, end.s, least.1);
            cells.push((Interval { from, to, speed, least_at, reached, bound, between }, worst.0));
        }
        for i in 0..cells.len() {
            let bound = binding(&cells, i);
            built.add(Interval { bound, ..cells[i].0 });
        }
        let (from, to) = path.range();
        let asked = built.intervals.iter().filter(|i| i.bound == Bound::Asked);
        built.at_asked = asked.map(|i| i.to - i.from).sum::<f64>() / (to - from);
        built
    }

    /// Minimum and maximum speed of the tip between acceleration and deceleration phase, mm/s; none if these meet.
    pub fn band(&self) -> Option<(f64, f64)> {
        let speeds = self.intervals.iter().filter(|i| i.between).map(|i| i.speed);
        speeds.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
    }

    /// Adds the channels' use of their limits at one point. Returns the maximum and its limit.
    fn at(&mut self, path: &dyn Channels, derivatives: &[[f64; 3]], p: ProfilePoint) -> (f64, Bound) {
        let mut worst = (0.0, Bound::Asked);
        for (i, (([q1, q2, q3], limits), used)) in derivatives.iter().zip(path.limits()).zip(&mut self.uses).enumerate()
        {
            let (v, a) = (p.v, p.a);
            let here = Use {
                speed: (q1 * v / limits.speed).abs(),
                acceleration: ((q2 * v * v + q1 * a) / limits.acceleration).abs(),
                jerk: ((q3 * v * v * v + 3.0 * q2 * v * a + q1 * p.j) / limits.jerk).abs(),
            };
            used.speed = used.speed.max(here.speed);
            used.acceleration = used.acceleration.max(here.acceleration);
            used.jerk = used.jerk.max(here.jerk);
            let bounds = [
                (here.speed, Bound::Speed(i)),
                (here.acceleration, Bound::Acceleration(i)),
                (here.jerk, Bound::Jerk(i)),
            ];
            for bound in bounds {
                if bound.0 > worst.0 {
                    worst = bound;
                }
            }
        }
        worst
    }

    /// Adds the tip speed that the channels can hold steadily at one point.
    fn steady(&mut self, path: &dyn Channels, derivatives: &[[f64; 3]], tip: f64) {
        for ([q1, q2, q3], limits) in derivatives.iter().zip(path.limits()) {
            let speed = (limits.speed / q1.abs())
                .min((limits.acceleration / q2.abs()).sqrt())
                .min((limits.jerk / q3.abs()).cbrt());
            self.everywhere = self.everywhere.min(tip * speed * (1.0 - 1.5 * RESERVE));
        }
    }

    /// Appends a stretch, merged with the last one if that has the same bound.
    fn add(&mut self, next: Interval) {
        match self.intervals.last_mut().filter(|last| (last.bound, last.between) == (next.bound, next.between)) {
            Some(last) => {
                last.to = next.to;
                if next.speed.0 < last.speed.0 {
                    (last.speed.0, last.least_at) = (next.speed.0, next.least_at);
                }
                last.speed.1 = last.speed.1.max(next.speed.1);
                last.reached = lesser(last.reached, next.reached);
            }
            None => {
                // The end of a cell and the start of the next differ by rounding.
                let from = self.intervals.last().map_or(next.from, |last| last.to);
                self.intervals.push(Interval { from, ..next });
            }
        }
    }
}

fn lesser(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    if b.0 < a.0 { b } else { a }
}

/// Binding limit of cell `i`, from the cells with their maximum use of a limit. A cell that uses up no limit takes that
/// of the nearest slowed cell that does: its speed leads to or from there.
fn binding(cells: &[(Interval, f64)], i: usize) -> Bound {
    let own = cells[i].0.bound;
    if own == Bound::Asked || cells[i].1 >= BINDS {
        return own;
    }
    let strong = |c: &&(Interval, f64)| c.1 >= BINDS;
    let slowed = |c: &&(Interval, f64)| c.0.bound != Bound::Asked;
    let before = cells[..i].iter().rev().take_while(slowed).position(|c| strong(&c));
    let after = cells[i + 1..].iter().take_while(slowed).position(|c| strong(&c));
    match (before, after) {
        (Some(b), Some(a)) if a < b => cells[i + 1 + a].0.bound,
        (Some(b), _) => cells[i - 1 - b].0.bound,
        (None, Some(a)) => cells[i + 1 + a].0.bound,
        (None, None) => Bound::Change,
    }
}

/// Fraction of a cell's time at which its speed has an extremum, if any: the acceleration changes its sign at most once
/// in a cell.
fn turning(profile: &SpeedProfile, cell: usize) -> Option<f64> {
    let sign = |part: f64| profile.in_cell(cell, part).a;
    let first = sign(0.0);
    // Until the speed, nearly constant at the extremum, is exact to rounding.
    (first * sign(1.0) < 0.0).then(|| bisect(0.0, 1.0, 30, |part| first * sign(part) > 0.0).0)
}
