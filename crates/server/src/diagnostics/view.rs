use super::process_memory;
use crate::http::Panel;
use crate::wire::{
    AlarmCount, AlarmView, ClientsView, CycleView, DiagnosticsView, DiskView, LineView, RealtimeView, ReportAge, Status,
};
use std::time::Duration;

/// Priorities of alarms, the most urgent first.
pub(super) const PRIORITIES: [&str; 4] = ["critical", "high", "medium", "low"];

/// Gathers everything, without waiting for a disk or the cycle.
pub(crate) fn view(panel: &Panel) -> DiagnosticsView {
    let hub = &panel.cell.hub;
    let (status, tally) = (hub.latest(), hub.tally());
    let mut queues = tally.queues();
    queues.push(panel.cell.archive.queue());
    let clients =
        ClientsView { pages: hub.clients(), sessions: panel.sessions.count(), ..panel.diagnostics.counts.view() };
    DiagnosticsView {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        uptime_s: panel.diagnostics.started.elapsed().as_secs_f64(),
        not_ready: super::not_ready(panel).into_iter().map(Into::into).collect(),
        mode: status.as_ref().map_or_else(String::new, |status| status.mode.clone()),
        cycle: CycleView {
            period_s: hub.machine().map_or(0.0, |machine| machine.servo_period_s),
            age_s: hub.age().as_ref().map(Duration::as_secs_f64),
            missed: status.as_ref().map_or(0, |status| u64::from(status.missed)),
            lost: status.as_ref().map_or(0, |status| status.lost),
            longest_gap_ms: status.as_ref().map_or(0.0, |status| status.longest_gap_ms),
            latency: tally.latency.view(),
        },
        realtime: realtime(status.as_ref()),
        queues,
        reports: reports(status.as_ref()),
        lines: lines(panel),
        disk: panel.diagnostics.disk.get().map_or_else(DiskView::default, super::DiskProbe::view),
        memory: process_memory::of(std::process::id()),
        cell_memory: hub.cell_process().and_then(process_memory::of),
        alarms: alarms(&hub.listed_alarms()),
        welds: hub.welds(),
        workers: panel.planner.workers().view(),
        clients,
    }
}

fn realtime(status: Option<&Status>) -> RealtimeView {
    let unknown = || RealtimeView { missing: Vec::new(), text: String::new() };
    status.map_or_else(unknown, |status| status.realtime.clone())
}

fn reports(status: Option<&Status>) -> Vec<ReportAge> {
    let age = |device: &str, of: fn(&Status) -> Option<f64>| ReportAge {
        device: device.to_owned(),
        age_s: status.and_then(of),
    };
    vec![
        age("drives", |status| status.ages.drives),
        age("source", |status| status.ages.source),
        age("inputs", |status| status.ages.inputs),
    ]
}

fn lines(panel: &Panel) -> Vec<LineView> {
    let lines = panel.cell.hub.lines().into_iter().map(|(name, traffic)| LineView {
        name,
        polls: traffic.polls,
        missed: traffic.missed,
        failed: traffic.failed,
        connections: traffic.connections,
        away_s: traffic.away_s,
        latency_s: traffic.latency.map(|latency| latency.mean_s),
        latency_sigma_s: traffic.latency.map(|latency| latency.sigma_s),
        trouble: traffic.trouble.map(Into::into),
    });
    lines.collect()
}

/// Counts listed alarms by priority. Shelved ones that are no longer listed do not count.
fn alarms(list: &[AlarmView]) -> Vec<AlarmCount> {
    let count = |priority: &&str| {
        let own = || list.iter().filter(|alarm| alarm.priority == *priority);
        let counted = |states: &[&str]| own().filter(|alarm| states.contains(&alarm.state.as_str())).count() as u32;
        AlarmCount {
            priority: (*priority).to_owned(),
            active: counted(&["unacknowledged", "acknowledged"]),
            unacknowledged: counted(&["unacknowledged", "returned"]),
        }
    };
    PRIORITIES.iter().map(count).collect()
}
