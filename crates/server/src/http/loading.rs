use super::answer::Refused;
use super::job_name::checked;
use crate::cell::{Around, Loading};
use crate::view::work_view;
use crate::wire::{Load, WorkView};
use seamwright_cell::{CrossingPlan, Program, decode_plan, encode_plan, fingerprint, try_program};
use seamwright_document::DocumentError;
use seamwright_executive::Place;
use seamwright_message::{Message, Unit};
use seamwright_project::load::{Loaded, load_foreign};
use seamwright_project::planning::Planning;
use seamwright_project::recording::{Header, Who, record_plan};
use seamwright_project::run_rows;
use seamwright_project::simulated_part::Part;
use seamwright_record::{Plan, sha256};
use std::path::Path as FilePath;
use std::sync::Arc;

/// A planned job to be loaded.
struct Ready {
    loaded: Loaded,
    program: Program,
    view: WorkView,
    record: Plan,
    passes: usize,
}

/// Plans a job to be loaded, only from its text and the folder of jobs, and tries all steps of loading that take memory
/// and time. Returns the encoded plan for [`ready`].
/// Fails if the job is invalid. The approach from the current axis positions is not checked.
pub(crate) fn planned(load: &Load, text: &str, jobs: &FilePath) -> Result<Vec<u8>, Refused> {
    let loaded = load_foreign(checked(&load.job)?, text, jobs)?.with_torch_angles(&Planning::default())?;
    let part = simulated_part(load.distortion.as_deref())?;
    part.check_devices(&loaded.machine)?;
    let motion = encode_plan(&loaded, &part.plan(&loaded)?).map_err(Refused::input)?;
    let Ready { loaded, program, view, record, .. } = ready(load, text, jobs, motion.clone(), 0)?;
    let around = Around::new(&loaded.machine, &loaded.clamped).map_err(Refused::input)?;
    try_program(program).map_err(Refused::input)?;
    // Dropped together: panel and cell also need all of them at once.
    drop((view, around, record, loaded));
    Ok(motion)
}

/// Reads a planned job to be loaded; `number` is the number of its view.
fn ready(load: &Load, text: &str, jobs: &FilePath, motion: Vec<u8>, number: u64) -> Result<Ready, Refused> {
    let loaded = load_foreign(checked(&load.job)?, text, jobs)?;
    let CrossingPlan { torches, motion: plan } = decode_plan(&motion, &loaded).map_err(Refused::input)?;
    let loaded = loaded.with_searched_torches(torches)?;
    let tracking = simulated_part(load.distortion.as_deref())?.tracking;
    let from = load.from.map(|(pass, s_mm)| Place { pass: pass as usize, s_mm });
    let mut view = work_view(number, &load.job, &loaded, Ok(&plan));
    let heads = if tracking { run_rows::head_names(&loaded) } else { Vec::new() };
    (view.from, view.tracked, view.distortion) = (load.from, heads.len(), load.distortion.clone());
    let columns = run_rows::columns(&loaded.machine, &view.values, &heads);
    let title = loaded.welding.program.value.title.clone();
    let mut about = vec![("title", title), ("machine", loaded.machine.name.clone())];
    about.extend(view.distortion.clone().map(|text| ("distortion", text)));
    let header = Header { columns: &columns, about: &about, from };
    let simulated = loaded.machine.devices.is_empty();
    let who = Who { part: load.part.clone().unwrap_or_default(), simulated, welder: None };
    let record = record_plan(&loaded, &plan, &header, who)?;
    let passes = plan.passes.len() - from.map_or(0, |place| place.pass.saturating_sub(1)).min(plan.passes.len());
    let program = Program {
        number: 0,
        job: load.job.clone(),
        text: text.to_owned(),
        folder: jobs.to_owned(),
        machine: fingerprint(&loaded.machine),
        sha256: sha256(&motion),
        motion,
        from,
        about: serde_json::to_string(load).map_err(|e| Refused::server(e.to_string()))?,
        distortion: load.distortion.clone(),
    };
    Ok(Ready { loaded, program, view, record, passes })
}

/// Reads the program of a running cell again, which a panel before this one has loaded.
pub(crate) fn adopted(program: &Program) -> Result<Loading, Refused> {
    let load: Load = serde_json::from_str(&program.about).map_err(|e| Refused::server(e.to_string()))?;
    loading(&load, &program.text, &program.folder, program.motion.clone(), (1, String::new()))
}

/// Reads a planned job to be loaded; its view has the number of `of`, and it is loaded by the user of `of`.
pub(super) fn loading(
    load: &Load,
    text: &str,
    jobs: &FilePath,
    motion: Vec<u8>,
    of: (u64, String),
) -> Result<Loading, Refused> {
    let overlap_mm = overlap(load)?;
    let (number, user) = of;
    let Ready { loaded, program, view, record, passes } = ready(load, text, jobs, motion, number)?;
    let around = Arc::new(Around::new(&loaded.machine, &loaded.clamped).map_err(Refused::input)?);
    let (program, machine, view) = (Box::new(program), Box::new(loaded.machine), Arc::new(view));
    Ok(Loading { program, machine, view, around, plan: record, passes, overlap_mm, user })
}

/// Maximum overlap over finished weld that needs no confirmation at a start, mm.
const MAX_OVERLAP_MM: f64 = 100.0;

fn overlap(load: &Load) -> Result<f64, Refused> {
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
    Part::distorted(distortion).map_err(|e| Refused::input(document_message(&e)))
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
