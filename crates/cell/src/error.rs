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
}
