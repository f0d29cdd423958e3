use super::answer::{Answer, JSON, Refused, page_of};
use super::job_name::checked;
use super::jobs::text;
use super::loading::loading;
use super::panel::{Panel, Shared};
use super::records::{reads, spoken};
use crate::cell::{Change, Loading, NotLoaded, ToDesk};
use crate::limits::{MAX_PAGE_CHARS, MAX_PART_CHARS};
use crate::planner::{Asked, Page, Question};
use crate::users::Session;
use crate::view::tuning_view;
use crate::wire::{JobText, Load, PlaceText, PlanningView, PostText, ReachText, TuningView, WorkView};
use axum::Json;
use axum::extract::rejection::ExtensionRejection;
use axum::extract::{FromRequestParts, Path, Query, State};
use axum::http::request::Parts;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse as _, Response};
use seamwright_message::Message;
use serde::Deserialize;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::oneshot;

/// Runs long work in its own thread, one at a time.
pub(super) async fn alone<T: Send + 'static>(
    panel: &Arc<Panel>,
    work: impl FnOnce(&Panel) -> Result<T, Refused> + Send + 'static,
) -> Result<T, Refused> {
    let with = Arc::clone(panel);
    panel.planning.run(move || work(&with)).await
}

/// Header with the identifier of a page within its session.
const PAGE: &str = "x-seamwright-page";

impl<S: Send + Sync> FromRequestParts<S> for Page {
    type Rejection = ExtensionRejection;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, ExtensionRejection> {
        let session = Session::from_request_parts(parts, state).await?;
        let page = parts.headers.get(PAGE).and_then(|value| value.to_str().ok()).unwrap_or_default();
        Ok(Self { user: session.user, session: session.id, page: page.chars().take(MAX_PAGE_CHARS).collect() })
    }
}

async fn answered(panel: &Panel, page: Page, question: Question) -> Result<Response, Refused> {
    let json = panel.planner.ask(page, question, panel.jobs()).await?;
    Ok(([(header::CONTENT_TYPE, JSON)], json).into_response())
}

pub(super) async fn plan(State(panel): Shared, page: Page, Json(job): Json<JobText>) -> Result<Response, Refused> {
    let question = Question::Plan { text: job.text, number: panel.plan_number() };
    answered(&panel, page, question).await
}

pub(super) async fn draft(State(panel): Shared, page: Page, Json(job): Json<JobText>) -> Result<Response, Refused> {
    answered(&panel, page, Question::Draft { text: job.text }).await
}

pub(super) async fn place(State(panel): Shared, page: Page, Json(asked): Json<PlaceText>) -> Result<Response, Refused> {
    answered(&panel, page, Question::Place { asked }).await
}

pub(super) async fn reach(State(panel): Shared, page: Page, Json(asked): Json<ReachText>) -> Result<Response, Refused> {
    answered(&panel, page, Question::Reach { asked }).await
}

pub(super) async fn planning(State(panel): Shared, page: Page) -> Json<Vec<PlanningView>> {
    let asked = panel.planner.asked(&page);
    let view = |asked: Asked| PlanningView {
        kind: asked.name.to_owned(),
        elapsed_s: asked.since.elapsed().as_secs_f64(),
        done: asked.progress.map(|progress| progress.done),
        total: asked.progress.map(|progress| progress.total),
    };
    Json(asked.into_iter().map(view).collect())
}

/// `?kind=NAME`: only requests of this kind.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OfKind {
    kind: Option<String>,
}

pub(super) async fn cancel(State(panel): Shared, page: Page, Query(of): Query<OfKind>) -> StatusCode {
    panel.planner.cancel(&page, of.kind.as_deref());
    StatusCode::NO_CONTENT
}

/// Checks a part number for records.
fn part(number: &str) -> Result<(), Refused> {
    if number.chars().count() <= MAX_PART_CHARS && !number.chars().any(crate::cell::hides) {
        return Ok(());
    }
    Err(Message::new("server-part-number").count("max", MAX_PART_CHARS).into())
}

pub(super) async fn load(State(panel): Shared, page: Page, Json(load): Json<Load>) -> Answer<WorkView> {
    checked(&load.job)?;
    part(load.part.as_deref().unwrap_or_default())?;
    let (what, job) = (Message::new("server-audit-load").text("job", &load.job), load.job.clone());
    let user = page.user.clone();
    let result = match uncontrolled(&panel, &page) {
        Ok(()) => put_in(&panel, load, page).await,
        Err(refused) => Err(refused),
    };
    let loaded = |_: &_| Message::new("server-audit-loaded");
    let said = result.as_ref().map_or_else(|refused| refused.message.clone(), loaded);
    panel.audit(&user, what, Change { old: "", new: &job }, said);
    result.map(|view| Json((*view).clone()))
}

/// Modes in which a job can be loaded: in all others the machine moves, welds or is held.
const AT_REST: [&str; 4] = ["off", "idle", "ready", "fault"];

/// Time until the cell's status shows starts that were accepted just before a load was announced.
const ANNOUNCED: Duration = Duration::from_millis(100);

