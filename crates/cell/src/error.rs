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
    /// A head has no cross slide to correct with.
    #[error("head {head} of machine {machine} has no cross slide: two linear axes of its own")]
    NoSlide {
        /// Name of the machine.
        machine: String,
        /// Counted from 1.
        head: usize,
    },
    /// Tracking cannot work like this.
    #[error(transparent)]
    Tracking(#[from] seamwright_tracking::lead::Error),
}
