use super::state::AxisState;
use seamwright_machine::AxisLimits;

/// Time-optimal change of one axis from any speed and acceleration to a constant speed within its acceleration and
/// jerk: three phases of constant jerk, in closed form.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Ramp {
    /// State at the start of each phase, and at the end of the last one.
    begins: [AxisState; 4],
    jerks: [f64; 3],
    /// End time of each phase.
    ends: [f64; 3],
}

impl Ramp {
    /// Plans from the state `from` to the speed `to`. An acceleration beyond its limit is reduced.
    pub(super) fn new(limits: &AxisLimits, from: AxisState, to: f64) -> Self {
        let AxisState { speed: v, acceleration: a, .. } = from;
        let j = limits.jerk;
        // The sign follows from the speed left missing after only reducing the acceleration to 0.
        let way = if to >= v + a * a.abs() / (2.0 * j) { 1.0 } else { -1.0 };
        let (a, missing) = (way * a, way * (to - v));
        // From a to a peak and from there to 0 the speed changes by (2 peak^2 - a^2) / 2 j.
        let peak = (j * missing + 0.5 * a * a).max(0.0).sqrt();
        let most = limits.acceleration.max(a);
        let (peak, hold) = if peak <= most {
            (peak.max(a), 0.0)
        } else {
            (most, ((missing - (most * most - 0.5 * a * a) / j) / most).max(0.0))
        };
        let times = [(peak - a) / j, hold, peak / j];
        let jerks = [way * j, 0.0, -way * j];
        let mut ramp = Self { begins: [from; 4], jerks, ends: [0.0; 3] };
        let mut t = 0.0;
        for i in 0..3 {
            t += times[i];
            ramp.ends[i] = t;
            ramp.begins[i + 1] = ramp.begins[i].after(times[i], jerks[i]);
        }
        // Removes the rounding of the end.
        (ramp.begins[3].speed, ramp.begins[3].acceleration) = (to, 0.0);
        ramp
    }

    pub(super) fn duration(&self) -> f64 {
        self.ends[2]
    }

    pub(super) fn end(&self) -> f64 {
        self.begins[3].q
    }

    pub(super) fn at(&self, t: f64) -> AxisState {
        match self.ends.iter().position(|end| t < *end) {
            Some(i) => self.begins[i].after(t - if i == 0 { 0.0 } else { self.ends[i - 1] }, self.jerks[i]),
            None => self.begins[3].after(t - self.ends[2], 0.0),
        }
    }

    pub(super) fn reach(&self) -> (f64, f64) {
        let mut reach = (self.begins[0].q, self.begins[0].q);
        let mut meets = |q: f64| reach = (reach.0.min(q), reach.1.max(q));
        for i in 0..3 {
            let (begin, j) = (self.begins[i], self.jerks[i]);
            let length = self.ends[i] - if i == 0 { 0.0 } else { self.ends[i - 1] };
            let AxisState { speed: v, acceleration: a, .. } = begin;
            // The axis reverses where v + a t + j t^2 / 2 = 0: both roots without cancellation.
            let root = (a * a - 2.0 * j * v).max(0.0).sqrt();
            let sum = -(a + root.copysign(a));
            for t in [sum / j, 2.0 * v / sum] {
                if t > 0.0 && t < length {
                    meets(begin.after(t, j).q);
                }
            }
            meets(self.begins[i + 1].q);
        }
        reach
    }

