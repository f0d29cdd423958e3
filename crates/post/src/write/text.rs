//! Lines of a part program, put together in one buffer.

use super::number;
use crate::control::Dialect;

/// A comment is cut off behind so many characters.
const LONGEST_COMMENT: usize = 200;

pub(super) struct Text {
    out: Vec<u8>,
    /// Start of the current line.
    line: usize,
    point: u8,
    /// Begin and end of a comment.
    comment: (&'static str, &'static str),
    longest: usize,
    too_long: bool,
}

impl Text {
    pub(super) fn new(dialect: Dialect, decimal_comma: bool, capacity: usize) -> Self {
        let (comment, longest) = match dialect {
            Dialect::Linuxcnc => (("(", ")"), 255),
            Dialect::Grblhal => (("(", ")"), 256),
            Dialect::Sinumerik => (("; ", ""), 512),
            Dialect::Pmac => (("; ", ""), 255),
        };
        let point = if decimal_comma { b',' } else { b'.' };
        Self { out: Vec::with_capacity(capacity), line: 0, point, comment, longest, too_long: false }
    }

    /// Adds to the line, with a space between if it has begun.
    pub(super) fn word(&mut self, word: &str) {
        if self.out.len() > self.line {
            self.out.push(b' ');
        }
        self.out.extend_from_slice(word.as_bytes());
    }

    pub(super) fn valued(&mut self, word: &str, value: f64) {
        self.word(word);
        self.number(value);
    }

    /// A word and a feed or a centre behind it, to nine decimals.
    pub(super) fn fine(&mut self, word: &str, value: f64) {
        self.word(word);
        self.fine_number(value);
    }

    /// Appends a value to nine decimals.
    pub(super) fn fine_number(&mut self, value: f64) {
        number::push_fine(&mut self.out, value, self.point);
    }

    pub(super) fn number(&mut self, value: f64) {
        number::push(&mut self.out, value, self.point);
    }

    /// Adds to the line without a space.
    pub(super) fn glue(&mut self, text: &str) {
        self.out.extend_from_slice(text.as_bytes());
    }

    pub(super) fn counted(&mut self, word: &str, number: u32) {
        self.word(word);
        number::push_whole(&mut self.out, u64::from(number));
    }

    pub(super) fn remark(&mut self, text: &str) {
        self.word(self.comment.0);
        self.clean(text, true);
        self.glue(self.comment.1);
    }

    /// Ends the line; [`Text::fits`] reports whether all lines are short enough for the control.
    pub(super) fn end(&mut self) {
        self.too_long |= self.out.len() - self.line > self.longest;
        self.out.push(b'\n');
        self.line = self.out.len();
    }

    pub(super) fn line(&mut self, text: &str) {
        self.word(text);
        self.end();
    }

    /// A line of a template: printable ASCII as it is.
    pub(super) fn plain(&mut self, text: &str) {
        self.clean(text, false);
        self.end();
    }

    /// A remark, and the end of the line.
    pub(super) fn comment(&mut self, text: &str) {
        self.remark(text);
        self.end();
    }

    /// The end of the line, with a remark if there is one.
    pub(super) fn end_with(&mut self, text: Option<&str>) {
        text.into_iter().for_each(|text| self.remark(text));
        self.end();
    }

    /// Appends the text of a message or comment, cleaned: a comment must not hold parentheses or control characters.
    pub(super) fn clean(&mut self, text: &str, quoted: bool) {
        let most = if quoted { LONGEST_COMMENT } else { usize::MAX };
        self.out.extend(text.chars().take(most).map(|c| match c {
            '(' if quoted => b'[',
            ')' if quoted => b']',
            '"' if quoted => b'\'',
            c if c.is_ascii_graphic() || c == ' ' => c as u8,
            _ => b'?',
        }));
    }

    /// Whether all lines so far are short enough, and how long one may be.
    pub(super) fn fits(&self) -> (bool, usize) {
        (!self.too_long, self.longest)
    }

    pub(super) fn finish(self) -> String {
        String::from_utf8(self.out).unwrap_or_else(|e| String::from_utf8_lossy(e.as_bytes()).into_owned())
    }
}
