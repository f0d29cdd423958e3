/// Instant while the arc (or beam) is on, by the times at which it is switched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcTime {
    /// Time since the arc went on, s.
    pub since_on_s: f64,
    /// Time until the arc goes off, s; infinite if unknown.
    pub until_off_s: f64,
}

impl ArcTime {
    /// Any instant of the travel: after the upslope and before the downslope.
    pub const TRAVEL: Self = Self { since_on_s: f64::INFINITY, until_off_s: f64::INFINITY };
}
