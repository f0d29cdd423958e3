//! Messages in the text columns of the library, and in JSON.
//!
//! A column holds a message as JSON, which begins with `{`. Any other text is a sentence: what a person typed, or what an
//! older version wrote.

#[cfg(feature = "library")]
use rusqlite::Row;
#[cfg(feature = "library")]
use seamwright_message::Argument;
use seamwright_message::{Language, Message};
use serde::Serializer;
use serde::ser::SerializeMap;

#[cfg(feature = "library")]
pub(crate) fn written(message: &Message) -> String {
    match (message.code.as_ref(), message.arguments.as_slice()) {
        ("text", [(_, Argument::Text(text))]) if !text.starts_with('{') => text.clone(),
        _ => serde_json::to_string(message).unwrap_or_else(|_| message.in_language(Language::English)),
    }
}

#[cfg(feature = "library")]
pub(crate) fn read(column: String) -> Message {
    let known = if column.starts_with('{') { serde_json::from_str(&column).ok() } else { None };
    known.unwrap_or_else(|| Message::verbatim(column))
}

#[cfg(feature = "library")]
pub(crate) fn column(row: &Row, at: usize) -> rusqlite::Result<Message> {
    row.get(at).map(read)
}

#[cfg(feature = "library")]
pub(crate) fn english<S: Serializer>(message: &Message, out: S) -> Result<S::Ok, S::Error> {
    out.serialize_str(&message.in_language(Language::English))
}

#[cfg(feature = "library")]
/// Serializes the name of an alarm: its English words, and code and arguments.
pub(crate) fn name<S: Serializer>(message: &Message, out: S) -> Result<S::Ok, S::Error> {
    described("name", message, out)
}

/// Serializes the text of an event: its English words, and code and arguments.
pub(crate) fn text<S: Serializer>(message: &Message, out: S) -> Result<S::Ok, S::Error> {
    described("text", message, out)
}

fn described<S: Serializer>(key: &'static str, message: &Message, out: S) -> Result<S::Ok, S::Error> {
    let mut map = out.serialize_map(Some(3))?;
    map.serialize_entry(key, &message.in_language(Language::English))?;
    map.serialize_entry("code", &message.code)?;
    map.serialize_entry("arguments", &message.named_arguments())?;
    map.end()
}

#[cfg(feature = "library")]
/// Joins notes to one message; empty ones are left out.
pub fn joined(notes: impl IntoIterator<Item = Message>) -> Message {
    let notes = notes.into_iter().filter(|note| !note.is_empty());
    let all = notes.reduce(|first, then| Message::new("record-notes").message("first", first).message("then", then));
    all.unwrap_or_default()
}

#[cfg(all(test, feature = "library"))]
mod tests {
    use super::*;
    use seamwright_message::Unit;

    #[test]
    fn a_column_holds_a_message_or_an_old_sentence() {
        let left = Message::new("cell-event-pass-left").pass("pass", 2).quantity("at", 12.5, Unit::Mm, 2);
        let notes = joined([Message::verbatim("typed"), Message::default(), left.clone()]);
        for message in [left, notes, Message::default(), Message::verbatim("as typed"), Message::verbatim("{}")] {
            assert_eq!(read(written(&message)), message);
        }
        assert_eq!(written(&Message::verbatim("as typed")), "as typed");
        assert_eq!(read("pass 1 ends".to_owned()), Message::verbatim("pass 1 ends"));
        assert_eq!(read("{ no message".to_owned()), Message::verbatim("{ no message"));
    }
}
