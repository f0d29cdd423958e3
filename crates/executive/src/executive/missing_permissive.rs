use super::alarm::{Alarm, named};
use super::mode::Refused;
use seamwright_message::{Argument, Message, named_enum};
use serde::{Deserialize, Serialize};

/// Reasons why an action is not possible now.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
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

named_enum! {
    /// A device that does not answer.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    pub enum SilentDevice {
        /// The drives.
        Drives => "drives", "cell-device-drives";
        /// The input device.
        Inputs => "inputs", "cell-device-inputs";
        /// The process source.
        Source => "process source", "cell-device-source";
    }
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
