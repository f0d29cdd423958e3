use crate::executive::Orders;

/// Homing time of a drive, s.
const REFERENCE_S: f64 = 0.5;
/// Position error before homing, mm or rad.
pub const UNREFERENCED_ERROR: f64 = 0.37;
/// Time from switch-on until drives have power, s.
const POWER_S: f64 = 0.1;

/// Power and references of drives that have none of their own: they come a moment after the order.
#[derive(Debug, Clone)]
pub struct PowerState {
    period: f64,
    powered_for: f64,
    homing_for: f64,
    referenced: bool,
}

impl PowerState {
    /// Creates the state without power and references; `period` in s.
    #[must_use]
    pub fn new(period: f64) -> Self {
        Self { period, powered_for: 0.0, homing_for: 0.0, referenced: false }
    }

    /// Advances by one period. Returns whether the drives have power, and whether they follow set-points.
    pub fn step(&mut self, orders: &Orders) -> (bool, bool) {
        self.powered_for = if orders.power { self.powered_for + self.period } else { 0.0 };
        let powered = self.powered_for >= POWER_S;
        self.homing_for = if powered && orders.home { self.homing_for + self.period } else { 0.0 };
        self.referenced |= self.homing_for >= REFERENCE_S;
        // During homing a drive holds its position.
        (powered, powered && !orders.home)
    }

    /// Returns true once the drives know their references.
    #[must_use]
    pub fn is_referenced(&self) -> bool {
        self.referenced
    }
}
