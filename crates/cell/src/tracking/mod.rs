//! Welding with tracking, in simulation: seams that lie and move otherwise than they were taught, sensors that lead the
//! torches, the slides' drives, and how far each weld truly is from its seam.

pub mod beam;
pub(crate) mod carrier;
mod cross_talk;
mod displacement;
mod distortion;
mod error;
mod eyes;
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
mod rig;
mod scenario;
mod sensor;
pub mod shows;
mod sighting;
pub mod stripes;
mod tally;
mod tracked_pass;
mod twin;
mod world;

use crate::Conditions;
use seamwright_machine::Machine;
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, TorchPath};

pub use cross_talk::cross_talk;
pub use displacement::{Displacement, Part};
pub use distortion::Distortion;
pub use error::Error;
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
pub use tracked_pass::trouble;
pub use twin::SimulatedSensors;
pub use world::{Along, Placement, World};

/// Looks whether every pass with an arc can be simulated under `conditions`: on a part that lies elsewhere, and tracked.
///
/// # Errors
/// The first that cannot: one that blends corners, or that two torches or a beam weave; nothing that sees ahead, too short a lead, axes that cannot
/// correct; stored deviations that do not cover it, or that no beam can replay.
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
    let hidden = passes.iter().zip(&motion.passes).filter(|((path, _), planned)| planned.arc && !path.is_timed());
    for (pass, planned) in hidden {
        let scene = PassScene::new(*pass, None, whole);
        scene.truths(machine, planned, 0)?;
        if conditions.tracking {
            let correction = scene.correction(machine, planned)?;
            scene.heads(machine, planned, &correction, conditions.replay)?;
        }
    }
    Ok(())
}
