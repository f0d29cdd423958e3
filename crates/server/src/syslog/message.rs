//! Entries as messages of RFC 5424.

use crate::cell::{from_stored, plain};
use seamwright_executive::{Alarm, Priority};
use seamwright_message::{Argument, Language, Message};
use seamwright_record::Moment;
use seamwright_record::library::{self, AuditEntry, PendingEntry};
use std::fmt::Write;

/// Maximum length of a message, bytes: what every receiver should take (RFC 5424, 6.1).
pub(super) const MAX_BYTES: usize = 2048;
/// Maximum length of header and structured data; further parameters are left out.
const MAX_DATA: usize = 1500;
/// Maximum number of characters of a parameter's value.
const MAX_VALUE: usize = 160;
/// Facilities: log audit, log alert.
const AUDIT: u8 = 13;
const ALERT: u8 = 14;
/// Number of our structured data. It stands for documentation and private use (RFC 5612).
const ENTERPRISE: &str = "32473";

/// Sender of messages: its parts of the header.
#[derive(Debug, Clone)]
pub(super) struct Origin {
    pub(super) host: String,
    pub(super) process: u32,
}

impl Origin {
    /// Of this process on this computer.
    pub(super) fn here() -> Self {
        let name = std::fs::read_to_string("/proc/sys/kernel/hostname").or_else(|_| std::env::var("HOSTNAME"));
        Self { host: header_field(name.unwrap_or_default().trim(), 255), process: std::process::id() }
    }
}

/// Returns text as a field of the header: printable ASCII without spaces, or `-`.
fn header_field(text: &str, most: usize) -> String {
    let field: String = text.chars().filter(char::is_ascii_graphic).take(most).collect();
    if field.is_empty() { "-".to_owned() } else { field }
}

/// Severities of RFC 5424.
#[derive(Debug, Clone, Copy)]
enum Severity {
    Alert = 1,
    Critical = 2,
    Error = 3,
    Warning = 4,
    Notice = 5,
}

/// A message that is being put together.
struct Line {
    text: String,
}

impl Line {
    fn new(facility: u8, severity: Severity, at: Moment, origin: &Origin, kind: &str) -> Self {
        let priority = facility * 8 + severity as u8;
        let Origin { host, process } = origin;
        Self { text: format!("<{priority}>1 {} {host} seamwright {process} {kind} ", at.rfc3339()) }
    }

    /// Adds an element of structured data, with the parameters that have room.
    fn element(&mut self, id: &str, parameters: &[(&str, String)]) {
        let before = self.text.len();
        let _ = write!(self.text, "[{id}@{ENTERPRISE}");
        for (name, value) in parameters {
            let parameter = format!(" {}=\"{}\"", parameter_name(name), escaped(value));
            // The bracket follows.
            if self.text.len() + parameter.len() < MAX_DATA {
                self.text.push_str(&parameter);
            }
        }
        if self.text.len() >= MAX_DATA {
            return self.text.truncate(before);
        }
        self.text.push(']');
    }

    /// Ends with the words, shortened to what has room.
    fn finish(mut self, words: &str) -> Vec<u8> {
        self.text.push_str(" \u{feff}");
        for c in plain(words).chars() {
            if self.text.len() + c.len_utf8() > MAX_BYTES {
                break;
            }
            self.text.push(c);
        }
        self.text.into_bytes()
    }
}

/// Returns a name as a PARAM-NAME.
fn parameter_name(name: &str) -> String {
    let allowed = |c: &char| c.is_ascii_graphic() && !matches!(c, '=' | ']' | '"');
    let name: String = name.chars().filter(allowed).take(32).collect();
    if name.is_empty() { "x".to_owned() } else { name }
}

