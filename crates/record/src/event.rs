use crate::moment::Moment;
use crate::stored_message;
use seamwright_message::Message;
use serde::{Deserialize, Serialize};

/// Position and time in a weld.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Place {
    /// The pass, counted from 1.
    pub pass: Option<u32>,
    /// Path length, mm.
    pub s_mm: Option<f64>,
    /// Time in the trace, s.
    pub t_s: Option<f64>,
}

/// An event that is no alarm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Event {
    /// Time.
    #[serde(serialize_with = "crate::moment::written")]
    pub at: Moment,
    /// Description.
    #[serde(flatten, serialize_with = "stored_message::text")]
    pub text: Message,
    /// Position.
    #[serde(flatten)]
    pub place: Place,
}
