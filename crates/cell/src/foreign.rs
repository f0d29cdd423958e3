//! Messages of crates that have only sentences.

use seamwright_message::Message;
use seamwright_tracking::actuator::{Alarm, Cause};
use std::fmt::Display;

/// Message of an error.
pub(crate) fn error(error: &impl Display) -> Message {
    Message::verbatim(error.to_string())
}

/// Message of an alarm of tracking.
pub(crate) fn alarm(alarm: Alarm) -> Message {
    Message::verbatim(alarm.name())
}

/// Message of a fault of a sensor.
pub(crate) fn cause(cause: Cause) -> Message {
    Message::verbatim(cause.name())
}
