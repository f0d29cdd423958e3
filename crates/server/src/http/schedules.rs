//! Tables of seams: kept among the jobs, planned in a process beside the cell, one at a time.

use super::answer::{Answer, Refused, page_of};
use super::panel::{Panel, Shared};
use crate::cell::Change;
use crate::limits::{MAX_JOB_BYTES, MAX_SCHEDULE_PARTS, MAX_SCHEDULE_ROWS, MAX_SCHEDULES};
use crate::planner::{LongWork, Planned, Question, ScheduleWork};
use crate::users::Session;
use crate::wire::{
    JobText, MachineParts, PartTime, ScheduleOptions, ScheduleRow, ScheduleRun, ScheduleText, ScheduleView, SeamRow,
};
use axum::Json;
use axum::extract::{Path, Query, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse as _, Response};
use seamwright_message::Message;
use seamwright_project::files;
use seamwright_schedule::{Row, RowResult, Status, Table, Task, machine_load};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Maximum length of the name of a table, characters.
const MAX_NAME: usize = 80;
/// Result files that can be downloaded, with their content types.
const FILES: [(&str, &str); 4] = [
    ("schedule.csv", "text/csv; charset=utf-8"),
    ("schedule.parquet", "application/vnd.apache.parquet"),
    ("machines.csv", "text/csv; charset=utf-8"),
    ("report.html", "text/html; charset=utf-8"),
];
/// File with the options of the last run, among the results.
const OPTIONS: &str = "options.json";
/// Options before the first run.
const DEFAULT_LIMIT_S: f64 = 60.0;

/// The schedule that is being planned, and how those before it ended.
#[derive(Default)]
pub(crate) struct Schedules(Mutex<Runs>);

#[derive(Default)]
struct Runs {
    running: Option<(String, Arc<LongWork>)>,
    /// Reasons of runs that ended early, by table.
    failed: BTreeMap<String, Message>,
}

impl Schedules {
    fn lock(&self) -> MutexGuard<'_, Runs> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn running(&self, name: &str) -> Option<Arc<LongWork>> {
        self.lock().running.as_ref().filter(|(running, _)| running == name).map(|(_, work)| Arc::clone(work))
    }

    fn begin(&self, name: &str) -> Result<Arc<LongWork>, Refused> {
        let mut runs = self.lock();
        if let Some((other, _)) = &runs.running {
            let message = Message::new("server-schedule-runs").text("name", other);
            return Err(Refused::new(StatusCode::CONFLICT, "busy", message));
        }
        let work = Arc::new(LongWork::begin());
        runs.failed.remove(name);
        runs.running = Some((name.to_owned(), Arc::clone(&work)));
        Ok(work)
    }

    fn end(&self, name: &str, failed: Option<Message>) {
        let mut runs = self.lock();
        runs.running = None;
        if let Some(message) = failed {
            runs.failed.insert(name.to_owned(), message);
        }
    }
}

/// Checks the name of a table: a file without folders.
fn checked(name: &str) -> Result<&str, Refused> {
    let stem = name.strip_suffix(".csv").or_else(|| name.strip_suffix(".toml")).unwrap_or_default();
    let good = |c: char| c.is_alphanumeric() || "-_. ()+".contains(c);
    let is_good = !stem.is_empty()
        && name.chars().count() <= MAX_NAME
        && name.chars().all(good)
        && !name.starts_with(['.', ' '])
        && !name.contains("..");
    if is_good {
        return Ok(name);
    }
    Err(Message::new("server-schedule-name").text("name", name).count("max", MAX_NAME).into())
}

fn folder(panel: &Panel) -> PathBuf {
    panel.jobs().join("schedules")
}

fn results(panel: &Panel, name: &str) -> PathBuf {
    panel.data.join("schedules").join(name)
}

/// The path of an existing table.
fn table(panel: &Panel, name: &str) -> Result<PathBuf, Refused> {
    let path = folder(panel).join(checked(name)?);
    if path.is_file() {
        return Ok(path);
    }
    Err(Refused::not_found(Message::new("server-no-schedule").text("name", name)))
}

fn names(panel: &Panel) -> Vec<String> {
    let entries = std::fs::read_dir(folder(panel)).into_iter().flatten().filter_map(Result::ok);
    let files = entries.filter(|entry| entry.path().is_file());
    let mut names: Vec<String> =
        files.filter_map(|entry| entry.file_name().into_string().ok()).filter(|name| checked(name).is_ok()).collect();
    names.sort();
    names
}

