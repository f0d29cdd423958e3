//! Welds tracked with images of laser stripes: everything from the pixel to the slide.

use crate::acceptance::Gate;
use crate::camera_simulator::stripe::{Section, StripeDisturbances};
use crate::error::Error;
use crate::tracking::displacement::{Displacement, Part};
use crate::tracking::scenario::{HeadScene, Scenario};
use crate::tracking::scenario_run::{Method, run};
use crate::tracking::sensor_model::Sees;
use glam::DVec2;
use seamwright_machine::Machine;
use seamwright_vision::stripe::JointKind;
use std::f64::consts::TAU;

/// Length of each weld, mm.
const LENGTH: f64 = 80.0;
const SPEED: f64 = 20.0;

/// Welds a fillet and a V groove that bend by 1 mm and more, with stripe sensors: on ground steel, and beside a
/// burning arc on bright steel. Returns rows against limits.
///
/// # Errors
/// Those of [`run`].
pub fn stripe_rows(machine: &Machine) -> Result<Vec<Gate>, Error> {
    let fillet = Section::Fillet { angle: 0.25 * TAU, gap: 0.0 };
    let groove = Section::V { bevels: [30f64.to_radians(); 2], depth: 6.0, gap: 1.5, mismatch: 0.0 };
    let mut rows = Vec::new();
    for (what, section, kind) in [("fillet", fillet, JointKind::Fillet), ("V groove", groove, JointKind::V)] {
        for (light, how) in
            [("ground steel", StripeDisturbances::USUAL), ("arc, bright steel", StripeDisturbances::ROUGH)]
        {
            let wave = Part::Wave { length_mm: 90.0, size: DVec2::new(1.0, 0.5), phase: DVec2::new(0.3, 1.2) };
            let mut head = HeadScene::straight(LENGTH, Displacement::of(Part::Shift(DVec2::new(0.6, -0.3))).and(wave));
            head.sensor.period_s = 0.02;
            head.sensor.sees = Sees::Stripes(section, kind, how);
            let mut scenario = Scenario::steady("stripes", SPEED, vec![head]);
            let tracked = &run(&scenario, machine, Method::Tracked, 1)?[0];
            scenario.heads[0].sensor.sees = Sees::Offsets;
            let plain = &run(&scenario, machine, Method::Uncorrected, 1)?[0];
            let weld = format!("{what} seen by its stripe, {light} (untracked {:.3} mm)", plain.p99_mm);
            rows.push(Gate::at_most(&weld, "99 % of the weld within", tracked.p99_mm, 0.05, "mm"));
            rows.push(Gate::at_most(&weld, "not welded", (LENGTH - tracked.welded_mm).abs(), 0.1, "mm"));
        }
    }
    Ok(rows)
}
