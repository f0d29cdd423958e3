//! Limits of verbs that make many plans at the same time.

use super::positive;
use crate::args::cluster::ClusterArgs;
use crate::args::planning::PlanningArgs;
use crate::refusals::{at_most, between, not_allowed};
use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_schedule::Spark;
use std::time::Duration;

/// Maximum number of threads.
const MAX_THREADS: usize = 256;
/// Maximum time limit of a plan, s.
const MAX_LIMIT_S: f64 = 1e6;

/// Time limit of the searches of a plan.
pub(super) fn time_limit(planning: &PlanningArgs) -> Result<Duration, Failure> {
    let limit = positive("--time-limit", planning.time_limit)?;
    if limit > MAX_LIMIT_S {
        return Err(not_allowed("--time-limit", limit, at_most(MAX_LIMIT_S, Unit::S)));
    }
    Ok(Duration::from_secs_f64(limit))
}

/// Number of threads; that of the processors if it is not given.
pub(super) fn threads(jobs: Option<usize>) -> Result<usize, Failure> {
    match jobs {
        Some(jobs) if !(1..=MAX_THREADS).contains(&jobs) => {
            Err(not_allowed("--jobs", jobs, between(1.0, MAX_THREADS as f64)))
        }
        Some(jobs) => Ok(jobs),
        None => Ok(std::thread::available_parallelism().map_or(1, usize::from)),
    }
}

/// The cluster that plans, if one is asked for.
pub(super) fn spark(cluster: &ClusterArgs) -> Result<Option<Spark>, Failure> {
    let Some(address) = &cluster.spark else { return Ok(None) };
    if address.strip_prefix("sc://").is_none_or(str::is_empty) {
        return Err(not_allowed("--spark", address, Message::new("cli-allowed-spark")));
    }
    Ok(Some(Spark { address: address.clone(), python: cluster.python.clone() }))
}
