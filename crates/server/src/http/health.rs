use super::panel::Shared;
use axum::Json;
use axum::extract::State;
use serde_json::{Value, json};

/// Reports that this process lives and answers, for whatever restarts it: no data that needs a login. Whether the cell
/// can be used is asked of `/readyz`.
pub(super) async fn health(State(panel): Shared) -> Json<Value> {
    let ms = |s: f64| (s * 1e3).round() * 1e-3;
    let age_s = panel.cell.hub.age().map(|age| ms(age.as_secs_f64()));
    let uptime_s = ms(panel.diagnostics.started.elapsed().as_secs_f64());
    Json(json!({ "status": "ok", "uptime_s": uptime_s, "cycle_age_s": age_s }))
}
