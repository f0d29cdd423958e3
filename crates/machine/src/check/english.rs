//! Messages as English text, for JSON.

use seamwright_message::{Language, Message};
use serde::{Serialize, Serializer};

/// Writes the English text of a message.
pub(super) fn one<S: Serializer>(message: &Message, serializer: S) -> Result<S::Ok, S::Error> {
    message.in_language(Language::English).serialize(serializer)
}

/// Writes the English texts of messages.
pub(super) fn list<S: Serializer>(messages: &[Message], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(messages.iter().map(|message| message.in_language(Language::English)))
}
