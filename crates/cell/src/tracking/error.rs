/// Why a weld cannot be tracked in simulation.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// The machine's drives.
    #[error(transparent)]
    Cell(#[from] crate::Error),
    /// A head has no cross slide to correct with.
    #[error("head {head} of machine {machine} has no cross slide: two linear axes of its own")]
    NoSlide {
        /// Name of the machine.
        machine: String,
        /// Counted from 1.
        head: usize,
    },
    /// Settings that cannot work, as a lead too short for the speed.
    #[error(transparent)]
    Settings(#[from] seamwright_tracking::lead::Error),
}
