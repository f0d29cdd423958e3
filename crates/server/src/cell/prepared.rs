use seamwright_cell::executive::{Place, Start, Work};
use seamwright_machine::{Clamped, Joints, Machine, Surroundings};
use seamwright_motion::WeldMotion;
use seamwright_project::load::Loaded;
use seamwright_record::sha256;
use self_cell::self_cell;

/// How far an axis may be from home for the plain way from there, mm or rad.
const AT_HOME: f64 = 0.005;

/// A planned job, owned.
pub(crate) struct Planned {
    pub(crate) loaded: Loaded,
    pub(crate) motion: WeldMotion,
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

self_cell! {
    struct Stood {
        owner: Task,
        #[not_covariant]
        dependent: Surroundings,
    }
}

type WorkOf<'a> = Work<'a>;

self_cell! {
    struct Worked {
        owner: Stood,
        #[not_covariant]
        dependent: WorkOf,
    }
}

/// A task with everything made that running it takes memory for: ready to be handed to the cycle's thread.
pub(crate) struct Prepared {
    worked: Worked,
    fingerprint: String,
}

impl Prepared {
    /// With the axes at `at`; `from`: where to begin, if not at the begin.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub(crate) fn new(task: Task, at: &Joints, from: Option<Place>) -> Result<Self, String> {
        let stood = Stood::try_new(task, |task| {
            let nothing = Clamped::default();
            let clamped = match task {
                Task::Job(planned) => &planned.loaded.clamped,
                Task::Machine(_) => &nothing,
            };
            Surroundings::new(task.machine(), clamped).map_err(|e| e.to_string())
        })?;
        // Machine files of one name may differ: all that is in them counts.
        let fingerprint = sha256(format!("{:?}", stood.borrow_owner().machine()).as_bytes());
        let worked = Worked::try_new(stood, |stood| stood.with_dependent(|task, around| work(task, around, at, from)))?;
        Ok(Self { worked, fingerprint })
    }

    pub(crate) fn with<T>(&self, run: impl FnOnce(&Work<'_>) -> T) -> T {
        self.worked.with_dependent(|_, work| run(work))
    }

    pub(crate) fn machine(&self) -> &Machine {
        self.worked.borrow_owner().borrow_owner().machine()
    }

    /// The same for machines that are the same in everything.
    pub(crate) fn fingerprint(&self) -> &str {
        &self.fingerprint
    }
}

fn work<'a>(
    task: &'a Task,
    around: &'a Surroundings<'a>,
    at: &Joints,
    from: Option<Place>,
) -> Result<Work<'a>, String> {
    let Task::Job(planned) = task else { return Ok(Work::none(task.machine(), around)) };
    let Planned { loaded, motion } = &**planned;
    let passes: Vec<_> = loaded.welding.program.value.passes.iter().collect();
    let home = loaded.machine.home();
    let axes = loaded.machine.axes.len();
    let at_home = at[..axes].iter().zip(&home).all(|(a, b)| (a - b).abs() < AT_HOME);
    let start = match from {
        None if at_home => Start::at_home(motion),
        None => start(loaded, around, motion, at, Place { pass: 1, s_mm: 0.0 })?,
        Some(place) => start(loaded, around, motion, at, place)?,
    };
    let most = seamwright_cell::executive::VALUES;
    Work::new(&loaded.machine, Some(around), &passes, motion, start)
        .map_err(|n| format!("the program has {n} process values; allowed: up to {most}"))
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
