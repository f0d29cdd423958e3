mod cell;
mod measure;
mod tracked;

use crate::summary::Summary;
use crate::tracking::{Distortion, PassScene};
use crate::{Error, Sample};
use cell::SimulatedCell;
use seamwright_machine::Machine;
use seamwright_motion::{Stage, WeldMotion};
use seamwright_program::{Pass, TorchPath};
use tracked::play_tracked;

/// Under what a weld is simulated.
#[derive(Debug, Clone, Copy, Default)]
pub struct Conditions<'a> {
    /// Of everything random: the same seed gives the same weld, bit for bit.
    pub seed: u64,
    /// How the part differs from the planned one; none: not at all.
    pub distortion: Option<&'a Distortion>,
    /// True if passes are tracked by the machine's leading sensors. The motion must leave the axes their
    /// [`crate::tracking::RESERVE`].
    pub tracking: bool,
}

/// Plays `motion`, whose passes are `passes`, on simulated drives, one set-point a servo period, from the start of
/// the first weld to the end of the last, and shows every period's [`Sample`] to `observer`. A summary of each pass.
///
/// The observer's errors end the simulation.
///
/// # Errors
/// [`Error::Drive`] if the machine file's drive values make no drive; [`Error::Tracking`] for a pass that cannot be
/// tracked; the observer's error.
pub fn simulate<E: From<Error>>(
    machine: &Machine,
    passes: &[(&dyn TorchPath, &Pass)],
    motion: &WeldMotion,
    conditions: Conditions<'_>,
    observer: impl FnMut(&Sample) -> Result<(), E>,
) -> Result<Vec<Summary>, E> {
    let period = machine.servo_period_s;
    let mut cell = SimulatedCell::new(machine, passes, motion, conditions.seed, observer)?;
    let hidden = conditions.distortion.is_some() || conditions.tracking;
    let mut heads = vec![Vec::new(); motion.passes.len()];
    for stage in motion.stages(false) {
        let begun = cell.count();
        match stage {
            Stage::Pass(i, planned) if hidden && planned.arc && !passes[i].0.is_timed() => {
                let scene = PassScene::new(passes[i], conditions.distortion);
                let carrier = conditions.tracking.then(|| scene.carrier(machine, planned)).transpose();
                let mut carrier = carrier.map_err(Error::from)?;
                let live = scene.heads(machine, planned, carrier.as_ref(), conditions.seed);
                let mut live = live.map_err(Error::from)?;
                match &mut carrier {
                    Some(carrier) => play_tracked(&mut cell, machine, (i + 1, planned), (&mut live, carrier))?,
                    None => {
                        stage.play(period, begun, &mut |pass, set, rates| cell.show(pass, set, &rates, &mut live))?;
                    }
                }
                heads[i] = live.into_iter().map(|head| head.finish(machine)).collect();
            }
            _ => {
                stage.play(period, begun, &mut |pass, set, rates| cell.show(pass, set, &rates, &mut []))?;
            }
        }
    }
    Ok(cell.finish(heads))
}
