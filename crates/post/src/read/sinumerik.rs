//! The words of Siemens' Sinumerik 840D.

mod calls;
mod codes;
mod line;

use super::addresses::no_address;
use super::error::{Fault, Read, Span};
use super::lexer::{Cursor, same};
use super::lines::{Flow, Lines};
use super::modal_state::{Motion, State};
use super::motion::Block;
use super::programs::{Programs, remark};
use super::target::{How, put_once};
use crate::part_program::Level;
use line::Line;
use seamwright_message::Message;

/// State of the text so far.
#[derive(Debug, Default)]
pub(super) struct Words {
    begun: bool,
}

/// Words that steer the program: they are not read.
#[rustfmt::skip]
const STEERING: [&str; 23] = [
    "IF", "ELSE", "ENDIF", "GOTO", "GOTOF", "GOTOB", "GOTOC", "GOTOS", "FOR", "ENDFOR", "WHILE", "ENDWHILE", "LOOP",
    "ENDLOOP", "REPEAT", "REPEATB", "UNTIL", "CASE", "CALL", "PCALL", "MCALL", "PROC", "ID",
];

impl Lines for Words {
    fn line(&mut self, state: &mut State, c: &mut Cursor, programs: &Programs) -> Read<Flow> {
        if !self.begun {
            // At power-on Siemens' controls are in G1.
            self.begun = true;
            state.motion = Some(Motion::Line);
        }
        state.number = None;
        state.target.clear();
        let block = Block { span: Span { from: c.at, to: c.end }, ..Block::default() };
        let mut line = Line { block, ..Line::default() };
        loop {
            c.blanks();
            if c.is_done() {
                break;
            }
            if let Err(fault) = line.word(state, c, programs) {
                state.leave_out(fault, c)?;
            }
        }
        line.finish(state)
    }
}

impl Line {
    #[inline]
    fn word(&mut self, state: &mut State, c: &mut Cursor, programs: &Programs) -> Read {
        let from = c.at;
        let letter = c.peek();
        match letter {
            b'A'..=b'Z' | b'a'..=b'z' | b'_' => {}
            b';' => return state.comment_behind(1, c),
            b':' => {
                c.at += 1;
                return state.read_number(c, from);
            }
            b'$' => return self.system_variable(state, c, true),
            b'/' => return Err(skipped(c)),
            _ => return Err(c.stray()),
        }
        // The two forms that nearly all words have: X=1.5, and a letter with a number.
        if c.look(1) == b'=' && c.look(2) != b'=' {
            c.at += 2;
            self.begun = true;
            return self.address(letter, state, c, from);
        }
        if matches!(c.look(1), b'0'..=b'9' | b'.' | b'-' | b'+') && !longer_name(c) {
            c.at += 1;
            if letter.eq_ignore_ascii_case(&b'N') {
                return state.read_number(c, from);
            }
            self.begun = true;
            return self.address(letter, state, c, from);
        }
        let name = c.name();
        let span = c.since(from);
        c.blanks();
        let first = !std::mem::replace(&mut self.begun, true);
        match c.peek() {
            b'=' if c.look(1) != b'=' => {
                c.at += 1;
                self.assignment(name, state, c, span)
            }
            b'(' => calls::call(name, state, c, span),
            b'[' if same(name, "PO") => self.polynomial(state, c, span),
            b'[' => {
                c.skip_word();
                let fault = Fault::unknown(span, Message::new("post-indexed-name-not-read").text("name", name));
                Err(if same(name, "FGREF") { fault.cure("post-fgref-cure") } else { fault })
            }
            _ => self.keyword(name, first, state, c, span, programs),
        }
    }

