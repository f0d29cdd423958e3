use super::data::{folder, open};
use crate::args::records::{BackupArgs, RestoreArgs};
use crate::rows::print_either;
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use serde_json::json;

pub(super) fn backup(args: &BackupArgs) -> Result<(), Failure> {
    let data = open(args.data.data.as_deref())?;
    // It has the users with their password hashes.
    files::write_secret_with(&args.output, |out| Ok(data.back_up(out)?))?;
    let bytes = std::fs::metadata(&args.output).map_or(0, |m| m.len());
    let written = Message::new("cli-record-backup").text("file", args.output.display().to_string());
    let written = written.number("size", bytes as f64 / 1e6, 1);
    print_either(args.data.json, &json!({ "file": args.output, "bytes": bytes }), || format!("{written}\n"))
}

pub(super) fn restore(args: &RestoreArgs) -> Result<(), Failure> {
    let to = folder(args.data.data.as_deref())?;
    seamwright_record::restore(&args.archive, &to)?;
    let restored = Message::new("cli-record-restored").text("folder", to.display().to_string());
    print_either(args.data.json, &json!({ "folder": to }), || format!("{restored}\n"))
}
