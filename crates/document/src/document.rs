use crate::address::{contains, path_at, span_of};
use crate::bounds;
use crate::error::{DocumentError, place};
use serde::de::DeserializeOwned;
use std::ops::Range;

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
        match toml::from_str(text) {
            Ok(value) => {
                let document = Self { value, file: file.to_owned(), text: text.to_owned() };
                bounds::check(&document)?;
                Ok(document)
            }
            Err(error) => Err(explain(file, text, &error)),
        }
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
        let error = self.error_at(path, format!("`{name}` is not known"), known.join(", "));
        DocumentError { help: suggestion(name, known), ..error }
    }

    /// An error at the key `path` (like `tool[2].range_mm`), or at the nearest table above it that exists.
    pub fn error_at(&self, path: &str, message: impl Into<String>, allowed: impl Into<String>) -> DocumentError {
        let span = span_of(&self.text, path);
        DocumentError {
            message: message.into(),
            allowed: Some(allowed.into()).filter(|a: &String| !a.is_empty()),
            ..build(&self.file, &self.text, &span, path.to_owned())
        }
    }
}

fn build(file: &str, text: &str, span: &Range<usize>, key: String) -> DocumentError {
    let (line, column, source_line, marked) = place(text, span);
    let value = text.get(span.clone()).unwrap_or_default();
    let quotable = value.chars().count() <= QUOTED && !value.contains('\n') && !value.starts_with('[');
    DocumentError {
        file: file.to_owned(),
        line,
        column,
        value: if quotable && !key.ends_with(value) { value.to_owned() } else { String::new() },
        key,
        message: String::new(),
        allowed: None,
        help: None,
        source_line,
        marked,
    }
}

/// Turns the parser's error into ours. Its messages have serde's fixed forms, which a test pins down.
fn explain(file: &str, text: &str, error: &toml::de::Error) -> DocumentError {
    let span = error.span().unwrap_or(0..0);
    let message = error.message().trim();
    let path = if span.is_empty() { String::new() } else { path_at(text, &span) };
    let mut e = build(file, text, &span, path);
    let (what, expected) = message.split_once(", expected ").unwrap_or((message, ""));
    if let Some(name) = quoted(what, "unknown field ") {
        let known = names(expected);
        e.message = format!("there is no key `{name}` here");
        e.help = suggestion(name, &known);
        e.allowed = Some(known.join(", "));
        e.value = String::new();
    } else if let Some((name, known)) = unexpected_key(what) {
        e.message = format!("there is no key `{name}` here");
        e.help = suggestion(name, &known);
        e.allowed = Some(known.join(", "));
        e.value = String::new();
    } else if let Some(name) = quoted(what, "unknown variant ") {
        let known = names(expected);
        e.message = format!("`{name}` is not known");
        e.help = suggestion(name, &known);
        e.allowed = Some(known.join(", "));
    } else if let Some(name) = quoted(what, "missing field ") {
        e.key = if e.key.is_empty() { name.to_owned() } else { format!("{}.{name}", e.key) };
        e.message = format!("the key `{name}` is missing");
        e.value = String::new();
        let unit = stem(name).1.trim_start_matches('_').replacen('_', "/", 1);
        e.allowed = Some(format!("`{name} = ...`, in {unit}")).filter(|_| !unit.is_empty());
        if name == "schema" {
            e.help = Some("begin the file with: schema = 1".to_owned());
        }
    } else {
        e.message = what.replace("floating point ", "").replace("integer ", "").replace('`', "");
        if what.contains("wanted exactly 1 element") {
            e.message = if what.contains("found 0") { "none is given" } else { "several are given" }.to_owned();
            e.value = String::new();
            e.allowed = Some("exactly one of them".to_owned());
            return e;
        }
        if what.contains("string values must be quoted") {
            e.help = Some("a number stands alone: its unit is in the key".to_owned());
        }
        e.allowed = Some(
            expected
                .replace("f64", "a number")
                .replace("u8", "a whole number from 0 to 255")
                .replace("u16", "a whole number from 0 to 65535")
                .replace("struct ", "a table "),
        )
        .filter(|a| !a.is_empty());
    }
    e
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

/// The known name that was probably meant.
fn suggestion(name: &str, known: &[&str]) -> Option<String> {
    if let Some(same) = known.iter().find(|k| stem(k).0 == stem(name).0 && !stem(k).1.is_empty()) {
        let unit = stem(same).1.trim_start_matches('_');
        return Some(format!("did you mean `{same}`? This value is given in {}", unit.replacen('_', "/", 1)));
    }
    closest(name, known).map(|best| format!("did you mean `{best}`?"))
}

/// Finds the known name that was probably meant by `name`, if one is close to it.
pub fn closest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let (distance, best) = known.iter().map(|k| (strsim::damerau_levenshtein(name, k), *k)).min()?;
    (distance <= 1 + name.len() / 3).then_some(best)
}
