use super::alarms::Mirror;
use super::archive::Archive;
use super::connection::Connection;
use super::display_distances::Around;
use super::event::{Happening, happening};
use super::hub::Hub;
use super::names::{Extra, Names};
use super::prepared_task::Prepared;
use super::progress::{Left, Parts, Progress, ToWeld};
use super::recorder::Recorder;
use super::safe_outputs::SafeOutputs;
use super::standstill::Stillness;
use super::tally::Tally;
use super::unavailable_commands::Readiness;
use crate::refusal::{Lack, lack};
use crate::wire::{FromCell, Shelving, WorkView};
use rtrb::{Consumer, Producer, PushError};
use seamwright_executive::realtime::{Outside, RealtimeRights, Shown, Shutdown};
use seamwright_executive::{Ask, Command, Missing, Mode, Origin};
use seamwright_log as log;
use seamwright_message::Message;
use seamwright_record::{DataFolder, Plan};
use std::collections::{HashMap, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, TryRecvError};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};
use tokio::sync::oneshot;

/// Polling period for messages of the cycle.
const LOOK: Duration = Duration::from_millis(2);
/// Period of status updates to clients.
const SHOW: Duration = Duration::from_micros(33_333);

/// Maximum time of the cycle to end after a signal or a panic; then the desk ends without it.
const SHUTDOWN: Duration = Duration::from_secs(15);

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
    pub(crate) prepared: Box<Prepared>,
    pub(crate) view: Option<Arc<WorkView>>,
    /// Surroundings for the display of distances.
    pub(crate) around: Arc<Around>,
    /// Plan of the record of its weld.
    pub(crate) plan: Option<Plan>,
    /// Number of passes to be welded.
    pub(crate) passes: usize,
    /// Length of finished weld that is welded over on purpose when a weld is continued, mm.
    pub(crate) overlap_mm: f64,
    pub(crate) user: String,
}

/// Receiver of the result of loading a program.
pub(crate) type Loaded = oneshot::Sender<Result<(), Lack>>;

/// Handles messages of the cycle: informs clients, records welds, forwards commands.
pub(super) struct Desk {
    pub(super) hub: Arc<Hub>,
    pub(super) archive: Archive,
    pub(super) outside: Outside,
    from: Receiver<ToDesk>,
    next: Producer<Box<Prepared>>,
    done: Consumer<Box<Prepared>>,
    pub(super) names: Names,
    pub(super) recorder: Recorder,
    pub(super) mirror: Mirror,
    pub(super) to_weld: Option<ToWeld>,
    /// The running weld.
    pub(super) welding: Option<Welding>,
    pub(super) safe_outputs: SafeOutputs,
    waiting: VecDeque<Command>,
    /// Missing conditions reported so far, by station and command number.
    pub(super) lacks: HashMap<(u32, u32), Vec<Lack>>,
    loading: Option<Box<Pending>>,
    now: Option<Shown>,
    shown: Instant,
    stillness: Stillness,
    readiness: Option<Readiness>,
    /// Real-time rights granted to the cycle.
    pub(super) footing: Arc<OnceLock<RealtimeRights>>,
    /// The missing real-time rights have been reported.
    granted: bool,
    tally: Tally,
    missed: u32,
    /// Maximum number of cycles missed at once.
    longest: u32,
    pub(super) left: Option<Left>,
    /// The value before the running weld, until that weld has a result.
    pub(super) left_before: Option<Left>,
    pub(super) parts: Parts,
    pub(super) quits: bool,
    /// The last reported reason for which the record cannot be written.
    pub(super) trouble: Option<String>,
}

/// Progress of the running weld, recorded or not.
#[derive(Debug, Default)]
pub(super) struct Welding {
    /// Number of finished passes.
    pub(super) passes: usize,
    /// It was left before its end.
    pub(super) is_left: bool,
    /// A cycle of this weld has arrived: earlier ones may still be in the queue when it starts.
    runs: bool,
}

