use super::answer::{Answer, Refused};
use super::panel::Shared;
use super::plan::alone;
use crate::teaching::program;
use crate::wire::{StandingView, TaughtProgram, TaughtView, TeachProgram};
use axum::Json;
use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse as _, Response};
use seamwright_message::Message;

/// Returns the standing position of the machine, for recording a point. Refused during motion: a passed position would
/// be outdated when recorded.
pub(super) async fn position(State(panel): Shared) -> Answer<StandingView> {
    let refused = |message: Message| Refused::new(StatusCode::CONFLICT, "busy", message);
    let hub = &panel.cell.hub;
    let known = hub.latest().zip(hub.machine());
    let (status, machine) = known.ok_or_else(|| refused(Message::new("server-cell-silent")))?;
    if !status.stands {
        return Err(refused(Message::new("server-axes-moving")));
    }
    if let Some((axis, _)) = machine.axes.iter().zip(&status.axes).find(|(_, axis)| !axis.referenced) {
        return Err(refused(Message::new("server-not-homed").axis("axis", &axis.name)));
    }
    Ok(Json(StandingView { axes: status.axes.iter().map(|axis| axis.position).collect(), tip: status.tip }))
}

pub(super) async fn taught(State(panel): Shared) -> Answer<TaughtView> {
    Ok(Json(panel.teaching.taught()))
}

pub(super) async fn picture(State(panel): Shared) -> Result<Response, Refused> {
    let png = panel.teaching.picture().ok_or_else(|| Refused::not_found(Message::new("server-no-image")))?;
    Ok(([(header::CONTENT_TYPE, "image/png")], png.to_vec()).into_response())
}

pub(super) async fn made(State(panel): Shared, Json(asked): Json<TeachProgram>) -> Answer<TaughtProgram> {
    alone(&panel, move |panel| Ok(program(&panel.teaching, &asked)?)).await.map(Json)
}
