//! Faults of sensors and slides half-way through a weld: rows against limits that follow from the course of the seam.

use super::disturbances::SPEEDS;
use crate::acceptance::Gate;
use crate::disturbance::uniform;
use crate::error::Error;
use crate::tracking::displacement::{Displacement, Part};
use crate::tracking::scenario::{HeadScene, Scenario};
use crate::tracking::scenario_run::{Method, Outcome, run};
use crate::tracking::sensor_model::Fault;
use glam::DVec2;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use seamwright_machine::Machine;
use seamwright_tracking::actuator::{Alarm, Cause};
use seamwright_tracking::lead::{Refusal, Settings};
use std::f64::consts::TAU;

const LENGTH: f64 = 600.0;
/// Start of the faults, mm.
const THERE: f64 = 300.0;
const LEAD: f64 = 20.0;
/// Distance in which the torch comes to rest, mm: from 100 mm/s at 1000 mm/s^2, and a cycle or two.
const BRAKING: f64 = 6.0;
/// Allowed deviation beyond the seam's course, mm: noise of the sensor and of the followed slope, and the drive.
const SLACK: f64 = 0.05;
/// Deviation of a slide from its order that is noticed, mm, and the time that this takes, s.
const NOTICED: (f64, f64) = (0.1, 0.02);
/// Maximum number of reversals of the set-points: with the seam, and on the way back to the taught path.
const TURNS: f64 = 2.0;

/// Device that fails.
#[derive(Debug, Clone, Copy)]
enum Failing {
    Sensor(Fault, Cause),
    Slide,
}

const FAULTS: [(&str, Failing); 7] = [
    ("total loss: sensor silent", Failing::Sensor(Fault::Silent, Cause::Silent)),
    ("sensor frozen", Failing::Sensor(Fault::Frozen, Cause::Refused(Refusal::Frozen))),
    ("sensor wild", Failing::Sensor(Fault::Wild, Cause::Wild)),
    ("sensor late by 3 periods", Failing::Sensor(Fault::Late(0.03), Cause::Refused(Refusal::Late))),
    ("sensor's clock 0.5 s ahead", Failing::Sensor(Fault::ClockStep(0.5), Cause::Refused(Refusal::Clock))),
    ("sensor's clock 0.5 s behind", Failing::Sensor(Fault::ClockStep(-0.5), Cause::Refused(Refusal::Late))),
    ("slide stuck", Failing::Slide),
];

/// Runs every fault at both speeds with the seeds 1 to `seeds`, of which the worst counts. Measures the deviation of
/// the weld, position and cause of the alarm, the stopping position and the slide's reversals.
///
/// # Errors
/// Those of [`run`].
pub fn fault_rows(machine: &Machine, seeds: u64) -> Result<Vec<Gate>, Error> {
    let (mut rows, mut used) = (Vec::new(), 0.0f64);
    for (speed, _) in SPEEDS {
        for (name, failing) in FAULTS {
            let mut worst = [f64::NEG_INFINITY; FIGURES];
            for seed in 1..=seeds {
                let scenario = faulty(speed, failing, seed);
                let tracked = &run(&scenario, machine, Method::Tracked, seed)?[0];
                let found = measured(&scenario.heads[0].displacement, tracked, failing, speed);
                for (worst, found) in worst.iter_mut().zip(found) {
                    *worst = worst.max(found);
                }
                used = tracked.used.into_iter().fold(used, f64::max);
            }
            rows.extend(named(&format!("{speed} mm/s, {name}"), failing, speed, worst));
        }
    }
    rows.push(Gate::at_most("all of them", "of the slide's limits", 100.0 * used, 100.001, "%"));
    Ok(rows)
}

/// Number of figures measured of a weld.
const FIGURES: usize = 7;

/// Measures a weld: maximum miss; the part explained by the seam's course, and the rest; positions of alarm and rest
/// after the fault; alarms with another cause; reversals.
fn measured(seam: &Displacement, weld: &Outcome, failing: Failing, speed: f64) -> [f64; FIGURES] {
    let (explained, right, from) = match failing {
        Failing::Sensor(_, cause) => (unseen(seam, speed), weld.cause == Some(cause), THERE),
        Failing::Slide => (unmoved(seam, speed), weld.alarm == Some(Alarm::SlideStuck), THERE + until_noticed(seam)),
    };
    let after = |place: Option<f64>| place.map_or(f64::INFINITY, |at| at - from);
    let (alarm, rest) = (after(weld.alarm_mm), after(weld.stopped_mm));
    let missed = weld.most_mm;
    [missed, explained, missed - explained, alarm, rest, f64::from(!right), f64::from(weld.turns)]
}

