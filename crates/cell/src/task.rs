//! The task of a cell, with the data that borrow from it.

use seamwright_machine::{Clamped, Machine, Surroundings};
use seamwright_motion::WeldMotion;
use seamwright_project::load::Loaded;
use seamwright_project::simulated_part::Part;
use seamwright_simulation::SimulatedCell;
use seamwright_weld::WeldPath;
use self_cell::self_cell;

/// Random seed of a simulated cell.
pub(crate) const SEED: u64 = 1;

pub(crate) struct Planned {
    pub(crate) loaded: Loaded,
    pub(crate) motion: WeldMotion,
    /// Pose of its part, if devices are simulated.
    pub(crate) part: Part,
}

/// Task of a cell: a planned job, or a machine alone.
pub(crate) enum Task {
    Job(Box<Planned>),
    Machine(Box<Machine>),
}

impl Task {
    pub(crate) fn machine(&self) -> &Machine {
        match self {
            Self::Job(planned) => &planned.loaded.machine,
            Self::Machine(machine) => machine,
        }
    }
}

/// Data that borrows from a task.
pub(crate) struct Ground<'a> {
    pub(crate) around: Surroundings<'a>,
    paths: Vec<WeldPath<'a>>,
}

self_cell! {
    pub(crate) struct Stood {
        owner: Task,
        #[not_covariant]
        dependent: Ground,
    }
}

/// Present for a job only.
type CellOf<'a> = Option<SimulatedCell<'a>>;

self_cell! {
    /// Owner of the data that everything in a task borrows from.
    pub(crate) struct Base {
        owner: Stood,
        #[not_covariant]
        dependent: CellOf,
    }
}

impl Base {
    pub(crate) fn of(task: Task) -> Result<Self, String> {
        let stood = Stood::try_new(task, |task| {
            let nothing = Clamped::default();
            let (clamped, paths) = match task {
                Task::Job(planned) => (&planned.loaded.clamped, planned.loaded.paths()),
                Task::Machine(_) => (&nothing, Vec::new()),
            };
            let around = Surroundings::new(task.machine(), clamped).map_err(|e| e.to_string())?;
            Ok::<_, String>(Ground { around, paths })
        })?;
        Ok(Self::new(stood, |stood| stood.with_dependent(cell)))
    }

    pub(crate) fn machine(&self) -> &Machine {
        self.borrow_owner().borrow_owner().machine()
    }
}

fn cell<'a, 'q>(task: &'q Task, ground: &'a Ground<'q>) -> Option<SimulatedCell<'a>> {
    let Task::Job(planned) = task else { return None };
    let Planned { loaded, motion, part } = &**planned;
    let conditions = part.conditions(SEED, &[], &ground.around);
    Some(SimulatedCell::new(&loaded.machine, loaded.passes(&ground.paths), motion, conditions))
}
