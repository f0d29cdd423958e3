//! One row, planned on each of its machines.

use crate::job_text::{JobText, in_row};
use crate::table::{Row, Table};
use seamwright_message::{Language, Message};
use seamwright_motion::WeldMotion;
use seamwright_program::Finding;
use seamwright_project::failure::Failure;
use seamwright_project::load::{Loaded, load_text_from};
use seamwright_project::planning::Planning;
use seamwright_project::posting::PostTarget;
use seamwright_report::WeldReport;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// Outcome of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// It can be welded as asked.
    Weldable,
    /// It cannot; the findings say why.
    NotWeldable,
    /// Its searches took longer than allowed.
    OutOfTime,
    /// Its job is invalid; `error` says why.
    Invalid,
    /// Its part program deviates when it is read back, or the planner failed.
    Failed,
}

impl Status {
    /// The word in result files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Weldable => "weldable",
            Self::NotWeldable => "not_weldable",
            Self::OutOfTime => "out_of_time",
            Self::Invalid => "invalid",
            Self::Failed => "failed",
        }
    }
}

/// Result of a row, of one part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RowResult {
    /// Outcome.
    pub status: Status,
    /// The machine of these figures: of those that can weld it the fastest, otherwise the one with the fewest findings.
    pub machine: String,
    /// Time of one part on each machine that can weld it, s.
    pub times: BTreeMap<String, f64>,
    /// Number of passes.
    pub passes: usize,
    /// Length of all passes, mm.
    pub length_mm: f64,
    /// Time from home to home, s.
    pub total_s: f64,
    /// Time with the arc or beam on, s.
    pub arc_s: f64,
    /// Wire, kg; none if unknown.
    pub wire_kg: Option<f64>,
    /// Shielding gas, l; none if unknown.
    pub gas_l: Option<f64>,
    /// Arc energy, kJ; none if unknown.
    pub energy_kj: Option<f64>,
    /// Cost by the job's rates.
    pub cost: Option<f64>,
    /// Minimum distance of everything watched, mm; none if nothing is near.
    pub clearance_mm: Option<f64>,
    /// Number of findings by code.
    pub findings: BTreeMap<String, usize>,
    /// Number of findings that prevent the weld.
    pub blocking: usize,
    /// The fault of an invalid or failed row, in the language of the process.
    pub error: Option<String>,
}

/// Limits of a row and what is written of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RowTerms<'a> {
    /// Time limit of the searches of each plan.
    pub(crate) limit: Duration,
    /// Control to write part programs for.
    pub(crate) post: Option<PostTarget>,
    /// Set to cancel it.
    pub(crate) cancel: Option<&'a AtomicBool>,
    /// Language of faults.
    pub(crate) language: Language,
}

/// A result, and the part program if there is one.
pub(crate) type Planned = (RowResult, Option<String>);

/// Plans a row as [`plan_row`] does; a panic costs only this row.
///
/// # Errors
/// [`Failure::Cancelled`] only.
pub(crate) fn plan_contained(table: &Table, row: &Row, jobs: &[JobText], terms: RowTerms) -> Result<Planned, Failure> {
    let planned = catch_unwind(AssertUnwindSafe(|| plan_row(table, row, jobs, terms)));
    planned.unwrap_or_else(|_| Ok((RowResult::failed(terms.language), None)))
}

/// Plans a row on all of its machines. Returns the result, and the proven part program of the machine chosen.
///
/// # Errors
/// [`Failure::Cancelled`] only: a fault of the row is a result.
fn plan_row(table: &Table, row: &Row, jobs: &[JobText], terms: RowTerms) -> Result<Planned, Failure> {
    let mut best: Option<Planned> = None;
    let mut times = BTreeMap::new();
    for job in jobs {
        let (result, program) = plan_job(table, row, job, terms)?;
        if result.status == Status::Weldable {
            times.insert(result.machine.clone(), result.total_s);
        }
        let key = |r: &RowResult| (r.status != Status::Weldable, r.blocking, r.error.is_some());
        let is_better = best.as_ref().is_none_or(|(old, _)| {
            key(&result) < key(old) || (key(&result) == key(old) && result.total_s < old.total_s && old.total_s > 0.0)
        });
        if is_better {
            best = Some((result, program));
        }
    }
    let (mut result, program) = best.unwrap_or_else(|| (RowResult::without_plan(Status::Invalid, String::new()), None));
    result.times = times;
    Ok((result, program))
}

