//! Teaching in simulation: the shipped machines, misplaced seams, the hidden truth at the end.

use crate::common::soak;
use glam::DVec3;
use seamwright_frames::FrameError;
use seamwright_geometry::reduce::Method;
use seamwright_machine::{Clamped, Joints, Machine, Surroundings, shipped};
use seamwright_message::Message;
use seamwright_motion::PassMotion;
use seamwright_program::TorchPath as _;
use seamwright_simulation::camera_simulator::{Appearance, CameraSimulator, Distortion};
use seamwright_simulation::teaching::{SimulatedRig, Truth, truth};
use seamwright_teaching::{
    Answer, CameraPose, Carrier, Crawl, End, JointFollower, Kind, Lean, LinePoint, NoOperator, Operator,
    ReductionTolerances, SeamLine, Settings, Setup, Station, TaughtLine, TaughtRun, smoothed, to_program, torch_axes,
};
use seamwright_weld::{NoFiles, Welding};
use std::time::{Duration, Instant};

/// Maximum length of a bridged tack, pixels: 10 mm.
const LONGEST_GAP_PX: f64 = 100.0;

const PLACED_WRONG: Distortion = Distortion { shift_mm: 1.5, turn: 0.005, bend_mm: 1.5 };

struct Bench {
    welding: Welding,
    machine: Machine,
    nominal: SeamLine,
    planned: PassMotion,
}

impl Bench {
    /// Plans a job; `machine` is the text of a machine file other than the shipped one.
    fn new(job: &str, machine: Option<&str>) -> Self {
        let welding = Welding::read("job.toml", job).unwrap();
        let text = machine.unwrap_or_else(|| shipped(&welding.program.value.machine).unwrap().text);
        let machine = Machine::read("m.toml", text).unwrap();
        let seam = welding.seam.as_ref().unwrap();
        let place = welding.program.value.seam_in_work();
        let length = if seam.all_round() { seam.length() } else { seam.weld_length() };
        let nominal = SeamLine::sampled(length, seam.all_round(), |s| {
            let p = seam.at(s);
            Station { point: place.transform_point3(p.point), normal: place.transform_vector3(p.bisector) }
        });
        let planned = PassMotion::plan(&machine, &welding.path(0), &welding.program.value.passes[0], 1);
        let planned = planned.unwrap_or_else(|f| panic!("{f:?}"));
        Self { welding, machine, nominal, planned }
    }

    /// Returns the axis positions of the planned weld nearest to a point.
    fn guide(&self, point: DVec3) -> Option<Joints> {
        Some(self.planned.path.at(self.nominal.foot(point)?.way.min(self.planned.path.length())))
    }
}

struct Taught {
    run: TaughtRun,
    line: TaughtLine,
    smooth: Vec<LinePoint>,
    truth: Truth,
    actual: SeamLine,
    frames: usize,
    a_frame: Duration,
}

/// Teaches the misplaced part of a seed, with tacks from and to these lengths, mm.
fn teach(bench: &Bench, tacks: &[(f64, f64)], seed: u64, operator: &mut dyn Operator) -> Taught {
    teach_actual(bench, PLACED_WRONG.of(&bench.nominal, seed), tacks, seed, operator)
}

fn teach_actual(
    bench: &Bench,
    actual: SeamLine,
    tacks: &[(f64, f64)],
    seed: u64,
    operator: &mut dyn Operator,
) -> Taught {
    let Bench { machine, nominal, .. } = bench;
    let sensor = &machine.sensors[0];
    let appearance = Appearance { tacks: tacks.to_vec(), ..Appearance::default() };
    let eye = CameraSimulator::new(machine, sensor, actual.clone(), appearance, seed).unwrap();
    let around = Surroundings::new(machine, &Clamped::default()).unwrap();
    let guide = |point| bench.guide(point);
    let carrier = Carrier::new(machine, sensor, &around, Some(&guide), bench.planned.path.at(0.0));
    let mut rig = SimulatedRig::new(carrier, eye);
    // The operator puts the cross on the joint's start, with a realistic error.
    let (start, _) = actual.at(0.0);
    let (_, along) = nominal.at(0.0);
    let across = start.normal.cross(along);
    let start = CameraPose {
        point: start.point + 0.3 * across + 0.5 * along,
        normal: start.normal,
        along: along + 0.1 * across,
    };
    let settings = Settings {
        ends_after_mm: if nominal.is_closed() { f64::INFINITY } else { nominal.length() - 10.0 },
        ..Settings::default()
    };
    let seamwright_machine::Sight::Camera(camera) = &sensor.sight else { panic!("no camera") };
    let mut walk = Crawl::new(settings, &camera.table, nominal, start);
    let mut midline = JointFollower::new(LONGEST_GAP_PX);
    let begun = Instant::now();
    let mut frames = 0;
    let setup = Setup { machine, sensor, midline: &mut midline, operator };
    let run = seamwright_teaching::teach(setup, &mut walk, &mut rig, &mut |_| {
        frames += 1;
        Ok::<(), FrameError>(())
    });
    let run = run.unwrap();
    let a_frame = begun.elapsed() / frames.max(1) as u32;
    if !run.asked.is_empty() {
        walk.notes().iter().rev().take(4).for_each(|n| println!("{n:?}"));
    }
    let smooth = smoothed(&walk.levelled(), 0.5, 2.5, matches!(run.end, Some(End::Closed { .. })));
    let truth = truth(&actual, &smooth);
    Taught { run, line: walk.line().clone(), smooth, truth, actual, frames, a_frame }
}

