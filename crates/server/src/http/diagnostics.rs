//! State of server and cell, for the page *Diagnostics* and for monitoring tools.

use super::answer::Answer;
use super::panel::Shared;
use crate::diagnostics::{metrics_text, not_ready, view};
use crate::wire::{DiagnosticsView, ReadyView};
use axum::Json;
use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::IntoResponse;

/// Content type of the text format of Prometheus.
const PROMETHEUS: &str = "text/plain; version=0.0.4; charset=utf-8";

pub(super) async fn diagnostics(State(panel): Shared) -> Answer<DiagnosticsView> {
    Ok(Json(view(&panel)))
}

/// Reports whether the cell can be used: 503 with the reasons if not.
pub(super) async fn ready(State(panel): Shared) -> (StatusCode, Json<ReadyView>) {
    let reasons = not_ready(&panel);
    let status = if reasons.is_empty() { StatusCode::OK } else { StatusCode::SERVICE_UNAVAILABLE };
    let ready = reasons.is_empty();
    (status, Json(ReadyView { ready, reasons: reasons.into_iter().map(Into::into).collect() }))
}

pub(super) async fn metrics(State(panel): Shared) -> impl IntoResponse {
    let text = panel.diagnostics.printed(|| metrics_text(&view(&panel)));
    ([(header::CONTENT_TYPE, PROMETHEUS)], text.to_string())
}
