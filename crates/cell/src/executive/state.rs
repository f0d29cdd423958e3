use super::alarm_list::{AlarmList, Place, Raised};
use super::command::{Ask, Command};
use super::{Alarm, Mode, Orders, ProcessState, Refused, Reports, Tracked};
use seamwright_motion::pace::RunPhase;
use std::ops::Deref;

/// What the executive is doing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Status {
    /// Time since the executive began, s.
    pub t: f64,
    /// The mode after this cycle.
    pub mode: Mode,
    /// Where on the program.
    pub place: Place,
    /// What a pass is doing; none beside passes.
    pub phase: Option<RunPhase>,
    /// Speed along the path that is asked of the axes, mm/s: `pace` is in it.
    pub speed: f64,
    /// The pass is travelled at the pace that is asked for, with arc or beam burning long enough for its values to have settled.
    pub steady: bool,
    /// Path length up to which the pass is welded, mm.
    pub welded_mm: f64,
    /// Arc or beam.
    pub process: ProcessState,
    /// The next start of the process is allowed.
    pub armed: bool,
    /// Part of the planned speed that is asked for.
    pub pace: f64,
    /// What tracking knows and does, of each head; none where it does nothing.
    pub tracked: [Option<Tracked>; 2],
}

/// What a cycle was, as shown to the outside.
#[derive(Debug, Clone, Copy)]
pub struct Cycle<'a> {
    /// What the executive is doing.
    pub status: Status,
    /// What was asked of the devices at the begin of the cycle.
    pub orders: &'a Orders,
    /// What they reported at its end.
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

/// Something that happened, for the log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Note {
    /// The mode changed.
    Mode(Mode, Mode),
    /// A command was taken.
    Taken(Command),
    /// A command was refused, for the first of what is missing.
    Refused(Command, Missing),
    /// This stands against what was asked about: one of several.
    Lacks(Command, Missing),
    /// An alarm came.
    Alarm(Raised),
    /// Its cause has gone; which axis or condition.
    Cleared(Alarm, u8),
    /// Cycles were missed of late: how many, and the longest time without one, ms.
    Missed(u32, f64),
    /// A pass came to its end, welded up to there.
    PassEnds(Place),
    /// Where a program was left that can be gone on with.
    Left(Place),
}

/// Why something cannot be done now.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Missing {
    /// It has no meaning in this mode.
    Mode(Refused),
    /// What ran before has not come to rest.
    Moving,
    /// Axes whose reference is not known, a bit each.
    References(u16),
    /// This axis goes home before: its number from 0.
    HomesFirst(u8),
    /// The drives have no power yet.
    Power,
    /// A device has not been heard of for too long: drives, inputs or source.
    Silent(&'static str),
    /// A condition is not met: its number from 0.
    Condition(u8),
    /// An alarm is there or not acknowledged; and which axis or condition.
    Alarm(Alarm, u8),
    /// The process was not armed, or too long ago.
    Arming,
    /// The process source is not ready.
    Source,
    /// The axes are not where the way to the weld begins: this one is farthest off.
    NotAtStart(u8),
    /// No program is loaded.
    Work,
    /// The number is outside what is allowed.
    Value,
    /// The motion refuses it.
    Motion,
}

impl Missing {
    /// In words, with the names of `axes` and `conditions`.
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

/// What the outside is to an executive. Must neither allocate nor lock: a real one puts things into queues.
pub trait Port {
    /// The next command, if there is one.
    fn command(&mut self, t: f64) -> Option<Command>;
    /// A cycle has been.
    fn show(&mut self, cycle: &Cycle<'_>);
    /// Something happened at time `t`.
    fn note(&mut self, t: f64, note: Note);
    /// True once the record has lost something.
    fn record_fails(&self) -> bool {
        false
    }
    /// True once everything shall come to its end: process off, axes at rest, power off.
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
    /// True for what is never a mistake to ask.
    pub(super) fn stops(&self) -> bool {
        matches!(self, Self::Stop | Self::Hold)
    }
}
