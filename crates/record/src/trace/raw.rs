//! The raw file, written block by block and read up to where it is whole.

use super::column::Column;
use crate::error::{Doing, Error};
use crate::private_files;
use seamwright_message::Message;
use serde::{Deserialize, Serialize};
use std::fs::{File, TryLockError};
use std::io::{BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

const FILE_MARK: &[u8; 8] = b"SEAMTRC1";
const BLOCK_MARK: &[u8; 4] = b"BLCK";
/// Bytes of a block before its rows.
const BLOCK_HEAD: usize = 16;
/// Bytes of rows after which a block is written, regardless of the time.
const BLOCK_BYTES: usize = 1 << 17;
/// Maximum length of a header; longer ones are refused.
const MAX_HEADER: u32 = 1 << 24;
/// Rows are with the system no later than this after they came: the death of this process does not lose them.
const WRITE_EVERY: Duration = Duration::from_millis(100);
/// Rows are on the disk no later than this after they came.
const SYNC_EVERY: Duration = Duration::from_millis(500);

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Header {
    pub(super) columns: Vec<Column>,
    pub(super) about: Vec<(String, String)>,
}

impl Header {
    pub(super) fn row_bytes(&self) -> usize {
        self.columns.iter().map(|c| c.kind.bytes()).sum()
    }
}

/// Appends rows to a raw file, which it holds locked.
#[derive(Debug)]
pub(super) struct RawWriter {
    file: File,
    pub(super) path: PathBuf,
    columns: Vec<Column>,
    /// Head and rows of the block that is being filled.
    block: Vec<u8>,
    in_block: u32,
    pub(super) rows: u64,
    /// Of these, rows that could not be written.
    pub(super) lost: u64,
    /// Bytes of the file up to the end of its last whole block.
    whole: u64,
    synced: Instant,
    /// Time of the last block.
    written: Instant,
}

impl RawWriter {
    pub(super) fn create(path: &Path, header: &Header) -> Result<Self, Error> {
        let failed = |e| Error::io(path, Doing::Write, e);
        let file = private_files::options().write(true).create_new(true).open(path).map_err(|e| match e.kind() {
            std::io::ErrorKind::AlreadyExists => {
                Error::damaged(path, Message::new("record-trace-left"), Message::new("record-recover-first"))
            }
            _ => failed(e),
        })?;
        file.lock().map_err(failed)?;
        Self::on(file, path, header)
    }

    fn on(mut file: File, path: &Path, header: &Header) -> Result<Self, Error> {
        let failed = |e| Error::io(path, Doing::Write, e);
        let text = serde_json::to_vec(header).map_err(|e| failed(e.into()))?;
        let mut head = FILE_MARK.to_vec();
        head.extend_from_slice(&(text.len() as u32).to_le_bytes());
        head.extend_from_slice(&text);
        head.extend_from_slice(&crc32fast::hash(&text).to_le_bytes());
        file.write_all(&head).and_then(|()| file.sync_all()).map_err(failed)?;
        let row_bytes = header.row_bytes();
        let mut block = Vec::with_capacity(BLOCK_HEAD + BLOCK_BYTES + 2 * row_bytes + 4);
        block.resize(BLOCK_HEAD, 0);
        let columns = header.columns.clone();
        Ok(Self {
            file,
            path: path.to_owned(),
            columns,
            block,
            in_block: 0,
            rows: 0,
            lost: 0,
            whole: head.len() as u64,
            synced: Instant::now(),
            written: Instant::now(),
        })
    }

    pub(super) fn row(&mut self, values: impl IntoIterator<Item = f64>) -> Result<(), Error> {
        let begin = self.block.len();
        let mut count = 0;
        for (column, value) in self.columns.iter().zip(values) {
            column.kind.put(value, &mut self.block);
            count += 1;
        }
        if count != self.columns.len() {
            self.block.truncate(begin);
            let what = Message::new("record-row-length").text("path", self.path.display().to_string());
            let allowed = Message::new("record-value-per-column").count("n", self.columns.len());
            return Err(Error::wrong(what.count("n", count), allowed));
        }
        self.in_block += 1;
        if self.synced.elapsed() >= SYNC_EVERY {
            return self.flush();
        }
        let due = self.block.len() >= BLOCK_HEAD + BLOCK_BYTES || self.written.elapsed() >= WRITE_EVERY;
        if due { self.write_block() } else { Ok(()) }
    }

    /// Reserves room on the disk for so many rows; the length of the file stays.
    pub(super) fn reserve(&self, rows: u64) -> Result<(), Error> {
        let row_bytes: usize = self.columns.iter().map(|c| c.kind.bytes()).sum();
        // Blocks of few rows have their heads and checksums beside.
        let bytes = rows.saturating_mul(row_bytes as u64).saturating_mul(21) / 20;
        private_files::reserve(&self.file, self.whole, bytes).map_err(|e| Error::io(&self.path, Doing::Write, e))
    }

    /// Puts everything on the disk.
    pub(super) fn flush(&mut self) -> Result<(), Error> {
        self.write_block()?;
        self.synced = Instant::now();
        self.file.sync_data().map_err(|e| Error::io(&self.path, Doing::Write, e))?;
        self.check_there()
    }

    /// A file that was removed takes rows all the same, and is gone with its writer.
    fn check_there(&self) -> Result<(), Error> {
        match same_file(&self.file, &self.path) {
            Ok(true) => return Ok(()),
            Ok(false) => {}
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => {}
            Err(e) => return Err(Error::io(&self.path, Doing::Read, e)),
        }
        let why = Message::new("record-trace-replaced");
        Err(Error::damaged(&self.path, why, Message::new("record-folder-untouched")))
    }

    fn write_block(&mut self) -> Result<(), Error> {
        self.written = Instant::now();
        if self.in_block == 0 {
            return Ok(());
        }
        self.block[..4].copy_from_slice(BLOCK_MARK);
        self.block[4..8].copy_from_slice(&self.in_block.to_le_bytes());
        self.block[8..16].copy_from_slice(&self.rows.to_le_bytes());
        self.block.extend_from_slice(&crc32fast::hash(&self.block).to_le_bytes());
        let written = self.file.write_all(&self.block);
        let rows = u64::from(std::mem::take(&mut self.in_block));
        self.rows += rows;
        match &written {
            Ok(()) => self.whole += self.block.len() as u64,
            // Removes the incomplete block, so that later ones can be read; if that fails too they are lost.
            Err(_) => {
                self.lost += rows;
                let _ = self.file.set_len(self.whole).and_then(|()| self.file.seek(SeekFrom::Start(self.whole)));
            }
        }
        self.block.truncate(BLOCK_HEAD);
        written.map_err(|e| Error::io(&self.path, Doing::Write, e))
    }
}

#[cfg(unix)]
fn same_file(file: &File, path: &Path) -> std::io::Result<bool> {
    use std::os::unix::fs::MetadataExt as _;
    let (open, named) = (file.metadata()?, std::fs::metadata(path)?);
    Ok((open.dev(), open.ino()) == (named.dev(), named.ino()))
}

#[cfg(not(unix))]
fn same_file(_file: &File, path: &Path) -> std::io::Result<bool> {
    path.try_exists()
}

/// Closing alone does not free the file: a program that is being started by another thread has it open for a moment too.
impl Drop for RawWriter {
    fn drop(&mut self) {
        let _ = self.file.unlock();
    }
}

/// Reads a raw file block by block.
pub(super) struct RawReader {
    file: BufReader<File>,
    path: PathBuf,
    pub(super) header: Header,
    row_bytes: usize,
    rows: Vec<u8>,
    /// Number of the next row: rows read so far, and those between that could not be written.
    pub(super) next: u64,
    /// Bytes of the file that form no whole block.
    pub(super) left: u64,
    /// Bytes not yet read.
    ahead: u64,
}

impl RawReader {
    /// Opens a file that is not being written; `None` if it is.
    pub(super) fn open(path: &Path) -> Result<Option<Self>, Error> {
        let failed = |e| Error::io(path, Doing::Read, e);
        let file = File::open(path).map_err(failed)?;
        match file.try_lock_shared() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Ok(None),
            Err(TryLockError::Error(e)) => return Err(failed(e)),
        }
        let length = file.metadata().map_err(failed)?.len();
        let mut file = BufReader::with_capacity(1 << 16, file);
        let damaged =
            || Error::damaged(path, Message::new("record-no-raw-trace"), Message::new("record-own-raw-trace"));
        let mut fixed = [0; 12];
        file.read_exact(&mut fixed).map_err(|_| damaged())?;
        let [.., a, b, c, d] = fixed;
        let size = u32::from_le_bytes([a, b, c, d]);
        if &fixed[..8] != FILE_MARK || size > MAX_HEADER {
            return Err(damaged());
        }
        let mut text = vec![0; size as usize];
        let mut crc = [0; 4];
        file.read_exact(&mut text).and_then(|()| file.read_exact(&mut crc)).map_err(|_| damaged())?;
        if crc32fast::hash(&text) != u32::from_le_bytes(crc) {
            return Err(damaged());
        }
        let header: Header = serde_json::from_slice(&text).map_err(|_| damaged())?;
        // Rows without values could be of any number.
        if header.columns.is_empty() {
            return Err(damaged());
        }
        let (row_bytes, ahead) = (header.row_bytes(), length - 16 - u64::from(size));
        let path = path.to_owned();
        Ok(Some(Self { file, path, header, row_bytes, rows: Vec::new(), next: 0, left: 0, ahead }))
    }

    /// The rows of the next block, by bytes; `None` at the end, or at an incomplete block: [`RawReader::left`] then has
    /// the number of bytes.
    pub(super) fn block(&mut self) -> Result<Option<&[u8]>, Error> {
        if self.ahead == 0 {
            return Ok(None);
        }
        let failed = |e| Error::io(&self.path, Doing::Read, e);
        self.left = self.ahead;
        if self.ahead < (BLOCK_HEAD + 4) as u64 {
            return Ok(None);
        }
        let mut head = [0; BLOCK_HEAD];
        self.file.read_exact(&mut head).map_err(failed)?;
        let [_, _, _, _, a, b, c, d, first @ ..] = head;
        let (count, first) = (u32::from_le_bytes([a, b, c, d]), u64::from_le_bytes(first));
        let bytes = u64::from(count) * self.row_bytes as u64;
        if &head[..4] != BLOCK_MARK || first < self.next || bytes + 20 > self.ahead {
            return Ok(None);
        }
        self.rows.resize(bytes as usize, 0);
        let mut crc = [0; 4];
        self.file.read_exact(&mut self.rows).and_then(|()| self.file.read_exact(&mut crc)).map_err(failed)?;
        let mut hasher = crc32fast::Hasher::new();
        hasher.update(&head);
        hasher.update(&self.rows);
        if hasher.finalize() != u32::from_le_bytes(crc) {
            return Ok(None);
        }
        self.next = first + u64::from(count);
        self.ahead -= bytes + 20;
        self.left = 0;
        Ok(Some(&self.rows))
    }

    pub(super) fn row_bytes(&self) -> usize {
        self.row_bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::column::Kind;

    fn header() -> Header {
        let column = |name: &str, kind| Column::new(name, "1", kind);
        let columns =
            vec![column("t_s", Kind::F64), column("v", Kind::F32), column("n", Kind::U32), column("b", Kind::U8)];
        Header { columns, about: vec![("title".to_owned(), "a \"weld\"".to_owned())] }
    }

    /// A file of blocks of 10 rows; where each block ends.
    fn written(path: &Path, blocks: u32) -> Vec<u64> {
        let mut writer = RawWriter::create(path, &header()).unwrap();
        let ends = (0..blocks).map(|i| {
            (0..10).for_each(|k| writer.row([f64::from(10 * i + k), 0.5, f64::from(k), 3.0]).unwrap());
            writer.flush().unwrap();
            std::fs::metadata(path).unwrap().len()
        });
        ends.collect()
    }

    fn rows(path: &Path) -> (u64, u64) {
        let mut reader = RawReader::open(path).unwrap().unwrap();
        let mut next = 0.0;
        while let Some(rows) = reader.block().unwrap() {
            for row in rows.chunks(17) {
                assert_eq!(f64::from_le_bytes(row[..8].try_into().unwrap()).to_bits(), f64::to_bits(next));
                next += 1.0;
            }
        }
        (reader.next, reader.left)
    }

    #[test]
    fn cut_at_any_byte_all_whole_blocks_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let (whole, cut) = (folder.path().join("whole.raw"), folder.path().join("cut.raw"));
        let ends = written(&whole, 4);
        assert_eq!(rows(&whole), (40, 0));
        let bytes = std::fs::read(&whole).unwrap();
        let head = 16 + serde_json::to_vec(&header()).unwrap().len();
        for length in 0..bytes.len() {
            // A new file each: to cut an old one down makes some systems wait for the disk.
            let _ = std::fs::remove_file(&cut);
            std::fs::write(&cut, &bytes[..length]).unwrap();
            if length < head {
                assert!(RawReader::open(&cut).is_err());
                continue;
            }
            let blocks = ends.iter().filter(|e| **e <= length as u64).count();
            let kept = if blocks == 0 { head as u64 } else { ends[blocks - 1] };
            assert_eq!(rows(&cut), (10 * blocks as u64, length as u64 - kept), "{length}");
        }
    }

    #[test]
    fn a_changed_byte_is_found() {
        let folder = tempfile::tempdir().unwrap();
        let (whole, changed) = (folder.path().join("whole.raw"), folder.path().join("changed.raw"));
        let ends = written(&whole, 3);
        let bytes = std::fs::read(&whole).unwrap();
        let head = 16 + serde_json::to_vec(&header()).unwrap().len();
        for place in 0..bytes.len() {
            let mut bytes = bytes.clone();
            bytes[place] ^= 1 << (place % 8);
            let _ = std::fs::remove_file(&changed);
            std::fs::write(&changed, &bytes).unwrap();
            if place < head {
                assert!(RawReader::open(&changed).is_err(), "{place}");
            } else {
                let before = ends.iter().filter(|e| **e <= place as u64).count();
                assert_eq!(rows(&changed).0, 10 * before as u64, "{place}");
            }
        }
    }

    #[test]
    fn locked_while_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("trace.raw");
        let writer = RawWriter::create(&path, &header()).unwrap();
        assert!(RawReader::open(&path).unwrap().is_none());
        let told = RawWriter::create(&path, &header()).unwrap_err().to_string();
        assert!(told.contains("records recover"), "{told}");
        // A handle as a child process inherits it.
        let _inherited = writer.file.try_clone().unwrap();
        drop(writer);
        assert!(RawReader::open(&path).unwrap().is_some());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_told() {
        // Every write to this device fails with a full disk.
        let file = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let error = RawWriter::on(file, Path::new("trace.raw"), &header()).unwrap_err();
        assert!(matches!(error, Error::Full { .. }) && !error.is_input(), "{error}");
        assert!(error.to_string().contains("the disk is full"), "{error}");
    }

    #[test]
    fn a_row_of_wrong_length_is_refused_and_changes_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("trace.raw");
        let mut writer = RawWriter::create(&path, &header()).unwrap();
        assert!(writer.row([1.0, 2.0]).is_err());
        writer.row([0.0; 4]).unwrap();
        writer.flush().unwrap();
        drop(writer);
        assert_eq!(rows(&path), (1, 0));
    }
}
