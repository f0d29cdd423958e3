use super::alarm_list::{AlarmList, Place, Raised};
use super::command::{Ask, Command};
use super::{Alarm, Mode, Orders, ProcessState, Refused, Reports, Tracked};
use seamwright_motion::pace::RunPhase;
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
    /// Requested path speed, mm/s, including the feed override `pace`.
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
    pub pace: f64,
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
    /// One of the reasons against the action of an [`Ask::Why`].
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
    /// A device has been silent for too long: drives, inputs or source.
    Silent(&'static str),
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

impl Missing {
    /// Returns the text, with the names of `axes` and `conditions`.
    pub fn text(&self, axes: &[&str], conditions: &[&str]) -> String {
        let name =
            |names: &[&str], i: u8| names.get(usize::from(i)).map_or_else(|| format!("no. {i}"), ToString::to_string);
        match self {
            Self::Mode(refused) => refused.to_string(),
            Self::Moving => "the axes have not come to rest: wait a moment".to_owned(),
            Self::References(bits) => {
                let list: Vec<String> = (0..16u8).filter(|i| bits >> i & 1 == 1).map(|i| name(axes, i)).collect();
                format!("the reference of {} is not known: home first", list.join(", "))
            }
            Self::HomesFirst(i) => format!("axis {} goes home first: so says the machine file", name(axes, *i)),
            Self::Power => "the drives have no power yet: wait a moment".to_owned(),
            Self::Silent(device) => format!("the {device} cannot be heard: check cable and device"),
            Self::Condition(i) => format!("`{}` is not met", name(conditions, *i)),
            Self::Alarm(alarm, i) => {
                let of = match alarm {
                    Alarm::Interlock => format!(" ({})", name(conditions, *i)),
                    Alarm::DriveFault | Alarm::LimitSwitch | Alarm::FollowingError => {
                        format!(" (axis {})", name(axes, *i))
                    }
                    _ => String::new(),
                };
                let entry = alarm.entry();
                format!("alarm `{}`{of}: {}, then acknowledge", entry.name, entry.action)
            }
            Self::Arming => "the process is not armed: arm, then start within a minute".to_owned(),
            Self::Source => "the process source is not ready".to_owned(),
            Self::NotAtStart(i) => {
                format!("axis {} is not where the way to the weld begins", name(axes, *i))
            }
            Self::Work => "no program is loaded".to_owned(),
            Self::Value => "the number is outside what is allowed".to_owned(),
            Self::Motion => "the motion cannot do that now".to_owned(),
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

impl Ask {
    /// Returns true for commands that are always accepted.
    pub(super) fn stops(&self) -> bool {
        matches!(self, Self::Stop | Self::Hold)
    }
}
