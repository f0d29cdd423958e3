use super::AxisLimits;

/// Time-optimal change of one axis from any speed and acceleration to a constant speed within its acceleration and
/// jerk: three phases of constant jerk, in closed form.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Ramp {
    /// Position, speed and acceleration at the start of each phase.
    begins: [(f64, f64, f64); 4],
    jerks: [f64; 3],
    /// End time of each phase.
    ends: [f64; 3],
}

/// The state after a time with constant jerk.
fn moved((q, v, a): (f64, f64, f64), j: f64, t: f64) -> (f64, f64, f64) {
    (q + t * (v + t * (a / 2.0 + t * j / 6.0)), v + t * (a + t * j / 2.0), a + t * j)
}

impl Ramp {
    /// Plans from position, speed and acceleration `from` to the speed `to`. An acceleration beyond its limit is
    /// reduced.
    pub(super) fn new(limits: &AxisLimits, from: (f64, f64, f64), to: f64) -> Self {
        let (_, v, a) = from;
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
            ramp.begins[i + 1] = moved(ramp.begins[i], jerks[i], times[i]);
        }
        // Removes the rounding of the end.
        (ramp.begins[3].1, ramp.begins[3].2) = (to, 0.0);
        ramp
    }

    pub(super) fn duration(&self) -> f64 {
        self.ends[2]
    }

    /// Position at which the speed is reached.
    pub(super) fn end(&self) -> f64 {
        self.begins[3].0
    }

    /// Position, speed and acceleration at time `t`, from 0 on.
    pub(super) fn at(&self, t: f64) -> (f64, f64, f64) {
        match self.ends.iter().position(|end| t < *end) {
            Some(i) => moved(self.begins[i], self.jerks[i], t - if i == 0 { 0.0 } else { self.ends[i - 1] }),
            None => moved(self.begins[3], 0.0, t - self.ends[2]),
        }
    }

    /// Minimum and maximum position during the change.
    pub(super) fn reach(&self) -> (f64, f64) {
        let mut reach = (self.begins[0].0, self.begins[0].0);
        let mut meets = |q: f64| reach = (reach.0.min(q), reach.1.max(q));
        for i in 0..3 {
            let (begin, j) = (self.begins[i], self.jerks[i]);
            let length = self.ends[i] - if i == 0 { 0.0 } else { self.ends[i - 1] };
            let (_, v, a) = begin;
            // The axis reverses where v + a t + j t^2 / 2 = 0: both roots without cancellation.
            let root = (a * a - 2.0 * j * v).max(0.0).sqrt();
            let sum = -(a + root.copysign(a));
            for t in [sum / j, 2.0 * v / sum] {
                if t > 0.0 && t < length {
                    meets(moved(begin, j, t).0);
                }
            }
            meets(self.begins[i + 1].0);
        }
        reach
    }

    /// Maximum absolute speed between two times from 0 on.
    pub(super) fn greatest_speed(&self, from: f64, to: f64) -> f64 {
        // The acceleration passes 0 at most once: in the first stretch.
        let (_, _, a) = self.begins[0];
        let turn = -a / self.jerks[0];
        let ends = self.at(from).1.abs().max(self.at(to).1.abs());
        if turn > from && turn < to && turn < self.ends[0] { ends.max(self.at(turn).1.abs()) } else { ends }
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
            let range = (f64::NEG_INFINITY, f64::INFINITY);
            let limits = AxisLimits { speed: 50.0, acceleration, jerk, range };
            let a = a * acceleration;
            let ramp = Ramp::new(&limits, (3.0, v, a), to);
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
                let (q, v, a) = ramp.at(t);
                prop_assert!(q >= low - 1e-9 && q <= high + 1e-9 && a.abs() <= acceleration * (1.0 + 1e-9));
                let mut theirs = DataArrayOrVec::new(None, 0.0);
                found.at_time(t, &mut Some(&mut theirs), &mut None, &mut None, &mut None, &mut None);
                prop_assert!((theirs[0] - q).abs() < 1e-7 * (1.0 + high - low));
                (least, most_far) = (least.min(q), most_far.max(q));
                let jumps = jerk * 1e-3 * ramp.duration() * (1.0 + 1e-6) + 1e-9;
                prop_assert!((a - last.2).abs() <= jumps);
                last = (q, v, a);
                if t >= begin && t <= end {
                    prop_assert!(v.abs() <= most * (1.0 + 1e-12) + 1e-12);
                    sampled = sampled.max(v.abs());
                }
            }
            // A turn between two samples is a parabola.
            let missed = acceleration * (1e-3 * ramp.duration()).powi(2) + 1e-9;
            prop_assert!(least - low < missed && high - most_far < missed);
            prop_assert!(most <= sampled + 2e-3 * acceleration * ramp.duration());
            prop_assert!(ramp.at(ramp.duration()) == (ramp.end(), to, 0.0));
        }
    }

    /// An acceleration beyond its limit, as after the limit was lowered, is reduced first.
    #[test]
    fn takes_back_what_is_too_much() {
        let range = (f64::NEG_INFINITY, f64::INFINITY);
        let limits = AxisLimits { speed: 50.0, acceleration: 10.0, jerk: 100.0, range };
        for (v, to) in [(5.0, 40.0), (5.0, 0.0), (-5.0, 0.0)] {
            let ramp = Ramp::new(&limits, (0.0, v, 20.0), to);
            let (_, reached, a) = ramp.at(ramp.duration() * (1.0 - 1e-12));
            assert!((reached - to).abs() < 1e-6 && a.abs() < 1e-3, "{v} {to}: {reached} {a}");
        }
    }
}
