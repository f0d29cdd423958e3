use super::alarms::Mirror;
use super::archive::Archive;
use super::desk::{Desk, Records, ToDesk};
use super::display_distances::{self, Around};
use super::event::happening;
use super::hub::Hub;
use super::names::Names;
use super::progress;
use super::recorder::Recorder;
use super::supervisor::{self, Supervisor};
use super::urgent::Urgent;
use seamwright_cell::protocol::Report;
use seamwright_cell::{CellClient, CellStart, StopLine, fingerprint};
use seamwright_executive::realtime::Shutdown;
use seamwright_machine::Clamped;
use seamwright_message::Message;
use seamwright_record::DataFolder;
use seamwright_record::journal::{Journal, JournalState};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;

pub(crate) struct Cell {
    pub(crate) hub: Arc<Hub>,
    pub(crate) archive: Archive,
    /// Stops and holds, which bypass all queues.
    pub(crate) urgent: Urgent,
    pub(crate) desk: Sender<ToDesk>,
    /// It was found running, with a program.
    pub(crate) has_program: bool,
    thread: Mutex<Option<JoinHandle<Vec<String>>>>,
}

/// Folder of the sockets of a cell whose records go to `data`.
fn sockets(data: &Path) -> PathBuf {
    data.join("cell")
}

impl Cell {
    /// Starts a cell, off and without a program; records go to `data`. It is a process of its own, `program cell`, or
    /// threads of this one without a program.
    /// `shutdown` ends the cell first of all: process off within a cycle, rest, power off.
    ///
    /// # Errors
    /// In words: an unwritable folder, invalid drive values in the machine file, devices that do not answer.
    pub(crate) fn start(
        start: &CellStart,
        data: &Path,
        program: Option<&Path>,
        shutdown: &Shutdown,
    ) -> Result<Self, Message> {
        let machine = start.machine.read()?;
        seamwright_simulation::check_drives(&machine).map_err(|e| e.message())?;
        let mut folder = DataFolder::open(data).map_err(|e| e.message())?;
        // Records of a cell that has outlived its panel are open, or about to be.
        let found = supervisor::found(start, &sockets(data))?;
        let open = match found.as_ref().and_then(CellClient::first) {
            Some(Report::Hello { open, .. }) => open,
            _ => Vec::new(),
        };
        let interrupted = folder.recover_except(&open).map_err(|e| e.message())?;
        // A cell that has outlived its panel may be writing it.
        let JournalState { last, damaged } = Journal::look(data).map_err(|e| e.message())?;
        let lost = folder.lost_welds().map_err(|e| e.message())?;
        let mut last = last;
        if let Some(at) = &last {
            progress::remember(at, folder.library()).map_err(|e| e.message())?;
            let weld = i64::try_from(at.weld).unwrap_or(0);
            if !open.contains(&weld) && progress::is_settled(weld, folder.library()) {
                progress::clear_journal(&folder).map_err(|e| e.message())?;
                last = None;
            }
        }
        let left = progress::newest_left(folder.library()).map_err(|e| e.message())?;
        let unknown = folder.library().listed_alarms().map_err(|e| e.message())?;
        drop(folder);
        let hub = Arc::new(Hub::default());
        hub.set_machine(&machine);
        hub.set_around(Arc::new(Around::new(&machine, &Clamped::default())?));
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
        let urgent = Urgent::start(StopLine::new(&sockets(data))).map_err(|e| Message::outside(&e))?;
        let fingerprint = fingerprint(&machine);
        let names = Names { machine, fingerprint, values: 0, heads: 0 };
        let recorder = Recorder::new(data, Arc::clone(&hub), archive.clone());
        let mirror = Mirror::new(&unknown);
        hub.alarms(mirror.views(&names));
        // Devices come last: nothing is switched before all files are valid.
        let supervisor = Supervisor::start(found, start.clone(), sockets(data), program.map(Path::to_owned))?;
        let has_program = supervisor.has_program();
        let (desk, from) = channel();
        let records = Records { archive: archive.clone(), recorder, mirror, left };
        let listens = Desk::new(Arc::clone(&hub), supervisor, from, names, records);
        let its_shutdown = shutdown.clone();
        let thread = std::thread::spawn(move || listens.run(&its_shutdown));
        let watched = Arc::downgrade(&hub);
        std::thread::spawn(move || display_distances::watch(&watched));
        Ok(Self { hub, archive, urgent, desk, has_program, thread: Mutex::new(Some(thread)) })
    }

    /// Stops, switches the power off, and waits for the end. Returns one line for a cell that could not be replaced, and
    /// for each device that has not confirmed its safe outputs.
    pub(crate) fn end(&self) -> Vec<String> {
        // Sending fails only if the desk has already ended.
        drop(self.desk.send(ToDesk::Quit));
        let thread = self.thread.lock().unwrap_or_else(PoisonError::into_inner).take();
        let Some(thread) = thread else { return Vec::new() };
        let unconfirmed = thread.join().unwrap_or_default();
        self.archive.flush();
        unconfirmed
    }
}
