use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_record::DataFolder;
use seamwright_record::library::WeldResult;
use std::path::{Path, PathBuf};

/// The data folder, to be read.
pub(super) fn open(data: Option<&Path>) -> Result<DataFolder, Failure> {
    Ok(DataFolder::open_to_read(&folder(data)?)?)
}

/// The folder asked for, or the usual one.
pub(crate) fn folder(data: Option<&Path>) -> Result<PathBuf, Failure> {
    if let Some(data) = data {
        return Ok(data.to_owned());
    }
    let named = |name: &str| std::env::var_os(name).filter(|v| !v.is_empty()).map(PathBuf::from);
    let home = || named("HOME").or_else(|| named("USERPROFILE")).map(|home| home.join(".local/share"));
    named("SEAMWRIGHT_DATA")
        .or_else(|| Some(named("XDG_DATA_HOME").or_else(home)?.join("seamwright")))
        .ok_or_else(|| Failure::refused(Message::new("cli-no-data-folder"), Message::new("cli-data-folder")))
}

pub(super) fn result(result: WeldResult) -> Message {
    Message::new(match result {
        WeldResult::Running => "cli-result-running",
        WeldResult::Good => "cli-result-good",
        WeldResult::Deviating => "cli-result-deviating",
        WeldResult::Stopped => "cli-result-stopped",
        WeldResult::Interrupted => "cli-result-interrupted",
    })
}
