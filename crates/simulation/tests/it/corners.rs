//! Simulated welds round a right angle: with a stop, and blended.

use crate::common::simulated;
use glam::DVec3;
use seamwright_document::{NonNegative, Positive};
use seamwright_geometry::Pose;
use seamwright_machine::{Machine, shipped};
use seamwright_motion::WeldMotion;
use seamwright_program::{AtCorner, Pass, TorchPath};
use seamwright_simulation::{Conditions, Sample, Summary};
use seamwright_weld::Welding;

const SIDE: f64 = 60.0;
const MM: f64 = 0.3;

/// 60 mm along x, then 60 mm along y.
struct RightAngle;

impl TorchPath for RightAngle {
    fn length(&self) -> f64 {
        2.0 * SIDE
    }
    fn pose(&self, s: f64) -> Pose {
        Pose { point: DVec3::new(s.min(SIDE), (s - SIDE).max(0.0), 0.0), direction: -DVec3::Z }
    }
    fn knots(&self) -> Vec<f64> {
        vec![SIDE]
    }
}

fn weld(corner: AtCorner) -> (WeldMotion, Summary, Vec<Sample>, Pass) {
    let welding = Welding::read("job", include_str!("../../../../examples/ellipse.toml")).unwrap();
    let mut pass = welding.program.value.passes[0].clone();
    pass.corner = corner;
    pass.spans.truncate(1);
    let span = &mut pass.spans[0];
    (span.from_mm, span.to_mm) = (NonNegative::default(), Positive::new(2.0 * SIDE).unwrap());
    span.speed_mm_s = Positive::new(10.0).unwrap().into();
    let machine = Machine::read("m", shipped("ellipse-xy").unwrap().text).unwrap();
    let welded = simulated(&machine, &[(&RightAngle, &pass)], Conditions::default());
    let (motion, mut summaries, samples) = welded.unwrap();
    (motion, summaries.remove(0), samples, pass)
}

#[test]
fn a_blend_is_measured_from_the_seam_and_its_speed_along_the_blend() {
    let (motion, summary, samples, pass) = weld(AtCorner::BlendMm(Positive::new(MM).unwrap()));
    let (from, to) = motion.passes[0].path.blends()[0];
    assert!(summary.findings(&pass.tolerance, 1).is_empty(), "{summary:#?}");
    let machine = Machine::read("m", shipped("ellipse-xy").unwrap().text).unwrap();
    let mut blended = 0;
    for s in samples.iter().filter(|s| s.travels()) {
        // The distance from an angle of two straight ways, in closed form.
        let tip = machine.forward(&s.q).point;
        let first = DVec3::new((tip.x - SIDE).max(0.0), tip.y, 0.0).length();
        let second = DVec3::new(tip.x - SIDE, tip.y.min(0.0), 0.0).length();
        if s.tip_s > 1.0 && s.tip_s < 2.0 * SIDE - 1.0 {
            assert!((s.path_error - first.min(second)).abs() < 1e-6, "{s:?}");
        }
        if s.tip_s > from && s.tip_s < to {
            blended += 1;
            assert!((s.tip_speed / s.planned_speed - 1.0).abs() < 0.06, "{s:?}");
            assert!(s.planned_speed <= 10.0 * (1.0 + 1e-9) && s.planned_speed > 9.9, "{s:?}");
        }
    }
    let most = samples.iter().filter(|s| s.travels()).map(|s| s.path_error).fold(0.0, f64::max);
    let planned: Vec<String> =
        motion.findings.iter().filter(|f| f.kind == "blend").map(|f| f.message.to_string()).collect();
    assert!(blended > 50 && most > 0.05 && most < MM + 0.05, "{blended} {most} {planned:?}");
}

#[test]
fn at_a_stop_no_steady_speed_is_judged() {
    let (motion, summary, samples, pass) = weld(AtCorner::Stop);
    assert_eq!(motion.passes[0].profile.legs().len(), 2);
    assert!(summary.findings(&pass.tolerance, 1).is_empty(), "{summary:#?}");
    assert!(summary.path_error_mm.max < 0.05 && summary.tip_speed_mm_s.unwrap().min > 9.0, "{summary:#?}");
    assert!(samples.iter().any(|s| s.travels() && (s.set.profile.s - SIDE).abs() < 1e-3 && s.set.profile.v < 0.1));
}
