//! Single welds that tracking must pass: a long T-joint, a misplaced saddle, a seam drawn by heat. Rows against
//! limits.

use crate::acceptance::Gate;
use crate::error::Error;
use crate::tracking::displacement::{Displacement, Part};
use crate::tracking::scenario::{HeadScene, Scenario, opposite};
use crate::tracking::scenario_run::{Method, Outcome, run};
use crate::tracking::world::Placement;
use glam::{DQuat, DVec2, DVec3};
use seamwright_executive::tracking::Seam;
use seamwright_machine::Machine;
use seamwright_program::TorchPath;
use std::f64::consts::TAU;

/// Welds a T-joint of 3 m on a skin of 3 m radius, both fillets tracked at 20 mm/s. The fillets drift apart by 4 mm.
///
/// # Errors
/// Those of [`run`].
pub fn t_joint_rows(machine: &Machine) -> Result<Vec<Gate>, Error> {
    let length = 3000.0;
    let drift = Part::Ramp { from_mm: 0.0, to_mm: length, by: DVec2::new(2.0, 0.5) };
    let displacements = opposite(&Displacement::of(drift).and(Part::Sag { from_mm: 0.0, to_mm: length, by_mm: 0.8 }));
    let heads = displacements.map(|d| HeadScene::on(Seam::arc(length, -3000.0, true), d)).into_iter().collect();
    rows_of("T-joint of 3 m, fillets drift apart by 4 mm", &Scenario::steady("T-joint", 20.0, heads), machine)
}

/// Welds a seam in space at 20 mm/s, with a part misplaced by 2 mm, turned by 0.5 degrees and 1 mm out of round.
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

/// Movement of a seam by heat, lateral and height, mm, and its decay length behind the pool.
const DRAWN: DVec2 = DVec2::new(1.0, 0.5);
const BEHIND_MM: f64 = 150.0;
/// Decay lengths ahead of the pool: short, and long.
const AHEAD_MM: [f64; 2] = [60.0, 300.0];
/// Deviation that tracking may add to movement that no sensor sees, mm.
const TRACKED_MM: f64 = 0.05;

/// Welds a straight seam at 20 mm/s that the heat of its own weld draws aside. A sensor ahead cannot see movement
/// between itself and the torch, so the limit allows that much more.
///
/// # Errors
/// Those of [`run`].
pub fn heat_rows(machine: &Machine) -> Result<Vec<Gate>, Error> {
    let mut rows = Vec::new();
    for ahead_mm in AHEAD_MM {
        let heat = Displacement::of(Part::Heat { by: DRAWN, ahead_mm, behind_mm: BEHIND_MM });
        let scene = HeadScene::straight(800.0, heat);
        let unseen = 0.5 * DRAWN.length() * (1.0 - (-scene.sensor.lead_mm / ahead_mm).exp());
        let scenario = Scenario::steady("heat", 20.0, vec![scene]);
        let p99 =
            |method| Ok::<_, Error>(run(&scenario, machine, method, 1)?.first().map_or(f64::INFINITY, |o| o.p99_mm));
        let (tracked, plain) = (p99(Method::Tracked)?, p99(Method::Uncorrected)?);
        let name = format!(
            "seam drawn by heat, {ahead_mm} mm ahead of the pool: of it {unseen:.3} mm behind the sensor (untracked {plain:.3} mm)"
        );
        rows.push(Gate::at_most(&name, "99 % of the weld within", tracked, unseen + TRACKED_MM, "mm"));
    }
    Ok(rows)
}

fn rows_of(name: &str, scenario: &Scenario, machine: &Machine) -> Result<Vec<Gate>, Error> {
    let tracked = run(scenario, machine, Method::Tracked, 1)?;
    let plain = run(scenario, machine, Method::Uncorrected, 1)?;
    let mut rows = Vec::new();
    for (i, (tracked, plain)) in tracked.iter().zip(&plain).enumerate() {
        let Outcome { p99_mm, used, welded_mm, .. } = tracked;
        let weld = format!("{name}, head {} (untracked {:.3} mm)", i + 1, plain.p99_mm);
        rows.push(Gate::at_most(&weld, "99 % of the weld within", *p99_mm, 0.05, "mm"));
        rows.push(Gate::at_most(&weld, "not welded", (scenario.heads[i].seam.length_mm - welded_mm).abs(), 0.1, "mm"));
        rows.push(Gate::at_most(
            &weld,
            "of the slide's limits",
            100.0 * used.iter().copied().fold(0.0, f64::max),
            100.001,
            "%",
        ));
    }
    Ok(rows)
}
