//! Access of monitoring tools: from this computer, with a token, or by a session.

use super::answer::Refused;
use super::guard::{cookie, role_refused};
use super::login::{From, address, same};
use super::panel::{Panel, Shared};
use crate::users::may;
use axum::extract::{Request, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse as _, Response};
use seamwright_message::Message;

/// Action in the table of permissions.
pub(super) const ACTION: &str = "diagnose";

/// Headers by which a proxy on this computer passes on requests of others.
const FORWARDED: [&str; 4] = ["forwarded", "via", "x-forwarded-for", "x-real-ip"];

/// Passes a request on if it comes from this computer, has the token of monitoring tools, or a session that may look.
pub(super) async fn monitor(State(panel): Shared, from: From, request: Request, next: Next) -> Response {
    match allowed(&panel, &from, request.headers()) {
        Ok(()) => next.run(request).await,
        Err(refused) => refused.into_response(),
    }
}

fn allowed(panel: &Panel, from: &From, headers: &HeaderMap) -> Result<(), Refused> {
    let is_forwarded = FORWARDED.iter().any(|name| headers.contains_key(*name));
    if address(from).to_canonical().is_loopback() && !is_forwarded {
        return Ok(());
    }
    let sent = headers.get(header::AUTHORIZATION).and_then(|value| value.to_str().ok()?.strip_prefix("Bearer "));
    if let (Some(token), Some(sent)) = (&panel.diagnostics.token, sent)
        && same(token.as_bytes(), sent.as_bytes())
    {
        return Ok(());
    }
    // Asking does not prolong a session.
    let session = cookie(headers, panel.tls).and_then(|cookie| panel.sessions.known(cookie));
    match session.filter(|session| panel.stands(session, false)) {
        Some(session) if may(session.role, ACTION) => Ok(()),
        Some(session) => Err(Refused::new(StatusCode::FORBIDDEN, "role", role_refused(session.role, ACTION))),
        None => Err(Refused::new(StatusCode::UNAUTHORIZED, "login", Message::new("server-monitor-login"))),
    }
}
