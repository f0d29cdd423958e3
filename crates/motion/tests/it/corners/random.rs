//! Random corners on three machines.

use super::route::{Part, Route};
use super::{blend, of_kind, pass, plan};
use crate::planning::shipped_machine;
use glam::DVec3;
use seamwright_machine::{AxisKind, AxisLimits, Joints, Machine};
use seamwright_motion::speed_profile::Bound;
use seamwright_motion::{PassMotion, SetPoint};
use seamwright_program::{AtCorner, TorchPath};
use seamwright_testkit::{Random, cases};

const PERIOD: f64 = 1e-3;

/// Lines and arcs with turns, or tangent to each other; the torch leans if the machine can.
fn route(random: &mut Random, leans: Option<[f64; 2]>, at: DVec3) -> Route {
    let count = 2 + (3.0 * random.unit()) as usize;
    let mut lean = [0.0; 2];
    let parts = (0..count).map(|i| {
        let length = random.within(3.0, 40.0);
        let turn = match random.unit() {
            _ if i == 0 => 0.0,
            x if x < 0.25 => 0.0,
            _ => random.within(-140.0, 140.0).to_radians(),
        };
        let curvature = if random.unit() < 0.5 { 0.0 } else { random.within(-0.04, 0.04) };
        if leans.is_some() && random.unit() < 0.6 {
            lean = [0, 1].map(|_| random.within(-2e-3, 2e-3));
        }
        Part { turn, length, curvature, lean }
    });
    Route::leaning(at, leans.unwrap_or_default(), parts.collect())
}

struct Case {
    machine: Machine,
    route: Route,
    speed: f64,
    mm: f64,
    motion: PassMotion,
    stopping: PassMotion,
}

#[test]
fn random_corners_are_smooth_near_to_the_seam_and_within_all_limits() {
    let machines = ["ellipse-xy", "torch-5axis", "table-tilting-xyzac"].map(|name| (shipped_machine(name), name));
    let (mut blends, mut wide, mut cruised) = (0, 0, 0);
    let (mut faster, mut cornered) = (0, 0);
    for seed in 0..cases(150) {
        let mut random = Random::of_case(seed);
        let (machine, name) = &machines[(seed % 3) as usize];
        let (leans, at) = match *name {
            "ellipse-xy" => (None, DVec3::ZERO),
            "torch-5axis" => (Some([0.0; 2]), DVec3::new(0.0, 0.0, 300.0)),
            // Not near the upright torch, where the table is singular.
            _ => (Some([0.6, 0.3]), DVec3::new(20.0, 30.0, 40.0)),
        };
        let route = route(&mut random, leans, at);
        let (speed, mm) = (random.within(3.0, 30.0), random.within(0.02, 0.5));
        let what = format!("seed {seed}, {name}");
        let motion = plan(machine, &route, speed, blend(mm)).unwrap_or_else(|f| panic!("{what}: {f:#?}"));
        let stopping = plan(machine, &route, speed, AtCorner::Stop).unwrap_or_else(|f| panic!("{what}: {f:#?}"));
        let case = Case { machine: machine.clone(), route, speed, mm, motion, stopping };
        assert_eq!(case.motion.path.blends().len() + 1, case.stopping.profile.legs().len(), "{what}");
        faster += usize::from(case.motion.profile.duration() < case.stopping.profile.duration());
        cornered += usize::from(case.stopping.profile.legs().len() > 1);
        assert!(case.motion.profile.legs().len() == 1 && of_kind(&case.motion.findings, "stop").is_empty(), "{what}");
        smooth(&case, &what);
        (blends, wide) = (blends + case.motion.path.blends().len(), wide + near(&case, &what));
        untouched(&case, &what);
        cruised += in_time(&case, &what);
    }
    assert!(blends > 200 && wide * 2 < blends && cruised > 10_000, "{blends} {wide} {cruised}");
    assert!(faster as f64 > 0.98 * cornered as f64, "{faster} of {cornered}");
}

