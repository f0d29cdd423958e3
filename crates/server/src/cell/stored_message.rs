//! Messages in the text columns of the audit log: JSON of code, arguments and English text, which begins with `{`. Any
//! other text is shown as it is: what an older version wrote.

use super::audit_entry::plain;
use seamwright_message::{Argument, Language, Message};
use serde::Serialize;

/// A message with its English text: the log is evidence, also without the catalogues of the version that wrote it.
#[derive(Serialize)]
struct Evidence<'a> {
    #[serde(flatten)]
    message: &'a Message,
    text: String,
}

/// Returns the text of a column for `message`, as one line in which hidden characters are escaped.
pub(super) fn stored(message: Message) -> String {
    match (message.code.as_ref(), message.arguments.as_slice()) {
        ("text", [(_, Argument::Text(text))]) if !text.starts_with('{') => plain(text),
        _ => {
            let message = escaped(message);
            let evidence = Evidence { message: &message, text: message.in_language(Language::English) };
            serde_json::to_string(&evidence).unwrap_or_else(|_| plain(&message.as_data()))
        }
    }
}

/// Returns the message of a column; the columns of some versions have no English text.
pub(crate) fn from_stored(column: String) -> Message {
    let known = if column.starts_with('{') { serde_json::from_str(&column).ok() } else { None };
    known.unwrap_or_else(|| Message::verbatim(column))
}

fn escaped(mut message: Message) -> Message {
    message.arguments.iter_mut().for_each(|(_, argument)| escape(argument));
    message
}

fn escape(argument: &mut Argument) {
    match argument {
        Argument::Axis(text) | Argument::Key(text) | Argument::Text(text) => *text = plain(text),
        Argument::Message(message) => **message = escaped((**message).clone()),
        Argument::List(items) => items.iter_mut().for_each(escape),
        Argument::Quantity(_) | Argument::Range(..) | Argument::Count(_) | Argument::Pass(_) => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_holds_a_message_or_an_old_sentence() {
        let load = Message::new("server-audit-load").text("job", "a.toml");
        for message in [load, Message::verbatim("as typed"), Message::verbatim("{}"), Message::default()] {
            assert_eq!(from_stored(stored(message.clone())), message);
        }
        assert_eq!(from_stored("load a.toml".to_owned()), Message::verbatim("load a.toml"));
        let load = Message::new("server-audit-load").text("job", "a.toml");
        assert_eq!(from_stored(serde_json::to_string(&load).unwrap()), load);
        let column: serde_json::Value = serde_json::from_str(&stored(load.clone())).unwrap();
        assert_eq!(column["text"], load.in_language(Language::English));
        let hidden = stored(Message::new("server-audit-load").text("job", "a\u{202e}\nb"));
        assert_eq!(from_stored(hidden).argument("job"), Some(&Argument::Text("a\\u{202e}\\nb".to_owned())));
    }
}
