//! Planned welds, scripts for their operators, records of cycles.

// Not every test uses all of it.
#![allow(dead_code)]
#![allow(clippy::unwrap_used)]

use seamwright_executive::tracking::RESERVE;
use seamwright_executive::{AlarmList, Ask, Command, Cycle, Executive, Missing, Mode, Note, Place, Port, Start, Work};
use seamwright_machine::{Clamped, Joints, Machine, Surroundings, shipped};
use seamwright_motion::WeldMotion;
use seamwright_motion::feed_override::RunPhase;
use seamwright_program::{Pass, TorchPath};
use seamwright_simulation::devices::{Fault, simulated_devices};
use seamwright_simulation::tracking::Distortion;
use seamwright_simulation::{Conditions, Error, Judge, Sample, SimulatedCell, Summary, simulate};
use seamwright_weld::Welding;

pub(crate) const SADDLE: &str = include_str!("../../../../examples/saddle.toml");

/// Factor of the number of cases, if `SEAMWRIGHT_SOAK` requests one. Not `testkit`'s: that crate has an allocator, and so
/// have the tests of allocations here.
pub(crate) fn soak() -> Option<u64> {
    let factor = std::env::var("SEAMWRIGHT_SOAK").ok()?;
    Some(factor.parse().unwrap_or_else(|_| panic!("SEAMWRIGHT_SOAK={factor}: not a whole number")))
}

/// The example weld, planned.
pub(crate) struct Planned {
    pub(crate) machine: Machine,
    pub(crate) welding: Welding,
    pub(crate) motion: WeldMotion,
}

impl Planned {
    pub(crate) fn new(job: &str) -> Self {
        Self::with_reserve(job, 0.0)
    }

    /// Plans with this reserve of every axis' limits.
    pub(crate) fn with_reserve(job: &str, reserve: f64) -> Self {
        let welding = Welding::read("job.toml", job).unwrap();
        let program = &welding.program.value;
        let machine = Machine::read("m.toml", shipped(&program.machine).unwrap().text).unwrap();
        let planned_on = machine.with_reserve(reserve);
        let around = Surroundings::new(&planned_on, &Clamped::default()).unwrap();
        let path = welding.path(0);
        let passes: Vec<(&dyn TorchPath, &Pass)> = vec![(&path, &program.passes[0])];
        let motion = WeldMotion::plan(&planned_on, &around, &passes, 30.0).unwrap();
        Self { machine, welding, motion }
    }

    pub(crate) fn work(&self, start: Start) -> Work<'_> {
        let passes: Vec<&Pass> = self.welding.program.value.passes.iter().collect();
        Work::new(&self.machine, None, &passes, &self.motion, start).unwrap()
    }

    pub(crate) fn near_end(&self) -> Start {
        let around = Surroundings::new(&self.machine, &Clamped::default()).unwrap();
        let s_mm = self.motion.passes[0].path.length() - 5.0;
        Start::at_place(&self.machine, &around, &self.motion, &self.machine.home(), Place { pass: 1, s_mm }).unwrap()
    }
}

/// Plans passes on a machine and simulates them: the motion, a summary of each pass, and all samples.
pub(crate) fn simulated(
    machine: &Machine,
    passes: &[(&dyn TorchPath, &Pass)],
    conditions: Conditions<'_>,
) -> Result<(WeldMotion, Vec<Summary>, Vec<Sample>), Error> {
    let planned_on = machine.with_reserve(if conditions.tracking { RESERVE } else { 0.0 });
    let around = Surroundings::new(&planned_on, &Clamped::default()).unwrap();
    let motion = WeldMotion::plan(&planned_on, &around, passes, 30.0).unwrap();
    let mut samples = Vec::new();
    let summaries = simulate(machine, passes, &motion, conditions, |s| {
        samples.push(*s);
        Ok::<(), Error>(())
    })?;
    Ok((motion, summaries, samples))
}

/// A tracked weld on a displaced part; it lives as long as the test.
pub(crate) struct Tracked {
    pub(crate) planned: &'static Planned,
    pub(crate) passes: &'static [(&'static dyn TorchPath, &'static Pass)],
    pub(crate) distortion: Distortion,
}

