//! Words with brackets, system variables, and variables of the program's own.

use super::line::Line;
use crate::part_program::{ChannelKind, Event};
use crate::polynomial::POWERS;
use crate::read::addresses::no_address;
use crate::read::error::{Fault, Read, Span};
use crate::read::lexer::{Cursor, same};
use crate::read::modal_state::State;
use crate::read::programs::Programs;
use crate::read::target::{FARTHEST, How};
use seamwright_message::Message;

/// `NAME(..)`; the cursor is at the bracket.
pub(super) fn call(name: &str, state: &mut State, c: &mut Cursor, span: Span) -> Read {
    match name.to_ascii_uppercase().as_str() {
        "FGROUP" => feed_group(state, c),
        "MSG" => message(state, c),
        "PRESETON" => preset(state, c),
        "TRAORI" => {
            c.need(b'(')?;
            let first = c.peek() == b'1';
            c.at += usize::from(first);
            c.need(b')')?;
            state.switch_level(crate::part_program::Level::Tip, span)
        }
        "POLYPATH" => poly_path(c, span),
        "IF" | "WHILE" | "UNTIL" | "CASE" => {
            Err(Fault::new(span, Message::new("post-no-branches").text("name", name)).cure("post-write-out"))
        }
        _ => {
            c.skip_word();
            let allowed = Message::new("post-calls-allowed").text("names", "FGROUP, MSG, POLYPATH, PRESETON, TRAORI");
            Err(Fault::unknown(span, Message::new("post-unknown-call").text("name", name)).allowed(allowed))
        }
    }
}

pub(super) fn channel(state: &State, c: &mut Cursor) -> Read<(usize, Span)> {
    c.blanks();
    let from = c.at;
    let name = c.name();
    let span = c.since(from);
    if name.is_empty() {
        return Err(Fault::new(c.here(), "post-axis-missing"));
    }
    // An unknown axis changes the meaning of the rest, so even a lenient reader does not leave it out.
    let mut fault = match state.addresses.name(name) {
        Some(channel) => return Ok((channel, span)),
        None => no_address(state.control, span, name),
    };
    fault.unknown = false;
    Err(fault)
}

/// FGROUP(X, Y, ..): axes whose way the feed counts; without axes the usual ones.
fn feed_group(state: &mut State, c: &mut Cursor) -> Read {
    c.need(b'(')?;
    if c.take(b')') {
        state.rule = state.control.feed_rule(None);
        return Ok(());
    }
    let mut group = Vec::new();
    loop {
        let (axis, span) = channel(state, c)?;
        if group.contains(&axis) {
            return Err(Fault::new(span, "post-feed-group-twice"));
        }
        if state.program.channels[axis].kind == ChannelKind::Stepped {
            return Err(Fault::new(span, "post-feed-group-axes"));
        }
        group.push(axis);
        if !c.take(b',') {
            break;
        }
    }
    c.need(b')')?;
    state.rule = state.control.feed_rule(Some(&group));
    Ok(())
}

/// POLYPATH("AXES", ..): which axes POLY is for.
fn poly_path(c: &mut Cursor, span: Span) -> Read {
    c.need(b'(')?;
    let mut axes = false;
    while c.take(b'"') {
        axes |= c.until('"').is_some_and(|group| same(group, "AXES"));
        c.take(b',');
    }
    c.need(b')')?;
    if axes {
        Ok(())
    } else {
        Err(Fault::new(span, "post-polynomial-without-axes").allowed(Message::verbatim("POLYPATH(\"AXES\")")))
    }
}

/// MSG("..").
fn message(state: &mut State, c: &mut Cursor) -> Read {
    c.need(b'(')?;
    let mut text = "";
    if c.take(b'"') {
        let from = c.at;
        text = c.until('"').ok_or_else(|| Fault::new(c.since(from.saturating_sub(1)), "post-text-open"))?;
    }
    c.need(b')')?;
    state.event(Event::Message(text.into()), true);
    Ok(())
}

/// PRESETON(CW, 0, ..): a process value is set where it stands.
fn preset(state: &mut State, c: &mut Cursor) -> Read {
    c.need(b'(')?;
    loop {
        let (channel, span) = channel(state, c)?;
        c.need(b',')?;
        let value = state.expressions.expression(c)?;
        if matches!(state.program.channels[channel].kind, ChannelKind::Linear | ChannelKind::Rotary) {
            let fault = Fault::new(span, "post-preset-moves-zero");
            return Err(fault.allowed("post-process-values").cure("post-zero-cure"));
        }
        state.set(channel, value, true);
        if !c.take(b',') {
            break;
        }
    }
    c.need(b')')
}

