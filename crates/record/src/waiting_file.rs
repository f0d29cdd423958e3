//! Bounded file of entries that the library does not take: disk full, database locked.
//!
//! Its room is written beforehand, so that a full disk does not refuse an entry. One after another, little-endian:
//!
//! | bytes | |
//! |---|---|
//! | 4 | length of the entry; 0: end |
//! | 4 | CRC-32 of the entry |
//! | n | the entry |
//!
//! An entry torn by a crash ends the list.

use crate::error::{Doing, Error};
use crate::library::PendingEntry;
use crate::private_files;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Name of the file in the data folder.
pub(crate) const NAME: &str = "audit.waiting";
/// Bytes of the file.
const ROOM: usize = 4 << 20;
/// Bytes before an entry.
const HEAD: usize = 8;

/// Entries that wait for the library, on the disk. One program has it open at a time.
#[derive(Debug)]
pub struct WaitingFile {
    path: PathBuf,
    file: File,
    /// Bytes of the file.
    room: usize,
    /// End of the last entry.
    end: usize,
}

impl WaitingFile {
    /// Opens the file of `folder`, made if missing. Returns it with the entries that an earlier run left.
    ///
    /// # Errors
    /// If it cannot be read or written, or another program has it open ([`Error::Busy`]).
    pub fn open(folder: &Path) -> Result<(Self, Vec<PendingEntry>), Error> {
        Self::with_room(folder, ROOM)
    }

    fn with_room(folder: &Path, room: usize) -> Result<(Self, Vec<PendingEntry>), Error> {
        let path = folder.join(NAME);
        let failed = |e| Error::io(&path, Doing::Create, e);
        let options = &mut private_files::options();
        let mut file = options.read(true).write(true).create(true).truncate(false).open(&path).map_err(failed)?;
        if file.try_lock().is_err() {
            return Err(Error::Busy { path });
        }
        let mut bytes = Vec::new();
        Read::by_ref(&mut file)
            .take(room as u64)
            .read_to_end(&mut bytes)
            .map_err(|e| Error::io(&path, Doing::Read, e))?;
        let mut waiting = Self { path, file, room, end: 0 };
        let entries = waiting.entries(&bytes);
        if bytes.len() < room {
            // Without its room on the disk entries are still written, as long as there is some.
            drop(waiting.reserve(bytes.len()));
        }
        Ok((waiting, entries))
    }

