//! Messages of a page over its socket, checked against its permissions.

use super::guard::role_refused;
use super::panel::Panel;
use crate::cell::{Change, Refusal, ToDesk, WHY, executive_command, happening};
use crate::limits::{MESSAGE_BURST, MESSAGE_RATE_PER_S};
use crate::refusal::{Lack, action_word, lack, panel_word};
use crate::users::{Session, may};
use crate::wire::{AskView, FromCell, TeachOrder, ToCell};
use seamwright_executive::{Ask, Command, Origin};
use seamwright_machine::Joints;
use seamwright_message::Message;
use std::sync::Arc;
use std::time::{Duration, Instant};

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
pub(super) fn number(text: &str) -> u32 {
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
            allowance: MESSAGE_BURST,
            spoke: Instant::now(),
        }
    }

    /// Returns false if the page exceeds its message rate.
    pub(super) fn may_speak(&mut self) -> bool {
        let since = self.spoke.elapsed().as_secs_f64();
        self.spoke = Instant::now();
        self.allowance = (self.allowance + MESSAGE_RATE_PER_S * since).min(MESSAGE_BURST) - 1.0;
        self.allowance >= 0.0
    }

    pub(super) fn hears(&mut self, text: &str) {
        let message = match serde_json::from_str::<ToCell>(text) {
            Ok(message) => message,
            Err(e) => {
                return self.answer(
                    number(text),
                    Err(lack("value", Message::new("server-message-invalid").text("why", e.to_string()))),
                );
            }
        };
        // A user who was logged out or whose role changed can no longer command, but can still stop.
        let stops = matches!(message, ToCell::Command { ask: AskView::Stop {}, .. });
        if !stops && !self.panel.stands(&self.session, !matches!(message, ToCell::Beat {})) {
            let seq = if let ToCell::Command { seq, .. } = message { seq } else { 0 };
            return self.answer(seq, Err(lack("login", Message::new("server-session-over"))));
        }
        match message {
            // Like a jog, not answered.
            ToCell::Step { seq, of, frame, index, by } => drop(self.step(seq, of, frame.as_deref(), (index, by))),
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
            ToCell::Jog { seq, of, frame, speeds } => {
                // Not answered: a refused jog does not move.
                drop(self.jog(seq, of, frame.as_deref(), &speeds));
            }
            ToCell::TakeControl { over } => self.take_control(over),
            ToCell::GiveControl {} => self.panel.cell.hub.give_control(self.station),
            ToCell::Why { ask } => {
                let known = WHY.iter().position(|(name, _)| *name == ask);
                match known {
                    Some(i) => self.send(i as u32, Ask::Why(WHY[i].1)),
                    None => {
                        let names: Vec<&str> = WHY.iter().map(|(name, _)| *name).collect();
                        self.answer(
                            0,
                            Err(lack(
                                "value",
                                Message::new("server-unknown-command")
                                    .text("name", ask)
                                    .text("allowed", names.join(", ")),
                            )),
                        );
                    }
                }
            }
        }
    }

    fn place(&self) -> Message {
        Message::new("server-audit-panel-number").number("number", f64::from(self.station), 0)
    }

    fn audit(&self, command: Message, result: Message) {
        self.panel.cell.archive.audit(&self.session.user, self.place(), command, Change::default(), result);
    }

    pub(super) fn allowed(&mut self, action: &str) -> Result<(), Lack> {
        if may(self.session.role, action) {
            return Ok(());
        }
        let (command, result) = (action_word(action), Message::new("server-audit-refused-role"));
        self.panel.cell.archive.refused(&self.session.user, self.place(), command, result);
        Err(lack("role", role_refused(self.session.role, action)))
    }

    fn command(&mut self, seq: u32, ask: &AskView) -> Result<(), Lack> {
        let again = matches!(ask, AskView::StartWeld { reweld: true });
        let (name, ask) = executive_command(ask)?;
        // A stop needs neither role, token nor number.
        if ask == Ask::Stop {
            drop(self.panel.cell.urgent.ask(&ask));
            // Audited at most once a second: a held key does not fill the disk.
            if self.stopped.is_none_or(|at| at.elapsed() > Duration::from_secs(1)) {
                self.stopped = Some(Instant::now());
                self.audit(panel_word("do", name), Message::new("server-audit-accepted"));
            }
            // The stop was passed on in any case; a hanging or ended cycle does not take it.
            let heard = self.panel.cell.hub.age().is_some_and(|age| age < FRESH);
            let why = || lack("silent_cycle", Message::new("server-cell-silent"));
            self.answer(seq, heard.then_some(()).ok_or_else(why));
            return Ok(());
        }
        self.allowed(name)?;
        self.counts(seq)?;
        if ask == Ask::Hold {
            drop(self.panel.cell.urgent.ask(&ask));
            self.audit(panel_word("do", name), Message::new("server-audit-accepted"));
            self.answer(seq, Ok(()));
            return Ok(());
        }
        if !self.panel.cell.hub.controls(self.station, false) {
            return Err(lack("control", Message::new("server-no-control")));
        }
        if leaves_rest(&ask) && self.panel.loads.any() {
            return Err(lack("busy", Message::new("server-load-announced")));
        }
        if again {
            self.audit(panel_word("do", "start weld"), Message::new("server-audit-reweld"));
            drop(self.panel.cell.desk.send(ToDesk::Reweld(self.of_page(seq, ask))));
            return Ok(());
        }
        self.send(seq, ask);
        Ok(())
    }

    fn teach(&mut self, seq: u32, order: &TeachOrder) -> Result<(), Lack> {
        self.allowed("teach")?;
        self.counts(seq)?;
        // Pausing and stopping need no control token.
        let stops = matches!(order, TeachOrder::Pause {} | TeachOrder::Stop {});
        if !stops && !self.panel.cell.hub.controls(self.station, false) {
            return Err(lack("control", Message::new("server-no-control")));
        }
        let result = crate::teaching::order(&self.panel, self.station, order);
        let accepted = || Message::new("server-audit-accepted");
        let said = result.as_ref().map_or_else(|why| why.message.clone(), |()| accepted());
        self.audit(Message::new("server-audit-teach").message("order", order.message()), said);
        result
    }

    /// Refuses a command whose number is not greater than the last.
    fn counts(&mut self, seq: u32) -> Result<(), Lack> {
        if seq <= self.commands {
            let message = Message::new("server-replayed").number("n", f64::from(seq), 0);
            return Err(lack("replayed", message.number("last", f64::from(self.commands), 0)));
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
                let event =
                    Message::new(if over { "server-event-control-taken-over" } else { "server-event-control-taken" });
                let command = action_word("take_control");
                self.panel.cell.archive.repeatable(&self.session.user, self.place(), command, event.clone());
                hub.event(t, happening(event).by(Some(self.session.user.clone())));
            }
            Err(Refusal::Jogs) => {
                self.answer(0, Err(lack("control", Message::new("server-control-jogs"))));
            }
            Err(Refusal::Held(by)) => {
                let message = Message::new("server-control-held").text("user", by.user);
                self.answer(0, Err(lack("control", message.number("page", f64::from(by.station), 0))));
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

    fn answer(&self, seq: u32, result: Result<(), Lack>) {
        let answer = FromCell::Answer { seq, ok: result.is_ok(), why: result.err().map(Into::into) };
        self.panel.cell.hub.tell(self.station, &answer);
    }
}

fn leaves_rest(ask: &Ask) -> bool {
    matches!(ask, Ask::Home | Ask::HomeAxis(_) | Ask::StartJog | Ask::StartTeach | Ask::StartDryRun | Ask::StartWeld)
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