/// DEF REAL NAME=.., NAME=..
pub(super) fn define(state: &mut State, c: &mut Cursor, programs: &Programs) -> Read {
    let from = c.at;
    let kind = c.name();
    if !same(kind, "REAL") && !same(kind, "INT") {
        return Err(Fault::unknown(c.since(from), "post-variable-kind").allowed("post-variable-kinds"));
    }
    loop {
        c.blanks();
        let from = c.at;
        let name = c.name();
        let span = c.since(from);
        if name.len() < 2 || name.as_bytes()[0].is_ascii_digit() {
            return Err(Fault::new(c.here(), "post-name-missing").allowed("post-name-allowed"));
        }
        if state.addresses.name(name).is_some() || programs.sub(name).is_some() {
            return Err(
                Fault::new(span, Message::new("post-name-taken").text("name", name)).cure("post-name-taken-cure")
            );
        }
        let value = if c.take(b'=') { state.expressions.expression(c)? } else { 0.0 };
        state.expressions.set_named(name, value);
        if !c.take(b',') {
            return Ok(());
        }
    }
}

impl Line {
    /// `PO[X]=(end, a2, a3, ..)`: an axis as a polynomial; the cursor is at the bracket.
    pub(super) fn polynomial(&mut self, state: &mut State, c: &mut Cursor, span: Span) -> Read {
        c.need(b'[')?;
        if c.take(b']') {
            return Err(Fault::new(span, "post-polynomial-denominator").cure("post-polynomial-denominator-cure"));
        }
        let (channel, at) = channel(state, c)?;
        if channel >= state.program.axes() {
            return Err(Fault::new(at, "post-polynomial-axes").cure("post-polynomial-axes-cure"));
        }
        if state.control.decimal_comma {
            return Err(Fault::new(span, "post-polynomial-comma").cure("post-polynomial-comma-cure"));
        }
        [b']', b'=', b'('].into_iter().try_for_each(|byte| c.need(byte))?;
        let end = state.expressions.expression(c)?;
        let mut higher = [0.0; POWERS];
        let mut powers = higher.iter_mut();
        while c.take(b',') {
            let place = c.here();
            let value = state.expressions.expression(c)?;
            let Some(power) = powers.next() else {
                return Err(Fault::new(place, "post-polynomial-degree"));
            };
            if value.abs() > FARTHEST {
                return Err(Fault::new(place, "post-coefficient-too-large").allowed("post-position-allowed"));
            }
            *power = value;
        }
        c.need(b')')?;
        let span = c.since(span.from);
        self.block.higher.push((channel, higher, span));
        state.target.put(channel, end, How::Modal, None, span)
    }

    /// `$A_OUT[1]=1` or `$A_OUTA[1]=2.5`; the cursor is at the `$`.
    pub(super) fn system_variable(&mut self, state: &mut State, c: &mut Cursor, at_once: bool) -> Read {
        self.begun = true;
        let from = c.at;
        c.at += 1;
        let name = c.name();
        let span = c.since(from);
        let analogue = same(name, "A_OUTA");
        if !analogue && !same(name, "A_OUT") {
            c.skip_word();
            return Err(Fault::unknown(span, Message::new("post-system-variable").text("name", name))
                .allowed("post-system-variables-allowed"));
        }
        c.need(b'[')?;
        c.blanks();
        let place = c.at;
        let number = c.whole()?;
        let number_span = c.since(place);
        c.need(b']')?;
        c.need(b'=')?;
        c.blanks();
        let place = c.at;
        let value = state.expressions.expression(c)?;
        if !(1..=256).contains(&number) {
            return Err(Fault::new(number_span, "post-no-output").allowed("post-output-allowed"));
        }
        if analogue {
            return state.set_output(number - 1, value, at_once, c.since(from));
        }
        state.switch_by_value((number - 1) as u16, value, at_once, c.since(place))
    }

    /// WHEN TRUE DO $A_OUT[1]=1: with the start of the next move.
    pub(super) fn when(&mut self, state: &mut State, c: &mut Cursor, span: Span) -> Read {
        let condition = c.name();
        c.blanks();
        let then = c.name();
        c.blanks();
        if !same(condition, "TRUE") || !same(then, "DO") || c.peek() != b'$' {
            c.at = c.end;
            let fault = Fault::unknown(Span { from: span.from, to: c.end }, "post-action");
            return Err(fault.allowed("post-action-allowed"));
        }
        while c.peek() == b'$' {
            self.system_variable(state, c, false)?;
            c.blanks();
        }
        Ok(())
    }
}
