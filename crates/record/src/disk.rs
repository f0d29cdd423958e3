//! State of the disk of a data folder.

use crate::error::{Doing, Error};
use crate::private_files;
use std::io::Write as _;
use std::path::Path;

/// Room that must be left on the disk beside the trace of a weld, bytes.
pub const SPARE_BYTES: u64 = 64 << 20;

/// File that [`probe_disk`] writes.
const PROBE: &str = ".disk-probe";

/// Room on a disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DiskRoom {
    /// Bytes free for this user.
    pub free_bytes: u64,
    /// Size of the disk, bytes.
    pub total_bytes: u64,
}

/// Returns the room on the disk of `path`, if the system reports it.
///
/// # Errors
/// If there is no such path.
#[cfg(unix)]
pub fn disk_room(path: &Path) -> Result<Option<DiskRoom>, Error> {
    let room = rustix::fs::statvfs(path).map_err(|e| Error::io(path, Doing::Read, e.into()))?;
    let bytes = |blocks: u64| blocks.saturating_mul(room.f_frsize);
    Ok(Some(DiskRoom { free_bytes: bytes(room.f_bavail), total_bytes: bytes(room.f_blocks) }))
}

/// Returns the room on the disk of `path`, if the system reports it.
///
/// # Errors
/// None on this system.
#[cfg(not(unix))]
pub fn disk_room(_: &Path) -> Result<Option<DiskRoom>, Error> {
    Ok(None)
}

/// Writes a few bytes into a data folder and returns once they are on the disk. Waits as long as the disk hangs.
///
/// # Errors
/// If they cannot be written.
pub fn probe_disk(folder: &Path) -> Result<(), Error> {
    let path = folder.join(PROBE);
    let written = || {
        let mut file = private_files::options().write(true).create(true).truncate(true).open(&path)?;
        file.write_all(b"probe\n")?;
        file.sync_data()
    };
    written().map_err(|e| Error::io(&path, Doing::Write, e))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_disk_of_a_folder_has_room_and_takes_bytes() {
        let folder = tempfile::tempdir().unwrap();
        let room = disk_room(folder.path()).unwrap();
        assert!(room.is_none_or(|room| room.free_bytes <= room.total_bytes && room.total_bytes > 0), "{room:?}");
        probe_disk(folder.path()).unwrap();
        probe_disk(folder.path()).unwrap();
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(probe_disk(&folder.path().join("missing")).is_err());
    }
}
