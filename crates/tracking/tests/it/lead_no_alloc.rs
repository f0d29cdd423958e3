//! Tracking does not allocate on measurements, gaps, jumps, holds and reversing.

use glam::DVec2;
use seamwright_machine::AxisLimits;
use seamwright_testkit::no_alloc;
use seamwright_tracking::actuator::{HeadTracking, SlideLimits};
use seamwright_tracking::lead::{Measurement, Moment, OwnCurve, Settings};
use std::hint::black_box;

#[test]
fn cycles_do_not_allocate() {
    let limits =
        SlideLimits { stroke_mm: 15.0, motion: AxisLimits { speed: 50.0, acceleration: 1000.0, jerk: 20_000.0 } };
    let mut head = HeadTracking::new(Settings::usual(20.0, 100.0), OwnCurve::straight(20.0), [limits; 2]).unwrap();
    let (mut s, mut slide) = (-25.0f64, DVec2::ZERO);
    no_alloc(|| {
        for i in 0..20_000 {
            let t = 1e-3 * f64::from(i);
            let speed = if i % 6000 < 4000 { 50.0 } else { -30.0 };
            s += 1e-3 * speed;
            if i % 10 == 0 && i % 3000 > 800 {
                let jump = if (s / 40.0).floor() % 2.0 == 0.0 { 1.0 } else { 0.0 };
                let offset = DVec2::new((0.1 * s).sin() + jump, 0.3) - slide;
                black_box(head.take(&Measurement { exposed_s: t - 0.015, offset, confidence: 0.9 }, t));
            }
            slide = head.cycle(Moment { t_s: t, s_mm: s, slide }, speed).slide;
        }
    });
}
