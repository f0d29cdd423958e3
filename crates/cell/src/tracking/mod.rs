//! Welding with tracking, in simulation: seams that lie and move otherwise than they were taught, sensors that lead the
//! torches, the slides' drives, and how far each weld truly is from its seam.

mod carrier;
mod displacement;
mod distortion;
mod error;
pub mod gates;
mod live_head;
mod motion;
mod pass_scene;
mod rig;
mod scenario;
mod sensor;
pub mod shows;
mod tally;
mod world;

use seamwright_machine::Machine;
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, TorchPath};

pub use displacement::{Displacement, Part};
pub use distortion::Distortion;
pub use error::Error;
pub(crate) use live_head::LiveHead;
pub use live_head::{AlarmAt, HeadSample, HeadSummary};
pub use motion::Leg;
pub(crate) use pass_scene::PassScene;
pub use rig::{Method, Outcome, run};
pub use scenario::{HeadScene, Scenario, Seam};
pub use sensor::{Fault, SensorModel};
pub use world::{Along, Placement, World};

/// The part of the axes' limits that plans must leave to tracking on `machine`: none where a cross slide corrects.
///
/// # Errors
/// A machine that cannot correct at all.
pub fn needs_reserve(machine: &Machine) -> Result<f64, Error> {
    let carrier = carrier::Carrier::new(machine, 0)?;
    Ok(if carrier.needs_reserve() { seamwright_tracking::actuator::RESERVE } else { 0.0 })
}

/// Looks whether every pass with an arc can be tracked on `machine`.
///
/// # Errors
/// The first that cannot: no sensor that leads, too short a lead, axes that cannot correct.
pub fn check(machine: &Machine, passes: &[(&dyn TorchPath, &Pass)], motion: &WeldMotion) -> Result<(), Error> {
    let tracked = passes.iter().zip(&motion.passes).filter(|((path, _), planned)| planned.arc && !path.is_timed());
    tracked.map(|(pass, planned)| PassScene::new(*pass, None).heads(machine, planned, true, 0).map(drop)).collect()
}
