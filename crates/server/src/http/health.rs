use super::panel::Shared;
use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use serde_json::{Value, json};
use std::time::Duration;

/// Maximum age of the last status; beyond it the cycle counts as dead.
const SILENT: Duration = Duration::from_secs(2);

/// Reports whether the cycle runs, for monitoring tools: no data that needs a login.
pub(super) async fn health(State(panel): Shared) -> (StatusCode, Json<Value>) {
    let age = panel.cell.hub.age();
    let is_well = age.is_some_and(|age| age < SILENT);
    let status = if is_well { StatusCode::OK } else { StatusCode::SERVICE_UNAVAILABLE };
    let age_s = age.map(|age| (age.as_secs_f64() * 1e3).round() * 1e-3);
    (status, Json(json!({ "status": if is_well { "ok" } else { "the cycle is silent" }, "cycle_age_s": age_s })))
}
