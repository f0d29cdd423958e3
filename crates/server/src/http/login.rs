use super::answer::{Answer, Refused};
use super::guard::{TOKEN, cookie, cookie_name, device_name, named_cookie};
use super::panel::{Panel, Shared};
use crate::cell::Change;
use crate::limits::MAX_LOGIN_BYTES;
use crate::users::{NEEDS, OWNER, Origin, Session, may};
use crate::wire::{Login, Role, SessionView};
use axum::extract::{ConnectInfo, State};
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{AppendHeaders, IntoResponse, Response};
use axum::{Extension, Json};
use seamwright_log as log;
use seamwright_message::{Message, Unit};
use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::time::{Duration, Instant};

pub(super) fn session_view(panel: &Panel, session: &Session) -> SessionView {
    SessionView {
        user: session.user.clone(),
        role: session.role,
        may: NEEDS.iter().filter(|(name, _)| may(session.role, name)).map(|(name, _)| (*name).to_owned()).collect(),
        token: session.token.clone(),
        first_run: !panel.accounts.has_admin(),
    }
}

/// Address of a request; without a connection, as in tests, this computer.
pub(super) type From = Option<Extension<ConnectInfo<SocketAddr>>>;

pub(super) fn address(from: &From) -> IpAddr {
    from.as_ref().map_or(IpAddr::V4(Ipv4Addr::LOCALHOST), |from| from.0.0.ip())
}

/// Returns the words for the panel at an address, for the audit log.
pub(super) fn panel_at(address: IpAddr) -> Message {
    Message::new("server-audit-panel-at").text("address", address.to_string())
}

/// Minimum time of the answer to a wrong password: it does not reveal which users exist.
const ANSWER: Duration = Duration::from_millis(300);

fn slowed(wait: Duration) -> Refused {
    let message = Message::new("server-wrong-passwords").quantity("wait", wait.as_secs_f64().ceil(), Unit::S, 0);
    Refused::new(StatusCode::TOO_MANY_REQUESTS, "slow_down", message)
}

/// Checks the password of `user`: one at a time, and slower after each wrong one. Returns the checked role and hash if
/// it was right.
pub(super) async fn checked(
    panel: &Arc<Panel>,
    from: &From,
    headers: &HeaderMap,
    user: &str,
    password: String,
) -> Result<Option<(Role, String)>, Refused> {
    let begin = Instant::now();
    let device = named_cookie(headers, device_name(panel.tls)).and_then(|cookie| panel.devices.of(cookie, user));
    let origin = Origin { address: address(from), device };
    if let Some(wait) = panel.tries.waits(&origin, user) {
        return Err(slowed(wait));
    }
    let right = if user == OWNER || panel.accounts.role(user).is_some() {
        // Too many checks of this name are waiting: refused as after wrong passwords.
        let check = panel.checks.begin(user).ok_or_else(|| slowed(Duration::from_secs(2)))?;
        let (asked, user) = (Arc::clone(panel), user.to_owned());
        let work = move || {
            let _check = check;
            fits(&asked, &origin, &user, &password)
        };
        panel.checking.run(work).await?
    } else {
        // Invented names take neither time nor checks from others.
        panel.tries.tried(&origin, user, false);
        None
    };
    if right.is_none() {
        tokio::time::sleep(ANSWER.saturating_sub(begin.elapsed())).await;
    }
    Ok(right)
}

fn fits(panel: &Panel, origin: &Origin, user: &str, password: &str) -> Result<Option<(Role, String)>, Refused> {
    // Others may have guessed while this check waited.
    if let Some(wait) = panel.tries.waits(origin, user) {
        return Err(slowed(wait));
    }
    let right = match user {
        OWNER => {
            let right = !panel.accounts.has_admin() && same(password.as_bytes(), panel.key.as_bytes());
            right.then(|| (Role::Admin, String::new()))
        }
        _ => panel.accounts.check(user, password),
    };
    panel.tries.tried(origin, user, right.is_some());
    Ok(right)
}

