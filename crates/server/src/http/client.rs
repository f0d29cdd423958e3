//! Messages of a page over its socket, checked against its permissions.

use super::panel::Panel;
use crate::cell::{Refusal, ToDesk, WHY, happening};
use crate::users::{Session, may};
use crate::wire::{AskView, FromCell, LackView, TeachOrder, ToCell};
use seamwright_cell::executive::{Alarm, Ask, Command, Origin};
use seamwright_machine::Joints;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Maximum messages per second of a page, and maximum burst.
const RATE: f64 = 100.0;
const BURST: f64 = 200.0;

/// Maximum age of the last status for which the cycle counts as alive.
const FRESH: Duration = Duration::from_millis(500);

/// State and permissions of a connected page.
pub(super) struct Client {
    pub(super) panel: Arc<Panel>,
    session: Session,
    pub(super) station: u32,
    commands: u32,
    pub(super) jogs: u32,
    /// Time of the last audited stop of this page.
    stopped: Option<Instant>,
    /// Target of steps while a key is held, mm or rad.
    pub(super) held: Option<Joints>,
    allowance: f64,
    spoke: Instant,
}

/// Returns the number of an invalid message, if it is of a kind that is answered.
fn number(text: &str) -> u32 {
    let message = serde_json::from_str::<serde_json::Value>(text).unwrap_or_default();
    let answered = matches!(message["kind"].as_str(), Some("command" | "teach"));
    message["seq"].as_u64().filter(|_| answered).and_then(|seq| u32::try_from(seq).ok()).unwrap_or(0)
}

impl Client {
    pub(super) fn new(panel: Arc<Panel>, session: Session, station: u32) -> Self {
        Self {
            panel,
            session,
            station,
            commands: 0,
            jogs: 0,
            held: None,
            stopped: None,
            allowance: BURST,
            spoke: Instant::now(),
        }
    }

    /// Returns false if the page exceeds its message rate.
    pub(super) fn may_speak(&mut self) -> bool {
        let since = self.spoke.elapsed().as_secs_f64();
        self.spoke = Instant::now();
        self.allowance = (self.allowance + RATE * since).min(BURST) - 1.0;
        self.allowance >= 0.0
    }

    pub(super) fn hears(&mut self, text: &str) {
        let message = match serde_json::from_str::<ToCell>(text) {
            Ok(message) => message,
            Err(e) => {
                return self.answer(number(text), Err(lack("value", format!("the message is not understood: {e}"))));
            }
        };
        // A user who was logged out or whose role changed can no longer command, but can still stop.
        let stops = matches!(message, ToCell::Command { ask: AskView::Stop {}, .. });
        if !stops && !self.panel.stands(&self.session, !matches!(message, ToCell::Beat {})) {
            let seq = if let ToCell::Command { seq, .. } = message { seq } else { 0 };
            return self.answer(seq, Err(lack("login", "the session is over: log in")));
        }
        match message {
            // Like a jog, not answered.
            ToCell::Step { seq, of, index, by } => drop(self.step(seq, of, index, by)),
            ToCell::Go { seq, axes } => drop(self.go(seq, &axes)),
            ToCell::Teach { seq, order } => {
                let result = self.teach(seq, &order);
                self.answer(seq, result);
            }
            ToCell::Beat {} => self.panel.cell.hub.beat(self.station),
            ToCell::Command { seq, ask } => {
                if let Err(why) = self.command(seq, &ask) {
                    self.answer(seq, Err(why));
                }
            }
            ToCell::Jog { seq, of, speeds } => {
                // Not answered: a refused jog does not move.
                drop(self.jog(seq, of, &speeds));
            }
            ToCell::TakeControl { over } => self.take_control(over),
            ToCell::GiveControl {} => self.panel.cell.hub.give_control(self.station),
            ToCell::Why { ask } => {
                let known = WHY.iter().position(|(name, _)| *name == ask);
                match known {
                    Some(i) => self.send(i as u32, Ask::Why(WHY[i].1)),
                    None => {
                        let names: Vec<&str> = WHY.iter().map(|(name, _)| *name).collect();
                        self.answer(0, Err(lack("value", format!("`{ask}`; allowed: {}", names.join(", ")))));
                    }
                }
            }
        }
    }