fn plan_job(table: &Table, row: &Row, job: &JobText, terms: RowTerms) -> Result<Planned, Failure> {
    let refused = |failure: Failure| {
        let failure = match failure {
            Failure::Cancelled => return Err(Failure::Cancelled),
            Failure::Document(error) => in_row(table, row, *error),
            other => other,
        };
        Ok((RowResult::without_plan(Status::Invalid, failure.text_in(terms.language)), None))
    };
    let name = format!("{}: {}", row.name, row.template);
    let planning = Planning { limit: Some(terms.limit), cancel: terms.cancel, progress: None };
    let loaded = load_text_from(&name, &job.text, &job.folder, table.store())
        .and_then(|loaded| loaded.with_torch_angles(&planning));
    let loaded = match loaded {
        Ok(loaded) => loaded,
        Err(failure) => return refused(failure),
    };
    let machine = loaded.welding.program.value.machine.clone();
    match loaded.try_plan_under(&loaded.machine, &planning) {
        Err(failure) => refused(failure),
        Ok(Err(findings)) => Ok((RowResult::blocked(machine, &findings), None)),
        Ok(Ok(motion)) => {
            let mut result = RowResult::of(machine, &loaded, &motion);
            let target = terms.post.filter(|_| result.status == Status::Weldable);
            match target.map(|target| target.proven(&loaded, &motion)).transpose() {
                Ok(program) => Ok((result, program.map(|(text, _)| text))),
                Err(why) => {
                    result.status = Status::Failed;
                    result.error = Some(why.message().in_language(terms.language));
                    Ok((result, None))
                }
            }
        }
    }
}

impl RowResult {
    /// A row without a plan.
    #[must_use]
    pub fn without_plan(status: Status, error: String) -> Self {
        Self {
            status,
            machine: String::new(),
            times: BTreeMap::new(),
            passes: 0,
            length_mm: 0.0,
            total_s: 0.0,
            arc_s: 0.0,
            wire_kg: None,
            gas_l: None,
            energy_kj: None,
            cost: None,
            clearance_mm: None,
            findings: BTreeMap::new(),
            blocking: 0,
            error: Some(error).filter(|text| !text.is_empty()),
        }
    }

    /// A row whose planner failed.
    pub(crate) fn failed(language: Language) -> Self {
        Self::without_plan(Status::Failed, Message::new("schedule-planner-failed").in_language(language))
    }

    fn blocked(machine: String, findings: &[Finding]) -> Self {
        let mut result = Self { machine, ..Self::without_plan(status_of(findings), String::new()) };
        result.count(findings);
        result
    }

    fn of(machine: String, loaded: &Loaded, motion: &WeldMotion) -> Self {
        let (report, _) = WeldReport::new(&loaded.machine, &loaded.welding, motion, None, Language::English);
        let totals = report.totals;
        let nearest = motion.clearance.iter().flatten().filter_map(|pass| pass.nearest.as_ref().map(|n| n.0));
        let clearance = nearest.fold(f64::INFINITY, f64::min);
        let mut result = Self {
            machine,
            passes: totals.passes,
            length_mm: totals.length_mm,
            total_s: totals.total_s,
            arc_s: totals.arc_on_s,
            wire_kg: totals.wire_kg,
            gas_l: totals.gas_l,
            energy_kj: totals.arc_energy_kj,
            cost: totals.cost.map(|cost| cost.total),
            clearance_mm: Some(clearance).filter(|mm| mm.is_finite()),
            ..Self::without_plan(Status::Weldable, String::new())
        };
        result.count(&motion.findings);
        if result.blocking > 0 {
            result.status = Status::NotWeldable;
        }
        result
    }

    fn count(&mut self, findings: &[Finding]) {
        (self.blocking, self.findings) = counted(findings);
    }
}

/// Number of findings that prevent a weld, and the number of all by code.
pub(crate) fn counted(findings: &[Finding]) -> (usize, BTreeMap<String, usize>) {
    let mut by_code = BTreeMap::new();
    for finding in findings {
        *by_code.entry(finding.message.code.to_string()).or_default() += 1;
    }
    (findings.iter().filter(|finding| !finding.allowed).count(), by_code)
}

/// Whether findings that prevent a plan say that it was out of time.
pub(crate) fn status_of(findings: &[Finding]) -> Status {
    let is_search = findings.iter().any(|f| f.kind == "search" && !f.allowed);
    if is_search { Status::OutOfTime } else { Status::NotWeldable }
}