/// Positions and two derivatives are continuous at both ends of a blend, and the derivatives match differences of the
/// positions.
fn smooth(case: &Case, what: &str) {
    let path = &case.motion.path;
    for &(from, to) in path.blends() {
        let half = 0.5 * (to - from);
        for s in [from, to] {
            let (a, b) = (path.point(s, true), path.point(s, false));
            for i in 0..case.machine.axes.len() {
                let scale = 1.0 + a.d1[i].abs();
                assert!((a.q[i] - b.q[i]).abs() < 1e-10, "{what}: axis {i} at {s}");
                assert!((a.d1[i] - b.d1[i]).abs() < 1e-8 * scale, "{what}: axis {i} at {s}");
                assert!((a.d2[i] - b.d2[i]).abs() < 1e-5 * scale / half.min(1.0), "{what}: axis {i} at {s}");
            }
            // From outside in: the cubic through four positions on each side has the same slope at the join.
            let h = 0.02 * half;
            let slope = |side: f64| -> Joints {
                let q = [0.0, 1.0, 2.0, 3.0].map(|k| path.at((s + side * k * h).clamp(0.0, path.length())));
                std::array::from_fn(|i| {
                    side * (-11.0 * q[0][i] + 18.0 * q[1][i] - 9.0 * q[2][i] + 2.0 * q[3][i]) / (6.0 * h)
                })
            };
            let (before, after) = (slope(-1.0), slope(1.0));
            for i in 0..case.machine.axes.len() {
                let off = (before[i] - after[i]).abs();
                assert!(
                    off < 2e-3 * (1.0 + a.d1[i].abs()) && (before[i] - a.d1[i]).abs() < 2e-3 * (1.0 + a.d1[i].abs()),
                    "{what}: axis {i} at {s}: {} {} {}",
                    before[i],
                    after[i],
                    a.d1[i]
                );
            }
        }
    }
}

/// The tip stays within its distance from the seam everywhere, by brute force; blends are as wide as possible.
fn near(case: &Case, what: &str) -> usize {
    let Case { machine, route, mm, motion, .. } = case;
    let mut wide = 0;
    for (&(from, to), corner) in motion.path.blends().iter().zip(&case.stopping.profile.legs()[1..]) {
        let exact: Vec<DVec3> = (0..=1200)
            .map(|k| from - (to - from) + 3.0 * (to - from) * f64::from(k) / 1200.0)
            .map(|s| route.pose(s.clamp(0.0, route.length())).point)
            .collect();
        let off = |s: f64| {
            let tip = machine.forward(&motion.path.at(s)).point;
            exact.windows(2).map(|w| from_chord(tip, w[0], w[1])).fold(f64::INFINITY, f64::min)
        };
        let most = (0..=80).map(|k| off(from + (to - from) * f64::from(k) / 80.0)).fold(0.0, f64::max);
        assert!(most <= *mm, "{what}: {most} of {mm} at {from}");
        let bent = (0..=120).map(|k| from + (to - from) * f64::from(k) / 120.0);
        let turned = bent.map(|s| {
            let torch = machine.forward(&motion.path.at(s));
            let asked = route.pose(s).direction;
            torch.direction.angle_between(asked).to_degrees()
        });
        let turned = turned.fold(0.0, f64::max);
        assert!(turned < 10.1, "{what}: {turned}");
        // As wide as possible: up to the tolerance, or to half the distance to the next corner or end.
        let places: Vec<f64> = std::iter::once(0.0)
            .chain(case.stopping.profile.legs()[1..].iter().map(|l| l.from))
            .chain(std::iter::once(route.length()))
            .collect();
        let i = places.iter().position(|s| (s - corner.from).abs() < 1e-9).unwrap();
        let room = 0.5 * (places[i] - places[i - 1]).min(places[i + 1] - places[i]);
        let full = (0.5 * (to - from) - room).abs() < 1e-9;
        if let Some(used) = used_at_constant_speed(case, from, to).filter(|_| !full && most < 0.97 * mm && turned < 9.0)
        {
            assert!((0.8..0.92).contains(&used), "{what}: {used} of the limits, {most} of {mm}, {from} {to}");
        }
        wide += usize::from(full);
    }
    wide
}

/// Maximum use of a limit by an axis if the tip passes a blend between two stations at constant requested speed, by
/// differences; none if these would be rounding.
fn used_at_constant_speed(case: &Case, from: f64, to: f64) -> Option<f64> {
    let Case { machine, motion, speed, .. } = case;
    let tip = |s: f64| machine.forward(&motion.path.at(s)).point;
    let (mut rows, mut s, period) = (Vec::new(), from, (to - from) / speed / 150.0);
    while s < to {
        rows.push(motion.path.at(s));
        // The station one period later, by the length of the chord.
        let way = period * speed;
        let mut step = way;
        for _ in 0..20 {
            step *= way / tip(s + step).distance(tip(s));
        }
        s += step;
    }
    let used = machine.axes.iter().enumerate().map(|(i, axis)| {
        let mut row: Vec<f64> = rows.iter().map(|q| q[i]).collect();
        let AxisLimits { speed, acceleration, jerk } = axis.limits();
        [speed, acceleration, jerk].into_iter().fold(0.0, |used: f64, limit| {
            row = row.windows(2).map(|w| (w[1] - w[0]) / period).collect();
            row.iter().fold(used, |u, v| u.max(v.abs() / limit))
        })
    });
    (period > 5e-5).then(|| used.fold(0.0, f64::max))
}

fn from_chord(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let along = (b - a).dot(p - a) / (b - a).length_squared().max(1e-300);
    p.distance(a.lerp(b, along.clamp(0.0, 1.0)))
}

