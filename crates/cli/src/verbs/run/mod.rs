//! A job on a running cell, in real time under an operator's orders.

pub(super) mod desk;
pub(super) mod orders;
mod table;

use crate::args::records::RecordArgs;
use crate::args::run::RunArgs;
use crate::planning;
use crate::refusals::refused;
use crate::verbs::simulated_part;
use desk::Desk;
use seamwright_executive::realtime::{
    Latency, Outside, Paced, RealtimeRights, Shutdown, ShutdownCause, Urgent, guarded, live,
};
use seamwright_executive::tracking::Tracking;
use seamwright_executive::{Devices, Executive, Place, Start, Work};
use seamwright_machine::{Machine, Surroundings};
use seamwright_message::{Message, Unit};
use seamwright_motion::WeldMotion;
use seamwright_program::is_before;
use seamwright_project::devices::{self, Lines};
use seamwright_project::failure::Failure;
use seamwright_project::files::Output;
use seamwright_project::load::Loaded;
use seamwright_project::power_loss;
use seamwright_simulation::SimulatedCell;
use seamwright_simulation::devices::Fault;
use std::io::{BufRead as _, IsTerminal as _, Write as _};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::OnceLock;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread::ScopedJoinHandle;
use std::time::{Duration, Instant};
use table::{Content, Table};

/// Period at which the desk reads the cycle's data.
const LOOK: Duration = Duration::from_millis(5);
/// After a signal the cycle has this long to bring everything to rest and its devices to their safe states.
const SHUTDOWN: Duration = Duration::from_secs(15);

/// RealtimeRights of a cell, and its end.
pub(super) struct Ended {
    pub(super) left: Option<Place>,
    pub(super) timing: Option<(RealtimeRights, Latency)>,
    pub(super) lines: Lines,
}

pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let loaded = planning::load(&args.job, &args.planning)?;
    let part = simulated_part::read(&args.part)?;
    let around = loaded.surroundings()?;
    let conditions = part.conditions(args.seed, &args.fault, &around);
    part.check_devices(&loaded.machine)?;
    devices::check_period(&loaded.machine)?;
    let motion = planning::plan_part(&part, &loaded, &args.planning)?;
    power_loss::check(args.record.data.as_deref(), args.from)?;
    let paths = loaded.paths();
    let cell = SimulatedCell::new(&loaded.machine, loaded.passes(&paths), &motion, conditions);
    let asked = Asked {
        output: &args.output,
        record: &args.record,
        json: args.json,
        from: args.from,
        cpu: args.cpu,
        faults: (&args.fault, args.seed),
    };
    with_cell(&loaded, &motion, &around, &cell, asked)
}

/// Start and outputs of a run.
#[derive(Clone, Copy)]
struct Asked<'a> {
    output: &'a std::path::Path,
    record: &'a RecordArgs,
    json: bool,
    from: Option<Place>,
    cpu: Option<usize>,
    /// Of the devices, and the seed of simulated ones.
    faults: (&'a [Fault], u64),
}

/// Reports how late cycles were, if some were missed.
fn report_missed(ended: &Ended, period_s: f64) {
    let Some((_, latency)) = ended.timing.as_ref().filter(|(_, latency)| latency.missed() > 0) else { return };
    let (missed, all) = (latency.missed(), latency.missed() + latency.count());
    let note = Message::new("cli-run-missed")
        .number("missed", missed as f64, 0)
        .count("cycles", all as usize)
        .value("period", 1e3 * period_s, Unit::Ms)
        .quantity("late", 1e-3 * latency.most_us(), Unit::Ms, 2);
    let cure = Message::new("cli-run-missed-cure");
    // Errors are ignored: standard error may be closed.
    let _ = writeln!(std::io::stderr(), "{note}\n   {cure}");
}

