use crate::executive::VALUES;
use thiserror::Error;

/// Reasons why a cell cannot run.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Error {
    /// Invalid drive values.
    #[error("drive of axis {axis}: {reason}")]
    Drive {
        /// Name of the axis.
        axis: String,
        /// The reason.
        reason: String,
    },
    /// A pass does not allow tracking.
    #[error(transparent)]
    Tracking(Box<crate::tracking::Error>),
    /// Too many process values.
    #[error("the program has {0} process values\n   allowed: up to {VALUES}")]
    Values(usize),
}

impl From<crate::tracking::Error> for Error {
    fn from(error: crate::tracking::Error) -> Self {
        match error {
            crate::tracking::Error::Cell(error) => *error,
            other => Self::Tracking(Box::new(other)),
        }
    }
}
