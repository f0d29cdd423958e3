use super::alarms::Mirror;
use super::archive::Archive;
use super::connection::CellDevices;
use super::cycle::{self, Swap};
use super::desk::{Desk, Queues, Records, ToDesk};
use super::display_distances::{self, Around};
use super::event::happening;
use super::hub::Hub;
use super::names::Names;
use super::prepared_task::Prepared;
use super::progress;
use super::recorder::Recorder;
use super::safe_outputs::SafeOutputs;
use super::task::Task;
use seamwright_executive::realtime::{Shutdown, Urgent, live};
use seamwright_machine::{Clamped, Machine, MachineDevices};
use seamwright_message::Message;
use seamwright_record::DataFolder;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread::JoinHandle;

/// Capacity of the queues of programs to and from the cycle.
const PROGRAMS: usize = 4;

pub(crate) struct Cell {
    pub(crate) hub: Arc<Hub>,
    pub(crate) archive: Archive,
    /// Stops and holds, which bypass all queues.
    pub(crate) urgent: Urgent,
    pub(crate) desk: Sender<ToDesk>,
    /// Real devices that jobs may use, and the folder of their paths: those of the machine at the start, chosen by the
    /// user who started the panel.
    pub(crate) devices: (MachineDevices, PathBuf),
    safe_outputs: SafeOutputs,
    thread: Mutex<Option<JoinHandle<()>>>,
}

impl Cell {
    /// Starts a cell on the devices of `machine`, off and without a program; records go to `data`. Paths in the machine
    /// file are relative to `beside`. `values` are the process values of later programs, for devices that are not
    /// simulated.
    /// `shutdown` ends the cell first of all: process off within a cycle, rest, power off.
    ///
    /// # Errors
    /// In words: an unwritable folder, invalid drive values in the machine file, devices that do not answer.
    pub(crate) fn start(
        machine: &Machine,
        beside: &Path,
        values: &[String],
        data: &Path,
        shutdown: &Shutdown,
    ) -> Result<Self, Message> {
        seamwright_simulation::check_drives(machine).map_err(|e| e.message())?;
        let mut folder = DataFolder::open(data).map_err(|e| e.message())?;
        let interrupted = folder.recover().map_err(|e| e.message())?;
        let journal = folder.journal().map_err(|e| e.message())?;
        let (last, damaged) = (journal.last(), journal.is_damaged());
        drop(journal);
        let lost = folder.lost_welds().map_err(|e| e.message())?;
        if let Some(at) = &last {
            progress::remember(at, folder.library()).map_err(|e| e.message())?;
        }
        let left = progress::newest_left(folder.library()).map_err(|e| e.message())?;
        let unknown = folder.library().listed_alarms().map_err(|e| e.message())?;
        drop(folder);
        let hub = Arc::new(Hub::default());
        hub.set_machine(machine);
        hub.set_around(Arc::new(Around::new(machine, &Clamped::default())?));
        for weld in &interrupted {
            hub.count_weld(weld.weld.result);
            hub.event(
                0.0,
                happening(Message::new("server-event-record-interrupted").number("weld", weld.weld.id as f64, 0)),
            );
        }
        if let Some(at) = &last {
            hub.event(0.0, happening(Message::new("server-event-left-before").number("weld", at.weld as f64, 0)));
        }
        if damaged {
            hub.event(0.0, happening(Message::new("server-event-journal-damaged")));
        }
        for weld in &lost {
            hub.event(0.0, happening(Message::new("server-event-weld-lost").text("weld", weld.to_string())));
        }
        for alarm in &unknown {
            let message = Message::new("server-event-alarm-before").message("alarm", alarm.name.clone());
            hub.event(0.0, happening(message.text("time", alarm.raised.to_string())));
        }
        let archive = Archive::open(data, Arc::clone(&hub)).map_err(|e| e.message())?;
        let (port, outside) = live(shutdown);
        let urgent = outside.urgent();
        let (next, to_cycle) = rtrb::RingBuffer::new(PROGRAMS);
        let (from_cycle, done) = rtrb::RingBuffer::new(PROGRAMS);
        let task = Box::new(Prepared::new(Task::Machine(Box::new(machine.clone())), &machine.home(), None)?);
        let fingerprint = task.fingerprint().to_owned();
        // Devices come last: nothing is switched before all files are valid.
        let devices = CellDevices::new(&task, beside, values)?;
        hub.set_connection(devices.to());
        let footing = Arc::new(OnceLock::new());
        let (its_footing, its_shutdown) = (Arc::clone(&footing), shutdown.clone());
        let cycle = std::thread::spawn(move || {
            let swap = Swap { next: to_cycle, done: from_cycle };
            cycle::run(task, devices, port, swap, &its_footing, &its_shutdown);
        });
        let (desk, from) = channel();
        let names = Names { machine: machine.clone(), fingerprint, values: 0, heads: 0 };
        let recorder = Recorder::new(data, Arc::clone(&hub), archive.clone());
        let mirror = Mirror::new(&unknown);
        hub.alarms(mirror.views(&names));
        let queues = Queues { outside, next, done };
        let records = Records { archive: archive.clone(), recorder, mirror, left };
        let listens = Desk::new(Arc::clone(&hub), queues, from, names, records, footing);
        let safe_outputs = listens.safe_outputs.clone();
        let its_shutdown = shutdown.clone();
        let thread = std::thread::spawn(move || listens.run(|| cycle.is_finished(), &its_shutdown));
        let watched = Arc::downgrade(&hub);
        std::thread::spawn(move || display_distances::watch(&watched));
        let devices = (machine.devices.clone(), beside.to_owned());
        Ok(Self { hub, archive, urgent, desk, devices, safe_outputs, thread: Mutex::new(Some(thread)) })
    }

    /// Stops, switches the power off, and waits for the end. Returns one line for each device that has not confirmed
    /// its safe outputs.
    pub(crate) fn end(&self) -> Vec<String> {
        // Sending fails only if the desk has already ended.
        drop(self.desk.send(ToDesk::Quit));
        let thread = self.thread.lock().unwrap_or_else(PoisonError::into_inner).take();
        let Some(thread) = thread else { return Vec::new() };
        drop(thread.join());
        let to = self.hub.connection();
        let unconfirmed = self.safe_outputs.end(to.as_ref());
        self.archive.flush();
        unconfirmed
    }
}
