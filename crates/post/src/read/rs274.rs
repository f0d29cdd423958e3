//! The words of LinuxCNC and grblHAL, which are those of NIST's RS274.

mod codes;

use super::addresses::no_address;
use super::error::{Fault, Read, Span};
use super::expression::Parameter;
use super::lexer::{Cursor, same};
use super::lines::{Flow, Lines};
use super::modal_state::State;
use super::motion::Block;
use super::programs::{Programs, o_word, remark};
use super::target::{How, put_once};
use crate::control::Dialect;
use crate::part_program::Event;
use seamwright_message::Message;

/// grblHAL's buffer for a line has this many characters.
const LONGEST: usize = 256;
/// Letters beside axes, G, M and N, in the order of [`Line::values`].
const LETTERS: &[u8; 10] = b"FPQELRSIJK";
const F: usize = 0;
const P: usize = 1;
const Q: usize = 2;
const E: usize = 3;
const L: usize = 4;
const R: usize = 5;
const S: usize = 6;
const I: usize = 7;

/// State of the text so far.
#[derive(Debug, Default)]
pub(super) struct Words {
    /// Whether a block was read: `%` is then the end.
    begun: bool,
    /// Parameters that get their values at the end of the line.
    assigned: Vec<(Parameter, f64)>,
}

/// Words of a line, beside the channels.
#[derive(Debug, Default)]
struct Line {
    block: Block,
    /// A bit for each modal group of which there was a code.
    groups: u32,
    values: [Option<(f64, Span)>; 10],
    dwell: Option<Span>,
    /// M62 to M68.
    output: Option<(u32, Span)>,
    /// M3 to M5.
    spindle: Option<(u32, Span)>,
    /// M0, M1, M2 and M30.
    stop: Option<u32>,
    path: bool,
    /// Number of steps before the line.
    steps: usize,
}

impl Lines for Words {
    fn line(&mut self, state: &mut State, c: &mut Cursor, programs: &Programs) -> Read<Flow> {
        let whole = Span { from: c.at, to: c.end };
        let grblhal = state.control.dialect == Dialect::Grblhal;
        if grblhal && whole.to - whole.from > LONGEST && c.of(whole).trim_end().len() > LONGEST {
            let span = Span { from: whole.from + LONGEST, to: whole.to };
            return Err(Fault::new(span, "post-line-too-long").allowed("post-line-too-long-allowed"));
        }
        state.number = None;
        state.target.clear();
        c.blanks();
        match c.peek() {
            b'%' if self.begun => return Ok(Flow::End),
            b'%' => {
                c.at += 1;
                c.blanks();
            }
            b'o' | b'O' if !grblhal => return self.program_word(state, c, programs),
            _ => {}
        }
        let block = Block { span: whole, ..Block::default() };
        let mut line = Line { block, steps: state.program.steps.len(), ..Line::default() };
        loop {
            c.blanks();
            if c.is_done() {
                break;
            }
            if let Err(fault) = self.word(&mut line, state, c) {
                state.leave_out(fault, c)?;
            }
        }
        self.finish(line, state)
    }
}

impl Words {
    #[inline]
    fn word(&mut self, line: &mut Line, state: &mut State, c: &mut Cursor) -> Read {
        let from = c.at;
        let letter = c.peek().to_ascii_uppercase();
        c.at += 1;
        c.blanks();
        match letter {
            b'(' => return comment(state, c, from),
            b';' => return state.comment_behind(0, c),
            b'N' => return label(state, c),
            b'G' => {
                self.begun = true;
                return line.g_code(c.code()?, state, c.since(from));
            }
            b'M' => {
                self.begun = true;
                return line.m_code(c.code()?, state, c.since(from));
            }
            b'#' if state.control.dialect == Dialect::Linuxcnc => return self.assign(state, c),
            _ => {}
        }
        self.begun = true;
        if let Some(channel) = state.addresses.letter(letter).filter(|_| letter.is_ascii_alphabetic()) {
            let value = value(state, c)?;
            let span = c.since(from);
            if !state.is_interpolated(channel) {
                // It is set at the line's end, when it is known whether the line moves.
                if letter == b'S' {
                    return put_once(&mut line.values[S], (value, span), span);
                }
                state.set_later(channel, value);
                return Ok(());
            }
            return state.target.put(channel, value, How::Modal, None, span);
        }
        if let Some(index) = LETTERS.iter().position(|l| *l == letter) {
            let value = value(state, c)?;
            let span = c.since(from);
            if index >= I {
                return put_once(&mut line.block.centre[index - I], (value, How::Modal, span), span);
            }
            return put_once(&mut line.values[index], (value, span), span);
        }
        c.at = from;
        let mark = c.here();
        if !letter.is_ascii_alphabetic() {
            return Err(c.stray());
        }
        c.at = mark.to;
        c.skip_word();
        Err(no_address(state.control, mark, &char::from(letter).to_string()))
    }

