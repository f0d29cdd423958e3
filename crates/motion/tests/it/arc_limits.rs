//! Requirements of the process while the arc is on, verified by walking along the set-points.

use crate::number;
use crate::planning::{read, shipped_machine};
use glam::DVec3;
use seamwright_document::{NonNegative, Positive};
use seamwright_geometry::Pose;
use seamwright_motion::PassMotion;
use seamwright_program::{Finding, OnLimit, Pass, TorchPath};

const RADIUS: f64 = 100.0;

/// A straight line along y tangent to an arc, or a full circle without the line.
struct LineAndArc {
    line: f64,
    arc: f64,
}

impl TorchPath for LineAndArc {
    fn length(&self) -> f64 {
        self.line + self.arc
    }
    fn pose(&self, s: f64) -> Pose {
        let point = match s < self.line {
            true => DVec3::new(RADIUS, s - self.line, 0.0),
            false => {
                let (sin, cos) = ((s - self.line) / RADIUS).sin_cos();
                RADIUS * DVec3::new(cos, sin, 0.0)
            }
        };
        Pose { point, direction: -DVec3::Z }
    }
    fn knots(&self) -> Vec<f64> {
        if self.line > 0.0 { vec![self.line] } else { Vec::new() }
    }
}

/// One span at `speed`, slowed down where an axis needs it.
fn pass(length: f64, speed: f64, least: Option<f64>) -> Pass {
    let welding = read(include_str!("../../../../examples/ellipse.toml"));
    let mut pass = welding.program.value.passes[0].clone();
    pass.on_limit = OnLimit::Slow;
    pass.least_speed_mm_s = least.map(|v| Positive::new(v).unwrap());
    pass.spans.truncate(1);
    let span = &mut pass.spans[0];
    (span.from_mm, span.to_mm) = (NonNegative::new(0.0).unwrap(), Positive::new(length).unwrap());
    span.speed_mm_s = Positive::new(speed).unwrap().into();
    pass
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
    let (machine, circle) =
        (shipped_machine("ellipse-xy"), LineAndArc { line: 0.0, arc: 2.0 * std::f64::consts::PI * RADIUS });
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
    let (machine, circle) =
        (shipped_machine("ellipse-xy"), LineAndArc { line: 0.0, arc: 2.0 * std::f64::consts::PI * RADIUS });
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
    // The acceleration of an axis jumps by v^2 / r where the line ends.
    let path = LineAndArc { line: 80.0, arc: 150.0 };
    let bent =
        findings(PassMotion::plan(&shipped_machine("ellipse-xy"), &path, &pass(path.length(), 40.0, None), 1), "stop");
    assert_eq!(bent.len(), 1, "{bent:#?}");
    assert!(
        !bent[0].allowed
            && bent[0].message.to_string().contains("axis x")
            && bent[0].message.to_string().contains("80.000 mm")
    );
    assert!((bent[0].from_mm - 80.0).abs() < 1e-6 && (bent[0].to_mm - 80.0).abs() < 1e-6);
    let smooth = LineAndArc { line: 0.0, arc: 150.0 };
    assert!(
        findings(PassMotion::plan(&shipped_machine("ellipse-xy"), &smooth, &pass(150.0, 40.0, None), 1), "stop")
            .is_empty()
    );
}
