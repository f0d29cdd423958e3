use super::case::Case;
use super::expected::{Expected, expected};
use seamwright_executive::{Alarm, Mode, Place};
use seamwright_message::Message;

/// Result of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// Mode of the cell some seconds later.
    pub mode: Mode,
    /// First alarm after the fault.
    pub first_alarm: Option<Alarm>,
    /// Cycles from an alarm with process off to the off order; 0 without such an alarm while the process is on.
    pub off_cycles: u32,
    /// Path length from the alarm to rest, mm.
    pub stop_mm: f64,
    /// Stop distance relative to its bound from the axes' limits; more than 1 is a violation.
    pub stop_part: f64,
    /// Position at which a weld was left.
    pub left: Option<Place>,
    /// The situation was reached.
    pub reached: bool,
    /// Violated requirements.
    pub violations: Vec<Message>,
}

impl Outcome {
    /// Returns true if the result is as required.
    pub fn is_kept(&self) -> bool {
        let Expected { mode, alarm } = expected(self.case);
        self.reached && self.mode == mode && self.first_alarm == alarm && self.violations.is_empty()
    }
}
