//! Times one cycle of a machine with ten axes: the set-point from the plan with its feed-forward, the inverse
//! kinematics of its pose moved by a correction, and ten position loops. Aim: 5 us in the median, 20 us for 999 of
//! 1000. Also times cycles of tracking, of beam mode and of the whole executive.

use glam::{DVec2, DVec3};
use seamwright_executive::tracking::RESERVE;
use seamwright_executive::{Devices, Executive, Orders, Place, Reports, Slack, Start};
use seamwright_machine::{AxisLimits, BeamDeflection, Clamped, Machine, Surroundings, Target, shipped};
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_program::{Pass, TorchPath};
use seamwright_servo::{Gains, Notch, PositionLoop, SetPoint};
use seamwright_simulation::tracking::Distortion;
use seamwright_simulation::{Conditions, SimulatedCell, WeldOperator};
use seamwright_tracking::actuator::{HeadTracking, SlideLimits};
use seamwright_tracking::beam::{Beam, BeamTracking, Picture, Point, Settings as BeamSettings};
use seamwright_tracking::lead::{Measurement, Moment, OwnCurve, SeamFrame, Settings};
use seamwright_weld::Welding;
use std::hint::black_box;
use std::time::Instant;

const JOB: &str = include_str!("../../../examples/t-joint.toml");
const MISPLACED: &str = include_str!("../../../examples/distortions/misplaced.toml");
const PERIOD: f64 = 1e-3;
const CYCLES: usize = 1_000_000;

fn position_loop() -> Result<PositionLoop, seamwright_servo::Error> {
    PositionLoop::new(Gains::suggested(60.0, PERIOD), PERIOD, 60.0)?
        .with_notch(Notch::new(45.0, 0.2, 30.0, PERIOD)?)?
        .with_notch(Notch::new(160.0, 0.1, 80.0, PERIOD)?)
}

fn main() {
    let welding = Welding::read("t-joint", JOB).expect("the example is good");
    let program = &welding.program.value;
    let machine = Machine::read("machine", shipped(&program.machine).expect("it ships").text).expect("it is good");
    let motion = PassMotion::plan(&machine, &welding.path(0), &program.passes[0], 1).expect("it can be welded");
    let mut loops: Vec<PositionLoop> = machine.axes.iter().map(|_| position_loop().expect("a good loop")).collect();
    assert_eq!(loops.len(), 10);

    let mut times = Vec::with_capacity(CYCLES);
    let (mut cursor, mut failed) = (0, 0);
    let mut near = motion.path.at(0.0);
    for k in 0..CYCLES {
        let t = (k as f64 * PERIOD) % motion.profile.duration();
        let begin = Instant::now();
        let profile = motion.profile.at(black_box(t), &mut cursor);
        let point = motion.path.point(profile.s, false);
        let mut target = Target::new(machine.forward_of(0, &point.q), Some(machine.forward_of(1, &point.q)));
        // Correction of the torch by a seam tracker.
        target.first.point += 0.1 * target.first.direction;
        match machine.inverse_near(black_box(target), &near) {
            Ok(solution) => near = solution.joints,
            Err(_) => failed += 1,
        }
        for (i, axis) in loops.iter_mut().enumerate() {
            let velocity = point.d1[i] * profile.v;
            let acceleration = point.d2[i] * profile.v * profile.v + point.d1[i] * profile.a;
            black_box(axis.update(SetPoint { position: near[i], velocity, acceleration }, near[i] - 1e-3));
        }
        times.push(begin.elapsed().as_nanos() as u64);
    }
    assert_eq!(failed, 0);
    print("cycle of ten axes", times);
    tracking();
    beam();
    executive();
}

/// Times the executive's work between two exchanges with its devices.
struct Timed<D> {
    devices: D,
    left: Option<Instant>,
    times: Vec<u64>,
}

impl<D: Devices> Devices for Timed<D> {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        if let Some(left) = self.left.filter(|_| orders.seam.pass > 0 && orders.process.on) {
            self.times.push(left.elapsed().as_nanos() as u64);
        }
        self.devices.exchange(orders, reports);
        self.left = Some(Instant::now());
    }

    fn rides_out(&self) -> Slack {
        self.devices.rides_out()
    }

    fn drives_late_s(&self) -> f64 {
        self.devices.drives_late_s()
    }

    fn picture(&self) -> Option<Picture<'_>> {
        self.devices.picture()
    }
}