/// The desk's ends of the queues to and from the cycle.
pub(super) struct Queues {
    pub(super) outside: Outside,
    pub(super) next: Producer<Box<Prepared>>,
    pub(super) done: Consumer<Box<Prepared>>,
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
    pub(super) fn new(
        hub: Arc<Hub>,
        queues: Queues,
        from: Receiver<ToDesk>,
        names: Names,
        records: Records,
        footing: Arc<OnceLock<RealtimeRights>>,
    ) -> Self {
        let Queues { outside, next, done } = queues;
        let Records { archive, recorder, mirror, left } = records;
        let safe_outputs = SafeOutputs::new(Arc::clone(&hub));
        Self {
            hub,
            archive,
            outside,
            from,
            next,
            done,
            names,
            recorder,
            mirror,
            to_weld: None,
            welding: None,
            safe_outputs,
            waiting: VecDeque::new(),
            lacks: HashMap::new(),
            loading: None,
            now: None,
            shown: Instant::now(),
            stillness: Stillness::default(),
            readiness: None,
            footing,
            granted: false,
            tally: Tally::default(),
            longest: 0,
            missed: 0,
            left,
            left_before: None,
            parts: Parts::default(),
            quits: false,
            trouble: None,
        }
    }

    /// Runs until `ended` returns true, or a requested `shutdown` times out. Then closes records.
    pub(super) fn run(mut self, ended: impl Fn() -> bool, shutdown: &Shutdown) {
        let mut asked: Option<Instant> = None;
        // After a panic of its own the desk only waits: the panic requests a shutdown, so the cycle ends by itself.
        let mut fails = false;
        while !ended() {
            fails = fails || catch_unwind(AssertUnwindSafe(|| self.look())).is_err();
            if shutdown.is_requested() && asked.get_or_insert_with(Instant::now).elapsed() > SHUTDOWN {
                log::error(&Message::new("server-log-cycle-hangs"));
                break;
            }
            std::thread::sleep(LOOK);
        }
        let closed = catch_unwind(AssertUnwindSafe(|| {
            if !fails {
                self.look();
            }
            if let Some(cause) = shutdown.cause() {
                self.tell(happening(Message::new("server-event-stopped-by").message("cause", cause.message())));
                self.recorder.stopped_by(&cause.message());
            }
            self.recorder.close();
        }));
        if closed.is_err() {
            log::error(&Message::new("server-log-record-open"));
        }
    }

    /// Reports once which real-time rights the cycle lacks.
    fn tell_footing(&mut self) {
        let Some(footing) = self.footing.get().filter(|_| !self.granted) else { return };
        if !footing.is_whole() {
            self.tell(happening(Message::new("server-event-no-realtime").message("reason", footing.message())));
        }
        self.granted = true;
    }

    fn look(&mut self) {
        self.tell_footing();
        self.tally.look(&self.outside);
        while let Ok(done) = self.done.pop() {
            self.drop_task(done);
        }
        while let Ok((t, note)) = self.outside.notes.pop() {
            self.handle_note(t, note);
        }
        while let Ok(shown) = self.outside.cycles.pop() {
            self.cycle(&shown);
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
            if self.outside.commands.push(*command).is_err() {
                break;
            }
            self.waiting.pop_front();
        }
    }

