use super::head_columns::HeadColumns;
use super::plan::{finish, write_report};
use super::row_destination::{self, Rows};
use super::run::desk::Desk;
use super::run::orders::Line;
use super::run::{Ended, bad};
use super::simulated_part;
use crate::args::SimulateArgs;
use crate::args::records::RecordArgs;
use crate::planning;
use crate::progress::Progress;
use seamwright_executive::realtime::Shown;
use seamwright_executive::{Command, Cycle, Executive, Note, Place, Port, Start};
use seamwright_machine::Machine;
use seamwright_message::{Language, Message, Unit};
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_project::failure::Failure;
use seamwright_project::files::Output;
use seamwright_project::load::Loaded;
use seamwright_project::recording::Header;
use seamwright_report::{SimulationCurves, WeldReport};
use seamwright_simulation::devices::When;
use seamwright_simulation::{Conditions, Judge, Sample, SimulatedCell, Summary};
use std::io::Write as _;

/// A weld from switching on to home.
const ORDERS: [&str; 6] = ["on", "home", "wait ready", "arm", "weld", "wait ready"];

pub(crate) fn run(args: &SimulateArgs) -> Result<(), Failure> {
    let loaded = planning::load(&args.job, &args.planning)?;
    let part = simulated_part::read(&args.part)?;
    let around = loaded.surroundings()?;
    let conditions = part.conditions(args.seed, &args.fault, &around);
    let motion = planning::plan_part(&part, &loaded, &args.planning)?;
    let mut output = Output::new(&args.output)?;
    let (report, desk) = weld(&loaded, &motion, conditions, &mut output, args)?;
    if args.fault.is_empty() {
        finish(output, &report, args.json)?;
        judge(report)?;
        return desk.judge();
    }
    // The events were printed instead.
    output.finish()?;
    desk.judge()?;
    judge(report)
}

/// A completed weld that strays beyond its tolerance is a failure, and so is a plan that leaves its procedure.
pub(super) fn judge(report: WeldReport) -> Result<(), Failure> {
    if report.findings.iter().all(|f| f.allowed) { Ok(()) } else { Err(Failure::Findings(report.findings)) }
}

/// Welds in simulation; adds the trace, the report, the events and the deviations that a beam found to `output`, and
/// records the weld if requested. With faults to be injected the events are printed.
pub(super) fn weld(
    loaded: &Loaded,
    motion: &WeldMotion,
    conditions: Conditions<'_>,
    output: &mut Output,
    args: &SimulateArgs,
) -> Result<(WeldReport, Desk), Failure> {
    let Loaded { welding, machine, .. } = loaded;
    let paths = loaded.paths();
    let cell = SimulatedCell::new(machine, loaded.passes(&paths), motion, conditions);
    let lines = ORDERS.iter().filter_map(|line| Line::read(line).ok()).collect();
    let desk = Desk::new(machine, None, lines, args.json);
    let mut desk = if conditions.faults.is_empty() { desk.quiet() } else { desk };
    desk.ends();
    let (outcome, rows, ended) = trace(loaded, motion, &cell, conditions, &mut desk, output, &args.record)?;
    let (report, plots) = WeldReport::new(machine, welding, motion, Some(outcome), Language::of_process());
    for (i, pass) in report.passes.iter().enumerate() {
        // One head: a beam.
        let heads = pass.simulation.iter().flat_map(|summary| &summary.heads);
        if let Some(found) = heads.into_iter().find_map(|head| head.deviations.as_ref()) {
            output.text(&format!("deviations-pass-{}.csv", i + 1), &found.to_csv())?;
        }
    }
    let files = desk.files(&welding.program.value.title, &ended);
    for (name, text) in &files {
        output.text(name, text)?;
    }
    let files = files.map(|(name, text)| (name.to_owned(), text)).into();
    rows.finish(&report, files, desk.happened(), desk.was_stopped(), output)?;
    write_report(output, &report, &plots, welding, args.appendix.extent())?;
    Ok((report, desk))
}

/// Results of each pass, in numbers and in curves.
type Simulated = (Vec<Summary>, Vec<SimulationCurves>);

