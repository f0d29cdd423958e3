use crate::executive::VALUES;
use thiserror::Error;

/// Why a cell cannot run.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Error {
    /// A drive's values do not make a drive.
    #[error("drive of axis {axis}: {reason}")]
    Drive {
        /// Name of the axis.
        axis: String,
        /// What is wrong.
        reason: String,
    },
    /// A pass that cannot be tracked.
    #[error(transparent)]
    Tracking(Box<crate::tracking::Error>),
    /// More process values than a cell carries.
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
