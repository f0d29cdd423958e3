//! Files of a data folder: archives of a backup, the library inside, traces.

use crate::scratch::{folder, write};
use crate::target::{Target, USUAL};
use crate::texts::describe;
use seamwright_record::library::{AuditEntry, DocumentKind, Query};
use seamwright_record::trace::{Column, Kind, Outline, Trace, TraceWriter, recover};
use seamwright_record::{DataFolder, Moment, check_archive, sha256};
use serde_json::Value;
use std::fs;
use std::path::Path;

const FILE: Target = Target { is_text: false, max_length: 64 << 10, cases: 60, ..USUAL };

/// Archives of a backup; the checksums of entries are set first.
pub const ARCHIVE: Target = Target {
    name: "archive",
    read: |bytes| restored(&with_header_checksums(bytes)),
    seeds: || {
        vec![backup(true), backup(false), archive_of(&[("jobs/a.toml", b"title = \"a\""), ("users.json", b"[]")])]
    },
    words: || {
        ["library.sqlite", "manifest.sha256", "welds/", "jobs/", "users.json", "../", "ustar", "/"]
            .map(str::to_owned)
            .to_vec()
    },
    max_length: 256 << 10,
    ..FILE
};

/// The library in an archive with the right manifest.
pub const LIBRARY: Target = Target {
    name: "library",
    read: |bytes| restored(&archive_of(&[("library.sqlite", bytes)])),
    seeds: || vec![library()],
    words: || {
        ["CREATE TABLE ", "CREATE TRIGGER ", "audit", "welds", "documents", "SELECT ", "sqlite_"]
            .map(str::to_owned)
            .to_vec()
    },
    max_length: 256 << 10,
    ..FILE
};

/// Traces in Parquet files.
pub const TRACE: Target = Target {
    name: "trace",
    read: trace,
    seeds: || vec![traces(false)],
    words: || ["PAR1", "trace", "unit:", "t_s"].map(str::to_owned).to_vec(),
    ..FILE
};

/// Raw traces, as a crash leaves them; checksums are set first.
pub const RAW_TRACE: Target = Target {
    name: "raw_trace",
    read: |bytes| raw_trace(&with_checksums(bytes)),
    seeds: || vec![traces(true)],
    words: || {
        [
            "SEAMTRC1",
            "BLCK",
            "{\"columns\":[",
            "],\"about\":[]}",
            "{\"name\":\"a\",\"unit\":\"1\",\"kind\":\"f64\"}",
            "f32",
            "u32",
            "u8",
        ]
        .map(str::to_owned)
        .to_vec()
    },
    ..FILE
};

/// Checks an archive as the panel does, then reads what it restored.
fn restored(archive: &[u8]) {
    let folder = folder("restore");
    let (path, data) = (folder.join("upload.tar"), folder.join("data"));
    fs::create_dir_all(&data).unwrap_or_else(|e| panic!("{e}"));
    write(&path, archive);
    match check_archive(&path, &data) {
        Ok((contents, new)) => {
            let data = DataFolder::open_to_read(&new).unwrap_or_else(|e| panic!("checked, and cannot be opened: {e}"));
            let welds = data.library().find(&Query::default()).unwrap_or_else(|e| panic!("{contents:?}: {e}"));
            assert_eq!(welds.len(), contents.welds);
            describe(data.library().audit_entries(100));
        }
        Err(error) => describe::<(), _>(Err(error)),
    }
    assert!(!folder.join("outside").exists(), "a file outside of the folder");
    let left = fs::read_dir(&folder).map_or(0, Iterator::count);
    assert_eq!(left, 2, "files beside the data");
}

/// A tar archive of these files with their manifest.
fn archive_of(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut tar = tar::Builder::new(Vec::new());
    let mut manifest = String::new();
    let mut add = |name: &str, bytes: &[u8]| {
        let mut header = tar::Header::new_gnu();
        header.set_size(bytes.len() as u64);
        header.set_mode(0o600);
        tar.append_data(&mut header, name, bytes).unwrap_or_else(|e| panic!("{e}"));
    };
    for (name, bytes) in files {
        add(name, bytes);
        manifest += &format!("{}  {name}\n", sha256(bytes));
    }
    add("manifest.sha256", manifest.as_bytes());
    tar.into_inner().unwrap_or_else(|e| panic!("{e}"))
}

/// Bytes of a block of a tar archive.
const BLOCK: usize = 512;

/// The same archive with the checksum of every entry set.
fn with_header_checksums(bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let mut at = 0;
    while let Some(header) = bytes.get_mut(at..at + BLOCK) {
        if header.iter().all(|byte| *byte == 0) {
            break;
        }
        header[148..156].fill(b' ');
        let sum: u32 = header.iter().copied().map(u32::from).sum();
        header[148..156].copy_from_slice(format!("{sum:06o}\0 ").as_bytes());
        let size =
            std::str::from_utf8(&header[124..135]).ok().and_then(|text| usize::from_str_radix(text.trim(), 8).ok());
        at = at.saturating_add(BLOCK).saturating_add(size.unwrap_or(0).next_multiple_of(BLOCK));
    }
    bytes
}