/// Options of the last run of a table.
fn options(panel: &Panel, name: &str) -> Option<ScheduleOptions> {
    serde_json::from_slice(&std::fs::read(results(panel, name).join(OPTIONS)).ok()?).ok()
}

fn work(panel: &Panel, name: &str, options: Option<ScheduleOptions>) -> Result<ScheduleWork, Refused> {
    let table = table(panel, name)?;
    let without = || ScheduleOptions { post: None, limit_s: DEFAULT_LIMIT_S, language: "en".to_owned() };
    Ok(ScheduleWork { table, output: results(panel, name), options: options.unwrap_or_else(without) })
}

fn run_view(work: &LongWork) -> ScheduleRun {
    let (of, elapsed_s) = (work.progress(), work.elapsed().as_secs_f64());
    let planned = of.done.saturating_sub(of.kept);
    let per_s = (planned > 0 && elapsed_s > 0.0).then(|| planned as f64 / elapsed_s);
    ScheduleRun {
        done: of.done,
        total: of.total,
        kept: of.kept,
        elapsed_s,
        rows_per_min: per_s.map(|per_s| 60.0 * per_s),
        left_s: per_s.map(|per_s| of.total.saturating_sub(of.done) as f64 / per_s),
    }
}

fn row(panel: &Panel, name: String) -> ScheduleRow {
    let runs = panel.schedules.lock();
    let running = runs.running.as_ref().filter(|(running, _)| *running == name);
    ScheduleRow {
        has_results: results(panel, &name).join(FILES[0].0).is_file(),
        run: running.map(|(_, work)| run_view(work)),
        failed: runs.failed.get(&name).map(Into::into),
        name,
    }
}

pub(super) async fn list(State(panel): Shared) -> Answer<Vec<ScheduleRow>> {
    let list = |panel: &Arc<Panel>| Ok(names(panel).into_iter().map(|name| row(panel, name)).collect());
    panel.run(|panel| &panel.reading, list).await.map(Json)
}

pub(super) async fn put(
    State(panel): Shared,
    session: Session,
    Path(name): Path<String>,
    Json(asked): Json<ScheduleText>,
) -> Answer<ScheduleRow> {
    panel.run(|panel| &panel.saving, move |panel| keep(panel, &session, &name, &asked)).await.map(Json)
}

fn keep(panel: &Panel, session: &Session, name: &str, asked: &ScheduleText) -> Result<ScheduleRow, Refused> {
    let path = folder(panel).join(checked(name)?);
    let old = if path.is_file() { files::read_up_to(&path, MAX_JOB_BYTES)? } else { String::new() };
    if path.is_file() && !asked.replace {
        let message = Message::new("server-other-text").text("job", name);
        return Err(Refused::new(StatusCode::CONFLICT, "other", message));
    }
    if !path.is_file() && names(panel).len() >= MAX_SCHEDULES {
        return Err(Message::new("server-too-many-schedules").count("max", MAX_SCHEDULES).into());
    }
    if panel.schedules.running(name).is_some() {
        let message = Message::new("server-schedule-runs").text("name", name);
        return Err(Refused::new(StatusCode::CONFLICT, "busy", message));
    }
    check(panel, name, &asked.text)?;
    let folder = folder(panel);
    std::fs::create_dir_all(&folder).map_err(|e| files::not_writable(&folder, &e))?;
    files::write(&path, &asked.text)?;
    let hash = |text: &str| seamwright_record::sha256(text.as_bytes());
    let (old, new) = (hash(&old), hash(&asked.text));
    let command = Message::new("server-audit-save-schedule").text("name", name);
    panel.audit(&session.user, command, Change { old: &old, new: &new }, Message::new("server-audit-saved"));
    Ok(row(panel, name.to_owned()))
}

/// Checks the rows of a table, and that its templates can be read, where it is not listed.
fn check(panel: &Panel, name: &str, text: &str) -> Result<(), Refused> {
    let folder = panel.data.join("schedules").join(".checked");
    std::fs::create_dir_all(&folder).map_err(|e| files::not_writable(&folder, &e))?;
    let copy = folder.join(name);
    files::write(&copy, text)?;
    let checked = Table::open_foreign(&copy, &panel.jobs());
    // A copy that stays is overwritten by the next one of its name.
    drop(std::fs::remove_file(&copy));
    checked?;
    Ok(())
}

