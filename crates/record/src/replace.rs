use crate::backup::restore;
use crate::data_folder::DataFolder;
use crate::error::{Doing, Error};
use crate::library::Query;
use crate::moment::Moment;
use crate::replacement_steps::{BEGUN, CHECKED, USERS, finish_replacing, sync, synced};
use seamwright_message::Message;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// Contents of an archive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Contents {
    /// Welds.
    pub welds: usize,
    /// Start of the newest of them.
    pub newest: Option<Moment>,
    /// Files of jobs.
    pub jobs: usize,
    /// Entries of the audit log.
    pub audit: u64,
}

/// Unpacks an archive of [`DataFolder::back_up`] inside the data folder and checks all of it: the library and its
/// version, the audit log's chain, the hash of every file that the library names. Data are not replaced. Returns the
/// contents, and their folder until [`discard_checked`], [`replace_by_checked`] or the next check.
///
/// # Errors
/// An archive that is foreign, not whole, of a later version or changed since; a disk that is full.
pub fn check_archive(archive: &Path, data: &Path) -> Result<(Contents, PathBuf), Error> {
    discard_checked(data)?;
    let scratch = tempfile::tempdir_in(data).map_err(|e| Error::io(data, Doing::Write, e))?;
    let new = scratch.path().join("new");
    restore(archive, &new)?;
    let mut folder = DataFolder::open(&new)?;
    // A weld that was running when it was backed up is an interrupted one there.
    folder.recover()?;
    let verified = folder.verify()?;
    if let Some(problem) = verified.problems.first() {
        let more = verified.problems.len() - 1;
        let why = Message::new("record-archive-problems").message("problem", problem.clone()).count("more", more);
        return Err(Error::damaged(archive, why, Message::new("record-restore-elsewhere")));
    }
    let newest = folder.library().find(&Query::default())?.iter().map(|weld| weld.begun).max();
    let jobs = fs::read_dir(new.join("jobs")).map_or(0, Iterator::count);
    let contents = Contents { welds: verified.welds, newest, jobs, audit: verified.audit.entries };
    drop(folder);
    sync(&new).map_err(|e| Error::io(&new, Doing::Write, e))?;
    let checked = data.join(CHECKED);
    fs::rename(scratch.path(), &checked).map_err(|e| Error::io(&checked, Doing::Create, e))?;
    Ok((contents, checked.join("new")))
}

/// Removes the files unpacked by [`check_archive`], if any.
pub fn discard_checked(data: &Path) -> Result<(), Error> {
    let checked = data.join(CHECKED);
    match fs::remove_dir_all(&checked) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(Error::io(&checked, Doing::Remove, e)),
        _ => Ok(()),
    }
}

/// True if an archive was checked and waits.
pub fn has_checked(data: &Path) -> bool {
    data.join(CHECKED).is_dir()
}

/// Replaces the data, which must not be open, by the checked archive. Returns the folder of the old data.
///
/// # Errors
/// Without a checked archive, or if files cannot be moved: then [`finish_replacing`] continues, at the latest when the
/// folder is opened next.
pub fn replace_by_checked(data: &Path) -> Result<PathBuf, Error> {
    let checked = data.join(CHECKED);
    keep_users(data, &checked.join("new"))?;
    fs::rename(&checked, data.join(BEGUN)).map_err(|e| Error::io(&checked, Doing::Move, e))?;
    let nothing = || Error::wrong(Message::new("record-nothing-restored"), Message::new("record-checked-archive"));
    finish_replacing(data)?.ok_or_else(nothing)
}

