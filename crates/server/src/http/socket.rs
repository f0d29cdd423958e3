use super::answer::Refused;
use super::panel::Panel;
use crate::cell::{Connected, Refusal, Text, ToDesk, WHY, happening};
use crate::users::{Session, may};
use crate::wire::{AskView, FromCell, JogOf, LackView, TeachOrder, ToCell};
use axum::Extension;
use axum::extract::State;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::http::StatusCode;
use axum::response::{IntoResponse as _, Response};
use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt as _, StreamExt as _};
use glam::DVec3;
use seamwright_cell::executive::{Alarm, Ask, Command, Origin, REDUCED_MM_S};
use seamwright_machine::{Joints, MAX_AXES};
use seamwright_motion::jog::{self, TipFrame};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{mpsc, watch};

/// Most bytes of a message from a panel.
const MOST_BYTES: usize = 16 << 10;
/// Messages a second from a panel, and how many may come at once.
const RATE: f64 = 100.0;
const BURST: f64 = 200.0;
/// A page that has not taken a message after this long has gone.
const PATIENCE: Duration = Duration::from_secs(20);
/// Longest step of a key, mm or degrees.
const MOST_STEP: f64 = 10.0;
/// How often a session is looked at again.
const CHECK: Duration = Duration::from_secs(2);

pub(super) async fn live(
    State(panel): State<Arc<Panel>>,
    Extension(session): Extension<Session>,
    upgrade: WebSocketUpgrade,
) -> Response {
    // A cookie is sent with foreign pages' sockets too: the guard has held their origin against the host.
    let Some(connected) = panel.cell.hub.connect(&session.user) else {
        let text = "too many pages are open: close one";
        return Refused::new(StatusCode::SERVICE_UNAVAILABLE, "slow_down", text).into_response();
    };
    let leaves = Leaves { panel: Arc::clone(&panel), station: connected.0 };
    upgrade.max_message_size(MOST_BYTES).max_frame_size(MOST_BYTES).on_upgrade(move |socket| async move {
        talk(&panel, &session, connected, socket).await;
        drop(leaves);
    })
}

/// Says that a connection has gone, however it went: also one that never came to be.
struct Leaves {
    panel: Arc<Panel>,
    station: u32,
}

impl Drop for Leaves {
    fn drop(&mut self) {
        let cell = &self.panel.cell;
        // A hand on its keys goes with it, at once.
        if cell.hub.controls(self.station, false) {
            let origin = Origin { user: 0, station: self.station };
            drop(cell.desk.send(ToDesk::Command(Command { origin, number: 0, ask: Ask::Jog(jog::Command::Rest) })));
        }
        cell.hub.disconnect(self.station);
    }
}

async fn talk(panel: &Arc<Panel>, session: &Session, (station, told, status): Connected, socket: WebSocket) {
    let client = Client::new(Arc::clone(panel), session.clone(), station);
    let (to, from) = socket.split();
    // Apart: who hears nothing because his network is slow is heard all the same when he stops.
    tokio::select! {
        () = listen(from, client) => {}
        () = tell(to, told, status) => {}
        () = over(panel, session) => {}
    }
}

/// Hears a page until it says too much, something else than text, or goes.
async fn listen(mut from: SplitStream<WebSocket>, mut client: Client) {
    while let Some(Ok(message)) = from.next().await {
        match message {
            _ if !client.may_speak() => break,
            Message::Text(text) => client.hears(&text),
            Message::Ping(_) | Message::Pong(_) => {}
            _ => break,
        }
    }
}

/// Tells a page what it must not miss, and the newest status, until it does not listen any more.
async fn tell(
    mut to: SplitSink<WebSocket, Message>,
    mut told: mpsc::Receiver<Text>,
    mut status: watch::Receiver<Option<Text>>,
) {
    loop {
        let text = tokio::select! {
            biased;
            message = told.recv() => message,
            changed = status.changed() => {
                let newest = status.borrow_and_update().clone();
                let Some(newest) = newest.filter(|_| changed.is_ok()) else { continue };
                Some(newest)
            }
        };
        // None: it was too slow for the others.
        let Some(text) = text else { break };
        let sent = tokio::time::timeout(PATIENCE, to.send(Message::Text((*text).into()))).await;
        if !matches!(sent, Ok(Ok(()))) {
            break;
        }
    }
}

/// Until the session is over.
async fn over(panel: &Panel, session: &Session) {
    let mut check = tokio::time::interval(CHECK);
    while panel.stands(session, false) {
        check.tick().await;
    }
}

