use seamwright_machine::Axis;

/// What one axis can do, mm or rad and s; all greater than 0 and finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisLimits {
    /// Highest speed.
    pub speed: f64,
    /// Highest acceleration.
    pub acceleration: f64,
    /// Highest jerk.
    pub jerk: f64,
    /// Lowest and highest position; infinite on a continuous axis.
    pub range: (f64, f64),
}

impl From<&Axis> for AxisLimits {
    fn from(axis: &Axis) -> Self {
        let range = axis.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        Self { speed: axis.max_speed, acceleration: axis.max_acceleration, jerk: axis.jerk(), range }
    }
}

impl AxisLimits {
    /// The promised stopping distance: no fastest stop from a state within the limits with this speed (of either sign)
    /// takes the axis farther from where it is, mm or rad.
    ///
    /// Closed form. The worst acceleration is the highest from which the highest speed is not passed; it is taken away
    /// at full jerk, and what speed there is then braked. Only if the axis is slow for its acceleration can it go
    /// farther backwards: then that is the worst.
    pub fn stopping_distance(&self, speed: f64) -> f64 {
        let (v, top, a, j) = (speed.abs().min(self.speed), self.speed, self.acceleration, self.jerk);
        let onwards = self.accelerating(v, a.min((2.0 * j * (top - v)).sqrt()));
        // Against the motion: what is left of the acceleration where the axis turns round.
        let back = (0.5 * a * a / j - v).clamp(0.0, top);
        onwards.max(self.accelerating(0.0, (2.0 * j * back).sqrt()))
    }

    /// The same at the highest speed or any lower one.
    pub fn greatest_stopping_distance(&self) -> f64 {
        // The distance grows with the speed up to where the highest acceleration just fits; beyond, it may fall again.
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
