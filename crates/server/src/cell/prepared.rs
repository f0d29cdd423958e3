use super::connection::CellDevices;
use super::guiding::{Guiding, Sensing};
use seamwright_cell::SimulatedCell;
use seamwright_cell::executive::{Place, Start, Work};
use seamwright_machine::{Clamped, Joints, Machine, MachineDevices, Surroundings};
use seamwright_motion::WeldMotion;
use seamwright_project::load::Loaded;
use seamwright_project::part::Part;
use seamwright_record::sha256;
use seamwright_weld::WeldPath;
use self_cell::self_cell;
use std::path::Path;
use std::sync::Arc;

/// How far an axis may be from home for the plain way from there, mm or rad.
const AT_HOME: f64 = 0.005;
/// Of everything random in a simulated cell.
pub(super) const SEED: u64 = 1;

/// A planned job, owned.
pub(crate) struct Planned {
    pub(crate) loaded: Loaded,
    pub(crate) motion: WeldMotion,
    /// How its part lies, if devices are simulated.
    pub(crate) part: Part,
}

/// What a cell can be given: a planned job, or a machine alone.
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

/// What a task stands on.
pub(super) struct Ground<'a> {
    around: Surroundings<'a>,
    paths: Vec<WeldPath<'a>>,
}

self_cell! {
    pub(super) struct Stood {
        owner: Task,
        #[not_covariant]
        dependent: Ground,
    }
}

/// A job has one.
type CellOf<'a> = Option<SimulatedCell<'a>>;

self_cell! {
    /// What everything of a task borrows from.
    pub(super) struct Base {
        owner: Stood,
        #[not_covariant]
        dependent: CellOf,
    }
}

impl Base {
    /// # Errors
    /// What is wrong, in words.
    fn of(task: Task) -> Result<Self, String> {
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

    fn machine(&self) -> &Machine {
        self.borrow_owner().borrow_owner().machine()
    }
}

type WorkOf<'a> = Work<'a>;

self_cell! {
    struct Worked {
        owner: Arc<Base>,
        #[not_covariant]
        dependent: WorkOf,
    }
}

/// The same for machines that are the same in everything: files of one name may differ.
pub(crate) fn fingerprint(machine: &Machine) -> String {
    sha256(format!("{machine:?}").as_bytes())
}

/// A task with everything made that running it takes memory for: ready to be handed to the cycle's thread.
pub(crate) struct Prepared {
    worked: Worked,
    /// What corrects its passes, if they are tracked.
    pub(super) guide: Option<Guiding>,
    /// What sees their joints.
    pub(super) sensors: Option<Sensing>,
    /// The devices of a machine that is not yet the cell's.
    pub(crate) devices: Option<CellDevices>,
    fingerprint: String,
}

impl Prepared {
    /// With the axes at `at`; `from`: where to begin, if not at the begin.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub(crate) fn new(task: Task, at: &Joints, from: Option<Place>) -> Result<Self, String> {
        let tracks = matches!(&task, Task::Job(planned) if planned.part.tracking);
        let base = Arc::new(Base::of(task)?);
        let fingerprint = fingerprint(base.machine());
        let worked = Worked::try_new(Arc::clone(&base), |base| work(base, at, from))?;
        let (mut guide, mut sensors) = (None, None);
        if tracks {
            guide = Some(Guiding::of(&base, from.unwrap_or_default())?);
            sensors = Some(Sensing::of(&base)?);
        }
        Ok(Self { worked, guide, sensors, devices: None, fingerprint })
    }

    pub(crate) fn with<T>(&self, run: impl FnOnce(&Work<'_>) -> T) -> T {
        self.worked.with_dependent(|_, work| run(work))
    }

    /// A machine without a program, on simulated devices.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub(crate) fn bare(machine: &Machine) -> Result<Self, String> {
        let mut machine = machine.clone();
        machine.devices = MachineDevices::default();
        let home = machine.home();
        let mut bare = Self::new(Task::Machine(Box::new(machine)), &home, None)?;
        bare.devices = Some(CellDevices::new(&bare, Path::new(""), &[])?);
        Ok(bare)
    }

    pub(crate) fn machine(&self) -> &Machine {
        self.worked.borrow_owner().machine()
    }

    /// See [`fingerprint`].
    pub(crate) fn fingerprint(&self) -> &str {
        &self.fingerprint
    }
}

fn cell<'a, 'q>(task: &'q Task, ground: &'a Ground<'q>) -> Option<SimulatedCell<'a>> {
    let Task::Job(planned) = task else { return None };
    let Planned { loaded, motion, part } = &**planned;
    let conditions = part.conditions(SEED, &[], &ground.around);
    Some(SimulatedCell::new(&loaded.machine, loaded.passes(&ground.paths), motion, conditions))
}

fn work<'a>(base: &'a Base, at: &Joints, from: Option<Place>) -> Result<Work<'a>, String> {
    base.with_dependent(|stood, cell| {
        stood.with_dependent(|task, ground| of(task, &ground.around, cell.as_ref(), (at, from)))
    })
}

fn of<'a>(
    task: &'a Task,
    around: &'a Surroundings<'a>,
    cell: Option<&'a SimulatedCell<'a>>,
    (at, from): (&Joints, Option<Place>),
) -> Result<Work<'a>, String> {
    let (Task::Job(planned), Some(cell)) = (task, cell) else { return Ok(Work::none(task.machine(), around)) };
    let Planned { loaded, motion, .. } = &**planned;
    let home = loaded.machine.home();
    let axes = loaded.machine.axes.len();
    let at_home = at[..axes].iter().zip(&home).all(|(a, b)| (a - b).abs() < AT_HOME);
    let start = match from {
        None if at_home => Start::at_home(motion),
        None => start(loaded, around, motion, at, Place { pass: 1, s_mm: 0.0 })?,
        Some(place) => start(loaded, around, motion, at, place)?,
    };
    cell.work(start).map_err(|e| e.to_string())
}

fn start(
    loaded: &Loaded,
    around: &Surroundings<'_>,
    motion: &WeldMotion,
    at: &Joints,
    place: Place,
) -> Result<Start, String> {
    let length = place.pass.checked_sub(1).and_then(|i| motion.passes.get(i)).map(|pass| pass.path.length());
    if !length.is_some_and(|length| (0.0..length).contains(&place.s_mm)) {
        return Err(format!(
            "pass {}, {} mm: there is nothing left to weld; allowed: a pass from 1 to {}, within its length",
            place.pass,
            place.s_mm,
            motion.passes.len()
        ));
    }
    Start::at_place(&loaded.machine, around, motion, at, place).map_err(|e| e.to_string())
}
