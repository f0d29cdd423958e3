/// Limits of the torch tip's motion against the work along a path. Infinite if the machine file has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TipLimits {
    /// Maximum speed, mm/s.
    pub speed: f64,
    /// Maximum acceleration in any direction, mm/s^2: centripetal and tangential.
    pub acceleration: f64,
    /// Maximum jerk in any direction, mm/s^3.
    pub jerk: f64,
}

impl TipLimits {
    /// No limits.
    pub const NONE: Self = Self { speed: f64::INFINITY, acceleration: f64::INFINITY, jerk: f64::INFINITY };
}
