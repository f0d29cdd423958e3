use super::answer::{Answer, Refused};
use super::guard::{TOKEN, cookie, cookie_name};
use super::panel::Panel;
use crate::users::{NEEDS, OWNER, Session, may};
use crate::wire::{Login, Role, SessionView};
use axum::extract::{ConnectInfo, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{AppendHeaders, IntoResponse, Response};
use axum::{Extension, Json};
use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::sync::Arc;

/// Most bytes of a name and of a password that are looked at.
const MOST: usize = 512;

pub(super) fn session_view(panel: &Panel, session: &Session) -> SessionView {
    SessionView {
        user: session.user.clone(),
        role: session.role,
        may: NEEDS.iter().filter(|(name, _)| may(session.role, name)).map(|(name, _)| (*name).to_owned()).collect(),
        token: session.token.clone(),
        first_run: !panel.accounts.has_admin(),
    }
}

/// Where a request comes from; without a connection, as in tests, from here.
pub(super) type From = Option<Extension<ConnectInfo<SocketAddr>>>;

pub(super) fn address(from: &From) -> IpAddr {
    from.as_ref().map_or(IpAddr::V4(Ipv4Addr::LOCALHOST), |from| from.0.0.ip())
}

/// Checks the password of `user`: one at a time, and slower with every wrong one. What was checked, if it was right.
pub(super) async fn checked(
    panel: &Arc<Panel>,
    from: &From,
    user: &str,
    password: String,
) -> Result<Option<(Role, String)>, Refused> {
    let (from, user, asked) = (address(from), user.to_owned(), Arc::clone(panel));
    let wait = move |asked: &Panel, user: &str| match asked.tries.waits(from, user) {
        Some(wait) => {
            let text = format!("too many wrong passwords: wait {:.0} s", wait.as_secs_f64().ceil());
            Err(Refused::new(StatusCode::TOO_MANY_REQUESTS, "slow_down", text))
        }
        None => Ok(()),
    };
    wait(panel, &user)?;
    let check = move || {
        // Others may have guessed while this one waited for its turn.
        wait(&asked, &user)?;
        let right = match user.as_str() {
            OWNER => {
                let right = !asked.accounts.has_admin() && same(password.as_bytes(), asked.key.as_bytes());
                right.then(|| (Role::Admin, String::new()))
            }
            _ => asked.accounts.check(&user, &password),
        };
        asked.tries.tried(from, &user, right.is_some());
        Ok(right)
    };
    panel.checking.run(check).await
}

pub(super) async fn login(
    State(panel): State<Arc<Panel>>,
    from: From,
    headers: HeaderMap,
    Json(login): Json<Login>,
) -> Result<Response, Refused> {
    if headers.get(TOKEN).is_none_or(|v| v != "login") {
        let text = format!("the header `{TOKEN}` must say `login`");
        return Err(Refused::new(StatusCode::FORBIDDEN, "token", text));
    }
    if login.user.len() > MOST || login.password.len() > MOST {
        return Err(Refused::input(format!("name or password is too long; allowed: up to {MOST} bytes")));
    }
    let name = if login.user.is_empty() { OWNER.to_owned() } else { login.user };
    let right = checked(&panel, &from, &name, login.password).await?;
    let station = format!("panel at {}", address(&from));
    let result = if right.is_some() { "logged in" } else { "refused" };
    panel.cell.archive.audit(&name, &station, "log in", ("", ""), result);
    let wrong = || {
        let text = "name or password is wrong, or the address is an old one";
        Refused::new(StatusCode::UNAUTHORIZED, "login", text)
    };
    let right = right.ok_or_else(wrong)?;
    if let Some(before) = cookie(&headers, panel.tls) {
        panel.sessions.end(before);
    }
    let (cookie, session) = panel.sessions.begin(&name, right.0).map_err(Refused::server)?;
    // A password that was changed while it was checked opens nothing.
    let still = if name == OWNER { !panel.accounts.has_admin() } else { panel.accounts.is_still(&name, &right) };
    if !still {
        panel.sessions.end(&cookie);
        return Err(wrong());
    }
    let set = set_cookie(&panel, &cookie, "");
    let view = Json(session_view(&panel, &session));
    Ok((AppendHeaders([(header::SET_COOKIE, set)]), view).into_response())
}

fn set_cookie(panel: &Panel, value: &str, more: &str) -> String {
    let (name, secure) = (cookie_name(panel.tls), if panel.tls { "; Secure" } else { "" });
    format!("{name}={value}; Path=/; HttpOnly; SameSite=Strict{secure}{more}")
}

/// Compares without telling by its time how much was right.
pub(super) fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).fold(0, |differ, (a, b)| differ | (a ^ b)) == 0
}

pub(super) async fn logout(
    State(panel): State<Arc<Panel>>,
    Extension(session): Extension<Session>,
    headers: HeaderMap,
) -> Response {
    if let Some(cookie) = cookie(&headers, panel.tls) {
        panel.sessions.end(cookie);
    }
    panel.cell.archive.audit(&session.user, "panel", "log out", ("", ""), "logged out");
    let gone = set_cookie(&panel, "", "; Max-Age=0");
    (StatusCode::NO_CONTENT, AppendHeaders([(header::SET_COOKIE, gone)])).into_response()
}

pub(super) async fn session(
    State(panel): State<Arc<Panel>>,
    Extension(session): Extension<Session>,
) -> Answer<SessionView> {
    Ok(Json(session_view(&panel, &session)))
}