pub(super) async fn login(
    State(panel): Shared,
    from: From,
    headers: HeaderMap,
    Json(login): Json<Login>,
) -> Result<Response, Refused> {
    if headers.get(TOKEN).is_none_or(|v| v != "login") {
        let message = Message::new("server-header").text("header", TOKEN).text("value", "login");
        return Err(Refused::new(StatusCode::FORBIDDEN, "token", message));
    }
    if login.user.len() > MAX_LOGIN_BYTES || login.password.len() > MAX_LOGIN_BYTES {
        return Err(Message::new("server-login-too-long").value("max", MAX_LOGIN_BYTES as f64, Unit::Byte).into());
    }
    let name = if login.user.is_empty() { OWNER.to_owned() } else { login.user };
    let right = checked(&panel, &from, &headers, &name, login.password).await?;
    let station = panel_at(address(&from));
    panel.diagnostics.counts.login(right.is_some());
    let (archive, command) = (&panel.cell.archive, Message::new("server-audit-log-in"));
    if right.is_some() {
        archive.audit(&name, station, command, Change::default(), Message::new("server-audit-logged-in"));
    } else {
        archive.refused(&name, station, command, Message::new("server-audit-refused"));
    }
    let wrong = || Refused::new(StatusCode::UNAUTHORIZED, "login", Message::new("server-login-wrong"));
    let right = right.ok_or_else(wrong)?;
    if let Some(before) = cookie(&headers, panel.tls) {
        panel.sessions.end(before);
    }
    let (cookie, session) = panel.sessions.begin(&name, right.0).map_err(Refused::server)?;
    // A password that was changed during the check does not open a session.
    let still =
        if name == OWNER { !panel.accounts.has_admin() } else { panel.accounts.is_still(&name, right.0, &right.1) };
    if !still {
        panel.sessions.end(&cookie);
        return Err(wrong());
    }
    let logged_in = Message::new("server-log-logged-in").text("user", &name);
    log::info(&logged_in.text("address", address(&from).to_string()));
    let mut set = vec![(header::SET_COOKIE, set_cookie(&panel, cookie_name(panel.tls), &cookie, ""))];
    let device = named_cookie(&headers, device_name(panel.tls));
    if device.and_then(|cookie| panel.devices.of(cookie, &name)).is_none() {
        let device = panel.devices.remember(&name).map_err(Refused::server)?;
        set.push((header::SET_COOKIE, set_cookie(&panel, device_name(panel.tls), &device, DEVICE_AGE)));
        keep_devices(&panel);
    }
    let mut response = Json(session_view(&panel, &session)).into_response();
    for (name, value) in set {
        let value = HeaderValue::try_from(value).map_err(|e| Refused::server(e.to_string()))?;
        response.headers_mut().append(name, value);
    }
    Ok(response)
}

/// Lifetime of the cookie of a known browser, s: half a year.
const DEVICE_AGE: &str = "; Max-Age=15552000";

fn set_cookie(panel: &Panel, name: &str, value: &str, more: &str) -> String {
    let secure = if panel.tls { "; Secure" } else { "" };
    format!("{name}={value}; Path=/; HttpOnly; SameSite=Strict{secure}{more}")
}

/// Writes known browsers in a thread that may wait for the disk.
pub(super) fn keep_devices(panel: &Arc<Panel>) {
    let panel = Arc::clone(panel);
    drop(tokio::task::spawn_blocking(move || panel.devices.save()));
}

/// Compares in constant time, so that the duration does not reveal matching bytes.
pub(super) fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).fold(0, |differ, (a, b)| differ | (a ^ b)) == 0
}

pub(super) async fn logout(State(panel): Shared, session: Session, headers: HeaderMap) -> Response {
    if let Some(cookie) = cookie(&headers, panel.tls) {
        panel.sessions.end(cookie);
    }
    let command = Message::new("server-audit-log-out");
    panel.audit(&session.user, command, Change::default(), Message::new("server-audit-logged-out"));
    let gone = set_cookie(&panel, cookie_name(panel.tls), "", "; Max-Age=0");
    (StatusCode::NO_CONTENT, AppendHeaders([(header::SET_COOKIE, gone)])).into_response()
}

pub(super) async fn session(State(panel): Shared, session: Session) -> Answer<SessionView> {
    Ok(Json(session_view(&panel, &session)))
}