/// Returns a value as a PARAM-VALUE: one line, with `"`, `\` and `]` escaped.
fn escaped(value: &str) -> String {
    let value: String = value.chars().take(MAX_VALUE).collect();
    let mut out = String::new();
    for c in plain(&value).chars() {
        if matches!(c, '"' | '\\' | ']') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

fn english(message: &Message) -> String {
    message.in_language(Language::English)
}

fn argument(argument: &Argument) -> String {
    match argument {
        Argument::Message(message) => english(message),
        Argument::Axis(text) | Argument::Key(text) | Argument::Text(text) => text.clone(),
        other => english(&Message::new("text").with("text", other.clone())),
    }
}

fn arguments(message: &Message) -> Vec<(&str, String)> {
    message.arguments.iter().map(|(name, value)| (name.as_ref(), argument(value))).collect()
}

/// Returns the entry as a message.
pub(super) fn formatted(entry: &PendingEntry, origin: &Origin) -> Vec<u8> {
    match entry {
        PendingEntry::Audit(entry) => audit(entry, origin),
        PendingEntry::Alarm { weld, alarm: of } => alarm(*weld, of, origin),
        PendingEntry::Acknowledge { name, by, at } => acknowledge(name.as_ref(), by, *at, origin),
    }
}

/// Returns the severity of an entry by its result: a reason for which something was refused is a warning.
fn severity(result: &Message) -> Severity {
    match result.code.as_ref() {
        "server-audit-left-out" => Severity::Error,
        code if code.starts_with("server-audit-refused") => Severity::Warning,
        code if is_outcome(code) => Severity::Notice,
        _ => Severity::Warning,
    }
}

/// Returns true for codes of outcomes and events; all others are reasons.
fn is_outcome(code: &str) -> bool {
    let mut words = code.split('-');
    match words.next() {
        Some("server") => matches!(words.next(), Some("audit" | "event")),
        Some("panel") => true,
        _ => code.starts_with("text"),
    }
}

fn audit(entry: &AuditEntry, origin: &Origin) -> Vec<u8> {
    let [station, command, result] = [&entry.station, &entry.command, &entry.result].map(|c| from_stored(c.clone()));
    let mut line = Line::new(AUDIT, severity(&result), entry.at, origin, "AUDIT");
    let words = [&station, &command, &result].map(english);
    let mut parameters = vec![
        ("user", entry.user.clone()),
        ("station", words[0].clone()),
        ("command", command.code.to_string()),
        ("result", result.code.to_string()),
    ];
    let changes = [("old", &entry.old), ("new", &entry.new)].into_iter().filter(|(_, value)| !value.is_empty());
    parameters.extend(changes.map(|(name, value)| (name, value.clone())));
    line.element("audit", &parameters);
    for (id, message) in [("command", &command), ("result", &result)] {
        if !message.arguments.is_empty() {
            line.element(id, &arguments(message));
        }
    }
    line.finish(&format!("{}, {}: {}: {}", entry.user, words[0], words[1], words[2]))
}

fn alarm(weld: Option<i64>, of: &library::Alarm, origin: &Origin) -> Vec<u8> {
    let severity = match Priority::ALL.into_iter().find(|priority| priority.name() == of.priority) {
        Some(Priority::Critical) => Severity::Alert,
        Some(Priority::High) => Severity::Critical,
        Some(Priority::Medium) => Severity::Error,
        Some(Priority::Low) | None => Severity::Warning,
    };
    let mut line = Line::new(ALERT, severity, of.raised, origin, "ALARM");
    let known = Alarm::from_title(&of.name);
    let code =
        known.as_ref().map_or_else(|| of.name.code.to_string(), |(alarm, _)| alarm.entry().title.code.to_string());
    let mut parameters =
        vec![("code", code), ("priority", of.priority.clone()), ("first_out", of.first_out.to_string())];
    let mut optional = |name, value: Option<String>| parameters.extend(value.map(|value| (name, value)));
    optional("about", known.as_ref().and_then(|(_, about)| about.as_ref().map(english)));
    optional("weld", weld.map(|weld| weld.to_string()));
    optional("pass", of.place.pass.map(|pass| pass.to_string()));
    optional("s_mm", of.place.s_mm.map(|s| format!("{s:.2}")));
    optional("t_s", of.place.t_s.map(|t| format!("{t:.3}")));
    line.element("alarm", &parameters);
    let action = known.map(|(alarm, _)| format!("; {}", english(&alarm.entry().action)));
    line.finish(&format!("{}: {}{}", english(&of.name), english(&of.cause), action.unwrap_or_default()))
}

fn acknowledge(name: Option<&Message>, by: &str, at: Moment, origin: &Origin) -> Vec<u8> {
    let mut line = Line::new(ALERT, Severity::Notice, at, origin, "ACKNOWLEDGE");
    let alarm = name.map_or_else(|| "all alarms".to_owned(), english);
    line.element("acknowledge", &[("user", by.to_owned()), ("alarm", alarm.clone())]);
    line.finish(&format!("{by}: {alarm}"))
}

/// Returns a message about messages that were not sent.
pub(super) fn not_sent(count: u64, origin: &Origin) -> Vec<u8> {
    let mut line = Line::new(AUDIT, Severity::Error, Moment::now(), origin, "NOT-SENT");
    line.element("not_sent", &[("count", count.to_string())]);
    line.finish(&format!("{count} messages were not sent"))
}

/// Parses a message by the grammar of RFC 5424, 6.
#[cfg(test)]
pub(super) mod grammar {
    use std::collections::{BTreeMap, BTreeSet};

    #[derive(Debug)]
    pub(in crate::syslog) struct Parsed {
        pub(in crate::syslog) priority: u8,
        pub(in crate::syslog) host: String,
        pub(in crate::syslog) kind: String,
        /// Elements by name, each with its parameters by name.
        pub(in crate::syslog) data: BTreeMap<String, BTreeMap<String, String>>,
        pub(in crate::syslog) words: String,
    }

    struct Input<'a>(&'a [u8]);

    impl Input<'_> {
        fn byte(&mut self) -> Result<u8, String> {
            let (first, rest) = self.0.split_first().ok_or("end")?;
            self.0 = rest;
            Ok(*first)
        }

        fn expect(&mut self, wanted: u8) -> Result<(), String> {
            match self.byte()? {
                b if b == wanted => Ok(()),
                b => Err(format!("{:?} instead of {:?}", b as char, wanted as char)),
            }
        }

        /// Printable ASCII up to a byte of `ends`, which stays.
        fn printable(&mut self, ends: &[u8], most: usize) -> Result<String, String> {
            let length = self.0.iter().position(|b| ends.contains(b)).ok_or("no end")?;
            let (field, rest) = self.0.split_at(length);
            if length == 0 || length > most || !field.iter().all(u8::is_ascii_graphic) {
                return Err(format!("field {:?}", String::from_utf8_lossy(field)));
            }
            self.0 = rest;
            Ok(String::from_utf8(field.to_vec()).unwrap())
        }

        fn field(&mut self, most: usize) -> Result<String, String> {
            let field = self.printable(b" ", most)?;
            self.expect(b' ')?;
            Ok(field)
        }

        /// PARAM-VALUE: UTF-8 in which `"`, `\` and `]` are escaped.
        fn value(&mut self) -> Result<String, String> {
            self.expect(b'"')?;
            let mut bytes = Vec::new();
            loop {
                match self.byte()? {
                    b'"' => return String::from_utf8(bytes).map_err(|e| e.to_string()),
                    b']' => return Err("] in a value".to_owned()),
                    b'\\' => match self.byte()? {
                        b @ (b'"' | b'\\' | b']') => bytes.push(b),
                        _ => return Err("a lone backslash".to_owned()),
                    },
                    b if b < 32 || b == 127 => return Err(format!("control character {b}")),
                    b => bytes.push(b),
                }
            }
        }

        fn element(&mut self) -> Result<(String, BTreeMap<String, String>), String> {
            self.expect(b'[')?;
            let name = |input: &mut Self, ends: &[u8]| {
                let name = input.printable(ends, 32)?;
                if name.contains(['=', ']', '"']) { Err(format!("name {name}")) } else { Ok(name) }
            };
            let id = name(self, b" ]")?;
            let mut parameters = BTreeMap::new();
            while self.0.first() == Some(&b' ') {
                self.expect(b' ')?;
                let parameter = name(self, b"=")?;
                self.expect(b'=')?;
                parameters.insert(parameter, self.value()?);
            }
            self.expect(b']')?;
            Ok((id, parameters))
        }
    }

    fn is_time(text: &str) -> bool {
        let shape: String = text.chars().map(|c| if c.is_ascii_digit() { '0' } else { c }).collect();
        shape == "0000-00-00T00:00:00.000Z"
    }

    pub(in crate::syslog) fn parse(bytes: &[u8]) -> Result<Parsed, String> {
        let input = &mut Input(bytes);
        input.expect(b'<')?;
        let priority: u8 = input.printable(b">", 3)?.parse().map_err(|_| "PRIVAL")?;
        input.expect(b'>')?;
        if priority > 191 || input.field(3)? != "1" {
            return Err("PRI or VERSION".to_owned());
        }
        if !is_time(&input.field(32)?) {
            return Err("TIMESTAMP".to_owned());
        }
        let (host, app, process, kind) = (input.field(255)?, input.field(48)?, input.field(128)?, input.field(32)?);
        if app != "seamwright" || process.parse::<u32>().is_err() {
            return Err(format!("APP-NAME {app} or PROCID {process}"));
        }
        let (mut data, mut ids) = (BTreeMap::new(), BTreeSet::new());
        while input.0.first() == Some(&b'[') {
            let (id, parameters) = input.element()?;
            let (name, number) = id.split_once('@').ok_or("SD-ID")?;
            if number != super::ENTERPRISE || !ids.insert(id.clone()) {
                return Err(format!("SD-ID {id}"));
            }
            data.insert(name.to_owned(), parameters);
        }
        if data.is_empty() {
            return Err("no structured data".to_owned());
        }
        input.expect(b' ')?;
        let words = input.0.strip_prefix("\u{feff}".as_bytes()).ok_or("BOM")?;
        let words = String::from_utf8(words.to_vec()).map_err(|e| e.to_string())?;
        if words.chars().any(char::is_control) {
            return Err("control character in MSG".to_owned());
        }
        Ok(Parsed { priority, host, kind, data, words })
    }
}

