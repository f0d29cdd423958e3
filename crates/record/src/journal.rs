//! Journal of the weld's position, for a power failure.
//!
//! Two files of one disk block each are written by turns, in place, and synced. If writing one of them fails, the other
//! has the entry before. They never grow.
//!
//! | bytes | an entry, little-endian |
//! |---|---|
//! | 8 | `SEAMJRN1` |
//! | 8 | sequence number |
//! | 8 | weld; 0: the weld before ended well |
//! | 4, 1, 3 | pass; phase; nothing |
//! | 8, 8, 8 | time (s since 1970), s (mm), welded to (mm) |
//! | 32 | corrections (mm): of each head lateral, height |
//! | 4 | CRC-32 of all this |

use crate::error::{Doing, Error};
use crate::{private_files, whole_file};
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

const MARK: &[u8; 8] = b"SEAMJRN1";
/// Bytes of an entry with its checksum.
const ENTRY: usize = 92;
/// Bytes of a file: the size that a disk writes at once.
const BLOCK: usize = 4096;
const NAMES: [&str; 2] = ["position.a", "position.b"];

/// Position of a weld.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Position {
    /// Time, s since 1970 UTC.
    pub time: f64,
    /// Number of the weld in the library; not 0.
    pub weld: u64,
    /// The pass, counted from 1; 0 in the air.
    pub pass: u32,
    /// Phase of the process, as the executive counts it.
    pub phase: u8,
    /// Position of the torch by path length, mm.
    pub s: f64,
    /// The weld is good up to here, mm.
    pub welded_to: f64,
    /// Corrections of the two heads, lateral and height, mm.
    pub corrections: [[f64; 2]; 2],
}

/// State of a journal.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct JournalState {
    /// See [`Journal::last`].
    pub last: Option<Position>,
    /// See [`Journal::is_damaged`].
    pub damaged: bool,
}

/// The newest entry of some files.
#[derive(Default)]
struct Newest {
    sequence: u64,
    state: JournalState,
}

impl Newest {
    fn of(files: &mut [(PathBuf, File)]) -> Result<Self, Error> {
        let mut newest = Self::default();
        let (mut whole, mut written) = (false, false);
        for (path, file) in files {
            let failed = |e| Error::io(path, Doing::Read, e);
            let entry = read(file).map_err(failed)?;
            whole |= entry.is_some();
            written |= !is_blank(file).map_err(failed)?;
            if let Some((sequence, last)) = entry.filter(|entry| entry.0 > newest.sequence) {
                (newest.sequence, newest.state.last) = (sequence, last);
            }
        }
        newest.state.damaged = written && !whole;
        Ok(newest)
    }
}

/// Keeps the newest position on the disk.
///
/// One thread writes, at most every 50 ms; each call returns when the disk has the entry.
#[derive(Debug)]
pub struct Journal {
    files: [(PathBuf, File); 2],
    /// Number of the newest entry.
    sequence: u64,
    last: Option<Position>,
    /// Neither file has a whole entry, but at least one has data: the newest entry is unknown.
    damaged: bool,
}

impl Journal {
    /// The journal in `folder`, made if missing.
    ///
    /// # Errors
    /// If its files cannot be read or written, or another program writes them.
    pub fn open(folder: &Path) -> Result<Self, Error> {
        let [a, b] = NAMES.map(|name| open(&folder.join(name)));
        let mut files = [a?, b?];
        let newest = Newest::of(&mut files)?;
        let Newest { sequence, state: JournalState { last, damaged } } = newest;
        Ok(Self { files, sequence, last, damaged })
    }

    /// The state of the journal in `folder`, also while another program writes it; empty if it is missing.
    ///
    /// # Errors
    /// If its files cannot be read.
    pub fn look(folder: &Path) -> Result<JournalState, Error> {
        let mut files = Vec::new();
        for path in NAMES.map(|name| folder.join(name)) {
            match File::open(&path) {
                Ok(file) => files.push((path, file)),
                Err(e) if e.kind() == std::io::ErrorKind::NotFound => {}
                Err(e) => return Err(Error::io(&path, Doing::Read, e)),
            }
        }
        Ok(Newest::of(&mut files)?.state)
    }

