use crate::wire::EventView;
use seamwright_log::{self as log, Level};
use seamwright_message::Message;

/// Kinds of events by the codes of their messages.
const KINDS: [(&str, &str); 46] = [
    ("server-event-mode", "mode"),
    ("server-event-order", "order"),
    ("server-event-refused", "refused"),
    ("server-event-alarm", "alarm"),
    ("server-event-alarm-of", "alarm"),
    ("server-event-alarm-before", "alarm"),
    ("server-event-cleared", "cleared"),
    ("server-event-cleared-of", "cleared"),
    ("server-event-shelved", "alarm"),
    ("server-event-unshelved", "alarm"),
    ("server-event-machine-changed", "work"),
    ("server-event-tool-changed", "work"),
    ("server-event-frame-changed", "work"),
    ("server-event-sensor-changed", "work"),
    ("server-event-pass-ends", "pass"),
    ("server-event-left", "left"),
    ("server-event-left-before", "left"),
    ("server-event-stopped-by", "alarm"),
    ("server-event-cycles-missed", "alarm"),
    ("server-event-no-realtime", "alarm"),
    ("server-event-cell-lost", "alarm"),
    ("server-event-cell-restarted", "alarm"),
    ("server-event-cell-found", "work"),
    ("server-event-cell-not-restarted", "alarm"),
    ("server-event-safe-unconfirmed", "alarm"),
    ("server-event-safe-by-panel", "alarm"),
    ("server-event-journal-damaged", "alarm"),
    ("server-event-weld-lost", "record"),
    ("server-event-recorded", "record"),
    ("server-event-record-not-whole", "record"),
    ("server-event-record-interrupted", "record"),
    ("server-event-record-fails", "record"),
    ("server-event-not-recorded", "record"),
    ("server-event-audit-fails", "alarm"),
    ("server-event-audit-hangs", "alarm"),
    ("server-event-audit-left-out", "alarm"),
    ("server-event-audit-stored", "record"),
    ("server-event-syslog-fails", "record"),
    ("server-event-syslog-sends", "record"),
    ("server-event-restored", "record"),
    ("server-event-control-taken", "control"),
    ("server-event-control-taken-over", "control"),
    ("server-event-control-lost", "control"),
    ("server-event-loaded", "work"),
    ("server-event-not-loaded", "work"),
    ("server-event-teach-ended", "teach"),
];

/// Events that are failures: data are lost, or outputs are not known to be safe.
const FAILURES: [&str; 7] = [
    "server-event-safe-unconfirmed",
    "server-event-journal-damaged",
    "server-event-weld-lost",
    "server-event-record-not-whole",
    "server-event-record-fails",
    "server-event-not-recorded",
    "server-event-audit-fails",
];

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
    KINDS.iter().find(|(code, _)| *code == message.code)
}

impl Happening {
    pub(crate) fn by(self, user: Option<String>) -> Self {
        Self { user, ..self }
    }

    /// Writes it to the log.
    pub(super) fn log(&self) {
        log::event(self.level(), &self.message, self.user.as_deref());
    }

    fn level(&self) -> Level {
        match (&*self.message.code, kind(&self.message).map(|(_, what)| *what)) {
            ("server-event-shelved" | "server-event-unshelved", _) => Level::Info,
            (code, _) if FAILURES.contains(&code) => Level::Error,
            (_, Some("alarm")) => Level::Warn,
            // They may be many.
            (_, Some("refused")) => Level::Debug,
            _ => Level::Info,
        }
    }

    pub(super) fn view(self, number: u64, t: f64, at: String) -> EventView {
        let (key, what) = kind(&self.message).copied().unwrap_or(KINDS[1]);
        let key = key.splitn(3, '-').nth(2).unwrap_or_default().replace('-', "_");
        let what = what.to_owned();
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
            assert!(Catalogue::of(Language::English).has(code), "{code}");
        }
        let loaded = happening(Message::new("server-event-loaded").text("job", "{ $job }"));
        let view = loaded.by(Some("ada".to_owned())).view(7, 1.5, String::new());
        assert_eq!((view.key.as_str(), view.what.as_str()), ("loaded", "work"));
        assert_eq!(view.message.text, "loaded: { $job }");
    }
}
