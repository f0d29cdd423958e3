use seamwright_machine::AxisLimits;
use serde::{Deserialize, Serialize};

/// Time-optimal motion from 0 to 1, rest to rest, within a speed, an acceleration and a jerk limit: up to seven phases
/// of constant jerk, symmetric in time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct RestToRest {
    jerk: f64,
    /// Speed of the cruise phase, 1/s.
    speed: f64,
    /// Durations: of constant jerk (four times), of constant acceleration (twice), of constant speed.
    times: [f64; 3],
}

impl RestToRest {
    /// Plans with limits in 1/s, 1/s^2 and 1/s^3; infinite limits give a motion of zero duration.
    pub(super) fn new(limits: AxisLimits) -> Self {
        let AxisLimits { speed: v, acceleration: a, jerk: j } = limits;
        if !(v.is_finite() && a.is_finite() && j.is_finite()) {
            return Self { jerk: 0.0, speed: 0.0, times: [0.0; 3] };
        }
        // Acceleration to a speed w and deceleration from it cover w (w / a + a / j) if the full acceleration is
        // reached, that is if w > a^2 / j, else 2 w sqrt(w / j). Short moves never reach the full speed.
        let ramp = a / j;
        let full = 0.5 * a * ((ramp * ramp + 4.0 / a).sqrt() - ramp);
        let highest = if full > a * ramp { full } else { (0.25 * j).cbrt() };
        let speed = v.min(highest);
        let (with_jerk, with_acceleration) =
            if speed > a * ramp { (ramp, speed / a - ramp) } else { ((speed / j).sqrt(), 0.0) };
        let with_speed = (1.0 / speed - 2.0 * with_jerk - with_acceleration).max(0.0);
        Self { jerk: j, speed, times: [with_jerk, with_acceleration, with_speed] }
    }

    /// No motion for `time` (s), then at the end.
    pub(super) fn resting(time: f64) -> Self {
        Self { jerk: 0.0, speed: 0.0, times: [0.0, 0.0, time] }
    }

    pub(super) fn duration(&self) -> f64 {
        let [with_jerk, with_acceleration, with_speed] = self.times;
        4.0 * with_jerk + 2.0 * with_acceleration + with_speed
    }

    /// Position, speed (1/s) and acceleration (1/s^2) at time `t` (s).
    pub(super) fn at(&self, t: f64) -> (f64, f64, f64) {
        let left = self.duration() - t;
        if left <= 0.0 {
            (1.0, 0.0, 0.0)
        } else if t <= 0.0 {
            (0.0, 0.0, 0.0)
        } else if left < t {
            let (s, v, a) = self.first_half(left);
            (1.0 - s, v, -a)
        } else {
            self.first_half(t)
        }
    }

    /// Third derivative at time `t` (s), 1/s^3; at a jump, the value of the side before or after.
    pub(super) fn jerk(&self, t: f64, before: bool) -> f64 {
        let signs = [1.0, 0.0, -1.0, 0.0, -1.0, 0.0, 1.0];
        let passed = self.borders().iter().filter(|b| if before { **b < t } else { **b <= t }).count();
        passed.checked_sub(1).and_then(|i| signs.get(i)).map_or(0.0, |sign| sign * self.jerk)
    }

    /// Times at which the third derivative may jump, s.
    pub(super) fn borders(&self) -> [f64; 8] {
        let [t1, t2, t3] = self.times;
        let mut t = 0.0;
        let mut borders = [0.0; 8];
        for (border, stretch) in borders[1..].iter_mut().zip([t1, t2, t1, t3, t1, t2, t1]) {
            t += stretch;
            *border = t;
        }
        borders
    }

    fn first_half(&self, t: f64) -> (f64, f64, f64) {
        let ([t1, t2, _], j, v) = (self.times, self.jerk, self.speed);
        let run_up = 2.0 * t1 + t2;
        if t < t1 {
            (j * t.powi(3) / 6.0, 0.5 * j * t * t, j * t)
        } else if t < t1 + t2 {
            // Integrated twice from the middle of the build-up, the equivalent start of a linear rise.
            let (a, u) = (j * t1, t - 0.5 * t1);
            (0.5 * a * (u * u + t1 * t1 / 12.0), a * u, a)
        } else if t < run_up {
            let u = run_up - t;
            (v * (0.5 * run_up - u) + j * u.powi(3) / 6.0, v - 0.5 * j * u * u, j * u)
        } else {
            (v * (t - 0.5 * run_up), v, 0.0)
        }
    }
}