impl Tracked {
    pub(crate) fn new(job: &str) -> Self {
        let planned: &Planned = Box::leak(Box::new(Planned::with_reserve(job, RESERVE)));
        let path: &dyn TorchPath = Box::leak(Box::new(planned.welding.path(0)));
        let passes = Box::leak(Box::new([(path, &planned.welding.program.value.passes[0])]));
        let distortion = include_str!("../../../../examples/distortions/misplaced.toml");
        Self { planned, passes, distortion: Distortion::read("d.toml", distortion).unwrap() }
    }

    pub(crate) fn cell(&self) -> SimulatedCell<'_> {
        self.cell_with(&[])
    }

    pub(crate) fn cell_with<'a>(&'a self, faults: &'a [Fault]) -> SimulatedCell<'a> {
        let distortion = Some(&self.distortion);
        let conditions = Conditions { seed: 1, distortion, tracking: true, faults, ..Conditions::default() };
        SimulatedCell::new(&self.planned.machine, self.passes.to_vec(), &self.planned.motion, conditions)
    }

    /// Runs a script; returns the judge's sample of each cycle, and the position at which the program was left.
    pub(crate) fn play(&self, faults: &[Fault], script: &mut Script<'_>) -> (Vec<Sample>, Option<Place>) {
        let cell = self.cell_with(faults);
        let work = cell.work(Start::at_home(&self.planned.motion)).unwrap();
        let mut devices = cell.devices().unwrap();
        let mut tracking = cell.tracking(Place::default()).unwrap();
        let mut judged = Judged { judge: cell.judge().unwrap(), script, samples: Vec::new() };
        let guide = tracking.as_mut().map(|tracking| tracking as _);
        let mut executive = Executive::new(&self.planned.machine, &mut devices, &mut judged).with_guide(guide);
        executive.serve(Some(&work));
        let left = executive.left();
        drop(executive);
        (judged.samples, left)
    }
}

/// Largest shares of speed, acceleration and jerk that any axis uses between set-points, by differences; each with its
/// time and axis. Set-points are not followed before the references are found, or without power.
pub(crate) fn limit_use<'a>(machine: &'a Machine, samples: &[Sample]) -> [(f64, f64, &'a str); 3] {
    let period = machine.servo_period_s;
    let mut worst = [(0.0, 0.0, ""); 3];
    let follows = |s: &Sample| matches!(s.mode, Mode::Weld | Mode::Hold | Mode::DryRun);
    for four in samples.windows(4).filter(|four| four.iter().all(follows)) {
        for (i, axis) in machine.axes.iter().enumerate() {
            let [a, b, c, d] = std::array::from_fn(|k| four[k].set.q[i]);
            let speed = (d - c) / (period * axis.max_speed);
            let acceleration = (d - 2.0 * c + b) / (period.powi(2) * axis.max_acceleration);
            let jerk = (d - 3.0 * c + 3.0 * b - a) / (period.powi(3) * axis.jerk());
            for (worst, used) in worst.iter_mut().zip([speed, acceleration, jerk].map(f64::abs)) {
                assert!(used.is_finite(), "{} at {} s", axis.name, four[3].set.t);
                if used > worst.0 {
                    *worst = (used, four[3].set.t, &axis.name);
                }
            }
        }
    }
    worst
}

/// A script, and the judge of its weld.
struct Judged<'a, 'b, 'c> {
    pub(crate) judge: Judge<'a>,
    pub(crate) script: &'b mut Script<'c>,
    pub(crate) samples: Vec<Sample>,
}

impl Port for Judged<'_, '_, '_> {
    fn command(&mut self, t: f64) -> Option<Command> {
        self.script.command(t)
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        self.script.show(cycle);
        self.samples.push(self.judge.sample(cycle));
    }

    fn note(&mut self, t: f64, note: Note) {
        self.script.note(t, note);
    }
}

/// An operator with a script: each line waits for its condition, then asks.
pub(crate) struct Script<'a> {
    pub(crate) lines: Vec<(When<'a>, Ask)>,
    pub(crate) next: usize,
    pub(crate) asked: bool,
    pub(crate) cycles: Vec<Seen>,
    pub(crate) notes: Vec<Note>,
    alarms: AlarmList,
}

pub(crate) type When<'a> = Box<dyn Fn(&Seen) -> bool + 'a>;

