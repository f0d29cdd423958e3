mod cell;
mod judge;
mod measure;
mod operator;

use crate::devices::Fault;
use crate::executive::{Command, Cycle, Executive, Note, Place, Port};
use crate::summary::Summary;
use crate::tracking::Distortion;
use crate::{Error, Sample};
use operator::Operator;
use seamwright_machine::{Machine, Surroundings};
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, TorchPath};
use seamwright_tracking::beam::DeviationRecord;

pub use cell::{CellDevices, SimulatedCell};
pub use judge::Judge;

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
    /// What the machine must keep clear of on the moves that tracking adds, and on those by hand; none: nothing is looked at.
    pub around: Option<&'a Surroundings<'a>>,
    /// What fails.
    pub faults: &'a [Fault],
}

/// Runs `motion`, whose passes are `passes`, under the executive on simulated devices in virtual time, from switching on over the
/// first weld to home, and shows every period's [`Sample`] to `observer`. A summary of each pass.
///
/// A cosmetic pass of a beam that tracks is corrected by what it has found of that seam before, if that covers the pass.
///
/// A pass that is stopped ends it: the torch stands there, and later passes are not welded. The observer's errors end it too.
///
/// # Errors
/// [`Error::Drive`] if the machine file's drive values make no drive; [`Error::Tracking`] for a pass that cannot be
/// tracked; [`Error::Values`]; the observer's error.
pub fn simulate<E: From<Error>>(
    machine: &Machine,
    passes: &[(&dyn TorchPath, &Pass)],
    motion: &WeldMotion,
    conditions: Conditions<'_>,
    observer: impl FnMut(&Sample) -> Result<(), E>,
) -> Result<Vec<Summary>, E> {
    let cell = SimulatedCell::new(machine, passes.to_vec(), motion, conditions);
    let work = cell.work(crate::executive::Start::at_home(motion))?;
    let mut devices = cell.devices()?;
    let mut tracking = cell.tracking(Place::default())?;
    let judge = cell.judge()?;
    let mut watched = Watched { judge, observer, failed: None, operator: Operator::default() };
    let guide = tracking.as_mut().map(|tracking| tracking as _);
    Executive::new(machine, &mut devices, &mut watched).with_guide(guide).serve(Some(&work));
    let Watched { judge, failed, .. } = watched;
    match failed {
        Some(error) => Err(error),
        None => Ok(judge.summaries(tracking.as_ref())),
    }
}

/// An operator, and who watches.
struct Watched<'a, F, E> {
    judge: Judge<'a>,
    observer: F,
    failed: Option<E>,
    operator: Operator,
}

impl<E, F: FnMut(&Sample) -> Result<(), E>> Port for Watched<'_, F, E> {
    fn command(&mut self, t: f64) -> Option<Command> {
        self.operator.command(t)
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        self.operator.show(cycle);
        if self.failed.is_none()
            && let Err(error) = (self.observer)(&self.judge.sample(cycle))
        {
            (self.failed, self.operator.over) = (Some(error), true);
        }
    }

    fn note(&mut self, t: f64, note: Note) {
        self.operator.note(t, note);
    }
}
