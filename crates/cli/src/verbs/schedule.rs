use super::job_limits::{spark, threads, time_limit};
use crate::args::schedule::ScheduleArgs;
use crate::progress::Progress;
use crate::rows::print_text;
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_schedule::{Schedule, Table};

pub(crate) fn run(args: &ScheduleArgs) -> Result<(), Failure> {
    let (limit, threads) = (time_limit(&args.planning)?, threads(args.jobs)?);
    let spark = spark(&args.cluster)?;
    let (table, rows) = Table::open(&args.table)?;
    let schedule = Schedule {
        table: &table,
        output: &args.output,
        threads,
        spark: spark.as_ref(),
        limit,
        post: args.post.map(Into::into),
        cancel: None,
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
