use crate::address::{contains, path_at, span_of};
use crate::bounds;
use crate::deserializer::Node;
use crate::error::{DocumentError, place};
use crate::nesting::check_nesting;
use seamwright_message::Message;
use serde::de::DeserializeOwned;
use std::marker::PhantomData;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Longest value that is quoted in an error.
const QUOTED: usize = 60;

/// A document read into `T`, together with its text, so that later checks can point at a key.
#[derive(Debug, Clone)]
pub struct Document<T> {
    /// The value read.
    pub value: T,
    file: String,
    text: String,
}

impl<T: DeserializeOwned> Document<T> {
    /// Reads `text`, calling it `file` in errors.
    ///
    /// # Errors
    /// A [`DocumentError`] at the first thing that is wrong: syntax, a missing or unknown key, a wrong type, a value
    /// out of its range or beyond the bound of its unit.
    pub fn read(file: &str, text: &str) -> Result<Self, DocumentError> {
        check_nesting(file, text)?;
        let root = DeTable::parse(text).map_err(|e| explain(file, text, e.span(), e.message()))?;
        let root = Spanned::new(root.span(), DeValue::Table(root.into_inner()));
        let value = Node(&root).read(PhantomData).map_err(|fault| explain(file, text, fault.span, &fault.message))?;
        bounds::check(file, text, &root)?;
        Ok(Self { value, file: file.to_owned(), text: text.to_owned() })
    }
}

impl<T> Document<T> {
    /// The same document with another value.
    pub fn with<U>(&self, value: U) -> Document<U> {
        Document { value, file: self.file.clone(), text: self.text.clone() }
    }

    /// The file's name.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// The text that was read.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// True if the key `path` (like `tool[2].range_mm`) is in the text.
    pub fn has(&self, path: &str) -> bool {
        contains(&self.text, path)
    }

    /// Key that an error about a value names: `path` if it is in the text, or the table `above` that leaves it at its
    /// default.
    pub fn given_or<'a>(&self, path: &'a str, above: &'a str) -> &'a str {
        if self.has(path) { path } else { above }
    }

    /// An error at the key `path` whose value `name` is not among the names `known`, with the one probably meant.
    pub fn unknown_name(&self, path: &str, name: &str, known: &[&str]) -> DocumentError {
        let error = self.error_at(path, Message::new("document-unknown-name").text("name", name), known.join(", "));
        DocumentError { help: suggestion(name, known), ..error }
    }

    /// An error as of [`Document::error_at`] without arguments: the codes of the fault and of what is allowed.
    pub fn fault_at(&self, path: &str, fault: &'static str, allowed: &'static str) -> DocumentError {
        self.error_at(path, Message::new(fault), Message::new(allowed))
    }

    /// An error at the key `path` (like `tool[2].range_mm`), or at the nearest table above it that exists.
    pub fn error_at(&self, path: &str, message: impl Into<Message>, allowed: impl Into<Message>) -> DocumentError {
        error_at(&self.file, &self.text, path, message.into(), allowed.into())
    }
}

/// The error at the key `path` of a text, see [`Document::error_at`].
pub(crate) fn error_at(file: &str, text: &str, path: &str, message: Message, allowed: Message) -> DocumentError {
    let allowed = Some(allowed).filter(|allowed| !allowed.is_empty());
    DocumentError { message, allowed, ..build(file, text, &span_of(text, path), path.to_owned()) }
}

/// An error at a place of an unparsable text: without a key.
pub(crate) fn error_at_span(
    file: &str,
    text: &str,
    span: &Range<usize>,
    message: Message,
    allowed: Message,
) -> DocumentError {
    DocumentError { message, allowed: Some(allowed), ..build(file, text, span, String::new()) }
}

pub(crate) fn build(file: &str, text: &str, span: &Range<usize>, key: String) -> DocumentError {
    let (line, column, source_line, marked) = place(text, span);
    let value = text.get(span.clone()).unwrap_or_default();
    let quotable = value.chars().count() <= QUOTED && !value.contains('\n') && !value.starts_with('[');
    DocumentError {
        file: file.to_owned(),
        line,
        column,
        value: if quotable && !key.ends_with(value) { value.to_owned() } else { String::new() },
        key,
        source_line,
        marked,
        ..DocumentError::default()
    }
}

/// Turns the parser's error into ours. Its messages have serde's fixed forms, which a test pins down.
pub(crate) fn explain(file: &str, text: &str, span: Option<Range<usize>>, message: &str) -> DocumentError {
    let span = span.unwrap_or(0..0);
    let message = message.trim();
    let path = if span.is_empty() { String::new() } else { path_at(text, &span) };
    let mut e = build(file, text, &span, path);
    let (what, expected) = message.split_once(", expected ").unwrap_or((message, ""));
    let known = if what.starts_with("unexpected keys") { unexpected_key(what) } else { None };
    if let Some((name, known)) = quoted(what, "unknown field ").map(|name| (name, names(expected))).or(known) {
        e.message = Message::new("document-unknown-key").key("key", name);
        e.help = suggestion(name, &known);
        e.allowed = Some(Message::verbatim(known.join(", ")));
        e.value = String::new();
    } else if let Some(name) = quoted(what, "unknown variant ") {
        let known = names(expected);
        e.message = Message::new("document-unknown-name").text("name", name);
        e.help = suggestion(name, &known);
        e.allowed = Some(Message::verbatim(known.join(", ")));
    } else if let Some(name) = quoted(what, "missing field ") {
        e.key = if e.key.is_empty() { name.to_owned() } else { format!("{}.{name}", e.key) };
        e.message = Message::new("document-missing-key").key("key", name);
        e.value = String::new();
        let unit = stem(name).1.trim_start_matches('_').replacen('_', "/", 1);
        let allowed = Message::new("document-key-in-unit").key("key", name).text("unit", unit.clone());
        e.allowed = Some(allowed).filter(|_| !unit.is_empty());
        if name == "schema" {
            e.help = Some(Message::new("document-missing-schema"));
        }
    } else if what.contains("wanted exactly 1 element") {
        let none = what.contains("found 0");
        e.message = Message::new(if none { "document-none-given" } else { "document-several-given" });
        e.value = String::new();
        e.allowed = Some(Message::new("document-exactly-one"));
    } else {
        e.message = fault(what);
        if what.contains("string values must be quoted") {
            e.help = Some(Message::new("document-number-without-unit"));
        }
        e.allowed = Some(expectation(expected)).filter(|allowed| !allowed.is_empty());
    }
    e
}