pub(super) async fn delete(
    State(panel): Shared,
    session: Session,
    Path(name): Path<String>,
) -> Result<StatusCode, Refused> {
    panel.run(|panel| &panel.saving, move |panel| remove(panel, &session, &name)).await?;
    Ok(StatusCode::NO_CONTENT)
}

fn remove(panel: &Panel, session: &Session, name: &str) -> Result<(), Refused> {
    let path = table(panel, name)?;
    if panel.schedules.running(name).is_some() {
        let message = Message::new("server-schedule-runs").text("name", name);
        return Err(Refused::new(StatusCode::CONFLICT, "busy", message));
    }
    let failed = |e: std::io::Error| {
        Refused::server(Message::new("server-job-not-deleted").text("job", name).text("why", e.to_string()))
    };
    let (old, _) = seamwright_record::sha256_of_file(&path)?;
    std::fs::remove_file(&path).map_err(failed)?;
    let results = results(panel, name);
    if results.is_dir() {
        std::fs::remove_dir_all(&results).map_err(failed)?;
    }
    let command = Message::new("server-audit-delete-schedule").text("name", name);
    panel.audit(&session.user, command, Change { old: &old, new: "" }, Message::new("server-audit-deleted"));
    Ok(())
}

pub(super) async fn get(State(panel): Shared, Path(name): Path<String>) -> Answer<ScheduleView> {
    panel.run(|panel| &panel.reading, move |panel| view(panel, &name)).await.map(Json)
}

fn view(panel: &Panel, name: &str) -> Result<ScheduleView, Refused> {
    let options = options(panel, name);
    let work = work(panel, name, options.clone())?;
    let (mut rows, mut tasks, mut more) = (Vec::new(), Vec::new(), 0);
    let wrong = work.with(&panel.jobs(), |schedule, _| {
        schedule.results(&mut |row, result| {
            if let Some(result) = result.as_ref().filter(|result| result.status == Status::Weldable) {
                let left = MAX_SCHEDULE_PARTS.saturating_sub(tasks.len()).min(row.count as usize);
                tasks.extend((0..left).map(|_| task(&row, result)));
            }
            if rows.len() < MAX_SCHEDULE_ROWS {
                rows.push(seam(row, result));
            } else {
                more += 1;
            }
            Ok(true)
        })?;
        Ok(())
    });
    let known = FILES.iter().map(|(file, _)| *file).filter(|file| work.output.join(file).is_file());
    Ok(ScheduleView {
        name: name.to_owned(),
        wrong: wrong.err().map(|refused| refused.message.into()),
        rows,
        more,
        machines: machine_load(tasks).into_iter().map(machine_parts).collect(),
        files: known.map(str::to_owned).collect(),
        options,
    })
}

fn task(row: &Row, result: &RowResult) -> Task {
    Task { name: row.name.clone(), setup_s: 60.0 * row.setup_min, times: result.times.clone() }
}

fn machine_parts(load: seamwright_schedule::MachineLoad) -> MachineParts {
    let part = |part: seamwright_schedule::Occupation| PartTime {
        name: part.name,
        from_s: part.from_s,
        weld_s: part.weld_s,
        to_s: part.to_s,
    };
    MachineParts { machine: load.machine, parts: load.parts.into_iter().map(part).collect(), end_s: load.end_s }
}

fn seam(row: Row, result: Option<RowResult>) -> SeamRow {
    let status = result.as_ref().map_or("waiting", |result| result.status.word()).to_owned();
    let of = result.unwrap_or_else(|| RowResult::without_plan(Status::Invalid, String::new()));
    let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    SeamRow {
        number: row.number,
        name: row.name,
        template: row.template,
        machines: row.machines,
        count: row.count,
        setup_min: row.setup_min,
        status,
        machine: of.machine,
        passes: number(of.passes),
        length_mm: of.length_mm,
        total_s: of.total_s,
        arc_s: of.arc_s,
        wire_kg: of.wire_kg,
        gas_l: of.gas_l,
        energy_kj: of.energy_kj,
        cost: of.cost,
        clearance_mm: of.clearance_mm,
        blocking: number(of.blocking),
        findings: of.findings.into_iter().map(|(code, n)| (code, number(n))).collect(),
        error: of.error,
    }
}

pub(super) async fn run(
    State(panel): Shared,
    session: Session,
    Path(name): Path<String>,
    Json(options): Json<ScheduleOptions>,
) -> Result<StatusCode, Refused> {
    panel.run(|panel| &panel.saving, move |panel| start(panel, &session, &name, options)).await?;
    Ok(StatusCode::ACCEPTED)
}