    /// True if both files are damaged: a weld may have been left, and where is not known. The next entry ends that.
    pub fn is_damaged(&self) -> bool {
        self.damaged
    }

    /// The newest whole entry; `None` if the weld before ended well, or there was no weld.
    pub fn last(&self) -> Option<Position> {
        self.last
    }

    /// Puts `position` on the disk.
    ///
    /// # Errors
    /// If it cannot be written; the entry before is still there.
    pub fn write(&mut self, position: &Position) -> Result<(), Error> {
        self.put(Some(*position))
    }

    /// Clears the journal: the weld ended well.
    pub fn clear(&mut self) -> Result<(), Error> {
        self.put(None)
    }

    fn put(&mut self, position: Option<Position>) -> Result<(), Error> {
        let sequence = self.sequence + 1;
        let (path, file) = &mut self.files[(sequence % 2) as usize];
        let written = file
            .seek(SeekFrom::Start(0))
            .and_then(|_| file.write_all(&encoded(sequence, position)))
            .and_then(|()| file.sync_data());
        written.map_err(|e| Error::io(path, Doing::Write, e))?;
        (self.sequence, self.last, self.damaged) = (sequence, position, false);
        Ok(())
    }
}

/// Closing alone does not free the files: a program that is being started by another thread has them open for a moment too.
impl Drop for Journal {
    fn drop(&mut self) {
        for (_, file) in &self.files {
            let _ = file.unlock();
        }
    }
}

/// Opens a file of full length, which it locks.
fn open(path: &Path) -> Result<(PathBuf, File), Error> {
    let failed = |e| Error::io(path, Doing::Write, e);
    let mut options = private_files::options();
    let mut file = options.read(true).write(true).create(true).truncate(false).open(path).map_err(failed)?;
    if file.try_lock().is_err() {
        return Err(Error::Busy { path: path.to_owned() });
    }
    let length = file.metadata().map_err(failed)?.len();
    if length != BLOCK as u64 {
        // Allocates the bytes on the disk, so that later writes need no space and change no lengths.
        let missing = BLOCK.saturating_sub(length as usize);
        let filled = file.seek(SeekFrom::End(0)).and_then(|_| file.write_all(&vec![0; missing]));
        filled.and_then(|()| file.set_len(BLOCK as u64)).and_then(|()| file.sync_all()).map_err(failed)?;
        whole_file::sync_folder(path)?;
    }
    Ok((path.to_owned(), file))
}

fn encoded(sequence: u64, position: Option<Position>) -> [u8; ENTRY] {
    let none = Position { time: 0.0, weld: 0, pass: 0, phase: 0, s: 0.0, welded_to: 0.0, corrections: [[0.0; 2]; 2] };
    let p = position.unwrap_or(none);
    let mut bytes = [0; ENTRY];
    bytes[..8].copy_from_slice(MARK);
    bytes[8..16].copy_from_slice(&sequence.to_le_bytes());
    bytes[16..24].copy_from_slice(&p.weld.to_le_bytes());
    bytes[24..28].copy_from_slice(&p.pass.to_le_bytes());
    bytes[28] = p.phase;
    let [[a, b], [c, d]] = p.corrections;
    for (place, value) in bytes[32..88].chunks_exact_mut(8).zip([p.time, p.s, p.welded_to, a, b, c, d]) {
        place.copy_from_slice(&value.to_le_bytes());
    }
    let crc = crc32fast::hash(&bytes[..88]);
    bytes[88..].copy_from_slice(&crc.to_le_bytes());
    bytes
}

