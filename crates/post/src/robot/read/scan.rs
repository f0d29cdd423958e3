//! A cursor over the text of a robot program.

use crate::read::error::{Fault, Read, Span};
use seamwright_message::Message;

/// A position in a text, up to an end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scan<'a> {
    text: &'a str,
    pub(super) at: usize,
    end: usize,
}

impl<'a> Scan<'a> {
    /// The whole text.
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, at: 0, end: text.len() }
    }

    /// The next line without its end; `None` behind the last one.
    pub(super) fn line(&mut self) -> Option<Self> {
        if self.at >= self.end {
            return None;
        }
        let from = self.at;
        let to = self.text[from..self.end].find('\n').map_or(self.end, |i| from + i);
        self.at = to + 1;
        Some(Self { text: self.text, at: from, end: to })
    }

    /// The text that is left.
    pub(super) fn rest(&self) -> &'a str {
        self.text.get(self.at..self.end).unwrap_or_default()
    }

    /// Skips blanks, and ends of lines.
    pub(super) fn blanks(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }

    /// True at the end, behind blanks.
    pub(super) fn is_empty(&mut self) -> bool {
        self.blanks();
        self.at >= self.end
    }

    /// Skips `token` if it is next behind blanks.
    pub(super) fn take(&mut self, token: &str) -> bool {
        self.blanks();
        let found = self.rest().get(..token.len()).is_some_and(|start| start.eq_ignore_ascii_case(token));
        if found {
            self.at += token.len();
        }
        found
    }

    /// Skips `token`, which must be next.
    pub(super) fn expect(&mut self, token: &str) -> Read {
        if self.take(token) { Ok(()) } else { Err(self.missing(token)) }
    }

    /// A word of letters, digits, `_` and `$` behind blanks, possibly empty.
    pub(super) fn word(&mut self) -> &'a str {
        self.blanks();
        let rest = self.rest();
        let length = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '$')).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    /// A word, which must be next.
    pub(super) fn name(&mut self) -> Read<&'a str> {
        match self.word() {
            "" => Err(self.missing("name")),
            word => Ok(word),
        }
    }

    /// Text up to `token`, which is skipped.
    pub(super) fn until(&mut self, token: char) -> Read<&'a str> {
        let rest = self.rest();
        let Some(length) = rest.find(token) else { return Err(self.missing(&token.to_string())) };
        self.at += length + token.len_utf8();
        Ok(&rest[..length])
    }

    /// A finite decimal number, possibly with a sign and an exponent.
    pub(super) fn number(&mut self) -> Read<f64> {
        self.blanks();
        let bytes = self.rest().as_bytes();
        let mut length = 0;
        while let Some(byte) = bytes.get(length) {
            let before = if length > 0 { bytes[length - 1] } else { b' ' };
            let is_sign = matches!(byte, b'+' | b'-') && matches!(before, b' ' | b'e' | b'E');
            if !(byte.is_ascii_digit() || *byte == b'.' || is_sign || (matches!(byte, b'e' | b'E') && length > 0)) {
                break;
            }
            length += 1;
        }
        let from = self.at;
        let parsed = self.rest().get(..length).and_then(|digits| digits.parse::<f64>().ok());
        match parsed.filter(|number| number.is_finite()) {
            Some(number) => {
                self.at += length;
                Ok(number)
            }
            None => Err(Fault::new(Span { from, to: from + length.max(1) }, "post-number-missing")),
        }
    }

    /// `N` numbers with `between` between them.
    pub(super) fn numbers<const N: usize>(&mut self, between: &str) -> Read<[f64; N]> {
        let mut all = [0.0; N];
        for (i, number) in all.iter_mut().enumerate() {
            if i > 0 {
                self.expect(between)?;
            }
            *number = self.number()?;
        }
        Ok(all)
    }

    /// The range of the text from `from` to the cursor.
    pub(super) fn since(&self, from: usize) -> Span {
        Span { from, to: self.at.max(from + 1) }
    }

    /// A fault at the cursor: `token` is missing.
    pub(super) fn missing(&self, token: &str) -> Box<Fault> {
        let message = Message::new("post-robot-expected").text("token", token);
        Fault::new(Span { from: self.at.min(self.end), to: self.at + 1 }, message)
    }

    /// A fault for the text since `from`: `word` is unknown.
    pub(super) fn unknown(&self, from: usize, word: &str) -> Box<Fault> {
        Fault::new(self.since(from), Message::new("post-robot-unknown").text("word", word))
    }

    /// Refuses more text in the line, except a comment that starts with `comment`.
    pub(super) fn end_of_line(&mut self, comment: &str) -> Read {
        if self.is_empty() || self.take(comment) {
            return Ok(());
        }
        let from = self.at;
        let word = self.rest().chars().take(20).collect::<String>();
        Err(self.unknown(from, &word))
    }
}

/// A speed or length that must be above 0.
pub(super) fn positive(value: f64, span: Span) -> Read<f64> {
    if value > 0.0 { Ok(value) } else { Err(Fault::new(span, "post-robot-positive")) }
}