fn start(panel: &Arc<Panel>, session: &Session, name: &str, options: ScheduleOptions) -> Result<(), Refused> {
    let work = work(panel, name, Some(options))?;
    // Faults of table and options are answered at once.
    work.with(&panel.jobs(), |_, _| Ok(()))?;
    let running = panel.schedules.begin(name)?;
    let kept = serde_json::to_string(&work.options).map_err(|e| Refused::server(e.to_string())).and_then(|text| {
        std::fs::create_dir_all(&work.output).map_err(|e| files::not_writable(&work.output, &e))?;
        Ok(files::write(&work.output.join(OPTIONS), &text)?)
    });
    if let Err(refused) = kept {
        panel.schedules.end(name, None);
        return Err(refused);
    }
    let command = || Message::new("server-audit-run-schedule").text("name", name);
    panel.audit(&session.user, command(), Change::default(), Message::new("server-audit-begun"));
    let (on, user, of) = (Arc::clone(panel), session.user.clone(), name.to_owned());
    let plan = move || {
        let answer = on.planner.work_long(&running, &Question::Schedule { asked: work }, &on.jobs());
        let planned = answer
            .and_then(|json| serde_json::from_slice::<Planned>(&json).map_err(|e| Refused::server(e.to_string())));
        let said = match &planned {
            Ok(of) => {
                let said = Message::new("server-audit-schedule-planned").number("rows", of.rows as f64, 0);
                said.number("weldable", of.weldable as f64, 0)
            }
            Err(_) if running.is_cancelled() => Message::new("server-schedule-cancelled"),
            Err(refused) => refused.message.clone(),
        };
        on.schedules.end(&of, planned.is_err().then(|| said.clone()));
        let command = Message::new("server-audit-run-schedule").text("name", &of);
        on.audit(&user, command, Change::default(), said);
    };
    let spawned = std::thread::Builder::new().name("panel-schedule".to_owned()).spawn(plan);
    spawned.map(drop).map_err(|e| {
        panel.schedules.end(name, None);
        Refused::server(Message::new("server-no-thread").text("why", e.to_string()))
    })
}

pub(super) async fn cancel(State(panel): Shared, Path(name): Path<String>) -> Result<StatusCode, Refused> {
    let Some(work) = panel.schedules.running(checked(&name)?) else {
        return Err(Refused::not_found(Message::new("server-schedule-rests").text("name", name)));
    };
    work.cancel();
    Ok(StatusCode::NO_CONTENT)
}

/// `?row=NAME`, with the machine that welds it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OfRow {
    row: String,
    machine: Option<String>,
}

pub(super) async fn job(State(panel): Shared, Path(name): Path<String>, Query(of): Query<OfRow>) -> Answer<JobText> {
    let found = move |panel: &Arc<Panel>| {
        let work = work(panel, &name, None)?;
        let text = work.with(&panel.jobs(), |schedule, _| Ok(schedule.job_of(&of.row, of.machine.as_deref())?))?;
        let missing = || Refused::not_found(Message::new("server-no-seam").text("row", &of.row));
        Ok(JobText { text: text.ok_or_else(missing)? })
    };
    panel.run(|panel| &panel.reading, found).await.map(Json)
}

pub(super) async fn file(
    State(panel): Shared,
    Path((name, file)): Path<(String, String)>,
) -> Result<Response, Refused> {
    let missing = || Refused::not_found(Message::new("server-no-result").text("file", &file));
    let (known, kind) = FILES.into_iter().find(|(known, _)| *known == file).ok_or_else(missing)?;
    let path = results(&panel, checked(&name)?).join(known);
    let bytes = panel.run(|panel| &panel.reading, move |_| Ok(std::fs::read(path).ok())).await?.ok_or_else(missing)?;
    if known == "report.html" {
        return Ok(page_of(String::from_utf8_lossy(&bytes).into_owned()));
    }
    let stem = name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem);
    let end = known.rsplit_once('.').map_or("", |(_, end)| end);
    let ascii =
        |text: &str| -> String { text.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect() };
    let part = if known.starts_with("machines") { "-machines" } else { "" };
    let attached = format!("attachment; filename=\"{}{part}.{end}\"", ascii(stem));
    Ok(([(header::CONTENT_TYPE, kind.to_owned()), (header::CONTENT_DISPOSITION, attached)], bytes).into_response())
}
