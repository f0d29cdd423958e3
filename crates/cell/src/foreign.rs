//! Messages of crates that have only sentences.

use seamwright_message::Message;
use std::fmt::Display;

/// Message of an error.
pub(crate) fn error(error: &impl Display) -> Message {
    Message::verbatim(error.to_string())
}
