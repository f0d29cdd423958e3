use crate::tracking::trouble;
use seamwright_message::{Argument, Message, named_enum};
use serde::{Deserialize, Serialize};

named_enum! {
    /// Reaction of the cell to an alarm, the mildest first.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
    pub enum Reaction {
        /// Report only.
        Tell => "told", "alarm-reaction-report";
        /// Hold the program on its path, as by the operator: the crater is filled.
        Hold => "hold", "alarm-reaction-hold";
        /// Switch the process off at once, hold the program.
        ProcessOff => "process off, hold", "alarm-reaction-process-off";
        /// Switch the process off at once, stop on the path within limits, then switch the drives off.
        Stop => "process off, stop, power off", "alarm-reaction-stop";
        /// Switch process and drives off at once; the brakes close.
        PowerOff => "process and power off", "alarm-reaction-power-off";
    }
}

named_enum! {
    /// Alarms of a cell.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
    pub enum Alarm {
        /// An interlock condition of the machine file is not met; the detail is its number.
        Interlock => "condition not met",
        /// An axis' drive reports a fault.
        DriveFault => "drive fault",
        /// An axis is on a limit switch.
        LimitSwitch => "limit switch",
        /// The following error of an axis is too large.
        FollowingError => "following error",
        /// Drives have lost their power although it is requested.
        DrivePower => "drives without power",
        /// The drives do not answer.
        DrivesSilent => "drives silent",
        /// The drives have restarted: references are lost.
        DrivesRestarted => "drives restarted",
        /// The references were not found in time.
        NoReference => "no reference",
        /// The inputs are out of date.
        InputsSilent => "inputs silent",
        /// The input device has restarted.
        InputsRestarted => "inputs restarted",
        /// The process source does not answer.
        SourceSilent => "process source silent",
        /// The process source has restarted.
        SourceRestarted => "process source restarted",
        /// The process source reports a fault of its own.
        SourceFault => "process source fault",
        /// Arc or beam did not ignite.
        NoArc => "no arc or beam",
        /// Arc or beam was lost.
        ArcLost => "arc or beam lost",
        /// Arc or beam is on although it is ordered off.
        ProcessStuckOn => "arc or beam stays on",
        /// A process value is out of tolerance; the detail is its number.
        ProcessValue => "process value off",
        /// The wire sticks in the pool after the end.
        WireStuck => "wire stuck",
        /// Cycles were missed.
        Overrun => "cycles missed",
        /// The motion cannot continue.
        MotionStuck => "motion stuck",
        /// The panel fell silent while axes were jogged.
        PanelSilent => "panel silent",
        /// Jogging was stopped by an obstacle or a limit.
        JogStopped => "jog stopped",
        /// The record of the weld cannot be written.
        RecordFailing => "record failing",
        /// Tracking does not see the joint or cannot follow it.
        Tracking => "tracking",
        /// The drives ran out of set-points.
        Starved => "set-points missing",
    }
}

/// An entry of the catalogue of alarms (ISA-18.2): cause, consequence, operator action. Its words have codes like
/// `alarm-17-cause`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// Its name in files and interfaces.
    pub name: &'static str,
    /// Title: the alarm in a few words.
    pub title: Message,
    /// Cause.
    pub cause: Message,
    /// Consequence without an action.
    pub consequence: Message,
    /// Operator action.
    pub action: Message,
    /// Reaction of the cell.
    pub reaction: Reaction,
}

impl Alarm {
    /// Its number in the catalogue, from 1.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// Reaction of the cell.
    pub fn reaction(self) -> Reaction {
        self.rationalisation().reaction
    }

    /// Its entry in the catalogue.
    pub fn entry(self) -> Entry {
        let words =
            |part: &str| Message { code: format!("alarm-{}-{part}", self.number()).into(), arguments: Vec::new() };
        Entry {
            name: self.name(),
            title: words("title"),
            cause: words("cause"),
            consequence: words("consequence"),
            action: words("action"),
            reaction: self.reaction(),
        }
    }
}

impl Alarm {
    /// Returns the axis, the interlock or the trouble of tracking that `detail` means, with the names of `axes` and
    /// `conditions`; `None` for an alarm that has none.
    pub fn about(self, detail: u8, axes: &[&str], conditions: &[&str]) -> Option<Message> {
        match self {
            Self::Interlock => Some(Message::verbatim(named(conditions, detail))),
            Self::DriveFault | Self::LimitSwitch | Self::FollowingError => Some(Message::verbatim(named(axes, detail))),
            Self::Tracking => trouble(detail),
            _ => None,
        }
    }

    /// Returns its title, with what it is about.
    pub fn title_of(self, about: Option<Message>) -> Message {
        let title = self.entry().title;
        match about {
            Some(about) => Message::new("alarm-of").message("title", title).message("of", about),
            None => title,
        }
    }

    /// Returns the alarm of a [title](Self::title_of), and what it is about. Older versions have recorded sentences:
    /// `NAME` or `NAME (OF)`.
    pub fn from_title(title: &Message) -> Option<(Self, Option<Message>)> {
        let of_code = |code: &str| {
            let number: usize = code.strip_prefix("alarm-")?.strip_suffix("-title")?.parse().ok()?;
            Self::ALL.get(number.checked_sub(1)?).copied()
        };
        match (title.code.as_ref(), title.argument("title"), title.argument("of"), title.argument("text")) {
            ("alarm-of", Some(Argument::Message(title)), Some(Argument::Message(of)), _) => {
                Some((of_code(&title.code)?, Some((**of).clone())))
            }
            ("text", _, _, Some(Argument::Text(text))) => {
                let split = text.strip_suffix(')').and_then(|text| text.split_once(" ("));
                let (name, of) = split.map_or((text.as_str(), None), |(name, of)| (name, Some(of)));
                Some((Self::ALL.into_iter().find(|alarm| alarm.name() == name)?, of.map(Message::verbatim)))
            }
            (code, ..) => Some((of_code(code)?, None)),
        }
    }
}

/// Name of item `i`, counted from 0.
pub(super) fn named(names: &[&str], i: u8) -> String {
    names.get(usize::from(i)).map_or_else(|| format!("{}", u16::from(i) + 1), ToString::to_string)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn alarms_are_numbered_in_their_order() {
        for (i, alarm) in Alarm::ALL.into_iter().enumerate() {
            assert_eq!(alarm.number(), i + 1);
        }
    }

    #[test]
    fn an_alarm_is_found_by_its_title() {
        for alarm in Alarm::ALL {
            for about in [None, Some(Message::verbatim("door (left)"))] {
                assert_eq!(Alarm::from_title(&alarm.title_of(about.clone())), Some((alarm, about)));
            }
            let old = Message::verbatim(format!("{} (door (left))", alarm.name()));
            assert_eq!(Alarm::from_title(&old), Some((alarm, Some(Message::verbatim("door (left)")))));
            assert_eq!(Alarm::from_title(&Message::verbatim(alarm.name())), Some((alarm, None)));
        }
    }
}
