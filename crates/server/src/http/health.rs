use super::panel::Panel;
use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use serde_json::{Value, json};
use std::sync::Arc;
use std::time::Duration;

/// The cycle is taken for dead if it has not been heard of for this long.
const SILENT: Duration = Duration::from_secs(2);

/// Answers whether the cycle runs, for whoever watches the program: nothing that only users may know.
pub(super) async fn health(State(panel): State<Arc<Panel>>) -> (StatusCode, Json<Value>) {
    let age = panel.cell.hub.age();
    let is_well = age.is_some_and(|age| age < SILENT);
    let status = if is_well { StatusCode::OK } else { StatusCode::SERVICE_UNAVAILABLE };
    let age_s = age.map(|age| (age.as_secs_f64() * 1e3).round() * 1e-3);
    (status, Json(json!({ "status": if is_well { "ok" } else { "the cycle is silent" }, "cycle_age_s": age_s })))
}
