use crate::wire::EventView;
use seamwright_message::Message;

/// Start of the codes of events.
const EVENT: &str = "server-event-";

/// Kinds of events by the rest of their codes.
const KINDS: [(&str, &str); 35] = [
    ("mode", "mode"),
    ("order", "order"),
    ("refused", "refused"),
    ("alarm", "alarm"),
    ("alarm-of", "alarm"),
    ("alarm-before", "alarm"),
    ("cleared", "cleared"),
    ("cleared-of", "cleared"),
    ("shelved", "alarm"),
    ("unshelved", "alarm"),
    ("machine-changed", "work"),
    ("tool-changed", "work"),
    ("sensor-changed", "work"),
    ("pass-ends", "pass"),
    ("left", "left"),
    ("left-before", "left"),
    ("stopped-by", "alarm"),
    ("cycles-missed", "alarm"),
    ("no-realtime", "alarm"),
    ("safe-unconfirmed", "alarm"),
    ("journal-damaged", "alarm"),
    ("weld-lost", "record"),
    ("recorded", "record"),
    ("record-not-whole", "record"),
    ("record-interrupted", "record"),
    ("record-fails", "record"),
    ("not-recorded", "record"),
    ("audit-fails", "record"),
    ("restored", "record"),
    ("control-taken", "control"),
    ("control-taken-over", "control"),
    ("control-lost", "control"),
    ("loaded", "work"),
    ("not-loaded", "work"),
    ("teach-ended", "teach"),
];

/// An event.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Happening {
    message: Message,
    /// User who caused it, if any.
    user: Option<String>,
}

/// Creates an event from its message, whose code has a kind in the table.
pub(crate) fn happening(message: Message) -> Happening {
    debug_assert!(kind(&message).is_some(), "{} has no kind", message.code);
    Happening { message, user: None }
}

fn kind(message: &Message) -> Option<&'static (&'static str, &'static str)> {
    let rest = message.code.strip_prefix(EVENT)?;
    KINDS.iter().find(|(code, _)| *code == rest)
}

impl Happening {
    pub(crate) fn by(self, user: Option<String>) -> Self {
        Self { user, ..self }
    }

    /// Returns the event's view with its number and times.
    pub(super) fn view(self, number: u64, t: f64, at: String) -> EventView {
        let (key, what) = kind(&self.message).copied().unwrap_or(KINDS[1]);
        let (key, what) = (key.replace('-', "_"), what.to_owned());
        EventView { number, t, at, what, key, message: self.message.into(), user: self.user }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_message::{Catalogue, Language};

    #[test]
    fn every_event_has_a_kind_and_words() {
        for (i, (code, _)) in KINDS.iter().enumerate() {
            assert!(KINDS[..i].iter().all(|row| row.0 != *code), "{code}");
            assert!(Catalogue::of(Language::English).has(&format!("{EVENT}{code}")), "{code}");
        }
        let loaded = happening(Message::new("server-event-loaded").text("job", "{ $job }"));
        let view = loaded.by(Some("ada".to_owned())).view(7, 1.5, String::new());
        assert_eq!((view.key.as_str(), view.what.as_str()), ("loaded", "work"));
        assert_eq!(view.message.text, "loaded: { $job }");
    }
}
