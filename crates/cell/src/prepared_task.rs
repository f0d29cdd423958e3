use crate::devices::CellDevices;
use crate::task::{Base, Planned, Task};
use crate::tracking::{Guiding, Sensing};
use seamwright_executive::{Place, Start, Work};
use seamwright_machine::{Joints, Machine, MachineDevices, Surroundings};
use seamwright_message::{Message, Unit};
use seamwright_motion::WeldMotion;
use seamwright_project::load::Loaded;
use seamwright_record::sha256;
use seamwright_simulation::SimulatedCell;
use self_cell::self_cell;
use std::path::Path;
use std::sync::Arc;

/// Maximum distance of an axis from home for the planned approach from home, mm or rad.
const AT_HOME: f64 = 0.005;

type WorkOf<'a> = Work<'a>;

self_cell! {
    struct Worked {
        owner: Arc<Base>,
        #[not_covariant]
        dependent: WorkOf,
    }
}

/// Returns a text that is equal for machines that are identical: files of one name may differ.
pub fn fingerprint(machine: &Machine) -> String {
    // User frames are directions for an operator; devices and motion do not depend on them.
    let mut machine = machine.clone();
    machine.user_frames.clear();
    sha256(format!("{machine:?}").as_bytes())
}

/// A task with all memory allocated: ready for the cycle's thread.
pub(crate) struct Prepared {
    worked: Worked,
    /// Corrects its passes, if they are tracked.
    pub(crate) guide: Option<Guiding>,
    /// Senses their joints.
    pub(crate) sensors: Option<Sensing>,
    /// Devices of a machine that the cell does not have yet.
    pub(crate) devices: Option<CellDevices>,
    fingerprint: String,
}

impl Prepared {
    /// Prepares a task with the axes at `at`; `from`: start position, if not at the start of the first pass.
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

    /// Prepares a machine without a program, on simulated devices.
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

    pub(crate) fn fingerprint(&self) -> &str {
        &self.fingerprint
    }
}

fn work<'a>(base: &'a Base, at: &Joints, from: Option<Place>) -> Result<Work<'a>, String> {
    base.with_dependent(|stood, cell| {
        stood.with_dependent(|task, ground| of(task, &ground.around, cell.as_ref(), at, from))
    })
}

fn of<'a>(
    task: &'a Task,
    around: &'a Surroundings<'a>,
    cell: Option<&'a SimulatedCell<'a>>,
    at: &Joints,
    from: Option<Place>,
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
        let message = Message::new("server-nothing-to-weld").pass("pass", place.pass);
        let message = message.value("s", place.s_mm, Unit::Mm).count("passes", motion.passes.len());
        return Err(message.to_string());
    }
    Start::at_place(&loaded.machine, around, motion, at, place).map_err(|e| e.to_string())
}