fn no_one() -> NoOperator {
    NoOperator::default()
}

/// Tilts the torch within a job's limits, differently at each position.
fn lean(p: &LinePoint) -> Lean {
    Lean { work: 0.2 * (0.01 * p.way).sin(), travel: 0.1, first_is_left: true }
}

fn check(name: &str, seed: u64, bench: &Bench, taught: &Taught) {
    let t = &taught.truth;
    let axes = torch_axes(&taught.smooth, &lean);
    let like = &bench.welding.program.value;
    let tolerances = ReductionTolerances { path_mm: 0.05, attitude_rad: 0.01 };
    let [arcs, spline] = [Kind::Arcs(Method::Greedy), Kind::Spline]
        .map(|kind| to_program(&taught.smooth, &axes, like, tolerances, kind).unwrap());
    let [lines, bent, _] = arcs.curves.counts();
    println!(
        "{name} seed {seed}: {:?}, {} frames, {:.1} ms a frame, across {:.3} RMS {:.3} max, height {:.3} RMS {:.3} max, \
         bridged {:.1} mm {:.3} max, ends {:.3} {:.3}, {} spans ({bent} arcs) of {} points within {:.3}, spline of {} \
         within {:.3}, torch {:.2} deg off",
        taught.run.end,
        taught.frames,
        taught.a_frame.as_secs_f64() * 1e3,
        t.across_rms,
        t.across_max,
        t.height_rms,
        t.height_max,
        t.bridged,
        t.bridged_max,
        t.start,
        t.end,
        lines + bent,
        taught.line.points().len(),
        arcs.curves.max_error(),
        spline.curves.counts()[2],
        spline.curves.max_error(),
        turned(taught, &axes).to_degrees(),
    );
    assert!(taught.run.asked.is_empty(), "{name} seed {seed}: {:?}", taught.run.asked);
    assert!(t.across_rms <= 0.05 && t.across_max <= 0.1, "{name} seed {seed}: {t:?}");
    assert!(t.height_rms <= 0.03 && t.height_max <= 0.06, "{name} seed {seed}: {t:?}");
    assert!(t.start <= 0.8 && t.end <= 0.3 && t.bridged_max < 0.5, "{name} seed {seed}: {t:?}");
    assert!(turned(taught, &axes) < 0.02, "{name} seed {seed}: {}", turned(taught, &axes));
    for program in [arcs, spline] {
        assert!(program.curves.max_error() <= 0.05);
        assert!(program.curves.counts().iter().sum::<usize>() * 5 < taught.smooth.len());
        // It is a program: it reads back, and its pass is as long as the taught line. All along it the tip is on the
        // line and the torch has the attitude found.
        let text = program.program.to_toml().unwrap();
        let again = Welding::read_with("taught.toml", &text, &NoFiles).unwrap();
        // The machine's surroundings are those during teaching.
        let part = |welding: &Welding| -> Vec<_> {
            let clamped = welding.clamped(&|_| Err(std::io::ErrorKind::NotFound.into())).unwrap();
            clamped.part.iter().map(|solid| (solid.name().to_owned(), *solid.pose())).collect()
        };
        assert!(!part(&bench.welding).is_empty(), "{name}");
        assert_eq!(part(&again), part(&bench.welding), "{name}");
        let pass = again.path(0);
        let line = taught.smooth.windows(2).map(|w| w[0].point.distance(w[1].point)).sum::<f64>();
        assert!((pass.length() - line).abs() < 0.01 * line, "{} {line}", pass.length());
        let count = 1000;
        let mut near = 0;
        for k in 0..=count {
            let pose = pass.pose(pass.length() * f64::from(k) / f64::from(count));
            // The nearest point about here.
            while near + 1 < taught.smooth.len()
                && taught.smooth[near + 1].point.distance(pose.point) <= taught.smooth[near].point.distance(pose.point)
            {
                near += 1;
            }
            let off = pose.point - taught.smooth[near].point;
            assert!(off.length() < 0.4, "{name} seed {seed}, {k}: {off}");
            let turned = (-pose.direction).angle_between(axes[near]);
            assert!(turned < 0.03, "{name} seed {seed}, {k}: {turned}");
        }
    }
}

