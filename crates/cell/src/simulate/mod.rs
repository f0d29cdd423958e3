mod cell;
mod measure;
mod off_path;
mod sighting;
mod tracked;

use crate::summary::Summary;
use crate::tracking::{Correction, Distortion, HeadSummary, PassScene, Whole};
use crate::{Error, Sample};
use cell::SimulatedCell;
use seamwright_machine::{Machine, Surroundings};
use seamwright_motion::{Stage, WeldMotion};
use seamwright_program::{Pass, Role, TorchPath};
use seamwright_tracking::beam::{DeviationRecord, Replay};
use tracked::TrackedPass;

/// Under what a weld is simulated.
#[derive(Debug, Clone, Copy, Default)]
pub struct Conditions<'a> {
    /// Of everything random: the same seed gives the same weld, bit for bit.
    pub seed: u64,
    /// How the part differs from the planned one; none: not at all.
    pub distortion: Option<&'a Distortion>,
    /// True if passes are tracked by the machine's leading sensors, or by its beam. The motion must leave the axes their
    /// [`crate::tracking::RESERVE`].
    pub tracking: bool,
    /// What an earlier weld's beam has found of the seam: passes are corrected by it, and not tracked anew.
    pub replay: Option<&'a DeviationRecord>,
    /// What the machine must keep clear of on the moves that tracking adds; none: nothing is looked at.
    pub around: Option<&'a Surroundings<'a>>,
}

/// Plays `motion`, whose passes are `passes`, on simulated drives, one set-point a servo period, from the start of
/// the first weld to the end of the last, and shows every period's [`Sample`] to `observer`. A summary of each pass.
///
/// A cosmetic pass of a beam that tracks is corrected by what it has found of that seam before, if that covers the pass.
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
    let mut heads: Vec<Vec<HeadSummary>> = vec![Vec::new(); motion.passes.len()];
    for stage in motion.stages(false) {
        let begun = cell.count();
        match stage {
            Stage::Pass(i, planned) if hidden && planned.arc && !passes[i].0.is_timed() => {
                let scene = PassScene::new(passes[i], conditions.distortion, whole);
                let correction = conditions.tracking.then(|| scene.correction(machine, planned)).transpose();
                let mut correction = correction.map_err(Error::from)?;
                let stored = conditions.replay.or_else(|| found_before(passes, &heads, i));
                let live = scene.heads(machine, planned, correction.as_ref(), (stored, conditions.seed));
                let mut live = live.map_err(Error::from)?;
                let done = match &mut correction {
                    Some(Correction { carrier, .. }) => {
                        let around = conditions.around;
                        TrackedPass { cell: &mut cell, machine, around, number: i + 1, planned }
                            .play(&mut live, carrier)?
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

/// What the passes before cosmetic pass `i` have found last of its seam; none of another pass, or where that does not cover it.
fn found_before<'a>(
    passes: &[(&dyn TorchPath, &Pass)],
    heads: &'a [Vec<HeadSummary>],
    i: usize,
) -> Option<&'a DeviationRecord> {
    let pass = passes[i].1;
    if pass.known_role() != Some(Role::Cosmetic) {
        return None;
    }
    let ends = [0.0, pass.length()].map(|s| pass.seam_s(s));
    let from = ends[0].min(ends[1]);
    let before = passes.iter().zip(heads).take(i).rev().filter(|((_, before), _)| before.copy == pass.copy);
    let found = before.filter_map(|(_, heads)| heads.first()?.deviations.as_ref());
    found.into_iter().find(|found| Replay::covers(found, from, pass.length()))
}
