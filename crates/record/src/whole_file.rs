//! Files that are there whole or not at all: a temporary name, sync, rename, sync of the folder.

use crate::Error;
use std::fs::File;
use std::path::Path;
use tempfile::NamedTempFile;

/// The folder that `path` is in.
fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// A temporary file beside `path`.
pub(crate) fn beside(path: &Path) -> Result<NamedTempFile, Error> {
    let folder = folder_of(path);
    // The owner's alone, as temporary files are.
    let mut builder = tempfile::Builder::new();
    builder.prefix(".seamwright-").tempfile_in(folder).map_err(|e| Error::io(folder, "cannot be written", e))
}

/// Gives a written file its name.
pub(crate) fn keep(file: NamedTempFile, path: &Path) -> Result<(), Error> {
    let failed = |e| Error::io(path, "cannot be written", e);
    file.as_file().sync_all().map_err(failed)?;
    file.persist(path).map_err(|e| failed(e.error))?;
    sync_folder(path)
}

/// Makes the names in the folder of `path` last; where folders cannot be synced they last by themselves.
pub(crate) fn sync_folder(path: &Path) -> Result<(), Error> {
    if cfg!(unix) {
        let folder = folder_of(path);
        let synced = File::open(folder).and_then(|folder| folder.sync_all());
        synced.map_err(|e| Error::io(folder, "cannot be written", e))?;
    }
    Ok(())
}
