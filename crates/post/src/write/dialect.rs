//! Differences between the dialects. What one does not say about outputs, messages and times it says as RS274 does.

use super::rs274;
use super::writer::{Problem, Writer};
use crate::part_program::{Event, Level, Move};

/// A dialect, with its state between lines.
pub(super) trait Tongue {
    /// Whether several passes become sub-programs, and whether these come before the main part.
    const SUBS: Option<bool>;

    /// The very first lines, before the comments.
    fn first(&mut self, _w: &mut Writer) {}

    /// The usual lines at the start of the main part.
    fn head(&mut self, w: &mut Writer);

    /// The start of pass `number` (from 1), in a sub-program of its own or not.
    fn begin(&mut self, w: &mut Writer, number: u32, name: &str, sub: bool);

    fn end(&mut self, w: &mut Writer, number: u32, sub: bool);

    /// The line of the main part that runs pass `number`.
    fn call(&mut self, _w: &mut Writer, _number: u32, _name: &str) {}

    /// The usual lines at the end.
    fn tail(&mut self, w: &mut Writer) {
        w.text.line("M2");
    }

    /// Describes how to start again at a pass.
    fn restart(&self, passes: u32) -> String;

    /// Lines that make the control go over to axes or tip.
    fn level(&mut self, _w: &mut Writer, _level: Level) {}

    /// Called before actions at once, with the machine at rest.
    fn wait(&mut self, _w: &mut Writer) {}

    /// A block of motion to the row `to`; the changes are in `w`.
    fn go(&mut self, w: &mut Writer, step: &Move, to: &[f64]) -> Result<(), Problem>;

    fn set(&mut self, w: &mut Writer, channel: usize, value: f64, at_once: bool) -> Result<(), Problem> {
        rs274::set(w, channel, value, at_once)
    }

    fn output(&mut self, w: &mut Writer, output: u32, on: bool, at_once: bool) {
        rs274::output(w, output, on, at_once);
    }

    fn message(&mut self, w: &mut Writer, text: &str) {
        rs274::message(w, text);
    }

    /// Switches events that need no output; false if the dialect has no word for this one.
    fn own(&mut self, _w: &mut Writer, _event: &Event, _at_once: bool) -> bool {
        false
    }

    /// Waits, s.
    fn dwell(&mut self, w: &mut Writer, seconds: f64, why: Option<&str>) {
        rs274::dwell(w, seconds, why);
    }
}