    /// A line with a word of LinuxCNC's programs within programs.
    fn program_word(&mut self, state: &mut State, c: &mut Cursor, programs: &Programs) -> Read<Flow> {
        self.begun = true;
        let from = c.at;
        let (name, keyword) = o_word(c)?;
        let span = c.since(from);
        let sub = programs.sub(name);
        let flow = match sub {
            Some(sub) if same(keyword, "sub") => return Ok(Flow::Over(sub)),
            Some(sub) if same(keyword, "call") => Flow::Call(sub, 1),
            None if same(keyword, "call") => {
                let names: Vec<&str> = programs.subs.iter().map(|p| p.name).collect();
                let fault = Fault::new(span, Message::new("post-no-sub-program").text("name", name));
                return Err(fault.allowed(match names.is_empty() {
                    true => Message::new("post-none"),
                    false => Message::verbatim(names.join(" ")),
                }));
            }
            _ => {
                let message = Message::new("post-no-branches").text("name", format!("o{name} {keyword}"));
                return Err(Fault::new(span, message).allowed("post-subs-allowed").cure("post-write-out"));
            }
        };
        let title = remark(c);
        c.blanks();
        if !c.is_done() {
            return Err(Fault::new(c.here(), "post-call-arguments").allowed("post-call-arguments-allowed"));
        }
        let named = sub.map_or("", |sub| programs.subs[sub].title);
        state.pass([title, named, name].into_iter().find(|n| !n.is_empty()).unwrap_or_default());
        Ok(flow)
    }

    /// `#1=..`, `#<name>=..`; it counts from the next line on.
    fn assign(&mut self, state: &mut State, c: &mut Cursor) -> Read {
        let parameter = state.expressions.parameter_name(c, 0)?;
        c.need(b'=')?;
        c.blanks();
        self.assigned.push((parameter, state.expressions.word(c)?));
        Ok(())
    }

    #[inline]
    fn finish(&mut self, line: Line, state: &mut State) -> Read<Flow> {
        let flow = line.finish(state)?;
        for (parameter, value) in self.assigned.drain(..) {
            match parameter {
                Parameter::Number(n) => state.expressions.set(b'#', n, value),
                Parameter::Name(name) => state.expressions.set_named(&name, value),
            }
        }
        Ok(flow)
    }
}

#[inline]
fn value(state: &State, c: &mut Cursor) -> Read<f64> {
    if state.control.dialect == Dialect::Linuxcnc {
        return state.expressions.word(c);
    }
    if matches!(c.peek(), b'#' | b'[') {
        return Err(Fault::new(c.here(), "post-grblhal-expression").allowed("a number"));
    }
    c.number()
}

/// A remark in brackets, or a message.
fn comment(state: &mut State, c: &mut Cursor, from: usize) -> Read {
    let Some(text) = c.until(')') else {
        return Err(Fault::new(Span { from, to: c.end }, "post-comment-open").allowed("post-comment-allowed"));
    };
    let text = text.trim();
    match text.split_once(',') {
        Some((word, message)) if same(word.trim(), "MSG") => {
            state.event(Event::Message(message.trim().into()), true);
        }
        _ => state.comment(text),
    }
    Ok(())
}

/// N and the block's number. On grblHAL one alone in its line, except for a remark, starts a pass.
fn label(state: &mut State, c: &mut Cursor) -> Read {
    let from = c.at - 1;
    state.read_number(c, from)?;
    if state.control.dialect == Dialect::Grblhal && state.target.count == 0 {
        state.pass_at_number(c, from);
    }
    Ok(())
}
