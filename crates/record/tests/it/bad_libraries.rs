//! Libraries that fail to open or to be written: clear messages, no changes.

use crate::common::{WeldResult, empty, outcome, plan, row};
use seamwright_record::library::{DocumentKind, Library, Query};
use seamwright_record::{DataFolder, Error};
use std::fs;
use std::path::Path;

fn recorded() -> tempfile::TempDir {
    let (folder, mut data) = empty();
    let mut recording = data.begin(&plan("P-1")).unwrap();
    (0..2000).for_each(|i| recording.row(row(i)));
    recording.finish(&mut data, &outcome(WeldResult::Good)).unwrap();
    folder
}

fn sql(folder: &Path, sql: &str) {
    rusqlite::Connection::open(folder.join("library.sqlite")).unwrap().execute_batch(sql).unwrap();
}

#[test]
fn a_later_version_is_refused_and_left_alone() {
    let folder = recorded();
    sql(folder.path(), "PRAGMA user_version = 99");
    for error in [DataFolder::open(folder.path()).unwrap_err(), DataFolder::open_to_read(folder.path()).unwrap_err()] {
        assert!(matches!(error, Error::Newer { found: 99, .. }) && error.is_input(), "{error}");
        let told = error.to_string();
        assert!(told.contains("library.sqlite") && told.contains("schema 99"), "{told}");
    }
    sql(folder.path(), "PRAGMA user_version = 4");
    assert_eq!(DataFolder::open(folder.path()).unwrap().library().find(&Query::default()).unwrap().len(), 1);
}

#[test]
fn another_database_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    sql(folder.path(), "CREATE TABLE songs (title TEXT)");
    let told = DataFolder::open(folder.path()).unwrap_err().to_string();
    assert!(told.contains("not a library of Seamwright") && told.contains("another data folder"), "{told}");
}

#[test]
fn no_database_at_all() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("library.sqlite"), "this is a text, and not a short one. ".repeat(40)).unwrap();
    let error = DataFolder::open(folder.path()).unwrap_err();
    assert!(matches!(error, Error::Damaged { .. }) && !error.is_input(), "{error}");
    assert!(error.to_string().contains("damaged") && error.to_string().contains("move it away"), "{error}");
    let told = DataFolder::open_to_read(Path::new("/nowhere/at/all")).unwrap_err().to_string();
    assert!(told.contains("the library is missing"), "{told}");
}

#[test]
fn a_damaged_library_is_told_wherever_it_is_damaged() {
    let folder = recorded();
    sql(folder.path(), "PRAGMA wal_checkpoint(TRUNCATE)");
    let path = folder.path().join("library.sqlite");
    let whole = fs::read(&path).unwrap();
    let (mut told, pages) = (0, whole.len() / 4096);
    for page in 0..pages {
        let mut bytes = whole.clone();
        bytes[4096 * page..4096 * (page + 1)].fill(0xa5);
        fs::write(&path, bytes).unwrap();
        let verified = DataFolder::open_to_read(folder.path()).and_then(|data| data.verify());
        told += usize::from(!verified.is_ok_and(|v| v.problems.is_empty()));
    }
    // All pages of a library this small are in use.
    assert_eq!(told, pages);
    fs::write(&path, &whole[..whole.len() / 2]).unwrap();
    let error = DataFolder::open(folder.path()).and_then(|data| data.verify());
    assert!(!error.is_ok_and(|v| v.problems.is_empty()));
    fs::write(&path, whole).unwrap();
    assert!(DataFolder::open(folder.path()).unwrap().verify().unwrap().problems.is_empty());
}

#[test]
fn a_full_library_is_told_and_keeps_what_it_has() {
    let folder = recorded();
    let library = Library::open(&folder.path().join("library.sqlite")).unwrap();
    library.limit_pages(60).unwrap();
    let big = "x".repeat(400_000);
    let error = library.add_document(DocumentKind::Program, "big", &big).unwrap_err();
    assert!(matches!(error, Error::Full { .. }) && error.to_string().contains("the disk is full"), "{error}");
    assert!(library.integrity().unwrap().is_empty());
    drop(library);
    let data = DataFolder::open(folder.path()).unwrap();
    assert!(data.verify().unwrap().problems.is_empty());
    assert_eq!(data.library().find(&Query::default()).unwrap().len(), 1);
}