/// A connection's side of what it is allowed to say.
struct Client {
    panel: Arc<Panel>,
    session: Session,
    station: u32,
    commands: u32,
    jogs: u32,
    /// When a stop of this page was audited last, and what was refused to it.
    stopped: Option<Instant>,
    refused: Vec<String>,
    /// Where a key that is held since leads to, mm or rad.
    held: Option<Joints>,
    allowance: f64,
    spoke: Instant,
}

impl Client {
    fn new(panel: Arc<Panel>, session: Session, station: u32) -> Self {
        Self {
            panel,
            session,
            station,
            commands: 0,
            jogs: 0,
            held: None,
            stopped: None,
            refused: Vec::new(),
            allowance: BURST,
            spoke: Instant::now(),
        }
    }

    /// False once it says too much.
    fn may_speak(&mut self) -> bool {
        let since = self.spoke.elapsed().as_secs_f64();
        self.spoke = Instant::now();
        self.allowance = (self.allowance + RATE * since).min(BURST) - 1.0;
        self.allowance >= 0.0
    }

    fn hears(&mut self, text: &str) {
        let message = match serde_json::from_str::<ToCell>(text) {
            Ok(message) => message,
            Err(e) => return self.answer(0, Err(lack("value", format!("the message is not understood: {e}")))),
        };
        // Whoever was logged out or lost his role a moment ago commands nothing any more, but still stops.
        let stops = matches!(message, ToCell::Command { ask: AskView::Stop {}, .. });
        if !stops && !self.panel.stands(&self.session, !matches!(message, ToCell::Beat {})) {
            let seq = if let ToCell::Command { seq, .. } = message { seq } else { 0 };
            return self.answer(seq, Err(lack("login", "the session is over: log in")));
        }
        match message {
            // Not answered either.
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
                // Not answered: what is refused does not move.
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

    fn allowed(&mut self, action: &str) -> Result<(), LackView> {
        if may(self.session.role, action) {
            return Ok(());
        }
        // Once for each: who repeats it does not fill the disk.
        if !self.refused.iter().any(|known| known == action) {
            self.refused.push(action.to_owned());
            self.audit(action, "refused: role");
        }
        let needed = crate::users::least(action).map_or(String::new(), |r| format!(" (from {r:?} on)").to_lowercase());
        Err(lack("role", format!("your role does not allow this{needed}")))
    }

    fn command(&mut self, seq: u32, ask: &AskView) -> Result<(), LackView> {
        let (name, ask) = executive(ask)?;
        // Who stops is always heard: without role, token or number.
        if ask == Ask::Stop {
            self.panel.cell.urgent.ask(&ask);
            // Once a second: who leans on the key does not fill the disk.
            if self.stopped.is_none_or(|at| at.elapsed() > Duration::from_secs(1)) {
                self.stopped = Some(Instant::now());
                self.audit(name, "taken");
            }
            self.answer(seq, Ok(()));
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
        self.send(seq, ask);
        Ok(())
    }

    /// True: the hand may move axes, and teaching by eye stands still for it.
    fn may_jog(&mut self, seq: u32, moves: bool) -> Result<(), LackView> {
        self.allowed("jog")?;
        if seq <= self.jogs {
            return Err(lack("replayed", "it came before"));
        }
        self.jogs = seq;
        if !self.panel.cell.hub.controls(self.station, moves) {
            return Err(lack("control", "this page does not have control"));
        }
        if moves { self.panel.teaching.pause("hand") } else { Ok(()) }
    }

    fn jog(&mut self, seq: u32, of: JogOf, speeds: &[f64]) -> Result<(), LackView> {
        let moves = speeds.iter().any(|v| *v != 0.0);
        self.may_jog(seq, moves)?;
        self.held = None;
        let part = |v: f64| if v.is_finite() { v.clamp(-1.0, 1.0) } else { 0.0 };
        let command = match of {
            _ if !moves => jog::Command::Rest,
            JogOf::Joints => {
                let machine = self.panel.cell.hub.machine().ok_or_else(|| lack("work", "there is no machine"))?;
                let mut all: Joints = [0.0; MAX_AXES];
                for ((speed, axis), v) in all.iter_mut().zip(&machine.axes).zip(speeds) {
                    *speed = part(*v) * axis.max_speed;
                }
                jog::Command::Speeds(all)
            }
            JogOf::Tip => {
                let at = |i: usize| speeds.get(i).map_or(0.0, |v| part(*v));
                let velocity = REDUCED_MM_S * DVec3::new(at(0), at(1), at(2)).clamp_length_max(1.0);
                jog::Command::Tip { frame: TipFrame::Work, velocity }
            }
        };
        self.send(seq, Ask::Jog(command));
        Ok(())
    }

    /// On to where the first step since the hand let go leads.
    fn step(&mut self, seq: u32, of: JogOf, index: u32, by: f64) -> Result<(), LackView> {
        self.may_jog(seq, true)?;
        let target = match self.held {
            Some(target) => target,
            None => self.stepped(of, index as usize, by)?,
        };
        self.held = Some(target);
        self.send(seq, Ask::Jog(jog::Command::To(target)));
        Ok(())
    }

    /// Where a step leads from where the axes shall be.
    fn stepped(&self, of: JogOf, index: usize, by: f64) -> Result<Joints, LackView> {
        if !(-MOST_STEP..=MOST_STEP).contains(&by) {
            return Err(lack("value", format!("a step of {by}; allowed: {MOST_STEP} of either sign")));
        }
        let hub = &self.panel.cell.hub;
        let known = hub.machine().zip(hub.set_points());
        let (machine, mut q) = known.ok_or_else(|| lack("references", "where the axes are is not known"))?;
        match of {
            JogOf::Joints => {
                let axis = machine.axes.get(index).ok_or_else(|| lack("value", "there is no such axis"))?;
                q[index] += axis.from_file(by);
                if let Some((low, high)) = axis.range {
                    q[index] = q[index].clamp(low, high);
                }
                Ok(q)
            }
            JogOf::Tip if index < 3 => {
                let mut pose = machine.forward(&q);
                pose.point[index] += by;
                let there = machine.inverse_near(pose, &q).map_err(|e| lack("motion", e.to_string()))?;
                Ok(there.joints)
            }
            JogOf::Tip => Err(lack("value", "the tip has x, y and z")),
        }
    }

    fn go(&mut self, seq: u32, axes: &[f64]) -> Result<(), LackView> {
        self.may_jog(seq, true)?;
        self.held = None;
        let machine = self.panel.cell.hub.machine().ok_or_else(|| lack("work", "there is no machine"))?;
        if axes.len() != machine.axes.len() {
            return Err(lack("value", format!("{} axes; allowed: {}", axes.len(), machine.axes.len())));
        }
        let target = seamwright_cell::teach::joints(&machine, axes);
        self.send(seq, Ask::Jog(jog::Command::To(target)));
        Ok(())
    }

    fn teach(&mut self, seq: u32, order: &TeachOrder) -> Result<(), LackView> {
        self.allowed("teach")?;
        self.counts(seq)?;
        // Who stands still needs no control.
        let stops = matches!(order, TeachOrder::Pause {} | TeachOrder::Stop {});
        if !stops && !self.panel.cell.hub.controls(self.station, false) {
            return Err(lack("control", "this page does not have control: take it first"));
        }
        let result = crate::teaching::order(&self.panel, self.station, order);
        let said = result.as_ref().map_or_else(|why| why.text.clone(), |()| "taken".to_owned());
        let (user, station) = (&self.session.user, format!("panel {}", self.station));
        self.panel.cell.archive.audit(user, &station, &format!("teach: {order:?}"), ("", ""), &said);
        result
    }

    /// Refuses commands that came before.
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
                self.audit("take control", text);
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

    fn send(&self, number: u32, ask: Ask) {
        let command = Command { origin: Origin { user: 0, station: self.station }, number, ask };
        // A cell that has ended closes all connections.
        drop(self.panel.cell.desk.send(ToDesk::Command(command)));
    }

    fn answer(&self, seq: u32, result: Result<(), LackView>) {
        let answer = FromCell::Answer { seq, ok: result.is_ok(), why: result.err() };
        self.panel.cell.hub.tell(self.station, &answer);
    }
}

fn lack(key: &str, text: impl Into<String>) -> LackView {
    LackView { key: key.to_owned(), of: Vec::new(), text: text.into() }
}

/// A command as the executive takes it, with its name in the table of permissions.
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
        AskView::StartWeld {} => ("start_weld", Ask::StartWeld),
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

/// What a page says, one message after the other, and what it is told.
#[cfg(test)]
pub(crate) fn hears(panel: &Arc<Panel>, session: &Session, texts: &[String]) -> Vec<String> {
    let (station, mut told, _status) = panel.cell.hub.connect(&session.user).unwrap();
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
