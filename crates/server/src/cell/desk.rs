use super::alarms::Mirror;
use super::archive::Archive;
use super::display_distances::Around;
use super::event::{Happening, happening};
use super::hub::Hub;
use super::names::{Extra, Names};
use super::own_connection::OwnConnection;
use super::progress::{Left, Parts, Progress, ToWeld};
use super::recorder::Recorder;
use super::standstill::Stillness;
use super::supervisor::{News, Supervisor};
use super::tally::Tally;
use super::unavailable_commands::Readiness;
use crate::refusal::{Lack, lack};
use crate::service_manager;
use crate::wire::{FromCell, Shelving, WorkView};
use seamwright_cell::Program;
use seamwright_cell::protocol::{Report, Request, Unprepared};
use seamwright_executive::realtime::{RealtimeRights, Shown, Shutdown};
use seamwright_executive::{Ask, Command, Missing, Mode};
use seamwright_log as log;
use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_record::{DataFolder, Plan};
use std::collections::{BTreeMap, HashMap, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError};
use std::time::{Duration, Instant};
use tokio::sync::oneshot;

/// Polling period for messages of the cycle.
const LOOK: Duration = Duration::from_millis(2);
/// Period of status updates to clients.
const SHOW: Duration = Duration::from_micros(33_333);

/// Maximum time of the cycle to end after a signal or a panic; then the desk ends without it.
const SHUTDOWN: Duration = Duration::from_secs(15);

/// Period of reports to the service manager.
const REPORT: Duration = Duration::from_secs(1);
/// Maximum number of commands that wait for the cycle.
const WAITING: usize = 512;

pub(crate) enum ToDesk {
    /// A command for the executive.
    Command(Command),
    /// Start of a weld whose finished passes may be welded again: the operator confirmed.
    Reweld(Command),
    /// Loads another program.
    Load(Box<Loading>, Loaded),
    /// Shelves or unshelves an alarm, by a user.
    Shelve(Shelving, String, oneshot::Sender<Result<(), Message>>),
    /// Switches everything off, then ends.
    Quit,
}

/// A program to be loaded into the cell.
pub(crate) struct Loading {
    /// For the cell; the desk numbers it.
    pub(crate) program: Box<Program>,
    pub(crate) machine: Box<Machine>,
    pub(crate) view: Arc<WorkView>,
    /// Surroundings for the display of distances.
    pub(crate) around: Arc<Around>,
    /// Plan of the record of its weld.
    pub(crate) plan: Plan,
    /// Number of passes to be welded.
    pub(crate) passes: usize,
    /// Length of finished weld that is welded over on purpose when a weld is continued, mm.
    pub(crate) overlap_mm: f64,
    pub(crate) user: String,
}

/// Receiver of the result of loading a program.
pub(crate) type Loaded = oneshot::Sender<Result<(), NotLoaded>>;

/// Reasons why a program was not loaded.
#[derive(Debug)]
pub(crate) enum NotLoaded {
    /// The state of the cell.
    Lack(Lack),
    /// The program itself, or its devices.
    Invalid(Message),
}

/// Handles messages of the cycle: informs clients, records welds, forwards commands.
pub(super) struct Desk {
    pub(super) hub: Arc<Hub>,
    pub(super) archive: Archive,
    pub(super) cell: Supervisor,
    from: Receiver<ToDesk>,
    pub(super) names: Names,
    pub(super) recorder: Recorder,
    pub(super) own_connection: OwnConnection,
    pub(super) mirror: Mirror,
    pub(super) to_weld: Option<ToWeld>,
    /// The running weld.
    pub(super) welding: Option<Welding>,
    /// Devices without a confirmation of their safe outputs, with the reason.
    pub(super) unconfirmed: BTreeMap<String, Message>,
    pub(super) waiting: VecDeque<Command>,
    /// Missing conditions reported so far, by station and command number.
    pub(super) lacks: HashMap<(u32, u32), Vec<Lack>>,
    pub(super) loading: Option<Box<Pending>>,
    /// Number of the last program.
    pub(super) programs: u32,
    /// The program was found in a running cell, whose first cycle has not come yet.
    pub(super) adopts: bool,
    /// Its weld, if no panel has asked for the record of that.
    pub(super) unrecorded: Option<u64>,
    pub(super) now: Option<Shown>,
    shown: Instant,
    /// Time of the last report to the service manager.
    reported: Instant,
    stillness: Stillness,
    pub(super) readiness: Option<Readiness>,
    /// Real-time rights granted to the cycle.
    pub(super) footing: Option<RealtimeRights>,
    /// The cell was asked to end.
    pub(super) expects_end: bool,
    /// It has ended, and no other takes its place.
    pub(super) ended: bool,
    /// Why no other takes its place.
    pub(super) failure: Option<Message>,
    pub(super) tally: Tally,
    missed: u32,
    /// Maximum number of cycles missed at once.
    longest: u32,
    pub(super) left: Option<Left>,
    /// The value before the running weld, until that weld has a result.
    pub(super) left_before: Option<Left>,
    pub(super) parts: Parts,
    pub(super) quits: bool,
}

