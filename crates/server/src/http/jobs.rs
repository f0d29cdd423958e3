use super::answer::{Answer, Refused};
use super::job_name::checked;
use super::panel::{Panel, Shared};
use crate::cell::Change;
use crate::document_kind::{Kind, kind_of_head};
use crate::limits::{MAX_JOB_BYTES, MAX_JOBS};
use crate::users::Session;
use crate::wire::{DistortionRow, JobKept, JobRow, JobText};
use axum::Json;
use axum::extract::{Path, State};
use axum::http::StatusCode;
use seamwright_message::Message;
use seamwright_program::Procedure;
use seamwright_project::examples::{DISTORTIONS, EXAMPLES, Example};
use seamwright_project::{Failure, files};
use std::io::Read as _;
use std::sync::Arc;

fn example(name: &str) -> Option<&'static str> {
    EXAMPLES.iter().find(|e| name.strip_suffix(".toml") == Some(e.name)).map(|e| e.text)
}

pub(super) fn title(text: &str) -> String {
    let found = text.lines().find_map(|line| line.trim().strip_prefix("title")?.trim_start().strip_prefix('='));
    let quoted = found.and_then(|rest| rest.trim().strip_prefix('"')).and_then(|rest| rest.split('"').next());
    quoted.unwrap_or_default().to_owned()
}

/// Returns the text of a job: an own one or an example.
pub(crate) fn text(panel: &Panel, name: &str) -> Result<String, Refused> {
    let name = checked(name)?;
    let path = panel.jobs().join(name);
    if path.is_file() {
        return Ok(files::read_up_to(&path, MAX_JOB_BYTES)?);
    }
    example(name).map(str::to_owned).ok_or_else(|| Refused::not_found(Message::new("server-no-job").text("job", name)))
}

/// Returns the sorted names of own jobs.
pub(super) fn own(panel: &Panel) -> Result<Vec<String>, Refused> {
    let entries = std::fs::read_dir(panel.jobs())
        .map_err(|e| Refused::server(Message::new("server-jobs-unreadable").text("why", e.to_string())))?;
    let files = entries.filter_map(Result::ok).filter(|entry| entry.path().is_file());
    let names = files.filter_map(|entry| entry.file_name().into_string().ok());
    let mut names: Vec<String> = names.filter(|name| checked(name).is_ok()).collect();
    names.sort();
    Ok(names)
}

/// Size of the start of a file in which its title is searched, bytes.
const HEAD: u64 = 16 << 10;

/// Reads the start of a file.
pub(super) fn head(path: &std::path::Path) -> std::io::Result<String> {
    let mut head = Vec::new();
    std::fs::File::open(path)?.take(HEAD).read_to_end(&mut head)?;
    Ok(String::from_utf8_lossy(&head).into_owned())
}

pub(super) async fn list(State(panel): Shared) -> Answer<Vec<JobRow>> {
    let list = move |asked: &Arc<Panel>| {
        let row = |name: String| match head(&asked.jobs().join(&name)) {
            Ok(head) => matches!(kind_of_head(&head), Kind::Job | Kind::Program).then(|| JobRow {
                name,
                title: title(&head),
                example: false,
            }),
            Err(e) => Some(JobRow { name, title: e.to_string(), example: false }),
        };
        let mut rows: Vec<JobRow> = own(asked)?.into_iter().take(MAX_JOBS).filter_map(row).collect();
        for example in EXAMPLES {
            let name = format!("{}.toml", example.name);
            if rows.iter().all(|row| row.name != name) {
                rows.push(JobRow { name, title: title(example.text), example: true });
            }
        }
        Ok(rows)
    };
    panel.run(|panel| &panel.reading, list).await.map(Json)
}

pub(super) async fn distortions() -> Json<Vec<DistortionRow>> {
    let row = |example: &Example| DistortionRow { name: example.name.to_owned(), text: example.text.to_owned() };
    Json(DISTORTIONS.iter().map(row).collect())
}

pub(super) async fn get(State(panel): Shared, Path(name): Path<String>) -> Answer<JobText> {
    panel.run(|panel| &panel.reading, move |asked| Ok(JobText { text: text(asked, &name)? })).await.map(Json)
}

pub(super) async fn put(
    State(panel): Shared,
    session: Session,
    Path(name): Path<String>,
    Json(job): Json<JobKept>,
) -> Answer<JobRow> {
    panel.run(|panel| &panel.saving, move |on| keep(on, &session, &name, &job)).await.map(Json)
}

fn keep(panel: &Panel, session: &Session, name: &str, job: &JobKept) -> Result<JobRow, Refused> {
    let name = checked(name)?;
    if example(name).is_some() {
        return Err(Message::new("server-template-name").text("job", name).into());
    }
    // A job may be incomplete; an invalid procedure would invalidate every job that names it.
    if kind_of_head(&job.text) == Kind::Procedure {
        Procedure::read(name, &job.text).map_err(Failure::from)?;
    }
    let path = panel.jobs().join(name);
    let old = if path.is_file() { files::read_up_to(&path, MAX_JOB_BYTES)? } else { String::new() };
    if job.over.as_ref().is_some_and(|over| *over != old) {
        return Err(Refused::new(StatusCode::CONFLICT, "other", Message::new("server-other-text").text("job", name)));
    }
    if !path.is_file() && own(panel)?.len() >= MAX_JOBS {
        return Err(Message::new("server-too-many-jobs").count("max", MAX_JOBS).into());
    }
    files::write(&path, &job.text)?;
    let hash = |text: &str| seamwright_record::sha256(text.as_bytes());
    let (old, new) = (hash(&old), hash(&job.text));
    let command = Message::new("server-audit-save-job").text("job", name);
    panel.audit(&session.user, command, Change { old: &old, new: &new }, Message::new("server-audit-saved"));
    Ok(JobRow { name: name.to_owned(), title: title(&job.text), example: false })
}

pub(super) async fn delete(
    State(panel): Shared,
    session: Session,
    Path(name): Path<String>,
) -> Result<StatusCode, Refused> {
    panel.run(|panel| &panel.saving, move |on| remove(on, &session, &name)).await?;
    Ok(StatusCode::NO_CONTENT)
}

fn remove(panel: &Panel, session: &Session, name: &str) -> Result<(), Refused> {
    let name = checked(name)?;
    let path = panel.jobs().join(name);
    if !path.is_file() {
        return Err(Refused::not_found(Message::new("server-no-own-job").text("job", name)));
    }
    // Of any size: a job that is too large to be read can be removed.
    let (old, _) = seamwright_record::sha256_of_file(&path)?;
    std::fs::remove_file(&path).map_err(|e| {
        Refused::server(Message::new("server-job-not-deleted").text("job", name).text("why", e.to_string()))
    })?;
    let command = Message::new("server-audit-delete-job").text("job", name);
    panel.audit(&session.user, command, Change { old: &old, new: "" }, Message::new("server-audit-deleted"));
    Ok(())
}
