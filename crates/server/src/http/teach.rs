use super::answer::{Answer, Refused};
use super::panel::Panel;
use super::plan::alone;
use crate::teaching::program;
use crate::wire::{TaughtProgram, TaughtView, TeachProgram};
use axum::Json;
use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse as _, Response};
use std::sync::Arc;

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