/// Progress of the running weld, recorded or not.
#[derive(Debug, Default)]
pub(super) struct Welding {
    /// Number of finished passes.
    pub(super) passes: usize,
    /// It was left before its end.
    pub(super) is_left: bool,
    /// A cycle of this weld has arrived: earlier ones may still be in the queue when it starts.
    pub(super) runs: bool,
}

/// Audit log, alarms and weld records of a cell, with the data that earlier runs left in them.
pub(super) struct Records {
    pub(super) archive: Archive,
    pub(super) recorder: Recorder,
    pub(super) mirror: Mirror,
    /// Position where the newest unfinished weld was left.
    pub(super) left: Option<Left>,
}

impl Desk {
    pub(super) fn new(hub: Arc<Hub>, cell: Supervisor, from: Receiver<ToDesk>, names: Names, records: Records) -> Self {
        let Records { archive, recorder, mirror, left } = records;
        Self {
            hub,
            archive,
            cell,
            from,
            names,
            recorder,
            own_connection: OwnConnection::new(),
            mirror,
            to_weld: None,
            welding: None,
            unconfirmed: BTreeMap::new(),
            waiting: VecDeque::new(),
            lacks: HashMap::new(),
            loading: None,
            programs: 0,
            adopts: false,
            unrecorded: None,
            now: None,
            shown: Instant::now(),
            reported: Instant::now(),
            stillness: Stillness::default(),
            readiness: None,
            footing: None,
            expects_end: false,
            ended: false,
            failure: None,
            tally: Tally::default(),
            longest: 0,
            missed: 0,
            left,
            left_before: None,
            parts: Parts::default(),
            quits: false,
        }
    }

    /// Runs until the cell ends, or does not end in time after a requested `shutdown`. Then closes records. Returns one
    /// line for a cell that could not be replaced, and for each device that has not confirmed its safe outputs.
    pub(super) fn run(mut self, shutdown: &Shutdown) -> Vec<String> {
        let mut asked: Option<Instant> = None;
        // After a panic of its own the desk only waits: the panic requests a shutdown, so the cell ends by itself.
        let mut fails = false;
        while !self.ended {
            if fails {
                self.wait_for_end();
            } else {
                fails = catch_unwind(AssertUnwindSafe(|| self.look(shutdown))).is_err();
            }
            if shutdown.is_requested() && asked.is_none() {
                asked = Some(Instant::now());
                if let Some(cause) = shutdown.cause() {
                    self.tell(happening(Message::new("server-event-stopped-by").message("cause", cause.message())));
                    self.recorder.stopped_by(&cause.message());
                }
                // A cell that has gone is noticed by its news.
                self.cell.send(&Request::Shutdown);
            }
            if asked.is_some_and(|asked| asked.elapsed() > SHUTDOWN) {
                log::error(&Message::new("server-log-cycle-hangs"));
                self.cell.kill();
                break;
            }
            std::thread::sleep(LOOK);
        }
        let closed = catch_unwind(AssertUnwindSafe(|| {
            self.recorder.close_all();
        }));
        if closed.is_err() {
            log::error(&Message::new("server-log-record-open"));
        }
        self.cell.wait();
        let line = |(name, why): (&String, &Message)| {
            format!("device `{name}`: its outputs are not confirmed to be safe: {why}")
        };
        let failure = self.failure.iter().map(ToString::to_string);
        failure.chain(self.unconfirmed.iter().map(line)).collect()
    }

    /// Reports which real-time rights the cycle lacks.
    pub(super) fn tell_footing(&mut self, footing: RealtimeRights) {
        if !footing.is_whole() {
            self.tell(happening(Message::new("server-event-no-realtime").message("reason", footing.message())));
        }
        self.footing = Some(footing);
    }

    /// Reads the news of the cell without handling them, up to its end.
    fn wait_for_end(&mut self) {
        while let Some(news) = self.cell.news() {
            self.ended |= matches!(news, News::Lost(_) | News::Report(Report::Ended { .. }));
            if self.ended {
                break;
            }
        }
    }

