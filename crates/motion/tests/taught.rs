//! Motion along taught points.

use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use seamwright_machine::{Joints, MAX_AXES, Machine, shipped};
use seamwright_motion::law::{Channels, LawStream};
use seamwright_motion::taught::{Corner, TaughtPath};
use std::f64::consts::TAU;

/// A machine with the limits of a measurement of rivals: 50 mm/s, 500 mm/s^2; 60 deg/s, 600 deg/s^2; jerk ten times that;
/// both rotary axes through the origin, as there.
fn machine() -> Machine {
    let text = shipped("table-tilting-xyzac").unwrap().text.replace("at_mm = [0, 20, 10]", "at_mm = [0, 0, 0]");
    let mut machine = Machine::read("machine", &text).unwrap();
    for axis in &mut machine.axes {
        let unit = if axis.unit() == "mm" { 50.0 } else { 60f64.to_radians() };
        (axis.max_speed, axis.max_acceleration, axis.max_jerk) = (unit, 10.0 * unit, 100.0 * unit);
    }
    machine
}

fn axes(values: [f64; 5]) -> Joints {
    std::array::from_fn(|i| values.get(i).copied().unwrap_or(0.0))
}

/// Axis positions on the saddle of a nozzle of radius 25 on a shell of radius 60, tilt 20 sin(phi) degrees, one turn.
fn saddle(phi: f64) -> Joints {
    let z = (3600.0 - (25.0 * phi.sin()).powi(2)).sqrt();
    let tilt = 20f64.to_radians() * phi.sin();
    axes([25.0, -z * tilt.sin(), z * tilt.cos(), tilt, phi])
}

/// The saddle every `step` mm of the tip's way, and its end.
fn cut(machine: &Machine, step: f64) -> Vec<Joints> {
    let tip = |phi: f64| machine.forward(&saddle(phi)).point;
    let mut points = vec![saddle(0.0)];
    let (mut way, mut last) = (0.0, tip(0.0));
    for i in 1..600_000 {
        let phi = TAU * f64::from(i) / 6e5;
        let next = tip(phi);
        way += next.distance(last);
        last = next;
        if way >= step {
            points.push(saddle(phi));
            way -= step;
        }
    }
    points.push(saddle(TAU));
    points
}

/// What a run along points did.
struct Run {
    duration: f64,
    stops: usize,
    /// Greatest use of speeds, accelerations and jerks.
    used: [f64; 3],
    /// Instant, speed of the tip, positions.
    rows: Vec<(f64, f64, Joints)>,
}

fn run(machine: &Machine, points: Vec<Joints>, speed: f64, corner: Corner, period: f64) -> Run {
    let path = TaughtPath::new(machine, points.into_iter(), speed, corner, 0.01);
    let mut law = LawStream::new(path, 4.0).unwrap();
    let (mut rows, mut used) = (Vec::new(), [0.0f64; 3]);
    let mut d = vec![[0.0; 3]; machine.axes.len()];
    for k in 0.. {
        let t = f64::from(k) * period;
        let Some(p) = law.at(t).unwrap() else { break };
        let tip = law.path().derivatives(p.s, false, &mut d);
        for ([q1, q2, q3], axis) in d.iter().zip(&machine.axes) {
            let rates = [
                q1 * p.v / axis.max_speed,
                (q2 * p.v * p.v + q1 * p.a) / axis.max_acceleration,
                (q3 * p.v.powi(3) + 3.0 * q2 * p.v * p.a + q1 * p.j) / axis.jerk(),
            ];
            (0..3).for_each(|i| used[i] = used[i].max(rates[i].abs()));
        }
        rows.push((t, tip * p.v, law.path().position(p.s)));
    }
    Run { duration: law.duration().unwrap(), stops: law.stops(), used, rows }
}

#[test]
fn any_segmentation_is_the_same_weld() {
    let machine = machine();
    let mut durations = Vec::new();
    for step in [2.0, 0.5, 0.02] {
        let run = run(&machine, cut(&machine, step), 20.0, Corner::Stop, 1e-3);
        let fastest = run.rows.iter().map(|r| r.1).fold(0.0, f64::max);
        println!("{step} mm: {} s, fastest {fastest} mm/s, use of limits {:?}", run.duration, run.used);
        assert!(run.used.iter().all(|u| *u <= 1.0 + 1e-9) && run.stops == 0, "{step}: {:?}", run.used);
        assert!(fastest <= 20.0 * (1.0 + 1e-9) && fastest > 19.97);
        // The tip is on the saddle: on the nozzle's wall and on the shell.
        for (_, _, q) in &run.rows {
            let tip = machine.forward(q).point;
            assert!((tip.truncate().length() - 25.0).abs() < 1e-4, "{step}: {tip}");
            assert!(((tip.y * tip.y + tip.z * tip.z).sqrt() - 60.0).abs() < 1e-4, "{step}: {tip}");
        }
        durations.push(run.duration);
    }
    // The same law on the path in closed form takes 8.1346 s (tests/law).
    assert!(durations.iter().all(|d| (d / 8.1346 - 1.0).abs() < 1e-3), "{durations:?}");
}