fn named(weld: &str, failing: Failing, speed: f64, worst: [f64; FIGURES]) -> Vec<Gate> {
    let settings = Settings::usual(LEAD, speed);
    // Ten periods without sight are a warning if they are longer than tacks explain. Detection of a frozen sensor may
    // take five more.
    let blind = (0.1 * speed).max(settings.coast_mm()) + 0.05 * speed + 1.0;
    // The last measurement is a lead ahead of the torch.
    let lost = LEAD + settings.coast_mm() + settings.fade_mm;
    // The maximum deviation of a drive accounts for 2 mm of path.
    let stuck = speed * NOTICED.1 + 2.0;
    let [missed, explained, beyond, alarm, rest, other, turns] = worst;
    let rows = match failing {
        Failing::Sensor(..) => [("first alarm, after", alarm, blind), ("at rest, after", rest, lost + BRAKING)],
        Failing::Slide => [
            ("alarm, after 0.1 mm were missing by", alarm, stuck),
            ("at rest, after 0.1 mm were missing by", rest, stuck + BRAKING),
        ],
    };
    let gate = |what, value, limit, unit| Gate::at_most(weld, what, value, limit, unit);
    let [alarm, rest] = rows.map(|(what, value, limit)| gate(what, value, limit, "mm"));
    vec![
        gate("maximum miss", missed, (1e3 * (explained + SLACK)).round() / 1e3, "mm"),
        gate("missed beyond the seam's own course", beyond, SLACK, "mm"),
        alarm,
        rest,
        gate("welds whose alarm names something else", other, 0.0, ""),
        gate("turns of the slide", turns, TURNS, ""),
    ]
}

/// Distance in which the seam leaves a stuck slide so far that it can be noticed, mm.
fn until_noticed(seam: &Displacement) -> f64 {
    let at = |s: f64| seam.at(s, s);
    let ways = (0..3000).map(|k| 0.1 * f64::from(k));
    ways.into_iter().find(|way| at(THERE + way).distance(at(THERE)) > NOTICED.0).unwrap_or(LENGTH - THERE)
}

/// Maximum deviation of the seam from the order where it is not seen. The last slope decays, then the order fades to
/// zero.
fn unseen(seam: &Displacement, speed: f64) -> f64 {
    let settings = Settings::usual(LEAD, speed);
    let at = |s: f64| seam.at(s, s);
    let seen = THERE + LEAD;
    let slope = (at(seen) - at(seen - 0.5 * LEAD)) / (0.5 * LEAD);
    let (coast, fade, decay) = (settings.coast_mm(), settings.fade_mm, settings.decay_mm);
    let off = |way: f64| {
        let ordered = at(seen) + slope * decay * (1.0 - (-way / decay).exp());
        let faded = ((way - coast) / fade).clamp(0.0, 1.0);
        (at(seen + way) - (1.0 - faded * faded * (3.0 - 2.0 * faded)) * ordered).length()
    };
    (0..=1000).map(|k| off((coast + fade + BRAKING) * f64::from(k) / 1000.0)).fold(0.0, f64::max)
}

/// Maximum deviation of the seam from a stuck slide until that is noticed and the torch is at rest.
fn unmoved(seam: &Displacement, speed: f64) -> f64 {
    let at = |s: f64| seam.at(s, s);
    let rest = until_noticed(seam) + speed * NOTICED.1 + speed * speed / 2000.0 + 1.0;
    (0..=1000).map(|k| at(THERE + rest * f64::from(k) / 1000.0).distance(at(THERE))).fold(0.0, f64::max)
}

/// A seam that oscillates by some millimetres, as the seed determines, and a failure half-way.
fn faulty(speed: f64, failing: Failing, seed: u64) -> Scenario {
    let mut random = Pcg64Mcg::seed_from_u64(seed ^ 0xfa01_7000_0000_0001);
    let phase = DVec2::new(TAU * uniform(&mut random), TAU * uniform(&mut random));
    let length_mm = 250.0 + 200.0 * uniform(&mut random);
    let wave = Part::Wave { length_mm, size: DVec2::new(1.2, 0.6), phase };
    let mut head = HeadScene::straight(LENGTH, Displacement::of(Part::Shift(DVec2::new(0.5, -0.4))).and(wave));
    match failing {
        Failing::Sensor(fault, _) => head.sensor.fault = Some((THERE, fault)),
        Failing::Slide => head.stuck_mm = Some(THERE),
    }
    Scenario::steady("fault", speed, vec![head])
}