    /// Maximum absolute speed between two times from 0 on.
    pub(super) fn greatest_speed(&self, from: f64, to: f64) -> f64 {
        // The acceleration passes 0 at most once: in the first stretch.
        let turn = -self.begins[0].acceleration / self.jerks[0];
        let ends = self.at(from).speed.abs().max(self.at(to).speed.abs());
        if turn > from && turn < to && turn < self.ends[0] { ends.max(self.at(turn).speed.abs()) } else { ends }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rsruckig::prelude::*;

    proptest! {
        /// The library finds the same fastest change of speed; extremes are those of dense samples.
        #[test]
        fn is_as_fast_as_the_library(
            v in -50.0..50.0f64, a in -1.0..1.0f64, to in prop::sample::select(vec![0.0, 0.0, -20.0, 7.5, 50.0]),
            acceleration in 1.0..1000.0f64, jerk in 10.0..20000.0f64,
        ) {
            let limits = AxisLimits { speed: 50.0, acceleration, jerk };
            let a = a * acceleration;
            let ramp = Ramp::new(&limits, AxisState { q: 3.0, speed: v, acceleration: a }, to);
            let mut ruckig = Ruckig::<1, ThrowErrorHandler>::new(None, 1e-3);
            let mut input = InputParameter::new(None);
            let mut found = Trajectory::new(None);
            input.control_interface = ControlInterface::Velocity;
            (input.current_position[0], input.current_velocity[0], input.current_acceleration[0]) = (3.0, v, a);
            input.target_velocity[0] = to;
            (input.max_acceleration[0], input.max_jerk[0]) = (acceleration, jerk);
            ruckig.calculate(&input, &mut found).unwrap();
            prop_assert!((found.get_duration() - ramp.duration()).abs() < 1e-7 * (1.0 + ramp.duration()));
            let (low, high) = ramp.reach();
            let (begin, end) = (0.2 * ramp.duration(), 0.7 * ramp.duration());
            let most = ramp.greatest_speed(begin, end);
            let mut sampled = 0.0f64;
            let mut last = ramp.at(0.0);
            let (mut least, mut most_far) = (f64::INFINITY, f64::NEG_INFINITY);
            for i in 0..=1000 {
                let t = f64::from(i) * 1e-3 * ramp.duration();
                let AxisState { q, speed: v, acceleration: a } = ramp.at(t);
                prop_assert!(q >= low - 1e-9 && q <= high + 1e-9 && a.abs() <= acceleration * (1.0 + 1e-9));
                let mut theirs = DataArrayOrVec::new(None, 0.0);
                found.at_time(t, &mut Some(&mut theirs), &mut None, &mut None, &mut None, &mut None);
                prop_assert!((theirs[0] - q).abs() < 1e-7 * (1.0 + high - low));
                (least, most_far) = (least.min(q), most_far.max(q));
                let jumps = jerk * 1e-3 * ramp.duration() * (1.0 + 1e-6) + 1e-9;
                prop_assert!((a - last.acceleration).abs() <= jumps);
                last = ramp.at(t);
                if t >= begin && t <= end {
                    prop_assert!(v.abs() <= most * (1.0 + 1e-12) + 1e-12);
                    sampled = sampled.max(v.abs());
                }
            }
            // A turn between two samples is a parabola.
            let missed = acceleration * (1e-3 * ramp.duration()).powi(2) + 1e-9;
            prop_assert!(least - low < missed && high - most_far < missed);
            prop_assert!(most <= sampled + 2e-3 * acceleration * ramp.duration());
            let end = AxisState { q: ramp.end(), speed: to, acceleration: 0.0 };
            prop_assert!(ramp.at(ramp.duration()) == end);
        }
    }

    /// An acceleration beyond its limit, as after the limit was lowered, is reduced first.
    #[test]
    fn takes_back_what_is_too_much() {
        let limits = AxisLimits { speed: 50.0, acceleration: 10.0, jerk: 100.0 };
        for (v, to) in [(5.0, 40.0), (5.0, 0.0), (-5.0, 0.0)] {
            let ramp = Ramp::new(&limits, AxisState { q: 0.0, speed: v, acceleration: 20.0 }, to);
            let AxisState { speed: reached, acceleration: a, .. } = ramp.at(ramp.duration() * (1.0 - 1e-12));
            assert!((reached - to).abs() < 1e-6 && a.abs() < 1e-3, "{v} {to}: {reached} {a}");
        }
    }
}