#[cfg(test)]
mod tests {
    use super::grammar::parse;
    use super::*;
    use seamwright_executive::Reaction;

    fn origin() -> Origin {
        Origin { host: header_field("cell 7\n.shop", 255), process: 42 }
    }

    #[expect(clippy::needless_pass_by_value, reason = "tests make their messages in place")]
    fn entry(user: &str, command: Message, result: Message) -> PendingEntry {
        let column = |message: &Message| serde_json::to_string(message).unwrap();
        PendingEntry::Audit(AuditEntry {
            at: Moment(1_795_269_909_007),
            user: user.to_owned(),
            station: "panel 1".to_owned(),
            command: column(&command),
            old: "5\u{0}".to_owned(),
            new: String::new(),
            result: column(&result),
        })
    }

    fn alarm(of: Alarm, about: &str) -> PendingEntry {
        let place = library::Place { pass: Some(2), s_mm: Some(12.345), t_s: Some(7.0) };
        let about = Some(Message::verbatim(about));
        let priority = of.priority(of.reaction()).name().to_owned();
        let (name, cause, raised) = (of.title_of(about), of.entry().cause, Moment(0));
        let alarm = library::Alarm { name, cause, priority, place, raised, first_out: true, acknowledged: None };
        PendingEntry::Alarm { weld: Some(9), alarm: Box::new(alarm) }
    }

