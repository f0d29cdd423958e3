//! Whole tracked welds with a hold and a resume allocate nothing after the program is loaded: by a leading sensor, by
//! two with cross slides, by a beam.

use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};
use seamwright_executive::tracking::RESERVE;
use seamwright_executive::{Ask, Command, Cycle, Executive, Mode, Note, Place, Port, Start};
use seamwright_machine::{Clamped, Machine, Surroundings, shipped};
use seamwright_motion::WeldMotion;
use seamwright_motion::feed_override::RunPhase;
use seamwright_program::{Pass, TorchPath};
use seamwright_simulation::tracking::Distortion;
use seamwright_simulation::{Conditions, SimulatedCell};
use seamwright_weld::Welding;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// Welds once, with a hold in the middle.
#[derive(Default)]
struct Operator {
    mode: Option<Mode>,
    armed: bool,
    phase: Option<RunPhase>,
    s: f64,
    held: bool,
    welded: bool,
    asked: bool,
    powered: bool,
    corrected: f64,
}

impl Port for Operator {
    fn command(&mut self, _t: f64) -> Option<Command> {
        if std::mem::replace(&mut self.asked, true) {
            return None;
        }
        let ask = match self.mode? {
            Mode::Off if self.welded => Ask::Quit,
            Mode::Off => Ask::SwitchOn,
            Mode::Idle if self.powered => Ask::Home,
            Mode::Ready if self.welded => Ask::SwitchOff,
            Mode::Ready | Mode::Hold if !self.armed => Ask::Arm,
            Mode::Ready => Ask::StartWeld,
            Mode::Hold if self.phase == Some(RunPhase::Held) => Ask::Resume,
            Mode::Weld if !self.held && self.s > 20.0 => {
                self.held = true;
                Ask::Hold
            }
            _ => return None,
        };
        Some(Command::of(ask))
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        self.welded |= cycle.mode == Mode::Ready && self.held;
        (self.mode, self.armed, self.phase, self.s) = (Some(cycle.mode), cycle.armed, cycle.phase, cycle.place.s_mm);
        self.asked = false;
        self.powered = cycle.reports.drives.powered;
        let by = cycle.tracked.iter().flatten().map(|head| head.correction_mm[0].abs()).fold(0.0, f64::max);
        self.corrected = self.corrected.max(by);
    }

    fn note(&mut self, _t: f64, _note: Note) {}
}

fn welds_without(job: &str, distortion: &str) {
    let welding = Welding::read("job.toml", job).unwrap();
    let program = &welding.program.value;
    let machine = Machine::read("m.toml", shipped(&program.machine).unwrap().text).unwrap();
    let distortion = Distortion::read("d.toml", distortion).unwrap();
    let planned_on = machine.with_reserve(RESERVE);
    let around = Surroundings::new(&planned_on, &Clamped::default()).unwrap();
    let path = welding.path(0);
    let passes: Vec<(&dyn TorchPath, &Pass)> = vec![(&path, &program.passes[0])];
    let motion = WeldMotion::plan(&planned_on, &around, &passes, 30.0).unwrap();
    let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
    let conditions = Conditions {
        seed: 1,
        distortion: Some(&distortion),
        tracking: true,
        replay: None,
        around: Some(&around),
        faults: &[],
    };
    let cell = SimulatedCell::new(&machine, passes.clone(), &motion, conditions);
    let work = cell.work(Start::at_home(&motion)).unwrap();
    let mut devices = cell.devices().unwrap();
    let mut tracking = cell.tracking(Place::default()).unwrap();
    let mut operator = Operator::default();
    let guide = tracking.as_mut().map(|tracking| tracking as _);
    let mut executive = Executive::new(&machine, &mut devices, &mut operator).with_guide(guide);
    assert_no_alloc(|| executive.serve(Some(&work)));
    assert_eq!(violation_count(), 0);
    assert!(executive.left().is_none());
    drop(executive);
    assert!(operator.welded && operator.held && operator.corrected > 0.3, "{}", operator.corrected);
}

#[test]
fn tracked_welds_cost_no_allocation() {
    let shift = "schema = 1\n[[displacement]]\nshift = { lateral_mm = 0.6 }\n";
    // Ten degrees of the saddle.
    let saddle = include_str!("../../../examples/saddle.toml").replace("overlap_mm = 20", "end_phi_deg = 30");
    let half_ring = include_str!("../../../examples/half-ring.toml");
    let t_joint = include_str!("../../../examples/t-joint.toml");
    for job in [&saddle, half_ring, t_joint] {
        welds_without(job, shift);
    }
}
