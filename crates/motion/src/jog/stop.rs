use super::ramp::Ramp;
use super::state::State;
use seamwright_machine::{AxisLimits, Course, Joints, MAX_AXES};

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stop {
    ramps: [Ramp; MAX_AXES],
    axes: usize,
    pub(super) duration: f64,
}

impl Stop {
    pub(super) fn new(limits: &[AxisLimits], from: &State) -> Self {
        let mut stop = Self { ramps: [Ramp::default(); MAX_AXES], axes: limits.len(), duration: 0.0 };
        for (i, limits) in limits.iter().enumerate() {
            stop.ramps[i] = Ramp::new(limits, from.axis(i), 0.0);
            stop.duration = stop.duration.max(stop.ramps[i].duration());
        }
        stop
    }

    pub(super) fn ramps(&self) -> &[Ramp] {
        &self.ramps[..self.axes]
    }

    pub(super) fn end(&self) -> Joints {
        let mut q = Joints::default();
        q.iter_mut().zip(self.ramps()).for_each(|(q, ramp)| *q = ramp.end());
        q
    }

    pub(super) fn at(&self, t: f64) -> State {
        let mut state = State::default();
        for (i, ramp) in self.ramps().iter().enumerate() {
            let axis = ramp.at(t);
            (state.q[i], state.speed[i], state.acceleration[i]) = (axis.q, axis.speed, axis.acceleration);
        }
        state
    }
}

/// Motion that a set-point commits to: straight from the previous one to it in a period, then the stop from it. The
/// parameter is time, s; 0 at the set-point.
#[derive(Debug)]
pub(super) struct Commitment<'a> {
    pub(super) before: &'a Joints,
    pub(super) period: f64,
    pub(super) stop: &'a Stop,
}

impl Commitment<'_> {
    pub(super) fn reach(&self) -> (Joints, Joints) {
        let (mut low, mut high) = (*self.before, *self.before);
        for (i, ramp) in self.stop.ramps().iter().enumerate() {
            let (l, h) = ramp.reach();
            (low[i], high[i]) = (low[i].min(l), high[i].max(h));
        }
        (low, high)
    }
}

impl Course for Commitment<'_> {
    fn range(&self) -> (f64, f64) {
        (-self.period, self.stop.duration)
    }

    fn at(&self, s: f64) -> Joints {
        let q = self.stop.at(s.max(0.0)).q;
        let back = (-s / self.period).clamp(0.0, 1.0);
        std::array::from_fn(|i| q[i] + back * (self.before[i] - q[i]))
    }

    fn greatest_rates(&self, from: f64, to: f64) -> Joints {
        let mut rates = Joints::default();
        for (i, ramp) in self.stop.ramps().iter().enumerate() {
            let before = if from < 0.0 { (ramp.at(0.0).q - self.before[i]).abs() / self.period } else { 0.0 };
            let after = if to > 0.0 { ramp.greatest_speed(from.max(0.0), to) } else { 0.0 };
            rates[i] = before.max(after);
        }
        rates
    }
}
