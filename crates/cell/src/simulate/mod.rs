mod cell;
mod measure;
mod off_path;
mod tracked;

use crate::summary::Summary;
use crate::tracking::{Distortion, PassScene, Whole};
use crate::{Error, Sample};
use cell::SimulatedCell;
use seamwright_machine::Machine;
use seamwright_motion::{Stage, WeldMotion};
use seamwright_program::{Pass, TorchPath};
use tracked::TrackedPass;

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
/// A tracked pass that is stopped ends it: the torch stands there, and later passes are not welded. The observer's errors
/// end it too.
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
    let whole = Whole::of(passes);
    let mut heads = vec![Vec::new(); motion.passes.len()];
    for stage in motion.stages(false) {
        let begun = cell.count();
        match stage {
            Stage::Pass(i, planned) if hidden && planned.arc && !passes[i].0.is_timed() => {
                let scene = PassScene::new(passes[i], conditions.distortion, whole);
                let carrier = conditions.tracking.then(|| scene.carrier(machine, planned)).transpose();
                let mut carrier = carrier.map_err(Error::from)?;
                let live = scene.heads(machine, planned, carrier.as_ref(), conditions.seed);
                let mut live = live.map_err(Error::from)?;
                let done = match &mut carrier {
                    Some(carrier) => {
                        TrackedPass { cell: &mut cell, machine, number: i + 1, planned }.play(&mut live, carrier)?
                    }
                    None => {
                        stage.play(period, begun, &mut |pass, set, rates| cell.show(pass, set, &rates, &mut live))?;
                        true
                    }
                };
                heads[i] = live.into_iter().map(|head| head.finish(machine)).collect();
                if !done {
                    break;
                }
            }
            _ => {
                stage.play(period, begun, &mut |pass, set, rates| cell.show(pass, set, &rates, &mut []))?;
            }
        }
    }
    Ok(cell.finish(heads))
}
