//! The words of Delta Tau's Turbo PMAC, in motion programs.

mod keywords;

use super::addresses::no_address;
use super::error::{Fault, Read, Span};
use super::lexer::Cursor;
use super::lines::{Flow, Lines};
use super::modal_state::{FeedMode, Motion, State};
use super::motion::Block;
use super::programs::Programs;
use super::target::{How, put_once};
use glam::DVec3;
use seamwright_message::Message;

/// State of PMAC beside the other controls' state.
#[derive(Debug)]
pub(super) struct Words {
    begun: bool,
    closed: bool,
    /// Channels that INC holds for.
    incremental: Vec<bool>,
    /// NORMAL: arcs of CIRCLE1 turn about it by the right-hand rule.
    normal: DVec3,
    /// TM in s, or F per second: the last one.
    feed: Option<(FeedMode, f64)>,
    /// Unit of F's time, s: I190.
    feed_time: f64,
    /// TA and TS, s.
    acceleration: Option<f64>,
    s_curve: f64,
    /// Time of PVT, s.
    hermite: Option<f64>,
}

impl Default for Words {
    fn default() -> Self {
        Self {
            begun: false,
            closed: false,
            incremental: Vec::new(),
            normal: DVec3::NEG_Z,
            feed: None,
            feed_time: 1.0,
            acceleration: None,
            s_curve: 0.0,
            hermite: None,
        }
    }
}

impl Lines for Words {
    fn line(&mut self, state: &mut State, c: &mut Cursor, _: &Programs) -> Read<Flow> {
        if !self.begun {
            self.begun = true;
            state.motion = Some(Motion::Line);
            self.incremental = vec![false; state.row.len()];
        }
        state.number = None;
        state.target.clear();
        let span = Span { from: c.at, to: c.end };
        let mut block = Block { span, normal: Some(self.normal), ..Block::default() };
        loop {
            c.blanks();
            if c.is_done() {
                break;
            }
            if let Err(fault) = self.word(&mut block, state, c) {
                state.leave_out(fault, c)?;
            }
        }
        self.finish(&block, state)
    }
}

impl Words {
    #[inline]
    fn word(&mut self, block: &mut Block, state: &mut State, c: &mut Cursor) -> Read {
        let from = c.at;
        match c.peek() {
            b'A'..=b'Z' | b'a'..=b'z' => {}
            b';' => return state.comment_behind(1, c),
            b'/' if c.look(1) == b'/' => return state.comment_behind(2, c),
            b'&' => {
                c.at += 1;
                return c.whole().map(|_| ());
            }
            b'#' => return definition(state, c),
            _ => return Err(c.stray()),
        }
        if c.look(1).is_ascii_alphabetic() {
            return self.keyword(block, state, c);
        }
        let letter = c.peek().to_ascii_uppercase();
        c.at += 1;
        if let Some(channel) = state.addresses.letter(letter).filter(|i| state.is_interpolated(*i)) {
            return self.axis(channel, state, c, from);
        }
        match letter {
            b'N' => {
                state.read_number(c, from)?;
                state.pass_at_number(c, from);
                Ok(())
            }
            b'I' | b'J' | b'K' => {
                if letter == b'I' && is_variable(c) {
                    return self.i_variable(c, from);
                }
                let value = state.expressions.word(c)?;
                let span = c.since(from);
                put_once(&mut block.centre[usize::from(letter - b'I')], (value, How::Modal, span), span)
            }
            b'R' => {
                let value = state.expressions.word(c)?;
                let span = c.since(from);
                put_once(&mut block.radius, (value, span), span)
            }
            b'F' => {
                let value = state.expressions.word(c)?;
                State::check_feed(value, c.since(from))?;
                self.feed = Some((FeedMode::PerMinute, value));
                Ok(())
            }
            b'P' | b'Q' => {
                let number = c.whole()?;
                c.need(b'=')?;
                state.expressions.set(letter, number, state.expressions.expression(c)?);
                Ok(())
            }
            b'M' if is_variable(c) => m_variable(state, c, from),
            b'G' | b'M' => {
                let code = c.code()?;
                if state.own_code(letter, code) {
                    return Ok(());
                }
                Err(Fault::unknown(c.since(from), "post-pmac-call").cure("post-pmac-call-cure"))
            }
            _ => {
                let span = c.since(from);
                c.skip_word();
                Err(no_address(state.control, span, &char::from(letter).to_string()))
            }
        }
    }

