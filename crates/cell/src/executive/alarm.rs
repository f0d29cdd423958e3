/// Reaction of the cell to an alarm, the mildest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reaction {
    /// Report only.
    Tell,
    /// Hold the program on its path, as by the operator: the crater is filled.
    Hold,
    /// Switch the process off at once, hold the program.
    ProcessOff,
    /// Switch the process off at once, stop on the path within limits, then switch the drives off.
    Stop,
    /// Switch process and drives off at once; the brakes close.
    PowerOff,
}

impl Reaction {
    /// Text of the catalogue.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tell => "told",
            Self::Hold => "hold",
            Self::ProcessOff => "process off, hold",
            Self::Stop => "process off, stop, power off",
            Self::PowerOff => "process and power off",
        }
    }
}

/// Alarms of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Alarm {
    /// An interlock condition of the machine file is not met; the detail is its number.
    Interlock,
    /// An axis' drive reports a fault.
    DriveFault,
    /// An axis is on a limit switch.
    LimitSwitch,
    /// The following error of an axis is too large.
    FollowingError,
    /// Drives have lost their power although it is requested.
    DrivePower,
    /// The drives do not answer.
    DrivesSilent,
    /// The drives have restarted: references are lost.
    DrivesRestarted,
    /// The references were not found in time.
    NoReference,
    /// The inputs are out of date.
    InputsSilent,
    /// The input device has restarted.
    InputsRestarted,
    /// The process source does not answer.
    SourceSilent,
    /// The process source has restarted.
    SourceRestarted,
    /// The process source reports a fault of its own.
    SourceFault,
    /// Arc or beam did not ignite.
    NoArc,
    /// Arc or beam was lost.
    ArcLost,
    /// Arc or beam is on although it is ordered off.
    ProcessStuckOn,
    /// A process value is out of tolerance; the detail is its number.
    ProcessValue,
    /// The wire sticks in the pool after the end.
    WireStuck,
    /// Cycles were missed.
    Overrun,
    /// The motion cannot continue.
    MotionStuck,
    /// The panel fell silent while axes were jogged.
    PanelSilent,
    /// Jogging was stopped by an obstacle or a limit.
    JogStopped,
    /// The record of the weld cannot be written.
    RecordFailing,
    /// Tracking does not see the joint or cannot follow it.
    Tracking,
    /// The drives ran out of set-points.
    Starved,
}

/// An entry of the catalogue of alarms (ISA-18.2): cause, consequence, operator action.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Entry {
    /// Name in a few words.
    pub name: &'static str,
    /// Cause.
    pub cause: &'static str,
    /// Consequence without an action.
    pub consequence: &'static str,
    /// Operator action.
    pub action: &'static str,
    /// Reaction of the cell.
    pub reaction: Reaction,
}

impl Alarm {
    /// All alarms, in the order of the catalogue.
    pub const ALL: [Self; 25] = [
        Self::Interlock,
        Self::DriveFault,
        Self::LimitSwitch,
        Self::FollowingError,
        Self::DrivePower,
        Self::DrivesSilent,
        Self::DrivesRestarted,
        Self::NoReference,
        Self::InputsSilent,
        Self::InputsRestarted,
        Self::SourceSilent,
        Self::SourceRestarted,
        Self::SourceFault,
        Self::NoArc,
        Self::ArcLost,
        Self::ProcessStuckOn,
        Self::ProcessValue,
        Self::WireStuck,
        Self::Overrun,
        Self::MotionStuck,
        Self::PanelSilent,
        Self::JogStopped,
        Self::RecordFailing,
        Self::Tracking,
        Self::Starved,
    ];