/// Returns the maximum angle between the torch and its attitude over the actual seam, rad.
fn turned(taught: &Taught, axes: &[DVec3]) -> f64 {
    let off = |(p, axis): (&LinePoint, &DVec3)| {
        let foot = taught.actual.foot(p.point)?;
        let normal = foot.at.normal.reject_from_normalized(foot.along).normalize();
        let actual = LinePoint { normal, ..*p };
        let Lean { work, travel, .. } = lean(&actual);
        let across = work.cos() * normal + work.sin() * normal.cross(foot.along);
        Some((travel.cos() * across + travel.sin() * foot.along).angle_between(*axis))
    };
    taught.smooth.iter().zip(axes).filter_map(off).fold(0.0, f64::max)
}

fn half_ring() -> String {
    let job = include_str!("../../../../examples/oblique-girth.toml");
    job.replace("overlap_mm = 25                   # the table turns a little more than once", "end_phi_deg = 210")
}

#[test]
fn half_an_oblique_ring_on_a_cylinder() {
    let bench = Bench::new(&half_ring(), None);
    for seed in 1..=soak().unwrap_or(1) {
        let taught = teach(&bench, &[(80.0, 86.0), (200.0, 204.0)], seed, &mut no_one());
        assert_eq!(taught.run.end, Some(End::JointEnd), "seed {seed}: {:?}", taught.run.asked);
        // At least four axes move, as in the paper.
        let range = |axis: usize| {
            let values = taught.run.axes.iter().map(|q| q[axis]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            bench.machine.axes[axis].to_file(high - low)
        };
        let moving = (0..bench.machine.axes.len()).filter(|&a| range(a) > 2.0).count();
        assert!(moving >= 4, "{moving}");
        check("half ring", seed, &bench, &taught);
    }
}

#[test]
fn a_closed_saddle() {
    let job = include_str!("../../../../examples/saddle.toml").replace("procedure = ", "# procedure = ");
    let bench = Bench::new(&job, None);
    for seed in 1..=soak().unwrap_or(1) {
        let taught = teach(&bench, &[(100.0, 106.0), (900.0, 905.0)], seed, &mut no_one());
        assert!(matches!(taught.run.end, Some(End::Closed { gap_mm }) if gap_mm < 0.1), "{:?}", taught.run.end);
        check("saddle", seed, &bench, &taught);
    }
}

const S_CURVE: &str = "schema = 1
title = \"S\"
machine = \"ebw-7axis\"
[placement]
move_mm = [0, 0, 60]
[seam.spline]
joint = \"butt\"
points_mm = [[-120, 0, 0], [-90, 30, 0], [-50, 38, 0], [-15, 15, 0], [15, -15, 0], [50, -38, 0], [90, -30, 0], [120, 0, 0]]
[weld]
speed_mm_s = 8
[weld.process]
beam_ma = 30
";

#[test]
fn an_s_with_tacks() {
    let bench = Bench::new(S_CURVE, None);
    for seed in 1..=soak().unwrap_or(1) {
        let taught = teach(&bench, &[(30.0, 35.0), (120.0, 128.0), (220.0, 223.0)], seed, &mut no_one());
        assert_eq!(taught.run.end, Some(End::JointEnd), "seed {seed}: {:?}", taught.run.asked);
        check("S", seed, &bench, &taught);
    }
}

/// Jogs to the end of the tack, where the joint appears.
struct Helper<'a> {
    actual: &'a SeamLine,
    way: f64,
    asked: usize,
}

impl Operator for Helper<'_> {
    fn answer(&mut self, _why: &Message, crawl: &Crawl) -> Answer {
        self.asked += 1;
        if self.asked > 1 {
            return Answer::End;
        }
        assert!(crawl.line().length() < self.way);
        let (station, along) = self.actual.at(self.way);
        let across = station.normal.cross(along);
        Answer::Point(station.point + 0.3 * across, Some(along))
    }
}

