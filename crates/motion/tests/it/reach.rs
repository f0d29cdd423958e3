//! Placements of the work: against closed forms and brute force.

use crate::planning::{machine_of, read, read_machine, shipped_machine};
use glam::DVec3;
use seamwright_machine::{AxisKind, Joints, Machine, Target};
use seamwright_motion::PassMotion;
use seamwright_motion::reach::{
    FaultKind, Judgement, Pivot, Placement, PlacementTask, ReachGrid, ReachSpan, SearchResult, search,
};
use seamwright_program::{Pass, TorchPath};
use seamwright_testkit::{Random, cases};
use seamwright_weld::Welding;
use std::f64::consts::{PI, TAU};

const ELLIPSE: &str = include_str!("../../../../examples/ellipse.toml");

/// A nozzle on a shell, near enough for the arms.
const NOZZLE: &str = include_str!("../../../../tests/data/nozzle-on-arm.toml");

/// An arm with a spherical wrist on the axis of its first turn: links of 700 and 600 mm, a torch of 300 mm along the
/// flange, and no stops within a turn.
const SHELL: &str = r#"
schema = 1
name = "shell"
title = "Arm whose reach is a shell"
servo_period_ms = 4
[torch]
direction = [1, 0, 0]
"#;
const UPPER_MM: f64 = 700.0;
const FOREARM_MM: f64 = 600.0;
const WRIST_MM: f64 = 300.0;
const SHOULDER_MM: f64 = 500.0;

fn shell() -> Machine {
    let axis = |name: &str, turn: &str, at: String, home: f64| {
        format!(
            "[[tool]]\naxis = \"{name}\"\nturn = {turn}\nat_mm = {at}\nrange_deg = [-720, 720]\nhome_deg = {home}\n\
             max_speed_deg_s = 180\nmax_acceleration_deg_s2 = 720\nmax_jerk_deg_s3 = 7200\n\n"
        )
    };
    let (elbow, wrist) = (SHOULDER_MM + UPPER_MM, FOREARM_MM);
    let mut text = SHELL.to_owned();
    text += &axis("j1", "[0, 0, 1]", "[0, 0, 0]".into(), 0.0);
    text += &axis("j2", "[0, 1, 0]", format!("[0, 0, {SHOULDER_MM}]"), 0.0);
    text += &axis("j3", "[0, 1, 0]", format!("[0, 0, {elbow}]"), 0.0);
    text += &axis("j4", "[1, 0, 0]", format!("[0, 0, {elbow}]"), 0.0);
    text += &axis("j5", "[0, 1, 0]", format!("[{wrist}, 0, {elbow}]"), 30.0);
    text += &axis("j6", "[1, 0, 0]", format!("[{wrist}, 0, {elbow}]"), 0.0);
    text += &format!("[[tool]]\nfixed = {{ move_mm = [{}, 0, {elbow}] }}\n", wrist + WRIST_MM);
    read_machine(&text)
}

/// Calls `with` with the task of a weld.
fn on<R>(machine: &Machine, welding: &Welding, with: impl FnOnce(&PlacementTask) -> R) -> R {
    let program = &welding.program.value;
    let paths: Vec<_> = (0..program.passes.len()).map(|i| welding.path(i)).collect();
    let passes: Vec<(&dyn TorchPath, &Pass)> =
        paths.iter().zip(&program.passes).map(|(path, pass)| (path as &dyn TorchPath, pass)).collect();
    with(&PlacementTask { machine, passes: &passes, procedure: program.procedure.as_ref() })
}

fn pivot() -> Pivot {
    Pivot { point: DVec3::ZERO, up: DVec3::Z }
}

fn judge(task: &PlacementTask, placement: &Placement) -> Judgement {
    task.judge(placement.affine(&pivot()), None).unwrap()
}

fn at(x: f64, y: f64, z: f64, turn: f64) -> Placement {
    Placement { by: DVec3::new(x, y, z), turn }
}

fn grid(spans: [(f64, f64, usize); 4]) -> ReachGrid {
    ReachGrid { spans: spans.map(|(from, to, cells)| ReachSpan::new(from, to, cells).unwrap()) }
}

fn searched(task: &PlacementTask, grid: &ReachGrid) -> SearchResult {
    search(grid, &mut |placements| placements.iter().map(|p| task.judge(p.affine(&pivot()), None)).collect())
}

