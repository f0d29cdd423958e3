//! Arithmetic in the ways the controls write it, and the variables in it. Angles are in degrees on all of them.

use super::error::{Fault, Read, Span};
use super::lexer::{Cursor, same};
use crate::control::Dialect;
use seamwright_message::Message;
use std::collections::HashMap;

/// Brackets within brackets that are read; deeper ones are a mistake.
const DEEPEST: u32 = 40;

/// Variables and how expressions are written.
#[derive(Debug)]
pub(super) struct Expressions {
    dialect: Dialect,
    numbered: HashMap<(u8, u32), f64>,
    named: HashMap<String, f64>,
}

impl Expressions {
    pub(super) fn new(dialect: Dialect) -> Self {
        Self { dialect, numbered: HashMap::new(), named: HashMap::new() }
    }

    /// Sets variable `letter` `number`, like R1 (`#` for LinuxCNC's).
    pub(super) fn set(&mut self, letter: u8, number: u32, value: f64) {
        self.numbered.insert((letter, number), value);
    }

    pub(super) fn set_named(&mut self, name: &str, value: f64) {
        self.named.insert(name.to_ascii_uppercase(), value);
    }

    pub(super) fn is_named(&self, name: &str) -> bool {
        !self.named.is_empty() && self.named.contains_key(&name.to_ascii_uppercase())
    }

    /// A value right behind an address: a number, or its replacement without an operator outside brackets.
    #[inline]
    pub(super) fn word(&self, c: &mut Cursor) -> Read<f64> {
        if matches!(c.peek(), b'0'..=b'9' | b'.') || (c.at_number() && matches!(c.look(1), b'0'..=b'9' | b'.')) {
            return c.number();
        }
        let from = c.at;
        finite(self.factor(c, 0)?, c.since(from))
    }

    /// A whole expression, as behind `=`.
    #[inline]
    pub(super) fn expression(&self, c: &mut Cursor) -> Read<f64> {
        c.blanks();
        let from = c.at;
        if c.at_number() && c.look(1) != b'(' {
            // Fast path: it is nearly always a plain number.
            let mut ahead = *c;
            let value = ahead.number();
            let behind = ahead.at;
            ahead.blanks();
            if value.is_ok() && !matches!(ahead.peek(), b'+' | b'-' | b'*' | b'/' | b'%' | b'M' | b'm' | b'D' | b'd') {
                c.at = behind;
                return value;
            }
        }
        finite(self.sum(c, 0)?, c.since(from))
    }

    fn sum(&self, c: &mut Cursor, depth: u32) -> Read<f64> {
        let mut value = self.product(c, depth)?;
        loop {
            c.blanks();
            match c.peek() {
                b'+' => {
                    c.at += 1;
                    value += self.product(c, depth)?;
                }
                b'-' => {
                    c.at += 1;
                    value -= self.product(c, depth)?;
                }
                _ => return Ok(value),
            }
        }
    }

    fn product(&self, c: &mut Cursor, depth: u32) -> Read<f64> {
        let mut value = self.power(c, depth)?;
        loop {
            c.blanks();
            match c.peek() {
                b'*' if c.look(1) != b'*' => {
                    c.at += 1;
                    value *= self.power(c, depth)?;
                }
                b'/' if c.look(1) != b'/' => {
                    c.at += 1;
                    value /= self.power(c, depth)?;
                }
                b'%' if self.dialect == Dialect::Pmac => {
                    c.at += 1;
                    value %= self.power(c, depth)?;
                }
                b'M' | b'm' if self.dialect != Dialect::Pmac && word_here(c, "MOD") => {
                    c.at += 3;
                    let divisor = self.power(c, depth)?;
                    // LinuxCNC's remainder is never negative, Siemens' has the sign of the dividend.
                    value = if self.dialect == Dialect::Linuxcnc { value.rem_euclid(divisor) } else { value % divisor };
                }
                b'D' | b'd' if self.dialect == Dialect::Sinumerik && word_here(c, "DIV") => {
                    c.at += 3;
                    value = (value / self.power(c, depth)?).trunc();
                }
                _ => return Ok(value),
            }
        }
    }

