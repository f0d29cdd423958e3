use crate::args::bench::BenchFaultsArgs;
use crate::progress::Progress;
use crate::rows::{print_json, print_text};
use crate::verbs::run::bad;
use seamwright_executive::tracking::RESERVE;
use seamwright_executive::{Place, Start};
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_project::load::load_text;
use seamwright_simulation::fault_injection::{Outcome, Stage, TrackedStage};
use seamwright_simulation::tracking::Distortion;
use seamwright_simulation::{Conditions, SimulatedCell, fault_injection};
use std::path::Path;

const JOB: &str = include_str!("../../../../../examples/saddle.toml");
const MISPLACED: &str = include_str!("../../../../../examples/distortions/misplaced.toml");
/// Distance of the start from the end of the weld in which the crater is filled, mm.
const LAST_MM: f64 = 5.0;

pub(super) fn run(args: &BenchFaultsArgs) -> Result<(), Failure> {
    let loaded = load_text("saddle.toml", JOB, Path::new("."))?;
    let machine = &loaded.machine;
    let around = loaded.surroundings()?;
    let paths = loaded.paths();
    // Untracked, and tracked on a part that lies elsewhere.
    let distortion = Distortion::read("misplaced.toml", MISPLACED)?;
    let plain = Conditions { seed: 1, around: Some(&around), ..Conditions::default() };
    let tracked = Conditions { distortion: Some(&distortion), tracking: true, ..plain };
    let motions = [loaded.plan()?, loaded.plan_on(&machine.with_reserve(RESERVE))?];
    let cells = [
        SimulatedCell::new(machine, loaded.passes(&paths), &motions[0], plain),
        SimulatedCell::new(machine, loaded.passes(&paths), &motions[1], tracked),
    ];
    let near_end = Place { pass: 1, s_mm: motions[0].passes[0].path.length() - LAST_MM };
    let start = |motion| Start::at_place(machine, &around, motion, &machine.home(), near_end);
    let mut works = Vec::new();
    for (cell, motion) in cells.iter().zip(&motions) {
        works.push(cell.work(Start::at_home(motion)).map_err(|e| bad(&e))?);
        works.push(cell.work(start(motion).map_err(|e| Failure::input(Message::outside(&e)))?).map_err(|e| bad(&e))?);
    }
    let [begin, end, tracked_begin, tracked_end] = &works[..] else { return Err(Failure::Printed) };
    let on_sensors = TrackedStage { cell: &cells[1], works: [tracked_begin, tracked_end], near_end };
    let stage = Stage { machine, begin, end, tracked: Some(on_sensors) };
    let cases = fault_injection::cases(&stage);
    let progress = Progress::new("cli-progress-faults", args.seeds * cases.len() as u64);
    let mut outcomes: Vec<Outcome> = Vec::new();
    for seed in 0..args.seeds {
        for case in &cases {
            outcomes.push(fault_injection::run(stage, *case, seed, false).map_err(|e| bad(&e))?);
            progress.all(1);
        }
    }
    drop(progress);
    print(args, machine, &cases, &outcomes)?;
    if outcomes.iter().all(Outcome::is_kept) { Ok(()) } else { Err(Failure::Printed) }
}

/// The worst of all seeds represents a case.
fn print(
    args: &BenchFaultsArgs,
    machine: &seamwright_machine::Machine,
    cases: &[fault_injection::Case],
    outcomes: &[Outcome],
) -> Result<(), Failure> {
    let worst = cases.iter().filter_map(|case| {
        let of = || outcomes.iter().filter(|o| o.case == *case);
        of().find(|o| !o.is_kept()).or_else(|| of().next()).cloned()
    });
    let worst: Vec<Outcome> = worst.collect();
    if args.json {
        let rows = worst.iter().map(|o| {
            serde_json::json!({
                "device": o.case.device.name(),
                "fault": o.case.kind.name(),
                "situation": o.case.situation.name(),
                "mode": o.mode.name(),
                "first_alarm": o.first_alarm.map(|a| a.entry().name),
                "process_off_after_cycles": o.off_cycles,
                "stopped_after_mm": o.stop_mm,
                "of_the_stop_allowed": o.stop_part,
                "kept": o.is_kept(),
                "violations": o.violations.iter().map(ToString::to_string).collect::<Vec<_>>(),
            })
        });
        return print_json(&serde_json::json!({ "seeds": args.seeds, "cases": rows.collect::<Vec<_>>() }));
    }
    print_text(&format!("{}\n{}\n", fault_injection::table(machine, &worst), fault_injection::summary(outcomes)))
}
