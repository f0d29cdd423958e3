use super::answer::{Answer, Refused, page_of};
use super::jobs::{checked, text};
use super::panel::Panel;
use super::records::spoken;
use crate::cell::{Around, CellDevices, Connection, Loading, Planned, Prepared, Task, ToDesk, fingerprint};
use crate::users::Session;
use crate::view::{clamped_views, sections, tuning_view, work_view};
use crate::wire::{DraftAnswer, JobText, Load, PlanAnswer, PostAnswer, PostText, TuningView, WorkView, WrongView};
use axum::extract::{Path, Query, State};
use axum::http::StatusCode;
use axum::response::Response;
use axum::{Extension, Json};
use seamwright_cell::executive::Place;
use seamwright_cell::tracking::Distortion;
use seamwright_post::{Control, Dialect, Feed, Options};
use seamwright_project::Failure;
use seamwright_project::load::{Loaded, load_foreign};
use seamwright_project::part::Part;
use seamwright_project::posting::{Unproven, proven};
use seamwright_project::recording::{Header, Who, record_plan};
use seamwright_project::run_rows;
use seamwright_report::WeldReport;
use serde::Deserialize;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::oneshot;

/// Runs work that takes a while in a thread of its own, one at a time.
pub(super) async fn alone<T: Send + 'static>(
    panel: &Arc<Panel>,
    work: impl FnOnce(&Panel) -> Result<T, Refused> + Send + 'static,
) -> Result<T, Refused> {
    let with = Arc::clone(panel);
    panel.planning.run(move || work(&with)).await
}

/// Name of a text that is asked about.
const JOB: &str = "job.toml";

fn wrong(failure: &Failure) -> PlanAnswer {
    let at = match failure {
        Failure::Document(error) => Some(Box::new(WrongView {
            file: (error.file != JOB).then(|| error.file.clone()),
            line: (error.file == JOB && error.line > 0).then_some(error.line),
            key: error.key.clone(),
            value: error.value.clone(),
            what: error.message.clone(),
            allowed: error.allowed.clone(),
            help: error.help.clone(),
        })),
        _ => None,
    };
    PlanAnswer::Wrong { message: failure.text(), at }
}

pub(super) async fn plan(State(panel): State<Arc<Panel>>, Json(job): Json<JobText>) -> Answer<PlanAnswer> {
    let answer = alone(&panel, move |panel| {
        let loaded = match load_foreign(JOB, &job.text, &panel.jobs()) {
            Ok(loaded) => loaded,
            Err(failure) => return Ok(wrong(&failure)),
        };
        let number = panel.plan_number();
        Ok(match loaded.try_plan() {
            Ok(planned) => {
                let planned = planned.as_ref().map_err(Vec::as_slice);
                PlanAnswer::Planned { work: Box::new(work_view(number, "", &loaded, planned)) }
            }
            Err(failure) => wrong(&failure),
        })
    });
    answer.await.map(Json)
}

/// What a text describes, at once: nothing is planned.
pub(super) async fn draft(State(panel): State<Arc<Panel>>, Json(job): Json<JobText>) -> Answer<DraftAnswer> {
    let folder = panel.jobs();
    let answer = panel.drawing.run(move || {
        Ok(match load_foreign(JOB, &job.text, &folder) {
            Ok(loaded) => {
                let (part, fixtures) = clamped_views(&loaded);
                DraftAnswer::Drawn { part, fixtures, sections: sections(&loaded.welding) }
            }
            Err(failure) => DraftAnswer::Wrong { message: failure.text() },
        })
    });
    answer.await.map(Json)
}

fn loaded(panel: &Panel, name: &str) -> Result<Loaded, Refused> {
    Ok(load_foreign(checked(name)?, &text(panel, name)?, &panel.jobs())?)
}

/// Most characters of a part's number.
const MOST_PART: usize = 120;

/// A part's number as it may stand in records.
fn part(number: &str) -> Result<(), Refused> {
    if number.chars().count() <= MOST_PART && !number.chars().any(crate::cell::hides) {
        return Ok(());
    }
    Err(Refused::input(format!(
        "the number of the part cannot be that; allowed: up to {MOST_PART} characters that are seen"
    )))
}

pub(super) async fn load(
    State(panel): State<Arc<Panel>>,
    Extension(session): Extension<Session>,
    Json(load): Json<Load>,
) -> Answer<WorkView> {
    checked(&load.job)?;
    part(load.part.as_deref().unwrap_or_default())?;
    let (what, job) = (format!("load {}", load.job), load.job.clone());
    let result = put_in(&panel, load, session.user.clone()).await;
    let said = result.as_ref().map_or_else(|refused| refused.text.clone(), |_| "loaded".to_owned());
    panel.cell.archive.audit(&session.user, "panel", &what, ("", &job), &said);
    result.map(|view| Json((*view).clone()))
}