    /// The value of a one-letter address; the cursor is behind the letter, or behind the `=`.
    #[inline]
    fn address(&mut self, letter: u8, state: &mut State, c: &mut Cursor, from: usize) -> Read {
        let letter = letter.to_ascii_uppercase();
        if let Some(channel) = state.addresses.letter(letter) {
            let (value, how) = value(state, c)?;
            return put(state, channel, value, how, c.since(from));
        }
        match letter {
            b'G' => self.g_code(c.code()?, state, c.since(from)),
            b'M' => self.m_code(c.code()?, state, c.since(from)),
            b'F' => {
                let value = state.expressions.expression(c)?;
                let span = c.since(from);
                put_once(&mut self.feed, (value, span), span)
            }
            b'I' | b'J' | b'K' => {
                let (value, how) = value(state, c)?;
                let span = c.since(from);
                put_once(&mut self.block.centre[usize::from(letter - b'I')], (value, how, span), span)
            }
            _ => {
                let end = c.at;
                c.skip_word();
                Err(no_address(state.control, Span { from, to: end }, &char::from(letter).to_string()))
            }
        }
    }

    /// `NAME=..` where the name is longer than a letter.
    fn assignment(&mut self, name: &str, state: &mut State, c: &mut Cursor, span: Span) -> Read {
        if let Some(channel) = state.addresses.name(name) {
            let (value, how) = value(state, c)?;
            return put(state, channel, value, how, c.since(span.from));
        }
        let upper = [0, 1].map(|i| name.as_bytes().get(i).map_or(0, u8::to_ascii_uppercase));
        match upper {
            [b'I' | b'J' | b'K', b'1'] if name.len() == 2 => {
                let (value, how) = value(state, c)?;
                let span = c.since(span.from);
                put_once(&mut self.block.middle[usize::from(upper[0] - b'I')], (value, how, span), span)
            }
            [b'C', b'R'] if name.len() == 2 => {
                let value = state.expressions.expression(c)?;
                let span = c.since(span.from);
                put_once(&mut self.block.radius, (value, span), span)
            }
            [b'A', b'R'] if name.len() == 2 => {
                let value = state.expressions.expression(c)?;
                let span = c.since(span.from);
                put_once(&mut self.block.angle, (value, span), span)
            }
            [b'R', b'0'..=b'9'] if name.len() <= 10 && name[1..].bytes().all(|b| b.is_ascii_digit()) => {
                state.expressions.set(b'R', name[1..].parse().unwrap_or(u32::MAX), state.expressions.expression(c)?);
                Ok(())
            }
            [b'P', b'L'] if name.len() == 2 => {
                let value = state.expressions.expression(c)?;
                let at = c.since(span.from);
                if !(1e-4..=99_999.999_9).contains(&value) {
                    return Err(Fault::new(at, "post-parameter-length").allowed("post-parameter-length-allowed"));
                }
                put_once(&mut self.block.parameter, value, at)
            }
            _ if same(name, "TURN") => {
                let value = state.expressions.expression(c)?;
                let at = c.since(span.from);
                if !(0.0..=999.0).contains(&value) || (value - value.round()).abs() > 1e-9 {
                    return Err(Fault::new(at, "post-turns").allowed("post-turns-allowed"));
                }
                put_once(&mut self.block.turns, (value.round() as u32, at), at)
            }
            _ if state.expressions.is_named(name) => {
                state.expressions.set_named(name, state.expressions.expression(c)?);
                Ok(())
            }
            _ => {
                c.skip_word();
                Err(no_address(state.control, span, name))
            }
        }
    }

