//! Injects every fault in every situation of the executive.

use crate::common::{Planned, SADDLE, Tracked, soak};
use seamwright_executive::{Place, Start};
use seamwright_simulation::devices::Device;
use seamwright_simulation::fault_injection;
use seamwright_simulation::fault_injection::{Case, Outcome, Situation, Stage, TrackedStage};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

/// Runs `run` on the stage of the fault injection, made for this thread.
fn on_stage<T>(run: impl FnOnce(Stage<'_>) -> T) -> T {
    let planned = Planned::new(SADDLE);
    let (begin, end) = (planned.work(Start::at_home(&planned.motion)), planned.work(planned.near_end()));
    let tracked = Tracked::new(SADDLE);
    let cell = tracked.cell();
    let near_end = Place { pass: 1, s_mm: tracked.planned.motion.passes[0].path.length() - 5.0 };
    let start = tracked.planned.near_end();
    let works = [cell.work(Start::at_home(&tracked.planned.motion)).unwrap(), cell.work(start).unwrap()];
    let works = [&works[0], &works[1]];
    let on_sensors = TrackedStage { cell: &cell, works, near_end };
    run(Stage { machine: &planned.machine, begin: &begin, end: &end, tracked: Some(on_sensors) })
}

/// A weld that rides out a sensor's loss takes a minute.
fn takes_long(case: Case) -> bool {
    use Situation as S;
    case.device == Device::Sensors && matches!(case.situation, S::DryRun | S::Approach | S::Preflow | S::Strike)
}

/// Every device, every fault, every situation: the cell ends as required, the process is off a cycle later,
/// set-points keep every limit, and the alarm names the cause.
#[test]
fn whatever_fails_the_cell_ends_as_it_must() {
    on_stage(|stage| {
        let cases = fault_injection::cases(&stage).into_iter().filter(|case| !takes_long(*case));
        let outcomes: Vec<Outcome> = cases.map(|case| fault_injection::run(stage, case, 0, false).unwrap()).collect();
        println!("{}\n{}", fault_injection::summary(&outcomes), fault_injection::table(stage.machine, &outcomes));
        let failed: Vec<String> = outcomes.iter().filter(|o| !o.is_kept()).map(describe_outcome).collect();
        assert!(failed.is_empty(), "{} of {}:\n{}", failed.len(), outcomes.len(), failed.join("\n"));
    });
}

fn describe_outcome(outcome: &Outcome) -> String {
    format!("{outcome:?}\n    expected {:?}", fault_injection::expected(outcome.case))
}

/// Seeds of the soak, times SEAMWRIGHT_SOAK; and its maximum duration, s.
const SEEDS: u64 = 20;
const MAX_S: u64 = 3600;
/// One of this many seeds includes the faults of sensors, which take most of the time.
const WITH_SENSORS: u64 = 50;

/// Injects every fault with thousands of seeds, each of which determines the moment in the situation. In situations
/// that last, every fourth seed chooses it within twenty seconds. Runs as many as fit into an hour on all cores.
#[test]
#[ignore = "thousands of injections: make soak"]
fn thousands_of_moments_of_every_fault() {
    let (seeds, begun) = (SEEDS * soak().unwrap_or(5), Instant::now());
    let (next, done) = (AtomicU64::new(0), Mutex::new((0, Vec::new(), Vec::new())));
    let lane = |stage: Stage<'_>| {
        while begun.elapsed().as_secs() < MAX_S {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed >= seeds {
                break;
            }
            let outcomes = moments(stage, seed);
            let mut done = done.lock().unwrap();
            done.0 += 1;
            done.2.extend(
                outcomes.iter().filter(|o| !o.is_kept()).map(|o| format!("seed {seed}: {}", describe_outcome(o))),
            );
            done.1.extend(outcomes);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| on_stage(lane));
        }
    });
    let (seeds, outcomes, failed) = done.into_inner().unwrap();
    println!("{seeds} seeds in {:.0} s: {}", begun.elapsed().as_secs_f64(), fault_injection::summary(&outcomes));
    assert!(failed.is_empty(), "{} of {}:\n{}", failed.len(), outcomes.len(), failed.join("\n"));
}

/// Runs every case once, at the moment that `seed` determines.
fn moments(stage: Stage<'_>, seed: u64) -> Vec<Outcome> {
    use Situation as S;
    let with_sensors = seed % WITH_SENSORS == WITH_SENSORS - 1;
    let cases =
        fault_injection::cases(&stage).into_iter().filter(|case| with_sensors || case.device != Device::Sensors);
    let run = |case: Case| {
        let lasts =
            matches!(case.situation, S::Off | S::Idle | S::Ready | S::Jog | S::DryRun | S::Travel | S::Hold | S::Fault);
        let anywhere = seed % 4 == 3 && lasts && case.device != Device::Sensors;
        fault_injection::run(stage, case, seed, anywhere).unwrap()
    };
    cases.map(run).collect()
}