    fn look(&mut self, shutdown: &Shutdown) {
        self.expects_end |= self.quits || shutdown.is_requested();
        while !self.ended
            && let Some(news) = self.cell.news()
        {
            match news {
                News::Report(report) => self.handle_report(report),
                News::Lost(why) => self.lost(&why, shutdown),
            }
        }
        self.own_connection.watch(self.cell.is_silent(), &self.names.machine.devices.modbus);
        while let Some((device, outcome)) = self.own_connection.outcome() {
            self.written_by_panel(device, outcome);
        }
        while let Some(news) = self.recorder.news() {
            self.handle_record(news);
        }
        let unshelved = self.mirror.expire();
        if !unshelved.is_empty() {
            self.hub.alarms(self.mirror.views(&self.names));
        }
        for alarm in unshelved {
            self.tell(happening(Message::new("server-event-unshelved").message("alarm", alarm)));
        }
        if self.hub.forget_silent() {
            self.tell(happening(Message::new("server-event-control-lost")));
        }
        loop {
            match self.from.try_recv() {
                Ok(ToDesk::Command(command)) if command.ask == Ask::StartWeld && !self.may_start(&command) => {}
                Ok(ToDesk::Command(command) | ToDesk::Reweld(command)) if self.waiting.len() < WAITING => {
                    self.waiting.push_back(command);
                }
                Ok(ToDesk::Command(command) | ToDesk::Reweld(command)) => self.crowded(&command),
                Ok(ToDesk::Load(loading, answer)) => self.load(*loading, answer),
                Ok(ToDesk::Shelve(asked, user, answer)) => drop(answer.send(self.shelve(&asked, &user))),
                Ok(ToDesk::Quit) | Err(TryRecvError::Disconnected) => {
                    self.quits = true;
                    break;
                }
                Err(TryRecvError::Empty) => break,
            }
        }
        if self.quits && self.waiting.is_empty() {
            self.wind_down();
        }
        while let Some(command) = self.waiting.front() {
            if !self.cell.send(&Request::Command(*command)) {
                break;
            }
            self.waiting.pop_front();
        }
    }

    /// Refuses a start, and returns false, if it would weld finished passes without confirmation.
    fn may_start(&mut self, command: &Command) -> bool {
        let Some(of) = &self.to_weld else { return true };
        let data = DataFolder::open_to_read(self.recorder.folder()).ok();
        let Some(lack) = self.parts.finished(of, data.as_ref().map(DataFolder::library)) else { return true };
        self.refuse(*command, lack);
        false
    }

    /// Refuses a command that exceeds the queue. Stops and holds bypass the queue.
    fn crowded(&self, command: &Command) {
        if matches!(command.ask, Ask::Jog(_)) {
            return;
        }
        let why = lack("busy", Message::new("server-busy"));
        self.hub
            .tell(command.origin.station, &FromCell::Answer { seq: command.number, ok: false, why: Some(why.into()) });
    }

    /// Brings everything to rest, then switches the power off.
    fn wind_down(&mut self) {
        let Some(now) = &self.now else { return };
        self.waiting.push_back(Command::of(match now.mode {
            Mode::Off | Mode::Fault => Ask::Quit,
            Mode::Idle | Mode::Ready => Ask::SwitchOff,
            _ => Ask::Stop,
        }));
    }

    pub(super) fn cycle(&mut self, shown: &Shown) {
        if self.adopts {
            self.adopt(shown);
        }
        self.tally.cycle(shown);
        self.missed = self.missed.saturating_add(shown.reports.missed);
        self.longest = self.longest.max(shown.reports.missed);
        // A weld without a result restores the previous position. If the weld itself was left, that note arrives before
        // it is over.
        if let Some(welding) = &mut self.welding {
            welding.runs |= matches!(shown.mode, Mode::Weld | Mode::Hold);
        }
        let over = !shown.mode.moves() && shown.mode != Mode::Hold && shown.phase.is_none();
        if over
            && self.stillness.stands()
            && self.welding.as_ref().is_none_or(|welding| welding.runs)
            && let Some(before) = self.left_before.take()
        {
            self.left.get_or_insert(before);
        }
        self.names.watch(&mut self.stillness, shown);
        let readiness = Some(Readiness::at(shown, self.readiness));
        if self.readiness != readiness {
            self.readiness = readiness;
            self.hub.refuses(readiness.map_or_else(Vec::new, |now| now.refused(&self.names)));
        }
        self.now = Some(*shown);
        if self.reported.elapsed() >= REPORT {
            self.reported = Instant::now();
            service_manager::alive();
        }
        if self.shown.elapsed() >= SHOW {
            self.shown = Instant::now();
            let extra = Extra {
                missed: self.missed,
                longest: self.longest,
                footing: self.footing.as_ref(),
                left: self.left.as_ref().map(|left| left.seen(self.to_weld.as_ref())),
                start: self.to_weld.as_ref().map(|of| of.start),
                part: self.to_weld.as_ref().map_or_else(String::new, |of| of.plan.part.clone()),
                recording: self.recorder.weld(),
                stands: self.stillness.stands(),
            };
            let set = std::array::from_fn(|i| shown.orders.set[i].position);
            self.hub.show(self.names.status(shown, extra), set);
            self.hub.set_tally(self.tally.clone());
        }
    }

