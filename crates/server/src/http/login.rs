use super::answer::{Answer, Refused};
use super::guard::{COOKIE, TOKEN, cookie};
use super::panel::Panel;
use crate::users::{NEEDS, Session, may};
use crate::wire::{Login, Role, SessionView};
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{AppendHeaders, IntoResponse, Response};
use axum::{Extension, Json};
use std::sync::Arc;

/// Name of whoever has the printed address while there is no administrator.
const OWNER: &str = "owner";

pub(super) fn session_view(panel: &Panel, session: &Session) -> SessionView {
    SessionView {
        user: session.user.clone(),
        role: session.role,
        may: NEEDS.iter().filter(|(name, _)| may(session.role, name)).map(|(name, _)| (*name).to_owned()).collect(),
        token: session.token.clone(),
        first_run: !panel.accounts.has_admin(),
    }
}

pub(super) async fn login(
    State(panel): State<Arc<Panel>>,
    headers: HeaderMap,
    Json(login): Json<Login>,
) -> Result<Response, Refused> {
    if headers.get(TOKEN).is_none_or(|v| v != "login") {
        let text = format!("the header `{TOKEN}` must say `login`");
        return Err(Refused::new(StatusCode::FORBIDDEN, "token", text));
    }
    let name = if login.user.is_empty() { OWNER.to_owned() } else { login.user.clone() };
    if let Some(wait) = panel.sessions.waits(&name) {
        let text = format!("too many wrong passwords: wait {:.0} s", wait.as_secs_f64().ceil());
        return Err(Refused::new(StatusCode::TOO_MANY_REQUESTS, "slow_down", text));
    }
    let role = if login.user.is_empty() {
        let key = !panel.accounts.has_admin() && same(login.password.as_bytes(), panel.key.as_bytes());
        key.then_some(Role::Admin)
    } else {
        let panel = Arc::clone(&panel);
        tokio::task::spawn_blocking(move || panel.accounts.check(&login.user, &login.password)).await?
    };
    panel.sessions.tried(&name, role.is_some());
    let result = if role.is_some() { "logged in" } else { "refused" };
    panel.cell.archive.audit(&name, "panel", "log in", ("", ""), result);
    let Some(role) = role else {
        let text = "name or password is wrong, or the address is an old one";
        return Err(Refused::new(StatusCode::UNAUTHORIZED, "login", text));
    };
    let (cookie, session) = panel.sessions.begin(&name, role).map_err(Refused::server)?;
    let secure = if panel.tls { "; Secure" } else { "" };
    let cookie = format!("{COOKIE}={cookie}; Path=/; HttpOnly; SameSite=Strict{secure}");
    let view = Json(session_view(&panel, &session));
    Ok((AppendHeaders([(header::SET_COOKIE, cookie)]), view).into_response())
}

/// Compares without telling by its time how much was right.
fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).fold(0, |differ, (a, b)| differ | (a ^ b)) == 0
}

pub(super) async fn logout(
    State(panel): State<Arc<Panel>>,
    Extension(session): Extension<Session>,
    headers: HeaderMap,
) -> Response {
    if let Some(cookie) = cookie(&headers) {
        panel.sessions.end(cookie);
    }
    panel.cell.archive.audit(&session.user, "panel", "log out", ("", ""), "logged out");
    let gone = format!("{COOKIE}=; Path=/; HttpOnly; SameSite=Strict; Max-Age=0");
    (StatusCode::NO_CONTENT, AppendHeaders([(header::SET_COOKIE, gone)])).into_response()
}

pub(super) async fn session(
    State(panel): State<Arc<Panel>>,
    Extension(session): Extension<Session>,
) -> Answer<SessionView> {
    Ok(Json(session_view(&panel, &session)))
}
