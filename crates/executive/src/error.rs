use crate::executive::VALUES;
use seamwright_message::{Message, Unit, display_by_message};

/// Reasons why a cell cannot run.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// Invalid drive values.
    Drive {
        /// Name of the axis.
        axis: String,
        /// The reason.
        reason: Message,
    },
    /// Too many process values.
    Values(usize),
}

impl Error {
    /// Returns its message.
    pub fn message(&self) -> Message {
        match self {
            Self::Drive { axis, reason } => {
                Message::new("cell-invalid-drive").axis("axis", axis).message("why", reason.clone())
            }
            Self::Values(count) => {
                Message::new("cell-too-many-process-values").count("n", *count).value("max", VALUES as f64, Unit::One)
            }
        }
    }
}

display_by_message!(Error);