    fn time(&self) -> f64 {
        self.now.map_or(0.0, |now| now.t)
    }

    pub(super) fn tell(&self, happened: Happening) {
        self.hub.event(self.time(), happened);
    }

    /// Returns the reason for which a program cannot be loaded, if any.
    fn unfit(&self, loading: &Loading) -> Option<Lack> {
        if self.loading.is_some() {
            return Some(lack("moving", Message::new("server-loading")));
        }
        let off = self.now.is_none_or(|now| now.mode == Mode::Off);
        if loading.program.machine != self.names.fingerprint && !off {
            return Some(needs_off());
        }
        let moves = |now: Shown| now.mode.moves() || now.mode == Mode::Hold || now.phase.is_some();
        self.now.is_some_and(moves).then(|| self.names.lack(Missing::Moving))
    }

    /// Gives a program to the cell, which takes it only at rest.
    fn load(&mut self, loading: Loading, answer: Loaded) {
        // The client may have gone.
        if let Some(lack) = self.unfit(&loading) {
            drop(answer.send(Err(NotLoaded::Lack(lack))));
            return;
        }
        let Loading { mut program, machine, view, around, plan, passes, overlap_mm, user } = loading;
        let to_weld = ToWeld::new(plan, passes, view.from).with_overlap(overlap_mm);
        self.programs += 1;
        program.number = self.programs;
        let names = names_of(*machine, &program, &view);
        if !self.cell.send(&Request::Load(program)) {
            drop(answer.send(Err(NotLoaded::Lack(lack("moving", Message::new("server-cell-silent"))))));
            return;
        }
        self.loading = Some(Box::new(Pending { names, view, around, to_weld, user, answer }));
    }

    /// The cell could not prepare the program.
    pub(super) fn unprepared(&mut self, why: Unprepared) {
        let Some(pending) = self.loading.take() else { return };
        let why = match why {
            Unprepared::Busy => NotLoaded::Lack(lack("moving", Message::new("server-loading"))),
            Unprepared::NeedsOff => NotLoaded::Lack(needs_off()),
            Unprepared::Invalid(message) | Unprepared::Devices(message) => NotLoaded::Invalid(message),
        };
        // The client may have gone.
        drop(pending.answer.send(Err(why)));
    }

    pub(super) fn loaded(&mut self, refused: Option<Missing>) {
        let Some(pending) = self.loading.take() else { return };
        if let Some(missing) = refused {
            drop(pending.answer.send(Err(NotLoaded::Lack(self.names.lack(missing)))));
            return;
        }
        if pending.names.fingerprint != self.names.fingerprint {
            self.mirror.forget();
            self.hub.alarms(self.mirror.views(&pending.names));
            self.hub.set_machine(&pending.names.machine);
        }
        self.names = pending.names;
        self.to_weld = Some(pending.to_weld);
        if let Some(of) = &self.to_weld {
            let data = DataFolder::open_to_read(self.recorder.folder()).ok();
            if let Some(Progress::Left(left)) = self.parts.of(of, data.as_ref().map(DataFolder::library)) {
                self.left = Some(left);
            }
        }
        let loaded = Message::new("server-event-loaded").text("job", &pending.view.title);
        self.tell(happening(loaded).by(Some(pending.user)));
        self.hub.set_around(pending.around);
        self.hub.set_work(Some(pending.view));
        drop(pending.answer.send(Ok(())));
    }

    fn shelve(&mut self, asked: &Shelving, user: &str) -> Result<(), Message> {
        let name = self.mirror.shelve(&self.names, asked, user)?;
        self.hub.alarms(self.mirror.views(&self.names));
        let happened = match asked.minutes {
            0 => happening(Message::new("server-event-unshelved").message("alarm", name)),
            minutes => {
                let message = Message::new("server-event-shelved").message("alarm", name);
                happening(message.number("minutes", f64::from(minutes), 0))
            }
        };
        self.tell(happened.by(Some(user.to_owned())));
        Ok(())
    }
}

pub(super) fn names_of(machine: Machine, program: &Program, view: &WorkView) -> Names {
    Names { machine, fingerprint: program.machine.clone(), values: view.values.len(), heads: view.tracked }
}

fn needs_off() -> Lack {
    lack("mode", Message::new("server-needs-other-devices"))
}

/// A program that the cell has been given but not yet taken.
pub(super) struct Pending {
    pub(super) names: Names,
    view: Arc<WorkView>,
    pub(super) around: Arc<Around>,
    to_weld: ToWeld,
    user: String,
    pub(super) answer: Loaded,
}
