//! Answers being sent: bounded in memory and in the time that their reader may take.

use super::memory_limit::{Room, Taken};
use crate::http::Refused;
use crate::limits::{ANSWER_ROOM_BYTES, ANSWER_ROOM_OF_USER_BYTES, SMALL_BYTES};
use axum::body::{Body, Bytes};
use axum::http::{Response, StatusCode};
use axum::response::IntoResponse as _;
use hyper::body::{Body as HttpBody, Frame, SizeHint};
use seamwright_message::Message;
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll, ready};

/// Maximum size of a piece, bytes: a connection that copies pieces copies little.
const CHUNK: usize = 64 << 10;

pub(super) struct Answers(Arc<Room>);

impl Default for Answers {
    fn default() -> Self {
        Self::with_room(ANSWER_ROOM_BYTES, ANSWER_ROOM_OF_USER_BYTES)
    }
}

impl Answers {
    pub(super) fn with_room(all: usize, share: usize) -> Self {
        Self(Room::new(all, share))
    }

    /// Returns the answer to `user`, which holds its room until its last byte is sent, or a refusal if there is no
    /// room. Streamed answers hold only their pieces.
    pub(super) fn hold(&self, user: &str, response: Response<Body>) -> Response<Body> {
        let Some(size) = size(response.body()).filter(|size| *size > SMALL_BYTES) else { return response };
        let Some(taken) = self.0.try_take(user, size) else {
            let message = Message::new("server-slow-down");
            return Refused::new(StatusCode::SERVICE_UNAVAILABLE, "slow_down", message).into_response();
        };
        response.map(|body| Body::new(Counted { body, rest: Bytes::new(), taken: Arc::new(taken) }))
    }
}

/// Size of a body, bytes, if known.
pub(super) fn size(body: &Body) -> Option<usize> {
    body.size_hint().exact().and_then(|size| usize::try_from(size).ok())
}

/// A body whose bytes hold room until they are sent.
struct Counted {
    body: Body,
    /// Rest of the last piece.
    rest: Bytes,
    taken: Arc<Taken>,
}

struct Piece {
    bytes: Bytes,
    _taken: Arc<Taken>,
}

impl AsRef<[u8]> for Piece {
    fn as_ref(&self) -> &[u8] {
        &self.bytes
    }
}

impl HttpBody for Counted {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        if self.rest.is_empty() {
            let frame = match ready!(Pin::new(&mut self.body).poll_frame(cx)) {
                Some(Ok(frame)) => frame,
                end => return Poll::Ready(end),
            };
            match frame.into_data() {
                Ok(bytes) => self.rest = Bytes::from_owner(Piece { bytes, _taken: Arc::clone(&self.taken) }),
                Err(trailers) => return Poll::Ready(Some(Ok(trailers))),
            }
        }
        let next = self.rest.len().min(CHUNK);
        Poll::Ready(Some(Ok(Frame::data(self.rest.split_to(next)))))
    }

    fn is_end_stream(&self) -> bool {
        self.rest.is_empty() && self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        let (rest, body) = (self.rest.len() as u64, self.body.size_hint());
        body.exact().map_or_else(SizeHint::default, |body| SizeHint::with_exact(rest + body))
    }
}
