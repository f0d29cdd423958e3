use super::data::{folder, open};
use crate::args::records::{BackupArgs, RestoreArgs};
use crate::rows::{print_json, print_text};
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use serde_json::json;

pub(super) fn backup(args: &BackupArgs) -> Result<(), Failure> {
    let data = open(args.data.data.as_deref())?;
    files::write_with(&args.output, |out| Ok(data.back_up(out)?))?;
    let bytes = std::fs::metadata(&args.output).map_or(0, |m| m.len());
    match args.data.json {
        true => print_json(&json!({ "file": args.output, "bytes": bytes })),
        false => {
            let written = Message::new("cli-record-backup").text("file", args.output.display().to_string());
            print_text(&format!("{}\n", written.number("size", bytes as f64 / 1e6, 1)))
        }
    }
}

pub(super) fn restore(args: &RestoreArgs) -> Result<(), Failure> {
    let to = folder(args.data.data.as_deref())?;
    seamwright_record::restore(&args.archive, &to)?;
    match args.data.json {
        true => print_json(&json!({ "folder": to })),
        false => {
            let restored = Message::new("cli-record-restored").text("folder", to.display().to_string());
            print_text(&format!("{restored}\n"))
        }
    }
}
