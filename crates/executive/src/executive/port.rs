use super::alarm::Alarm;
use super::alarm_list::{AlarmList, Place, Raised};
use super::command::Command;
use super::device_interface::{Orders, Reports};
use super::guide::Tracked;
use super::missing_permissive::Missing;
use super::mode::Mode;
use super::process::ProcessState;
use seamwright_message::{Message, Unit};
use seamwright_motion::feed_override::RunPhase;
use serde::{Deserialize, Serialize};
use std::ops::Deref;

/// Status of the executive.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Status {
    /// Time since the executive started, s.
    pub t: f64,
    /// The mode after this cycle.
    pub mode: Mode,
    /// Position in the program.
    pub place: Place,
    /// Phase of the pass; `None` outside passes.
    pub phase: Option<RunPhase>,
    /// Requested path speed, mm/s, including the feed override `feed_override`.
    pub speed: f64,
    /// The pass runs at the requested feed override, and arc or beam has burned long enough for its values to settle.
    pub steady: bool,
    /// Path length up to which the pass is welded, mm.
    pub welded_mm: f64,
    /// State of arc or beam.
    pub process: ProcessState,
    /// The next start of the process is allowed.
    pub armed: bool,
    /// Requested feed override, 0 to 1.
    pub feed_override: f64,
    /// Tracking state of each head; `None` without tracking.
    pub tracked: [Option<Tracked>; 2],
}

/// A cycle, as shown to the outside.
#[derive(Debug, Clone, Copy)]
pub struct Cycle<'a> {
    /// Status of the executive.
    pub status: Status,
    /// Orders to the devices at the start of the cycle.
    pub orders: &'a Orders,
    /// Device reports at its end.
    pub reports: &'a Reports,
    /// All alarms.
    pub alarms: &'a AlarmList,
}

impl Deref for Cycle<'_> {
    type Target = Status;

    fn deref(&self) -> &Status {
        &self.status
    }
}

/// An event for the log.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Note {
    /// The mode changed.
    Mode(Mode, Mode),
    /// A command was accepted.
    Taken(Command),
    /// A command was refused; the first reason.
    Refused(Command, Missing),
    /// One of the reasons against the action of an [`super::Ask::Why`].
    Lacks(Command, Missing),
    /// An alarm was raised.
    Alarm(Raised),
    /// The cause of an alarm has gone; with its axis or condition.
    Cleared(Alarm, u8),
    /// Missed cycles since the last note: their number, and the longest gap, ms.
    Missed(u32, f64),
    /// A pass has ended, welded up to this position.
    PassEnds(Place),
    /// Position at which an unfinished program was left and can resume.
    Left(Place),
}

impl Note {
    /// Returns the words of a note that is an event of a weld; `None` for refusals and alarms.
    pub fn message(&self) -> Option<Message> {
        let passed =
            |code, place: &Place| Message::new(code).pass("pass", place.pass).quantity("at", place.s_mm, Unit::Mm, 2);
        match self {
            Self::Mode(from, to) => {
                Some(Message::new("cell-event-mode").message("from", from.message()).message("to", to.message()))
            }
            Self::Taken(command) => Some(command.ask.message()),
            Self::Missed(cycles, longest_ms) => {
                let message = Message::new("cell-event-missed").count("n", *cycles as usize);
                Some(message.quantity("gap", *longest_ms, Unit::Ms, 0))
            }
            Self::PassEnds(place) => Some(passed("cell-event-pass-ends", place)),
            Self::Left(place) => Some(passed("cell-event-pass-left", place)),
            Self::Refused(..) | Self::Lacks(..) | Self::Alarm(_) | Self::Cleared(..) => None,
        }
    }
}

/// Interface of an executive to the outside. Must neither allocate nor lock: real implementations use queues.
pub trait Port {
    /// Returns the next command, if any.
    fn command(&mut self, t: f64) -> Option<Command>;
    /// Shows a completed cycle.
    fn show(&mut self, cycle: &Cycle<'_>);
    /// Records an event at time `t`, s.
    fn note(&mut self, t: f64, note: Note);
    /// Returns true once the record has lost data.
    fn record_fails(&self) -> bool {
        false
    }
    /// Returns true once a shutdown is requested: process off, axes at rest, power off.
    fn shuts_down(&self) -> bool {
        false
    }
}

impl<P: Port + ?Sized> Port for &mut P {
    fn command(&mut self, t: f64) -> Option<Command> {
        (**self).command(t)
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        (**self).show(cycle);
    }

    fn note(&mut self, t: f64, note: Note) {
        (**self).note(t, note);
    }

    fn record_fails(&self) -> bool {
        (**self).record_fails()
    }

    fn shuts_down(&self) -> bool {
        (**self).shuts_down()
    }
}
