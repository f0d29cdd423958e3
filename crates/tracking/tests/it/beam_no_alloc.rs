//! Cycles and pictures of beam mode do not allocate.

use glam::{DVec2, DVec3};
use seamwright_machine::{AxisLimits, BeamDeflection};
use seamwright_testkit::no_alloc;
use seamwright_tracking::actuator::SlideLimits;
use seamwright_tracking::beam::{
    Beam, BeamReplay, BeamTracking, Picture, Point, Recorder, Replay, ReplaySettings, Settings,
};
use seamwright_tracking::lead::{Moment, SeamFrame};
use std::hint::black_box;

fn straight(s: f64) -> SeamFrame {
    SeamFrame { point: DVec3::X * s, along: DVec3::X, lateral: DVec3::Y, height: DVec3::Z }
}

fn points(s: f64, carried: f64) -> [Point; 40] {
    std::array::from_fn(|k| {
        let along_mm = k as f64 - 16.0;
        Point { along_mm, lateral_mm: 2.0 * (0.05 * (s + along_mm)).sin() - carried, confidence: 0.9 }
    })
}

#[test]
fn cycles_and_pictures_do_not_allocate() {
    let beam = BeamDeflection { range_mm: 1.0, speed: 2000.0, latency_s: 75e-6, pivot_mm: 400.0 };
    let axes = SlideLimits { stroke_mm: 5.0, motion: AxisLimits { speed: 5.0, acceleration: 30.0, jerk: 300.0 } };
    let mut head = BeamTracking::new(Settings::usual(10.0), &straight, beam, axes).unwrap();
    let mut recorder = Recorder::new(250.0, 0.5, 0.03);
    let mut carried = 0.0;
    no_alloc(|| {
        for i in 0..20_000 {
            let (t, s) = (1e-3 * f64::from(i), 1e-2 * f64::from(i));
            let orders = black_box(head.cycle(Moment { t_s: t, s_mm: s, slide: DVec2::new(carried, 0.0) }, 10.0, true));
            if let Beam::Seen(exposed_s) = orders.beam {
                let points = points(s, carried);
                black_box(head.take(&Picture { exposed_s, height_mm: 0.0, points: &points }, t));
            }
            recorder.add(s, &orders.estimate);
            carried = orders.carried_mm;
        }
    });
    let replay = Replay::new(recorder.finish().unwrap(), 0.0, 190.0, 0.03).unwrap();
    let mut head = BeamReplay::new(ReplaySettings::USUAL, replay, &straight, beam, axes).unwrap();
    no_alloc(|| {
        for i in 0..5000 {
            let (t, s) = (1e-3 * f64::from(i), 1e-2 * f64::from(i));
            let orders = black_box(head.cycle(Moment { t_s: t, s_mm: s, slide: DVec2::new(carried, 0.0) }, 10.0));
            if let Beam::Seen(exposed_s) = orders.beam {
                let points = points(s, carried);
                head.take(&Picture { exposed_s, height_mm: 0.0, points: &points }, t);
            }
            carried = orders.carried_mm;
        }
    });
    assert!(head.judged().is_some());
}
