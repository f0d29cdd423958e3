//! Motion along taught points.

use glam::DVec3;
use seamwright_machine::{AxisLimits, Joints, MAX_AXES, Machine, shipped};
use seamwright_motion::speed_profile::{Channels, ProfileStream};
use seamwright_motion::taught::{Corner, TaughtPath};
use seamwright_testkit::{Random, cases};
use std::f64::consts::TAU;

/// A machine with the limits of a measurement of rivals: 50 mm/s, 500 mm/s^2; 60 deg/s, 600 deg/s^2; jerk ten times
/// that; both rotary axes through the origin, as there.
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

/// The saddle every `step` mm of the tip's path, and its end.
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

struct Run {
    duration: f64,
    stops: usize,
    /// Maximum use of speeds, accelerations and jerks.
    used: [f64; 3],
    rows: Vec<(f64, f64, Joints)>,
}

fn run(machine: &Machine, points: Vec<Joints>, speed: f64, corner: Corner, period: f64) -> Run {
    let path = TaughtPath::new(machine, points.into_iter(), speed, corner, 0.01);
    let mut profile = ProfileStream::new(path, 4.0).unwrap();
    let (mut rows, mut used) = (Vec::new(), [0.0f64; 3]);
    let mut d = vec![[0.0; 3]; profile.path().limits().len()];
    for k in 0.. {
        let t = f64::from(k) * period;
        let Some(p) = profile.at(t).unwrap() else { break };
        // Within rounding of a stop: on the side where the torch is.
        let tip = profile.path().derivatives(p.s, p.a < 0.0, &mut d);
        for ([q1, q2, q3], axis) in d.iter().zip(&machine.axes) {
            let rates = [
                q1 * p.v / axis.max_speed,
                (q2 * p.v * p.v + q1 * p.a) / axis.max_acceleration,
                (q3 * p.v.powi(3) + 3.0 * q2 * p.v * p.a + q1 * p.j) / axis.jerk(),
            ];
            (0..3).for_each(|i| used[i] = used[i].max(rates[i].abs()));
        }
        rows.push((t, tip * p.v, profile.path().position(p.s)));
    }
    Run { duration: profile.duration().unwrap(), stops: profile.stops(), used, rows }
}

