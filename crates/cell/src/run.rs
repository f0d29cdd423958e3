//! A cell from its start to its end.

use crate::cycle::{self, Swap};
use crate::devices::CellDevices;
use crate::link::{Link, LinkStart};
use crate::loader::Loader;
use crate::machine_source::MachineSource;
use crate::prepared_task::Prepared;
use crate::recorder::Recorder;
use crate::sockets::Listeners;
use crate::stop;
use crate::task::Task;
use seamwright_executive::realtime::{Shutdown, ShutdownCause, live};
use seamwright_message::Message;
use serde::{Deserialize, Serialize};
use std::io::Write as _;
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// Period at which the link looks at both sides.
const LOOK: Duration = Duration::from_millis(1);
/// Maximum time of the cycle to end after a shutdown is requested.
const SHUTDOWN: Duration = Duration::from_secs(15);
/// Capacity of the queues of programs to and from the cycle.
const PROGRAMS: usize = 4;

/// Inputs of a cell's start.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct CellStart {
    /// Its machine.
    pub machine: MachineSource,
    /// Process values of programs to come, for devices that are not simulated.
    pub values: Vec<String>,
}

/// Runs a cell on the devices of its machine, off and without a program, until a panel or `shutdown` ends it. `ready` is
/// called once the devices are connected. Returns false if the cycle panicked or did not end.
///
/// # Errors
/// An invalid machine, devices that do not answer: nothing has been switched then.
pub fn run(
    start: &CellStart,
    listeners: Listeners,
    shutdown: &Shutdown,
    ready: impl FnOnce(),
) -> Result<bool, Message> {
    let machine = start.machine.read()?;
    seamwright_simulation::check_drives(&machine).map_err(|e| e.message())?;
    let task = Prepared::new(Task::Machine(Box::new(machine.clone())), &machine.home(), None);
    let task = Box::new(task.map_err(Message::verbatim)?);
    let fingerprint = task.fingerprint().to_owned();
    // Devices come last: nothing is switched before all else is valid.
    let devices = CellDevices::new(&task, &start.machine.folder, &start.values).map_err(Message::verbatim)?;
    let connection = devices.to().clone();
    let (port, outside) = live(shutdown);
    let _listens = stop::listen(listeners.stop, &outside.urgent()).map_err(|e| Message::outside(&e))?;
    let (next, to_cycle) = rtrb::RingBuffer::new(PROGRAMS);
    let (from_cycle, done) = rtrb::RingBuffer::new(PROGRAMS);
    let rights = Arc::new(OnceLock::new());
    let (its_rights, its_shutdown) = (Arc::clone(&rights), shutdown.clone());
    let cycle = move || {
        let swap = Swap { next: to_cycle, done: from_cycle };
        cycle::run(task, devices, port, swap, &its_rights, &its_shutdown);
    };
    let cycle = std::thread::Builder::new().name("cycle".into()).spawn(cycle).map_err(|e| Message::outside(&e))?;
    let recorder = Recorder::start(Arc::new(machine.clone())).map_err(|e| Message::outside(&e))?;
    let mut link = Link::new(LinkStart {
        listener: listeners.panel,
        outside,
        next,
        done,
        rights,
        connection,
        loader: Loader::new(machine.devices.clone(), start.machine.folder.clone()),
        panel_lost: machine.on_panel_lost,
        machine: fingerprint,
        shutdown: shutdown.clone(),
        recorder,
    });
    ready();
    let mut asked: Option<Instant> = None;
    while !cycle.is_finished() {
        link.step();
        if shutdown.is_requested() && asked.get_or_insert_with(Instant::now).elapsed() > SHUTDOWN {
            print(&Message::new("cell-does-not-end"));
            break;
        }
        std::thread::sleep(LOOK);
    }
    let failed = !cycle.is_finished() || shutdown.cause() == Some(ShutdownCause::Panic);
    link.end(failed);
    Ok(!failed)
}

/// Prints an error of the cell, for the log of its service. Errors of that are ignored: standard error may be closed.
pub(crate) fn print(message: &Message) {
    let _ = writeln!(std::io::stderr(), "{}", Message::new("cli-error").message("error", message.clone()));
}