/// On two linear axes the feasible placements are a box: the strokes less the extent of the ellipse. The extent turns with
/// the work.
#[test]
fn on_linear_axes_the_weldable_placements_are_a_box() {
    let welding = read(ELLIPSE);
    let machine = machine_of(&welding);
    let (a, b): (f64, f64) = (20.0, 16.0);
    let mut random = Random::new(47);
    let mut counts = [0, 0];
    on(&machine, &welding, |task| {
        for _ in 0..cases(300) {
            let turn = random.within(-PI, PI);
            let place = at(random.within(-640.0, 640.0), random.within(-230.0, 230.0), 0.0, turn);
            let half = [a.hypot(0.0) * turn.cos(), a * turn.sin(), b * turn.sin(), b * turn.cos()];
            let extent = [half[0].hypot(half[2]), half[1].hypot(half[3])];
            let free =
                [(600.0 - place.by.x.abs() - extent[0]) / 1200.0, (200.0 - place.by.y.abs() - extent[1]) / 400.0];
            let expected = free[0].min(free[1]);
            let judged = judge(task, &place);
            counts[usize::from(judged.margin().is_some())] += 1;
            match judged {
                Judgement::Weldable(margin) => {
                    assert!((margin.range - expected).abs() < 1e-5, "{place:?}: {margin:?}, {expected}");
                }
                Judgement::Fails(fault) => {
                    assert!(expected < 1e-9, "{place:?}: {fault:?}, {expected}");
                    assert_eq!(fault.kind, FaultKind::Range);
                    assert_eq!(fault.axis, Some(if free[0] < free[1] { 0 } else { 1 }));
                    assert!((fault.shortfall + expected).abs() < 1e-5);
                }
            }
        }
    });
    println!("{} fail, {} weldable", counts[0], counts[1]);
    assert!(counts.iter().all(|count| *count > 20));
}

/// The best placement on linear axes is in the middle of the stroke that limits, with the long axis of the ellipse along
/// the other.
#[test]
fn the_search_finds_the_middle_of_the_box() {
    let welding = read(ELLIPSE);
    let machine = machine_of(&welding);
    let grid = grid([(-300.0, 250.0, 4), (-150.0, 120.0, 4), (0.0, 0.0, 1), (-PI, PI, 1)]);
    let found = on(&machine, &welding, |task| searched(task, &grid));
    assert!(found.is_complete);
    let best = found.ranked()[0];
    let margin = best.judgement.margin().unwrap();
    // Limited by y: 200 mm less the half axis of 16 mm, of a stroke of 400 mm.
    assert!((margin.range - 0.46).abs() < 2e-3, "{best:?}");
    let brute = (0..41 * 37).map(|k| {
        let [x, y] = [f64::from(k % 41) / 40.0, f64::from(k / 41) / 36.0];
        on(&machine, &welding, |task| judge(task, &at(-300.0 + 550.0 * x, -150.0 + 270.0 * y, 0.0, 0.0)).score())
    });
    let brute = brute.fold(f64::NEG_INFINITY, f64::max);
    // A step of the local search is 1.4 mm of 400.
    assert!(best.judgement.score() >= brute - 8e-3, "{} {brute}", best.judgement.score());
    // The same again.
    assert_eq!(found, on(&machine, &welding, |task| searched(task, &grid)));
}

/// With the torch upright the wrist moves above the seam by the torch's length: the arm reaches it if it stays in the shell
/// about the shoulder between the difference and the sum of the links.
#[test]
fn the_reach_of_an_arm_with_a_spherical_wrist_is_a_shell() {
    let machine = shell();
    let welding = read(ELLIPSE);
    let mut random = Random::new(4);
    let mut counts = [0, 0];
    on(&machine, &welding, |task| {
        for _ in 0..cases(60) {
            let place =
                at(random.within(-1500.0, 1500.0), random.within(-1500.0, 1500.0), random.within(0.0, 900.0), 0.0);
            let radius = |k: u32| {
                let (sin, cos) = (TAU * f64::from(k) / 720.0).sin_cos();
                let wrist = place.by + DVec3::new(20.0 * cos, 16.0 * sin, WRIST_MM - SHOULDER_MM);
                wrist.length()
            };
            let (least, most) = (0..720).map(radius).fold((f64::INFINITY, 0.0f64), |(l, m), r| (l.min(r), m.max(r)));
            let room = (UPPER_MM + FOREARM_MM - most).min(least - (UPPER_MM - FOREARM_MM));
            let judged = judge(task, &place);
            counts[usize::from(room > 0.0)] += 1;
            // Within 5 mm of the shell's surface the arm is nearly stretched, and speed limits it.
            if room < -0.01 {
                assert_eq!(judged.fault().map(|f| f.kind), Some(FaultKind::Reach), "{place:?} {room} {judged:?}");
            } else if room > 5.0 && place.by.truncate().length() > 100.0 {
                assert!(judged.margin().is_some(), "{place:?} {room} {judged:?}");
            }
        }
    });
    println!("{} out of the shell, {} in it", counts[0], counts[1]);
    assert!(counts.iter().all(|count| *count > 5));
}

