//! Meaning of the codes of a line, and the order in which the line's words are executed.

use super::{E, F, L, Line, P, Q, R, S};
use crate::control::Dialect;
use crate::part_program::{Event, Level, Step, What};
use crate::read::error::{Fault, Read, Span, once};
use crate::read::lines::Flow;
use crate::read::modal_state::{FeedMode, Motion, State};
use seamwright_message::Message;

/// Modal groups, as bits.
const MOTION: u32 = 1;
const PLANE: u32 = 2;
const UNITS: u32 = 4;
const DISTANCE: u32 = 8;
const CENTRE: u32 = 16;
const FEED: u32 = 32;
const CUTTER: u32 = 64;
const TOOL: u32 = 128;
const OFFSET: u32 = 256;
const CONTROL: u32 = 512;
const ONCE: u32 = 1024;
const STOP: u32 = 2048;
const SPINDLE: u32 = 4096;
const OUTPUT: u32 = 8192;

const G_CODES: &str = "G0 G1 G2 G3 G4 G17 G18 G19 G20 G21 G40 G49 G53 G54-G59.3 G61 G64 G80 G90 G91 G93 G94";
const M_CODES: &str = "M0 M1 M2 M3 M4 M5 M30 M62-M68";

impl Line {
    fn group(&mut self, group: u32, span: Span) -> Read {
        once(&mut self.groups, group, span)
    }

    /// A G-code, in tenths.
    #[inline]
    pub(super) fn g_code(&mut self, code: u32, state: &mut State, span: Span) -> Read {
        if state.own_code(b'G', code) {
            return Ok(());
        }
        let linuxcnc = state.control.dialect == Dialect::Linuxcnc;
        let group = match code {
            0 | 10 | 20 | 30 | 800 => MOTION,
            40 | 530 => ONCE,
            170 | 180 | 190 => PLANE,
            200 | 210 => UNITS,
            400 => CUTTER,
            490 => TOOL,
            540 | 550 | 560 | 570 | 580 | 590..=593 => OFFSET,
            610 => CONTROL,
            611 | 640 if linuxcnc => CONTROL,
            900 | 910 => DISTANCE,
            901 if linuxcnc => CENTRE,
            911 => CENTRE,
            920 => {
                return Err(Fault::unknown(span, "post-zero-moved").cure("post-zero-cure"));
            }
            930 | 940 => FEED,
            950 => return Err(Fault::unknown(span, "post-feed-per-turn").cure("post-feed-per-turn-cure")),
            _ => return Err(Fault::unknown(span, "post-unknown-g-code").allowed(Message::verbatim(G_CODES))),
        };
        self.group(group, span)?;
        match code {
            0 => state.motion = Some(Motion::Rapid),
            10 => state.motion = Some(Motion::Line),
            20 => state.motion = Some(Motion::Clockwise),
            30 => state.motion = Some(Motion::Counterclockwise),
            800 => state.motion = None,
            40 => self.dwell = Some(span),
            530 => self.block.machine_zero = true,
            170 => state.plane = 2,
            180 => state.plane = 1,
            190 => state.plane = 0,
            200 | 210 => (state.inch, state.inch_feed) = (code == 200, code == 200),
            610 | 611 => state.exact_stop = linuxcnc,
            640 => (state.exact_stop, self.path) = (false, true),
            900 | 910 => state.incremental = code == 910,
            901 | 911 => state.absolute_centre = code == 901,
            930 => state.set_mode(FeedMode::InverseTime),
            940 => state.set_mode(FeedMode::PerMinute),
            _ if group == OFFSET => state.note("post-offsets-zero"),
            _ => {}
        }
        Ok(())
    }

    /// An M-code, in tenths.
    #[inline]
    pub(super) fn m_code(&mut self, code: u32, state: &mut State, span: Span) -> Read {
        if state.own_code(b'M', code) {
            return Ok(());
        }
        let switches = state.control.dialect == Dialect::Linuxcnc || state.addresses.letter(b'S').is_some();
        match code {
            0 | 10 | 20 | 300 => {
                self.group(STOP, span)?;
                self.stop = Some(code / 10);
            }
            30 | 40 | 50 if switches => {
                self.group(SPINDLE, span)?;
                self.spindle = Some((code / 10, span));
            }
            620 | 630 | 640 | 650 | 660 | 670 | 680 => {
                self.group(OUTPUT, span)?;
                self.output = Some((code / 10, span));
            }
            30 | 40 | 50 => {
                return Err(Fault::unknown(span, "post-spindle-code").cure("post-spindle-code-cure"));
            }
            70 | 80 | 90 => {
                return Err(Fault::unknown(span, "post-coolant-code").cure("post-coolant-code-cure"));
            }
            _ => {
                return Err(Fault::unknown(span, "post-unknown-m-code")
                    .allowed(Message::new("post-m-codes-allowed").text("codes", M_CODES)));
            }
        }
        Ok(())
    }

