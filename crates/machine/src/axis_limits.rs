/// Limits of the motion of one axis, or of anything else that moves along one coordinate: the torch tip, a slide.
///
/// In the unit of its positions (mm or rad) per s, s^2 and s^3; the same in both directions. All are greater than 0;
/// infinite without a limit. Those of a machine file are checked when it is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisLimits {
    /// Maximum speed.
    pub speed: f64,
    /// Maximum acceleration.
    pub acceleration: f64,
    /// Maximum jerk.
    pub jerk: f64,
}

impl AxisLimits {
    /// No limits.
    pub const NONE: Self = Self { speed: f64::INFINITY, acceleration: f64::INFINITY, jerk: f64::INFINITY };

    /// All limits times `factor`.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        let Self { speed, acceleration, jerk } = self;
        Self { speed: factor * speed, acceleration: factor * acceleration, jerk: factor * jerk }
    }

    /// All limits divided by `divisor`.
    pub fn divided(self, divisor: f64) -> Self {
        let Self { speed, acceleration, jerk } = self;
        Self { speed: speed / divisor, acceleration: acceleration / divisor, jerk: jerk / divisor }
    }

    /// The lower one of each limit.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        Self {
            speed: self.speed.min(other.speed),
            acceleration: self.acceleration.min(other.acceleration),
            jerk: self.jerk.min(other.jerk),
        }
    }
}