/// The fault in serde's words, or one that [`in_serde`] has put into them.
fn fault(what: &str) -> Message {
    let value = |text: &str| text.replace("floating point ", "").replace("integer ", "").replace('`', "");
    let of = |code, prefix| what.strip_prefix(prefix).map(|text| Message::new(code).text("value", value(text)));
    from_serde(what)
        .or_else(|| of("document-invalid-value", "invalid value: "))
        .or_else(|| of("document-invalid-type", "invalid type: "))
        .unwrap_or_else(|| Message::verbatim(value(what)))
}

/// The allowed values in serde's words, or those that [`in_serde`] has put into them.
fn expectation(expected: &str) -> Message {
    let whole = |from: i64, to: i64| {
        Message::new("document-whole-number").text("min", from.to_string()).text("max", to.to_string())
    };
    from_serde(expected).unwrap_or_else(|| match expected {
        "f64" => Message::new("document-number"),
        "u8" => whole(0, 255),
        "u16" => whole(0, 65535),
        other => match other.strip_prefix("struct ") {
            Some(name) => Message::new("document-table").text("name", name),
            None => Message::verbatim(other),
        },
    })
}

/// First and last character of a message within serde's text.
const ENCLOSED: char = '\u{1}';

/// Writes a message so that it passes through serde's errors, which are text, and is a message again in a
/// [`DocumentError`]: as the error of a `Deserialize`, or as its `expecting`.
pub fn in_serde(message: &Message) -> String {
    // A message is names and numbers: writing it as JSON cannot fail.
    format!("{ENCLOSED}{}{ENCLOSED}", serde_json::to_string(message).unwrap_or_default())
}

/// Writes a fault and the allowed values so that they pass through serde's errors; see [`in_serde`].
pub fn fault_in_serde(fault: &Message, allowed: &Message) -> String {
    format!("{}, expected {}", in_serde(fault), in_serde(allowed))
}

/// Text of an error of serde, with the words of the messages that [`in_serde`] has put into it.
pub fn serde_text(error: &str) -> String {
    let message = |text: &str| serde_json::from_str::<Message>(text).map(|message| message.to_string());
    let part = |(i, part): (usize, &str)| match message(part) {
        Ok(words) if i % 2 == 1 => words,
        _ => part.to_owned(),
    };
    error.split(ENCLOSED).enumerate().map(part).collect()
}

fn from_serde(text: &str) -> Option<Message> {
    serde_json::from_str(text.trim().strip_prefix(ENCLOSED)?.strip_suffix(ENCLOSED)?).ok()
}

/// The first unknown key of an enum's variant, and the known ones: the parser has its own words there.
fn unexpected_key(message: &str) -> Option<(&str, Vec<&str>)> {
    let (found, known) = message.strip_prefix("unexpected keys in table: ")?.split_once(", available keys: ")?;
    Some((found.split(", ").next()?, known.split(", ").collect()))
}

/// The name in backquotes after `prefix`.
fn quoted<'a>(message: &'a str, prefix: &str) -> Option<&'a str> {
    message.strip_prefix(prefix)?.strip_prefix('`')?.split('`').next()
}

/// The names in backquotes in serde's list of expected values.
fn names(expected: &str) -> Vec<&str> {
    expected.split('`').skip(1).step_by(2).collect()
}

/// Units that keys end in, longest first.
const UNITS: [&str; 26] = [
    "_deg_s3", "_deg_s2", "_mm_min", "_mm_s3", "_mm_s2", "_m_min", "_deg_s", "_cm_min", "_mm_s", "_in_min", "_m_s",
    "_deg", "_rad", "_inch", "_mm", "_cm", "_um", "_in", "_ms", "_us", "_hz", "_m", "_s", "_a", "_v", "_kv",
];

/// A key without its unit, and the unit.
fn stem(key: &str) -> (&str, &str) {
    UNITS.iter().find_map(|u| key.strip_suffix(u).map(|s| (s, *u))).unwrap_or((key, ""))
}

fn suggestion(name: &str, known: &[&str]) -> Option<Message> {
    if let Some(same) = known.iter().find(|k| stem(k).0 == stem(name).0 && !stem(k).1.is_empty()) {
        let unit = stem(same).1.trim_start_matches('_').replacen('_', "/", 1);
        return Some(Message::new("document-suggestion-unit").key("name", *same).text("unit", unit));
    }
    closest(name, known).map(|best| Message::new("document-suggestion").key("name", best))
}

/// Finds the known name that was probably meant by `name`, if one is close to it.
pub fn closest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let (distance, best) = known.iter().map(|k| (strsim::damerau_levenshtein(name, k), *k)).min()?;
    (distance <= 1 + name.len() / 3).then_some(best)
}
