//! Words common to LinuxCNC and grblHAL.

use super::feed_mode::FeedMode;
use super::number::fixed;
use super::writer::{Problem, Writer};
use crate::part_program::{Arc, Move, Path};
use seamwright_message::Message;
use std::f64::consts::TAU;

/// The modal state that lasts from block to block.
#[derive(Default)]
pub(super) struct Rs274 {
    mode: FeedMode,
    /// The axis normal to the plane of arcs: X, Y or Z; unknown at the start of a pass.
    plane: Option<usize>,
}

/// The state at the start of every program.
pub(super) const STATE: &str = "G21 G17 G90 G40 G49 G80 G94";

impl Rs274 {
    /// Resets the state, which the control may not have at the start of a pass.
    pub(super) fn forget(&mut self) {
        *self = Self::default();
    }

    /// Back to feeds per minute.
    pub(super) fn end(&mut self, w: &mut Writer) {
        if self.mode.inverse == Some(true) {
            w.text.line("G94");
        }
        self.mode = FeedMode::default();
    }

    /// Goes to a row.
    pub(super) fn go(&mut self, w: &mut Writer, step: &Move, to: &[f64]) -> Result<(), Problem> {
        let arc = match step.path {
            Path::Rapid | Path::Line => None,
            Path::Arc(index) => Some(w.arc(index)?),
            Path::Hermite(_) | Path::Spline | Path::Curve(_) => {
                return Err(Problem::plain("post-only-pmac", "post-plan-again-pmac"));
            }
        };
        if step.path == Path::Rapid {
            if w.order.iter().any(|i| w.changes(*i, to)) || !w.pending.is_empty() {
                w.text.word("G0");
                w.words(to, |_| false);
                w.end_move();
            }
            return Ok(());
        }
        let feed = self.feed(w, step, arc.as_ref(), to);
        match &arc {
            None => {
                w.text.word("G1");
                w.words(to, |_| false);
            }
            Some(arc) => self.arc(w, arc, to)?,
        }
        if let Some(feed) = feed {
            w.text.fine("F", feed);
        }
        w.end_move();
        Ok(())
    }

    /// The feed to be written, after its mode.
    fn feed(&mut self, w: &mut Writer, step: &Move, arc: Option<&Arc>, to: &[f64]) -> Option<f64> {
        let (mode, feed) = self.mode.words_before(w, step, arc, to);
        mode.into_iter().for_each(|mode| w.text.line(mode));
        feed
    }

    fn arc(&mut self, w: &mut Writer, arc: &Arc, to: &[f64]) -> Result<(), Problem> {
        let square = (0..3)
            .find(|k| arc.normal[*k].abs() > 1.0 - 1e-9)
            .ok_or_else(|| Problem::plain("post-arc-outside-planes", "post-plan-again-lines"))?;
        arc_words(w, &mut self.plane, square, arc);
        let mut plane = w.control.axes_xyz();
        plane[square] = None;
        w.words(to, |i| plane.contains(&Some(i)));
        let to_centre = arc.centre - w.place(&w.here);
        for k in (0..3).filter(|k| *k != square) {
            w.text.fine(["I", "J", "K"][k], to_centre[k]);
        }
        let turns = whole_turns(arc);
        if turns > 0 {
            w.text.counted("P", turns + 1);
        }
        Ok(())
    }
}

/// The plane of an arc, whose axis is `square` to it, if it is not in force; and G2 or G3.
pub(super) fn arc_words(w: &mut Writer, plane: &mut Option<usize>, square: usize, arc: &Arc) {
    if plane.replace(square) != Some(square) {
        w.text.word(["G19", "G18", "G17"][square]);
    }
    w.text.word(if arc.normal[square] * arc.sweep > 0.0 { "G3" } else { "G2" });
}

/// Full turns of an arc beyond its first one.
pub(super) fn whole_turns(arc: &Arc) -> u32 {
    ((arc.sweep.abs() / TAU - 1e-9).ceil() - 1.0).max(0.0) as u32
}

/// Sets a process value at its output or by its own word.
pub(super) fn set(w: &mut Writer, channel: usize, value: f64, at_once: bool) -> Result<(), Problem> {
    let control = w.control;
    let address = &control.addresses[channel];
    let name = &control.channels[channel].name;
    if let Some(output) = control.outputs[channel] {
        w.text.counted(if at_once { "M68 E" } else { "M67 E" }, u32::from(output));
        w.text.valued("Q", value);
    } else if address.len() == 1 && at_once {
        w.text.valued(address, value);
    } else if address.len() == 1 {
        w.with_next_move(&format!("{address}{}", fixed(value, 6)));
        return Ok(());
    } else {
        let cure = "post-value-without-output-cure";
        return Err(Problem::new(Message::new("post-value-without-output").text("name", name), cure));
    }
    match at_once && value == 0.0 {
        true => w.text.remark(&format!("{name} off")),
        false => w.text.remark(name),
    }
    w.text.end();
    Ok(())
}

pub(super) fn output(w: &mut Writer, output: u32, on: bool, at_once: bool) {
    let word = match (on, at_once) {
        (true, false) => "M62 P",
        (false, false) => "M63 P",
        (true, true) => "M64 P",
        (false, true) => "M65 P",
    };
    w.text.counted(word, output);
}

/// Words for the operator; the word `stop` stops the program.
pub(super) fn message(w: &mut Writer, text: &str) {
    match text {
        "stop" => w.text.line("M0"),
        text => {
            w.text.word("(MSG, ");
            w.text.clean(text, true);
            w.text.glue(")");
            w.text.end();
        }
    }
}

/// Waits.
pub(super) fn dwell(w: &mut Writer, seconds: f64, why: Option<&str>) {
    w.text.valued("G4 P", seconds);
    w.text.end_with(why);
}