/// Positions of an arm within its ranges at a pose, by rolls of 3 degrees and every branch.
fn reaches(machine: &Machine, path: &dyn TorchPath, s: f64) -> bool {
    let pose = path.pose(s);
    let (u, v) = pose.direction.any_orthonormal_pair();
    let free: Vec<usize> = machine.free().iter().collect();
    let samples: u32 = if free.is_empty() { 1 } else { 400 };
    (0..samples).any(|k| {
        let mut near: Joints = machine.home();
        let spread = machine.spread(k + 1);
        free.iter().for_each(|&axis| near[axis] = spread[axis]);
        (0..120).any(|roll| {
            let (sin, cos) = (TAU * f64::from(roll) / 120.0).sin_cos();
            let target = Target { across: Some(cos * u + sin * v), ..Target::from(pose) };
            let branches = machine.inverse(target, &near);
            branches.is_ok_and(|b| b.iter().any(|s| !machine.turns_in_range(&s.joints).is_empty()))
        })
    })
}

/// Weldable placements are planned by the planner, and those out of reach have a station that brute force cannot reach
/// either.
#[test]
fn judgements_on_an_arm_agree_with_planner_and_brute_force() {
    let machine = shipped_machine("irb-2600");
    let job = NOZZLE.replace("MACHINE", "irb-2600");
    let mut random = Random::new(26);
    let mut counts = [0, 0, 0];
    for _ in 0..cases(16) {
        let place = at(
            random.within(-500.0, 500.0),
            random.within(-700.0, 700.0),
            random.within(-150.0, 300.0),
            random.within(-PI, PI),
        );
        let welding = read(&job);
        let judged = on(&machine, &welding, |task| judge(task, &place));
        let [x, y, z, turn] = place.coordinates();
        // The seam's frame is 160 mm above the pivot, on its axis.
        let moved = format!("move_mm = [{x}, {y}, {}]\nturn = [0, 0, 1]\nangle_deg = {}", z + 160.0, turn.to_degrees());
        let moved = read(&job.replace("move_mm = [0, 0, 160]", &moved));
        let path = moved.path(0);
        match judged {
            Judgement::Weldable(margin) => {
                counts[0] += 1;
                let planned = PassMotion::plan(&machine, &path, &moved.program.value.passes[0], 1);
                let planned = planned.unwrap_or_else(|found| panic!("{place:?} {margin:?}: {found:?}"));
                assert!(planned.set_points(0.05).all(|point| machine.outside(&point.q).is_none()));
            }
            Judgement::Fails(fault) if fault.kind == FaultKind::Reach => {
                counts[1] += 1;
                assert!(!reaches(&machine, &path, fault.s), "{place:?} {fault:?}");
            }
            Judgement::Fails(_) => counts[2] += 1,
        }
    }
    println!("{} weldable and planned, {} out of reach, {} with another fault", counts[0], counts[1], counts[2]);
    assert!(counts[0] > 2 && counts[1] > 2, "{counts:?}");
}

/// Longer strokes never make a weldable placement fail, and shorter ones never make a failing one weldable.
#[test]
fn longer_ranges_keep_what_is_weldable() {
    let welding = read(ELLIPSE);
    let machine = machine_of(&welding);
    let mut random = Random::new(11);
    let mut changed = 0;
    for _ in 0..cases(40) {
        let place = at(random.within(-800.0, 800.0), random.within(-300.0, 300.0), 0.0, random.within(-PI, PI));
        let mut longer = machine.clone();
        for axis in longer.axes.iter_mut().filter(|axis| axis.kind == AxisKind::Linear) {
            let by = random.within(0.0, 300.0);
            axis.range = axis.range.map(|(low, high)| (low - by, high + by));
        }
        let [short, long] = [&machine, &longer].map(|m| on(m, &welding, |task| judge(task, &place)));
        if short.margin().is_some() {
            assert!(long.margin().is_some(), "{place:?}: {long:?}");
        }
        changed += usize::from(short.margin().is_none() && long.margin().is_some());
    }
    println!("{changed} became weldable");
    assert!(changed > 2);
}

/// A search that is stopped keeps what it has judged.
#[test]
fn a_stopped_search_keeps_its_results() {
    let welding = read(ELLIPSE);
    let machine = machine_of(&welding);
    let grid = grid([(-300.0, 300.0, 12), (-150.0, 150.0, 12), (0.0, 0.0, 1), (0.0, 0.0, 1)]);
    let mut left = 100;
    let found = on(&machine, &welding, |task| {
        search(&grid, &mut |placements| {
            let judged = placements.iter().map(|p| {
                left -= 1;
                (left > 0).then(|| task.judge(p.affine(&pivot()), None)).flatten()
            });
            judged.collect()
        })
    });
    assert!(!found.is_complete);
    assert_eq!(found.judged.len(), 99);
    assert_eq!(found.present().unwrap().placement, Placement::default());
}
