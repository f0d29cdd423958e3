//! Variables of a program: `[variables]`, and numbers written as `"= expression"` over them.
//!
//! Expressions are replaced in the text by their numbers before it is read as a program, each within its line. So later
//! errors have their own line and key. Texts for people (`title`, `name`, `message`) are left alone.

use seamwright_document::{Document, DocumentError, Finite, check_nesting};
use seamwright_message::Message;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Variables by name.
pub type Variables = BTreeMap<String, Finite>;

/// Keys whose texts are for people.
const WORDS: [&str; 3] = ["title", "name", "message"];
/// Allowed content of an expression.
const GRAMMAR: Message = Message::new("program-expression-grammar");
/// Allowed characters of a name.
const NAMES: Message = Message::new("program-variable-names");
/// Most parentheses and signs within each other.
const DEEPEST: usize = 64;

/// `text` with every `"= expression"` replaced by its number.
/// Fails with the key's address: a bad name, a variable that is not a number; in expressions an unknown name, wrong
/// syntax, a number that is not finite.
pub(crate) fn substituted<'a>(file: &str, text: &'a str) -> Result<Cow<'a, str>, DocumentError> {
    if !["\"=", "'=", "variables"].iter().any(|mark| text.contains(mark)) {
        return Ok(text.into());
    }
    check_nesting(file, text)?;
    // Syntax errors are reported when the text is read as a program.
    let Ok(table) = DeTable::parse(text) else { return Ok(text.into()) };
    let document = Document::<toml::Table>::read(file, text)?;
    let variables = given(&document)?;
    let mut found = Vec::new();
    table_values(table.get_ref(), &mut String::new(), &mut |path, value, span| {
        found.push((path.to_owned(), value.to_owned(), span));
    });
    let mut out = text.to_owned();
    // From the last one on, so that the ranges of the others stay.
    found.sort_by_key(|(_, _, span)| std::cmp::Reverse(span.start));
    let mut numbers = Vec::new();
    for (path, expression, span) in found {
        if text[span.clone()].contains('\n') {
            let message = Message::new("program-expression-lines");
            return Err(document.error_at(&path, message, Message::new("program-expression")));
        }
        numbers.push((span, evaluate(&document, &path, &expression, &variables)));
    }
    // Reports the first error in the order of the file.
    if let Some(i) = numbers.iter().rposition(|(_, number)| number.is_err()) {
        return Err(numbers.swap_remove(i).1.err().unwrap_or_else(|| document.error_at("", "", "")));
    }
    for (span, number) in numbers {
        out.replace_range(span, &written(number.unwrap_or_default()));
    }
    Ok(out.into())
}

/// A number as a file has it: whole ones without a fraction.
pub(crate) fn written(number: f64) -> String {
    if number.fract() == 0.0 && number.abs() < 1e15 { format!("{}", number as i64) } else { format!("{number:?}") }
}

pub(crate) fn is_expression(text: &str) -> bool {
    text.starts_with('=')
}

/// Whether a variable may have this name.
fn is_name(name: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    name.chars().all(plain) && name.chars().next().is_some_and(|c| !c.is_ascii_digit())
}

/// The table `[variables]` of a file.
fn given(document: &Document<toml::Table>) -> Result<BTreeMap<String, f64>, DocumentError> {
    let Some(value) = document.value.get("variables") else { return Ok(BTreeMap::new()) };
    let Some(table) = value.as_table() else {
        let message = Message::new("program-variables-no-table");
        return Err(document.error_at("variables", message, Message::new("program-variables-table")));
    };
    let mut variables = BTreeMap::new();
    for (name, value) in table {
        let path = format!("variables.{name}");
        if !is_name(name) {
            let message = Message::new("program-variable-name-invalid").text("name", name);
            return Err(document.error_at("variables", message, NAMES));
        }
        let number = value.as_float().or(value.as_integer().map(|i| i as f64)).filter(|v| v.is_finite());
        let wrong =
            || document.error_at(&path, Message::new("program-not-a-number"), Message::new("document-finite-number"));
        variables.insert(name.clone(), number.ok_or_else(wrong)?);
    }
    Ok(variables)
}

/// Calls `visit` for every expression with its key's path, its text after the equals sign, and its byte range.
fn table_values(table: &DeTable, path: &mut String, visit: &mut dyn FnMut(&str, &str, Range<usize>)) {
    for (key, value) in table {
        let name: &str = key.get_ref();
        if WORDS.contains(&name) && matches!(value.get_ref(), DeValue::String(_)) {
            continue;
        }
        let before = path.len();
        if before > 0 {
            path.push('.');
        } else if name == "variables" {
            continue;
        }
        path.push_str(name);
        values(value, path, visit);
        path.truncate(before);
    }
}