/// An archive without users leaves them as they are.
fn keep_users(data: &Path, new: &Path) -> Result<(), Error> {
    let (own, coming) = (data.join(USERS), new.join(USERS));
    if !own.is_file() || coming.exists() || !new.is_dir() {
        return Ok(());
    }
    let failed = |e| Error::io(&coming, Doing::Write, e);
    // Whole, or not: a restore that is broken off here has not begun.
    let mut file = tempfile::NamedTempFile::new_in(new).map_err(failed)?;
    let mut from = File::open(&own).map_err(|e| Error::io(&own, Doing::Read, e))?;
    std::io::copy(&mut from, &mut file).map_err(failed)?;
    file.as_file().sync_all().map_err(failed)?;
    file.persist(&coming).map(drop).map_err(|e| failed(e.error))?;
    synced(new)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::{AuditEntry, DocumentKind};
    use crate::replacement_steps::{LIBRARY, MOVED, REPLACED};

    fn audit(data: &mut DataFolder, command: &str) {
        let text = |t: &str| t.to_owned();
        let (user, station, old, new) = (text("ada"), text("panel"), text(""), text(""));
        let (command, result) = (text(command), text("taken"));
        data.library_mut().audit(&AuditEntry { at: Moment(5), user, station, command, old, new, result }).unwrap();
    }

    /// Data of a name, with users, a job and a journal.
    fn folder(path: &Path, name: &str) -> DataFolder {
        let mut data = DataFolder::open(path).unwrap();
        data.library().add_document(DocumentKind::Job, "job.toml", name).unwrap();
        audit(&mut data, name);
        fs::create_dir(path.join("jobs")).unwrap();
        fs::write(path.join(format!("jobs/{name}.toml")), name).unwrap();
        fs::write(path.join("users.json"), format!("[\"{name}\"]")).unwrap();
        drop(data.journal().unwrap());
        data
    }

    fn archive_of(scratch: &Path) -> PathBuf {
        let archive = scratch.join("backup.tar");
        folder(&scratch.join("from"), "new").back_up(File::create(&archive).unwrap()).unwrap();
        archive
    }

    fn name_in(data: &Path) -> String {
        let folder = DataFolder::open(data).unwrap();
        assert!(folder.library().verify_audit().unwrap().broken.is_none());
        let text = folder.library().documents(DocumentKind::Job, "job.toml").unwrap()[0].text.clone();
        let users = fs::read_to_string(data.join("users.json")).unwrap();
        assert_eq!(users, format!("[\"{text}\"]"));
        assert!(data.join(format!("jobs/{text}.toml")).is_file());
        assert_eq!(fs::read_dir(data.join("jobs")).unwrap().count(), 1);
        text
    }

    #[test]
    fn data_are_replaced_whole_and_the_old_ones_kept() {
        let scratch = tempfile::tempdir().unwrap();
        let (archive, data) = (archive_of(scratch.path()), scratch.path().join("data"));
        drop(folder(&data, "old"));
        fs::create_dir(data.join("tls")).unwrap();
        let (contents, new) = check_archive(&archive, &data).unwrap();
        assert_eq!(contents, Contents { welds: 0, newest: None, jobs: 1, audit: 1 });
        // The data are unchanged until then.
        assert!(has_checked(&data) && new.join("users.json").is_file());
        assert_eq!(name_in(&data), "old");
        let kept = replace_by_checked(&data).unwrap();
        assert_eq!((name_in(&data).as_str(), name_in(&kept).as_str()), ("new", "old"));
        // The journal refers to welds of the old data; keys stay.
        assert!(kept.join("position.a").is_file() && data.join("tls").is_dir() && !has_checked(&data));
        assert!(replace_by_checked(&data).is_err());
        assert_eq!(finish_replacing(&data).unwrap(), None);
    }

    #[test]
    fn users_stay_where_none_come() {
        let scratch = tempfile::tempdir().unwrap();
        let (archive, data) = (scratch.path().join("backup.tar"), scratch.path().join("data"));
        folder(&scratch.path().join("from"), "new").back_up_without_users(File::create(&archive).unwrap()).unwrap();
        drop(folder(&data, "old"));
        let (_, new) = check_archive(&archive, &data).unwrap();
        assert!(!new.join(USERS).exists());
        replace_by_checked(&data).unwrap();
        assert!(data.join("jobs/new.toml").is_file());
        assert_eq!(fs::read_to_string(data.join(USERS)).unwrap(), "[\"old\"]");
    }

    /// Broken off after any number of moves it is finished the next time, whole.
    #[test]
    fn a_restore_that_was_broken_off_is_finished() {
        for steps in 0..=2 * REPLACED.len() {
            let scratch = tempfile::tempdir().unwrap();
            let (archive, data) = (archive_of(scratch.path()), scratch.path().join("data"));
            drop(folder(&data, "old"));
            check_archive(&archive, &data).unwrap();
            let (begun, moved) = (data.join(BEGUN), data.join(MOVED));
            fs::rename(data.join(CHECKED), &begun).unwrap();
            fs::create_dir(begun.join("old")).unwrap();
            let there = |from: &Path, name: &str| from.join(name).exists();
            for name in REPLACED.iter().take(steps).filter(|name| there(&data, name)) {
                fs::rename(data.join(name), begun.join("old").join(name)).unwrap();
            }
            if steps >= REPLACED.len() {
                fs::rename(&begun, &moved).unwrap();
                let new = moved.join("new");
                for name in REPLACED.iter().take(steps - REPLACED.len()).filter(|name| there(&new, name)) {
                    fs::rename(new.join(name), data.join(name)).unwrap();
                }
            }
            // Opening it is enough.
            assert_eq!(name_in(&data), "new", "after {steps} steps");
            let kept = fs::read_dir(&data).unwrap().flatten().map(|e| e.path());
            let kept = kept.into_iter().find(|p| p.to_string_lossy().contains("before-restore")).unwrap();
            assert_eq!(name_in(&kept), "old", "after {steps} steps");
            assert!(!begun.exists() && !moved.exists());
        }
    }

    /// A refused archive leaves no files behind and changes no data.
    #[test]
    fn foreign_changed_and_newer_archives_are_refused() {
        let scratch = tempfile::tempdir().unwrap();
        let (archive, data) = (archive_of(scratch.path()), scratch.path().join("data"));
        drop(folder(&data, "old"));
        let whole = fs::read(&archive).unwrap();
        let bad = scratch.path().join("bad.tar");
        let refused = |what: &str| {
            let told = check_archive(&bad, &data).unwrap_err().to_string();
            assert!(!has_checked(&data) && name_in(&data) == "old", "{what}");
            assert_eq!(fs::read_dir(&data).unwrap().flatten().filter(|e| e.path().is_dir()).count(), 2, "{what}");
            told
        };
        for n in [0, 1, 511, 512, whole.len() / 2, whole.len() - 1025, whole.len() - 1] {
            fs::write(&bad, &whole[..n]).unwrap();
            assert!(refused("cut").contains("archive"), "{n}");
        }
        fs::write(&bad, b"PK\x03\x04 something else".repeat(100)).unwrap();
        assert!(refused("foreign").contains("archive"));
        // An entry of the audit log that was changed, and a schema of a later version.
        for (sql, said) in [
            (
                "UPDATE audit SET user = 'eve'; ALTER TABLE alarm DROP COLUMN priority; PRAGMA user_version = 2",
                "audit log, entry",
            ),
            ("PRAGMA user_version = 999", "later version"),
        ] {
            let from = scratch.path().join(format!("from {said}"));
            let changed = folder(&from, "new");
            drop(changed);
            let db = rusqlite::Connection::open(from.join(LIBRARY)).unwrap();
            let named = |row: &rusqlite::Row<'_>| Ok((row.get::<_, String>(0)?, row.get::<_, String>(1)?));
            let mut query = db.prepare("SELECT name, sql FROM sqlite_schema WHERE type = 'trigger'").unwrap();
            let triggers: Vec<_> = query.query_map((), named).unwrap().map(Result::unwrap).collect();
            drop(query);
            triggers.iter().for_each(|(name, _)| db.execute_batch(&format!("DROP TRIGGER {name}")).unwrap());
            db.execute_batch(sql).unwrap();
            // Triggers restored, so that the change is not visible in the schema.
            triggers.iter().for_each(|(_, sql)| db.execute_batch(sql).unwrap());
            db.execute_batch("PRAGMA wal_checkpoint(TRUNCATE)").unwrap();
            drop(db);
            let mut builder = tar::Builder::new(File::create(&bad).unwrap());
            builder.append_path_with_name(from.join(LIBRARY), LIBRARY).unwrap();
            builder.finish().unwrap();
            let told = refused(said);
            assert!(told.contains(said), "{told}");
        }
    }
}
