use super::answer::{Answer, Refused};
use super::login::{From, address, checked, panel_at};
use super::panel::{Panel, Shared};
use crate::cell::Change;
use crate::users::Session;
use crate::wire::{OwnPassword, UserChange, UserRow};
use axum::Json;
use axum::extract::{Path, State};
use axum::http::{HeaderMap, StatusCode};
use seamwright_message::Message;
use std::sync::Arc;

pub(super) async fn list(State(panel): Shared) -> Answer<Vec<UserRow>> {
    Ok(Json(panel.accounts.list()))
}

/// Checks the user's own password again before users or all data are changed; without an administrator none is needed.
pub(super) async fn again(
    panel: &Arc<Panel>,
    from: &From,
    headers: &HeaderMap,
    session: &Session,
    password: Option<String>,
) -> Result<(), Refused> {
    if !panel.accounts.has_admin() {
        return Ok(());
    }
    if checked(panel, from, headers, &session.user, password.unwrap_or_default()).await?.is_some() {
        return Ok(());
    }
    let [command, refused] = ["server-audit-own-password", "server-audit-refused"].map(Message::new);
    panel.cell.archive.refused(&session.user, panel_at(address(from)), command, refused);
    Err(Refused::new(StatusCode::FORBIDDEN, "password", Message::new("server-own-password")))
}

pub(super) async fn put(
    State(panel): Shared,
    from: From,
    headers: HeaderMap,
    session: Session,
    Path(name): Path<String>,
    Json(change): Json<UserChange>,
) -> Answer<UserRow> {
    again(&panel, &from, &headers, &session, change.own_password.clone()).await?;
    if change.only_new == Some(true) && panel.accounts.has(&name) {
        let message = Message::new("server-user-exists").text("user", name);
        return Err(Refused::new(StatusCode::CONFLICT, "exists", message));
    }
    let old = panel.accounts.role(&name).map_or(String::new(), |role| format!("{role:?}"));
    let (changed, user) = (Arc::clone(&panel), name.clone());
    let put = move || Ok(changed.accounts.put(&user, change.role, change.enabled, change.password.as_deref())?);
    let row = panel.saving.run(put).await?;
    // Ends sessions with the former permissions.
    panel.sessions.end_all_of(&name);
    panel.devices.forget(&name);
    super::login::keep_devices(&panel);
    let new = format!("{:?}{}", row.role, if row.enabled { "" } else { ", disabled" });
    let command = Message::new("server-audit-change-user").text("user", &name);
    panel.audit(&session.user, command, Change { old: &old, new: &new }, Message::new("server-audit-changed"));
    Ok(Json(row))
}

pub(super) async fn delete(
    State(panel): Shared,
    from: From,
    headers: HeaderMap,
    session: Session,
    Path(name): Path<String>,
    Json(own): Json<OwnPassword>,
) -> Result<StatusCode, Refused> {
    again(&panel, &from, &headers, &session, own.own_password).await?;
    let (changed, user) = (Arc::clone(&panel), name.clone());
    if !panel.saving.run(move || Ok(changed.accounts.remove(&user)?)).await? {
        return Err(Refused::not_found(Message::new("server-no-user").text("user", name)));
    }
    panel.sessions.end_all_of(&name);
    panel.devices.forget(&name);
    super::login::keep_devices(&panel);
    let command = Message::new("server-audit-delete-user").text("user", &name);
    panel.audit(&session.user, command, Change::default(), Message::new("server-audit-deleted"));
    Ok(StatusCode::NO_CONTENT)
}