    /// LinuxCNC's `**`, from left to right.
    fn power(&self, c: &mut Cursor, depth: u32) -> Read<f64> {
        let mut value = self.factor(c, depth)?;
        loop {
            c.blanks();
            if self.dialect != Dialect::Linuxcnc || c.peek() != b'*' || c.look(1) != b'*' {
                return Ok(value);
            }
            c.at += 2;
            value = value.powf(self.factor(c, depth)?);
        }
    }

    fn factor(&self, c: &mut Cursor, depth: u32) -> Read<f64> {
        c.blanks();
        if depth > DEEPEST {
            return Err(Fault::new(c.here(), "post-nested-brackets"));
        }
        let (open, close) = self.brackets();
        match c.peek() {
            b'0'..=b'9' | b'.' => c.number(),
            b'-' => {
                c.at += 1;
                self.factor(c, depth + 1).map(|v| -v)
            }
            b'+' => {
                c.at += 1;
                self.factor(c, depth + 1)
            }
            b if b == open => {
                c.at += 1;
                let value = self.sum(c, depth + 1)?;
                c.need(close)?;
                Ok(value)
            }
            b'#' if self.dialect == Dialect::Linuxcnc => {
                c.at += 1;
                self.parameter(c, depth + 1)
            }
            b if b.is_ascii_alphabetic() || b == b'_' => self.named_factor(c, depth + 1),
            _ => Err(Fault::new(c.here(), "post-number-missing")),
        }
    }

    fn brackets(&self) -> (u8, u8) {
        if self.dialect == Dialect::Linuxcnc { (b'[', b']') } else { (b'(', b')') }
    }

    fn parameter(&self, c: &mut Cursor, depth: u32) -> Read<f64> {
        let from = c.at;
        match self.parameter_name(c, depth)? {
            Parameter::Number(n) => self.numbered.get(&(b'#', n)).copied(),
            Parameter::Name(name) => self.named.get(&name).copied(),
        }
        .ok_or_else(|| unset(c.since(from)))
    }

    /// Number or name of the parameter behind `#`.
    pub(super) fn parameter_name(&self, c: &mut Cursor, depth: u32) -> Read<Parameter> {
        let from = c.at;
        if c.take(b'<') {
            let name = c.until('>').ok_or_else(|| Fault::new(c.since(from), "post-name-open"))?;
            return Ok(Parameter::Name(name.replace([' ', '\t'], "").to_ascii_uppercase()));
        }
        let value = self.factor(c, depth)?;
        if !(0.0..=9999.0).contains(&value) || (value - value.round()).abs() > 1e-6 {
            return Err(Fault::new(c.since(from), "post-parameter-number").allowed("post-parameter-number-allowed"));
        }
        Ok(Parameter::Number(value.round() as u32))
    }

    fn named_factor(&self, c: &mut Cursor, depth: u32) -> Read<f64> {
        let from = c.at;
        let name = c.name();
        let span = c.since(from);
        let (open, close) = self.brackets();
        c.blanks();
        if c.peek() == open {
            let function = self.function(name, span)?;
            c.at += 1;
            let first = self.sum(c, depth)?;
            let second = match function {
                Function::Two(_) if self.dialect == Dialect::Linuxcnc => {
                    c.need(close)?;
                    c.need(b'/')?;
                    c.need(open)?;
                    self.sum(c, depth)?
                }
                Function::Two(_) => {
                    c.need(b',')?;
                    self.sum(c, depth)?
                }
                Function::One(_) => 0.0,
            };
            c.need(close)?;
            return Ok(match function {
                Function::One(f) => f(first),
                Function::Two(f) => f(first, second),
            });
        }
        if let Some(value) = self.numbered_value(name) {
            return value.ok_or_else(|| unset(span));
        }
        match self.named.get(&name.to_ascii_uppercase()) {
            Some(value) if self.dialect == Dialect::Sinumerik => Ok(*value),
            _ => Err(Fault::unknown(span, Message::new("post-name-without-value").text("name", name))),
        }
    }

