use super::alarm::{Alarm, named};
use super::alarm_list::{AlarmList, Place, Raised};
use super::bus::{Orders, Reports};
use super::command::Command;
use super::guide::Tracked;
use super::mode::{Mode, Refused};
use super::process::ProcessState;
use seamwright_message::{Argument, Message, Unit};
use seamwright_motion::feed_override::RunPhase;
use std::ops::Deref;

/// Status of the executive.
#[derive(Debug, Clone, Copy, PartialEq)]
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
#[derive(Debug, Clone, Copy, PartialEq)]
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

/// Reasons why an action is not possible now.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Missing {
    /// The mode does not accept it.
    Mode(Refused),
    /// The axes still move.
    Moving,
    /// Axes with unknown references, one bit each.
    References(u16),
    /// Another axis must go home first: its number from 0.
    HomesFirst(u8),
    /// The drives have no power yet.
    Power,
    /// A device has been silent for too long.
    Silent(SilentDevice),
    /// An interlock condition is not met: its number from 0.
    Condition(u8),
    /// An alarm is active or unacknowledged; with its axis or condition.
    Alarm(Alarm, u8),
    /// The process was not armed, or the arming has expired.
    Arming,
    /// The process source is not ready.
    Source,
    /// The axes are not at the start of the approach: the number of the axis with the largest deviation.
    NotAtStart(u8),
    /// No program is loaded.
    Work,
    /// The value is out of range.
    Value,
    /// The motion does not allow it.
    Motion,
}

/// A device that does not answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SilentDevice {
    /// The drives.
    Drives,
    /// The input device.
    Inputs,
    /// The process source.
    Source,
}

impl Missing {
    /// Returns its message, with the names of `axes` and `conditions`.
    pub fn message(&self, axes: &[&str], conditions: &[&str]) -> Message {
        let axis = |i: u8| named(axes, i);
        match self {
            Self::Mode(refused) => refused.message(),
            Self::Moving => Message::new("cell-missing-rest"),
            Self::References(bits) => {
                let unknown = (0..16u8).filter(|i| bits >> i & 1 == 1);
                Message::new("cell-missing-references").list("axes", unknown.map(|i| Argument::Axis(axis(i))))
            }
            Self::HomesFirst(i) => Message::new("cell-missing-homes-first").axis("axis", axis(*i)),
            Self::Power => Message::new("cell-missing-power"),
            Self::Silent(device) => Message::new("cell-missing-answer").message("device", device.message()),
            Self::Condition(i) => Message::new("cell-missing-interlock").text("interlock", named(conditions, *i)),
            Self::Alarm(alarm, detail) => {
                let title = alarm.title_of(alarm.about(*detail, axes, conditions));
                let message = Message::new("cell-missing-acknowledgement").message("alarm", title);
                message.message("action", alarm.entry().action)
            }
            Self::Arming => Message::new("cell-missing-arming"),
            Self::Source => Message::new("cell-missing-source"),
            Self::NotAtStart(i) => Message::new("cell-missing-start").axis("axis", axis(*i)),
            Self::Work => Message::new("cell-missing-program"),
            Self::Value => Message::new("cell-missing-value"),
            Self::Motion => Message::new("cell-missing-motion"),
        }
    }
}

impl SilentDevice {
    /// Its name in interfaces.
    pub fn name(self) -> &'static str {
        match self {
            Self::Drives => "drives",
            Self::Inputs => "inputs",
            Self::Source => "process source",
        }
    }

    fn message(self) -> Message {
        Message::new(match self {
            Self::Drives => "cell-device-drives",
            Self::Inputs => "cell-device-inputs",
            Self::Source => "cell-device-source",
        })
    }
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
