use super::Error;
use seamwright_machine::{PulseTicks, Stepper};

/// Maximum ticks of a period: products with a step's fractions stay within 64 bits.
const MAX_PERIOD_TICKS: u64 = 1 << 38;

/// A driver's times in ticks of the timer, each rounded so that the driver's limit holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Timing {
    /// Ticks of a period.
    pub period: u64,
    /// The step line is high for this long, and low for at least as long.
    pub width: u64,
    /// Minimum distance of rising edges.
    pub spacing: u64,
    /// Minimum time from a change of direction to the next rising edge.
    pub setup: u64,
    /// Minimum time from a falling edge to a change of direction.
    pub hold: u64,
}

impl Timing {
    /// Computes the times of `stepper` on a timer with ticks of `tick_s` (s), for periods of `period` ticks.
    ///
    /// # Errors
    /// [`Error::Period`].
    pub fn new(stepper: &Stepper, tick_s: f64, period: u64) -> Result<Self, Error> {
        check_period(period)?;
        let PulseTicks { width, spacing, setup, hold } = stepper.ticks(tick_s);
        Ok(Self { period, width, spacing, setup, hold })
    }

    /// Maximum pulse frequency, Hz, with ticks of `tick_s` (s): the driver's, or less on a coarse timer.
    pub fn max_hz(&self, tick_s: f64) -> f64 {
        1.0 / tick_s / self.spacing as f64
    }
}

/// Refuses a period of 0 ticks, and one whose products would not be exact.
pub(super) fn check_period(ticks: u64) -> Result<(), Error> {
    if (1..=MAX_PERIOD_TICKS).contains(&ticks) { Ok(()) } else { Err(Error::Period { ticks }) }
}
