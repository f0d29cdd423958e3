use seamwright_program::{ArcTime, Pass};

/// Process values that robot languages have words for.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WeldValues {
    /// Current, A.
    pub current_a: f64,
    /// Voltage, V.
    pub voltage_v: f64,
    /// Wire feed, m/min.
    pub wire_feed_m_min: f64,
}

/// Names of the values in programs, in the order of [`WeldValues::all`].
pub(crate) const NAMES: [&str; 3] = ["current_a", "voltage_v", "wire_feed_m_min"];

impl WeldValues {
    /// The values of `pass` at path length `s` while it travels; 0 for those that it does not have.
    pub(crate) fn of(pass: &Pass, s: f64) -> Self {
        let value = |name: &str| {
            let value = pass.process_at(name, s, ArcTime::TRAVEL).unwrap_or(0.0);
            (value * 1e3).round() / 1e3
        };
        Self { current_a: value(NAMES[0]), voltage_v: value(NAMES[1]), wire_feed_m_min: value(NAMES[2]) }
    }

    /// All values, in the order of [`NAMES`].
    pub(crate) fn all(&self) -> [f64; 3] {
        [self.current_a, self.voltage_v, self.wire_feed_m_min]
    }
}
