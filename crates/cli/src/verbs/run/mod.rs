//! A job on a running cell: in real time under an operator's orders, or in virtual time with faults.

mod desk;
mod orders;
mod table;

use crate::args::SimulateArgs;
use crate::args::records::RecordArgs;
use crate::args::run::RunArgs;
use crate::failure::Failure;
use crate::files::Output;
use crate::load::{Loaded, load};
use desk::Desk;
use orders::Line;
use seamwright_cell::devices::When;
use seamwright_cell::executive::{Command, Cycle, Devices, Executive, Note, Place, Port, Start, VALUES, Work};
use seamwright_cell::realtime::{Footing, Latency, Outside, Paced, Pacer, Shown, Urgent, live};
use seamwright_machine::{Machine, Surroundings};
use seamwright_motion::WeldMotion;
use seamwright_program::Pass;
use seamwright_project::devices::{self, Cell, Lines};
use seamwright_project::power_loss;
use std::io::{BufRead as _, IsTerminal as _, Write as _};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::Duration;
use table::Table;

/// How often the desk looks at what the cycle has sent.
const LOOK: Duration = Duration::from_millis(5);

/// A weld in virtual time from switching on to home, with faults on the way.
const ORDERS: [&str; 6] = ["on", "home", "wait ready", "arm", "weld", "wait ready"];

/// What a cell ran on, and how it ended.
struct Ended {
    left: Option<Place>,
    timing: Option<(Footing, Latency)>,
    lines: Lines,
}

pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let loaded = load(&args.job)?;
    let motion = loaded.plan()?;
    let machine = &loaded.machine;
    let asked = Asked { output: &args.output, record: &args.record, json: args.json, from: args.from };
    power_loss::check(args.record.data.as_deref(), args.from)?;
    let devices =
        |work: &Work<'_>| devices::of_machine(&loaded.machine, loaded.folder(), work.values(), &args.fault, args.seed);
    with_work(&loaded, &motion, asked, Vec::new(), devices, |devices, work, desk| {
        real(work, machine, devices, args.cpu, desk)
    })
}

/// `simulate --fault`: the same in virtual time.
pub(super) fn simulate(args: &SimulateArgs) -> Result<(), Failure> {
    let loaded = load(&args.job)?;
    let motion = loaded.plan()?;
    let devices = |_: &Work<'_>| devices::simulated(&loaded.machine, &args.fault, args.seed);
    let lines = ORDERS.iter().filter_map(|line| Line::read(line).ok()).collect();
    let asked = Asked { output: &args.output, record: &args.record, json: args.json, from: None };
    with_work(&loaded, &motion, asked, lines, devices, |mut devices, work, desk| {
        desk.ends();
        let mut executive = Executive::new(&loaded.machine, &mut devices, InOne { desk });
        executive.serve(Some(work));
        let (left, end) = (executive.left(), executive.now());
        for fault in args.fault.iter().filter(|f| matches!(f.when, When::At(t) if t > end)) {
            // Nothing can be done if standard error is closed.
            let _ = writeln!(std::io::stderr(), "note: {fault} never came: everything was over at {end:.1} s");
        }
        Ok(Ended { left, timing: None, lines: Lines::new() })
    })
}

/// A program with more process values than a cell carries.
pub(super) fn too_many(values: usize) -> Failure {
    Failure::Input(format!("the program has {values} process values\n   allowed: up to {VALUES}"))
}

/// Where a run begins and what it leaves.
#[derive(Clone, Copy)]
struct Asked<'a> {
    output: &'a std::path::Path,
    record: &'a RecordArgs,
    json: bool,
    from: Option<Place>,
}

/// The start that is asked for.
fn start(
    loaded: &Loaded,
    around: &Surroundings<'_>,
    motion: &WeldMotion,
    from: Option<Place>,
) -> Result<Start, Failure> {
    let Some(place) = from else { return Ok(Start::at_home(motion)) };
    let length = motion.passes.get(place.pass - 1).map(|pass| pass.path.length());
    if !length.is_some_and(|length| place.s_mm < length) {
        let passes = motion.passes.len();
        let most =
            length.map_or(format!("passes 1 to {passes}"), |length| format!("up to {length:.2} mm in that pass"));
        return Err(Failure::Input(format!(
            "--from {},{}: there is nothing left to weld\n   allowed: {most}",
            place.pass, place.s_mm
        )));
    }
    let home = loaded.machine.home();
    Start::at_place(&loaded.machine, around, motion, &home, place).map_err(|e| Failure::Environment(e.to_string()))
}