/// Number and position of the entry in a file; `None` if it is not whole.
fn read(file: &mut File) -> std::io::Result<Option<(u64, Option<Position>)>> {
    let mut bytes = [0; ENTRY];
    file.seek(SeekFrom::Start(0))?;
    match file.read_exact(&mut bytes) {
        Err(e) if e.kind() == std::io::ErrorKind::UnexpectedEof => return Ok(None),
        result => result?,
    }
    Ok(decoded(&bytes))
}

fn is_blank(file: &mut File) -> std::io::Result<bool> {
    let mut bytes = Vec::with_capacity(BLOCK);
    file.seek(SeekFrom::Start(0))?;
    file.take(BLOCK as u64).read_to_end(&mut bytes)?;
    Ok(bytes.iter().all(|byte| *byte == 0))
}

fn decoded(bytes: &[u8; ENTRY]) -> Option<(u64, Option<Position>)> {
    let eight = |at: usize| <[u8; 8]>::try_from(&bytes[at..at + 8]).ok();
    let four = |at: usize| <[u8; 4]>::try_from(&bytes[at..at + 4]).ok();
    let number = |at: usize| eight(at).map(f64::from_le_bytes);
    if &bytes[..8] != MARK || crc32fast::hash(&bytes[..88]) != u32::from_le_bytes(four(88)?) {
        return None;
    }
    let weld = u64::from_le_bytes(eight(16)?);
    let position = Position {
        time: number(32)?,
        weld,
        pass: u32::from_le_bytes(four(24)?),
        phase: bytes[28],
        s: number(40)?,
        welded_to: number(48)?,
        corrections: [[number(56)?, number(64)?], [number(72)?, number(80)?]],
    };
    Some((u64::from_le_bytes(eight(8)?), (weld != 0).then_some(position)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::fs;

    fn position(i: u32) -> Position {
        let x = f64::from(i);
        Position {
            time: 1.8e9 + x,
            weld: 7,
            pass: i % 5 + 1,
            phase: (i % 9) as u8,
            s: 0.5 * x,
            welded_to: 0.5 * x - 1.0,
            corrections: [[0.1 * x, -x], [x, 1e-3]],
        }
    }

    /// A journal with entries 1 to `n`, and the files' bytes.
    fn written(folder: &Path, n: u32) -> [Vec<u8>; 2] {
        let mut journal = Journal::open(folder).unwrap();
        (1..=n).for_each(|i| journal.write(&position(i)).unwrap());
        NAMES.map(|name| fs::read(folder.join(name)).unwrap())
    }

    /// A new file: to cut an old one down and fill it again makes some systems wait for the disk.
    fn put(path: &Path, bytes: &[u8]) {
        let _ = fs::remove_file(path);
        fs::write(path, bytes).unwrap();
    }

    fn last(folder: &Path) -> Option<Position> {
        Journal::open(folder).unwrap().last()
    }

    #[test]
    fn goes_on_after_a_restart_and_never_grows() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(last(folder.path()), None);
        for n in 1..40 {
            Journal::open(folder.path()).unwrap().write(&position(n)).unwrap();
            assert_eq!(last(folder.path()), Some(position(n)));
        }
        Journal::open(folder.path()).unwrap().clear().unwrap();
        assert_eq!(last(folder.path()), None);
        Journal::open(folder.path()).unwrap().write(&position(3)).unwrap();
        assert_eq!(last(folder.path()), Some(position(3)));
        let sizes = NAMES.map(|name| fs::metadata(folder.path().join(name)).unwrap().len());
        assert_eq!(sizes, [BLOCK as u64; 2]);
    }

    #[test]
    fn one_writer() {
        let folder = tempfile::tempdir().unwrap();
        let first = Journal::open(folder.path()).unwrap();
        assert!(matches!(Journal::open(folder.path()), Err(Error::Busy { .. })));
        // Handles as a child process inherits them.
        let _inherited: Vec<_> = first.files.iter().map(|(_, file)| file.try_clone().unwrap()).collect();
        drop(first);
        assert!(Journal::open(folder.path()).is_ok());
    }

    /// Entry `n` torn after every byte: its start over the entry two before, or its end alone.
    #[test]
    fn torn_at_every_byte_the_newest_or_the_one_before() {
        let folder = tempfile::tempdir().unwrap();
        for n in [1, 2, 7, 8] {
            let before = written(folder.path(), n - 1);
            let mut now = Journal::open(folder.path()).unwrap();
            now.write(&position(n)).unwrap();
            drop(now);
            let slot = (last_sequence(folder.path()) % 2) as usize;
            let path = folder.path().join(NAMES[slot]);
            let after = fs::read(&path).unwrap();
            let older = Some(n - 1).filter(|i| *i > 0).map(position);
            for cut in 0..=ENTRY {
                for (a, b) in [(&after, &before[slot]), (&before[slot], &after)] {
                    put(&path, &[&a[..cut], &b[cut..]].concat());
                    let found = last(folder.path());
                    assert!(found == Some(position(n)) || found == older, "{n} {cut}: {found:?}");
                }
            }
            NAMES.iter().for_each(|name| fs::remove_file(folder.path().join(name)).unwrap());
        }
    }

    fn last_sequence(folder: &Path) -> u64 {
        Journal::open(folder).unwrap().sequence
    }

    /// Either file cut off or changed anywhere.
    #[test]
    fn damaged_at_every_byte_the_newest_or_the_one_before() {
        let folder = tempfile::tempdir().unwrap();
        for n in [2, 9] {
            let whole = written(folder.path(), n);
            for slot in 0..2 {
                let path = folder.path().join(NAMES[slot]);
                for at in (0..ENTRY + 8).chain([512, 4095]) {
                    let mut changed = whole[slot].clone();
                    changed[at] ^= 1 << (at % 8);
                    for bytes in [&changed, &whole[slot][..at].to_vec()] {
                        put(&path, bytes);
                        let found = last(folder.path());
                        assert!(found == Some(position(n)) || found == Some(position(n - 1)), "{n} {at}: {found:?}");
                    }
                }
                put(&path, &whole[slot]);
            }
            NAMES.iter().for_each(|name| fs::remove_file(folder.path().join(name)).unwrap());
        }
    }

    /// Damage of both files is reported until an entry is written. It differs from a journal with one damaged file, or
    /// without an entry.
    #[test]
    fn both_files_damaged_are_told() {
        let folder = tempfile::tempdir().unwrap();
        assert!(!Journal::open(folder.path()).unwrap().is_damaged());
        let whole = written(folder.path(), 5);
        let [a, b] = NAMES.map(|name| folder.path().join(name));
        let mut torn = whole.clone();
        torn.iter_mut().for_each(|bytes| bytes[40] ^= 4);
        put(&a, &torn[0]);
        assert!(!Journal::open(folder.path()).unwrap().is_damaged());
        put(&b, &torn[1]);
        let mut journal = Journal::open(folder.path()).unwrap();
        assert!(journal.is_damaged() && journal.last().is_none());
        journal.clear().unwrap();
        assert!(!journal.is_damaged());
        drop(journal);
        assert!(!Journal::open(folder.path()).unwrap().is_damaged());
    }

    proptest! {
        #[test]
        fn garbage_is_no_entry(bytes in proptest::collection::vec(any::<u8>(), ENTRY)) {
            let bytes: [u8; ENTRY] = bytes.try_into().unwrap();
            prop_assert!(decoded(&bytes).is_none());
        }

        #[test]
        fn entries_there_and_back(sequence in 1..u64::MAX, i in any::<u32>()) {
            prop_assert_eq!(decoded(&encoded(sequence, Some(position(i)))), Some((sequence, Some(position(i)))));
            prop_assert_eq!(decoded(&encoded(sequence, None)), Some((sequence, None)));
        }
    }
}