/// Plans a job and puts it into the cell.
async fn put_in(panel: &Arc<Panel>, load: Load, user: String) -> Result<Arc<WorkView>, Refused> {
    let loading = alone(panel, move |panel| loading(panel, load, user)).await?;
    let view = loading.view.clone().ok_or_else(|| Refused::server("a job without a picture"))?;
    give(panel, connected(panel, loading).await?).await?;
    panel.teaching.leave(&panel.cell.hub, (&view.job, &view.machine));
    Ok(view)
}

/// To the desk, and its answer.
async fn give(panel: &Panel, loading: Loading) -> Result<(), Refused> {
    let gone = || Refused::server("the cell has ended");
    let (answer, answered) = oneshot::channel();
    panel.cell.desk.send(ToDesk::Load(Box::new(loading), answer)).map_err(|_| gone())?;
    let taken = answered.await.map_err(|_| gone())?;
    taken.map_err(|lack| Refused::new(StatusCode::CONFLICT, "busy", lack.text))
}

/// With the devices that it needs, if the cell's are not connected for it: real ones are let go first, by a machine without a
/// program. A job may not lead to other devices than whoever started the panel has chosen.
async fn connected(panel: &Arc<Panel>, mut loading: Loading) -> Result<Loading, Refused> {
    /// Until devices are gone, s.
    const GO_S: u64 = 20;
    let now = panel.cell.hub.connection();
    if now.as_ref().is_some_and(|to| to.serves_it(&loading.prepared)) {
        return Ok(loading);
    }
    let (own, folder) = panel.cell.devices.clone();
    let its = &loading.prepared.machine().devices;
    if !its.is_empty() && *its != own {
        let text =
            "its machine file names devices other than those of the machine file that the panel was started with";
        return Err(Refused::input(format!("{text}\n   allowed: the same [devices], or none")));
    }
    if let Some(now) = now.filter(Connection::is_real) {
        let prepared = Box::new(Prepared::bare(loading.prepared.machine()).map_err(Refused::input)?);
        let around = Arc::clone(&loading.around);
        let user = loading.user.clone();
        give(panel, Loading { prepared, view: None, around, plan: None, passes: 0, user }).await?;
        let begin = Instant::now();
        while now.is_there() {
            if begin.elapsed() > Duration::from_secs(GO_S) {
                return Err(Refused::server("the devices do not let go: start the panel anew"));
            }
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
    }
    alone(panel, move |_| {
        let values = loading.prepared.with(|work| work.values().to_vec());
        loading.prepared.devices = Some(CellDevices::new(&loading.prepared, &folder, &values).map_err(Refused::input)?);
        Ok(loading)
    })
    .await
}

/// Begins with a job in the cell.
pub(crate) async fn begin_with(panel: &Arc<Panel>, job: &str) -> Result<(), String> {
    let load = Load { job: job.to_owned(), from: None, part: None, distortion: None };
    put_in(panel, load, String::new()).await.map(drop).map_err(|refused| refused.text)
}

fn loading(panel: &Panel, load: Load, user: String) -> Result<Loading, Refused> {
    let loaded = loaded(panel, &load.job)?;
    let part = simulated_part(load.distortion.as_deref())?;
    part.check_devices(&loaded.machine)?;
    let motion = part.plan(&loaded)?;
    let from = load.from.map(|(pass, s_mm)| Place { pass: pass as usize, s_mm });
    let mut view = work_view(panel.plan_number(), &load.job, &loaded, Ok(&motion));
    let heads = if part.tracking { run_rows::head_names(&loaded) } else { Vec::new() };
    (view.from, view.tracked, view.distortion) = (load.from, heads.len(), load.distortion);
    let view = Arc::new(view);
    let columns = run_rows::columns(&loaded.machine, &view.values, &heads);
    let title = loaded.welding.program.value.title.clone();
    let mut about = vec![("title", title), ("machine", loaded.machine.name.clone())];
    about.extend(view.distortion.clone().map(|text| ("distortion", text)));
    let header = Header { columns: &columns, about: &about, from };
    let simulated = loaded.machine.devices.is_empty();
    let who = Who { part: load.part.unwrap_or_default(), simulated, welder: None };
    let plan = record_plan(&loaded, &motion, &header, who)?;
    let passes = motion.passes.len() - from.map_or(0, |place| place.pass.saturating_sub(1)).min(motion.passes.len());
    // On the devices of the cell from where the axes are, on others from home.
    let fingerprint = fingerprint(&loaded.machine);
    let same = panel.cell.hub.connection().is_some_and(|to| to.serves(&fingerprint, &view.values));
    let at = panel.cell.hub.set_points().filter(|_| same).unwrap_or(loaded.machine.home());
    let around = Arc::new(Around::new(&loaded.machine, &loaded.clamped).map_err(Refused::input)?);
    let task = Task::Job(Box::new(Planned { loaded, motion, part }));
    let prepared = Box::new(Prepared::new(task, &at, from).map_err(Refused::input)?);
    Ok(Loading { prepared, view: Some(view), around, plan: Some(plan), passes, user })
}

/// The part that is welded, where devices are simulated.
fn simulated_part(distortion: Option<&str>) -> Result<Part, Refused> {
    let distortion = distortion.map(|text| Distortion::read("distortion", text)).transpose();
    let distortion = distortion.map_err(|e| Refused::input(e.to_string()))?;
    Ok(Part { tracking: distortion.is_some(), distortion, replay: None })
}

/// What was welded, planned once more: where a record's torch was.
pub(super) async fn recorded(State(panel): State<Arc<Panel>>, Path(id): Path<i64>) -> Answer<WorkView> {
    let view = alone(&panel, move |panel| {
        let data = seamwright_record::DataFolder::open_to_read(&panel.data)?;
        let program = data.library().program_of(id)?;
        let loaded = load_foreign(&program.name, &program.text, &panel.jobs())?;
        let planned = loaded.try_plan()?;
        let planned = planned.as_ref().map_err(Vec::as_slice);
        Ok(work_view(panel.plan_number(), &program.name, &loaded, planned))
    });
    view.await.map(Json)
}

/// `?axis=NAME`.
#[derive(Deserialize)]
pub(super) struct OfAxis {
    axis: String,
}

pub(super) async fn tuning(State(panel): State<Arc<Panel>>, Query(of): Query<OfAxis>) -> Answer<TuningView> {
    let answer = alone(&panel, move |panel| {
        let machine = panel.cell.hub.machine().ok_or_else(|| Refused::server("there is no machine"))?;
        let axis = machine.axes.iter().find(|axis| axis.name == of.axis).ok_or_else(|| {
            let names: Vec<&str> = machine.axes.iter().map(|axis| axis.name.as_str()).collect();
            Refused::not_found(format!("there is no axis `{}`; allowed: {}", of.axis, names.join(", ")))
        })?;
        Ok(tuning_view(axis, machine.servo_period_s))
    });
    answer.await.map(Json)
}

/// `?job=NAME`, and in which language; English if it is not said.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Named {
    job: String,
    language: Option<String>,
}

