//! The link of a cell with its panel: one thread, which never waits for the panel.

use crate::devices::Connection;
use crate::frame::{Inbox, Outbox};
use crate::loader::{CellNow, Loader, Step};
use crate::prepared_task::Prepared;
use crate::program::Program;
use crate::protocol::{MAX_REQUEST, PANEL_LOST_S, Report, Request, Unprepared, VERSION};
use crate::recorder::{RecordNews, Recorder};
use crate::resting::Resting;
use crate::safe_outputs::SafeOutputs;
use rtrb::{Consumer, Producer, PushError};
use seamwright_executive::realtime::{Outside, QueueFill, RealtimeRights, Shown, Shutdown, ShutdownCause, Urgent};
use seamwright_executive::{AlarmList, Ask, Command, Mode, Note, Origin};
use seamwright_machine::{Machine, PanelLost};
use seamwright_message::Message;
use std::collections::VecDeque;
use std::io;
use std::os::unix::net::{UnixListener, UnixStream};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// Bytes that wait for the panel beyond which cycles are left out, and beyond which it is disconnected.
const MAX_WAITING_FOR_CYCLES: usize = 2 << 20;
const MAX_WAITING: usize = 16 << 20;
/// Maximum number of commands that wait for the cycle.
const MAX_COMMANDS: usize = 512;
/// Period of the report on device traffic.
const LINES: Duration = Duration::from_millis(200);
/// The cell switches off and ends without a panel for this long, once nothing moves.
const ABANDONED: Duration = Duration::from_secs(60);
/// Maximum time of the disk to take the last rows of records.
const SAVES: Duration = Duration::from_secs(10);
/// Maximum time of the panel to read the last reports.
const LAST_REPORTS: Duration = Duration::from_secs(2);
/// Number in the command of a load that only releases devices; programs count from 1.
const RELEASES: u32 = 0;

/// The panel's end of the socket.
struct Panel {
    stream: UnixStream,
    inbox: Inbox,
    outbox: Outbox,
    heard: Instant,
    greeted: bool,
    knows_rights: bool,
}

/// Ends of the queues of the cycle, and what the link needs to know of the cell.
pub(crate) struct LinkStart {
    pub(crate) listener: UnixListener,
    pub(crate) outside: Outside,
    pub(crate) next: Producer<Box<Prepared>>,
    pub(crate) done: Consumer<Box<Prepared>>,
    pub(crate) rights: Arc<OnceLock<RealtimeRights>>,
    pub(crate) connection: Connection,
    pub(crate) loader: Loader,
    pub(crate) panel_lost: PanelLost,
    pub(crate) machine: String,
    pub(crate) shutdown: Shutdown,
    pub(crate) recorder: Recorder,
}

/// A task that the cycle has not yet taken.
struct Pending {
    /// Number of its program.
    number: u32,
    /// Its own devices, if it brings some.
    connection: Option<Connection>,
    machine: Arc<Machine>,
    /// See [`crate::fingerprint`].
    fingerprint: String,
}

pub(crate) struct Link {
    start: LinkStart,
    urgent: Urgent,
    panel: Option<Panel>,
    commands: VecDeque<Command>,
    pending: Option<Pending>,
    /// The last program that was sent, and the one that the cycle has.
    sent: Option<Box<Program>>,
    program: Option<Box<Program>>,
    alarms: AlarmList,
    releases: SafeOutputs,
    now: Option<Shown>,
    resting: Resting,
    /// Fill of the queues, the maximum since the last report.
    queues: Vec<QueueFill>,
    lines_sent: Instant,
    /// Start of the time without a panel; `None` with a panel.
    alone: Option<Instant>,
    /// The loss of the panel has been answered.
    is_answered: bool,
}

impl Link {
    pub(crate) fn new(start: LinkStart) -> Self {
        let urgent = start.outside.urgent();
        Self {
            start,
            urgent,
            panel: None,
            commands: VecDeque::new(),
            pending: None,
            sent: None,
            program: None,
            alarms: AlarmList::default(),
            releases: SafeOutputs::new(),
            now: None,
            resting: Resting::default(),
            queues: Vec::new(),
            lines_sent: Instant::now(),
            alone: Some(Instant::now()),
            is_answered: false,
        }
    }

