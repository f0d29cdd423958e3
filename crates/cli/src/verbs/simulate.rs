use super::head_columns::HeadColumns;
use super::plan::{finish, write_report};
use super::process::{ArcClock, ProcessColumns};
use super::recorded::{self, Rows};
use crate::args::SimulateArgs;
use crate::args::records::RecordArgs;
use crate::failure::Failure;
use crate::files;
use crate::files::Output;
use crate::load::{Loaded, load};
use crate::progress::Progress;
use seamwright_cell::tracking::{Distortion, RESERVE, check};
use seamwright_cell::{Conditions, Sample, Summary, simulate};
use seamwright_machine::{Machine, Surroundings};
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_project::recording::Header;
use seamwright_report::{SimulationCurves, WeldReport};
use seamwright_tracking::beam::DeviationRecord;
use std::path::Path;

pub(crate) fn run(args: &SimulateArgs) -> Result<(), Failure> {
    if !args.fault.is_empty() {
        return super::run::simulate(args);
    }
    let loaded = load(&args.job)?;
    let distortion = match &args.distortion {
        Some(path) => Some(Distortion::read(&path.display().to_string(), &files::read(path)?)?),
        None => None,
    };
    let replay = args.replay.as_deref().map(stored).transpose()?;
    let tracking = (distortion.is_some() || replay.is_some()) && !args.no_tracking;
    let around = Surroundings::new(&loaded.machine, &loaded.clamped)
        .map_err(|e| Failure::Input(format!("{}: {e}", loaded.welding.program.file())))?;
    let conditions = Conditions {
        seed: args.seed,
        distortion: distortion.as_ref(),
        tracking,
        replay: replay.as_ref(),
        around: Some(&around),
    };
    let reserve = if tracking { RESERVE } else { 0.0 };
    let motion = loaded.plan_on(&loaded.machine.with_reserve(reserve))?;
    loaded.check_count(&motion, loaded.machine.servo_period_s)?;
    if distortion.is_some() || tracking {
        let paths = loaded.paths();
        check(&loaded.machine, &loaded.passes(&paths), &motion, &conditions)?;
    }
    let mut output = Output::new(&args.output)?;
    let report = weld(&loaded, &motion, conditions, &mut output, &args.record)?;
    finish(output, &report, args.json)?;
    judge(report)
}

/// What an earlier weld has found of the seam.
fn stored(path: &Path) -> Result<DeviationRecord, Failure> {
    let record = DeviationRecord::from_csv(&path.display().to_string(), &files::read(path)?);
    record.map_err(|e| Failure::Input(e.to_string()))
}

/// A weld that was made but strays beyond its tolerance is no success, nor is a plan that leaves its procedure.
pub(super) fn judge(report: WeldReport) -> Result<(), Failure> {
    if report.findings.iter().all(|f| f.allowed) { Ok(()) } else { Err(Failure::Findings(report.findings)) }
}

/// Welds in simulation; adds the trace, the report and the deviations that a beam found to `output`, and records the weld if it
/// is to be.
pub(super) fn weld(
    loaded: &Loaded,
    motion: &WeldMotion,
    conditions: Conditions<'_>,
    output: &mut Output,
    record: &RecordArgs,
) -> Result<WeldReport, Failure> {
    let Loaded { welding, machine, .. } = loaded;
    let begin = |header: &Header<'_>| recorded::begin(loaded, motion, header, output, record);
    let (outcome, rows) = trace(loaded, motion, conditions, begin)?;
    let (report, plots) = WeldReport::new(machine, welding, motion, Some(outcome));
    for (i, pass) in report.passes.iter().enumerate() {
        // One head: a beam.
        let heads = pass.simulation.iter().flat_map(|summary| &summary.heads);
        if let Some(found) = heads.into_iter().find_map(|head| head.deviations.as_ref()) {
            output.text(&format!("deviations-pass-{}.csv", i + 1), &found.to_csv())?;
        }
    }
    rows.finish(&report, output)?;
    write_report(output, &report, &plots, welding)?;
    Ok(report)
}

