//! Bytes of a line, and the numbers and names in them. This module does not allocate.

use super::error::{Fault, Read, Span, floor_char};
use seamwright_message::Message;

/// A position in a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<'a> {
    pub(super) text: &'a str,
    bytes: &'a [u8],
    /// Byte in the whole text.
    pub(super) at: usize,
    /// Byte behind the line.
    pub(super) end: usize,
    /// Whether a comma between digits is a decimal point.
    comma: bool,
}

/// Powers of ten that are exact.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

impl<'a> Cursor<'a> {
    pub(super) fn new(text: &'a str, from: usize, to: usize, comma: bool) -> Self {
        Self { text, bytes: text.as_bytes(), at: from, end: to, comma }
    }

    /// The byte here; 0 at the end of the line.
    #[inline]
    pub(super) fn peek(&self) -> u8 {
        self.look(0)
    }

    /// The byte `ahead` of here; 0 behind the end of the line.
    #[inline]
    pub(super) fn look(&self, ahead: usize) -> u8 {
        if self.at + ahead < self.end { self.bytes[self.at + ahead] } else { 0 }
    }

    #[inline]
    pub(super) fn blanks(&mut self) {
        while self.at < self.end && matches!(self.bytes[self.at], b' ' | b'\t' | b'\r') {
            self.at += 1;
        }
    }

    #[inline]
    pub(super) fn is_done(&self) -> bool {
        self.at >= self.end
    }

    /// Goes on if `byte` is here, after blanks.
    #[inline]
    pub(super) fn take(&mut self, byte: u8) -> bool {
        self.blanks();
        let found = self.peek() == byte && !self.is_done();
        self.at += usize::from(found);
        found
    }

    /// `byte` must be here, after blanks.
    pub(super) fn need(&mut self, byte: u8) -> Read {
        if self.take(byte) {
            return Ok(());
        }
        Err(Fault::new(self.here(), Message::new("post-character-missing").text("character", char::from(byte))))
    }

    pub(super) fn here(&self) -> Span {
        let mut to = (self.at + 1).min(self.end);
        while !self.text.is_char_boundary(to) {
            to += 1;
        }
        Span { from: floor_char(self.text, self.at), to }
    }

    /// Fault of a character that starts no word.
    pub(super) fn stray(&self) -> Box<Fault> {
        match self.peek() {
            b',' if !self.comma => Fault::new(self.here(), "post-comma").cure("post-comma-cure"),
            b'0'..=b'9' | b'.' | b',' | b'+' | b'-' => {
                Fault::new(self.here(), "post-stray-number").cure("post-stray-number-cure")
            }
            _ => Fault::unknown(self.here(), "post-stray-character"),
        }
    }

    /// From byte `from` to here.
    #[inline]
    pub(super) fn since(&self, from: usize) -> Span {
        Span { from, to: self.at }
    }

