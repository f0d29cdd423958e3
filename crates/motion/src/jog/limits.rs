use seamwright_machine::Axis;

/// Limits of one axis, mm or rad and s; all greater than 0 and finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisLimits {
    /// Maximum speed.
    pub speed: f64,
    /// Maximum acceleration.
    pub acceleration: f64,
    /// Maximum jerk.
    pub jerk: f64,
    /// Minimum and maximum position; infinite on a continuous axis.
    pub range: (f64, f64),
}

impl From<&Axis> for AxisLimits {
    fn from(axis: &Axis) -> Self {
        let range = axis.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        Self { speed: axis.max_speed, acceleration: axis.max_acceleration, jerk: axis.jerk(), range }
    }
}

impl AxisLimits {
    /// Guaranteed stopping distance, mm or rad: an upper bound of the fastest stop's distance from any state within the
    /// limits with this speed (of either sign).
    ///
    /// Closed form. The worst acceleration is the maximum from which the maximum speed is not exceeded: it is reduced
    /// to 0 at full jerk, and the resulting speed is then braked. An axis that is slow for its acceleration may travel
    /// farther backwards; that is then the worst case.
    pub fn stopping_distance(&self, speed: f64) -> f64 {
        let (v, top, a, j) = (speed.abs().min(self.speed), self.speed, self.acceleration, self.jerk);
        let onwards = self.accelerating(v, a.min((2.0 * j * (top - v)).sqrt()));
        // Against the motion: the remaining acceleration at the reversal of the axis.
        let back = (0.5 * a * a / j - v).clamp(0.0, top);
        onwards.max(self.accelerating(0.0, (2.0 * j * back).sqrt()))
    }

    /// Guaranteed stopping distance at any speed up to the maximum.
    pub fn greatest_stopping_distance(&self) -> f64 {
        // The distance grows with the speed up to the point at which the maximum acceleration just fits; beyond, it may
        // fall again.
        let corner = (self.speed - 0.5 * self.acceleration.powi(2) / self.jerk).max(0.0);
        self.stopping_distance(self.speed).max(self.stopping_distance(corner)).max(self.stopping_distance(0.0))
    }

    /// Distance of the fastest stop from speed `v` and acceleration `a`, both forwards.
    fn accelerating(&self, v: f64, a: f64) -> f64 {
        let (most, j) = (self.acceleration, self.jerk);
        let rise = a / j;
        let risen = v * rise + a * rise * rise / 3.0;
        let v = v + 0.5 * a * rise;
        let full = most / j;
        risen + if v >= most * full { 0.5 * v * (v / most + full) } else { v * (v / j).sqrt() }
    }
}
