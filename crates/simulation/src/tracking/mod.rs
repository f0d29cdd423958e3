//! Simulated welding with tracking: seams that deviate from the taught ones, sensors that lead the torches, the
//! slides' drives, and the true distance of each weld from its seam.

pub mod acceptance;
pub mod beam;
mod displacement;
pub(crate) mod distortion;
pub(crate) mod head_result;
pub(crate) mod head_truth;
pub(crate) mod pass_scene;
mod scenario;
mod scenario_run;
mod sensor_model;
pub(crate) mod simulated_sensors;
mod travel;
mod weld_statistics;
mod world;

use crate::conditions::Conditions;
use crate::error::Error;
use seamwright_executive::tracking::{self, PassSeams};
use seamwright_machine::Machine;
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, TorchPath};

pub use displacement::{Displacement, Part};
pub use distortion::Distortion;
pub use head_result::{HeadSample, HeadSummary};
pub use scenario::{HeadScene, Scenario};
pub use scenario_run::{Method, Outcome, run};
pub use sensor_model::{Fault, Sees, SensorModel};
pub use simulated_sensors::SimulatedSensors;
pub use travel::Leg;
pub use world::{Placement, World};

/// Checks that every pass with an arc can be simulated under `conditions`: on a displaced part, and tracked.
///
/// # Errors
/// The first pass that cannot: blended corners; weaving by two torches or a beam; no sensor ahead; too short a lead;
/// axes that cannot correct; stored deviations that do not cover it or that no beam can replay.
pub fn check(
    machine: &Machine,
    passes: &[(&dyn TorchPath, &Pass)],
    motion: &WeldMotion,
    conditions: &Conditions<'_>,
) -> Result<(), Error> {
    if conditions.replay.is_some() && machine.deflection.is_none() {
        return Err(tracking::Error::NoReplay { machine: machine.name.clone() }.into());
    }
    let hidden =
        passes.iter().zip(&motion.passes).filter(|((path, _), planned)| planned.arc && path.points().is_none());
    for (&(path, pass), planned) in hidden {
        let seams = PassSeams::new(path, pass);
        seams.check_plain(machine, planned)?;
        if conditions.tracking {
            seams.check_tracking(machine, planned, conditions.replay)?;
        }
    }
    Ok(())
}
