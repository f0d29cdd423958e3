//! Reader of part programs: text in a control's language to data. Everything is checked that needs no machine.
//!
//! A line is read byte by byte into the words of one block ([`target`], [`motion::Block`]), then executed on the modal
//! state ([`modal_state`]); each dialect has a module for its words. Text that is not understood is an error with its
//! position, or, for a lenient reader, listed as left out. The reader skips no text in silence.

mod addresses;
mod arcs;
mod block_arc;
pub(crate) mod error;
mod expression;
mod lexer;
mod lines;
mod modal_state;
mod motion;
mod options;
mod pmac;
mod programs;
mod rs274;
mod sinumerik;
mod target;

pub use error::ReadError;
use lines::{Flow, Lines};
pub use options::{LeftOut, ReadOptions};

use crate::control::{Control, Dialect};
use crate::part_program::{PartProgram, What};
use error::{Fault, Read, Span};
use lexer::Cursor;
use modal_state::State;
use programs::Programs;
use seamwright_message::Message;

/// Result of reading a text.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The program.
    pub program: PartProgram,
    /// Texts that a lenient reader did not understand and left out, in order.
    pub left_out: Vec<LeftOut>,
    /// Notes for the user: assumptions of the reader, with their position.
    pub notes: Vec<Message>,
}

/// A program that is being read.
struct Frame {
    at: usize,
    to: usize,
    line: u32,
    /// The sub-program, and how often it is still to be read.
    sub: Option<(usize, u32)>,
}

/// Bytes of a usual block: memory is reserved for so many moves.
const USUAL_LINE: usize = 60;
/// Calls within calls; LinuxCNC allows 10, Siemens 12.
const DEEPEST: usize = 10;
/// Lines of sub-programs that are read at most: a program that calls more is a mistake.
const MAX_LINES: u64 = 5_000_000;

/// Reads the part program `text` for `control`; `file` is its name in errors.
///
/// A row holds commanded positions: mm and degrees, absolute. Every move has its time by the control's rule for feeds,
/// a rapid one 0. Outputs that the machine file names switch arc, gas and wire.
///
/// # Errors
/// [`ReadError`] at the first fault, or the first text that is not understood unless `options.lenient`.
pub fn read(control: &Control, file: &str, text: &str, options: &ReadOptions) -> Result<Reading, ReadError> {
    let mut state = State::new(control, options);
    state.program.reserve(text.len() / USUAL_LINE);
    run(&mut state, text).map_err(|fault| fault.placed(file, text))?;
    let State { mut program, left_out, notes, .. } = state;
    if program.title.is_empty() {
        file.clone_into(&mut program.title);
    }
    Ok(Reading { program, left_out, notes })
}

fn run(state: &mut State, text: &str) -> Read {
    let start = Span { from: 0, to: 0 };
    if state.control.dialect == Dialect::Grblhal && state.program.axes() > 8 {
        let message = Message::new("post-grblhal-axes").count("axes", state.program.axes());
        return Err(Fault::new(start, message).cure("post-another-control"));
    }
    let programs = Programs::find(text, state.control.dialect)?;
    match state.control.dialect {
        Dialect::Sinumerik => run_lines(state, text, &programs, sinumerik::Words::default()),
        Dialect::Linuxcnc | Dialect::Grblhal => run_lines(state, text, &programs, rs274::Words::default()),
        Dialect::Pmac => run_lines(state, text, &programs, pmac::Words::default()),
    }
}

fn run_lines(state: &mut State, text: &str, programs: &Programs, mut words: impl Lines) -> Read {
    let main = &programs.main;
    let bom = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
    let mut frames = vec![Frame { at: main.from.max(bom), to: main.to, line: main.line, sub: None }];
    let mut called = 0u64;
    let mut ended = state.control.dialect == Dialect::Pmac;
    while let Some(frame) = frames.last_mut() {
        if frame.at >= frame.to {
            leave(&mut frames, programs);
            continue;
        }
        let from = frame.at;
        let to = text[from..frame.to].find('\n').map_or(frame.to, |i| from + i);
        (state.line, state.line_start) = (frame.line, from);
        frame.at = to + 1;
        frame.line += 1;
        let inside = frame.sub.is_some();
        state.inside = inside;
        let mut c = Cursor::new(text, from, to, state.control.decimal_comma);
        called += u64::from(inside);
        if called > MAX_LINES {
            let message = Message::new("post-too-many-lines").count("max", MAX_LINES as usize);
            return Err(Fault::new(Span { from, to }, message));
        }
        match words.line(state, &mut c, programs)? {
            Flow::Next => {}
            Flow::Over(sub) => (frame.at, frame.line) = programs.subs[sub].after,
            Flow::Call(sub, times) => {
                let program = &programs.subs[sub];
                if frames.len() > DEEPEST {
                    let message = Message::new("post-calls-too-deep").count("max", DEEPEST);
                    return Err(Fault::new(Span { from, to }, message).cure("post-calls-too-deep-cure"));
                }
                let sub = Some((sub, times));
                frames.push(Frame { at: program.from, to: program.to, line: program.line, sub });
            }
            Flow::Return if inside => leave(&mut frames, programs),
            Flow::Return | Flow::End => {
                ended = true;
                let Some(main) = frames.first() else { break };
                rest(state, text, main);
                break;
            }
        }
    }
    if !ended {
        state.note("post-no-end");
    }
    if state.is_burning() {
        state.note("post-burning-at-end");
    }
    Ok(())
}

/// The end of a sub-program: once more, or back to the caller.
fn leave(frames: &mut Vec<Frame>, programs: &Programs) {
    let Some(frame) = frames.last_mut() else { return };
    match &mut frame.sub {
        Some((sub, times)) if *times > 1 => {
            *times -= 1;
            (frame.at, frame.line) = (programs.subs[*sub].from, programs.subs[*sub].line);
        }
        _ => drop(frames.pop()),
    }
}

/// Notes text behind the end of the main program.
fn rest(state: &mut State, text: &str, main: &Frame) {
    let something = text.get(main.at.min(main.to)..main.to).unwrap_or_default().lines().position(|line| {
        let line = line.trim();
        !(line.is_empty() || line == "%" || line.starts_with(['(', ';']))
    });
    if let Some(lines) = something {
        state.line = main.line + lines as u32;
        state.note("post-behind-end");
    }
}

impl State<'_> {
    /// Starts a pass. Calls within sub-programs are no passes.
    fn pass(&mut self, name: &str) {
        if !self.inside {
            self.push(What::Pass(name.into()));
        }
    }
}