    /// Text of `span`; whole characters.
    pub(super) fn of(&self, span: Span) -> &'a str {
        self.text.get(span.from..span.to).unwrap_or_default()
    }

    /// The rest of the line, which is then read; without blanks around it.
    pub(super) fn rest(&mut self) -> &'a str {
        let rest = self.of(Span { from: self.at, to: self.end });
        self.at = self.end;
        rest.trim()
    }

    /// Text up to `close`, which is then read; `None` if it is not in the line.
    pub(super) fn until(&mut self, close: char) -> Option<&'a str> {
        let rest = self.of(Span { from: self.at, to: self.end });
        let length = rest.find(close)?;
        self.at += length + close.len_utf8();
        Some(&rest[..length])
    }

    /// A name of letters, digits and `_`; may be empty.
    pub(super) fn name(&mut self) -> &'a str {
        let from = self.at;
        while matches!(self.peek(), b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'_') {
            self.at += 1;
        }
        self.of(self.since(from))
    }

    /// A name of letters only; may be empty.
    pub(super) fn letters(&mut self) -> &'a str {
        let from = self.at;
        while self.peek().is_ascii_alphabetic() {
            self.at += 1;
        }
        self.of(self.since(from))
    }

    #[inline]
    pub(super) fn at_number(&self) -> bool {
        matches!(self.peek(), b'0'..=b'9' | b'.' | b'+' | b'-')
    }

    /// A decimal number with an optional sign, correctly rounded; no exponent.
    #[inline]
    pub(super) fn number(&mut self) -> Read<f64> {
        let from = self.at;
        let negative = self.peek() == b'-';
        if matches!(self.peek(), b'-' | b'+') {
            self.at += 1;
        }
        let (first, mut whole) = (self.at, 0u64);
        while self.peek().is_ascii_digit() {
            whole = whole.wrapping_mul(10).wrapping_add(u64::from(self.bytes[self.at] - b'0'));
            self.at += 1;
        }
        let (mut digits, mut decimals, point) = (self.at - first, 0, self.at);
        let comma = self.comma && self.peek() == b',' && digits > 0 && self.look(1).is_ascii_digit();
        if self.peek() == b'.' || comma {
            self.at += 1;
            while self.peek().is_ascii_digit() {
                whole = whole.wrapping_mul(10).wrapping_add(u64::from(self.bytes[self.at] - b'0'));
                self.at += 1;
                decimals += 1;
            }
        }
        digits += decimals;
        if digits == 0 {
            self.at = from;
            return Err(Fault::new(self.here(), "post-number-missing"));
        }
        // Up to 15 digits are exact, and so is the power of ten: one correctly rounded division.
        let size = if digits <= 15 { whole as f64 / TENS[decimals] } else { self.long(first, point, comma) };
        Ok(if negative { -size } else { size })
    }

    /// A number of many digits, by the standard library.
    #[cold]
    fn long(&self, first: usize, point: usize, comma: bool) -> f64 {
        let text = self.of(self.since(first));
        let parsed = if comma {
            format!("{}.{}", &text[..point - first], &text[point - first + 1..]).parse()
        } else {
            text.parse()
        };
        parsed.unwrap_or(f64::INFINITY)
    }

    /// A whole number without sign, of at most nine digits.
    pub(super) fn whole(&mut self) -> Read<u32> {
        let from = self.at;
        let mut value = 0u32;
        while self.peek().is_ascii_digit() {
            value = value.saturating_mul(10).saturating_add(u32::from(self.bytes[self.at] - b'0'));
            self.at += 1;
        }
        match self.at - from {
            0 => Err(Fault::new(self.here(), "post-whole-number-missing")),
            1..=9 => Ok(value),
            _ => Err(Fault::new(self.since(from), "post-too-many-digits").allowed("post-too-many-digits-allowed")),
        }
    }

    /// The number of a G- or M-code in tenths: 611 for 61.1.
    pub(super) fn code(&mut self) -> Read<u32> {
        let from = self.at;
        let whole = self.whole()?;
        if self.peek() != b'.' {
            return Ok(10 * whole.min(99_999));
        }
        self.at += 1;
        let tenth = self.whole()?;
        if tenth > 9 {
            return Err(Fault::unknown(self.since(from), "post-code-decimals"));
        }
        Ok(10 * whole.min(99_999) + tenth)
    }

    /// Goes on to the next blank that is in no bracket: behind a word that is left out.
    pub(super) fn skip_word(&mut self) {
        let mut depth = 0i32;
        while !self.is_done() && (depth > 0 || !matches!(self.peek(), b' ' | b'\t' | b'\r')) {
            match self.peek() {
                b'(' | b'[' => depth += 1,
                b')' | b']' => depth -= 1,
                b';' => break,
                _ => {}
            }
            self.at += 1;
        }
    }
}

/// Whether two names are the same; all of the controls ignore case.
#[inline]
pub(super) fn same(a: &str, b: &str) -> bool {
    a.eq_ignore_ascii_case(b)
}
