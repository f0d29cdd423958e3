//! The history of a program file, beside it.

use crate::refusals::not_json;
use seamwright_program::edit::{Editor, History};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use std::path::{Path, PathBuf};

pub(super) fn path(file: &Path) -> PathBuf {
    let mut name = file.as_os_str().to_owned();
    name.push(".edits");
    name.into()
}

/// The history of `file`, and whether it belongs to `text`, the file's present text; empty if it is missing.
pub(super) fn read(file: &Path, text: &str) -> Result<(History, bool), Failure> {
    let path = path(file);
    if !path.exists() {
        return Ok((History::default(), true));
    }
    Ok(History::from_json_lines(&path.display().to_string(), &files::read(&path)?, text)?)
}

pub(super) fn write(file: &Path, editor: &Editor) -> Result<(), Failure> {
    let lines = editor.history().to_json_lines(editor.text()).map_err(not_json)?;
    files::write(file, editor.text())?;
    files::write(&path(file), &lines)
}
