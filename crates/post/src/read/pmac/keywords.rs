//! PMAC's words of more than one letter.

use super::Words;
use crate::part_program::Event;
use crate::read::addresses::no_address;
use crate::read::error::{Fault, Read, Span};
use crate::read::lexer::Cursor;
use crate::read::modal_state::{FeedMode, Motion, State};
use crate::read::motion::Block;
use glam::DVec3;
use seamwright_message::Message;

/// Words that steer the program: they are not read.
#[rustfmt::skip]
const STEERING: [&str; 14] = [
    "IF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "ENDW", "GOTO", "GOSUB", "CALL", "AND", "OR", "STOP", "BLOCKSTART",
    "BLOCKSTOP",
];
const WORDS: &str =
    "ABS INC RAPID LINEAR CIRCLE1 CIRCLE2 PVT SPLINE1 TM TA TS F FRAX NOFRAX NORMAL DWELL DELAY SEND OPEN CLOSE";

impl Words {
    pub(super) fn keyword(&mut self, block: &mut Block, state: &mut State, c: &mut Cursor) -> Read {
        let from = c.at;
        let name = c.letters().to_ascii_uppercase();
        let span = c.since(from);
        match name.as_str() {
            "ABS" | "INC" => return self.distance(name == "INC", state, c),
            "RAPID" => state.motion = Some(Motion::Rapid),
            "LINEAR" | "LIN" => state.motion = Some(Motion::Line),
            "CIRCLE" | "CIR" => {
                let number = c.whole()?;
                state.motion = Some(match number {
                    1 => Motion::Clockwise,
                    2 => Motion::Counterclockwise,
                    _ => return Err(Fault::new(c.since(from), "post-no-mode").allowed("post-circle-modes")),
                });
            }
            "SPLINE" => {
                if c.whole()? != 1 {
                    return Err(Fault::new(c.since(from), "post-uneven-splines").allowed("post-spline-allowed"));
                }
                state.motion = Some(Motion::Spline);
            }
            "PVT" => {
                self.hermite = Some(time(state, c, true)?);
                state.motion = Some(Motion::Hermite);
            }
            "TM" => self.feed = Some((FeedMode::Time, time(state, c, true)?)),
            "TA" => self.acceleration = Some(time(state, c, false)?),
            "TS" => self.s_curve = time(state, c, false)?,
            "DWELL" | "DWE" => {
                return state.dwell(time(state, c, false)?, true, c.since(from));
            }
            "DELAY" | "DEL" => {
                return state.dwell(time(state, c, false)?, false, c.since(from));
            }
            "FRAX" => return feed_axes(state, c),
            "NOFRAX" => state.rule = state.control.feed_rule(Some(&[])),
            "NORMAL" | "NRM" => return self.plane(block, state, c, span),
            "SEND" => return send(state, c, span),
            "OPEN" => return open(c, span),
            "CLOSE" | "RETURN" | "RET" => self.closed = true,
            "CLEAR" => {}
            "UNDEFINE" => {
                c.blanks();
                c.letters();
            }
            _ if STEERING.contains(&name.as_str()) => {
                return Err(Fault::new(span, Message::new("post-no-calls").text("name", name)).cure("post-write-out"));
            }
            _ => {
                c.skip_word();
                let mut fault = no_address(state.control, span, &name);
                fault = fault.allowed(Message::new("post-words-allowed").text("words", WORDS));
                return Err(fault);
            }
        }
        Ok(())
    }

    /// ABS or INC, for all axes or those in brackets; R stands for the centres of arcs.
    fn distance(&mut self, incremental: bool, state: &mut State, c: &mut Cursor) -> Read {
        if !c.take(b'(') {
            self.incremental.fill(incremental);
            return Ok(());
        }
        loop {
            c.blanks();
            let from = c.at;
            let name = c.letters();
            if name.eq_ignore_ascii_case("R") {
                state.absolute_centre = !incremental;
            } else {
                self.incremental[axis(state, name, c.since(from))?] = incremental;
            }
            if !c.take(b',') {
                return c.need(b')');
            }
        }
    }

    /// NORMAL I.. J.. K..
    fn plane(&mut self, block: &mut Block, state: &State, c: &mut Cursor, span: Span) -> Read {
        let mut normal = DVec3::ZERO;
        loop {
            c.blanks();
            let k = match c.peek().to_ascii_uppercase() {
                letter @ b'I'..=b'K' => usize::from(letter - b'I'),
                _ => break,
            };
            c.at += 1;
            normal[k] = state.expressions.word(c)?;
        }
        let Some(normal) = normal.try_normalize() else {
            return Err(Fault::new(span, "post-normal-without-direction").allowed("post-normal-allowed"));
        };
        self.normal = normal;
        block.normal = Some(normal);
        Ok(())
    }
}

fn axis(state: &State, name: &str, span: Span) -> Read<usize> {
    state.addresses.name(name).filter(|i| *i < state.program.axes()).ok_or_else(|| {
        let mut fault = no_address(state.control, span, name);
        fault.unknown = false;
        fault
    })
}

/// A time in ms behind a word, in s.
fn time(state: &State, c: &mut Cursor, positive: bool) -> Read<f64> {
    c.blanks();
    let from = c.at;
    let value = state.expressions.word(c)?;
    if !(0.0..=1e9).contains(&value) || (positive && value <= 0.0) {
        let allowed = if positive { "post-time-positive" } else { "post-time-not-negative" };
        return Err(Fault::new(c.since(from), "post-time").allowed(allowed));
    }
    Ok(1e-3 * value)
}

/// FRAX, or FRAX(X,Y,..): whose way F counts; without brackets all axes.
fn feed_axes(state: &mut State, c: &mut Cursor) -> Read {
    let mut group: Vec<usize> = (0..state.program.axes()).collect();
    if c.take(b'(') {
        group.clear();
        loop {
            c.blanks();
            let from = c.at;
            group.push(axis(state, c.letters(), c.since(from))?);
            if !c.take(b',') {
                break;
            }
        }
        c.need(b')')?;
    }
    group.sort_unstable();
    group.dedup();
    state.rule = state.control.feed_rule(Some(&group));
    Ok(())
}

fn send(state: &mut State, c: &mut Cursor, span: Span) -> Read {
    c.need(b'"')?;
    let text = c.until('"').ok_or_else(|| Fault::new(Span { from: span.from, to: c.end }, "post-text-open"))?;
    state.event(Event::Message(text.into()), true);
    Ok(())
}

/// OPEN PROG n, with or without CLEAR.
fn open(c: &mut Cursor, span: Span) -> Read {
    c.blanks();
    if !c.letters().eq_ignore_ascii_case("PROG") {
        return Err(Fault::unknown(span, "post-motion-programs").allowed("post-motion-programs-allowed"));
    }
    c.blanks();
    c.whole().map(|_| ())
}
