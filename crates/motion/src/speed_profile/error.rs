use crate::limit_kind::LimitKind;
use seamwright_message::{Message, Unit};

/// Error of a path without a speed profile. Channels count from 0; `at`, `from` and `to` are parameters of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum SpeedProfileError {
    /// A limit is not a positive number.
    Limit { channel: usize, kind: LimitKind, value: f64 },
    /// The requested speed, mm/s, is not a positive number.
    Asked { at: f64, value: f64 },
    /// The path has no length.
    Range { from: f64, to: f64 },
    /// A derivative is not a finite number.
    NotSmooth { channel: usize, at: f64 },
    /// No channel moves between two stops.
    Still { from: f64, to: f64 },
}

impl SpeedProfileError {
    /// Describes the error.
    pub fn message(&self) -> Message {
        match *self {
            Self::Limit { channel, kind, value } => Message::new("motion-profile-limit")
                .number("channel", channel as f64, 0)
                .message("limit", kind.message())
                .value("value", value, Unit::One),
            Self::Asked { at, value } => {
                Message::new("motion-profile-asked").value("at", at, Unit::One).value("value", value, Unit::MmPerS)
            }
            Self::Range { from, to } => {
                Message::new("motion-profile-range").value("from", from, Unit::One).value("to", to, Unit::One)
            }
            Self::NotSmooth { channel, at } => Message::new("motion-profile-not-smooth")
                .number("channel", channel as f64, 0)
                .value("at", at, Unit::One),
            Self::Still { from, to } => {
                Message::new("motion-profile-still").value("from", from, Unit::One).value("to", to, Unit::One)
            }
        }
    }
}

seamwright_message::display_by_message!(SpeedProfileError);
