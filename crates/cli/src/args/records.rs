//! Arguments of `seamwright records`, and those with which a weld is recorded.

use clap::{Args, Subcommand};
use seamwright_record::InvalidMoment;
use seamwright_record::Moment;
use seamwright_record::library::WeldResult;
use std::path::PathBuf;

/// Recording of a weld.
#[derive(Debug, Default, Args)]
pub(crate) struct RecordArgs {
    /// Record the weld in the library of this data folder (docs/reference/records.md), made if missing
    #[arg(long, value_name = "DIR")]
    pub(crate) data: Option<PathBuf>,
    /// Number of the part in the shop
    #[arg(long, value_name = "ID", requires = "data", default_value = "", hide_default_value = true)]
    pub(crate) part: String,
    /// Name of the welder
    #[arg(long, value_name = "NAME", requires = "data")]
    pub(crate) welder: Option<String>,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  seamwright simulate examples/saddle.toml -o out/saddle --data records --part N-17
  seamwright records list --data records --part N-17
  seamwright records export 1 -o out/n-17 --data records
Without --data the folder is $SEAMWRIGHT_DATA, or else seamwright in $XDG_DATA_HOME (~/.local/share).")]
pub(crate) struct RecordsArgs {
    #[command(subcommand)]
    pub(crate) action: Action,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Action {
    /// List the welds, the newest first
    List(ListArgs),
    /// Show the record of a weld
    Show(ShowArgs),
    /// Export the trace, report and figures of a weld
    Export(ExportArgs),
    /// Print the audit log as JSON lines, the oldest entry first
    Audit(LinesArgs),
    /// Print all alarms as JSON lines, the oldest first
    Alarms(LinesArgs),
    /// Check the database, the audit log and the hash of every file; exit code 1 if there are problems
    Verify(VerifyArgs),
    /// Write a data folder to one file, also while the panel runs
    Backup(BackupArgs),
    /// Restore a data folder from a backup
    Restore(RestoreArgs),
    /// Recover welds after a crash: their traces become readable, their result is interrupted
    Recover(RecoverArgs),
}

/// The data folder.
#[derive(Debug, Args)]
pub(crate) struct DataArgs {
    /// Data folder [default: $SEAMWRIGHT_DATA, or seamwright in $XDG_DATA_HOME]
    #[arg(long, value_name = "DIR")]
    pub(crate) data: Option<PathBuf>,
    /// JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright records list --data records --since 2026-11-01 --result stopped")]
pub(crate) struct ListArgs {
    #[command(flatten)]
    pub(crate) data: DataArgs,
    /// Only welds of this part
    #[arg(long, value_name = "ID")]
    pub(crate) part: Option<String>,
    /// Only welds begun at this date (UTC) or later: 2026-11-21, "2026-11-21 14:05"
    #[arg(long, value_name = "DATE")]
    pub(crate) since: Option<Moment>,
    /// Only welds begun at this date (UTC) or before; a day counts to its end
    #[arg(long, value_name = "DATE", value_parser = end)]
    pub(crate) until: Option<Moment>,
    /// Only welds by the procedure of this number
    #[arg(long, value_name = "NUMBER")]
    pub(crate) procedure: Option<String>,
    /// Only welds on this machine
    #[arg(long, value_name = "NAME")]
    pub(crate) machine: Option<String>,
    /// Only welds with this result: good, deviating, stopped, interrupted, running
    #[arg(long, value_name = "RESULT")]
    pub(crate) result: Option<WeldResult>,
    /// Only welds with this text in part, title, welder, note, job, program or alarms
    #[arg(long, value_name = "TEXT")]
    pub(crate) text: Option<String>,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright records show 1 --data records")]
pub(crate) struct ShowArgs {
    /// Number of the weld
    pub(crate) id: i64,
    #[command(flatten)]
    pub(crate) data: DataArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  seamwright records export 1 -o out/weld-1 --data records
  seamwright records export 1 -o out/weld-1 --data records --language de")]
pub(crate) struct ExportArgs {
    /// Number of the weld
    pub(crate) id: i64,
    /// Folder for trace.parquet, report.html, record.json and program.toml; made if missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    #[command(flatten)]
    pub(crate) data: DataArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  seamwright records audit --data cell --since 2026-11-01
  seamwright records alarms --data cell --after 1200 >> alarms.jsonl")]
pub(crate) struct LinesArgs {
    /// Data folder [default: $SEAMWRIGHT_DATA, or seamwright in $XDG_DATA_HOME]
    #[arg(long, value_name = "DIR")]
    pub(crate) data: Option<PathBuf>,
    /// Only entries at this date (UTC) or later: 2026-11-21, "2026-11-21 14:05"
    #[arg(long, value_name = "DATE")]
    pub(crate) since: Option<Moment>,
    /// Only entries at this date (UTC) or before; a day counts to its end
    #[arg(long, value_name = "DATE", value_parser = end)]
    pub(crate) until: Option<Moment>,
    /// Only entries with a number (`id`) higher than this: the last one of the export before
    #[arg(long, value_name = "ID", value_parser = clap::value_parser!(i64).range(0..))]
    pub(crate) after: Option<i64>,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright records verify --data records")]
pub(crate) struct VerifyArgs {
    #[command(flatten)]
    pub(crate) data: DataArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright records recover --data records")]
pub(crate) struct RecoverArgs {
    #[command(flatten)]
    pub(crate) data: DataArgs,
}

/// The end of what a date names: the next day, or the next minute.
fn end(text: &str) -> Result<Moment, InvalidMoment> {
    let moment: Moment = text.parse()?;
    Ok(if text.contains(':') { Moment(moment.0 + 60_000) } else { moment.next_day() })
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright records backup -o cell.tar --data cell")]
pub(crate) struct BackupArgs {
    /// The file to write (tar)
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: PathBuf,
    #[command(flatten)]
    pub(crate) data: DataArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright records restore cell.tar --data new-cell")]
pub(crate) struct RestoreArgs {
    /// Backup, written by `records backup` or the panel
    pub(crate) archive: PathBuf,
    #[command(flatten)]
    pub(crate) data: DataArgs,
}