/// Refuses while a page of somebody else is in control.
fn uncontrolled(panel: &Panel, page: &Page) -> Result<(), Refused> {
    let Some(by) = panel.cell.hub.held_by_other(&page.user, &page.page) else { return Ok(()) };
    let message = Message::new("server-control-held").text("user", by.user).number("page", f64::from(by.station), 0);
    Err(Refused::new(StatusCode::CONFLICT, "control", message))
}

/// Refuses while the machine moves, welds or is held.
fn at_rest(panel: &Panel) -> Result<(), Refused> {
    if panel.cell.hub.latest().is_some_and(|status| !AT_REST.contains(&status.mode.as_str())) {
        return Err(Refused::new(StatusCode::CONFLICT, "busy", Message::new("server-machine-moves")));
    }
    Ok(())
}

/// Plans a job and loads it into the cell. The job is planned beside the cell, with limits of memory and time; starts are
/// refused while the cell prepares it.
async fn put_in(panel: &Arc<Panel>, load: Load, page: Page) -> Result<Arc<WorkView>, Refused> {
    at_rest(panel)?;
    let (asked, job, user) = (Arc::clone(panel), load.job.clone(), page.user.clone());
    let text = panel.reading.run(move || text(&asked, &job)).await?;
    let question = Question::Load { load: load.clone(), text: text.clone() };
    let motion = panel.planner.ask(page, question, panel.jobs()).await?;
    let _announced = panel.loads.announce();
    let loading = alone(panel, move |panel| {
        std::thread::sleep(ANNOUNCED);
        at_rest(panel)?;
        loading(&load, &text, &panel.jobs(), motion, (panel.plan_number(), user))
    });
    let loading = loading.await?;
    let view = Arc::clone(&loading.view);
    give(panel, loading).await?;
    panel.teaching.leave(&panel.cell.hub, &view);
    Ok(view)
}

/// Sends a program to the desk and waits for its answer.
async fn give(panel: &Panel, loading: Loading) -> Result<(), Refused> {
    let gone = || Refused::server(Message::new("server-cell-ended"));
    let (answer, answered) = oneshot::channel();
    panel.cell.desk.send(ToDesk::Load(Box::new(loading), answer)).map_err(|_| gone())?;
    let taken = answered.await.map_err(|_| gone())?;
    taken.map_err(|why| match why {
        NotLoaded::Lack(lack) => Refused::new(StatusCode::CONFLICT, "busy", lack.message),
        NotLoaded::Invalid(message) => Refused::input(message),
    })
}

pub(crate) async fn begin_with(panel: &Arc<Panel>, job: &str) -> Result<(), Message> {
    let load = Load { job: job.to_owned(), from: None, overlap_mm: None, part: None, distortion: None };
    put_in(panel, load, Page::default()).await.map(drop).map_err(|refused| refused.message)
}

/// Plans a recorded weld again, to show the torch of its record.
pub(super) async fn recorded(State(panel): Shared, page: Page, Path(id): Path<i64>) -> Result<Response, Refused> {
    let Json(program) = reads(&panel, move |data| Ok(data.library().program_of(id)?)).await?;
    let question = Question::Recorded { name: program.name, text: program.text, number: panel.plan_number() };
    answered(&panel, page, question).await
}

/// `?axis=NAME`.
#[derive(Deserialize)]
pub(super) struct OfAxis {
    axis: String,
}

pub(super) async fn tuning(State(panel): Shared, Query(of): Query<OfAxis>) -> Answer<TuningView> {
    let answer = alone(&panel, move |panel| {
        let machine = panel.machine()?;
        let axis = machine.axes.iter().find(|axis| axis.name == of.axis).ok_or_else(|| {
            let names: Vec<&str> = machine.axes.iter().map(|axis| axis.name.as_str()).collect();
            Refused::not_found(Message::new("server-no-axis").text("axis", &of.axis).text("allowed", names.join(", ")))
        })?;
        Ok(tuning_view(axis, machine.servo_period_s))
    });
    answer.await.map(Json)
}

/// `?job=NAME`, with an optional language (default English) and `appendix=true`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Named {
    job: String,
    language: Option<String>,
    #[serde(default)]
    appendix: bool,
}

pub(super) async fn report(State(panel): Shared, page: Page, Query(named): Query<Named>) -> Result<Response, Refused> {
    let (language, appendix) = (spoken(named.language)?.code().to_owned(), named.appendix);
    let (asked, name) = (Arc::clone(&panel), checked(&named.job)?.to_owned());
    let text = panel.reading.run(move || text(&asked, &named.job)).await?;
    let question = Question::Report { name, text, language, appendix };
    let html = panel.planner.ask(page, question, panel.jobs()).await?;
    let html = String::from_utf8(html).map_err(|_| Refused::server(Message::new("server-failed")))?;
    Ok(page_of(html))
}

pub(super) async fn post(State(panel): Shared, page: Page, Json(asked): Json<PostText>) -> Result<Response, Refused> {
    let question = Question::Post { text: asked.text, dialect: asked.dialect };
    answered(&panel, page, question).await
}
