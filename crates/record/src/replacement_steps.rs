//! Steps of a replacement of the data, each of which can be repeated.

use crate::error::{Doing, Error};
use crate::moment::Moment;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// An archive that was checked, unpacked inside the data folder; to be thrown away or to replace the data.
pub(crate) const CHECKED: &str = "restore-checked";

/// The same once it is decided: the old data are moved into its `old`.
pub(crate) const BEGUN: &str = "restore-begun";

/// The same once the old data are moved away: its `new` replaces them.
pub(crate) const MOVED: &str = "restore-moved";

/// Files that a restore replaces: an archive has some of them. Keys of encrypted connections (`tls`) stay.
pub(crate) const REPLACED: [&str; 10] = [
    LIBRARY,
    "library.sqlite-wal",
    "library.sqlite-shm",
    "welds",
    "jobs",
    USERS,
    // Browsers that users of before are known in.
    "devices.json",
    "position.a",
    "position.b",
    // Orders and alarms that wait for the library: they belong to the old data.
    crate::waiting_file::NAME,
];
/// Users with hashes of their passwords.
pub(crate) const USERS: &str = "users.json";
/// The library in the archive.
pub(crate) const LIBRARY: &str = "library.sqlite";

/// Continues an interrupted restore: its folder's name shows the step reached, and each step can be repeated. Returns
/// the folder of the old data, or `None` if no restore was interrupted.
///
/// # Errors
/// If files cannot be moved.
pub fn finish_replacing(data: &Path) -> Result<Option<PathBuf>, Error> {
    let (begun, moved) = (data.join(BEGUN), data.join(MOVED));
    if begun.is_dir() {
        let old = begun.join("old");
        fs::create_dir_all(&old).map_err(|e| Error::io(&old, Doing::Create, e))?;
        take(data, &old)?;
        step(&begun, &moved)?;
        synced(data)?;
    }
    if !moved.is_dir() {
        return Ok(None);
    }
    take(&moved.join("new"), data)?;
    let stamp = Moment::now().to_string().replace([':', ' '], "-");
    let kept = data.join(format!("before-restore-{stamp}"));
    if moved.join("old").is_dir() {
        step(&moved.join("old"), &kept)?;
    }
    synced(data)?;
    fs::remove_dir_all(&moved).map_err(|e| Error::io(&moved, Doing::Remove, e))?;
    Ok(Some(kept))
}

pub(crate) fn take(from: &Path, to: &Path) -> Result<(), Error> {
    let there = |name: &&&str| fs::symlink_metadata(from.join(name)).is_ok();
    REPLACED.iter().filter(there).try_for_each(|name| step(&from.join(name), &to.join(name)))?;
    synced(to)
}

fn step(from: &Path, to: &Path) -> Result<(), Error> {
    fs::rename(from, to).map_err(|e| Error::io(from, Doing::Move, e))
}

/// The folder's entries are on the disk.
pub(crate) fn synced(folder: &Path) -> Result<(), Error> {
    // Other systems do not open folders, and need not.
    if cfg!(not(unix)) {
        return Ok(());
    }
    File::open(folder).and_then(|f| f.sync_all()).map_err(|e| Error::io(folder, Doing::Write, e))
}

/// A folder and all that is in it is on the disk.
pub(crate) fn sync(path: &Path) -> std::io::Result<()> {
    if path.is_dir() {
        for entry in fs::read_dir(path)? {
            sync(&entry?.path())?;
        }
        if cfg!(not(unix)) {
            return Ok(());
        }
    }
    File::open(path)?.sync_all()
}
