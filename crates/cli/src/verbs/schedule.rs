use super::positive;
use crate::args::schedule::ScheduleArgs;
use crate::progress::Progress;
use crate::refusals::{at_most, between, not_allowed};
use crate::rows::print_text;
use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_schedule::{Schedule, Table};
use std::time::Duration;

/// Maximum number of threads.
const MAX_THREADS: usize = 256;
/// Maximum time limit of a row, s.
const MAX_LIMIT_S: f64 = 1e6;

pub(crate) fn run(args: &ScheduleArgs) -> Result<(), Failure> {
    let limit = positive("--time-limit", args.planning.time_limit)?;
    if limit > MAX_LIMIT_S {
        return Err(not_allowed("--time-limit", limit, at_most(MAX_LIMIT_S, Unit::S)));
    }
    let threads = match args.jobs {
        Some(jobs) if !(1..=MAX_THREADS).contains(&jobs) => {
            return Err(not_allowed("--jobs", jobs, between(1.0, MAX_THREADS as f64)));
        }
        Some(jobs) => jobs,
        None => std::thread::available_parallelism().map_or(1, usize::from),
    };
    let (table, rows) = Table::open(&args.table)?;
    let schedule = Schedule {
        table: &table,
        output: &args.output,
        threads,
        limit: Duration::from_secs_f64(limit),
        post: args.post.map(Into::into),
    };
    let bar = Progress::new("cli-progress-rows", rows);
    let summary = schedule.run(&|progress| bar.at(progress.done))?;
    drop(bar);
    let message = Message::new("cli-schedule-done").number("weldable", summary.weldable as f64, 0);
    let message = message.number("rows", summary.rows as f64, 0).number("kept", summary.kept as f64, 0);
    let files: Vec<String> = summary.files.iter().map(|file| file.display().to_string()).collect();
    print_text(&format!("{message}\n{}\n", files.join("\n")))?;
    if summary.weldable == summary.rows { Ok(()) } else { Err(Failure::Printed) }
}