#[test]
fn corners_are_met_exactly_or_passed_within_the_tolerance() {
    let machine = machine();
    let square: Vec<Joints> = [[0.0, 0.0], [40.0, 0.0], [40.0, 40.0], [0.0, 40.0], [0.0, 0.0]]
        .map(|[x, y]| axes([x, y, 50.0, 0.0, 0.0]))
        .to_vec();
    let least = |run: &Run, corner: usize| {
        run.rows
            .iter()
            .map(|r| machine.forward(&r.2).point.distance(machine.forward(&square[corner]).point))
            .fold(f64::MAX, f64::min)
    };
    let stopped = run(&machine, square.clone(), 20.0, Corner::Stop, 1e-3);
    let blended = run(&machine, square.clone(), 20.0, Corner::Blend(0.2), 1e-3);
    for corner in 1..4 {
        assert!(least(&stopped, corner) < 1e-6, "{}", least(&stopped, corner));
        let off = least(&blended, corner);
        assert!(off < 0.2 + 1e-3 && off > 0.15, "{off}");
    }
    let slowest = blended.rows[500..blended.rows.len() - 500].iter().map(|r| r.1).fold(f64::MAX, f64::min);
    assert!(slowest > 3.0 && blended.duration < stopped.duration, "{slowest}");
    for run in [stopped, blended] {
        assert!(run.used.iter().all(|u| *u <= 1.0 + 1e-9), "{:?}", run.used);
    }
}

/// A walk with steps of very different lengths: some of nothing, some of a nanometre, some straight back, some of one
/// axis only while the tip stands still.
fn walk(rng: &mut TestRng, count: usize) -> Vec<Joints> {
    use proptest::prelude::RngExt;
    let mut random = || rng.random::<f64>();
    let mut q = axes([0.0, 0.0, 50.0, 0.0, 0.0]);
    let mut way: Joints = axes([1.0, 0.0, 0.0, 0.0, 0.0]);
    let mut points = vec![q];
    for _ in 0..count {
        let kind = (random() * 10.0) as u32;
        let length = 10f64.powf(random() * 5.0 - 3.0).min(5.0);
        match kind {
            0 => points.push(q),
            1 => q[0] += 1e-9,
            2 => way = way.map(|w| -w),
            3 => q[4] += 0.02 * random(),
            _ => (0..3).for_each(|i| way[i] += 0.3 * (random() - 0.5)),
        }
        let norm = way.iter().map(|w| w * w).sum::<f64>().sqrt().max(1e-3);
        (0..3).for_each(|i| q[i] += length * way[i] / norm);
        points.push(q);
    }
    points
}

#[test]
fn rough_walks_are_followed_within_limits_to_their_end() {
    let machine = machine();
    let mut runner = TestRunner::new_with_rng(
        Config { failure_persistence: None, ..Config::default() },
        TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]),
    );
    let soak: usize = std::env::var("SEAMWRIGHT_SOAK").ok().and_then(|v| v.parse().ok()).unwrap_or(1);
    for case in 0..40 * soak {
        let points = walk(&mut runner.new_rng(), 60);
        let last = points[points.len() - 1];
        let corner = if case % 2 == 0 { Corner::Stop } else { Corner::Blend(0.05) };
        let run = run(&machine, points.clone(), 15.0, corner, 2e-3);
        assert!(run.used.iter().all(|u| *u <= 1.0 + 1e-9), "{case}: {:?}", run.used);
        let end = run.rows[run.rows.len() - 1];
        assert!(end.1 < 1.0, "{case}: {} mm/s at the end", end.1);
        assert!((0..MAX_AXES).all(|i| (end.2[i] - last[i]).abs() < 0.02), "{case}");
        // Never far from what was taught.
        for (_, _, q) in run.rows.iter().step_by(7) {
            let tip = machine.forward(q).point;
            let near = points.iter().map(|p| machine.forward(p).point.distance(tip)).fold(f64::MAX, f64::min);
            assert!(near < 3.0, "{case}: {near} mm from every point");
        }
    }
}