    fn audit(&self, command: &str, result: &str) {
        let station = format!("panel {}", self.station);
        self.panel.cell.archive.audit(&self.session.user, &station, command, ("", ""), result);
    }

    pub(super) fn allowed(&mut self, action: &str) -> Result<(), LackView> {
        if may(self.session.role, action) {
            return Ok(());
        }
        let station = format!("panel {}", self.station);
        self.panel.cell.archive.repeatable(&self.session.user, &station, action, "refused: role");
        let needed = crate::users::least(action).map_or(String::new(), |r| format!(" (from {r:?} on)").to_lowercase());
        Err(lack("role", format!("your role does not allow this{needed}")))
    }

    fn command(&mut self, seq: u32, ask: &AskView) -> Result<(), LackView> {
        let again = matches!(ask, AskView::StartWeld { reweld: true });
        let (name, ask) = executive(ask)?;
        // A stop needs neither role, token nor number.
        if ask == Ask::Stop {
            self.panel.cell.urgent.ask(&ask);
            // Audited at most once a second: a held key does not fill the disk.
            if self.stopped.is_none_or(|at| at.elapsed() > Duration::from_secs(1)) {
                self.stopped = Some(Instant::now());
                self.audit(name, "taken");
            }
            // The stop was passed on in any case; a hanging or ended cycle does not take it.
            let heard = self.panel.cell.hub.age().is_some_and(|age| age < FRESH);
            let why = || lack("silent_cycle", "the cell does not answer: try again");
            self.answer(seq, heard.then_some(()).ok_or_else(why));
            return Ok(());
        }
        self.allowed(name)?;
        self.counts(seq)?;
        if ask == Ask::Hold {
            self.panel.cell.urgent.ask(&ask);
            self.audit(name, "taken");
            self.answer(seq, Ok(()));
            return Ok(());
        }
        if !self.panel.cell.hub.controls(self.station, false) {
            return Err(lack("control", "this page does not have control: take it first"));
        }
        if leaves_rest(&ask) && self.panel.loads.any() {
            return Err(lack("busy", "a job is being planned to be loaded: wait until it is in the cell"));
        }
        if again {
            self.audit("start weld", "what is finished may be welded again");
            drop(self.panel.cell.desk.send(ToDesk::Reweld(self.of_page(seq, ask))));
            return Ok(());
        }
        self.send(seq, ask);
        Ok(())
    }

    fn teach(&mut self, seq: u32, order: &TeachOrder) -> Result<(), LackView> {
        self.allowed("teach")?;
        self.counts(seq)?;
        // Pausing and stopping need no control token.
        let stops = matches!(order, TeachOrder::Pause {} | TeachOrder::Stop {});
        if !stops && !self.panel.cell.hub.controls(self.station, false) {
            return Err(lack("control", "this page does not have control: take it first"));
        }
        let result = crate::teaching::order(&self.panel, self.station, order);
        let said = result.as_ref().map_or_else(|why| why.text.clone(), |()| "taken".to_owned());
        let (user, station) = (&self.session.user, format!("panel {}", self.station));
        self.panel.cell.archive.audit(user, &station, &format!("teach: {order}"), ("", ""), &said);
        result
    }

    /// Refuses a command whose number is not greater than the last.
    fn counts(&mut self, seq: u32) -> Result<(), LackView> {
        if seq <= self.commands {
            let text = format!("command {seq} came before; allowed: greater than {}", self.commands);
            return Err(lack("replayed", text));
        }
        self.commands = seq;
        Ok(())
    }

    fn take_control(&mut self, over: bool) {
        if let Err(why) = self.allowed("take_control") {
            return self.answer(0, Err(why));
        }
        let hub = &self.panel.cell.hub;
        match hub.take_control(self.station, over) {
            Ok(()) => {
                let t = hub.latest().map_or(0.0, |s| s.t);
                let text = if over { "control taken over" } else { "control taken" };
                let station = format!("panel {}", self.station);
                self.panel.cell.archive.repeatable(&self.session.user, &station, "take control", text);
                let key = if over { "control_taken_over" } else { "control_taken" };
                hub.event(t, happening(key, []).by(Some(self.session.user.clone())));
            }
            Err(Refusal::Jogs) => {
                self.answer(0, Err(lack("control", "whoever has control moves axes by hand: wait until he lets go")));
            }
            Err(Refusal::Held(by)) => {
                let mut why = lack("control", format!("{} has control, on page {}", by.user, by.station));
                why.of = vec![by.user];
                self.answer(0, Err(why));
            }
        }
    }