    /// Drops a task that the cycle has finished or does not get. Its devices end in another thread.
    fn drop_task(&self, mut task: Box<Prepared>) {
        if let Some(devices) = task.devices.take() {
            self.safe_outputs.let_go(devices);
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

    fn cycle(&mut self, shown: &Shown) {
        self.tally.cycle(shown);
        self.missed = self.missed.saturating_add(shown.reports.missed);
        self.longest = self.longest.max(shown.reports.missed);
        if let Some(trouble) = self.recorder.row(&self.names, shown)
            && self.trouble.as_ref() != Some(&trouble)
        {
            self.outside.fail();
            self.tell(happening(Message::new("server-event-record-fails").text("reason", &trouble)));
            self.trouble = Some(trouble);
        }
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
        if self.shown.elapsed() >= SHOW {
            self.shown = Instant::now();
            let extra = Extra {
                missed: self.missed,
                longest: self.longest,
                footing: self.footing.get(),
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
        let prepared = &loading.prepared;
        if self.loading.is_some() {
            return Some(lack("moving", Message::new("server-loading")));
        }
        let connected = || self.hub.connection().is_some_and(|to| to.serves_it(prepared));
        if prepared.devices.is_none() && !connected() {
            return Some(lack("work", Message::new("server-not-connected")));
        }
        let off = self.now.is_none_or(|now| now.mode == Mode::Off);
        if prepared.fingerprint() != self.names.fingerprint && !off {
            return Some(lack("mode", Message::new("server-needs-other-devices")));
        }
        let moves = |now: Shown| now.mode.moves() || now.mode == Mode::Hold || now.phase.is_some();
        self.now.is_some_and(moves).then(|| self.names.lack(Missing::Moving))
    }

    /// Gives a program to the cycle, which takes it only at rest.
    fn load(&mut self, loading: Loading, answer: Loaded) {
        // The client may have gone.
        if let Some(lack) = self.unfit(&loading) {
            drop(answer.send(Err(lack)));
            self.drop_task(loading.prepared);
            return;
        }
        let Loading { prepared, view, around, plan, passes, overlap_mm, user } = loading;
        let start = view.as_ref().and_then(|view| view.from);
        let to_weld = plan.map(|plan| ToWeld::new(plan, passes, start).with_overlap(overlap_mm));
        let to = prepared.devices.as_ref().map(|devices| devices.to().clone());
        let (machine, fingerprint) = (prepared.machine().clone(), prepared.fingerprint().to_owned());
        let values = prepared.with(|work| work.values().len());
        let heads = view.as_ref().map_or(0, |view| view.tracked);
        if let Err(PushError::Full(prepared)) = self.next.push(prepared) {
            self.drop_task(prepared);
            drop(answer.send(Err(lack("moving", Message::new("server-cell-silent")))));
            return;
        }
        self.waiting.push_back(Command { origin: Origin::default(), number: 0, ask: Ask::Load });
        let names = Names { machine, fingerprint, values, heads };
        self.loading = Some(Box::new(Pending { names, to, view, around, to_weld, user, answer }));
    }

    pub(super) fn loaded(&mut self, refused: Option<Missing>) {
        let Some(pending) = self.loading.take() else { return };
        if let Some(missing) = refused {
            drop(pending.answer.send(Err(self.names.lack(missing))));
            return;
        }
        // Its rows belong to the previous program.
        self.recorder.end();
        if pending.names.fingerprint != self.names.fingerprint {
            self.mirror.forget();
            self.hub.alarms(self.mirror.views(&pending.names));
            self.hub.set_machine(&pending.names.machine);
            if let Some(to) = &pending.to {
                self.hub.set_connection(to);
            }
        }
        self.names = pending.names;
        self.to_weld = pending.to_weld;
        if let Some(of) = &self.to_weld {
            let data = DataFolder::open_to_read(self.recorder.folder()).ok();
            if let Some(Progress::Left(left)) = self.parts.of(of, data.as_ref().map(DataFolder::library)) {
                self.left = Some(left);
            }
        }
        if let Some(view) = &pending.view {
            self.tell(happening(Message::new("server-event-loaded").text("job", &view.title)).by(Some(pending.user)));
        }
        self.hub.set_around(pending.around);
        self.hub.set_work(pending.view);
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

/// A program that the cycle has been given but not yet taken.
pub(super) struct Pending {
    names: Names,
    /// Machine and process values that its devices serve.
    to: Option<Connection>,
    view: Option<Arc<WorkView>>,
    around: Arc<Around>,
    to_weld: Option<ToWeld>,
    user: String,
    answer: Loaded,
}