/// Times the executive in every cycle of a weld of the T-joint: ten axes, two tracked torches, interlocks,
/// supervision, process, display. The papers' machine had 75 us for its fast inputs and outputs (EBW-2004).
fn executive() {
    let welding = Welding::read("t-joint", JOB).expect("the example is good");
    let program = &welding.program.value;
    let machine = Machine::read("machine", shipped(&program.machine).expect("it ships").text).expect("it is good");
    let planned_on = machine.with_reserve(RESERVE);
    let around = Surroundings::new(&planned_on, &Clamped::default()).expect("its shapes are good");
    let paths: Vec<_> = (0..program.passes.len()).map(|pass| welding.path(pass)).collect();
    let passes: Vec<(&dyn TorchPath, &Pass)> =
        paths.iter().zip(&program.passes).map(|(path, pass)| (path as _, pass)).collect();
    let motion = WeldMotion::plan(&planned_on, &around, &passes, 30.0).expect("it can be welded");
    let distortion = Distortion::read("misplaced.toml", MISPLACED).expect("it is good");
    let conditions = Conditions { seed: 1, distortion: Some(&distortion), tracking: true, ..Conditions::default() };
    let cell = SimulatedCell::new(&machine, passes, &motion, conditions);
    let work = cell.work(Start::at_home(&motion)).expect("it has few values");
    let devices = cell.devices().expect("its drives are good");
    let mut devices = Timed { devices, left: None, times: Vec::with_capacity(CYCLES) };
    let mut tracking = cell.tracking(Place::default()).expect("it can be tracked");
    let guide = tracking.as_mut().map(|tracking| tracking as _);
    let mut operator = WeldOperator::default();
    Executive::new(&machine, &mut devices, &mut operator).with_guide(guide).serve(Some(&work));
    assert!(devices.times.len() > 10_000, "it welds");
    print("executive: ten axes, tracking, i/o", devices.times);
}

/// Times tracking of one head at 100 mm/s on a bent seam, a measurement every 10 ms. Aim: 3 us for 999 of 1000.
fn tracking() {
    let limits =
        SlideLimits { stroke_mm: 15.0, motion: AxisLimits { speed: 50.0, acceleration: 1000.0, jerk: 20_000.0 } };
    let settings = Settings::usual(20.0, 100.0);
    let mut head = HeadTracking::new(settings, OwnCurve::straight(20.0), [limits; 2]).expect("settings that work");
    let seam = |s: f64| DVec2::new((0.02 * s).sin() + 0.1 * (0.3 * s).cos(), 0.5 * (0.03 * s).cos());
    let mut times = Vec::with_capacity(CYCLES);
    let mut slide = DVec2::ZERO;
    for k in 0..CYCLES {
        let t = k as f64 * PERIOD;
        let s = 0.1 * k as f64;
        let offset = seam(s - 1.5 + 20.0) + 0.02 * DVec2::from_angle(1.7 * k as f64) - slide;
        let measured = Measurement { exposed_s: t - 0.015, offset, confidence: 0.9 };
        let begin = Instant::now();
        if k % 10 == 0 {
            black_box(head.take(&measured, t));
        }
        slide = black_box(head.cycle(Moment { t_s: t, s_mm: s, slide }, 100.0)).slide;
        times.push(begin.elapsed().as_nanos() as u64);
    }
    assert!(slide.distance(seam(0.1 * CYCLES as f64)) < 0.3, "it follows");
    print("tracking of a head", times);
}

/// Times beam mode at 10 mm/s on a straight seam: cycles, and the pictures that come every 300 ms. Aim: as that of a
/// head.
fn beam() {
    let straight = |s: f64| SeamFrame { point: DVec3::X * s, along: DVec3::X, lateral: DVec3::Y, height: DVec3::Z };
    let range = BeamDeflection { range_mm: 1.0, speed: 2000.0, latency_s: 75e-6, pivot_mm: 400.0 };
    let axes = SlideLimits { stroke_mm: 5.0, motion: AxisLimits { speed: 5.0, acceleration: 30.0, jerk: 300.0 } };
    let mut head = BeamTracking::new(BeamSettings::usual(10.0), &straight, range, axes).expect("settings that work");
    let seam = |s: f64| 1.5 * (0.02 * s).sin();
    let (mut cycles, mut pictures) = (Vec::with_capacity(CYCLES), Vec::new());
    let mut slide = DVec2::ZERO;
    for k in 0..CYCLES {
        let (t, s) = (k as f64 * PERIOD, 0.01 * k as f64);
        let begin = Instant::now();
        let orders = black_box(head.cycle(Moment { t_s: t, s_mm: s, slide }, 10.0, true));
        cycles.push(begin.elapsed().as_nanos() as u64);
        if let Beam::Seen(exposed_s) = orders.beam {
            let points: [Point; 24] = std::array::from_fn(|i| {
                let error = 0.02 * (1.7 * (k + i) as f64).sin();
                Point { along_mm: i as f64, lateral_mm: seam(s + i as f64) + error - slide.x, confidence: 0.9 }
            });
            let begin = Instant::now();
            black_box(head.take(&Picture { exposed_s, height_mm: 0.0, points: &points }, t));
            pictures.push(begin.elapsed().as_nanos() as u64);
        }
        slide.x = orders.carried_mm;
    }
    print("beam mode of a head", cycles);
    print("  a picture of it", pictures);
}

fn print(what: &str, mut times: Vec<u64>) {
    times.sort_unstable();
    let at = |part: f64| times[((times.len() - 1) as f64 * part) as usize] as f64 * 1e-3;
    println!("{what}: median {:.2} us, p99.9 {:.2} us, most {:.0} us", at(0.5), at(0.999), at(1.0));
}
