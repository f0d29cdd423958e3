//! Allocation tests after the program is loaded: whole welds with a hold and a resume, not tracked and tracked by a
//! leading sensor, by two with cross slides, and by a beam; jogging from its first cycle on, and refused jogs.

mod common;

use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};
use common::{Planned, SADDLE};
use seamwright_executive::realtime::{ManualTime, Paced, Pacer, Shutdown};
use seamwright_executive::tracking::RESERVE;
use seamwright_executive::{
    Ask, Command, Cycle, Devices, Executive, Guide, Mode, Note, Orders, Place, Port, Reports, Slack, Start, Work,
};
use seamwright_machine::{Clamped, Joints, MAX_AXES, Machine, Surroundings, shipped};
use seamwright_motion::feed_override::RunPhase;
use seamwright_motion::jog;
use seamwright_simulation::devices::simulated_devices;
use seamwright_simulation::tracking::Distortion;
use seamwright_simulation::{Conditions, SimulatedCell};
use std::time::Duration;

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

/// Welds `planned` and returns the largest lateral correction, mm.
fn weld<'a>(
    planned: &'a Planned,
    work: &Work<'_>,
    devices: &mut dyn Devices,
    guide: Option<&'a mut (dyn Guide + 'a)>,
) -> f64 {
    let mut operator = Operator::default();
    let mut devices = devices;
    let mut executive = Executive::new(&planned.machine, &mut devices, &mut operator).with_guide(guide);
    assert_no_alloc(|| executive.serve(Some(work)));
    assert_eq!(violation_count(), 0);
    assert!(executive.left().is_none());
    drop(executive);
    assert!(operator.welded && operator.held);
    operator.corrected
}

fn short_saddle() -> String {
    SADDLE.replace("overlap_mm = 20", "end_phi_deg = 30")
}

#[test]
fn a_weld_costs_no_allocation() {
    let planned = Planned::new(&short_saddle());
    let mut devices = simulated_devices(&planned.machine, 1).unwrap();
    weld(&planned, &planned.work(Start::at_home(&planned.motion)), &mut devices, None);
}

#[test]
fn tracked_welds_cost_no_allocation() {
    let shift = "schema = 1\n[[displacement]]\nshift = { lateral_mm = 0.6 }\n";
    let distortion = Distortion::read("d.toml", shift).unwrap();
    let half_ring = include_str!("../../../examples/half-ring.toml");
    let t_joint = include_str!("../../../examples/t-joint.toml");
    for job in [&short_saddle(), half_ring, t_joint] {
        let planned = Planned::with_reserve(job, RESERVE);
        let (path, pass) = (planned.welding.path(0), &planned.welding.program.value.passes[0]);
        let around = Surroundings::new(&planned.machine, &Clamped::default()).unwrap();
        let (distortion, around) = (Some(&distortion), Some(&around));
        let conditions = Conditions { seed: 1, distortion, tracking: true, around, ..Conditions::default() };
        let cell = SimulatedCell::new(&planned.machine, vec![(&path, pass)], &planned.motion, conditions);
        let work = cell.work(Start::at_home(&planned.motion)).unwrap();
        let (mut devices, mut tracking) = (cell.devices().unwrap(), cell.tracking(Place::default()).unwrap());
        let guide = tracking.as_mut().map(|tracking| tracking as _);
        let corrected = weld(&planned, &work, &mut devices, guide);
        assert!(corrected > 0.3, "{corrected}");
    }
}

/// Jogs by speeds, by steps, along the tip and to a position; sends invalid requests, restarts, and jogs again.
#[derive(Default)]
struct Hand {
    mode: Option<Mode>,
    cycles: u32,
    asked: bool,
    powered: bool,
    begins: u32,
    ways: [f64; 4],
    home: Joints,
    from: f64,
    q: f64,
}

/// Number of cycles of each part of a jog.
const PART: u32 = 1000;

/// Returns an invalid request in these cycles of a part.
fn refused(cycle: u32) -> Option<jog::Command> {
    let mut beyond = Joints::default();
    match cycle {
        190 => {
            beyond[0] = 1e9;
            Some(jog::Command::To(beyond))
        }
        192 => {
            beyond[1] = f64::NAN;
            Some(jog::Command::To(beyond))
        }
        194 => Some(jog::Command::Speeds([f64::NAN; MAX_AXES])),
        196 => {
            Some(jog::Command::Tip { frame: jog::TipFrame::Work, velocity: glam::DVec3::new(f64::INFINITY, 0.0, 0.0) })
        }
        198 => Some(jog::Command::Step { axis: 40, by: 1.0 }),
        200 => Some(jog::Command::Step { axis: 0, by: 1e9 }),
        _ => None,
    }
}

impl Hand {
    fn part(&self) -> usize {
        (self.cycles / PART) as usize
    }

    fn wants(&self) -> Option<jog::Command> {
        // The panel repeats a request twenty times a second, but steps once.
        let again = self.cycles.is_multiple_of(50);
        let begins = self.cycles.is_multiple_of(PART);
        let halfway = self.cycles % PART >= PART / 2;
        let mut joints = Joints::default();
        match self.part() {
            _ if halfway && self.part() != 2 => again.then_some(jog::Command::Rest),
            0 => {
                joints[0] = 5.0;
                again.then_some(jog::Command::Speeds(joints))
            }
            1 if begins => Some(jog::Command::Step { axis: 0, by: 0.5 }),
            // Ends before the panel counts as silent.
            1 => match self.cycles % PART {
                180 => Some(jog::Command::Rest),
                n => refused(n),
            },
            2 => {
                joints = self.home;
                joints[0] = self.from + 2.0;
                again.then_some(jog::Command::To(joints))
            }
            _ => {
                let velocity = glam::DVec3::new(3.0, 0.0, 0.0);
                again.then_some(jog::Command::Tip { frame: jog::TipFrame::Work, velocity })
            }
        }
    }
}