#[test]
fn any_segmentation_is_the_same_weld() {
    let machine = machine();
    let mut durations = Vec::new();
    for step in [2.0, 0.5, 0.02] {
        let run = run(&machine, cut(&machine, step), 20.0, Corner::Stop, 1e-3);
        let fastest = run.rows.iter().map(|r| r.1).fold(0.0, f64::max);
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
    // The same profile on the path in closed form takes 8.1346 s (tests/speed_profile).
    assert!(durations.iter().all(|d| (d / 8.1346 - 1.0).abs() < 1e-3), "{durations:?}");
}

#[test]
fn the_tip_keeps_limits_of_its_own_in_every_direction() {
    let mut machine = machine();
    let (speed, acceleration, jerk) = (15.0, 12.0, 60.0);
    machine.tip = AxisLimits { speed, acceleration, jerk };
    let period = 2e-3;
    let run = run(&machine, cut(&machine, 0.1), 20.0, Corner::Stop, period);
    let tips: Vec<DVec3> = run.rows.iter().map(|r| machine.forward(&r.2).point).collect();
    let most = |v: &[DVec3]| v.iter().map(|v| v.length()).fold(0.0, f64::max);
    let slope = |v: &[DVec3]| -> Vec<DVec3> { v.windows(2).map(|w| (w[1] - w[0]) / period).collect() };
    let v = slope(&tips);
    // Jerks by wider differences: they would else be rounding.
    let a = slope(&v);
    let j: Vec<DVec3> = a.windows(11).map(|w| (w[10] - w[0]) / (10.0 * period)).collect();
    let used = [most(&v) / speed, most(&a) / acceleration, most(&j) / jerk];
    assert!(used.iter().all(|u| *u <= 1.0 + 1e-3), "{used:?}");
    // And they bind: the nozzle's bend of 25 mm allows 17.3 mm/s, so the speed does first.
    assert!(used[0] > 0.98 && used[2] > 0.85, "{used:?}");
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

#[test]
fn corners_are_stopped_at_however_long_the_way_between_them() {
    let machine = machine();
    // From a part of a window to many times one (4 s at 20 mm/s).
    for length in [20.0, 79.0, 80.0, 81.0, 160.0, 200.0, 390.0] {
        let corners: Vec<Joints> = [[0.0, 0.0], [length, 0.0], [length, -length], [0.0, -length], [0.0, 0.0]]
            .map(|[x, y]| axes([x, y, 50.0, 0.0, 0.0]))
            .to_vec();
        for corner in [Corner::Stop, Corner::Blend(0.3)] {
            let period = 2e-3;
            let run = run(&machine, corners.clone(), 20.0, corner, period);
            // By differences of positions: the derivatives at either side of a corner would not show it.
            for w in run.rows.windows(3) {
                for (i, axis) in machine.axes.iter().enumerate() {
                    let a = (w[2].2[i] - 2.0 * w[1].2[i] + w[0].2[i]) / (period * period);
                    assert!(a.abs() <= axis.max_acceleration * (1.0 + 1e-6), "{length} {corner:?}: {a} at {}", w[1].0);
                }
            }
            assert_eq!(run.stops, 0, "{length} {corner:?}");
            let end = run.rows[run.rows.len() - 1].2;
            assert!((0..2).all(|i| (end[i] - corners[4][i]).abs() < 1e-3), "{length}: {end:?}");
        }
    }
}

#[test]
fn the_way_is_kept_where_points_are_left_out() {
    let machine = machine();
    // Straight on, then turned by an angle less than a corner's, or into an arc.
    let bend = |angle: f64| {
        move |w: f64| if w < 80.0 { [w, 0.0] } else { [80.0 + (w - 80.0) * angle.cos(), (w - 80.0) * angle.sin()] }
    };
    let arc = |r: f64| {
        move |w: f64| {
            if w < 80.0 { [w, 0.0] } else { [80.0 + r * ((w - 80.0) / r).sin(), r * (1.0 - ((w - 80.0) / r).cos())] }
        }
    };
    let ways: [Box<dyn Fn(f64) -> [f64; 2]>; 5] = [
        Box::new(bend(25f64.to_radians())),
        Box::new(bend(10f64.to_radians())),
        Box::new(bend(1f64.to_radians())),
        Box::new(arc(30.0)),
        Box::new(arc(100.0)),
    ];
    for (case, way) in ways.iter().enumerate() {
        for step in [0.02, 0.1, 1.0, 5.0] {
            let count = (160.0 / step) as usize;
            let points: Vec<[f64; 2]> = (0..=count).map(|i| way(i as f64 * step)).collect();
            let taught: Vec<Joints> = points.iter().map(|[x, y]| axes([*x, *y, 50.0, 0.0, 0.0])).collect();
            let run = run(&machine, taught, 20.0, Corner::Stop, 2e-3);
            let driven: Vec<[f64; 2]> = run.rows.iter().map(|r| [r.2[0], r.2[1]]).collect();
            let away = |p: &[f64; 2], line: &[[f64; 2]]| {
                let one = |w: &[[f64; 2]]| {
                    let (d, e) = ([w[1][0] - w[0][0], w[1][1] - w[0][1]], [p[0] - w[0][0], p[1] - w[0][1]]);
                    let part = ((d[0] * e[0] + d[1] * e[1]) / (d[0] * d[0] + d[1] * d[1]).max(1e-12)).clamp(0.0, 1.0);
                    (e[0] - part * d[0]).hypot(e[1] - part * d[1])
                };
                line.windows(2).map(one).fold(f64::MAX, f64::min)
            };
            // Every point is passed within the tolerance.
            let few = points.iter().step_by((count / 160).max(1));
            let missed = few.map(|p| away(p, &driven)).fold(0.0, f64::max);
            assert!(missed < 0.0101, "case {case}, points every {step} mm: {missed}");
            // Between points the deviation is at most the rounding of a bend there.
            let off = driven.iter().step_by(7).map(|p| away(p, &points)).fold(0.0, f64::max);
            assert!(off < 0.0101 + 0.1 * step, "case {case}, points every {step} mm: {off}");
        }
    }
}

/// A walk with steps of very different lengths: some of zero, some of a nanometre, some straight back, some of one axis
/// only with the tip at rest.
fn walk(random: &mut Random, count: usize) -> Vec<Joints> {
    let mut q = axes([0.0, 0.0, 50.0, 0.0, 0.0]);
    let mut way: Joints = axes([1.0, 0.0, 0.0, 0.0, 0.0]);
    let mut points = vec![q];
    for _ in 0..count {
        let kind = random.below(10);
        let length = 10f64.powf(random.within(-3.0, 2.0)).min(5.0);
        match kind {
            0 => points.push(q),
            1 => q[0] += 1e-9,
            2 => way = way.map(|w| -w),
            3 => q[4] += 0.02 * random.unit(),
            _ => (0..3).for_each(|i| way[i] += random.within(-0.15, 0.15)),
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
    for case in 0..cases(40) {
        let points = walk(&mut Random::of_case(case), 60);
        let last = points[points.len() - 1];
        let corner = if case % 2 == 0 { Corner::Stop } else { Corner::Blend(0.05) };
        let run = run(&machine, points.clone(), 15.0, corner, 2e-3);
        assert!(run.used.iter().all(|u| *u <= 1.0 + 1e-9), "{case}: {:?}", run.used);
        let end = run.rows[run.rows.len() - 1];
        assert!(end.1 < 1.0, "{case}: {} mm/s at the end", end.1);
        assert!((0..MAX_AXES).all(|i| (end.2[i] - last[i]).abs() < 0.02), "{case}");
        // Never far from the path between the points.
        let tips: Vec<DVec3> = points.iter().map(|p| machine.forward(p).point).collect();
        let mut worst = 0.0f64;
        for (_, _, q) in run.rows.iter().step_by(7) {
            let tip = machine.forward(q).point;
            let away = |w: &[DVec3]| {
                let (d, e) = (w[1] - w[0], tip - w[0]);
                let part = (d.dot(e) / d.length_squared().max(1e-12)).clamp(0.0, 1.0);
                (e - part * d).length()
            };
            worst = worst.max(tips.windows(2).map(away).fold(f64::MAX, f64::min));
        }
        assert!(worst < 0.6, "{case}: {worst} mm from the way");
    }
}
