//! Messages as English text, for JSON.

use seamwright_message::{Language, Message};
use serde::{Serialize, Serializer};

pub(super) fn one<S: Serializer>(message: &Message, serializer: S) -> Result<S::Ok, S::Error> {
    message.in_language(Language::English).serialize(serializer)
}

pub(super) fn list<S: Serializer>(messages: &[Message], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(messages.iter().map(|message| message.in_language(Language::English)))
}
