use crate::devices::fault::Fault;
use crate::tracking::distortion::Distortion;
use seamwright_machine::Surroundings;
use seamwright_tracking::beam::DeviationRecord;

/// Conditions of a simulated weld.
#[derive(Debug, Clone, Copy, Default)]
pub struct Conditions<'a> {
    /// Seed of all random numbers: the same seed gives the same weld, bit for bit.
    pub seed: u64,
    /// Deviation of the part from the plan; `None` for a part as planned.
    pub distortion: Option<&'a Distortion>,
    /// True if passes are tracked by the machine's leading sensors, or by its beam. The motion must leave the axes
    /// their [`seamwright_executive::tracking::RESERVE`].
    pub tracking: bool,
    /// Deviations of the seam recorded by the beam in an earlier weld: they correct the passes, without new tracking.
    pub replay: Option<&'a DeviationRecord>,
    /// Obstacles for the moves that tracking adds and for jogging; `None` for no collision check.
    pub around: Option<&'a Surroundings<'a>>,
    /// Injected faults.
    pub faults: &'a [Fault],
}