/// Record of a cycle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Seen {
    pub(crate) t: f64,
    pub(crate) mode: Mode,
    pub(crate) phase: Option<RunPhase>,
    pub(crate) place: Place,
    pub(crate) welded: f64,
    pub(crate) on: bool,
    pub(crate) gas: bool,
    pub(crate) current: f64,
    pub(crate) q: Joints,
    pub(crate) burning: bool,
    pub(crate) powered: bool,
}

impl<'a> Script<'a> {
    pub(crate) fn new(lines: Vec<(When<'a>, Ask)>) -> Self {
        Self { lines, next: 0, asked: false, cycles: vec![], notes: vec![], alarms: AlarmList::default() }
    }

    pub(crate) fn modes(&self) -> Vec<Mode> {
        self.notes.iter().filter_map(|n| if let Note::Mode(_, to) = n { Some(*to) } else { None }).collect()
    }

    pub(crate) fn refused(&self) -> Vec<Missing> {
        self.notes.iter().filter_map(|n| if let Note::Refused(_, why) = n { Some(*why) } else { None }).collect()
    }
}

impl Port for Script<'_> {
    fn command(&mut self, _t: f64) -> Option<Command> {
        let (when, ask) = self.lines.get(self.next)?;
        let now = self.cycles.last()?;
        if std::mem::replace(&mut self.asked, true) || !when(now) {
            return None;
        }
        self.next += 1;
        Some(Command::of(*ask))
    }

    fn show(&mut self, c: &Cycle<'_>) {
        self.asked = false;
        assert!(self.alarms.iter().eq(c.alarms.iter()), "{:?}\n{:?}", self.alarms, c.alarms);
        self.cycles.push(Seen {
            t: c.t,
            mode: c.mode,
            phase: c.phase,
            place: c.place,
            welded: c.welded_mm,
            on: c.orders.process.on,
            gas: c.orders.process.gas,
            current: c.orders.process.values[0],
            q: std::array::from_fn(|i| c.orders.set[i].position),
            burning: c.reports.source.burning,
            powered: c.orders.power && c.reports.drives.powered,
        });
        assert!(c.t < 400.0, "it goes on without end: line {} in mode {}", self.next, c.mode);
    }

    fn note(&mut self, _t: f64, note: Note) {
        self.alarms.follow(&note);
        self.notes.push(note);
    }
}

pub(crate) fn in_mode<'a>(mode: Mode) -> When<'a> {
    Box::new(move |c| c.mode == mode)
}

pub(crate) fn at<'a>(s: f64) -> When<'a> {
    Box::new(move |c| c.mode == Mode::Weld && c.place.s_mm > s)
}

pub(crate) fn held<'a>() -> When<'a> {
    Box::new(|c| c.mode == Mode::Hold && c.phase == Some(RunPhase::Held))
}

/// Lines from off to ready.
pub(crate) fn up<'a>() -> Vec<(When<'a>, Ask)> {
    vec![(in_mode(Mode::Off), Ask::SwitchOn), (Box::new(|c| c.mode == Mode::Idle && c.powered), Ask::Home)]
}

pub(crate) fn weld<'a>() -> Vec<(When<'a>, Ask)> {
    vec![(in_mode(Mode::Ready), Ask::Arm), (in_mode(Mode::Ready), Ask::StartWeld)]
}

/// Lines from ready to the end.
pub(crate) fn down<'a>() -> Vec<(When<'a>, Ask)> {
    vec![(in_mode(Mode::Ready), Ask::SwitchOff), (in_mode(Mode::Off), Ask::Quit)]
}

/// Runs a script on simulated devices; returns its record, and the position at which the program was left.
pub(crate) fn play<'a>(planned: &Planned, start: Start, lines: Vec<(When<'a>, Ask)>) -> (Script<'a>, Option<Place>) {
    let machine = &planned.machine;
    let (mut devices, mut script) = (simulated_devices(machine, 1).unwrap(), Script::new(lines));
    let work = planned.work(start);
    let mut executive = Executive::new(machine, &mut devices, &mut script);
    executive.serve(Some(&work));
    let left = executive.left();
    drop(executive);
    (script, left)
}

pub(crate) fn short() -> Planned {
    let job = SADDLE
        .replace("overlap_mm = 20", "end_phi_deg = 32")
        .replace("preflow_s = 0.5 ", "overlap_mm = 6\npreflow_s = 0.5 ");
    Planned::new(&job)
}
