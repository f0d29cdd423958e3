use super::AxisLimits;

/// One axis from any speed and acceleration to a constant speed, as fast as its acceleration and jerk let it: three
/// stretches of constant jerk, in closed form.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Ramp {
    /// Position, speed and acceleration where each stretch begins.
    begins: [(f64, f64, f64); 4],
    jerks: [f64; 3],
    /// Times at which each stretch ends.
    ends: [f64; 3],
}

/// The state after a time with constant jerk.
fn moved((q, v, a): (f64, f64, f64), j: f64, t: f64) -> (f64, f64, f64) {
    (q + t * (v + t * (a / 2.0 + t * j / 6.0)), v + t * (a + t * j / 2.0), a + t * j)
}

impl Ramp {
    /// From position, speed and acceleration `from` to the speed `to`. An acceleration beyond its limit is taken back.
    pub(super) fn new(limits: &AxisLimits, from: (f64, f64, f64), to: f64) -> Self {
        let (_, v, a) = from;
        let j = limits.jerk;
        // Where the speed goes if the acceleration is only taken away: what is missing then says the way to push.
        let way = if to >= v + a * a.abs() / (2.0 * j) { 1.0 } else { -1.0 };
        let (a, missing) = (way * a, way * (to - v));
        // From a to a peak and from there to 0: (2 peak^2 - a^2) / 2 j is what that changes the speed by.
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
        // What rounding left.
        (ramp.begins[3].1, ramp.begins[3].2) = (to, 0.0);
        ramp
    }

    pub(super) fn duration(&self) -> f64 {
        self.ends[2]
    }

    /// Position where the speed is reached.
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

    /// Lowest and highest position on the way.
    pub(super) fn reach(&self) -> (f64, f64) {
        let mut reach = (self.begins[0].0, self.begins[0].0);
        let mut meets = |q: f64| reach = (reach.0.min(q), reach.1.max(q));
        for i in 0..3 {
            let (begin, j) = (self.begins[i], self.jerks[i]);
            let length = self.ends[i] - if i == 0 { 0.0 } else { self.ends[i - 1] };
            let (_, v, a) = begin;
            // The axis turns round where v + a t + j t^2 / 2 = 0: both roots without cancellation.
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

    /// The highest speed, of either sign, between two times from 0 on.
    pub(super) fn greatest_speed(&self, from: f64, to: f64) -> f64 {
        // The acceleration passes 0 at most once: in the first stretch.
        let (_, _, a) = self.begins[0];
        let turn = -a / self.jerks[0];
        let ends = self.at(from).1.abs().max(self.at(to).1.abs());
        if turn > from && turn < to && turn < self.ends[0] { ends.max(self.at(turn).1.abs()) } else { ends }
    }
}
