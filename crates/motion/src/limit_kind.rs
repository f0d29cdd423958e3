use seamwright_machine::AxisKind;
use seamwright_message::{Message, Unit};

/// Kind of a limit of an axis or of the torch tip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LimitKind {
    /// Maximum speed.
    Speed,
    /// Maximum acceleration.
    Acceleration,
    /// Maximum jerk.
    Jerk,
}

impl LimitKind {
    /// Name in files: `speed`, `acceleration` or `jerk`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Speed => "speed",
            Self::Acceleration => "acceleration",
            Self::Jerk => "jerk",
        }
    }

    /// Message that names the limit.
    pub fn message(self) -> Message {
        Message::new(match self {
            Self::Speed => "motion-limit-speed",
            Self::Acceleration => "motion-limit-acceleration",
            Self::Jerk => "motion-limit-jerk",
        })
    }

    /// Unit of the limit of an axis, as in files.
    pub fn unit(self, axis: AxisKind) -> Unit {
        match (axis, self) {
            (AxisKind::Linear, Self::Speed) => Unit::MmPerS,
            (AxisKind::Linear, Self::Acceleration) => Unit::MmPerS2,
            (AxisKind::Linear, Self::Jerk) => Unit::MmPerS3,
            (AxisKind::Rotary, Self::Speed) => Unit::DegPerS,
            (AxisKind::Rotary, Self::Acceleration) => Unit::DegPerS2,
            (AxisKind::Rotary, Self::Jerk) => Unit::DegPerS3,
        }
    }
}
