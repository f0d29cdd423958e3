use super::answer::{Answer, Refused};
use super::login::{From, checked};
use super::panel::Panel;
use crate::users::Session;
use crate::wire::{OwnPassword, UserChange, UserRow};
use axum::extract::{Path, State};
use axum::http::{HeaderMap, StatusCode};
use axum::{Extension, Json};
use std::sync::Arc;

pub(super) async fn list(State(panel): State<Arc<Panel>>) -> Answer<Vec<UserRow>> {
    Ok(Json(panel.accounts.list()))
}

/// Checks the user's own password again before users or all data are changed; without an administrator none is needed.
pub(super) async fn again(
    panel: &Arc<Panel>,
    from: (&From, &HeaderMap),
    session: &Session,
    password: Option<String>,
) -> Result<(), Refused> {
    if !panel.accounts.has_admin() {
        return Ok(());
    }
    if checked(panel, from, &session.user, password.unwrap_or_default()).await?.is_some() {
        return Ok(());
    }
    panel.cell.archive.repeatable(&session.user, "panel", "own password", "refused");
    Err(Refused::new(StatusCode::FORBIDDEN, "password", "your own password is needed for this, and it is wrong"))
}

pub(super) async fn put(
    State(panel): State<Arc<Panel>>,
    from: From,
    headers: HeaderMap,
    Extension(session): Extension<Session>,
    Path(name): Path<String>,
    Json(change): Json<UserChange>,
) -> Answer<UserRow> {
    again(&panel, (&from, &headers), &session, change.own_password.clone()).await?;
    if change.only_new == Some(true) && panel.accounts.has(&name) {
        return Err(Refused::new(StatusCode::CONFLICT, "exists", format!("there is a user `{name}` already")));
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
    panel.cell.archive.audit(&session.user, "panel", &format!("change user {name}"), (&old, &new), "changed");
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
    again(&panel, (&from, &headers), &session, own.own_password).await?;
    let (changed, user) = (Arc::clone(&panel), name.clone());
    if !panel.saving.run(move || Ok(changed.accounts.remove(&user)?)).await? {
        return Err(Refused::not_found(format!("there is no user `{name}`")));
    }
    panel.sessions.end_all_of(&name);
    panel.devices.forget(&name);
    super::login::keep_devices(&panel);
    panel.cell.archive.audit(&session.user, "panel", &format!("delete user {name}"), ("", ""), "deleted");
    Ok(StatusCode::NO_CONTENT)
}