fn start(
    loaded: &Loaded,
    around: &Surroundings<'_>,
    motion: &WeldMotion,
    from: Option<Place>,
) -> Result<Start, Failure> {
    let Some(place) = from else { return Ok(Start::at_home(motion)) };
    let length = motion.passes.get(place.pass - 1).map(|pass| pass.path.length());
    if !length.is_some_and(|length| is_before(place.s_mm, length)) {
        let allowed = match length {
            Some(length) => Message::new("cli-run-up-to-in-pass").quantity("length", length, Unit::Mm, 2),
            None => Message::new("cli-run-passes-up-to").number("passes", motion.passes.len() as f64, 0),
        };
        let asked = format!("{},{}", place.pass, place.s_mm);
        return Err(refused("--from", asked, Message::new("cli-run-nothing-left"), allowed));
    }
    let home = loaded.machine.home();
    Start::at_place(&loaded.machine, around, motion, &home, place)
        .map_err(|e| Failure::environment(Message::outside(&e)))
}

/// Opens the desk, runs the cell under it, and closes it.
fn with_cell(
    loaded: &Loaded,
    motion: &WeldMotion,
    around: &Surroundings<'_>,
    cell: &SimulatedCell<'_>,
    asked: Asked<'_>,
) -> Result<(), Failure> {
    let machine = &loaded.machine;
    let work = cell.work(start(loaded, around, motion, asked.from)?).map_err(|e| bad(&e))?;
    let tracking = cell.tracking(asked.from.unwrap_or_default()).map_err(|e| bad(&e))?;
    // From here on there are devices that must be left in a safe state.
    let shutdown = Shutdown::default();
    shutdown.on_signals()?;
    shutdown.on_panic();
    // The devices must answer before files are written.
    let (devices, lines) = devices(loaded, cell, &work, asked)?;
    let equipment = Equipment { devices, lines, tracking };
    let mut output = Output::new(asked.output)?;
    let content = Content { values: work.values(), is_tracked: equipment.tracking.is_some(), from: asked.from };
    let table = Table::new(loaded, motion, &output, asked.record, content)?;
    let mut desk = Desk::new(machine, Some(table), Vec::new(), asked.json);
    let ended = real(work, machine, equipment, asked.cpu, &shutdown, &mut desk)?;
    let closed = desk.close(&mut output, &loaded.welding.program.value.title, &ended);
    // Outputs that may be on are reported before unwritable files.
    check_safe(&ended.lines)?;
    output.finish()?;
    report_missed(&ended, machine.servo_period_s);
    closed?;
    desk.judge()
}

/// Fails if a device has not confirmed that its outputs are safe.
fn check_safe(lines: &Lines) -> Result<(), Failure> {
    for (name, line) in lines {
        // A device without an answer counts as one whose outputs are on.
        let safe = line.get().safe.unwrap_or_else(|| Err(Message::new("cli-run-not-asked")));
        if let Err(why) = safe {
            let unsafe_outputs = Message::new("cli-run-outputs-unsafe").text("device", name).message("why", why);
            let lines = Message::new("cli-two-lines").message("first", unsafe_outputs);
            return Err(Failure::environment(lines.message("second", Message::new("cli-run-look-at-once"))));
        }
    }
    Ok(())
}

/// The devices that the machine file names; simulated ones by default.
fn devices<'a>(
    loaded: &Loaded,
    cell: &'a SimulatedCell<'_>,
    work: &Work<'_>,
    asked: Asked<'_>,
) -> Result<(Box<dyn Devices + Send + 'a>, Lines), Failure> {
    let machine = &loaded.machine;
    if machine.devices.is_empty() {
        return Ok((Box::new(cell.devices().map_err(|e| bad(&e))?), Lines::new()));
    }
    let (faults, seed) = asked.faults;
    let (devices, lines) = devices::of_machine(machine, loaded.folder(), work.values(), faults, seed)?;
    Ok((Box::new(devices), lines))
}

pub(in crate::verbs) fn bad(error: &seamwright_simulation::Error) -> Failure {
    Failure::input(error)
}

/// Devices of a cell with their lines, and its tracking if its joints are tracked.
struct Equipment<'a> {
    devices: Box<dyn Devices + Send + 'a>,
    lines: Lines,
    tracking: Option<Tracking<'a>>,
}

