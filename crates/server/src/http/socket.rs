use super::answer::Refused;
use super::client::Client;
use super::panel::Panel;
use crate::cell::{Connected, Text, ToDesk};
use crate::users::Session;
use axum::Extension;
use axum::extract::State;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::http::StatusCode;
use axum::response::{IntoResponse as _, Response};
use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt as _, StreamExt as _};
use seamwright_cell::executive::{Ask, Command, Origin};
use seamwright_motion::jog;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::{mpsc, watch};

/// Most bytes of a message from a panel.
const MOST_BYTES: usize = 16 << 10;
/// A page that has not taken a message after this long has gone.
const PATIENCE: Duration = Duration::from_secs(20);
/// How often a session is looked at again.
const CHECK: Duration = Duration::from_secs(2);

pub(super) async fn live(
    State(panel): State<Arc<Panel>>,
    Extension(session): Extension<Session>,
    upgrade: WebSocketUpgrade,
) -> Response {
    // A cookie is sent with foreign pages' sockets too: the guard has held their origin against the host.
    let Some(connected) = panel.cell.hub.connect(&session.user, session.role) else {
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