    pub(super) fn send(&self, number: u32, ask: Ask) {
        // Sending fails only if the cell has ended, which closes all connections.
        drop(self.panel.cell.desk.send(ToDesk::Command(self.of_page(number, ask))));
    }

    fn of_page(&self, number: u32, ask: Ask) -> Command {
        Command { origin: Origin { user: 0, station: self.station }, number, ask }
    }

    fn answer(&self, seq: u32, result: Result<(), LackView>) {
        let answer = FromCell::Answer { seq, ok: result.is_ok(), why: result.err() };
        self.panel.cell.hub.tell(self.station, &answer);
    }
}

/// Returns true if the command starts motion.
fn leaves_rest(ask: &Ask) -> bool {
    matches!(ask, Ask::Home | Ask::HomeAxis(_) | Ask::StartJog | Ask::StartTeach | Ask::StartDryRun | Ask::StartWeld)
}

pub(super) fn lack(key: &str, text: impl Into<String>) -> LackView {
    LackView { key: key.to_owned(), of: Vec::new(), text: text.into() }
}

/// Converts a command for the executive; returns it with its name in the table of permissions.
fn executive(ask: &AskView) -> Result<(&'static str, Ask), LackView> {
    Ok(match ask {
        AskView::SwitchOn {} => ("switch_on", Ask::SwitchOn),
        AskView::SwitchOff {} => ("switch_off", Ask::SwitchOff),
        AskView::Home { axis: None } => ("home", Ask::Home),
        AskView::Home { axis: Some(axis) } => ("home", Ask::HomeAxis(*axis)),
        AskView::StartJog {} => ("start_jog", Ask::StartJog),
        AskView::StartTeach {} => ("start_teach", Ask::StartTeach),
        AskView::StartDryRun {} => ("start_dry_run", Ask::StartDryRun),
        AskView::Arm {} => ("arm", Ask::Arm),
        AskView::StartWeld { .. } => ("start_weld", Ask::StartWeld),
        AskView::Hold {} => ("hold", Ask::Hold),
        AskView::Resume {} => ("resume", Ask::Resume),
        AskView::Reverse {} => ("reverse", Ask::Reverse),
        AskView::Stop {} => ("stop", Ask::Stop),
        AskView::Override { part } if (0.0..=1.0).contains(part) => ("override", Ask::Override(*part)),
        AskView::Override { part } => return Err(lack("value", format!("override {part}; allowed: 0 to 1"))),
        AskView::Reset {} => ("reset", Ask::Reset),
        AskView::Acknowledge { one: None } => ("acknowledge", Ask::Acknowledge),
        AskView::Acknowledge { one: Some((number, detail)) } => {
            let alarm = Alarm::ALL.into_iter().find(|alarm| alarm.number() == usize::from(*number));
            let alarm = alarm.ok_or_else(|| {
                lack("value", format!("there is no alarm {number}; allowed: 1 to {}", Alarm::ALL.len()))
            })?;
            ("acknowledge", Ask::AcknowledgeOne(alarm, *detail))
        }
    })
}

/// Handles messages of a page in order; returns the messages it receives.
#[cfg(test)]
pub(crate) fn hears(panel: &Arc<Panel>, session: &Session, texts: &[String]) -> Vec<String> {
    let (station, mut told, _status) = panel.cell.hub.connect(&session.user, session.role).unwrap();
    let mut client = Client::new(Arc::clone(panel), session.clone(), station);
    let mut all = Vec::new();
    for text in texts {
        client.hears(text);
        while let Ok(text) = told.try_recv() {
            all.push(text.to_string());
        }
    }
    panel.cell.hub.disconnect(station);
    all
}
