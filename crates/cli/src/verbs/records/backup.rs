use super::{folder, open};
use crate::args::records::{BackupArgs, RestoreArgs};
use crate::failure::Failure;
use crate::files;
use crate::rows::{print_json, print_text};
use serde_json::json;

pub(super) fn backup(args: &BackupArgs) -> Result<(), Failure> {
    let data = open(args.data.data.as_deref())?;
    files::write_with(&args.output, |out| Ok(data.back_up(out)?))?;
    let bytes = std::fs::metadata(&args.output).map_or(0, |m| m.len());
    match args.data.json {
        true => print_json(&json!({ "file": args.output, "bytes": bytes })),
        false => print_text(&format!("{}: {:.1} MB\n", args.output.display(), bytes as f64 / 1e6)),
    }
}

pub(super) fn restore(args: &RestoreArgs) -> Result<(), Failure> {
    let to = folder(args.data.data.as_deref())?;
    seamwright_record::restore(&args.archive, &to)?;
    match args.data.json {
        true => print_json(&json!({ "folder": to })),
        false => print_text(&format!("{}: restored; check it with `seamwright records verify`\n", to.display())),
    }
}
