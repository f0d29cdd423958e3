//! Every fault in every situation of the executive.

mod common;

use common::{Planned, SADDLE, Tracked};
use seamwright_cell::campaign::{self, Case, Outcome, Situation, Stage, TrackedStage};
use seamwright_cell::devices::{Device, FaultKind};
use seamwright_cell::executive::{Place, Start};

/// Every device, every fault, every situation: the cell ends as it must, the process is off a cycle later, set-points keep
/// every limit, and the alarm names the cause.
#[test]
fn whatever_fails_the_cell_ends_as_it_must() {
    let planned = Planned::new(SADDLE);
    let (begin, end) = (planned.work(Start::at_home(&planned.motion)), planned.work(planned.near_end()));
    let tracked = Tracked::new(SADDLE);
    let cell = tracked.cell();
    let near_end = Place { pass: 1, s_mm: tracked.planned.motion.passes[0].path.length() - 5.0 };
    let start = tracked.planned.near_end();
    let works = [cell.work(Start::at_home(&tracked.planned.motion)).unwrap(), cell.work(start).unwrap()];
    let works = [&works[0], &works[1]];
    let on_sensors = TrackedStage { cell: &cell, works, near_end };
    let stage = Stage { machine: &planned.machine, begin: &begin, end: &end, tracked: Some(on_sensors) };
    let seeds = soak().unwrap_or(1);
    let mut failed = Vec::new();
    let mut outcomes: Vec<Outcome> = Vec::new();
    for seed in 0..seeds {
        for case in campaign::cases(&stage) {
            // A weld that rides a sensor's loss out takes a minute: elsewhere than on its way for the soak only.
            let rides = matches!(case.situation, Situation::DryRun | Situation::Approach | Situation::Preflow);
            if case.device == Device::Sensors && (rides || case.situation == Situation::Strike) && soak().is_none() {
                continue;
            }
            let outcome = campaign::run(stage, case, seed, false).unwrap();
            if !outcome.is_kept() {
                failed.push(format!("seed {seed}: {outcome:?}\n    expected {:?}", campaign::expected(case)));
            }
            outcomes.push(outcome);
        }
    }
    println!("{}\n{}", campaign::summary(&outcomes), campaign::table(&planned.machine, &outcomes));
    assert!(failed.is_empty(), "{} of {}:\n{}", failed.len(), outcomes.len(), failed.join("\n"));
}

/// How much is tried beyond the quick.
fn soak() -> Option<u64> {
    std::env::var("SEAMWRIGHT_SOAK").ok().and_then(|n| n.parse().ok())
}

/// An emergency stop, a door and a lost arc at thousands of random moments of a weld: each ends as it must, within the way that the
/// axes' limits allow for a stop.
#[test]
#[ignore = "thousands of welds: make soak"]
fn doors_and_emergency_stops_at_any_moment() {
    let planned = Planned::new(SADDLE);
    let (begin, end) = (planned.work(Start::at_home(&planned.motion)), planned.work(planned.near_end()));
    let stage = Stage { machine: &planned.machine, begin: &begin, end: &end, tracked: None };
    let inputs = (0..3).map(|which| (Device::Inputs, FaultKind::Wrong, which));
    let cases: Vec<Case> = inputs
        .chain([(Device::Source, FaultKind::Wrong, 0), (Device::Cycle, FaultKind::Slow, 0)])
        .map(|(device, kind, which)| Case { device, kind, which, situation: Situation::Travel })
        .collect();
    let mut outcomes: Vec<Outcome> = Vec::new();
    for seed in 0..10 * soak().unwrap_or(100) {
        for case in &cases {
            let outcome = campaign::run(stage, *case, seed, true).unwrap();
            assert!(outcome.is_kept(), "seed {seed}: {outcome:?}");
            outcomes.push(outcome);
        }
    }
    println!("{}", campaign::summary(&outcomes));
}