pub(super) async fn report(State(panel): State<Arc<Panel>>, Query(named): Query<Named>) -> Result<Response, Refused> {
    let language = spoken(named.language)?;
    let page = alone(&panel, move |panel| {
        let loaded = loaded(panel, &named.job)?;
        let motion = loaded.try_plan()?.map_err(Failure::Findings)?;
        let (report, plots) = WeldReport::new(&loaded.machine, &loaded.welding, &motion, None, language);
        let date = seamwright_record::Moment::now().to_string();
        Ok(report.page(&plots, loaded.welding.program.text(), &date, language))
    });
    page.await.map(page_of)
}

pub(super) async fn post(State(panel): State<Arc<Panel>>, Json(asked): Json<PostText>) -> Answer<PostAnswer> {
    let answer = alone(&panel, move |panel| {
        let dialect = match asked.dialect.as_str() {
            "sinumerik" => Dialect::Sinumerik,
            "linuxcnc" => Dialect::Linuxcnc,
            "grblhal" => Dialect::Grblhal,
            "pmac" => Dialect::Pmac,
            other => {
                let allowed = "sinumerik, linuxcnc, grblhal, pmac";
                return Err(Refused::input(format!("there is no dialect `{other}`; allowed: {allowed}")));
            }
        };
        let loaded = load_foreign(JOB, &asked.text, &panel.jobs())?;
        let motion = loaded.plan()?;
        let control = Control::new(&loaded.machine, dialect).map_err(|e| Refused::input(e.to_string()))?;
        let made = proven(&loaded, &motion, &control, &Options::default(), Feed::InverseTime);
        let (text, proof) = made.map_err(|e| match e {
            Unproven::Failure(failure) => failure.into(),
            Unproven::Wrong(lines) => Refused::server(lines.join("\n")),
        })?;
        Ok(PostAnswer { text, proof: proof.lines() })
    });
    answer.await.map(Json)
}
