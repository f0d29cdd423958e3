use super::answer::Refused;
use super::login::{panel_at, same};
use super::panel::{Panel, Shared};
use super::work_limit::asked_by;
use crate::refusal::{action_word, panel_word};
use crate::users::{Session, may};
use crate::wire::Role;
use axum::Extension;
use axum::extract::rejection::ExtensionRejection;
use axum::extract::{ConnectInfo, FromRequestParts, Request, State};
use axum::http::request::Parts;
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use seamwright_message::Message;
use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::sync::Arc;

/// Header that requests with changes must carry.
pub(super) const TOKEN: &str = "x-seamwright";
/// Cookie of a session.
pub(super) const COOKIE: &str = "seamwright";
/// The same for encrypted connections: browsers accept such a name only from this host and encrypted.
const COOKIE_TLS: &str = "__Host-seamwright";

pub(super) fn cookie_name(tls: bool) -> &'static str {
    if tls { COOKIE_TLS } else { COOKIE }
}

/// Returns the name of the cookie of a known browser.
pub(super) fn device_name(tls: bool) -> &'static str {
    if tls { "__Host-seamwright-device" } else { "seamwright-device" }
}

#[derive(Clone)]
pub(super) struct Need {
    pub(super) panel: Arc<Panel>,
    /// Action in the table of permissions; `None`: no login needed.
    pub(super) action: Option<&'static str>,
    /// Content type of requests with changes: one that a form of a foreign page cannot send.
    pub(super) takes: &'static str,
}

/// Refuses requests with an unknown host name before anything else (DNS rebinding), and requests from foreign pages.
pub(super) async fn host(State(panel): Shared, request: Request, next: Next) -> Response {
    let headers = request.headers();
    let host = text(headers, header::HOST.as_str()).unwrap_or_default();
    if !panel.hosts.iter().any(|known| known.eq_ignore_ascii_case(host)) {
        let message = Message::new("server-unknown-host").text("host", host).text("allowed", panel.hosts.join(", "));
        return secured(Refused::new(StatusCode::FORBIDDEN, "origin", message).into_response());
    }
    let scheme = if panel.tls { "https" } else { "http" };
    if let Some(origin) = text(headers, header::ORIGIN.as_str())
        && !origin.eq_ignore_ascii_case(&format!("{scheme}://{host}"))
    {
        return secured(foreign());
    }
    // Browsers send this header even without an origin. A link to the panel itself may come from any page.
    let site = text(headers, "sec-fetch-site").unwrap_or("none");
    if request.uri().path().starts_with("/api/") && !matches!(site, "same-origin" | "none") {
        return secured(foreign());
    }
    secured(next.run(request).await)
}

fn foreign() -> Response {
    Refused::new(StatusCode::FORBIDDEN, "origin", Message::new("server-other-origin")).into_response()
}

/// Adds the headers of every answer.
fn secured(mut response: Response) -> Response {
    let csp = "default-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    let headers = response.headers_mut();
    for (name, value) in [
        ("content-security-policy", csp),
        ("x-content-type-options", "nosniff"),
        ("x-frame-options", "DENY"),
        ("referrer-policy", "no-referrer"),
        ("cross-origin-opener-policy", "same-origin"),
        ("cross-origin-resource-policy", "same-origin"),
    ] {
        headers.entry(name).or_insert(HeaderValue::from_static(value));
    }
    headers.entry(header::CACHE_CONTROL).or_insert(HeaderValue::from_static("no-store"));
    response
}

impl<S: Send + Sync> FromRequestParts<S> for Session {
    type Rejection = ExtensionRejection;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, ExtensionRejection> {
        Extension::from_request_parts(parts, state).await.map(|Extension(session)| session)
    }
}

/// Passes a request on if its user may do the action; the handler finds the [`Session`] in the extensions.
pub(super) async fn need(State(need): State<Need>, mut request: Request, next: Next) -> Response {
    let Some(action) = need.action else {
        return match is_of(need.takes, request.headers()) {
            Err(refused) if writes(request.method()) => refused.into_response(),
            _ => next.run(request).await,
        };
    };
    let address = request.extensions().get::<ConnectInfo<SocketAddr>>().map(|from| from.0.ip());
    match allowed(&need, action, &request, address.unwrap_or(IpAddr::V4(Ipv4Addr::LOCALHOST))) {
        Ok(session) => {
            request.extensions_mut().insert(session.clone());
            asked_by(&session, next.run(request)).await
        }
        Err(refused) => refused.into_response(),
    }
}

/// Describes that a role does not allow an action, and which role does.
pub(super) fn role_refused(role: Role, action: &str) -> Message {
    let name = |role: Role| panel_word("role", &format!("{role:?}").to_lowercase());
    let needed = crate::users::least(action);
    let message = Message::new(if needed.is_some() { "server-role-from" } else { "server-role" });
    let message = message.message("role", name(role)).message("action", action_word(action));
    needed.into_iter().fold(message, |message, needed| message.message("needed", name(needed)))
}

fn allowed(need: &Need, action: &str, request: &Request, from: IpAddr) -> Result<Session, Refused> {
    let (panel, headers) = (&need.panel, request.headers());
    let session = cookie(headers, panel.tls).and_then(|cookie| panel.sessions.of(cookie));
    let session = session.filter(|session| panel.stands(session, true));
    let Some(session) = session else {
        return Err(Refused::new(StatusCode::UNAUTHORIZED, "login", Message::new("server-not-logged-in")));
    };
    if !may(session.role, action) {
        let refused = Message::new("server-audit-refused-role");
        panel.cell.archive.refused(&session.user, panel_at(from), action_word(action), refused);
        return Err(Refused::new(StatusCode::FORBIDDEN, "role", role_refused(session.role, action)));
    }
    if writes(request.method()) {
        let token = text(headers, TOKEN).unwrap_or_default();
        if !same(token.as_bytes(), session.token.as_bytes()) {
            let message = Message::new("server-token").text("header", TOKEN);
            panel.cell.archive.refused(&session.user, panel_at(from), action_word(action), message.clone());
            return Err(Refused::new(StatusCode::FORBIDDEN, "token", message));
        }
        is_of(need.takes, headers)?;
    }
    Ok(session)
}

fn writes(method: &Method) -> bool {
    !matches!(*method, Method::GET | Method::HEAD)
}

fn is_of(takes: &str, headers: &HeaderMap) -> Result<(), Refused> {
    let kind = text(headers, header::CONTENT_TYPE.as_str()).unwrap_or_default();
    if kind.split(';').next().is_some_and(|kind| kind.trim() == takes) {
        return Ok(());
    }
    let message = Message::new("server-content-type").text("kind", kind).text("allowed", takes);
    Err(Refused::new(StatusCode::UNSUPPORTED_MEDIA_TYPE, "input", message))
}

fn text<'a>(headers: &'a HeaderMap, name: &str) -> Option<&'a str> {
    headers.get(name).and_then(|value| value.to_str().ok())
}

pub(crate) fn cookie(headers: &HeaderMap, tls: bool) -> Option<&str> {
    named_cookie(headers, cookie_name(tls))
}

pub(super) fn named_cookie<'a>(headers: &'a HeaderMap, wanted: &str) -> Option<&'a str> {
    let all = headers.get_all(header::COOKIE).into_iter().filter_map(|v| v.to_str().ok());
    let pairs = all.flat_map(|v| v.split(';')).filter_map(|pair| pair.trim().split_once('='));
    pairs.into_iter().find(|(name, _)| *name == wanted).map(|(_, value)| value)
}
