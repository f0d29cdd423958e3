use super::login::{From, address, panel_at};
use super::panel::Shared;
use crate::cell::Change;
use crate::refusal::panel_word;
use crate::wire::Stopped;
use axum::Json;
use axum::extract::State;
use seamwright_executive::Ask;
use seamwright_message::Message;
use std::sync::PoisonError;
use std::time::{Duration, Instant};

/// Repeated stops are audited once in this time.
const ONCE: Duration = Duration::from_secs(1);

/// Maximum wait for a cycle to act.
const ACTS: Duration = Duration::from_millis(600);

/// Handles STOP from a page without a session. Like any stop, it needs neither role nor token. Pages of other origins
/// are refused earlier.
pub(super) async fn stop(State(panel): Shared, from: From) -> Json<Stopped> {
    let acted = panel.cell.urgent.ask(&Ask::Stop);
    let cycle = tokio::time::timeout(ACTS, acted).await.ok().and_then(Result::ok).flatten();
    let mut stopped = panel.stopped.lock().unwrap_or_else(PoisonError::into_inner);
    if stopped.is_none_or(|at| at.elapsed() > ONCE) {
        *stopped = Some(Instant::now());
        let station = panel_at(address(&from));
        let accepted = Message::new("server-audit-accepted");
        panel.cell.archive.audit("", station, panel_word("do", "stop"), Change::default(), accepted);
    }
    let hub = &panel.cell.hub;
    let mode = hub.latest().map_or_else(String::new, |status| status.mode);
    Json(Stopped { cycle, mode, cycle_age_s: hub.age().map(|age| age.as_secs_f64()) })
}
