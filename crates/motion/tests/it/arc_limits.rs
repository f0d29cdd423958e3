//! Requirements of the process while the arc is on, verified by walking along the set-points.

use crate::corners::route::{Part, Route};
use crate::planning::{one_span, shipped_machine};
use crate::{number, positive};
use glam::DVec3;
use seamwright_motion::PassMotion;
use seamwright_program::{Finding, Pass, TorchPath};
use std::f64::consts::{FRAC_PI_2, TAU};

const RADIUS: f64 = 100.0;

/// An arc about the origin that begins along y.
fn arc(length: f64) -> Route {
    Route::new(DVec3::X * RADIUS, vec![Part { turn: FRAC_PI_2, ..Part::arc(length, 1.0 / RADIUS) }])
}

fn pass(length: f64, speed: f64, least: Option<f64>) -> Pass {
    Pass { least_speed_mm_s: least.map(positive), ..one_span(length, speed) }
}

fn findings(plan: Result<PassMotion, Vec<Finding>>, kind: &str) -> Vec<Finding> {
    let all = plan.map_or_else(|findings| findings, |motion| motion.findings);
    all.into_iter().filter(|f| f.kind == kind).collect()
}

/// Stretches of the set-points slower than `least`, as (from, to, minimum speed).
fn slow(points: &[(f64, f64)], least: f64) -> Vec<(f64, f64, f64)> {
    let mut runs: Vec<(f64, f64, f64)> = Vec::new();
    let mut open = false;
    for &(s, v) in points {
        match runs.last_mut().filter(|_| open) {
            Some(run) if v < least => *run = (run.0, s, run.2.min(v)),
            None if v < least => runs.push((s, s, v)),
            _ => {}
        }
        open = v < least;
    }
    runs
}

#[test]
fn stretches_below_the_least_speed_are_those_of_the_set_points() {
    let (machine, circle) = (shipped_machine("ellipse-xy"), arc(TAU * RADIUS));
    let (length, speed, period) = (circle.length(), 130.0, 2e-4);
    let motion = PassMotion::plan(&machine, &circle, &pass(length, speed, None), 1).unwrap();
    let welding = motion.set_points(period).filter(|p| p.phase.arc());
    let points: Vec<(f64, f64)> = welding.map(|p| (p.profile.s, p.profile.v)).collect();
    let mut seen = 0;
    for least in (0..30).map(|i| 99.0 + f64::from(i)) {
        let plan = PassMotion::plan(&machine, &circle, &pass(length, speed, Some(least)), 1);
        let found = findings(plan, "least_speed");
        let wanted = slow(&points, least);
        assert!(found.iter().all(|f| f.allowed == (f.from_mm <= 0.0 || f.to_mm >= length)), "{least}: {found:#?}");
        let mut found: Vec<(f64, f64)> = found.iter().map(|f| (f.from_mm, f.to_mm)).collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        // A slow stretch that contains the end of the acceleration or deceleration phase is reported in two parts.
        let (mut joined, gap) = (Vec::<(f64, f64)>::new(), speed * period);
        for part in found {
            match joined.last_mut().filter(|last| part.0 - last.1 < gap) {
                Some(last) => last.1 = part.1,
                None => joined.push(part),
            }
        }
        assert_eq!(joined.len(), wanted.len(), "{least}: {joined:?} {wanted:?}");
        for (found, wanted) in joined.iter().zip(&wanted) {
            assert!(
                (found.0 - wanted.0).abs() < gap && (found.1 - wanted.1).abs() < gap,
                "{least} {found:?} {wanted:?}"
            );
        }
        seen += wanted.len() - 2;
    }
    assert!(seen > 40, "{seen}");
}

#[test]
fn the_slowest_place_and_what_binds_there_are_told() {
    let (machine, circle) = (shipped_machine("ellipse-xy"), arc(TAU * RADIUS));
    let plan = PassMotion::plan(&machine, &circle, &pass(circle.length(), 130.0, Some(110.0)), 1);
    let found: Vec<Finding> = findings(plan, "least_speed").into_iter().filter(|f| !f.allowed).collect();
    // At a tangent along an axis that axis alone has the tip's speed: 100 mm/s.
    for f in &found {
        let middle = 0.5 * (f.from_mm + f.to_mm) / RADIUS;
        let axis = if middle.cos().abs() > middle.sin().abs() { "axis y" } else { "axis x" };
        assert!(f.message.code == "motion-least-speed-axis" && f.message.to_string().contains(axis), "{f:#?}");
        assert!((number(&f.message, "value") - 100.0).abs() < 1e-9, "{f:#?}");
    }
    assert!(found.len() >= 3, "{found:#?}");
}

#[test]
fn a_stop_with_the_arc_on_is_a_finding() {
    let stops = |path: &Route| {
        let machine = shipped_machine("ellipse-xy");
        findings(PassMotion::plan(&machine, path, &pass(path.length(), 40.0, None), 1), "stop")
    };
    // The acceleration of an axis jumps by v^2 / r where the line ends.
    let line_and_arc = vec![Part::line(90.0, 80.0), Part::arc(150.0, 1.0 / RADIUS)];
    let bent = stops(&Route::new(DVec3::new(RADIUS, -80.0, 0.0), line_and_arc));
    assert_eq!(bent.len(), 1, "{bent:#?}");
    assert!(
        !bent[0].allowed
            && bent[0].message.to_string().contains("axis x")
            && bent[0].message.to_string().contains("80.000 mm")
    );
    assert!((bent[0].from_mm - 80.0).abs() < 1e-6 && (bent[0].to_mm - 80.0).abs() < 1e-6);
    assert!(stops(&arc(150.0)).is_empty());
}
