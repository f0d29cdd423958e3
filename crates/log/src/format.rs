use crate::event::Arguments;
use seamwright_message::{Argument, Language, Message, named_enum};
use serde_json::{Map, Value};
use std::fmt::{self, Debug, Write as _};
use tracing::field::{Field, Visit};
use tracing::{Event, Level, Subscriber};
use tracing_subscriber::fmt::format::Writer;
use tracing_subscriber::fmt::time::{FormatTime as _, SystemTime};
use tracing_subscriber::fmt::{FmtContext, FormatEvent, FormatFields};
use tracing_subscriber::registry::LookupSpan;

named_enum! {
    /// Format of the lines.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Format {
        /// Time, level, words, then the other fields.
        Text => "text",
        /// A JSON object a line: `time`, `level`, `code`, `arguments`, `user`, `text`.
        Json => "json",
        /// Text for the journal of systemd: the level as its priority, and no time, which the journal adds.
        Journal => "journal",
    }
}

/// Writes an event as one line.
pub(crate) struct Lines {
    pub(crate) format: Format,
}

/// Name of the field with the words.
const TEXT: &str = "message";
/// Name of the field with the arguments, a JSON object.
const ARGUMENTS: &str = "arguments";

impl<S, N> FormatEvent<S, N> for Lines
where
    S: Subscriber + for<'a> LookupSpan<'a>,
    N: for<'a> FormatFields<'a> + 'static,
{
    fn format_event(&self, _: &FmtContext<'_, S, N>, mut writer: Writer<'_>, event: &Event<'_>) -> fmt::Result {
        let mut fields = Fields::default();
        event.record(&mut fields);
        writer.write_str(&self.format.line(*event.metadata().level(), fields))
    }
}

impl Format {
    fn line(self, level: Level, fields: Fields) -> String {
        let mut time = String::new();
        // Writing to a string cannot fail.
        let _ = SystemTime.format_time(&mut Writer::new(&mut time));
        match self {
            Self::Text => format!("{time} {level:5} {}\n", fields.line()),
            Self::Journal => format!("<{}>{}\n", priority(level), fields.line()),
            Self::Json => format!("{}\n", fields.json(time, level)),
        }
    }

    /// Returns the line that reports the number of lines left out.
    pub(crate) fn left_out(self, count: u64) -> String {
        let message = Message::new("server-log-left-out").with("n", Argument::Count(count));
        let others = vec![("code", message.code.to_string()), (ARGUMENTS, Arguments(&message).to_string())];
        self.line(Level::WARN, Fields { text: message.in_language(Language::English), others })
    }
}

/// Returns the priority of syslog.
fn priority(level: Level) -> u8 {
    match level {
        Level::ERROR => 3,
        Level::WARN => 4,
        Level::INFO => 6,
        _ => 7,
    }
}

/// Words and other fields of an event, in their order.
#[derive(Default)]
struct Fields {
    text: String,
    others: Vec<(&'static str, String)>,
}

impl Visit for Fields {
    fn record_str(&mut self, field: &Field, value: &str) {
        self.record_debug(field, &format_args!("{value}"));
    }

    fn record_debug(&mut self, field: &Field, value: &dyn Debug) {
        let value = format!("{value:?}");
        match field.name() {
            TEXT => self.text = value,
            name => self.others.push((name, value)),
        }
    }
}

impl Fields {
    fn json(self, time: String, level: Level) -> Value {
        let mut object = Map::new();
        object.insert("time".to_owned(), time.into());
        object.insert("level".to_owned(), level.as_str().to_lowercase().into());
        for (name, value) in self.others {
            let arguments = if name == ARGUMENTS { serde_json::from_str(&value).ok() } else { None };
            object.insert(name.to_owned(), arguments.unwrap_or_else(|| value.into()));
        }
        object.insert("text".to_owned(), self.text.into());
        Value::Object(object)
    }

    /// One line: controls in foreign text neither start another line nor change the terminal.
    fn line(self) -> String {
        let mut line = self.text;
        for (name, value) in self.others.iter().filter(|(_, value)| value != "{}") {
            // Writing to a string cannot fail.
            let _ = write!(line, " {name}={value}");
        }
        let mut plain = String::with_capacity(line.len());
        for c in line.chars() {
            match c {
                c if hides(c) => plain.extend(c.escape_default()),
                c => plain.push(c),
            }
        }
        plain
    }
}

/// Returns true for invisible characters and those that change the look of text.
fn hides(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Level as Ours, event};
    use seamwright_message::Unit;
    use std::io;
    use std::sync::{Arc, Mutex};
    use tracing_subscriber::filter::LevelFilter;

    #[derive(Clone, Default)]
    struct Kept(Arc<Mutex<Vec<u8>>>);

    impl io::Write for Kept {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0.lock().unwrap().extend_from_slice(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    fn written(format: Format, logs: impl FnOnce()) -> String {
        let kept = Kept::default();
        let to = kept.clone();
        let subscriber = tracing_subscriber::fmt()
            .with_max_level(LevelFilter::INFO)
            .event_format(Lines { format })
            .with_writer(move || to.clone())
            .finish();
        tracing::subscriber::with_default(subscriber, logs);
        String::from_utf8(kept.0.lock().unwrap().clone()).unwrap()
    }

    fn gap() -> Message {
        let message = Message::new("server-event-cycles-missed").count("cycles", 3);
        message.quantity("longest", 12.5, Unit::Ms, 0)
    }

    #[test]
    fn a_json_line_has_code_arguments_and_words() {
        let why = Message::new("server-slow-down");
        let line = written(Format::Json, || {
            event(Ours::Warn, &gap(), Some("ada"));
            event(Ours::Debug, &gap(), None);
            event(Ours::Error, &Message::new("server-event-audit-fails").message("reason", why), None);
        });
        let lines: Vec<Value> = line.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        assert_eq!(lines.len(), 2, "debug is below the level: {line}");
        let first = &lines[0];
        assert_eq!(
            (&first["level"], &first["code"], &first["user"]),
            (&"warn".into(), &"server-event-cycles-missed".into(), &"ada".into())
        );
        assert_eq!(first["arguments"]["cycles"], 3);
        assert_eq!(
            (&first["arguments"]["longest"]["value"], &first["arguments"]["longest"]["unit"]),
            (&12.5.into(), &"ms".into())
        );
        assert_eq!(first["text"], gap().in_language(Language::English));
        let time = first["time"].as_str().unwrap();
        assert!(time.ends_with('Z') && time.contains('T'), "{time}");
        assert!(lines[1].get("user").is_none() && lines[1]["arguments"]["reason"]["code"] == "server-slow-down");
    }

    #[test]
    fn a_text_line_is_one_line() {
        let foreign = Message::verbatim("a\nb \u{1b}[2J \u{202e}c");
        let text = written(Format::Text, || event(Ours::Info, &foreign, None));
        assert_eq!(text.lines().count(), 1, "{text}");
        assert!(text.contains(" INFO  a\\nb \\u{1b}[2J \\u{202e}c code=text"), "{text}");
    }

    #[test]
    fn the_journal_gets_priorities() {
        let text = written(Format::Journal, || {
            event(Ours::Error, &Message::verbatim("one"), None);
            event(Ours::Warn, &Message::verbatim("two"), None);
            event(Ours::Info, &Message::verbatim("three"), None);
        });
        let starts: Vec<&str> = text.lines().map(|line| line.split(' ').next().unwrap()).collect();
        assert_eq!(starts, ["<3>one", "<4>two", "<6>three"]);
    }
}
