//! Simulated welding with tracking: seams that deviate from the taught ones, sensors that lead the torches, the
//! slides' drives, and the true distance of each weld from its seam.

pub mod beam;
pub(crate) mod carrier;
mod cross_talk;
mod displacement;
mod distortion;
mod error;
pub mod faults;
pub mod gates;
mod guide;
mod head_truth;
mod leading;
mod live_beam;
mod live_head;
mod motion;
mod off_path;
mod pass_scene;
mod pass_sensors;
mod rig;
mod scenario;
mod sensor;
pub mod shows;
mod sighting;
mod simulated_sensors;
pub mod stripes;
mod tally;
mod tracked_pass;
mod world;

use crate::Conditions;
use seamwright_machine::Machine;
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, TorchPath};

pub use cross_talk::cross_talk;
pub use displacement::{Displacement, Part};
pub use distortion::Distortion;
pub use error::{Error, OffLine};
pub use guide::Tracking;
pub(crate) use head_truth::HeadTruth;
pub use live_beam::{BeamFit, BeamSample, BeamSummary};
pub(crate) use live_head::LiveHead;
pub use live_head::{AlarmAt, HeadSample, HeadSummary};
pub use motion::Leg;
pub(crate) use pass_scene::{Correction, PassScene, Whole};
pub use rig::{Method, Outcome, run};
pub use scenario::{HeadScene, Scenario, Seam};
pub use seamwright_tracking::actuator::RESERVE;
pub use sensor::{Fault, Sees, SensorModel};
pub use simulated_sensors::SimulatedSensors;
pub use tracked_pass::trouble;
pub use world::{Along, Placement, World};

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
        return Err(Error::NoReplay { machine: machine.name.clone() });
    }
    let whole = Whole::of(passes);
    let hidden =
        passes.iter().zip(&motion.passes).filter(|((path, _), planned)| planned.arc && path.points().is_none());
    for (&(path, pass), planned) in hidden {
        let scene = PassScene::new(path, pass, None, whole);
        scene.truths(machine, planned, 0)?;
        if conditions.tracking {
            let correction = scene.correction(machine, planned)?;
            scene.heads(machine, planned, &correction, conditions.replay)?;
        }
    }
    Ok(())
}
