use crate::argument::{Argument, Quantity};
use crate::unit::Unit;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

/// A stable code with named arguments.
///
/// `Display` prints its words in the language of the process: English, unless [`Language::speak`](crate::Language::speak) has set another one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Message {
    /// Code: identifier of the words in the catalogues, lower-case words with hyphens.
    pub code: Cow<'static, str>,
    /// Arguments by name, in the order in which they were added.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub arguments: Vec<(Cow<'static, str>, Argument)>,
}

impl Message {
    /// Creates a message without arguments.
    pub const fn new(code: &'static str) -> Self {
        Self { code: Cow::Borrowed(code), arguments: Vec::new() }
    }

    /// Creates a message that is `text` in every language: a name, or words from outside.
    pub fn verbatim(text: impl Into<String>) -> Self {
        Self::new("text").text("text", text)
    }

    /// True for text that is the same in every language.
    pub fn is_verbatim(&self) -> bool {
        self.code == "text"
    }

    /// True for text without a character.
    pub fn is_empty(&self) -> bool {
        self.code == "text" && self.argument("text") == Some(&Argument::Text(String::new()))
    }

    /// Creates a message with the words of an error from outside.
    pub fn outside(error: &dyn fmt::Display) -> Self {
        Self::verbatim(error.to_string())
    }

    /// Creates a message of one line after another; an empty text for none.
    pub fn lines(mut lines: Vec<Self>) -> Self {
        // Halves keep the depth small.
        let then = lines.split_off(lines.len().div_ceil(2));
        if then.is_empty() {
            return lines.pop().unwrap_or_default();
        }
        Self::new("lines").message("first", Self::lines(lines)).message("then", Self::lines(then))
    }

    /// Puts the message below another one, as a part of it.
    pub fn indented(self) -> Self {
        Self::new("indented").message("line", self)
    }

    /// Returns code and arguments as one line, for logs.
    pub fn as_data(&self) -> String {
        let mut line = self.code.to_string();
        for (i, (name, argument)) in self.arguments.iter().enumerate() {
            line.push_str(if i == 0 { ": " } else { ", " });
            line.push_str(&format!("{name} = {argument}"));
        }
        line
    }

    /// Returns the arguments by name, for JSON.
    pub fn named_arguments(&self) -> BTreeMap<&str, &Argument> {
        self.arguments.iter().map(|(name, argument)| (name.as_ref(), argument)).collect()
    }

    /// Returns the argument `name`.
    pub fn argument(&self, name: &str) -> Option<&Argument> {
        self.arguments.iter().find(|(own, _)| own == name).map(|(_, argument)| argument)
    }

    /// Adds an argument.
    pub fn with(mut self, name: &'static str, argument: Argument) -> Self {
        self.arguments.push((Cow::Borrowed(name), argument));
        self
    }

    /// Adds a value with its unit and the number of decimals to show.
    pub fn quantity(self, name: &'static str, value: f64, unit: Unit, decimals: u8) -> Self {
        self.with(name, Argument::Quantity(Quantity { value, unit, decimals }))
    }

    /// Adds a value with its unit and all its decimals, like one from a file.
    pub fn value(self, name: &'static str, value: f64, unit: Unit) -> Self {
        self.with(name, Argument::Quantity(Quantity::exact(value, unit)))
    }

    /// Adds a number without a unit and the number of decimals to show.
    pub fn number(self, name: &'static str, value: f64, decimals: u8) -> Self {
        self.quantity(name, value, Unit::One, decimals)
    }

    /// Adds a number of things.
    pub fn count(self, name: &'static str, count: usize) -> Self {
        self.with(name, Argument::Count(count as u64))
    }

    /// Adds the name of an axis.
    pub fn axis(self, name: &'static str, axis: impl Into<String>) -> Self {
        self.with(name, Argument::Axis(axis.into()))
    }

    /// Adds a key of a file.
    pub fn key(self, name: &'static str, key: impl Into<String>) -> Self {
        self.with(name, Argument::Key(key.into()))
    }

    /// Adds a pass, counted from 1.
    pub fn pass(self, name: &'static str, pass: usize) -> Self {
        self.with(name, Argument::Pass(pass))
    }

    /// Adds text that is shown as it is.
    pub fn text(self, name: &'static str, text: impl Into<String>) -> Self {
        self.with(name, Argument::Text(text.into()))
    }

    /// Adds a message within the message.
    pub fn message(self, name: &'static str, message: Self) -> Self {
        self.with(name, Argument::Message(Box::new(message)))
    }

    /// Adds several arguments under one name.
    pub fn list(self, name: &'static str, items: impl IntoIterator<Item = Argument>) -> Self {
        self.with(name, Argument::List(items.into_iter().collect()))
    }
}

impl Default for Message {
    /// Text without a character.
    fn default() -> Self {
        Self::verbatim("")
    }
}

// Lists of names, and words from outside.
impl From<&str> for Message {
    fn from(text: &str) -> Self {
        Self::verbatim(text)
    }
}

impl From<String> for Message {
    fn from(text: String) -> Self {
        Self::verbatim(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Language;

    #[test]
    fn a_message_is_the_same_after_json() {
        let inner = Message::new("jerk-limit").quantity("limit", 5000.0, Unit::MmPerS3, 0);
        let message = Message::new("speed-not-kept")
            .axis("axis", "theta")
            .quantity("asked", 6.0, Unit::MmPerS, 3)
            .count("places", 2)
            .pass("pass", 3)
            .key("key", "weld.speed_mm_s")
            .message("limit", inner)
            .list("names", [Argument::Text("a".to_owned()), Argument::Axis("z".to_owned())]);
        let json = serde_json::to_string(&message).unwrap();
        assert_eq!(serde_json::from_str::<Message>(&json).unwrap(), message);
        assert!(json.contains(r#"{"type":"quantity","value":{"value":6.0,"unit":"mm/s","decimals":3}}"#), "{json}");
        assert_eq!(serde_json::from_str::<Message>(r#"{"code":"stopped"}"#).unwrap(), Message::new("stopped"));
    }

    #[test]
    fn lines_are_one_below_the_other() {
        let lines = |n: usize| (0..n).map(|i| Message::verbatim(i.to_string()).indented()).collect::<Vec<_>>();
        assert_eq!(Message::lines(lines(0)), Message::default());
        for n in [1, 2, 3, 7] {
            let text = (0..n).map(|i| format!("   {i}")).collect::<Vec<_>>().join("\n");
            assert_eq!(Message::lines(lines(n)).in_language(Language::German), text);
        }
        let json = serde_json::to_string(&Message::lines(lines(5000))).unwrap();
        assert_eq!(serde_json::from_str::<Message>(&json).unwrap(), Message::lines(lines(5000)));
    }

    #[test]
    fn units_are_found_by_their_symbols_and_have_identifiers_of_their_own() {
        let mut identifiers: Vec<String> = Unit::ALL.iter().map(|unit| unit.identifier()).collect();
        for unit in Unit::ALL {
            assert_eq!(Unit::from_symbol(unit.symbol()), Some(*unit));
        }
        identifiers.sort();
        identifiers.dedup();
        assert_eq!(identifiers.len(), Unit::ALL.len());
    }
}