    #[test]
    fn an_order_is_as_the_standard_writes_it() {
        let load = Message::new("server-audit-load").text("job", "a.toml");
        let bytes = formatted(&entry("ada", load, Message::new("server-audit-loaded")), &origin());
        let text = String::from_utf8(bytes).unwrap();
        let expected = "<109>1 2026-11-21T14:05:09.007Z cell7.shop seamwright 42 AUDIT \
            [audit@32473 user=\"ada\" station=\"panel 1\" command=\"server-audit-load\" result=\"server-audit-loaded\" \
            old=\"5\\\\u{0}\"][command@32473 job=\"a.toml\"] \u{feff}ada, panel 1: load a.toml: loaded";
        assert_eq!(text, expected);
    }

    #[test]
    fn severity_follows_the_priority_of_an_alarm() {
        for (of, severity) in
            [(Alarm::ProcessStuckOn, 1), (Alarm::DrivesSilent, 2), (Alarm::FollowingError, 3), (Alarm::JogStopped, 4)]
        {
            let parsed = parse(&formatted(&alarm(of, "x"), &origin())).unwrap();
            assert_eq!(parsed.priority, 14 * 8 + severity, "{of:?}");
            let data = &parsed.data["alarm"];
            assert_eq!(data["code"], of.entry().title.code);
            assert_eq!((data["about"].as_str(), data["weld"].as_str(), data["s_mm"].as_str()), ("x", "9", "12.35"));
            assert!(parsed.words.contains(&english(&of.entry().action)), "{}", parsed.words);
        }
        // What older versions recorded.
        let old = Alarm::ALL[0].priority(Reaction::Tell);
        assert_eq!(old, Priority::Low);
    }

    /// Whatever the contents, a message follows the grammar, has one line and at most [`MAX_BYTES`].
    #[test]
    fn hostile_contents_are_escaped() {
        let long = "]".repeat(5000);
        let wide = "\u{1f525}".repeat(3000);
        for hostile in [
            "a\nb\r\n<13>1 - - - - - - forged",
            "\" ] [x@1 y=\"z",
            "\\",
            "\\\"",
            "]",
            "\u{0}\u{7f}\u{1b}[2J\u{85}",
            "\u{202e}\u{feff}\u{2028}",
            "\u{fffd}\u{10ffff}",
            "",
            &long,
            &wide,
        ] {
            let command = Message::new("server-audit-load").text("job", hostile).text("=] \"bad name", hostile);
            let result = (0..200).fold(Message::new("server-audit-refused-role"), |m, _| m.text("n", hostile));
            for entry in [
                entry(hostile, command, result),
                alarm(Alarm::Interlock, hostile),
                PendingEntry::Acknowledge { name: Some(hostile.into()), by: hostile.to_owned(), at: Moment(-1) },
            ] {
                let bytes = formatted(&entry, &origin());
                let parsed = parse(&bytes).unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&bytes)));
                assert!(bytes.len() <= MAX_BYTES && !bytes.contains(&b'\n'), "{}", bytes.len());
                assert_eq!(parsed.host, "cell7.shop");
                assert!(!parsed.data.contains_key("x"), "{parsed:?}");
            }
        }
    }

    #[test]
    fn values_are_the_same_after_the_receiver_has_read_them() {
        for value in ["a\\b", "say \"yes\"", "[1]", "Шов 7", "焊缝"] {
            let command = Message::new("server-audit-load").text("job", value);
            let bytes = formatted(&entry("ada", command, Message::new("server-audit-loaded")), &origin());
            assert_eq!(parse(&bytes).unwrap().data["command"]["job"], value);
        }
    }
}
