use super::answer::{Answer, Refused};
use super::panel::Shared;
use crate::view::{device_views, machine_view, simulated_view};
use crate::wire::{AlarmEntry, DeviceView, MachineView, WorkView};
use axum::Json;
use axum::extract::{Query, State};
use seamwright_executive::Alarm;
use seamwright_message::Message;
use seamwright_project::load::machine_among;
use serde::Deserialize;

pub(super) async fn machine(State(panel): Shared) -> Answer<MachineView> {
    let machine = panel.machine()?;
    Ok(Json(machine_view(&machine)))
}

/// `?name=NAME`, in the form in which a job names its machine.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OfMachine {
    name: String,
}

/// Returns the machine that a job names, to show its plan. It may differ from the cell's.
pub(super) async fn machine_of_job(State(panel): Shared, Query(of): Query<OfMachine>) -> Answer<MachineView> {
    let folder = panel.jobs();
    let look = move || {
        let machine = machine_among(&of.name, &folder)?;
        let machine = machine
            .ok_or_else(|| Refused::not_found(Message::new("server-no-machine-named").text("name", &of.name)))?;
        Ok(machine_view(&machine))
    };
    panel.reading.run(look).await.map(Json)
}

pub(super) async fn devices(State(panel): Shared) -> Answer<Vec<DeviceView>> {
    let hub = &panel.cell.hub;
    let machine = panel.machine()?;
    let (status, work) = (hub.latest(), hub.work());
    let values = work.as_ref().map_or(&[][..], |work| &work.values);
    let mut views = device_views(&machine, &hub.lines(), values, status.as_ref());
    let simulated = simulated_view(&machine, values, status.as_ref());
    if !simulated.signals.is_empty() {
        views.push(simulated);
    }
    Ok(Json(views))
}

pub(super) async fn work(State(panel): Shared) -> Answer<Option<WorkView>> {
    Ok(Json(panel.cell.hub.work().as_deref().cloned()))
}

pub(super) async fn catalogue() -> Answer<Vec<AlarmEntry>> {
    let entries = Alarm::ALL.into_iter().map(|alarm| {
        let (entry, row) = (alarm.entry(), alarm.rationalisation());
        AlarmEntry {
            number: alarm.number() as u8,
            name: entry.name.to_owned(),
            cause: entry.cause.to_string(),
            consequence: entry.consequence.to_string(),
            action: entry.action.to_string(),
            reaction: entry.reaction.name().to_owned(),
            priority: row.priority().name().to_owned(),
            severity: row.severity.name().to_owned(),
            response: row.response.name().to_owned(),
            shelvable: alarm.is_shelvable(row.reaction),
        }
    });
    Ok(Json(entries.collect()))
}
