use super::rest_to_rest::RestToRest;
use crate::feed_override::{Rates, Timed, Tip};
use seamwright_geometry::numeric::bisect;
use seamwright_machine::{AxisLimits, Course, Joints, Machine};
use serde::{Deserialize, Serialize};

/// Synchronised move of all axes between two sets of positions, straight in axis space, from rest to rest. Its speed is
/// the maximum within every axis' speed, acceleration and jerk.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Leg {
    from: Joints,
    to: Joints,
    /// Completed fraction of the move over time.
    part: RestToRest,
}

impl Leg {
    /// Plans the leg on `machine`. An axis without a maximum jerk uses [`Axis::jerk`](seamwright_machine::Axis::jerk).
    pub fn new(machine: &Machine, from: &Joints, to: &Joints) -> Self {
        let ways = machine.axes.iter().zip(from.iter().zip(to));
        let parts = ways.map(|(axis, (p, q))| axis.limits().divided((p - q).abs()));
        Self { from: *from, to: *to, part: RestToRest::new(parts.fold(AxisLimits::NONE, AxisLimits::min)) }
    }

    /// Rest of all axes at `q` for `time_s`.
    pub fn rest(q: &Joints, time_s: f64) -> Self {
        Self { from: *q, to: *q, part: RestToRest::resting(time_s) }
    }

    /// True if no axis moves.
    pub fn is_rest(&self) -> bool {
        self.from.iter().zip(&self.to).all(|(from, to)| from.to_bits() == to.to_bits())
    }

    /// Time from rest to rest, s.
    pub fn duration(&self) -> f64 {
        self.part.duration()
    }

    /// Start positions, mm or rad.
    pub fn start(&self) -> &Joints {
        &self.from
    }

    /// End positions, mm or rad.
    pub fn end(&self) -> &Joints {
        &self.to
    }

    /// Positions at time `t` (s) from its start, mm or rad.
    pub fn at_time(&self, t: f64) -> Joints {
        // At rest the ends themselves, without rounding.
        if t >= self.duration() { self.to } else { Course::at(self, self.part.at(t).0) }
    }

    /// Speeds and accelerations at time `t` (s) from its start, mm or rad per s and s^2.
    pub fn rates(&self, t: f64) -> (Joints, Joints) {
        let (_, speed, acceleration) = self.part.at(t);
        let times = |f: f64| std::array::from_fn(|i| f * (self.to[i] - self.from[i]));
        (times(speed), times(acceleration))
    }
}

/// The path length is the completed fraction, from 0 to 1. Limits of the torch tip do not apply to transfer moves.
impl Timed for Leg {
    fn duration(&self) -> f64 {
        self.part.duration()
    }

    fn at(&self, t: f64, before: bool) -> Rates {
        let ((s, v, a), j) = (self.part.at(t), self.part.jerk(t, before));
        let mut rates = Rates { q: self.at_time(t), tip: Tip { s, v, a, j }, ..Rates::default() };
        for (i, (from, to)) in self.from.iter().zip(&self.to).enumerate() {
            (rates.v[i], rates.a[i], rates.j[i]) = (v * (to - from), a * (to - from), j * (to - from));
        }
        rates
    }

    fn next_border(&self, t: f64, forward: bool) -> f64 {
        let borders = self.part.borders();
        let next = if forward {
            borders.iter().copied().find(|b| *b > t)
        } else {
            borders.iter().rev().copied().find(|b| *b < t)
        };
        next.unwrap_or(if forward { f64::INFINITY } else { f64::NEG_INFINITY })
    }

    fn time_of(&self, s: f64) -> f64 {
        // The fraction grows monotonically: bisection finds the time to the last digit.
        let end = self.duration();
        if s >= 1.0 { end } else { bisect(0.0, end, 64, |t| self.part.at(t).0 < s).0 }
    }
}

/// The course parameter is the completed fraction, from 0 to 1.
impl Course for Leg {
    fn range(&self) -> (f64, f64) {
        (0.0, 1.0)
    }

    fn at(&self, s: f64) -> Joints {
        std::array::from_fn(|i| self.from[i] + s * (self.to[i] - self.from[i]))
    }

    fn greatest_rates(&self, _from: f64, _to: f64) -> Joints {
        std::array::from_fn(|i| (self.to[i] - self.from[i]).abs())
    }

    fn greatest_rate_changes(&self, _from: f64, _to: f64) -> Joints {
        Joints::default()
    }
}

/// Transfer move: consecutive legs, at rest between them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TransferMove {
    /// The legs.
    pub legs: Vec<Leg>,
    /// True if the first leg takes the torch straight back from the end of a weld.
    pub retracts: bool,
    /// True if the last leg brings it straight down to the start of the next.
    pub approaches: bool,
}

impl TransferMove {
    /// The move through `points`, with neither retract nor approach.
    pub fn new(machine: &Machine, points: &[Joints]) -> Self {
        let legs = points.windows(2).map(|w| Leg::new(machine, &w[0], &w[1])).collect();
        Self { legs, retracts: false, approaches: false }
    }

    /// Time from rest to rest, s, with rests between.
    pub fn duration(&self) -> f64 {
        self.legs.iter().map(Leg::duration).sum()
    }

    /// Adds a rest of `time_s`: after the retract, away from the hot weld, or without one at `start`, before the next
    /// pass.
    pub(crate) fn rest(&mut self, start: &Joints, time_s: f64) {
        let after = usize::from(self.retracts).min(self.legs.len());
        let q = match after.checked_sub(1) {
            Some(retract) => *self.legs[retract].end(),
            None => self.legs.first().map_or(*start, |leg| *leg.start()),
        };
        self.legs.insert(after, Leg::rest(&q, time_s));
    }

    /// Time of the rests, s.
    pub fn rest_s(&self) -> f64 {
        self.legs.iter().filter(|leg| leg.is_rest()).map(Leg::duration).sum()
    }

    /// The leg at time `t` (s) from its start and the time since that leg's start; none if there is no leg.
    pub fn leg(&self, t: f64) -> Option<(&Leg, f64)> {
        let mut begun = 0.0;
        for leg in &self.legs {
            if t < begun + leg.duration() {
                return Some((leg, t - begun));
            }
            begun += leg.duration();
        }
        self.legs.last().map(|leg| (leg, leg.duration()))
    }

    /// Number of set-points, one a period from its start to its end.
    pub fn count(&self, period: f64) -> u64 {
        if self.legs.is_empty() { 0 } else { (self.duration() / period - 1e-9).ceil().max(0.0) as u64 + 1 }
    }
}
