//! Single welds that tracking must get through: faults, a long T-joint, a saddle out of place. Rows against limits.

use super::Error;
use super::gates::SPEEDS;
use super::scenario::opposite;
use super::{Displacement, Fault, HeadScene, Method, Outcome, Part, Placement, Scenario, Seam, run};
use crate::gate::{Gate, Limit};
use glam::{DQuat, DVec2, DVec3};
use seamwright_machine::Machine;
use seamwright_program::TorchPath;
use seamwright_tracking::lead::Settings;
use std::f64::consts::TAU;

const LENGTH: f64 = 600.0;
/// Where faults begin, mm.
const THERE: f64 = 300.0;
/// Way in which the torch comes to rest, mm: 100 mm/s at 1000 mm/s^2, and a cycle or two.
const BRAKING: f64 = 6.0;
/// Drive and noise, mm.
const SLACK: f64 = 0.1;

fn gate(frames: &str, what: &'static str, value: f64, limit: f64, unit: &'static str) -> Gate {
    Gate { frames: frames.to_owned(), what, value, limit: Limit::Most(limit), unit }
}

/// Sensors and slides that fail half-way, at both speeds: how far the weld strays at most, against what it would
/// without any correction or 1 mm, where the alarm comes, and where the torch has been stopped.
///
/// # Errors
/// Those of [`run`].
pub fn fault_rows(machine: &Machine) -> Result<Vec<Gate>, Error> {
    let faults: [(&str, Option<Fault>); 6] = [
        ("sensor silent", Some(Fault::Silent)),
        ("sensor frozen", Some(Fault::Frozen)),
        ("sensor wild", Some(Fault::Wild)),
        ("sensor late by 3 periods", Some(Fault::Late(0.03))),
        ("sensor's clock jumps by 0.5 s", Some(Fault::ClockStep(0.5))),
        ("slide stuck", None),
    ];
    let mut rows = Vec::new();
    for (speed, _) in SPEEDS {
        for (name, fault) in faults {
            let scenario = faulty(speed, fault);
            let tracked = &run(&scenario, machine, Method::Tracked, 1)?[0];
            let plain = &run(&scenario, machine, Method::Uncorrected, 1)?[0];
            let settings = Settings::usual(20.0, speed);
            // A stuck slide is noticed by how far it is off: that is the way of the seam.
            let until = match fault {
                Some(_) => settings.lead_mm + settings.coast_mm() + settings.fade_mm,
                None => LENGTH - THERE - BRAKING,
            };
            let weld = format!("{speed} mm/s, {name}");
            let most = (1e3 * (plain.most_mm.max(1.0) + SLACK)).round() / 1e3;
            rows.push(gate(&weld, "greatest miss", tracked.most_mm, most, "mm"));
            rows.push(gate(&weld, "first alarm, after", after(tracked.alarm_mm), until, "mm"));
            rows.push(gate(&weld, "at rest, after", after(tracked.stopped_mm), until + BRAKING, "mm"));
            let used = tracked.used.into_iter().fold(0.0, f64::max);
            rows.push(gate(&weld, "of the slide's limits", 100.0 * used, 100.001, "%"));
        }
    }
    Ok(rows)
}

fn after(place: Option<f64>) -> f64 {
    place.map_or(f64::INFINITY, |at| at - THERE)
}

fn faulty(speed: f64, fault: Option<Fault>) -> Scenario {
    let wave = Part::Wave { length_mm: 350.0, size: DVec2::new(1.2, 0.6), phase: DVec2::new(0.4, 1.0) };
    let mut head = HeadScene::straight(LENGTH, Displacement::of(Part::Shift(DVec2::new(0.5, -0.4))).and(wave));
    head.sensor.fault = fault.map(|fault| (THERE, fault));
    head.stuck_mm = fault.is_none().then_some(THERE);
    Scenario::steady("fault", speed, vec![head])
}

/// A T-joint of 3 m on a skin of 3 m radius whose fillets drift apart by 4 mm, both tracked at 20 mm/s.
///
/// # Errors
/// Those of [`run`].
pub fn t_joint_rows(machine: &Machine) -> Result<Vec<Gate>, Error> {
    let length = 3000.0;
    let drift = Part::Ramp { from_mm: 0.0, to_mm: length, by: DVec2::new(2.0, 0.5) };
    let sag = Part::Sag { from_mm: 0.0, to_mm: length, by_mm: 0.8 };
    let displacements = opposite(&Displacement::of(drift).and(sag));
    let heads = displacements.map(|d| HeadScene::on(Seam::arc(length, -3000.0, true), d)).into_iter().collect();
    let scenario = Scenario::steady("T-joint", 20.0, heads);
    rows_of("T-joint of 3 m, fillets drift apart by 4 mm", &scenario, machine)
}

/// A seam in space whose part is misplaced by 2 mm and turned by 0.5 degrees, 1 mm out of round, at 20 mm/s.
///
/// # Errors
/// Those of [`run`].
pub fn misplaced_rows(name: &str, path: &dyn TorchPath, machine: &Machine) -> Result<Vec<Gate>, Error> {
    let seam = Seam::along(path);
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -1.0).normalize(), 0.5f64.to_radians());
    let places = 64;
    let middle = (0..places).map(|i| (seam.frame)(seam.length_mm * f64::from(i) / f64::from(places)).point);
    let about = middle.sum::<DVec3>() / f64::from(places);
    let oval =
        Part::Wave { length_mm: seam.length_mm / 2.0, size: DVec2::new(0.5, 0.0), phase: DVec2::splat(TAU / 8.0) };
    let mut head = HeadScene::on(seam, Displacement::of(oval));
    let shift = 2.0 * DVec3::new(1.0, -1.0, 1.0).normalize();
    head.placement = Placement { shift, turn, about };
    rows_of(name, &Scenario::steady(name, 20.0, vec![head]), machine)
}

fn rows_of(name: &str, scenario: &Scenario, machine: &Machine) -> Result<Vec<Gate>, Error> {
    let tracked = run(scenario, machine, Method::Tracked, 1)?;
    let plain = run(scenario, machine, Method::Uncorrected, 1)?;
    let mut rows = Vec::new();
    for (i, (tracked, plain)) in tracked.iter().zip(&plain).enumerate() {
        let Outcome { p99_mm, used, welded_mm, .. } = tracked;
        let weld = format!("{name}, head {} (untracked {:.3} mm)", i + 1, plain.p99_mm);
        rows.push(gate(&weld, "99 % of the weld within", *p99_mm, 0.05, "mm"));
        let missing = (scenario.heads[i].seam.length_mm - welded_mm).abs();
        rows.push(gate(&weld, "not welded", missing, 0.1, "mm"));
        rows.push(gate(&weld, "of the slide's limits", 100.0 * used.iter().copied().fold(0.0, f64::max), 100.001, "%"));
    }
    Ok(rows)
}