/// A data folder with an entry of everything that a short archive has.
fn filled(path: &Path) -> DataFolder {
    let _ = fs::remove_dir_all(path);
    let mut data = DataFolder::open(path).unwrap_or_else(|e| panic!("{e}"));
    let text = str::to_owned;
    let entry = AuditEntry {
        at: Moment(5),
        user: text("ada"),
        station: text("panel"),
        command: text("arm"),
        old: text(""),
        new: text(""),
        result: text("taken"),
    };
    let library = data.library_mut();
    library.add_document(DocumentKind::Job, "job.toml", "text").unwrap_or_else(|e| panic!("{e}"));
    library.audit(&entry).unwrap_or_else(|e| panic!("{e}"));
    fs::create_dir_all(path.join("jobs"))
        .and_then(|()| fs::write(path.join("jobs/a.toml"), "a"))
        .unwrap_or_else(|e| panic!("{e}"));
    fs::write(path.join("users.json"), "[]").unwrap_or_else(|e| panic!("{e}"));
    data
}

fn backup(with_users: bool) -> Vec<u8> {
    let mut archive = Vec::new();
    let data = filled(&folder("seeds").join("backup"));
    let written = if with_users { data.back_up(&mut archive) } else { data.back_up_without_users(&mut archive) };
    written.unwrap_or_else(|e| panic!("{e}"));
    archive
}

/// The library of a backup.
fn library() -> Vec<u8> {
    let archive = backup(true);
    let mut archive = tar::Archive::new(&archive[..]);
    for entry in archive.entries().into_iter().flatten().flatten() {
        let mut entry = entry;
        if entry.path_bytes().as_ref() == b"library.sqlite" {
            let mut bytes = Vec::new();
            std::io::copy(&mut entry, &mut bytes).unwrap_or_else(|e| panic!("{e}"));
            return bytes;
        }
    }
    panic!("a backup without a library")
}

fn trace(bytes: &[u8]) {
    let path = folder("trace").join("trace.parquet");
    write(&path, bytes);
    match Trace::open(&path) {
        Ok(trace) => {
            let names: Vec<&str> = trace.columns().iter().map(|column| column.name.as_str()).collect();
            let mut outline = Outline::new(names.len(), trace.rows(), 100);
            describe(trace.read(&names, |row| outline.row(row)));
            drop(outline.finish());
        }
        Err(error) => describe::<(), _>(Err(error)),
    }
}

fn raw_trace(bytes: &[u8]) {
    let folder = folder("raw");
    fs::read_dir(&folder).into_iter().flatten().flatten().for_each(|entry| drop(fs::remove_file(entry.path())));
    write(&folder.join("trace.raw"), bytes);
    match recover(&folder) {
        Ok(parts) => {
            for part in parts.iter().filter(|part| part.rows > 0) {
                let trace = Trace::open(&part.path).unwrap_or_else(|e| panic!("recovered, and cannot be opened: {e}"));
                assert_eq!(trace.rows(), part.rows);
            }
        }
        Err(error) => describe::<(), _>(Err(error)),
    }
}

/// The same raw trace with the checksums of its header and its whole blocks set.
fn with_checksums(bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let word = |bytes: &[u8], at: usize| Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?) as usize);
    let set = |bytes: &mut [u8], from: usize, to: usize| {
        let checksum = crc32fast::hash(bytes.get(from..to)?).to_le_bytes();
        bytes.get_mut(to..to + 4)?.copy_from_slice(&checksum);
        Some(to + 4)
    };
    let Some(mut at) = word(&bytes, 8).and_then(|size| set(&mut bytes, 12, 12 + size)) else { return bytes };
    let header: Value = serde_json::from_slice(&bytes[12..at - 4]).unwrap_or_default();
    let width = |column: &Value| match column["kind"].as_str() {
        Some("f64") => 8,
        Some("u8") => 1,
        _ => 4,
    };
    let row: usize = header["columns"].as_array().into_iter().flatten().map(width).sum();
    while let Some(count) = word(&bytes, at + 4) {
        match count.checked_mul(row).and_then(|rows| set(&mut bytes, at, at + 16 + rows)) {
            Some(end) => at = end,
            None => break,
        }
    }
    bytes
}

/// A short trace: its raw file, or the Parquet file.
fn traces(raw: bool) -> Vec<u8> {
    let folder = folder("seeds").join("trace");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap_or_else(|e| panic!("{e}"));
    let path = folder.join("trace.parquet");
    let column = |name: &str, kind| Column::new(name, "1", kind);
    let columns = [column("t_s", Kind::F64), column("v", Kind::F32), column("n", Kind::U32), column("mode", Kind::U8)];
    let mut writer =
        TraceWriter::create(&path, &columns, &[("title", "a weld".to_owned())], 1000).unwrap_or_else(|e| panic!("{e}"));
    for i in 0..20u8 {
        let v = f64::from(i);
        writer.row([0.001 * v, v * v, v, v % 3.0]).and_then(|()| writer.flush()).unwrap_or_else(|e| panic!("{e}"));
    }
    if raw {
        return fs::read(path.with_extension("raw")).unwrap_or_else(|e| panic!("{e}"));
    }
    writer.finish().unwrap_or_else(|e| panic!("{e}"));
    fs::read(&path).unwrap_or_else(|e| panic!("{e}"))
}
