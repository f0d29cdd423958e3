//! Simulated welding with tracking: quick versions of the tests that `seamwright tools bench tracking` runs in full.

use crate::common::soak;
use glam::DVec2;
use seamwright_machine::{Machine, shipped};
use seamwright_simulation::tracking::acceptance::{
    fault_rows, misplaced_rows, scenarios, t_joint_rows, tracking_gates,
};
use seamwright_simulation::tracking::{Displacement, HeadScene, Method, Part, Scenario, run};
use seamwright_weld::Welding;

fn machine() -> Machine {
    Machine::read("machine", shipped("dual-laser-10axis").unwrap().text).unwrap()
}

/// Acceptance tests: one at each speed, both heads, and the papers' algorithms worse.
#[test]
fn fast_and_slow() {
    let machine = machine();
    for (speed, name, limit) in [(20.0, "sine of 0.5 mm, 2 Hz", 0.05), (100.0, "step of 1 mm", 0.1)] {
        let scenario = scenarios(speed, 0).into_iter().find(|s| s.name == name).unwrap();
        let tracked = run(&scenario, &machine, Method::Tracked, 0).unwrap();
        let papers = [Method::OneStep, Method::Subdivided].map(|m| run(&scenario, &machine, m, 0).unwrap());
        for head in 0..2 {
            assert!(tracked[head].p99_mm < limit, "{name}: {}", tracked[head].p99_mm);
            assert!(papers.iter().all(|p| p[head].p99_mm > tracked[head].p99_mm));
            assert!(tracked[head].used.iter().all(|u| *u <= 1.0 + 1e-6), "{:?}", tracked[head].used);
            assert!((tracked[head].welded_mm - 800.0).abs() < 0.1 && tracked[head].stopped_mm.is_none());
        }
    }
}

/// Displacement of one seam does not affect the other head.
#[test]
fn no_cross_talk() {
    let quiet = Displacement::of(Part::Shift(DVec2::new(0.3, 0.2)));
    let wave = Part::Wave { length_mm: 60.0, size: DVec2::new(2.0, 1.0), phase: DVec2::ZERO };
    let weld = |other: Displacement| {
        let heads = vec![HeadScene::straight(200.0, other), HeadScene::straight(200.0, quiet.clone())];
        run(&Scenario::steady("two", 20.0, heads), &machine(), Method::Tracked, 3).unwrap()
    };
    let (still, moving) = (weld(quiet.clone()), weld(Displacement::of(wave)));
    assert!(still[0].places != moving[0].places);
    assert_eq!(still[1], moving[1]);
}

/// Every scenario of the acceptance tests at 100 mm/s, or all of them: each head within its limit, never stopped, all
/// limits of the slides kept.
#[test]
fn every_gate() {
    let machine = machine();
    if let Some(soak) = soak() {
        for row in tracking_gates(&machine, 24.min(soak), || {}).unwrap() {
            assert!(row.is_kept(), "{row:?}");
        }
    }
    for scenario in scenarios(100.0, 1) {
        for (head, weld) in run(&scenario, &machine, Method::Tracked, 1).unwrap().iter().enumerate() {
            let name = format!("{}, head {head}", scenario.name);
            assert!(weld.p99_mm < 0.1 && weld.stopped_mm.is_none(), "{name}: {} {:?}", weld.p99_mm, weld.alarm);
            assert!(weld.used.iter().all(|used| *used <= 1.0 + 1e-6), "{name}: {:?}", weld.used);
        }
    }
}

/// Every fault: the seam's own course explains the miss, the alarm names the cause, the weld is stopped, and no axis
/// oscillates.
#[test]
fn every_fault() {
    for row in fault_rows(&machine(), soak().map_or(5, |soak| 30.min(5 * soak))).unwrap() {
        assert!(row.is_kept(), "{row:?}");
    }
}

#[test]
fn whole_parts() {
    let machine = machine();
    let welding = Welding::read("saddle", include_str!("../../../../examples/saddle.toml")).unwrap();
    let saddle = misplaced_rows("saddle", &welding.path(0), &machine).unwrap();
    for row in t_joint_rows(&machine).unwrap().iter().chain(&saddle) {
        assert!(row.is_kept(), "{row:?}");
    }
}