    /// Does the line, in RS274's order.
    #[inline]
    pub(super) fn finish(mut self, state: &mut State) -> Read<Flow> {
        self.take_feed(state)?;
        self.begin_pass(state);
        let moves = state.target.count > 0 || self.block.has_arc_word() || self.values[R].is_some();
        if let Some((value, _)) = self.values[S].take() {
            match state.addresses.letter(b'S') {
                Some(channel) => state.set_later(channel, value),
                None => state.note("post-s-not-read"),
            }
        }
        if let Some((code, _)) = self.spindle {
            state.event_later(spindle(state, code));
        }
        if let Some((code, span)) = self.output {
            self.outputs(code, span, state)?;
        }
        state.flush(moves);
        if let Some(span) = self.dwell {
            self.dwell_for(span, moves, state)?;
        } else {
            self.arc_words(state)?;
        }
        if self.path {
            self.values[P] = None;
            self.values[Q] = None;
        }
        if let Some((_, span)) = self.values.iter().flatten().next() {
            return Err(Fault::new(*span, "post-stray-word"));
        }
        if self.dwell.is_none() {
            state.go(&self.block)?;
        }
        Ok(state.stop(self.stop).unwrap_or(Flow::Next))
    }

    /// On grblHAL a numbered line with the whole modal state and no motion starts a pass, named by its remark.
    fn begin_pass(&self, state: &mut State) {
        let all = PLANE | UNITS | DISTANCE;
        let (Dialect::Grblhal, Some(number)) = (state.control.dialect, state.number) else { return };
        if self.groups & all != all || state.target.count > 0 {
            return;
        }
        let steps = &mut state.program.steps;
        let here = steps.len() > self.steps;
        match steps.pop_if(|step| here && matches!(step.what, What::Comment(_))) {
            Some(Step { what: What::Comment(name), .. }) => state.pass(&name),
            _ => state.pass(&format!("N{number}")),
        }
    }

    fn take_feed(&mut self, state: &mut State) -> Read {
        let feed = self.values[F].take();
        if let Some((value, span)) = feed {
            State::check_feed(value, span)?;
            state.feed = Some(value);
        } else if state.mode == FeedMode::InverseTime {
            state.feed = None;
        }
        Ok(())
    }

    /// R and P, if the block is an arc; and J K's zeros.
    fn arc_words(&mut self, state: &State) -> Read {
        if !state.motion.is_some_and(Motion::is_arc) {
            return Ok(());
        }
        self.block.radius = self.values[R].take();
        let arc = self.block.radius.is_some() || self.block.centre.iter().any(Option::is_some);
        if arc
            && self.output.is_none()
            && let Some((turns, span)) = self.values[P].take()
        {
            if !(1.0..=10_000.0).contains(&turns) || (turns - turns.round()).abs() > 1e-9 {
                return Err(Fault::new(span, "post-turns").allowed("post-turns-from-one"));
            }
            self.block.turns = Some((turns as u32 - 1, span));
        }
        Ok(())
    }

    fn dwell_for(&mut self, span: Span, moves: bool, state: &mut State) -> Read {
        if moves {
            let place = state.target.span().unwrap_or(span);
            return Err(Fault::new(place, "post-moves-with-dwell").cure("post-two-blocks"));
        }
        let Some((seconds, span)) = self.values[P].take() else {
            return Err(Fault::new(span, "post-dwell-needs-p"));
        };
        state.dwell(seconds, state.control.dialect == Dialect::Grblhal, span)
    }

    /// A whole number that the code needs.
    fn need(&mut self, letter: usize, code: Span, what: &str) -> Read<u32> {
        let Some((value, span)) = self.values[letter].take() else {
            return Err(Fault::new(code, Message::new("post-word-missing").text("word", what)));
        };
        if !(0.0..=255.0).contains(&value) || (value - value.round()).abs() > 1e-9 {
            return Err(Fault::new(span, "post-output-number").allowed("post-output-number-allowed"));
        }
        Ok(value.round() as u32)
    }

    fn outputs(&mut self, code: u32, span: Span, state: &mut State) -> Read {
        match code {
            66 => self.wait(span, state),
            67 | 68 => {
                let output = self.need(E, span, "E")?;
                let Some((value, value_span)) = self.values[Q].take() else {
                    return Err(Fault::new(span, Message::new("post-word-missing").text("word", "Q")));
                };
                if state.control.kinematics_output.map(u32::from) != Some(output) {
                    return state.set_output(output, value, code == 68, span);
                }
                if code == 67 || !(value == 0.0 || (value - 1.0).abs() < 1e-9) {
                    let fault = Fault::new(value_span, "post-kinematics-output");
                    return Err(fault.allowed("post-kinematics-output-allowed"));
                }
                state.switch_level(if value > 0.5 { Level::Tip } else { Level::Joint }, span)
            }
            _ => {
                let output = self.need(P, span, "P")? as u16;
                state.switch(output, code.is_multiple_of(2), code >= 64);
                Ok(())
            }
        }
    }

    /// M66: L0 only waits for the motion before.
    fn wait(&mut self, span: Span, state: &mut State) -> Read {
        let (digital, analogue) = (self.values[P].take(), self.values[E].take());
        let (how, _) = (self.values[L].take().map_or(0.0, |l| l.0), self.values[Q].take());
        let Some((input, _)) = digital.xor(analogue) else {
            return Err(Fault::new(span, "post-wait-input").allowed("post-wait-input-allowed"));
        };
        if how > 0.0 {
            let kind = if digital.is_some() { "digital" } else { "analogue" };
            state.event(Event::Message(format!("wait for {kind} input {input}").into()), true);
        }
        Ok(())
    }
}

/// With a process value called S the spindle's codes are the arc; else they are calls.
fn spindle(state: &State, code: u32) -> Event {
    match (state.addresses.letter(b'S'), code) {
        (Some(_), 3 | 4) => Event::Arc(true),
        (Some(_), _) => Event::Arc(false),
        (None, _) => Event::Call(format!("m{code}").into()),
    }
}