    /// Handles what has come from both sides.
    pub(crate) fn step(&mut self) {
        // The end of a connection is heard before the next one is accepted.
        self.hear();
        self.accept();
        self.pass_on();
        self.prepare();
        self.report_devices();
        self.report_record();
        self.watch_panel();
        while let Some(command) = self.commands.front() {
            if self.start.outside.commands.push(*command).is_err() {
                break;
            }
            self.commands.pop_front();
        }
        self.flush();
    }

    /// Reports the end of the cell, whose cycle has ended; waits some seconds for the panel to read it.
    pub(crate) fn end(mut self, failed: bool) {
        self.pass_on();
        self.report(&Report::Ending);
        self.flush();
        self.releases.wait();
        let main = self.start.connection.clone();
        let last: Vec<_> = self.releases.come().chain(crate::safe_outputs::released(&main)).collect();
        for (device, outcome) in last {
            self.report_release(device, outcome);
        }
        for news in self.start.recorder.close(SAVES) {
            self.tell_record(news);
        }
        for weld in self.start.recorder.open() {
            crate::run::print(&Message::new("cell-record-not-saved").number("weld", *weld as f64, 0));
        }
        self.report(&Report::Ended { failed });
        // A socket that is closed with unread requests takes the last reports with it: the panel closes first.
        let begin = Instant::now();
        while self.panel.is_some() && begin.elapsed() < LAST_REPORTS {
            self.flush();
            if self.requests().is_err() {
                self.lose();
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    fn accept(&mut self) {
        let Ok((stream, _)) = self.start.listener.accept() else { return };
        // A second panel is turned away: it sees the end of its connection.
        if self.panel.is_some() || stream.set_nonblocking(true).is_err() {
            return;
        }
        let (inbox, outbox) = (Inbox::default(), Outbox::default());
        self.panel = Some(Panel { stream, inbox, outbox, heard: Instant::now(), greeted: false, knows_rights: false });
        self.alone = None;
        self.is_answered = false;
        let (machine, program) = (self.start.machine.clone(), self.program.clone());
        let alarms = self.alarms.iter().copied().collect();
        let welds = self.now.is_some_and(|now| matches!(now.mode, Mode::Weld | Mode::Hold));
        let (start, recording) = self.start.recorder.last();
        self.report(&Report::Hello {
            version: VERSION,
            process: std::process::id(),
            machine,
            program,
            alarms,
            recording,
            unrecorded: (welds && recording.is_none()).then_some(start),
            open: self.start.recorder.open().to_vec(),
        });
    }

    fn report(&mut self, report: &Report) {
        if let Some(panel) = &mut self.panel
            && (panel.outbox.push(report).is_err() || panel.outbox.waiting() > MAX_WAITING)
        {
            self.lose();
        }
    }

    fn flush(&mut self) {
        let Some(panel) = &mut self.panel else { return };
        if panel.outbox.flush(&mut panel.stream).is_err() {
            self.lose();
        }
    }

    fn lose(&mut self) {
        self.panel = None;
        self.alone.get_or_insert_with(Instant::now);
    }

    /// Reads and handles the panel's requests.
    fn hear(&mut self) {
        match self.requests() {
            Ok(requests) => requests.into_iter().for_each(|request| self.handle(request)),
            Err(_) => self.lose(),
        }
    }

    fn requests(&mut self) -> io::Result<Vec<Request>> {
        let Some(panel) = &mut self.panel else { return Ok(Vec::new()) };
        let open = panel.inbox.read(&mut panel.stream)?;
        let mut requests = Vec::new();
        while let Some(request) = panel.inbox.next(MAX_REQUEST)? {
            panel.heard = Instant::now();
            match request {
                Request::Hello { version: VERSION } => panel.greeted = true,
                request if panel.greeted => requests.push(request),
                _ => return Err(io::ErrorKind::InvalidData.into()),
            }
        }
        // Requests before the end count; the end is seen once more by the next read.
        if open || !requests.is_empty() { Ok(requests) } else { Err(io::ErrorKind::UnexpectedEof.into()) }
    }

    fn handle(&mut self, request: Request) {
        match request {
            Request::Hello { .. } | Request::Beat => {}
            Request::Command(command) if matches!(command.ask, Ask::Load) => {}
            Request::Command(command) if self.commands.len() < MAX_COMMANDS => self.commands.push_back(command),
            // The cycle takes one a period: so many wait only if it stands, and then the panel replaces this cell.
            Request::Command(_) => {}
            Request::Load(program) => {
                let number = program.number;
                let now = cell_now(&self.start.connection, self.now.as_ref());
                let begun = match self.pending {
                    Some(_) => Err(Unprepared::Busy),
                    None => self.start.loader.begin((*program).clone(), &now),
                };
                match begun {
                    Ok(()) => self.sent = Some(program),
                    Err(why) => self.report(&Report::Prepared { number, outcome: Err(why) }),
                }
            }
            Request::Record(start) => self.start.recorder.begin(start),
            Request::NoRecord { start } => self.record_fails(start),
            Request::Shutdown => self.start.shutdown.request(ShutdownCause::Asked),
        }
    }

    /// Passes notes and cycles on.
    fn pass_on(&mut self) {
        self.look_at_queues();
        while let Ok(mut done) = self.start.done.pop() {
            if let Some(devices) = done.devices.take() {
                self.releases.release(devices);
            }
        }
        while let Ok((t, note)) = self.start.outside.notes.pop() {
            if let Note::Taken(command) | Note::Refused(command, _) = note
                && command.ask == Ask::Load
            {
                self.loaded(command.number, matches!(note, Note::Taken(_)));
                if command.number == RELEASES {
                    continue;
                }
            }
            self.alarms.follow(&note);
            let start = self.start.recorder.note(t, &note);
            self.report(&Report::Note((t, note)));
            if let Some(start) = start {
                // Trouble of the record before has been reported; this one is complete so far.
                self.start.outside.mend();
                self.report(&Report::WeldBegins { start });
            }
        }
        while let Ok(shown) = self.start.outside.cycles.pop() {
            if !self.start.recorder.cycle(&shown) {
                self.start.outside.fail();
            }
            let Some(shown) = self.resting.pass(shown) else { continue };
            match self.panel.as_ref().map(|panel| panel.outbox.waiting()) {
                Some(waiting) if waiting < MAX_WAITING_FOR_CYCLES => self.report(&Report::Cycle(Box::new(shown))),
                // The record has the others all the same.
                Some(_) | None => {}
            }
            self.now = Some(shown);
        }
    }

    fn look_at_queues(&mut self) {
        let now = self.start.outside.queues();
        for (fill, before) in self.queues.iter_mut().zip(now.iter()) {
            fill.waiting = fill.waiting.max(before.waiting);
        }
        if self.queues.is_empty() {
            self.queues = now.to_vec();
        }
    }

    /// The cycle has taken or refused a task.
    fn loaded(&mut self, number: u32, taken: bool) {
        let Some(pending) = self.pending.take_if(|pending| pending.number == number) else { return };
        if taken {
            (self.start.panel_lost, self.start.machine) = (pending.machine.on_panel_lost, pending.fingerprint);
            self.start.recorder.program(pending.machine);
            if let Some(connection) = pending.connection {
                self.start.connection = connection;
            }
            if number == RELEASES {
                self.program = None;
                self.report(&Report::DevicesReleased);
            } else {
                self.program = self.sent.take();
            }
        }
    }

    fn prepare(&mut self) {
        if self.pending.is_some() {
            return;
        }
        let now = cell_now(&self.start.connection, self.now.as_ref());
        match self.start.loader.step(&now) {
            Step::Wait => {}
            // If the cycle does not take it, the devices are not released in time, which the loader reports.
            Step::Release(bare) => drop(self.give(RELEASES, bare)),
            Step::Give(number, prepared) => {
                let outcome = self.give(number, prepared);
                self.report(&Report::Prepared { number, outcome });
            }
            Step::Refuse(number, why) => {
                self.sent = None;
                self.report(&Report::Prepared { number, outcome: Err(why) });
            }
        }
    }

    fn give(&mut self, number: u32, prepared: Box<Prepared>) -> Result<(), Unprepared> {
        let connection = prepared.devices.as_ref().map(|devices| devices.to().clone());
        let (machine, fingerprint) = (Arc::new(prepared.machine().clone()), prepared.fingerprint().to_owned());
        if let Err(PushError::Full(mut prepared)) = self.start.next.push(prepared) {
            // The cycle stands.
            if let Some(devices) = prepared.devices.take() {
                self.releases.release(devices);
            }
            return Err(Unprepared::Busy);
        }
        self.pending = Some(Pending { number, connection, machine, fingerprint });
        self.commands.push_back(Command { origin: Origin::default(), number, ask: Ask::Load });
        Ok(())
    }

    fn report_devices(&mut self) {
        let released: Vec<_> = self.releases.come().collect();
        for (device, outcome) in released {
            self.report_release(device, outcome);
        }
        if let Some(panel) = &mut self.panel
            && !panel.knows_rights
            && let Some(rights) = self.start.rights.get()
        {
            panel.knows_rights = true;
            self.report(&Report::Rights(rights.clone()));
        }
        if self.panel.is_some() && self.lines_sent.elapsed() >= LINES {
            self.lines_sent = Instant::now();
            let lines = self.start.connection.lines.iter().map(|(name, line)| (name.clone(), line.get()));
            self.report(&Report::Lines(lines.collect()));
            let queues = std::mem::take(&mut self.queues);
            self.report(&Report::Queues(queues));
        }
    }

    fn report_record(&mut self) {
        while let Some(news) = self.start.recorder.news() {
            self.tell_record(news);
        }
    }

    fn tell_record(&mut self, news: RecordNews) {
        match news {
            RecordNews::Ended(weld) => self.report(&Report::Recorded { weld }),
            RecordNews::Fails(start, why) => {
                self.record_fails(start);
                self.report(&Report::RecordFails { why });
            }
        }
    }

    /// The record of the weld with this start fails: an alarm, if that weld is the last one.
    fn record_fails(&self, start: u64) {
        if self.start.recorder.last().0 == start {
            self.start.outside.fail();
        }
    }

    fn report_release(&mut self, device: String, outcome: Result<(), Message>) {
        if let Err(why) = &outcome {
            let message = Message::new("cell-outputs-unconfirmed").text("device", &device);
            crate::run::print(&message.message("why", why.clone()));
        }
        self.report(&Report::Released { device, outcome });
    }

    /// Stops jogging, and holds a program unless its machine's file lets it go on, once the panel has gone or is silent.
    fn watch_panel(&mut self) {
        let silent = self.panel.as_ref().is_some_and(|panel| panel.heard.elapsed().as_secs_f64() > PANEL_LOST_S);
        if !silent && self.panel.is_some() {
            self.is_answered = false;
            return;
        }
        let Some(now) = &self.now else { return };
        if !self.is_answered {
            self.is_answered = true;
            match (now.mode, self.start.panel_lost) {
                (Mode::Weld | Mode::DryRun, PanelLost::Hold) => drop(self.urgent.ask(&Ask::Hold)),
                (Mode::Jog | Mode::Teach | Mode::Homing, _) => drop(self.urgent.ask(&Ask::Stop)),
                _ => {}
            }
        }
        let rests = !now.mode.moves() && now.phase.is_none();
        if rests && self.alone.is_some_and(|since| since.elapsed() > ABANDONED) {
            self.start.shutdown.request(ShutdownCause::Asked);
        }
    }
}

fn cell_now<'a>(connection: &'a Connection, now: Option<&Shown>) -> CellNow<'a> {
    // Without references the positions mean nothing.
    let is_referenced =
        |shown: &&Shown| (0..connection.axes).all(|axis| shown.reports.drives.referenced >> axis & 1 == 1);
    CellNow {
        connection,
        at: now.filter(is_referenced).map(|shown| std::array::from_fn(|i| shown.orders.set[i].position)),
        is_off: now.is_none_or(|shown| shown.mode == Mode::Off),
    }
}