fn untouched(case: &Case, what: &str) {
    let (path, exact) = (&case.motion.path, &case.stopping.path);
    assert!((path.length() - exact.length()).abs() < 1e-12);
    for k in 0..=2000 {
        let s = path.length() * f64::from(k) / 2000.0;
        if path.blends().iter().any(|b| b.0 < s && s < b.1) {
            continue;
        }
        let (a, b) = (path.at(s), exact.at(s));
        for (i, axis) in case.machine.axes.iter().enumerate() {
            let least = if axis.kind == AxisKind::Linear { 1e-10 } else { 1e-12 };
            assert!((a[i] - b[i]).abs() < least, "{what}: axis {} at {s}: {} {}", axis.name, a[i], b[i]);
        }
    }
}

/// Speed of the tip and limits of the axes by differences of the set-points.
fn in_time(case: &Case, what: &str) -> usize {
    let Case { machine, route, speed, motion, stopping, .. } = case;
    // Hundredths of a millimetre at a high speed leave so little room that a stop, whose jerks do not overlap, may win
    // by some milliseconds.
    assert!(motion.profile.duration() < stopping.profile.duration() + 0.01, "{what}");
    let sets: Vec<SetPoint> = motion.set_points(PERIOD).collect();
    let asked =
        |s: f64| motion.certificate.intervals.iter().any(|i| i.bound == Bound::Asked && i.from <= s && s <= i.to);
    let blended = |s: f64| motion.path.blends().iter().any(|b| b.0 <= s && s <= b.1);
    let mut cruised = 0;
    for w in sets.windows(2) {
        let way = machine.forward(&w[1].q).point.distance(machine.forward(&w[0].q).point);
        assert!(way / PERIOD <= speed * (1.0 + 1e-8), "{what}: {} at {}", way / PERIOD, w[0].profile.s);
        let told = motion.tip_speed(machine, w[0].profile).max(motion.tip_speed(machine, w[1].profile));
        assert!(told <= speed * (1.0 + 1e-9), "{what}: told {told}");
        let straight = route.part(w[0].profile.s).curvature == 0.0 && route.part(w[1].profile.s).curvature == 0.0;
        if w.iter().all(|p| asked(p.profile.s) && !blended(p.profile.s)) && straight {
            assert!((way / PERIOD / speed - 1.0).abs() < 1e-6, "{what}: {} at {}", way / PERIOD, w[0].profile.s);
            cruised += 1;
        } else if way / PERIOD > 0.1 * speed {
            // The reported speed is the tip's own, also in blends.
            let mean = 0.5 * (motion.tip_speed(machine, w[0].profile) + motion.tip_speed(machine, w[1].profile));
            assert!((way / PERIOD / mean - 1.0).abs() < 0.02, "{what}: {} {mean} at {}", way / PERIOD, w[0].profile.s);
        }
    }
    for (i, axis) in machine.axes.iter().enumerate() {
        let mut row: Vec<f64> = sets.iter().map(|p| p.q[i]).collect();
        let limits = axis.limits();
        for (order, limit) in [limits.speed, limits.acceleration, limits.jerk].into_iter().enumerate() {
            row = row.windows(2).map(|w| (w[1] - w[0]) / PERIOD).collect();
            let most = row.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let rounding = 1e-12 / PERIOD.powi(order as i32 + 1);
            assert!(most <= limit + rounding, "{what}: axis {} order {order}: {most} of {limit}", axis.name);
        }
    }
    assert!(motion.certificate.uses.iter().all(|u| u.speed <= 1.0 && u.acceleration <= 1.0 && u.jerk <= 1.0), "{what}");
    cruised
}

#[test]
fn limits_of_the_tip_hold_in_blends_too() {
    let mut machine = shipped_machine("torch-5axis");
    machine.tip = seamwright_machine::AxisLimits { speed: 25.0, acceleration: 60.0, jerk: 500.0 };
    for seed in 0..cases(10) {
        let mut random = Random::of_case(1000 + seed);
        let route = route(&mut random, Some([0.0; 2]), DVec3::new(0.0, 0.0, 300.0));
        let motion = PassMotion::plan(&machine, &route, &pass(route.length(), 30.0, blend(0.3)), 1).unwrap();
        let tips: Vec<DVec3> = motion.set_points(PERIOD).map(|p| machine.forward(&p.q).point).collect();
        let slope = |v: &[DVec3]| -> Vec<DVec3> { v.windows(2).map(|w| (w[1] - w[0]) / PERIOD).collect() };
        let most = |v: &[DVec3]| v.iter().map(|v| v.length()).fold(0.0, f64::max);
        let speeds = slope(&tips);
        let accelerations = slope(&speeds);
        assert!(most(&speeds) <= 25.0 && most(&accelerations) <= 60.0, "{} {}", most(&speeds), most(&accelerations));
    }
}