impl Port for Hand {
    fn command(&mut self, _t: f64) -> Option<Command> {
        if std::mem::replace(&mut self.asked, true) {
            return None;
        }
        let ask = match self.mode? {
            Mode::Off if self.begins > 1 => Ask::Quit,
            Mode::Off => Ask::SwitchOn,
            Mode::Idle if self.powered => Ask::Home,
            Mode::Ready if self.begins > 1 => Ask::SwitchOff,
            Mode::Ready => {
                (self.begins, self.cycles) = (self.begins + 1, 0);
                Ask::StartJog
            }
            Mode::Jog if self.part() > 3 => Ask::Hold,
            Mode::Jog => {
                if self.cycles.is_multiple_of(PART) {
                    self.from = self.q;
                }
                let wanted = self.wants();
                let part = self.part();
                self.ways[part] = self.ways[part].max((self.q - self.from).abs());
                self.cycles += 1;
                Ask::Jog(wanted?)
            }
            _ => return None,
        };
        Some(Command::of(ask))
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        (self.mode, self.asked, self.powered) = (Some(cycle.mode), false, cycle.reports.drives.powered);
        self.q = cycle.orders.set[0].position;
    }

    fn note(&mut self, _t: f64, _note: Note) {}
}

#[test]
fn jogging_costs_no_allocation() {
    let machine = Machine::read("m.toml", shipped("torch-5axis").unwrap().text).unwrap();
    let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
    let work = Work::none(&machine, &around);
    let mut devices = simulated_devices(&machine, 1).unwrap();
    let mut hand = Hand { home: machine.home(), ..Hand::default() };
    let mut executive = Executive::new(&machine, &mut devices, &mut hand);
    assert_no_alloc(|| executive.serve(Some(&work)));
    assert_eq!(violation_count(), 0);
    assert!(hand.begins == 2 && (0.49..0.51).contains(&hand.ways[1]), "{:?}", hand.ways);
    assert!(hand.ways[0] > 1.0 && (1.99..2.01).contains(&hand.ways[2]), "{:?}", hand.ways);
}

/// Exchanges in real time cost no allocation: with a supervisor, and over gaps on a manual clock, tolerated ones and
/// others.
#[test]
fn cycles_in_real_time_cost_no_allocation() {
    let machine = Machine::read("m.toml", shipped("ellipse-xy").unwrap().text).unwrap();
    let (mut orders, mut reports) = (Orders::default(), Reports::default());
    let shutdown = Shutdown::default();
    let mut paced = Paced::supervised(simulated_devices(&machine, 1).unwrap(), &machine, &shutdown);
    assert_no_alloc(|| {
        for _ in 0..100 {
            orders.watchdog = orders.watchdog.next(false);
            paced.exchange(&orders, &mut reports);
        }
    });
    let time = ManualTime::default();
    let pacer = Pacer::by(time.clone(), machine.servo_period_s);
    let mut paced = Paced::new(simulated_devices(&machine, 1).unwrap(), &machine, pacer);
    let mut late = 0;
    assert_no_alloc(|| {
        for k in 0..2000u32 {
            time.advance(Duration::from_millis(if k % 10 == 0 { u64::from(k) } else { 0 }));
            paced.exchange(&orders, &mut reports);
            late += u32::from(reports.late);
        }
    });
    assert_eq!(violation_count(), 0);
    assert!(late > 100, "{late}");
}

/// A weld that ends by a late cycle costs no allocation: the alarm, the stop and the notes included.
#[test]
fn a_late_cycle_costs_no_allocation() {
    /// Lets the clock run ahead once while the arc burns.
    struct Freezing<D>(D, ManualTime, u32);

    impl<D: Devices> Devices for Freezing<D> {
        fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
            self.0.exchange(orders, reports);
            self.2 += u32::from(reports.source.burning);
            if reports.source.burning && self.2 == 500 {
                self.1.advance(Duration::from_secs(2));
            }
        }

        fn rides_out(&self) -> Slack {
            self.0.rides_out()
        }

        fn drives_late_s(&self) -> f64 {
            self.0.drives_late_s()
        }
    }

    /// Welds until a fault, then quits.
    #[derive(Default)]
    struct Unlucky {
        operator: Operator,
        alarms: u32,
    }

    impl Port for Unlucky {
        fn command(&mut self, t: f64) -> Option<Command> {
            if self.alarms > 0 { Some(Command::of(Ask::Quit)) } else { self.operator.command(t) }
        }

        fn show(&mut self, cycle: &Cycle<'_>) {
            self.operator.show(cycle);
        }

        fn note(&mut self, _t: f64, note: Note) {
            self.alarms += u32::from(matches!(note, Note::Alarm(_)));
        }
    }

    let planned = Planned::new(&short_saddle());
    let time = ManualTime::default();
    let devices = Freezing(simulated_devices(&planned.machine, 1).unwrap(), time.clone(), 0);
    let mut paced = Paced::new(devices, &planned.machine, Pacer::by(time, planned.machine.servo_period_s));
    let mut operator = Unlucky::default();
    let work = planned.work(Start::at_home(&planned.motion));
    let mut executive = Executive::new(&planned.machine, &mut paced, &mut operator);
    assert_no_alloc(|| executive.serve(Some(&work)));
    assert_eq!(violation_count(), 0);
    assert!(executive.left().is_some());
    drop(executive);
    assert_eq!(operator.alarms, 1);
}