/// In real time: the cycle in a thread of its own, the desk here.
fn real(
    work: Work<'_>,
    machine: &Machine,
    equipment: Equipment<'_>,
    cpu: Option<usize>,
    shutdown: &Shutdown,
    desk: &mut Desk,
) -> Result<Ended, Failure> {
    let Equipment { devices, lines, mut tracking } = equipment;
    let (port, mut outside) = live(shutdown);
    let typed = typed(outside.urgent());
    let footing = OnceLock::new();
    let places = desk.journal()?.map(power_loss::writer);
    std::thread::scope(|scope| {
        let granted = &footing;
        let cycle = scope.spawn(move || {
            let footing = granted.get_or_init(|| RealtimeRights::ask(cpu)).clone();
            let mut paced = Paced::supervised(devices, machine, shutdown);
            let left = guarded(&mut paced, shutdown, |paced| {
                let guide = tracking.as_mut().map(|tracking| tracking as _);
                let mut executive = Executive::new(machine, paced as &mut dyn Devices, port).with_guide(guide);
                executive.serve(Some(&work));
                executive.left()
            });
            let latency = paced.pacer.latency().clone();
            // Until here real devices may be out of their safe states.
            drop(paced);
            (left, footing, latency)
        });
        let listened = catch_unwind(AssertUnwindSafe(|| {
            let mut waits = None;
            let mut known = false;
            while !cycle.is_finished() {
                if let Some(footing) = footing.get().filter(|_| !known) {
                    known = true;
                    desk.granted(footing);
                }
                look(&mut outside, &typed, desk);
                if let (Some(places), Some(position)) = (&places, desk.position()) {
                    // A disk that is slow misses some.
                    places.tell(position);
                }
                if shutdown.cause() == Some(ShutdownCause::CycleStopped) {
                    // Reported at once: the cycle may never end.
                    desk.ended_by(ShutdownCause::CycleStopped);
                }
                give_up_late(shutdown, &mut waits);
                std::thread::sleep(LOOK);
            }
            look(&mut outside, &typed, desk);
        }));
        if listened.is_err() {
            wait_for_end(&cycle, shutdown);
        }
        let (left, footing, latency) =
            cycle.join().map_err(|_| Failure::environment(Message::new("cli-cycle-ended-early")))?;
        if let Some(cause) = shutdown.cause() {
            desk.ended_by(cause);
        }
        // It ended in order: the journal needs no entry.
        if let Some(places) = places.filter(|_| left.is_ok()) {
            places.end()?;
        }
        Ok(Ended { left: left.unwrap_or(None), timing: Some((footing, latency)), lines })
    })
}

fn wait_for_end<T>(cycle: &ScopedJoinHandle<'_, T>, shutdown: &Shutdown) {
    let mut waits = None;
    while !cycle.is_finished() {
        give_up_late(shutdown, &mut waits);
        std::thread::sleep(LOOK);
    }
}

/// Ends the process where the cycle does not come to its end: it hangs in a device. Those that have a thread or a watchdog of
/// their own have left the process off by then.
fn give_up_late(shutdown: &Shutdown, waits: &mut Option<Instant>) {
    let Some(cause) = shutdown.cause() else { return };
    if waits.get_or_insert_with(Instant::now).elapsed() < SHUTDOWN {
        return;
    }
    // Errors are ignored: standard error may be closed.
    let hangs = Message::new("cli-run-hangs").message("cause", cause.message());
    let hangs = hangs.quantity("time", SHUTDOWN.as_secs_f64(), Unit::S, 0);
    let error = Message::new("cli-error").message("error", hangs);
    let _ = writeln!(std::io::stderr(), "{error}\n   {}", Message::new("cli-run-record-later"));
    std::process::exit(3);
}

/// Reads the data of the cycle and the lines of the operator, and gives the next order.
fn look(outside: &mut Outside, typed: &Receiver<String>, desk: &mut Desk) {
    while let Ok(shown) = outside.cycles.pop() {
        desk.shown(&shown);
    }
    while let Ok((t, note)) = outside.notes.pop() {
        desk.handle_note(t, note);
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
        // In a full queue the commands have not been taken for a while: the next look tries again.
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
    // It may wait for a line for ever, so the thread is not joined.
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
