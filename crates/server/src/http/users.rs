use super::answer::{Answer, Refused};
use super::login::{From, checked};
use super::panel::Panel;
use crate::cell::Change;
use crate::users::Session;
use crate::wire::{OwnPassword, UserChange, UserRow};
use axum::extract::{Path, State};
use axum::http::{HeaderMap, StatusCode};
use axum::{Extension, Json};
use seamwright_message::Message;
use std::sync::Arc;

pub(super) async fn list(State(panel): State<Arc<Panel>>) -> Answer<Vec<UserRow>> {
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
    panel.cell.archive.repeatable(
        &session.user,
        Message::new("server-audit-panel"),
        Message::new("server-audit-own-password"),
        Message::new("server-audit-refused"),
    );
    Err(Refused::new(StatusCode::FORBIDDEN, "password", Message::new("server-own-password")))
}

pub(super) async fn put(
    State(panel): State<Arc<Panel>>,
    from: From,
    headers: HeaderMap,
    Extension(session): Extension<Session>,
    Path(name): Path<String>,
    Json(change): Json<UserChange>,
) -> Answer<UserRow> {
    again(&panel, &from, &headers, &session, change.own_password.clone()).await?;
    if change.only_new == Some(true) && panel.accounts.has(&name) {
        return Err(Refused::new(
            StatusCode::CONFLICT,
            "exists",
            Message::new("server-user-exists").text("user", name),
        ));
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
    panel.audit(
        &session.user,
        Message::new("server-audit-change-user").text("user", &name),
        Change { old: &old, new: &new },
        Message::new("server-audit-changed"),
    );
    Ok(Json(row))
}

pub(super) async fn delete(
    State(panel): State<Arc<Panel>>,
    from: From,
    headers: HeaderMap,
    Extension(session): Extension<Session>,
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
    panel.audit(
        &session.user,
        Message::new("server-audit-delete-user").text("user", &name),
        Change::default(),
        Message::new("server-audit-deleted"),
    );
    Ok(StatusCode::NO_CONTENT)
}