/// In a read-only folder the library is readable, and writing is refused. Root may write everywhere.
#[cfg(unix)]
#[test]
fn a_read_only_folder() {
    use std::os::unix::fs::PermissionsExt;
    let folder = recorded();
    let path = folder.path();
    sql(path, "PRAGMA wal_checkpoint(TRUNCATE)");
    for leftover in ["library.sqlite-wal", "library.sqlite-shm"] {
        let _ = fs::remove_file(path.join(leftover));
    }
    let all = |mode: u32, files: u32| {
        fs::set_permissions(path.join("library.sqlite"), fs::Permissions::from_mode(files)).unwrap();
        fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
    };
    all(0o555, 0o444);
    if fs::write(path.join("probe"), "").is_ok() {
        eprintln!("SKIPPED: this user may write everywhere");
    } else {
        let error = DataFolder::open(path).unwrap_err();
        assert!(matches!(error, Error::ReadOnly { .. }) && error.is_input(), "{error}");
        let data = DataFolder::open_to_read(path).unwrap();
        assert_eq!(data.library().find(&Query::default()).unwrap().len(), 1);
    }
    all(0o755, 0o644);
    // Even for root, a library opened to be read refuses to be written.
    let data = DataFolder::open_to_read(path).unwrap();
    let error = data.library().add_document(DocumentKind::Job, "job", "text").unwrap_err();
    assert!(matches!(error, Error::ReadOnly { .. }) && error.to_string().contains("not writable"), "{error}");
    // A file where the folder should be.
    let error = DataFolder::open(&path.join("library.sqlite")).unwrap_err();
    assert!(error.is_input() && error.to_string().contains("library.sqlite"), "{error}");
}

/// A disk of 2 MB, where the system lets us have one.
#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_runs_full() {
    use std::process::Command;
    let folder = tempfile::tempdir().unwrap();
    let small = folder.path().join("small");
    fs::create_dir(&small).unwrap();
    let mount = |arguments: &[&str]| Command::new("mount").args(arguments).output().is_ok_and(|o| o.status.success());
    let place = small.display().to_string();
    if !mount(&["-t", "tmpfs", "-o", "size=2m", "tmpfs", &place]) {
        eprintln!("SKIPPED: this user may not mount a small disk");
        return;
    }
    let checks = std::panic::catch_unwind(|| on_a_small_disk(&small));
    Command::new("umount").arg(&place).status().unwrap();
    checks.unwrap();
}

#[cfg(target_os = "linux")]
fn on_a_small_disk(small: &Path) {
    use seamwright_record::trace::{TraceWriter, recover};
    let told = DataFolder::open(small).unwrap().begin(&plan("P-1")).unwrap_err().to_string();
    assert!(told.contains("MiB are free, the record of the weld needs"), "{told}");
    let path = small.join("trace.parquet");
    let mut writer = TraceWriter::create(&path, &plan("P-1").columns, &[], u64::MAX).unwrap();
    let ballast = small.join("ballast");
    fs::write(&ballast, vec![1; 1 << 20]).unwrap();
    let (mut refused, mut good) = (0, 0);
    for i in 0..100_000 {
        match writer.row(row(i)) {
            Ok(()) => good += 1,
            Err(Error::Full { .. }) => refused += 1,
            Err(e) => panic!("{e}"),
        }
        if i == 60_000 {
            assert!(refused > 0 && writer.lost() > 0);
            // With free space again the trace goes on, with a gap.
            fs::remove_file(&ballast).unwrap();
        }
    }
    assert!(good > 90_000);
    let _ = writer.flush();
    let lost = writer.lost();
    // The disk may be full for the Parquet file: then the raw one stays, and is recovered later.
    let finished = writer.finish();
    let left: Vec<_> = fs::read_dir(small).unwrap().map(|f| f.unwrap().file_name()).collect();
    let rows = match finished {
        Ok(parts) => parts[0].rows,
        Err(error) => {
            assert!(matches!(error, Error::Full { .. }), "{error}");
            fs::copy(small.join("trace.raw"), small.parent().unwrap().join("trace.raw")).unwrap();
            recover(small.parent().unwrap()).unwrap()[0].rows
        }
    };
    assert_eq!(rows + lost, 100_000, "{left:?}");
    assert!(lost > 0 && rows > 30_000);
}
