//! Meaning of the codes of a line, and the actions at its end.

use super::line::Line;
use crate::read::error::{Fault, Read, Span, once};
use crate::read::lines::Flow;
use crate::read::modal_state::{FeedMode, Motion, State};
use seamwright_message::Message;

/// Siemens' G groups, as bits.
pub(super) const MOTION: u32 = 1;
const ONCE: u32 = 2;
const PLANE: u32 = 4;
const CUTTER: u32 = 8;
const OFFSET: u32 = 16;
const SUPPRESS: u32 = 32;
const CONTROL: u32 = 64;
const STOP_ONCE: u32 = 128;
const UNITS: u32 = 256;
const DISTANCE: u32 = 512;
const FEED: u32 = 1024;
const STOP: u32 = 2048;

const G_CODES: &str =
    "G0 G1 G2 G3 CIP POLY G4 G9 G17 G18 G19 G40 G53 G54-G57 G500 G60 G64 G641-G645 G70 G71 G700 G710 G90 G91 G93 G94";
const M_CODES: &str = "M0 M1 M2 M17 M30";

impl Line {
    pub(super) fn group(&mut self, group: u32, span: Span) -> Read {
        once(&mut self.groups, group, span)
    }

    /// A G-code, in tenths.
    #[inline]
    pub(super) fn g_code(&mut self, code: u32, state: &mut State, span: Span) -> Read {
        if state.own_code(b'G', code) {
            return Ok(());
        }
        let number = if code.is_multiple_of(10) { code / 10 } else { u32::MAX };
        let group = match number {
            0..=3 => MOTION,
            4 => ONCE,
            9 => STOP_ONCE,
            17..=19 => PLANE,
            40 => CUTTER,
            53 => SUPPRESS,
            54..=57 | 500 => OFFSET,
            60 | 64 | 641..=645 => CONTROL,
            70 | 71 | 700 | 710 => UNITS,
            90 | 91 => DISTANCE,
            93 | 94 => FEED,
            95 => {
                return Err(Fault::unknown(span, "post-feed-per-turn").cure("post-feed-per-turn-cure"));
            }
            _ => return Err(Fault::unknown(span, "post-unknown-g-code").allowed(Message::verbatim(G_CODES))),
        };
        self.group(group, span)?;
        match number {
            0 => state.motion = Some(Motion::Rapid),
            1 => state.motion = Some(Motion::Line),
            2 => state.motion = Some(Motion::Clockwise),
            3 => state.motion = Some(Motion::Counterclockwise),
            4 => self.dwell = Some(span),
            9 => self.block.exact_stop = true,
            17 => state.plane = 2,
            18 => state.plane = 1,
            19 => state.plane = 0,
            54..=57 => state.note("post-offsets-zero"),
            60 => state.exact_stop = true,
            64 | 641..=645 => state.exact_stop = false,
            70 | 71 | 700 | 710 => (state.inch, state.inch_feed) = (matches!(number, 70 | 700), number == 700),
            90 | 91 => state.incremental = number == 91,
            93 => state.set_mode(FeedMode::InverseTime),
            94 => state.set_mode(FeedMode::PerMinute),
            _ => {}
        }
        Ok(())
    }

    /// An M-code, in tenths.
    pub(super) fn m_code(&mut self, code: u32, state: &mut State, span: Span) -> Read {
        if state.own_code(b'M', code) {
            return Ok(());
        }
        if !matches!(code, 0 | 10 | 20 | 170 | 300) {
            return Err(Fault::unknown(span, "post-unknown-m-code")
                .allowed(Message::new("post-m-codes-allowed").text("codes", M_CODES)));
        }
        self.group(STOP, span)?;
        self.stop = Some(code / 10);
        Ok(())
    }

    #[inline]
    pub(super) fn finish(self, state: &mut State) -> Read<Flow> {
        let moves = state.target.count > 0 || self.block.has_arc_word();
        state.flush(moves);
        if let Some(code) = self.dwell {
            if moves {
                let place = state.target.span().unwrap_or(code);
                return Err(Fault::new(place, "post-moves-with-dwell").cure("post-two-blocks"));
            }
            let Some((seconds, span)) = self.feed else {
                return Err(Fault::new(code, "post-dwell-needs-f").cure("post-dwell-needs-f-cure"));
            };
            state.dwell(seconds, false, span)?;
        } else {
            if let Some((value, span)) = self.feed {
                State::check_feed(value, span)?;
                state.feed = Some(value);
            }
            state.go(&self.block)?;
        }
        Ok(state.stop(self.stop).or(self.flow).unwrap_or(Flow::Next))
    }
}