    /// Value of a variable like R1 or P100, if `name` is one; the inner `None` if it was never set.
    fn numbered_value(&self, name: &str) -> Option<Option<f64>> {
        let letter = name.as_bytes().first()?.to_ascii_uppercase();
        let letters: &[u8] = match self.dialect {
            Dialect::Sinumerik => b"R",
            Dialect::Pmac => b"PQ",
            _ => b"",
        };
        let digits = name.get(1..)?;
        if !letters.contains(&letter) || digits.is_empty() || digits.len() > 9 {
            return None;
        }
        Some(self.numbered.get(&(letter, digits.parse().ok()?)).copied())
    }

    fn function(&self, name: &str, span: Span) -> Read<Function> {
        let known = FUNCTIONS.iter().find(|(dialect, n, _)| *dialect == self.dialect && same(n, name));
        known.map(|(_, _, function)| *function).ok_or_else(|| {
            let names = FUNCTIONS.iter().filter(|f| f.0 == self.dialect).map(|f| f.1).collect::<Vec<_>>().join(" ");
            Fault::unknown(span, Message::new("post-unknown-function").text("name", name))
                .allowed(Message::verbatim(names))
        })
    }
}

/// Parameter named after LinuxCNC's `#`.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Parameter {
    Number(u32),
    Name(String),
}

#[derive(Clone, Copy)]
enum Function {
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
}

fn atan2(y: f64, x: f64) -> f64 {
    y.atan2(x).to_degrees()
}

const SIN: Function = Function::One(|v| v.to_radians().sin());
const COS: Function = Function::One(|v| v.to_radians().cos());
const TAN: Function = Function::One(|v| v.to_radians().tan());
const ASIN: Function = Function::One(|v| v.asin().to_degrees());
const ACOS: Function = Function::One(|v| v.acos().to_degrees());
const ATAN: Function = Function::One(|v| v.atan().to_degrees());
const ATAN2: Function = Function::Two(atan2);
const SQRT: Function = Function::One(f64::sqrt);
const ABS: Function = Function::One(f64::abs);
const EXP: Function = Function::One(f64::exp);
const LN: Function = Function::One(f64::ln);
const ROUND: Function = Function::One(f64::round);
const FLOOR: Function = Function::One(f64::floor);
const CEIL: Function = Function::One(f64::ceil);
const TRUNC: Function = Function::One(f64::trunc);
const POT: Function = Function::One(|v| v * v);

const S: Dialect = Dialect::Sinumerik;
const L: Dialect = Dialect::Linuxcnc;
const P: Dialect = Dialect::Pmac;
#[rustfmt::skip]
const FUNCTIONS: [(Dialect, &str, Function); 37] = [
    (S, "SIN", SIN), (S, "COS", COS), (S, "TAN", TAN), (S, "ASIN", ASIN), (S, "ACOS", ACOS), (S, "ATAN2", ATAN2),
    (S, "SQRT", SQRT), (S, "ABS", ABS), (S, "POT", POT), (S, "TRUNC", TRUNC), (S, "ROUND", ROUND), (S, "LN", LN),
    (S, "EXP", EXP),
    (L, "SIN", SIN), (L, "COS", COS), (L, "TAN", TAN), (L, "ASIN", ASIN), (L, "ACOS", ACOS), (L, "ATAN", ATAN2),
    (L, "SQRT", SQRT), (L, "ABS", ABS), (L, "FIX", FLOOR), (L, "FUP", CEIL), (L, "ROUND", ROUND), (L, "LN", LN),
    (L, "EXP", EXP),
    (P, "SIN", SIN), (P, "COS", COS), (P, "TAN", TAN), (P, "ASIN", ASIN), (P, "ACOS", ACOS), (P, "ATAN", ATAN),
    (P, "SQRT", SQRT), (P, "ABS", ABS), (P, "INT", FLOOR), (P, "LN", LN), (P, "EXP", EXP),
];

/// Whether `word` is here and no letter behind it.
fn word_here(c: &Cursor, word: &str) -> bool {
    let here = (0..word.len()).all(|i| c.look(i).eq_ignore_ascii_case(&word.as_bytes()[i]));
    here && !c.look(word.len()).is_ascii_alphabetic()
}

fn finite(value: f64, span: Span) -> Read<f64> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(Fault::new(span, "post-no-value"))
}

fn unset(span: Span) -> Box<Fault> {
    Fault::new(span, "post-variable-unset").cure("post-variable-unset-cure")
}