/// Runs the simulation; its rows go into the output or the library.
fn trace(
    loaded: &Loaded,
    motion: &WeldMotion,
    cell: &SimulatedCell<'_>,
    conditions: Conditions<'_>,
    desk: &mut Desk,
    output: &Output,
    record: &RecordArgs,
) -> Result<(Simulated, Rows, Ended), Failure> {
    let Loaded { welding, machine, .. } = loaded;
    let program = &welding.program.value;
    let work = cell.work(Start::at_home(motion)).map_err(|e| bad(&e))?;
    let mut devices = cell.devices().map_err(|e| bad(&e))?;
    let mut tracking = cell.tracking(Place::default()).map_err(|e| bad(&e))?;
    let about =
        [("title", program.title.clone()), ("machine", machine.name.clone()), ("seed", conditions.seed.to_string())];
    let heads = HeadColumns::new(loaded, &conditions);
    let columns = columns(machine, &heads, work.values());
    let rows = row_destination::begin(
        loaded,
        motion,
        &Header { columns: &columns, about: &about, from: None },
        output,
        record,
        true,
    )?;
    let curves = |p: &PassMotion| SimulationCurves::new(machine.axes.len(), p.path.length());
    let mut watched = Watched {
        machine,
        motion,
        judge: cell.judge().map_err(|e| bad(&e))?,
        desk,
        heads,
        rows,
        values: work.values().len(),
        curves: motion.passes.iter().map(curves).collect(),
        progress: Progress::new("cli-progress-simulating", motion.count(machine.servo_period_s, true)),
        failed: None,
    };
    let guide = tracking.as_mut().map(|tracking| tracking as _);
    let mut executive = Executive::new(machine, &mut devices, &mut watched).with_guide(guide);
    executive.serve(Some(&work));
    let (left, end) = (executive.left(), executive.now());
    drop(executive);
    for fault in conditions.faults.iter().filter(|f| matches!(f.when, When::At(t) if t > end)) {
        // Errors are ignored: standard error may be closed.
        let note = Message::new("cli-fault-never-came").text("fault", fault.to_string());
        let _ = writeln!(std::io::stderr(), "{}", note.quantity("time", end, Unit::S, 1));
    }
    let Watched { judge, rows, curves, failed, .. } = watched;
    match failed {
        Some(failure) => Err(failure),
        None => {
            Ok(((judge.summaries(tracking.as_ref()), curves), rows, Ended { left, timing: None, lines: Vec::new() }))
        }
    }
}

/// Desk and cycle in one thread, in virtual time, with the judge of the weld.
struct Watched<'a> {
    machine: &'a Machine,
    motion: &'a WeldMotion,
    judge: Judge<'a>,
    desk: &'a mut Desk,
    heads: HeadColumns,
    rows: Rows,
    /// Number of process values.
    values: usize,
    curves: Vec<SimulationCurves>,
    progress: Progress,
    failed: Option<Failure>,
}

impl Watched<'_> {
    fn add(&mut self, sample: &Sample) -> Result<(), Failure> {
        self.progress.step();
        if let Some(pass) = sample.pass.checked_sub(1) {
            self.curves[pass].add(self.machine, sample);
        }
        let speed = self.motion.tip_speed(self.machine, sample.pass, &sample.set);
        let values = sample.values.into_iter().take(self.values);
        self.rows.row(row(self.machine, sample, speed).into_iter().chain(self.heads.values(sample)).chain(values))
    }
}

impl Port for Watched<'_> {
    fn command(&mut self, _t: f64) -> Option<Command> {
        let command = self.desk.next()?;
        self.desk.sent();
        Some(command)
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        self.desk.shown(&Shown::from(cycle));
        if self.failed.is_some() {
            return;
        }
        let sample = self.judge.sample(cycle);
        if let Err(failure) = self.add(&sample) {
            self.failed = Some(failure);
            self.desk.give_up(Message::new("cli-run-trace-lost"));
        }
    }

    fn note(&mut self, t: f64, note: Note) {
        self.desk.handle_note(t, note);
    }
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
        ("mode".to_owned(), "1"),
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
    let profile = sample.set.profile;
    let arc = sample.arc();
    let mut row = vec![
        sample.set.t,
        sample.pass as f64,
        profile.s,
        if arc { 1.0 } else { 0.0 },
        speed,
        sample.tip_s,
        sample.tip_speed,
        sample.path_error,
        sample.attitude_error.to_degrees(),
        f64::from(sample.mode as u8),
    ];
    for (i, axis) in machine.axes.iter().enumerate() {
        row.push(axis.to_file(sample.set.q[i]));
        row.push(axis.to_file(sample.q[i]));
        row.push(axis.to_file(sample.following_error[i]));
        row.push(sample.current[i]);
    }
    row
}
