use seamwright_message::{Message, Unit};

/// Error of a refused command or value. The state is then unchanged. Path lengths are in mm.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum FeedOverrideError {
    /// The override is out of range.
    Override { value: f64, greatest: f64 },
    /// The period of the set-points, s, is out of range.
    Period { value: f64 },
    /// A path length outside the path.
    Place { value: f64, length: f64 },
    /// The factor of the faster profile is out of range.
    Faster { value: f64 },
    /// A step to a path length that is `welded` already, or off the path.
    StepTo { value: f64, welded: f64, length: f64 },
    /// An order to move with an override of 0.
    Zero,
    /// The motion is stuck at `s`: the profile's rates are not finite there, or exceed the limits.
    Stuck { s: f64 },
}

impl FeedOverrideError {
    /// Describes the error.
    pub fn message(&self) -> Message {
        match *self {
            // A faster profile raises the maximum.
            Self::Override { value, greatest } if greatest < 1.5 => {
                Message::new("motion-override").value("value", value, Unit::One).value("max", greatest, Unit::One)
            }
            Self::Override { value, greatest } => Message::new("motion-override-faster")
                .value("value", value, Unit::One)
                .value("max", greatest, Unit::One),
            Self::Period { value } => Message::new("motion-period").value("value", value, Unit::S),
            Self::Place { value, length } => {
                Message::new("motion-path-length").value("value", value, Unit::Mm).value("length", length, Unit::Mm)
            }
            Self::Faster { value } => Message::new("motion-faster-profile").value("value", value, Unit::One),
            Self::StepTo { value, welded, length } => Message::new("motion-step-end")
                .value("value", value, Unit::Mm)
                .value("welded", welded, Unit::Mm)
                .value("length", length, Unit::Mm),
            Self::Zero => Message::new("motion-override-zero"),
            Self::Stuck { s } => Message::new("motion-stuck").value("s", s, Unit::Mm),
        }
    }
}

seamwright_message::display_by_message!(FeedOverrideError);