    /// Reads the entries up to the end or the first damaged one.
    fn entries(&mut self, bytes: &[u8]) -> Vec<PendingEntry> {
        let mut entries = Vec::new();
        while let Some(head) = bytes.get(self.end..self.end + HEAD) {
            let number = |at: usize| u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]);
            let (length, crc) = (number(0) as usize, number(4));
            let Some(entry) = bytes.get(self.end + HEAD..self.end + HEAD + length) else { break };
            if length == 0 || crc32fast::hash(entry) != crc {
                break;
            }
            // An entry of a later version is passed over.
            entries.extend(PendingEntry::from_bytes(entry));
            self.end += HEAD + length;
        }
        entries
    }

    /// Writes zeros from `from` to the end of the room.
    fn reserve(&mut self, from: usize) -> std::io::Result<()> {
        self.file.seek(SeekFrom::Start(from as u64))?;
        let zeros = vec![0; 1 << 16];
        let mut left = self.room - from;
        while left > 0 {
            let n = left.min(zeros.len());
            self.file.write_all(&zeros[..n])?;
            left -= n;
        }
        self.file.sync_data()
    }

    /// Appends the first entries that fit, and syncs. Returns their number.
    ///
    /// # Errors
    /// If the disk fails: none of them counts as written.
    pub fn append(&mut self, entries: &[PendingEntry]) -> Result<usize, Error> {
        let (mut bytes, mut count) = (Vec::new(), 0);
        for entry in entries {
            let entry = entry.to_bytes();
            // The mark of the end follows.
            if self.end + bytes.len() + HEAD + entry.len() + HEAD > self.room {
                break;
            }
            bytes.extend_from_slice(&(entry.len() as u32).to_le_bytes());
            bytes.extend_from_slice(&crc32fast::hash(&entry).to_le_bytes());
            bytes.extend_from_slice(&entry);
            count += 1;
        }
        if count > 0 {
            let end = self.end + bytes.len();
            bytes.extend_from_slice(&[0; HEAD]);
            self.write(self.end, &bytes)?;
            self.end = end;
        }
        Ok(count)
    }

    /// Removes all entries: the library has them.
    ///
    /// # Errors
    /// If the disk fails.
    pub fn clear(&mut self) -> Result<(), Error> {
        if self.end > 0 {
            self.write(0, &[0; HEAD])?;
            self.end = 0;
        }
        Ok(())
    }

    /// Returns true without entries.
    pub fn is_empty(&self) -> bool {
        self.end == 0
    }

    fn write(&mut self, at: usize, bytes: &[u8]) -> Result<(), Error> {
        let mut write = || {
            self.file.seek(SeekFrom::Start(at as u64))?;
            self.file.write_all(bytes)?;
            self.file.sync_data()
        };
        write().map_err(|e| Error::io(&self.path, Doing::Write, e))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::AuditEntry;
    use crate::moment::Moment;

    fn order(n: i64) -> PendingEntry {
        let text = |t: &str| t.to_owned();
        let (user, station, old, new, result) = (text("ada"), text("panel"), text(""), text(""), text("accepted"));
        PendingEntry::Audit(AuditEntry { at: Moment(n), user, station, command: format!("{n}"), old, new, result })
    }

    const SMALL: usize = 4096;

    fn open(folder: &Path) -> Result<(WaitingFile, Vec<PendingEntry>), Error> {
        WaitingFile::with_room(folder, SMALL)
    }

    /// Cut or damaged at any byte, the file has a beginning of what was written.
    #[test]
    fn a_torn_file_has_the_entries_before() {
        let folder = tempfile::tempdir().unwrap();
        let entries = [order(1), order(2), order(3)];
        let (mut waiting, before) = open(folder.path()).unwrap();
        assert!(before.is_empty() && waiting.is_empty());
        assert!(matches!(open(folder.path()), Err(Error::Busy { .. })));
        assert_eq!(waiting.append(&entries[..2]).unwrap(), 2);
        assert_eq!(waiting.append(&entries[2..]).unwrap(), 1);
        let (end, path) = (waiting.end, folder.path().join(NAME));
        drop(waiting);
        let whole = std::fs::read(&path).unwrap();
        assert_eq!(whole.len(), SMALL);
        let ends: Vec<usize> = (0..=3).map(|n| end / 3 * n).collect();
        for at in 0..end {
            let mut torn = whole.clone();
            torn[at] ^= 0x40;
            std::fs::write(&path, &torn).unwrap();
            let (_, found) = open(folder.path()).unwrap();
            let kept = ends.iter().rposition(|end| *end <= at).unwrap();
            assert_eq!(found, entries[..kept], "{at}");
            std::fs::write(&path, &whole[..at]).unwrap();
            assert_eq!(open(folder.path()).unwrap().1, entries[..kept], "cut at {at}");
        }
    }

    #[test]
    fn its_room_is_bounded_and_used_again() {
        let folder = tempfile::tempdir().unwrap();
        let (mut waiting, _) = open(folder.path()).unwrap();
        let entries: Vec<PendingEntry> = (0..100).map(order).collect();
        let written = waiting.append(&entries).unwrap();
        assert!(written > 10 && written < entries.len(), "{written}");
        assert_eq!(waiting.append(&entries).unwrap(), 0);
        drop(waiting);
        let (mut waiting, found) = open(folder.path()).unwrap();
        assert_eq!(found, entries[..written]);
        waiting.clear().unwrap();
        assert_eq!(waiting.append(&entries[..1]).unwrap(), 1);
        drop(waiting);
        assert_eq!(open(folder.path()).unwrap().1, entries[..1]);
        assert_eq!(std::fs::metadata(folder.path().join(NAME)).unwrap().len(), SMALL as u64);
    }
}
