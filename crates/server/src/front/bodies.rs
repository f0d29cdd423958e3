//! Request bodies, collected completely within limits of size, memory and time.

use super::memory_limit::Room;
use crate::http::Refused;
use crate::limits::{BODY_ROOM_BYTES, BODY_ROOM_OF_USER_BYTES, MAX_BODY_BYTES, MAX_STRANGER_BODY_BYTES, SMALL_BYTES};
use axum::body::Body;
use axum::http::StatusCode;
use hyper::body::Body as _;
use seamwright_message::Message;
use std::sync::Arc;

pub(super) struct Bodies(Arc<Room>);

impl Default for Bodies {
    fn default() -> Self {
        Self(Room::new(BODY_ROOM_BYTES, BODY_ROOM_OF_USER_BYTES))
    }
}

impl Bodies {
    /// Collects the body of a client without a session.
    pub(super) async fn stranger(&self, body: Body) -> Result<Body, Refused> {
        collect(body, MAX_STRANGER_BODY_BYTES).await
    }

    /// Collects the body of a user with a session, once there is room.
    pub(super) async fn known(&self, user: &str, body: Body) -> Result<Body, Refused> {
        let size = body.size_hint().upper().and_then(|n| usize::try_from(n).ok());
        let most = size.unwrap_or(MAX_BODY_BYTES).min(MAX_BODY_BYTES);
        if most <= SMALL_BYTES {
            return collect(body, MAX_BODY_BYTES).await;
        }
        let _room = self.0.take(user, most).await;
        collect(body, MAX_BODY_BYTES).await
    }
}

async fn collect(body: Body, most: usize) -> Result<Body, Refused> {
    let too_large = || {
        let message = Message::new("server-request-too-large").number("max", (most >> 10) as f64, 0);
        Refused::new(StatusCode::PAYLOAD_TOO_LARGE, "size", message)
    };
    if body.size_hint().lower() > most as u64 {
        return Err(too_large());
    }
    match axum::body::to_bytes(body, most).await {
        Ok(bytes) => Ok(Body::from(bytes)),
        // The only other cause is a closed connection, which reads no answer.
        Err(_) => Err(too_large()),
    }
}
