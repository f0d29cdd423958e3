use super::answer::{Answer, Refused};
use super::panel::Panel;
use super::plan::alone;
use crate::teaching::program;
use crate::wire::{StandingView, TaughtProgram, TaughtView, TeachProgram};
use axum::Json;
use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse as _, Response};
use std::sync::Arc;

/// Where the machine stands, for who records a place. Only what stands is there: a place that is passed is somewhere else by the
/// time it is kept.
pub(super) async fn position(State(panel): State<Arc<Panel>>) -> Answer<StandingView> {
    let refused = |text: String| Refused::new(StatusCode::CONFLICT, "busy", text);
    let hub = &panel.cell.hub;
    let known = hub.latest().zip(hub.machine());
    let (status, machine) = known.ok_or_else(|| refused("the cell does not answer: try again".to_owned()))?;
    if !status.stands {
        return Err(refused("the axes have not come to rest: wait a moment".to_owned()));
    }
    if let Some((axis, _)) = machine.axes.iter().zip(&status.axes).find(|(_, axis)| !axis.referenced) {
        return Err(refused(format!("the reference of {} is not known: home first", axis.name)));
    }
    Ok(Json(StandingView { axes: status.axes.iter().map(|axis| axis.position).collect(), tip: status.tip }))
}

/// What was taught so far.
pub(super) async fn taught(State(panel): State<Arc<Panel>>) -> Answer<TaughtView> {
    Ok(Json(panel.teaching.taught()))
}

/// The newest picture of the eye.
pub(super) async fn picture(State(panel): State<Arc<Panel>>) -> Result<Response, Refused> {
    let png = panel.teaching.picture().ok_or_else(|| Refused::not_found("there is no picture yet"))?;
    Ok(([(header::CONTENT_TYPE, "image/png")], png.to_vec()).into_response())
}

/// What was taught as a program; nothing is kept.
pub(super) async fn made(State(panel): State<Arc<Panel>>, Json(asked): Json<TeachProgram>) -> Answer<TaughtProgram> {
    alone(&panel, move |panel| Ok(program(&panel.teaching, &asked)?)).await.map(Json)
}
