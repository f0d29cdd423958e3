use crate::args::bench::BenchFaultsArgs;
use crate::failure::Failure;
use crate::load::load_text;
use crate::progress::Progress;
use crate::rows::{print_json, print_text};
use seamwright_cell::campaign::{self, Outcome, Stage};
use seamwright_cell::executive::{Place, Start, Work};
use seamwright_machine::Surroundings;
use seamwright_program::Pass;
use std::path::Path;

const JOB: &str = include_str!("../../../../../examples/saddle.toml");
/// How far before its end the weld begins in which the crater is filled, mm.
const LAST_MM: f64 = 5.0;

pub(super) fn run(args: &BenchFaultsArgs) -> Result<(), Failure> {
    let loaded = load_text("saddle.toml", JOB, Path::new("."))?;
    let motion = loaded.plan()?;
    let machine = &loaded.machine;
    let passes: Vec<&Pass> = loaded.welding.program.value.passes.iter().collect();
    let around = Surroundings::new(machine, &loaded.clamped).map_err(|e| Failure::Input(e.to_string()))?;
    let place = Place { pass: 1, s_mm: motion.passes[0].path.length() - LAST_MM };
    let near_end = Start::at_place(machine, &around, &motion, &machine.home(), place)
        .map_err(|e| Failure::Input(e.to_string()))?;
    let work = |start| Work::new(machine, None, &passes, &motion, start).map_err(crate::verbs::run::too_many);
    let (begin, end) = (work(Start::at_home(&motion))?, work(near_end)?);
    let stage = Stage { machine, begin: &begin, end: &end };
    let cases = campaign::cases(machine);
    let progress = Progress::new("faults", args.seeds * cases.len() as u64);
    let mut outcomes: Vec<Outcome> = Vec::new();
    for seed in 0..args.seeds {
        for case in &cases {
            let outcome = campaign::run(stage, *case, seed).map_err(|e| Failure::Environment(e.to_string()))?;
            outcomes.push(outcome);
            progress.all(1);
        }
    }
    drop(progress);
    print(args, machine, &cases, &outcomes)?;
    if outcomes.iter().all(Outcome::is_kept) { Ok(()) } else { Err(Failure::Printed) }
}

/// The worst of all seeds of a case stands for it.
fn print(
    args: &BenchFaultsArgs,
    machine: &seamwright_machine::Machine,
    cases: &[campaign::Case],
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
                "kept": o.is_kept(),
                "violations": o.violations,
            })
        });
        return print_json(&serde_json::json!({ "seeds": args.seeds, "cases": rows.collect::<Vec<_>>() }));
    }
    print_text(&format!("{}\n{}\n", campaign::table(machine, &worst), campaign::summary(outcomes)))
}
