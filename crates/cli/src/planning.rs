//! Planning on a terminal: under a time limit, with a progress bar.

use crate::args::PlanningArgs;
use crate::progress::Progress;
use crate::refusals::{at_most, not_allowed};
use crate::verbs::positive;
use seamwright_message::{Message, Unit};
use seamwright_motion::{SearchProgress, WeldMotion};
use seamwright_program::Finding;
use seamwright_project::failure::Failure;
use seamwright_project::load::Loaded;
use seamwright_project::planning::Planning;
use seamwright_project::simulated_part::Part;
use std::path::Path;
use std::time::Duration;

/// Longest time limit that is allowed, s.
const MAX_LIMIT_S: f64 = 1e6;

/// Reads a job with its machine, and searches the torch angles that it asks for.
pub(crate) fn load(job: &Path, args: &PlanningArgs) -> Result<Loaded, Failure> {
    let loaded = seamwright_project::load::load(job)?;
    within(args, |planning| loaded.with_torch_angles(planning))
}

/// Plans the weld, or returns the reasons why the machine cannot make it.
pub(crate) fn try_plan(loaded: &Loaded, args: &PlanningArgs) -> Result<Result<WeldMotion, Vec<Finding>>, Failure> {
    let planned = within(args, |planning| loaded.try_plan_under(&loaded.machine, planning))?;
    Ok(planned.map_err(with_option))
}

pub(crate) fn plan(loaded: &Loaded, args: &PlanningArgs) -> Result<WeldMotion, Failure> {
    within(args, |planning| loaded.plan_under(&loaded.machine, planning)).map_err(findings_with_option)
}

pub(crate) fn plan_part(part: &Part, loaded: &Loaded, args: &PlanningArgs) -> Result<WeldMotion, Failure> {
    within(args, |planning| part.plan_under(loaded, planning)).map_err(findings_with_option)
}

fn findings_with_option(failure: Failure) -> Failure {
    match failure {
        Failure::Findings(findings) => Failure::Findings(with_option(findings)),
        failure => failure,
    }
}

/// Adds to the cure of a search that was cut off which option gives it more time.
fn with_option(mut findings: Vec<Finding>) -> Vec<Finding> {
    for cure in findings.iter_mut().filter(|f| f.kind == "search").filter_map(|f| f.cure.as_mut()) {
        *cure = Message::new("cli-more-time").message("cure", cure.clone());
    }
    findings
}

fn within<T>(args: &PlanningArgs, plan: impl FnOnce(&Planning) -> Result<T, Failure>) -> Result<T, Failure> {
    let limit = positive("--time-limit", args.time_limit)?;
    if limit > MAX_LIMIT_S {
        return Err(not_allowed("--time-limit", limit, at_most(MAX_LIMIT_S, Unit::S)));
    }
    let bar = Progress::of_searches();
    let show = |progress: &SearchProgress| bar.searched(progress);
    plan(&Planning { limit: Some(Duration::from_secs_f64(limit)), cancel: None, progress: Some(&show) })
}
