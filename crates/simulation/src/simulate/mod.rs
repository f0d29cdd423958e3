mod cell;
mod judge;
mod measure;
mod operator;

use crate::conditions::Conditions;
use crate::error::Error;
use crate::sample::Sample;
use crate::summary::Summary;
use seamwright_executive::{Command, Cycle, Executive, Note, Place, Port, Start};
use seamwright_machine::Machine;
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, TorchPath};

pub use cell::{CellDevices, SimulatedCell};
pub use judge::Judge;
pub use operator::WeldOperator;

/// Runs `motion`, whose passes are `passes`, under the executive on simulated devices in virtual time, from power-on
/// through the weld to home. Shows every period's [`Sample`] to `observer`. Returns a summary of each pass.
///
/// A cosmetic pass of a tracking beam is corrected by its earlier record of that seam, if the record covers the pass.
///
/// A stopped pass ends the run: the torch stands there, and later passes are not welded. An error of the observer ends
/// it too.
///
/// # Errors
/// [`Error::Cell`] for invalid drive values in the machine file, or too many process values; [`Error::Tracking`] for a
/// pass that does not allow tracking; the observer's error.
pub fn simulate<E: From<Error>>(
    machine: &Machine,
    passes: &[(&dyn TorchPath, &Pass)],
    motion: &WeldMotion,
    conditions: Conditions<'_>,
    observer: impl FnMut(&Sample) -> Result<(), E>,
) -> Result<Vec<Summary>, E> {
    let cell = SimulatedCell::new(machine, passes.to_vec(), motion, conditions);
    let work = cell.work(Start::at_home(motion))?;
    let mut devices = cell.devices()?;
    let mut tracking = cell.tracking(Place::default())?;
    let judge = cell.judge()?;
    let mut watched = Watched { judge, observer, failed: None, operator: WeldOperator::default() };
    let guide = tracking.as_mut().map(|tracking| tracking as _);
    Executive::new(machine, &mut devices, &mut watched).with_guide(guide).serve(Some(&work));
    let Watched { judge, failed, .. } = watched;
    match failed {
        Some(error) => Err(error),
        None => Ok(judge.summaries(tracking.as_ref())),
    }
}

/// The outside of a simulated weld: operator, evaluation and observer.
struct Watched<'a, F, E> {
    judge: Judge<'a>,
    observer: F,
    failed: Option<E>,
    operator: WeldOperator,
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
