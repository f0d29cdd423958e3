//! Acceptance tests of tracking on simulated welds: rows of a table, each head against its limit, beside the papers'
//! algorithms and welds without correction.

use crate::error::Error;
use crate::tracking::displacement::{Displacement, Part};
use crate::tracking::scenario::{HeadScene, Scenario, opposite};
use crate::tracking::scenario_run::{Method, Outcome, run};
use crate::tracking::sensor_model::SensorModel;
use crate::tracking::travel::Leg;
use glam::DVec2;
use seamwright_machine::Machine;
use std::f64::consts::FRAC_PI_2;

/// Speeds of the tests, mm/s, with the distance that 99 % of the weld must keep, mm.
pub const SPEEDS: [(f64, f64); 2] = [(20.0, 0.05), (100.0, 0.1)];
/// Length of the seams, mm.
const LENGTH: f64 = 800.0;
/// Position of disturbances, mm.
const THERE: f64 = 400.0;

/// One head of one weld by all methods.
#[derive(Debug, Clone, PartialEq)]
pub struct GateRow {
    /// mm/s.
    pub speed_mm_s: f64,
    /// Disturbance of the seam or the sensor.
    pub name: String,
    /// Counted from 1.
    pub head: usize,
    /// Distance that 99 % of the weld keep, mm, in the order of [`Method::ALL`]; the maximum over all seeds.
    pub p99_mm: [f64; 4],
    /// Limit of tracking, mm.
    pub limit_mm: f64,
    /// Maximum share of a limit of the slide's stroke, speed, acceleration or jerk that tracking used.
    pub used: f64,
}

impl GateRow {
    /// Returns true if tracking is within its limit and exceeded no limit of the slide.
    #[must_use]
    pub fn is_kept(&self) -> bool {
        self.p99_mm[3] <= self.limit_mm && self.used <= 1.0 + 1e-6
    }
}

/// Welds all scenarios with the seeds from 0 to below `seeds` by all methods; calls `done` after each weld.
///
/// # Errors
/// Those of [`run`].
pub fn tracking_gates(machine: &Machine, seeds: u64, mut done: impl FnMut()) -> Result<Vec<GateRow>, Error> {
    let mut rows = Vec::new();
    for (speed, limit_mm) in SPEEDS {
        for number in 0..scenarios(speed, 0).len() {
            let mut found: Vec<GateRow> = Vec::new();
            for seed in 0..seeds {
                let scenario = &scenarios(speed, seed)[number];
                let welds = Method::ALL.map(|method| {
                    let outcome = run(scenario, machine, method, seed);
                    done();
                    outcome
                });
                let [a, b, c, d] = welds;
                merge(&mut found, scenario, limit_mm, &[a?, b?, c?, d?]);
            }
            rows.extend(found);
        }
    }
    Ok(rows)
}

/// Returns the number of welds of [`tracking_gates`].
#[must_use]
pub fn weld_count(seeds: u64) -> u64 {
    SPEEDS.iter().map(|(speed, _)| (scenarios(*speed, 0).len() * Method::ALL.len()) as u64 * seeds).sum()
}

fn merge(rows: &mut Vec<GateRow>, scenario: &Scenario, limit_mm: f64, welds: &[Vec<Outcome>; 4]) {
    for (head, tracked) in welds[3].iter().enumerate() {
        let p99_mm = welds.each_ref().map(|outcomes| outcomes[head].p99_mm);
        let used = tracked.used.into_iter().fold(0.0, f64::max);
        match rows.get_mut(head) {
            Some(row) => {
                row.p99_mm = [0, 1, 2, 3].map(|method: usize| row.p99_mm[method].max(p99_mm[method]));
                row.used = row.used.max(used);
            }
            None => rows.push(GateRow {
                speed_mm_s: scenario.speed_mm_s,
                name: scenario.name.clone(),
                head: head + 1,
                p99_mm,
                limit_mm,
                used,
            }),
        }
    }
}

/// Returns the welds of the tests at `speed`; both heads' seams bend in opposite ways.
#[must_use]
pub fn scenarios(speed: f64, seed: u64) -> Vec<Scenario> {
    let size = DVec2::new(1.0, 0.5);
    let bend = || Displacement::bend(LENGTH, 1.5, seed);
    let heads = |displacement: &Displacement| {
        opposite(displacement).map(|d| HeadScene::straight(LENGTH, d)).into_iter().collect::<Vec<_>>()
    };
    let steady = |name: &str, displacement: Displacement| Scenario::steady(name, speed, heads(&displacement));
    let sine = |hz: f64| {
        let wave = Part::Wave { length_mm: speed / hz, size: DVec2::splat(0.5), phase: DVec2::new(0.0, FRAC_PI_2) };
        steady(&format!("sine of 0.5 mm, {hz} Hz"), Displacement::of(wave))
    };
    let ramp = Part::Ramp { from_mm: 200.0, to_mm: 600.0, by: 4.0 * size };
    let mut all = vec![
        steady("step of 1 mm", Displacement::of(Part::Step { at_mm: THERE, by: size })),
        steady("ramp of 4 mm", Displacement::of(ramp)),
        sine(0.5),
        sine(1.0),
        sine(2.0),
        steady("bent, 5 % outliers", bend()),
        steady("bent, tack of 15 mm", bend().tacked(THERE, THERE + 15.0)),
        steady("bent, jitter of a period", bend()),
        steady("bent, speed changes", bend()),
        steady("bent, hold and reverse", bend()),
    ];
    sensors(&mut all[5], |sensor| sensor.outliers = 0.05);
    sensors(&mut all[7], |sensor| sensor.jitter = 1.0);
    let slow = 0.4 * speed;
    all[8].legs =
        vec![Leg::To(200.0, speed), Leg::To(350.0, slow), Leg::To(600.0, speed), Leg::To(LENGTH, 0.7 * speed)];
    all[9].legs = vec![
        Leg::To(THERE, speed),
        Leg::Hold(2.0),
        Leg::To(THERE - 15.0, slow),
        Leg::To(550.0, speed),
        Leg::To(525.0, speed),
        Leg::To(LENGTH, speed),
    ];
    all
}

fn sensors(scenario: &mut Scenario, change: impl Fn(&mut SensorModel)) {
    scenario.heads.iter_mut().for_each(|head| change(&mut head.sensor));
}
