use crate::{users, wire};
use axum::Json;
use axum::http::{StatusCode, header};
use axum::response::{Html, IntoResponse, Response};
use seamwright_message::Message;
use seamwright_project::Failure;

/// Content type of most bodies.
pub(super) const JSON: &str = "application/json";

#[derive(Debug)]
pub(crate) struct Refused {
    pub(crate) status: StatusCode,
    pub(crate) key: &'static str,
    pub(crate) message: Message,
}

impl Refused {
    pub(crate) fn new(status: StatusCode, key: &'static str, message: impl Into<Message>) -> Self {
        Self { status, key, message: message.into() }
    }

    /// Restores the refusal of a child process of this program.
    pub(crate) fn known(status: u16, key: &str, message: Message) -> Self {
        let status = StatusCode::from_u16(status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
        let key = ["input", "not_found"].into_iter().find(|known| *known == key).unwrap_or("server");
        Self { status, key, message }
    }

    pub(crate) fn input(message: impl Into<Message>) -> Self {
        Self::new(StatusCode::UNPROCESSABLE_ENTITY, "input", message)
    }

    pub(crate) fn not_found(message: impl Into<Message>) -> Self {
        Self::new(StatusCode::NOT_FOUND, "not_found", message)
    }

    pub(crate) fn server(message: impl Into<Message>) -> Self {
        Self::new(StatusCode::INTERNAL_SERVER_ERROR, "server", message)
    }
}

impl IntoResponse for Refused {
    fn into_response(self) -> Response {
        let trouble = wire::Trouble { key: self.key.to_owned(), message: self.message.into() };
        (self.status, Json(trouble)).into_response()
    }
}

/// Fault of a request.
impl From<Message> for Refused {
    fn from(message: Message) -> Self {
        Self::input(message)
    }
}

impl From<Failure> for Refused {
    fn from(failure: Failure) -> Self {
        match &failure {
            Failure::Environment(_) => Self::server(failure.message()),
            _ => Self::input(failure.message()),
        }
    }
}

impl From<seamwright_record::Error> for Refused {
    fn from(e: seamwright_record::Error) -> Self {
        if matches!(e, seamwright_record::Error::Interrupted { .. }) {
            return Self::new(StatusCode::SERVICE_UNAVAILABLE, "slow_down", e.message());
        }
        if e.is_input() { Self::not_found(e.message()) } else { Self::server(e.message()) }
    }
}

impl From<users::Trouble> for Refused {
    fn from(e: users::Trouble) -> Self {
        Self::input(e.0)
    }
}

impl From<tokio::task::JoinError> for Refused {
    fn from(_: tokio::task::JoinError) -> Self {
        Self::server(Message::new("server-failed"))
    }
}

/// Result of most handlers.
pub(crate) type Answer<T> = Result<Json<T>, Refused>;

/// Returns a report as an HTML page with its own styles and without scripts.
pub(super) fn page_of(html: String) -> Response {
    let policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; \
                  base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    ([(header::CONTENT_SECURITY_POLICY, policy)], Html(html)).into_response()
}
