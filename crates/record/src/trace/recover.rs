use super::parquet_file;
use super::raw::RawReader;
use crate::error::{Doing, Error};
use std::fs;
use std::path::{Path, PathBuf};

/// A part of a trace: a raw file that became a Parquet file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecoveredPart {
    /// The Parquet file.
    pub path: PathBuf,
    /// Its rows.
    pub rows: u64,
    /// Bytes at the raw file's end that form no whole block: a block that was being written. If there are more than one
    /// can have, the raw file is kept under the name `.damaged`.
    pub unread_bytes: u64,
}

/// Bytes that a block cut off may have; more is damage.
const TORN: u64 = 1 << 18;

/// Converts all raw files in `folder` that are not being written to Parquet, in the order of the trace's parts.
///
/// # Errors
/// If the folder cannot be read or written. A raw file without a whole header has no rows; it is moved away under the
/// name `.damaged` and counts as a part of no rows.
pub fn recover(folder: &Path) -> Result<Vec<RecoveredPart>, Error> {
    let unreadable = |e| Error::io(folder, Doing::Read, e);
    let mut raws = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.extension().is_some_and(|e| e == "raw") {
            raws.push(path);
        }
    }
    // `trace-10.raw` comes after `trace-2.raw`.
    raws.sort_by_key(|raw| (raw.as_os_str().len(), raw.clone()));
    let parts = raws.iter().map(|raw| recover_part(raw)).collect::<Result<Vec<_>, _>>()?;
    Ok(parts.into_iter().flatten().collect())
}

fn recover_part(raw: &Path) -> Result<Option<RecoveredPart>, Error> {
    let path = raw.with_extension("parquet");
    let mut reader = match RawReader::open(raw) {
        Ok(Some(reader)) => reader,
        Ok(None) => return Ok(None),
        Err(Error::Damaged { .. }) => {
            let unread_bytes = fs::metadata(raw).map_or(0, |m| m.len());
            move_away(raw)?;
            return Ok(Some(RecoveredPart { path, rows: 0, unread_bytes }));
        }
        Err(e) => return Err(e),
    };
    let rows = parquet_file::write(&mut reader, &path)?;
    let unread_bytes = reader.left;
    if unread_bytes > TORN {
        move_away(raw)?;
    } else {
        fs::remove_file(raw).map_err(|e| Error::io(raw, Doing::Remove, e))?;
    }
    Ok(Some(RecoveredPart { path, rows, unread_bytes }))
}

fn move_away(raw: &Path) -> Result<(), Error> {
    fs::rename(raw, raw.with_extension("raw.damaged")).map_err(|e| Error::io(raw, Doing::Move, e))
}

pub(crate) fn is_written(folder: &Path) -> bool {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut raws = entries.map(|e| e.path()).filter(|p| p.extension().is_some_and(|e| e == "raw"));
    raws.any(|raw| matches!(RawReader::open(&raw), Ok(None)))
}