#[test]
fn a_long_tack_is_asked_about() {
    let bench = Bench::new(S_CURVE, None);
    let tack = (100.0, 140.0);
    let actual = PLACED_WRONG.of(&bench.nominal, 3);
    let mut helper = Helper { actual: &actual, way: tack.1 + 2.0, asked: 0 };
    let taught = teach(&bench, &[tack], 3, &mut helper);
    assert_eq!((taught.run.end.clone(), helper.asked), (Some(End::JointEnd), 1), "{:?}", taught.run.asked);
    assert!(taught.truth.across_max <= 0.1 && taught.truth.end <= 0.3, "{:?}", taught.truth);
    assert!((35.0..50.0).contains(&taught.truth.bridged), "{:?}", taught.truth);
    // Without an operator, the joint found up to the tack is kept.
    let mut alone = no_one();
    let taught = teach(&bench, &[tack], 3, &mut alone);
    assert!(alone.asked && taught.run.end == Some(End::Operator));
    assert!((taught.line.length() - tack.0).abs() < 1.5, "{}", taught.line.length());
}

/// The end is the visible end of the joint, whether the nominal seam ends before or after it. Far before the nominal
/// end the operator is asked, since a long tack looks the same.
#[test]
fn the_end_is_found_by_sight() {
    let bench = Bench::new(S_CURVE, None);
    // Stations are half a millimetre apart.
    for (seed, less) in [(1, 0), (2, 6), (3, 17)] {
        let whole = PLACED_WRONG.of(&bench.nominal, seed);
        let kept = whole.stations().len() - less;
        let actual = SeamLine::through(whole.stations()[..kept].to_vec(), false);
        let taught = teach_actual(&bench, actual, &[], seed, &mut no_one());
        assert_eq!(taught.run.end, Some(End::JointEnd), "{less}: {:?}", taught.run.asked);
        assert!(taught.truth.end <= 0.3, "{less}: {:?}", taught.truth);
    }
    for (seed, less) in [(1, 8), (2, 25)] {
        let actual = PLACED_WRONG.of(&bench.nominal, seed);
        let nominal =
            SeamLine::through(bench.nominal.stations()[..bench.nominal.stations().len() - less].to_vec(), false);
        let short = Bench { nominal, ..Bench::new(S_CURVE, None) };
        let taught = teach_actual(&short, actual, &[], seed, &mut no_one());
        assert_eq!(taught.run.end, Some(End::JointEnd), "-{less}: {:?}", taught.run.asked);
        assert!(taught.truth.end <= 0.3, "-{less}: {:?}", taught.truth);
    }
    let half = SeamLine::through(PLACED_WRONG.of(&bench.nominal, 4).stations()[..300].to_vec(), false);
    let taught = teach_actual(&bench, half, &[], 4, &mut no_one());
    assert_eq!(taught.run.end, Some(End::Operator));
    assert!(taught.run.asked[0].to_string().contains("it ends here") && taught.truth.end <= 0.3, "{:?}", taught.truth);
}

#[test]
fn limits_and_zones_end_it() {
    let text = shipped("ebw-7axis").unwrap().text;
    let bench = Bench::new(S_CURVE, None);
    // The carriage ends in the middle of the S; or an obstacle stands there that the gun must keep clear of.
    let short = text.replacen("range_mm = [-1000, 1000]", "range_mm = [-1000, 40]", 1);
    let zone = "[[zones]]\nname = \"clamp\"\nkind = \"forbidden\"\non = \"base\"\nwatch = [\"torch\"]\n[[zones.solids]]\n\
        shape.box = { size_mm = [100, 600, 500] }\nat = { move_mm = [180, 0, 60] }\n\n[drives.x]";
    let zoned = text.replacen("[drives.x]", zone, 1);
    for (text, what) in [(short, "axis x"), (zoned, "clamp")] {
        let bench = Bench { machine: Machine::read("m.toml", &text).unwrap(), ..Bench::new(S_CURVE, None) };
        let taught = teach(&bench, &[], 1, &mut no_one());
        let Some(End::Limit(why)) = &taught.run.end else { panic!("{:?}", taught.run.end) };
        assert!(why.to_string().contains(what), "{why}");
        // The last frame shows some way beyond it.
        assert!(taught.line.length() > 100.0 && taught.line.length() < 250.0, "{}", taught.line.length());
        let x = bench.machine.axis("x").unwrap();
        assert!(taught.run.axes.iter().all(|q| bench.machine.axes[x].outside(q[x]).is_none()));
        assert!(taught.truth.across_max <= 0.1, "{:?}", taught.truth);
    }
    drop(bench);
}

#[test]
fn the_same_seed_teaches_the_same() {
    let bench = Bench::new(S_CURVE, None);
    let again = || teach(&bench, &[(30.0, 35.0)], 5, &mut no_one());
    let (a, b) = (again(), again());
    assert_eq!(a.line, b.line);
    assert_eq!(a.actual.stations(), b.actual.stations());
    assert!(teach(&bench, &[(30.0, 35.0)], 6, &mut no_one()).line != a.line);
}
