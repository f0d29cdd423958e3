//! Questions to a planner, answered only from a text and the folder of jobs.

use super::OnProgress;
use super::reach::reached;
use super::schedule::ScheduleWork;
use crate::http::{Refused, found_place, planned};
use crate::view::{clamped_views, sections, work_view};
use crate::wire::{DraftAnswer, Load, PlaceText, PlanAnswer, PostAnswer, ReachText, WrongView};
use seamwright_document::DocumentError;
use seamwright_message::Message;
use seamwright_project::Failure;
use seamwright_project::load::{Loaded, load_foreign};
use seamwright_project::planning::Planning;
use seamwright_project::posting::{PostTarget, Unproven};
use seamwright_record::Moment;
use seamwright_report::{Extent, Language, WeldReport};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// File name of the text in question.
pub(crate) const JOB: &str = "job.toml";

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub(crate) enum Question {
    /// Contents of the text without a plan: a [`DraftAnswer`].
    Draft { text: String },
    /// Its plan: a [`PlanAnswer`] with this number.
    Plan { text: String, number: u64 },
    /// Plan of a recorded weld: a [`crate::wire::WorkView`].
    Recorded { name: String, text: String, number: u64 },
    /// Report of its plan: an HTML page.
    Report { name: String, text: String, language: String, appendix: bool },
    /// Part program for it: a [`PostAnswer`].
    Post { text: String, dialect: String },
    /// Check that it can be planned and loaded: its motion, see [`seamwright_cell::encode_plan`].
    Load { load: Load, text: String },
    /// Pose of its part: a [`crate::wire::PlaceAnswer`].
    Place { asked: PlaceText },
    /// Search for the best placement: a [`crate::wire::ReachAnswer`].
    Reach { asked: ReachText },
    /// Plans of all rows of a table: a [`seamwright_schedule::Summary`] as numbers of rows and of weldable ones.
    Schedule { asked: ScheduleWork },
}

impl Question {
    /// It may take hours.
    pub(crate) fn is_long(&self) -> bool {
        matches!(self, Self::Schedule { .. })
    }

    /// Language of what it writes; none: English.
    pub(crate) fn language(&self) -> Option<Language> {
        if let Self::Schedule { asked } = self { asked.options.language.parse().ok() } else { None }
    }

    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Draft { .. } => "draft",
            Self::Plan { .. } => "plan",
            Self::Recorded { .. } => "recorded",
            Self::Report { .. } => "report",
            Self::Post { .. } => "post",
            Self::Load { .. } => "load",
            Self::Place { .. } => "place",
            Self::Reach { .. } => "reach",
            Self::Schedule { .. } => "schedule",
        }
    }

    /// Answers with the bytes of JSON or of an HTML page.
    /// Fails if the text is invalid, unless the answer contains the reason.
    /// `progress` is called by questions that know how far they are.
    pub(crate) fn answer(&self, jobs: &Path, progress: OnProgress) -> Result<Vec<u8>, Refused> {
        match self {
            Self::Draft { text } => json(&draft(text, jobs)),
            Self::Plan { text, number } => json(&plan(text, *number, jobs)),
            Self::Recorded { name, text, number } => {
                let loaded = ready_to_plan(name, text, jobs)?;
                let planned = loaded.try_plan()?;
                json(&work_view(*number, name, &loaded, planned.as_ref().map_err(Vec::as_slice)))
            }
            Self::Report { name, text, language, appendix } => {
                let extent = if *appendix { Extent::WithAppendix } else { Extent::Summary };
                report(name, text, language, extent, jobs)
            }
            Self::Post { text, dialect } => json(&post(text, dialect, jobs)?),
            Self::Load { load, text } => planned(load, text, jobs),
            Self::Place { asked } => json(&found_place(asked, jobs)?),
            Self::Reach { asked } => json(&reached(asked, jobs, progress)?),
            Self::Schedule { asked } => json(&asked.plan(jobs, progress)?),
        }
    }
}

fn json(answer: &impl Serialize) -> Result<Vec<u8>, Refused> {
    serde_json::to_vec(answer).map_err(|e| Refused::server(e.to_string()))
}

fn draft(text: &str, jobs: &Path) -> DraftAnswer {
    match load_foreign(JOB, text, jobs) {
        Ok(loaded) => {
            let (part, fixtures) = clamped_views(&loaded);
            DraftAnswer::Drawn { part, fixtures, sections: sections(&loaded.welding) }
        }
        Err(failure) => DraftAnswer::Wrong { message: failure.message().into() },
    }
}

fn plan(text: &str, number: u64, jobs: &Path) -> PlanAnswer {
    let view = |loaded: &Loaded| {
        let planned = loaded.try_plan()?;
        let planned = planned.as_ref().map_err(Vec::as_slice);
        Ok(PlanAnswer::Planned { work: Box::new(work_view(number, "", loaded, planned)) })
    };
    ready_to_plan(JOB, text, jobs).and_then(|loaded| view(&loaded)).unwrap_or_else(|failure| wrong(&failure))
}

/// Reads a job and searches the torch angles that it asks for.
fn ready_to_plan(name: &str, text: &str, jobs: &Path) -> Result<Loaded, Failure> {
    load_foreign(name, text, jobs)?.with_torch_angles(&Planning::default())
}

fn wrong(failure: &Failure) -> PlanAnswer {
    let at = if let Failure::Document(error) = failure { Some(Box::new(wrong_view(error))) } else { None };
    PlanAnswer::Wrong { message: failure.message().into(), at }
}

/// Returns the parts of a fault; its line only if it is in the text [`JOB`] itself.
pub(crate) fn wrong_view(error: &DocumentError) -> WrongView {
    WrongView {
        file: (error.file != JOB).then(|| error.file.clone()),
        line: (error.file == JOB && error.line > 0).then_some(error.line),
        key: error.key.clone(),
        value: error.value.clone(),
        what: (&error.message).into(),
        allowed: error.allowed.as_ref().map(Into::into),
        help: error.help.as_ref().map(Into::into),
    }
}

fn report(name: &str, text: &str, language: &str, extent: Extent, jobs: &Path) -> Result<Vec<u8>, Refused> {
    let language = language.parse::<Language>().map_err(|e| Refused::input(e.to_string()))?;
    let loaded = ready_to_plan(name, text, jobs)?;
    let motion = loaded.try_plan()?.map_err(Failure::Findings)?;
    let (report, plots) = WeldReport::new(&loaded.machine, &loaded.welding, &motion, None, language);
    let date = Moment::now().to_string();
    Ok(report.page(&plots, loaded.welding.program.text(), &date, extent, language).into_bytes())
}

fn post(text: &str, dialect: &str, jobs: &Path) -> Result<PostAnswer, Refused> {
    let Some(target) = PostTarget::named(dialect) else {
        let allowed = PostTarget::all().map(PostTarget::name).collect::<Vec<_>>().join(", ");
        return Err(Message::new("server-no-dialect").text("name", dialect).text("allowed", allowed).into());
    };
    let loaded = ready_to_plan(JOB, text, jobs)?;
    let motion = loaded.plan()?;
    let (text, proof) = target.proven(&loaded, &motion).map_err(|e| match e {
        Unproven::Failure(failure) => failure.into(),
        Unproven::Wrong(lines) => Refused::server(Message::lines(lines)),
    })?;
    Ok(PostAnswer { text, proof: proof.messages().into_iter().map(Into::into).collect() })
}