/// Connects the devices, opens the desk, lets `cell` run under it, and closes it.
fn with_work<D>(
    loaded: &Loaded,
    motion: &WeldMotion,
    asked: Asked<'_>,
    lines: Vec<Option<Line>>,
    devices: impl FnOnce(&Work<'_>) -> Result<D, Failure>,
    cell: impl FnOnce(D, &Work<'_>, &mut Desk) -> Result<Ended, Failure>,
) -> Result<(), Failure> {
    let program = &loaded.welding.program.value;
    let machine = &loaded.machine;
    loaded.check_count(motion, machine.servo_period_s)?;
    let around = Surroundings::new(machine, &loaded.clamped).map_err(|e| Failure::Input(e.to_string()))?;
    let passes: Vec<&Pass> = program.passes.iter().collect();
    let start = start(loaded, &around, motion, asked.from)?;
    let work = Work::new(machine, Some(&around), &passes, motion, start).map_err(too_many)?;
    // Nothing is written before they answer.
    let devices = devices(&work)?;
    let mut output = Output::new(asked.output)?;
    let table = Table::new((loaded, motion), &output, asked.record, work.values())?;
    let mut desk = Desk::new(machine, table, lines, asked.json);
    let ended = cell(devices, &work, &mut desk)?;
    desk.close(&mut output, &program.title, ended)?;
    output.finish()?;
    desk.judge()
}

/// In real time: the cycle in a thread of its own, the desk here.
fn real(
    work: &Work<'_>,
    machine: &Machine,
    (devices, lines): (Cell, Lines),
    cpu: Option<usize>,
    desk: &mut Desk,
) -> Result<Ended, Failure> {
    let (port, mut outside) = live();
    let typed = typed(outside.urgent());
    let places = desk.journal()?.map(power_loss::writer);
    std::thread::scope(|scope| {
        let cycle = scope.spawn(move || {
            let footing = Footing::ask(cpu);
            let mut paced = Paced { devices, pacer: Pacer::new(machine.servo_period_s) };
            let mut executive = Executive::new(machine, &mut paced as &mut dyn Devices, port);
            executive.serve(Some(work));
            let left = executive.left();
            drop(executive);
            (left, footing, paced.pacer.latency().clone())
        });
        while !cycle.is_finished() {
            look(&mut outside, &typed, desk);
            if let (Some(places), Some(position)) = (&places, desk.position()) {
                // A disk that is slow misses some.
                places.tell(position);
            }
            std::thread::sleep(LOOK);
        }
        look(&mut outside, &typed, desk);
        let (left, footing, latency) =
            cycle.join().map_err(|_| Failure::Environment("the thread of the cycle ended early".to_owned()))?;
        // It ended in order: nothing is left to power failures.
        if let Some(places) = places {
            places.end()?;
        }
        Ok(Ended { left, timing: Some((footing, latency)), lines })
    })
}

/// Takes what the cycle has sent and the operator typed, and gives the next order.
fn look(outside: &mut Outside, typed: &Receiver<String>, desk: &mut Desk) {
    while let Ok(shown) = outside.cycles.pop() {
        desk.shown(&shown);
    }
    while let Ok((t, note)) = outside.notes.pop() {
        desk.noted(t, note);
    }
    loop {
        match typed.try_recv() {
            Ok(line) => desk.typed(&line),
            Err(TryRecvError::Empty) => break,
            Err(TryRecvError::Disconnected) => {
                desk.ends();
                break;
            }
        }
    }
    if let Some(command) = desk.next() {
        // A full queue is one whose commands have not been taken for a while: asked again next time.
        if outside.commands.push(command).is_ok() {
            desk.sent();
        }
    }
    if desk.record_fails() {
        outside.fail();
    }
}

/// Lines of standard input as they come; the channel closes where it ends.
///
/// At a terminal a stop or a hold goes to the executive at once: past orders that wait, and past this program's desk.
fn typed(urgent: Urgent) -> Receiver<String> {
    let (to, from) = channel();
    let terminal = std::io::stdin().is_terminal();
    // It may wait for a line for ever: nobody waits for it.
    std::thread::spawn(move || {
        for line in std::io::stdin().lock().lines().map_while(Result::ok) {
            if let Some(ask) = desk::is_urgent(&line).filter(|_| terminal) {
                urgent.ask(&ask);
            }
            if to.send(line).is_err() {
                break;
            }
        }
    });
    from
}

/// Desk and cycle in one thread, in virtual time.
struct InOne<'a> {
    desk: &'a mut Desk,
}

impl Port for InOne<'_> {
    fn command(&mut self, _t: f64) -> Option<Command> {
        let command = self.desk.next()?;
        self.desk.sent();
        Some(command)
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        self.desk.shown(&Shown::from(cycle));
    }

    fn note(&mut self, t: f64, note: Note) {
        self.desk.noted(t, note);
    }

    fn record_fails(&self) -> bool {
        self.desk.record_fails()
    }
}
