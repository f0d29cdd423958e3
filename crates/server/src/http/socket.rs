use super::answer::Refused;
use super::client::Client;
use super::panel::{Panel, Shared};
use crate::cell::{Connected, Text, ToDesk};
use crate::limits::{MAX_MESSAGE_BYTES, MESSAGE_READ_BYTES, MESSAGE_TIME};
use crate::users::Session;
use axum::extract::State;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::http::StatusCode;
use axum::response::{IntoResponse as _, Response};
use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt as _, StreamExt as _};
use seamwright_executive::{Ask, Command, Origin};
use seamwright_motion::jog;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::{mpsc, watch};

/// Period of checking the session.
const CHECK: Duration = Duration::from_secs(2);

pub(super) async fn live(State(panel): Shared, session: Session, upgrade: WebSocketUpgrade) -> Response {
    // Browsers send cookies with sockets of foreign pages too: the guard has compared their origin with the host.
    let Some(connected) = panel.cell.hub.connect(&session.user, session.role) else {
        let message = seamwright_message::Message::new("server-too-many-pages");
        return Refused::new(StatusCode::SERVICE_UNAVAILABLE, "slow_down", message).into_response();
    };
    let leaves = Leaves { panel: Arc::clone(&panel), station: connected.0 };
    let upgrade = upgrade.max_message_size(MAX_MESSAGE_BYTES).max_frame_size(MAX_MESSAGE_BYTES);
    upgrade.read_buffer_size(MESSAGE_READ_BYTES).on_upgrade(move |socket| async move {
        talk(&panel, &session, connected, socket).await;
        drop(leaves);
    })
}

/// Disconnects a station when dropped, even if its socket was never opened.
struct Leaves {
    panel: Arc<Panel>,
    station: u32,
}

impl Drop for Leaves {
    fn drop(&mut self) {
        let cell = &self.panel.cell;
        // Ends its jog motion at once.
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
    // Sending and receiving are independent: a stop is handled even if the page receives slowly.
    tokio::select! {
        () = listen(from, client) => {}
        () = tell(to, told, status) => {}
        () = over(panel, session) => {}
    }
}

/// Handles messages of a page until it exceeds its rate, sends something other than text, or goes.
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

/// Sends a page its queued messages and the newest status, until it stops receiving.
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
        // `None`: the page was too slow for its queue.
        let Some(text) = text else { break };
        let sent = tokio::time::timeout(MESSAGE_TIME, to.send(Message::Text((*text).into()))).await;
        if !matches!(sent, Ok(Ok(()))) {
            break;
        }
    }
}

async fn over(panel: &Panel, session: &Session) {
    let mut check = tokio::time::interval(CHECK);
    while panel.stands(session, false) {
        check.tick().await;
    }
}