    /// An axis: `X10`, `X(P1+5)`, with PVT `X10:2.5`.
    #[inline]
    fn axis(&mut self, channel: usize, state: &mut State, c: &mut Cursor, from: usize) -> Read {
        let value = state.expressions.word(c)?;
        let mut speed = None;
        if c.peek() == b':' {
            c.at += 1;
            let place = c.at;
            speed = Some(state.expressions.word(c)?);
            if state.motion != Some(Motion::Hermite) {
                return Err(Fault::new(c.since(place), "post-speed-without-pvt"));
            }
        }
        let how = if self.incremental[channel] { How::Increment } else { How::Absolute };
        state.target.put(channel, value, how, speed, c.since(from))
    }

    /// `I190=1000`, the unit of F's time in ms: of coordinate system 1 as it is called on PMAC and on Turbo PMAC.
    fn i_variable(&mut self, c: &mut Cursor, from: usize) -> Read {
        let number = c.whole()?;
        let span = c.since(from);
        c.need(b'=')?;
        c.blanks();
        let place = c.at;
        let value = c.number()?;
        if number != 190 && number != 5190 {
            let fault =
                Fault::unknown(span, Message::new("post-unknown-i-variable").text("number", number.to_string()));
            return Err(fault.allowed("post-i-variables-allowed"));
        }
        if !(1.0..=1e6).contains(&value) {
            return Err(Fault::new(c.since(place), "post-time-unit").allowed("post-time-unit-allowed"));
        }
        self.feed_time = 1e-3 * value;
        Ok(())
    }

    /// Executes the line.
    #[inline]
    fn finish(&mut self, block: &Block, state: &mut State) -> Read<Flow> {
        let moves = state.target.count > 0 || block.has_arc_word();
        state.flush(moves);
        if !moves {
            return Ok(Flow::Next);
        }
        if self.closed {
            return Err(Fault::new(block.span, "post-behind-close").cure("post-behind-close-cure"));
        }
        state.least_time = 0.0;
        let (mode, feed) = match state.motion {
            Some(Motion::Hermite) => (FeedMode::Time, self.hermite),
            Some(Motion::Spline) => (FeedMode::Time, self.acceleration),
            _ => {
                state.least_time = self.acceleration.unwrap_or(0.0).max(2.0 * self.s_curve);
                let (mode, value) = self.feed.unzip();
                let mode = mode.unwrap_or(FeedMode::Time);
                (mode, value.map(|v| if mode == FeedMode::Time { v } else { v / self.feed_time }))
            }
        };
        if self.acceleration.is_none() && matches!(state.motion, Some(motion) if motion != Motion::Rapid) {
            state.note("post-acceleration-missing");
        }
        (state.mode, state.feed) = (mode, feed);
        state.go(block)?;
        Ok(Flow::Next)
    }
}

/// Whether digits and `=` are here: an assignment to a variable.
fn is_variable(c: &Cursor) -> bool {
    let mut ahead = *c;
    while ahead.peek().is_ascii_digit() {
        ahead.at += 1;
    }
    let digits = ahead.at > c.at;
    ahead.blanks();
    digits && ahead.peek() == b'='
}

/// `#1->X`: which motor an axis is. Only that the axis is known matters here.
fn definition(state: &State, c: &mut Cursor) -> Read {
    c.at += 1;
    c.whole()?;
    c.need(b'-')?;
    c.need(b'>')?;
    c.blanks();
    if c.at_number() {
        c.number()?;
    }
    let from = c.at;
    let axis = c.letters();
    if axis.is_empty() || state.addresses.name(axis).is_some_and(|i| i < state.program.axes()) {
        return Ok(());
    }
    Err(no_address(state.control, c.since(from), axis))
}

/// `M1=1` sets an output at once, `M1==1` with the next move.
fn m_variable(state: &mut State, c: &mut Cursor, from: usize) -> Read {
    let number = c.whole()?;
    let span = c.since(from);
    c.need(b'=')?;
    let at_once = !c.take(b'=');
    c.blanks();
    let place = c.at;
    let value = state.expressions.expression(c)?;
    if let Some(channel) = state.addresses.name(c.of(span)) {
        state.set(channel, value, at_once);
        return Ok(());
    }
    match number {
        1..=100 => state.switch_by_value(number as u16 - 1, value, at_once, c.since(place)),
        101..=200 => state.set_output(number - 101, value, at_once, span),
        _ => {
            let fault =
                Fault::unknown(span, Message::new("post-unknown-m-variable").text("number", number.to_string()));
            Err(fault.allowed("post-m-variables-allowed"))
        }
    }
}
