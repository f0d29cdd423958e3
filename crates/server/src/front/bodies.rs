//! Request bodies, collected completely within limits of size, memory and time.

use super::memory_limit::Room;
use crate::http::{MAX_BYTES, MAX_UNKNOWN, Refused};
use axum::body::Body;
use axum::http::StatusCode;
use hyper::body::Body as _;
use seamwright_message::Message;
use std::sync::Arc;

/// Maximum size of all large bodies being received, bytes, and of those of one user: a slow sender does not block
/// others.
const ROOM: usize = 64 << 20;
const SHARE: usize = 16 << 20;
/// Bodies up to this size, bytes, do not wait for room: the number of connections bounds them.
const SMALL: usize = 64 << 10;

pub(super) struct Bodies(Arc<Room>);

impl Default for Bodies {
    fn default() -> Self {
        Self(Room::new(ROOM, SHARE))
    }
}

impl Bodies {
    /// Collects the body of a client without a session.
    pub(super) async fn stranger(&self, body: Body) -> Result<Body, Refused> {
        collect(body, MAX_UNKNOWN).await
    }

    /// Collects the body of a user with a session, once there is room.
    pub(super) async fn known(&self, user: &str, body: Body) -> Result<Body, Refused> {
        let size = body.size_hint().upper().and_then(|n| usize::try_from(n).ok());
        let most = size.unwrap_or(MAX_BYTES).min(MAX_BYTES);
        if most <= SMALL {
            return collect(body, MAX_BYTES).await;
        }
        let _room = self.0.take(user, most).await;
        collect(body, MAX_BYTES).await
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
