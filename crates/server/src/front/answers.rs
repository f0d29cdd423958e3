//! Answers on their way out: bounded in memory, and in the time that their reader may take.

use super::room::{Room, Taken};
use crate::http::Refused;
use axum::body::{Body, Bytes};
use axum::http::{Response, StatusCode};
use axum::response::IntoResponse as _;
use hyper::body::{Body as HttpBody, Frame, SizeHint};
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll, ready};

/// Bytes of all large answers together that are held until their readers have them, and of those of one user: enough for the largest
/// one.
const ROOM: usize = 256 << 20;
const SHARE: usize = 128 << 20;
/// Answers of up to so many bytes take no room: connections are few enough for them.
const SMALL: usize = 64 << 10;
/// Bytes that are handed on at a time: where a connection copies them, it copies few.
const CHUNK: usize = 64 << 10;

/// Room for answers.
pub(super) struct Answers(Arc<Room>);

impl Default for Answers {
    fn default() -> Self {
        Self::with_room(ROOM, SHARE)
    }
}

impl Answers {
    pub(super) fn with_room(all: usize, share: usize) -> Self {
        Self(Room::new(all, share))
    }

    /// An answer to `user` with the room that it takes until its last byte is sent; a refusal if there is none. What is streamed holds no
    /// more than its pieces.
    pub(super) fn hold(&self, user: &str, response: Response<Body>) -> Response<Body> {
        let Some(size) = size(response.body()).filter(|size| *size > SMALL) else { return response };
        let Some(taken) = self.0.try_take(user, size) else {
            let text = "too much of this is asked for at once: try again in a moment";
            return Refused::new(StatusCode::SERVICE_UNAVAILABLE, "slow_down", text).into_response();
        };
        response.map(|body| Body::new(Counted { body, rest: Bytes::new(), taken: Arc::new(taken) }))
    }
}

/// Bytes of a body, if it is known how many there are.
pub(super) fn size(body: &Body) -> Option<usize> {
    body.size_hint().exact().and_then(|size| usize::try_from(size).ok())
}

/// A body whose bytes hold room, wherever they wait to be sent.
struct Counted {
    body: Body,
    /// Of the piece that came last, what is still to be handed on.
    rest: Bytes,
    taken: Arc<Taken>,
}

/// A piece of a body, with its room.
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
