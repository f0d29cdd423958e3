use super::answer::Refused;
use super::job_name::checked;
use crate::cell::{Around, Planned, Prepared, Task};
use crate::view::work_view;
use crate::wire::{Load, WorkView};
use seamwright_document::DocumentError;
use seamwright_executive::Place;
use seamwright_message::{Message, Unit};
use seamwright_motion::WeldMotion;
use seamwright_project::load::{Loaded, load_foreign};
use seamwright_project::recording::{Header, Who, record_plan};
use seamwright_project::run_rows;
use seamwright_project::simulated_part::Part;
use seamwright_record::Plan;
use seamwright_simulation::tracking::Distortion;
use std::path::Path as FilePath;

/// A planned job to be loaded.
pub(super) struct Ready {
    pub(super) loaded: Loaded,
    pub(super) motion: WeldMotion,
    pub(super) part: Part,
    pub(super) from: Option<Place>,
    pub(super) view: WorkView,
    pub(super) record: Plan,
    pub(super) passes: usize,
}

/// Plans a job to be loaded, only from its text and the folder of jobs; `number` is the number of its view.
pub(super) fn ready(load: &Load, text: &str, jobs: &FilePath, number: u64) -> Result<Ready, Refused> {
    let loaded = load_foreign(checked(&load.job)?, text, jobs)?;
    let part = simulated_part(load.distortion.as_deref())?;
    part.check_devices(&loaded.machine)?;
    let motion = part.plan(&loaded)?;
    let from = load.from.map(|(pass, s_mm)| Place { pass: pass as usize, s_mm });
    let mut view = work_view(number, &load.job, &loaded, Ok(&motion));
    let heads = if part.tracking { run_rows::head_names(&loaded) } else { Vec::new() };
    (view.from, view.tracked, view.distortion) = (load.from, heads.len(), load.distortion.clone());
    let columns = run_rows::columns(&loaded.machine, &view.values, &heads);
    let title = loaded.welding.program.value.title.clone();
    let mut about = vec![("title", title), ("machine", loaded.machine.name.clone())];
    about.extend(view.distortion.clone().map(|text| ("distortion", text)));
    let header = Header { columns: &columns, about: &about, from };
    let simulated = loaded.machine.devices.is_empty();
    let who = Who { part: load.part.clone().unwrap_or_default(), simulated, welder: None };
    let record = record_plan(&loaded, &motion, &header, who)?;
    let passes = motion.passes.len() - from.map_or(0, |place| place.pass.saturating_sub(1)).min(motion.passes.len());
    Ok(Ready { loaded, motion, part, from, view, record, passes })
}

/// Performs all steps of loading that take memory and time, and discards the result.
/// Fails if the job is invalid. The approach from the current axis positions is not checked.
pub(crate) fn try_load(load: &Load, text: &str, jobs: &FilePath) -> Result<(), Refused> {
    let Ready { loaded, motion, part, from, view, .. } = ready(load, text, jobs, 0)?;
    let home = loaded.machine.home();
    let around = Around::new(&loaded.machine, &loaded.clamped).map_err(Refused::input)?;
    let prepared = Prepared::new(Task::Job(Box::new(Planned { loaded, motion, part })), &home, from);
    // Dropped together: the cell also needs all of them at once.
    drop((view, around, prepared));
    Ok(())
}

/// Maximum overlap over finished weld that needs no confirmation at a start, mm.
const MAX_OVERLAP_MM: f64 = 100.0;

pub(super) fn overlap(load: &Load) -> Result<f64, Refused> {
    let overlap_mm = load.overlap_mm.unwrap_or(0.0);
    if (0.0..=MAX_OVERLAP_MM).contains(&overlap_mm) {
        return Ok(overlap_mm);
    }
    Err(Message::new("server-overlap")
        .value("value", overlap_mm, Unit::Mm)
        .value("max", MAX_OVERLAP_MM, Unit::Mm)
        .into())
}

fn simulated_part(distortion: Option<&str>) -> Result<Part, Refused> {
    let distortion = distortion.map(|text| Distortion::read("distortion", text)).transpose();
    let distortion = distortion.map_err(|e| Refused::input(document_message(&e)))?;
    Ok(Part { tracking: distortion.is_some(), distortion, replay: None })
}

/// Describes an error without its line: the line belongs to a text that the user does not see.
pub(super) fn document_message(e: &DocumentError) -> Message {
    let mut message = match (e.key.as_str(), e.value.as_str()) {
        ("", _) => e.message.clone(),
        (key, "") => Message::new("server-at-key").key("key", key).message("what", e.message.clone()),
        (key, value) => {
            Message::new("server-at-value").key("key", key).text("value", value).message("what", e.message.clone())
        }
    };
    if let Some(allowed) = &e.allowed {
        message = Message::new("server-and-allowed").message("what", message).message("allowed", allowed.clone());
    }
    if let Some(help) = &e.help {
        message = Message::new("server-and-help").message("what", message).message("help", help.clone());
    }
    message
}