    /// A word that stands alone.
    fn keyword(
        &mut self,
        name: &str,
        first: bool,
        state: &mut State,
        c: &mut Cursor,
        span: Span,
        programs: &Programs,
    ) -> Read {
        let upper = name.to_ascii_uppercase();
        match upper.as_str() {
            "CIP" => {
                self.group(codes::MOTION, span)?;
                state.motion = Some(Motion::Through);
            }
            "POLY" => {
                self.group(codes::MOTION, span)?;
                state.motion = Some(Motion::Polynomial);
            }
            "ASPLINE" | "BSPLINE" | "CSPLINE" => {
                let fault = Fault::new(span, Message::new("post-splines-not-read").text("name", upper));
                return Err(fault.allowed("post-curves-allowed").cure("post-splines-not-read-cure"));
            }
            "TRAORI" => state.switch_level(Level::Tip, span)?,
            "TRAFOOF" => state.switch_level(Level::Joint, span)?,
            "ORIMKS" | "ORIAXES" | "ORIWKS" => {}
            "RET" => self.stop = Some(17),
            "DEF" => return calls::define(state, c, programs),
            "WHEN" => return self.when(state, c, span),
            "SUPA" => self.block.machine_zero = true,
            _ if programs.sub(program_name(&upper)).is_some() => {
                return self.call(programs.sub(program_name(&upper)).unwrap_or_default(), name, first, state, c, span);
            }
            _ if STEERING.contains(&upper.as_str()) => {
                let message = Message::new("post-no-calls-of-others").text("name", upper);
                return Err(Fault::new(span, message).cure("post-write-out"));
            }
            _ if state.addresses.name(name).is_some() || "FGMIJKN".contains(&upper) => {
                return Err(Fault::new(c.here(), Message::new("post-value-missing").text("word", upper)));
            }
            _ => return Err(no_address(state.control, span, name)),
        }
        Ok(())
    }

    /// A line with just a sub-program's name, and perhaps how often.
    fn call(&mut self, sub: usize, name: &str, first: bool, state: &mut State, c: &mut Cursor, span: Span) -> Read {
        if !first {
            return Err(Fault::new(span, "post-call-not-alone").cure("post-two-lines"));
        }
        let mut times = 1;
        if matches!(c.peek(), b'P' | b'p') {
            c.at += 1;
            c.take(b'=');
            c.blanks();
            let from = c.at;
            times = c.whole()?;
            if !(1..=9999).contains(&times) {
                return Err(Fault::new(c.since(from), "post-repeats").allowed("post-repeats-allowed"));
            }
        }
        let title = remark(c);
        c.blanks();
        if !c.is_done() {
            return Err(Fault::new(c.here(), "post-call-not-alone").allowed("post-call-allowed"));
        }
        state.pass(if title.is_empty() { name } else { title });
        self.flow = Some(Flow::Call(sub, times));
        Ok(())
    }
}

/// Whether the letter and digits here are the start of a longer name, like `I1=` or `P1_ROOT`.
fn longer_name(c: &Cursor) -> bool {
    let mut ahead = 1;
    while c.look(ahead).is_ascii_digit() {
        ahead += 1;
    }
    ahead > 1 && (c.look(ahead) == b'_' || (c.look(ahead) == b'=' && c.look(ahead + 1) != b'='))
}

/// A sub-program's name without the extension of a call.
fn program_name(name: &str) -> &str {
    name.strip_suffix("_SPF").or_else(|| name.strip_suffix("_MPF")).unwrap_or(name)
}

/// A value, as it is or within AC(..), IC(..), DC(..), ACP(..) or ACN(..).
#[inline]
fn value(state: &State, c: &mut Cursor) -> Read<(f64, How)> {
    c.blanks();
    let how = if c.peek().is_ascii_alphabetic() { how(c) } else { How::Modal };
    Ok((state.expressions.expression(c)?, how))
}

/// The word before the bracket, which is then read; the brackets are the expression's own.
fn how(c: &mut Cursor) -> How {
    let mut ahead = *c;
    let name = ahead.letters();
    ahead.blanks();
    let words = [("AC", How::Absolute), ("IC", How::Increment), ("DC", How::Nearest), ("ACP", How::Upwards)];
    let found = words.iter().chain(&[("ACN", How::Downwards)]).find(|w| same(w.0, name) && ahead.peek() == b'(');
    found.map_or(How::Modal, |(_, how)| {
        *c = ahead;
        *how
    })
}

#[inline]
fn put(state: &mut State, channel: usize, value: f64, how: How, span: Span) -> Read {
    if !state.is_interpolated(channel) {
        state.set_later(channel, value);
        return Ok(());
    }
    state.target.put(channel, value, how, None, span)
}

/// A block that an operator's switch may skip.
fn skipped(c: &mut Cursor) -> Box<Fault> {
    let from = c.at;
    c.at = c.end;
    Fault::unknown(c.since(from), "post-skipped-block").cure("post-skipped-block-cure")
}