    /// Its number in the catalogue, from 1.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// Its entry in the catalogue.
    #[allow(clippy::too_many_lines, reason = "a table")]
    pub fn entry(self) -> Entry {
        use Reaction::{Hold, PowerOff, ProcessOff, Stop, Tell};
        let (name, cause, consequence, action, reaction) = match self {
            Self::Interlock => (
                "condition not met",
                "a door, vacuum, gas or coolant, as the machine file says",
                "as the condition's level says",
                "put right what is named",
                Tell,
            ),
            Self::DriveFault => (
                "drive fault",
                "over-current, over-temperature, encoder",
                "the axis may coast",
                "read the drive's own code, reset it",
                PowerOff,
            ),
            Self::LimitSwitch => (
                "limit switch",
                "an axis ran out of its range: wrong reference or parameter",
                "the mechanism would be damaged",
                "move it off by hand or with the drive's own tool, home again",
                PowerOff,
            ),
            Self::FollowingError => (
                "following error",
                "collision, a blocked guide, wrong tuning, a brake",
                "the torch is not where it should be",
                "look for what blocks the axis; check the tip before going on",
                Stop,
            ),
            Self::DrivePower => (
                "drives without power",
                "contactor, fuse or drive dropped out",
                "axes are held by brakes only",
                "look at the cabinet, switch on again",
                PowerOff,
            ),
            Self::DrivesSilent => {
                ("drives silent", "cable, bus or amplifier", "positions are unknown", "check the bus, reset", PowerOff)
            }
            Self::DrivesRestarted => (
                "drives restarted",
                "their supply was interrupted",
                "references are lost",
                "reset, switch on, home",
                PowerOff,
            ),
            Self::NoReference => (
                "no reference",
                "a reference switch or encoder",
                "positions are unknown",
                "check the switch, home again",
                Tell,
            ),
            Self::InputsSilent => (
                "inputs silent",
                "network or I/O device",
                "doors, gas and vacuum are unknown",
                "check the network and the device",
                Stop,
            ),
            Self::InputsRestarted => (
                "inputs restarted",
                "the I/O device's supply was interrupted",
                "its outputs fell to their safe states",
                "check outputs, reset",
                Stop,
            ),
            Self::SourceSilent => (
                "process source silent",
                "network or source",
                "arc or beam is unwatched",
                "check cable and source",
                ProcessOff,
            ),
            Self::SourceRestarted => (
                "process source restarted",
                "its supply was interrupted",
                "its settings may be lost",
                "check its settings, then go on",
                ProcessOff,
            ),
            Self::SourceFault => (
                "process source fault",
                "overheated, low gas or water, door of a laser, vacuum of a gun",
                "no weld",
                "read the source's own code",
                ProcessOff,
            ),
            Self::NoArc => (
                "no arc or beam",
                "dirt, insulation, end of wire, shutter",
                "nothing is welded",
                "clean, check wire and earth, go on",
                ProcessOff,
            ),
            Self::ArcLost => (
                "arc or beam lost",
                "wire, distance, discharge",
                "a crater where it went out",
                "grind it out, go on with overlap",
                ProcessOff,
            ),
            Self::ProcessStuckOn => (
                "arc or beam stays on",
                "contactor or interface of the source",
                "it burns through at rest",
                "emergency stop, disconnect the source",
                PowerOff,
            ),
            Self::ProcessValue => (
                "process value off",
                "feed, stick-out, cable, gap",
                "penetration or size of the weld",
                "look at the weld, adjust, go on",
                Hold,
            ),
            Self::WireStuck => ("wire stuck", "burn-back too short", "it bends when the torch leaves", "cut it", Hold),
            Self::Overrun => (
                "cycles missed",
                "this computer is too slow or busy for the period",
                "set-points come late",
                "stop other programs, see `seamwright latency`",
                Stop,
            ),
            Self::MotionStuck => (
                "motion stuck",
                "no way on within the axes' limits",
                "the torch stands on its path",
                "abort, plan again",
                ProcessOff,
            ),
            Self::PanelSilent => ("panel silent", "network or browser", "jogging stops", "jog again", Tell),
            Self::JogStopped => {
                ("jog stopped", "something is in the way, or an end of range", "none", "jog elsewhere", Tell)
            }
            Self::RecordFailing => (
                "record failing",
                "disk full or gone",
                "this weld has no complete record",
                "free the disk; decide whether to go on",
                Tell,
            ),
            Self::Tracking => (
                "tracking",
                "the joint is not seen or out of reach",
                "the weld may miss the joint",
                "look at sensor and joint, go on with overlap",
                ProcessOff,
            ),
            Self::Starved => (
                "set-points missing",
                "this computer is too busy, or `store` too short for it",
                "all axes stood still at once, beyond their limits",
                "look at the weld; stop other programs, or more `store`",
                Stop,
            ),
        };
        Entry { name, cause, consequence, action, reaction }
    }
}

/// The catalogue as a Markdown table.
pub fn catalogue() -> String {
    let mut text = String::from("| no. | alarm | cause | consequence | operator | cell |\n|---|---|---|---|---|---|\n");
    for alarm in Alarm::ALL {
        let e = alarm.entry();
        let line = [e.name, e.cause, e.consequence, e.action, e.reaction.name()].join(" | ");
        text += &format!("| {} | {line} |\n", alarm.number());
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_document_has_the_catalogue() {
        let text = include_str!("../../../../docs/executive.md");
        assert!(text.contains(&catalogue()), "docs/executive.md needs this table:\n{}", catalogue());
        for (i, alarm) in Alarm::ALL.into_iter().enumerate() {
            assert_eq!(alarm.number(), i + 1);
        }
    }
}