fn values(value: &Spanned<DeValue>, path: &mut String, visit: &mut dyn FnMut(&str, &str, Range<usize>)) {
    match value.get_ref() {
        DeValue::Table(table) => table_values(table, path, visit),
        DeValue::Array(items) => {
            let before = path.len();
            for (i, item) in items.iter().enumerate() {
                path.push_str(&format!("[{i}]"));
                values(item, path, visit);
                path.truncate(before);
            }
        }
        DeValue::String(text) => {
            if let Some(expression) = text.strip_prefix('=') {
                visit(path, expression, value.span());
            }
        }
        _ => {}
    }
}

fn evaluate(
    document: &Document<toml::Table>,
    path: &str,
    text: &str,
    variables: &BTreeMap<String, f64>,
) -> Result<f64, DocumentError> {
    let mut reader = Reader { rest: text, variables, depth: 0 };
    let value = reader.sum().and_then(|value| match reader.next() {
        None => Ok(value),
        Some(_) => Err(syntax("program-expression-rest", reader.rest.trim())),
    });
    match value {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => {
            let message = Message::new("program-result-not-finite");
            Err(document.error_at(path, message, Message::new("program-finite-result")))
        }
        Err(Wrong::Name(name)) => {
            let known: Vec<&str> = variables.keys().map(String::as_str).collect();
            let mut error = document.unknown_name(path, &name, &known);
            if known.is_empty() {
                error.help = Some(Message::new("program-no-variables"));
            }
            Err(error)
        }
        Err(Wrong::Syntax(message)) => Err(document.error_at(path, message, GRAMMAR)),
    }
}

enum Wrong {
    Name(String),
    Syntax(Message),
}

fn syntax(code: &'static str, text: impl Into<String>) -> Wrong {
    Wrong::Syntax(Message::new(code).text("text", text))
}

/// Reads an expression from left to right.
struct Reader<'a> {
    rest: &'a str,
    variables: &'a BTreeMap<String, f64>,
    depth: usize,
}

impl Reader<'_> {
    /// The next character that is no space.
    fn next(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    /// Takes `wanted` if it comes next.
    fn take(&mut self, wanted: char) -> bool {
        let there = self.next() == Some(wanted);
        if there {
            self.rest = &self.rest[wanted.len_utf8()..];
        }
        there
    }

    fn sum(&mut self) -> Result<f64, Wrong> {
        let mut value = self.product()?;
        loop {
            if self.take('+') {
                value += self.product()?;
            } else if self.take('-') {
                value -= self.product()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<f64, Wrong> {
        let mut value = self.factor()?;
        loop {
            if self.take('*') {
                value *= self.factor()?;
            } else if self.take('/') {
                value /= self.factor()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn factor(&mut self) -> Result<f64, Wrong> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Wrong::Syntax(Message::new("program-nesting-too-deep")));
        }
        let value = if self.take('-') {
            -self.factor()?
        } else if self.take('+') {
            self.factor()?
        } else if self.take('(') {
            let value = self.sum()?;
            if !self.take(')') {
                return Err(Wrong::Syntax(Message::new("program-parenthesis-missing")));
            }
            value
        } else {
            self.atom()?
        };
        self.depth -= 1;
        Ok(value)
    }

    fn atom(&mut self) -> Result<f64, Wrong> {
        let Some(first) = self.next() else {
            return Err(Wrong::Syntax(Message::new("program-expression-ends")));
        };
        if first.is_ascii_digit() || first == '.' {
            let (number, rest) = self.rest.split_at(number_length(self.rest));
            self.rest = rest;
            return number.parse().map_err(|_| syntax("program-number-invalid", number));
        }
        let end = self.rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(self.rest.len());
        if end == 0 {
            return Err(syntax("program-unexpected-character", first));
        }
        let (name, rest) = self.rest.split_at(end);
        self.rest = rest;
        self.variables.get(name).copied().ok_or_else(|| Wrong::Name(name.to_owned()))
    }
}

/// Number of bytes at the start of `text` that are a number, with an exponent if one follows.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| text[from..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |n| from + n);
    let mut end = digits(0);
    if text[end..].starts_with('.') {
        end = digits(end + 1);
    }
    if text[end..].starts_with(['e', 'E']) {
        let sign = end + 1 + usize::from(text[end + 1..].starts_with(['+', '-']));
        end = Some(digits(sign)).filter(|last| *last > sign).unwrap_or(end);
    }
    end
}