/// What each pass did, in numbers and in curves.
type Simulated = (Vec<Summary>, Vec<SimulationCurves>);

/// Runs the simulation; its rows go where `begin`, which gets columns and metadata, says.
fn trace(
    loaded: &Loaded,
    motion: &WeldMotion,
    conditions: Conditions<'_>,
    begin: impl FnOnce(&Header<'_>) -> Result<Rows, Failure>,
) -> Result<(Simulated, Rows), Failure> {
    let Loaded { welding, machine, .. } = loaded;
    let program = &welding.program.value;
    let (process, mut clock) = (ProcessColumns::new(program), ArcClock::new(motion));
    let about =
        [("title", program.title.clone()), ("machine", machine.name.clone()), ("seed", conditions.seed.to_string())];
    let heads = HeadColumns::new(loaded, &conditions);
    let columns = columns(machine, &heads, process.names());
    let mut rows = begin(&Header { columns: &columns, about: &about })?;
    let curves = |p: &PassMotion| SimulationCurves::new(machine.axes.len(), p.path.length());
    let mut curves: Vec<SimulationCurves> = motion.passes.iter().map(curves).collect();
    let mut progress = Progress::new("welding in simulation", motion.count(machine.servo_period_s, false));
    let paths = loaded.paths();
    let passes = loaded.passes(&paths);
    let summaries = simulate(machine, &passes, motion, conditions, |sample| {
        progress.step();
        if let Some(pass) = sample.pass.checked_sub(1) {
            curves[pass].add(machine, sample);
        }
        let values = process.values(sample.pass, sample.set.law.s, clock.at(sample.pass, &sample.set));
        let speed = motion.tip_speed(machine, sample.pass, &sample.set);
        rows.row(row(machine, sample, speed).into_iter().chain(heads.values(sample)).chain(values))
    })?;
    Ok(((summaries, curves), rows))
}

fn columns(machine: &Machine, heads: &HeadColumns, process: &[String]) -> Vec<(String, &'static str)> {
    let mut columns: Vec<(String, &'static str)> = vec![
        ("t_s".to_owned(), "s"),
        ("pass".to_owned(), "1"),
        ("s_mm".to_owned(), "mm"),
        ("arc".to_owned(), "1"),
        ("speed_set_mm_s".to_owned(), "mm/s"),
        ("tip_s_mm".to_owned(), "mm"),
        ("tip_speed_mm_s".to_owned(), "mm/s"),
        ("path_error_mm".to_owned(), "mm"),
        ("attitude_error_deg".to_owned(), "deg"),
    ];
    for axis in &machine.axes {
        let (name, unit) = (&axis.name, axis.unit());
        columns.push((format!("{name}_set_{unit}"), unit));
        columns.push((format!("{name}_true_{unit}"), unit));
        columns.push((format!("{name}_following_error_{unit}"), unit));
        columns.push((format!("{name}_current_part"), "1"));
    }
    columns.extend(heads.names());
    // The unit of a process value is the end of its name.
    columns.extend(process.iter().map(|name| (name.clone(), "")));
    columns
}

/// All columns but those of the process, with the planned `speed` of the tip.
fn row(machine: &Machine, sample: &Sample, speed: f64) -> Vec<f64> {
    let law = sample.set.law;
    let arc = sample.arc();
    let mut row = vec![
        sample.set.t,
        sample.pass as f64,
        law.s,
        if arc { 1.0 } else { 0.0 },
        speed,
        sample.tip_s,
        sample.tip_speed,
        sample.path_error,
        sample.attitude_error.to_degrees(),
    ];
    for (i, axis) in machine.axes.iter().enumerate() {
        row.push(axis.to_file(sample.set.q[i]));
        row.push(axis.to_file(sample.q[i]));
        row.push(axis.to_file(sample.following_error[i]));
        row.push(sample.current[i]);
    }
    row
}
