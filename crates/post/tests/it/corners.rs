//! Part programs of welds round a right angle: straight words as near to the planned path as allowed, and a block that
//! ends where the torch stops.

use glam::DVec3;
use seamwright_document::{NonNegative, Positive};
use seamwright_geometry::Pose;
use seamwright_machine::{Machine, shipped};
use seamwright_motion::PassMotion;
use seamwright_post::{Level, linearise};
use seamwright_program::{AtCorner, TorchPath};
use seamwright_weld::Welding;

const SIDE: f64 = 40.0;
const TOLERANCE: f64 = 0.01;

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

#[test]
fn blocks_follow_the_blend_and_end_at_stops() {
    let welding = Welding::read("job", include_str!("../../../../examples/ellipse.toml")).unwrap();
    let machine = Machine::read("m", shipped("ellipse-xy").unwrap().text).unwrap();
    for corner in [AtCorner::Stop, AtCorner::BlendMm(Positive::new(0.4).unwrap())] {
        let mut pass = welding.program.value.passes[0].clone();
        pass.corner = corner;
        pass.spans.truncate(1);
        let span = &mut pass.spans[0];
        (span.from_mm, span.to_mm) = (NonNegative::default(), Positive::new(2.0 * SIDE).unwrap());
        span.speed_mm_s = Positive::new(12.0).unwrap().into();
        let motion = PassMotion::plan(&machine, &RightAngle, &pass, 1).unwrap();
        let cut = linearise(&machine, &motion, &[], Level::Joint, TOLERANCE).unwrap();
        let ends: Vec<DVec3> = std::iter::once(&cut.start).chain(&cut.blocks).map(|b| b.tip).collect();
        let off = |p: DVec3| {
            let chord = |w: &[DVec3]| {
                let along = (w[1] - w[0]).dot(p - w[0]) / (w[1] - w[0]).length_squared();
                p.distance(w[0].lerp(w[1], along.clamp(0.0, 1.0)))
            };
            ends.windows(2).map(chord).fold(f64::INFINITY, f64::min)
        };
        for k in 0..=8000 {
            let s = 2.0 * SIDE * f64::from(k) / 8000.0;
            let away = off(machine.forward(&motion.path.at(s)).point);
            assert!(away <= TOLERANCE, "{corner:?}: {away} at {s}");
        }
        let time: f64 = cut.blocks.iter().map(|b| b.duration).sum();
        assert!((time - motion.profile.duration()).abs() < 1e-9);
        let stops = cut.blocks.iter().any(|b| b.stops && (b.s - SIDE).abs() < 1e-9);
        assert_eq!(cut.blocks.iter().filter(|b| b.stops).count(), usize::from(stops));
        assert_eq!(stops, corner == AtCorner::Stop);
        assert!(off(DVec3::new(SIDE, 0.0, 0.0)) > 0.05 || stops);
    }
}
