use crate::data_folder::{DataFolder, LEFT_UNFINISHED, UNFINISHED};
use crate::error::{Doing, Error};
use crate::hash::{Hashing, sha256_of_file};
use crate::library::Library;
use crate::replacement_steps::{LIBRARY, USERS};
use seamwright_message::{Argument, Message, Unit};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Folders and files of a data folder that go with its library: welds, jobs of the panel, its users.
const WITH: [&str; 3] = ["welds", "jobs", USERS];
/// Bytes that an archive is made of.
const BLOCK: u64 = 512;
/// SHA-256 of every file in the archive, the last one in it.
const MANIFEST: &str = "manifest.sha256";
/// Code of the operator action for a changed archive.
const AS_WRITTEN: &str = "record-archive-as-written";
/// Maximum size of it: half a million files.
const MAX_MANIFEST: u64 = 64 << 20;
/// Maximum number of files and folders in an archive: a hundred thousand welds.
const MAX_ENTRIES: usize = 500_000;
/// Maximum size of a name or another addition to an entry, bytes: it is read into memory.
const MAX_NAME_BYTES: u64 = 4 << 10;

impl DataFolder {
    /// Writes all data into one tar archive: the library at this moment, all files of welds, jobs and users, and the
    /// hashes of all of them. Keys of encrypted connections are left out. Welds may go on meanwhile; a running weld is
    /// in it as the library has it, without its trace.
    ///
    /// # Errors
    /// If a file cannot be read, there is no room for a copy of the library, or `out` fails.
    pub fn back_up(&self, out: impl Write) -> Result<(), Error> {
        self.back_up_files(out, &WITH)
    }

    /// Writes the same without users: the archive gives no access to their password hashes. A restore leaves the users
    /// unchanged.
    ///
    /// # Errors
    /// See [`Self::back_up`].
    pub fn back_up_without_users(&self, out: impl Write) -> Result<(), Error> {
        let with: Vec<&str> = WITH.into_iter().filter(|name| *name != USERS).collect();
        self.back_up_files(out, &with)
    }

    fn back_up_files(&self, out: impl Write, with: &[&str]) -> Result<(), Error> {
        // A larger archive could not be restored.
        let entries: usize = with.iter().map(|name| count(&self.path().join(name), MAX_ENTRIES)).sum();
        if entries + 2 > MAX_ENTRIES {
            return Err(Error::wrong(too_many_entries(), Message::new("record-archive-fewer")));
        }
        let scratch = tempfile::tempdir_in(self.path()).map_err(|e| Error::io(self.path(), Doing::Write, e))?;
        let copy = scratch.path().join(LIBRARY);
        self.library().copy_to(&copy)?;
        let failed = |path: &Path, e| Error::io(path, Doing::Archive, e);
        let mut archive = Archive { tar: tar::Builder::new(out), manifest: String::new() };
        archive.add(&copy, Path::new(LIBRARY)).map_err(|e| failed(&copy, e))?;
        for name in with {
            let path = self.path().join(name);
            archive.add(&path, Path::new(name)).map_err(|e| failed(&path, e))?;
        }
        archive.finish().map_err(|e| failed(self.path(), e))
    }
}

fn too_many_entries() -> Message {
    Message::new("record-archive-entries").number("max", MAX_ENTRIES as f64, 0)
}

/// Counts a file, or a folder with its contents, up to `most`.
fn count(path: &Path, most: usize) -> usize {
    let Ok(kind) = fs::symlink_metadata(path) else { return 0 };
    let inner = if kind.is_dir() { fs::read_dir(path).ok() } else { None };
    inner.into_iter().flatten().flatten().fold(1, |n, entry| match n < most {
        true => n + count(&entry.path(), most - n),
        false => n,
    })
}

struct Archive<W: Write> {
    tar: tar::Builder<W>,
    /// A line for each file in it.
    manifest: String,
}

impl<W: Write> Archive<W> {
    /// Adds a file, or a folder with its contents; missing files, also those removed meanwhile, are left out. So are
    /// raw traces: they grow while a weld runs.
    fn add(&mut self, path: &Path, name: &Path) -> std::io::Result<()> {
        let Ok(kind) = fs::symlink_metadata(path) else { return Ok(()) };
        if kind.is_dir() {
            let entries = fs::read_dir(path)?.collect::<Result<Vec<_>, _>>()?;
            let mut names: Vec<_> = entries.into_iter().map(|entry| entry.file_name()).collect();
            names.sort();
            return names.iter().try_for_each(|inner| self.add(&path.join(inner), &name.join(inner)));
        }
        let Some(file) =
            File::open(path).ok().filter(|_| kind.is_file() && path.extension().is_none_or(|e| e != "raw"))
        else {
            return Ok(());
        };
        let mut header = tar::Header::new_gnu();
        header.set_metadata(&file.metadata()?);
        let mut contents = Hashing::new(file.take(header.size()?));
        self.tar.append_data(&mut header, name, &mut contents)?;
        self.manifest += &line(&contents.finish(), name);
        Ok(())
    }

    /// Adds the hashes, and the mark of the end.
    fn finish(mut self) -> std::io::Result<()> {
        let mut header = tar::Header::new_gnu();
        header.set_size(self.manifest.len() as u64);
        header.set_mode(0o600);
        self.tar.append_data(&mut header, MANIFEST, self.manifest.as_bytes())?;
        self.tar.into_inner().and_then(|mut out| out.flush())
    }
}

/// A line of the manifest, as `sha256sum` writes and checks it.
fn line(hash: &str, name: &Path) -> String {
    format!("{hash}  {}\n", name.display())
}

/// Restores the data folder `folder`, which must be missing or empty, from an archive of [`DataFolder::back_up`]: all
/// of it, or none. Every file must be unchanged since the backup; rows of the library are copied into one of our own.
///
/// # Errors
/// A folder that is not empty, an archive that is damaged, was changed or has no library, a full disk.
pub fn restore(archive: &Path, folder: &Path) -> Result<(), Error> {
    let used = fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some()) || folder.is_file();
    if used {
        let what = Message::new("record-folder-not-empty").text("path", folder.display().to_string());
        return Err(Error::wrong(what, Message::new("record-empty-folder")));
    }
    let file = File::open(archive).map_err(|e| Error::io(archive, Doing::Read, e))?;
    let parent = folder.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let scratch = tempfile::tempdir_in(parent).map_err(|e| Error::io(parent, Doing::Write, e))?;
    let inside = scratch.path().join("data");
    unpack(file, archive, &inside)?;
    let is_listed = check_manifest(archive, &inside)?;
    // Only rows are copied from the archive: its triggers, views and damaged pages are not.
    let foreign = scratch.path().join("foreign.sqlite");
    fs::rename(inside.join(LIBRARY), &foreign).map_err(|e| Error::io(&foreign, Doing::Create, e))?;
    let has_manifests = Library::rebuild(&foreign, &inside.join(LIBRARY)).map_err(|e| in_archive(archive, e))?;
    if has_manifests && !is_listed {
        let why = Message::new("record-manifest-missing").text("name", MANIFEST);
        return Err(Error::damaged(archive, why, Message::new(AS_WRITTEN)));
    }
    // It opens, and is of this version or an older one.
    let data = DataFolder::open(&inside).map_err(|e| in_archive(archive, e))?;
    if !is_listed {
        // Of an older version, which wrote no hashes: those that the library has must be right.
        let mut problems = data.verify()?.problems;
        problems.retain(|problem| !matches!(problem.code.as_ref(), UNFINISHED | LEFT_UNFINISHED));
        if let Some(problem) = problems.first() {
            let why = Message::new("record-archive-without-hashes").message("problem", relative(problem, &inside));
            return Err(Error::damaged(archive, why, Message::new(AS_WRITTEN)));
        }
    }
    drop(data);
    if folder.is_dir() {
        fs::remove_dir(folder).map_err(|e| Error::io(folder, Doing::Remove, e))?;
    }
    fs::rename(&inside, folder).map_err(|e| Error::io(folder, Doing::Create, e))
}

/// Removes the path of the temporary folder, which means nothing to the user.
fn relative(message: &Message, folder: &Path) -> Message {
    let path = format!("{}/", folder.display());
    let mut message = message.clone();
    for (_, argument) in &mut message.arguments {
        match argument {
            Argument::Text(text) => *text = text.replace(&path, ""),
            Argument::Message(inner) => **inner = relative(inner, folder),
            _ => {}
        }
    }
    message
}

/// Names the archive as the source of an error of the library inside it.
fn in_archive(archive: &Path, e: Error) -> Error {
    match e {
        Error::Damaged { why, allowed, .. } => Error::Damaged { path: archive.to_owned(), why, allowed },
        Error::Newer { found, known, .. } => Error::Newer { path: archive.to_owned(), found, known },
        Error::Database { cause, .. } => {
            let why = Message::new("record-library-damaged").text("why", cause.to_string());
            Error::damaged(archive, why, Message::new(AS_WRITTEN))
        }
        other => other,
    }
}

/// Verifies every file against the manifest, and removes the manifest. False if it is missing, as in archives of older
/// versions.
fn check_manifest(archive: &Path, inside: &Path) -> Result<bool, Error> {
    let path = inside.join(MANIFEST);
    let size = match fs::metadata(&path) {
        Ok(there) => there.len(),
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(false),
        Err(e) => return Err(Error::io(&path, Doing::Read, e)),
    };
    if size > MAX_MANIFEST {
        let mib = |bytes: u64| bytes.div_ceil(1 << 20) as f64;
        let why = Message::new("record-manifest-size").text("name", MANIFEST).quantity("size", mib(size), Unit::MiB, 0);
        let allowed = Message::new("document-at-most").quantity("max", mib(MAX_MANIFEST), Unit::MiB, 0);
        return Err(Error::damaged(archive, why, allowed));
    }
    let manifest = fs::read_to_string(&path).map_err(|e| Error::io(&path, Doing::Read, e))?;
    fs::remove_file(&path).map_err(|e| Error::io(&path, Doing::Remove, e))?;
    let listed: BTreeSet<String> = manifest.split_inclusive('\n').map(str::to_owned).collect();
    let mut found = BTreeSet::new();
    lines(inside, Path::new(""), &mut found)?;
    let differs = listed.symmetric_difference(&found).next();
    let Some(differs) = differs else { return Ok(true) };
    let name = differs.trim_end().split_once("  ").map_or(MANIFEST, |(_, name)| name);
    let why = Message::new("record-archive-changed").text("name", name);
    Err(Error::damaged(archive, why, Message::new(AS_WRITTEN)))
}

fn lines(folder: &Path, name: &Path, found: &mut BTreeSet<String>) -> Result<(), Error> {
    let path = folder.join(name);
    if !path.is_dir() {
        found.insert(line(&sha256_of_file(&path)?.0, name));
        return Ok(());
    }
    let unreadable = |e| Error::io(&path, Doing::Read, e);
    for entry in fs::read_dir(&path).map_err(unreadable)? {
        lines(folder, &name.join(entry.map_err(unreadable)?.file_name()), found)?;
    }
    Ok(())
}

/// Looks through the headers of an archive before its names are read into memory and its files are made: of these there
/// may be no more, and those no longer, than any backup has.
fn check_headers(file: &mut (impl Read + Seek), from: &Path, most: usize) -> Result<(), Error> {
    let failed = |e| Error::io(from, Doing::Unpack, e);
    let damaged = |why| Error::damaged(from, why, Message::new(AS_WRITTEN));
    let mut entries = 0;
    let mut archive = tar::Archive::new(&mut *file);
    for entry in archive.entries_with_seek().map_err(failed)?.raw(true) {
        let entry = entry.map_err(failed)?;
        let kind = entry.header().entry_type();
        if kind.is_gnu_sparse() {
            // It would take more room than the archive.
            let name = String::from_utf8_lossy(&entry.path_bytes()).into_owned();
            return Err(damaged(Message::new("record-archive-foreign").text("name", name)));
        }
        entries += usize::from(kind.is_file() || kind.is_dir());
        if !kind.is_file() && entry.size() > MAX_NAME_BYTES {
            let max = (MAX_NAME_BYTES >> 10) as f64;
            return Err(damaged(Message::new("record-archive-name").number("max", max, 0)));
        }
        if entries > most {
            return Err(damaged(too_many_entries()));
        }
    }
    file.rewind().map_err(failed)
}

/// Unpacks only plain files and folders of the kinds that an archive has, and only into `folder`.
fn unpack(mut file: impl Read + Seek, from: &Path, folder: &Path) -> Result<(), Error> {
    let failed = |e| Error::io(from, Doing::Unpack, e);
    let damaged = |why| Error::damaged(from, why, Message::new(AS_WRITTEN));
    check_headers(&mut file, from, MAX_ENTRIES)?;
    fs::create_dir(folder).map_err(failed)?;
    let mut end = 0;
    let mut archive = tar::Archive::new(&mut file);
    for entry in archive.entries().map_err(failed)? {
        let mut entry = entry.map_err(failed)?;
        let path = entry.path().map_err(failed)?.into_owned();
        let named = |code| Message::new(code).text("name", path.display().to_string());
        let first = path.components().next().and_then(|c| c.as_os_str().to_str().map(str::to_owned));
        let known = first.is_some_and(|first| first == LIBRARY || first == MANIFEST || WITH.contains(&first.as_str()));
        let kind = entry.header().entry_type();
        if !known || !(kind.is_file() || kind.is_dir()) {
            return Err(damaged(named("record-archive-foreign")));
        }
        // Regardless of the archive only the owner may write the files, and only the owner may read users.
        entry.set_mask(if path == Path::new(USERS) { 0o7177 } else { 0o7022 });
        end = entry.raw_file_position() + entry.size().next_multiple_of(BLOCK);
        if !entry.unpack_in(folder).map_err(failed)? {
            return Err(damaged(named("record-archive-outside")));
        }
    }
    // The mark of its end: without it, files may be missing.
    file.seek(SeekFrom::Start(end)).map_err(failed)?;
    let mut mark = [1; 2 * BLOCK as usize];
    if file.read_exact(&mut mark).is_err() || mark.iter().any(|byte| *byte != 0) {
        return Err(damaged(Message::new("record-archive-cut-off")));
    }
    if !folder.join(LIBRARY).is_file() {
        return Err(damaged(Message::new("record-archive-no-library")));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hash::sha256_of_file;
    use crate::library::{AuditEntry, DocumentKind};
    use crate::moment::Moment;

    fn folder(path: &Path) -> DataFolder {
        let mut data = DataFolder::open(path).unwrap();
        data.library().add_document(DocumentKind::Job, "job.toml", "text").unwrap();
        let text = |t: &str| t.to_owned();
        let (user, station, command, old, new, result) =
            (text("ada"), text("panel"), text("arm"), text(""), text(""), text("taken"));
        data.library_mut().audit(&AuditEntry { at: Moment(5), user, station, command, old, new, result }).unwrap();
        fs::create_dir_all(path.join("welds/000001")).unwrap();
        fs::write(path.join("welds/000001/trace.parquet"), vec![7u8; 100_000]).unwrap();
        fs::create_dir(path.join("jobs")).unwrap();
        fs::write(path.join("jobs/mine.toml"), "title = \"mine\"").unwrap();
        fs::write(path.join("users.json"), "[]").unwrap();
        fs::create_dir(path.join("tls")).unwrap();
        fs::write(path.join("tls/ca.key"), "secret").unwrap();
        data
    }

    #[test]
    fn what_is_backed_up_comes_back() {
        let scratch = tempfile::tempdir().unwrap();
        let (from, to) = (scratch.path().join("from"), scratch.path().join("to"));
        let data = folder(&from);
        let archive = scratch.path().join("backup.tar");
        data.back_up(File::create(&archive).unwrap()).unwrap();
        restore(&archive, &to).unwrap();
        let back = DataFolder::open(&to).unwrap();
        assert_eq!(back.library().documents(DocumentKind::Job, "job.toml").unwrap().len(), 1);
        assert_eq!(back.library().verify_audit().unwrap().entries, 1);
        for file in ["welds/000001/trace.parquet", "jobs/mine.toml", "users.json"] {
            assert_eq!(sha256_of_file(&from.join(file)).unwrap(), sha256_of_file(&to.join(file)).unwrap());
        }
        assert!(!to.join("tls").exists() && !to.join(MANIFEST).exists());
        // Existing data are never overwritten.
        assert!(restore(&archive, &to).is_err());
        // Cut off anywhere it is refused, and leaves no files behind.
        let bytes = fs::read(&archive).unwrap();
        for part in 1..40 {
            let cut = scratch.path().join("cut.tar");
            fs::write(&cut, &bytes[..bytes.len() * part / 50]).unwrap();
            let there = scratch.path().join("there");
            assert!(restore(&cut, &there).is_err(), "{part}");
            assert!(!there.exists());
        }
    }

    /// Users are readable by their owner only, regardless of the archive.
    #[cfg(unix)]
    #[test]
    fn an_archive_opens_no_file_to_others() {
        use std::os::unix::fs::PermissionsExt as _;
        let scratch = tempfile::tempdir().unwrap();
        let (from, to) = (scratch.path().join("from"), scratch.path().join("to"));
        let data = folder(&from);
        for file in ["users.json", "jobs/mine.toml"] {
            fs::set_permissions(from.join(file), fs::Permissions::from_mode(0o666)).unwrap();
        }
        let archive = scratch.path().join("backup.tar");
        data.back_up(File::create(&archive).unwrap()).unwrap();
        restore(&archive, &to).unwrap();
        let mode = |file: &str| fs::metadata(to.join(file)).unwrap().permissions().mode();
        assert_eq!((mode("users.json") & 0o177, mode("jobs/mine.toml") & 0o022), (0, 0));
    }

    /// Any changed byte of an archive is detected, unless it has no effect on the restored data.
    #[test]
    fn altered_archives_are_refused() {
        let scratch = tempfile::tempdir().unwrap();
        let (from, to) = (scratch.path().join("from"), scratch.path().join("to"));
        let data = folder(&from);
        let archive = scratch.path().join("backup.tar");
        data.back_up(File::create(&archive).unwrap()).unwrap();
        let bytes = fs::read(&archive).unwrap();
        let altered = scratch.path().join("altered.tar");
        let (mut random, mut taken) = (seamwright_testkit::Random::new(7), 0);
        for _ in 0..150 {
            let (at, bit) = (random.below(bytes.len()), random.below(8));
            let mut changed = bytes.clone();
            changed[at] ^= 1 << bit;
            fs::write(&altered, &changed).unwrap();
            if restore(&altered, &to).is_ok() {
                taken += 1;
                // Padding between files: the restored files equal the saved ones.
                for file in ["welds/000001/trace.parquet", "jobs/mine.toml", "users.json"] {
                    assert_eq!(
                        sha256_of_file(&from.join(file)).unwrap(),
                        sha256_of_file(&to.join(file)).unwrap(),
                        "{at}"
                    );
                }
                assert!(DataFolder::open_to_read(&to).unwrap().verify().unwrap().audit.broken.is_none());
                fs::remove_dir_all(&to).unwrap();
            }
            assert!(!to.exists());
        }
        assert!(taken < 15, "{taken} of 150 altered archives were taken");
    }

    /// Archives of versions that wrote no hashes are still accepted, if they match the library.
    #[test]
    fn archives_without_hashes_are_taken_in_order_only() {
        let scratch = tempfile::tempdir().unwrap();
        let from = scratch.path().join("from");
        drop(folder(&from));
        let copy = |name: &str, change: &str| {
            let (library, archive) =
                (scratch.path().join(format!("{name}.sqlite")), scratch.path().join(format!("{name}.tar")));
            Library::open_to_read(&from.join(LIBRARY)).unwrap().copy_to(&library).unwrap();
            let db = rusqlite::Connection::open(&library).unwrap();
            // Of the last version that wrote no hashes.
            let older = "ALTER TABLE alarm DROP COLUMN priority; PRAGMA user_version = 2";
            db.execute_batch(older).and_then(|()| db.execute_batch(change)).unwrap();
            drop(db);
            let mut builder = tar::Builder::new(File::create(&archive).unwrap());
            builder.append_path_with_name(&library, LIBRARY).unwrap();
            builder.finish().unwrap();
            restore(&archive, &scratch.path().join(name)).map_err(|e| e.to_string())
        };
        assert_eq!(copy("whole", ""), Ok(()));
        let spy = copy("spy", "CREATE TRIGGER spy AFTER INSERT ON audit BEGIN SELECT 1; END").unwrap_err();
        assert!(spy.contains("trigger `spy`") && spy.contains("spy.tar"), "{spy}");
        let changed = "DROP TRIGGER audit_is_not_changed; UPDATE audit SET user = 'eve';
            CREATE TRIGGER audit_is_not_changed BEFORE UPDATE ON audit
            BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;";
        let changed = copy("changed", changed).unwrap_err();
        assert!(changed.contains("audit log, entry 1"), "{changed}");
        // Archives without hashes are refused.
        let stripped = copy("stripped", "PRAGMA user_version = 3").unwrap_err();
        assert!(stripped.contains("manifest.sha256: missing") && stripped.contains("stripped.tar"), "{stripped}");
    }

    /// A list of hashes that is larger than memory is not read.
    #[test]
    fn a_manifest_of_any_size_is_not_read() {
        let scratch = tempfile::tempdir().unwrap();
        let inside = scratch.path().join("inside");
        fs::create_dir(&inside).unwrap();
        File::create(inside.join(MANIFEST)).unwrap().set_len(MAX_MANIFEST + 1).unwrap();
        let refused = check_manifest(Path::new("backup.tar"), &inside).unwrap_err().to_string();
        assert!(refused.contains("manifest.sha256: 65 MiB"), "{refused}");
    }

    /// An archive of `names`, each an empty file, and the path to which it would be restored.
    fn archive_of(scratch: &Path, names: usize) -> std::path::PathBuf {
        let archive = scratch.join("many.tar");
        let mut builder = tar::Builder::new(std::io::BufWriter::new(File::create(&archive).unwrap()));
        for i in 0..names {
            let mut header = tar::Header::new_gnu();
            header.set_size(0);
            header.set_mode(0o644);
            builder.append_data(&mut header, format!("jobs/{i}.toml"), &b""[..]).unwrap();
        }
        builder.into_inner().unwrap().flush().unwrap();
        archive
    }

    /// Files are counted before the first one is made. An archive of 256 MB would make half a million.
    #[test]
    fn an_archive_of_too_many_files_makes_none() {
        let scratch = tempfile::tempdir().unwrap();
        let archive = archive_of(scratch.path(), 100);
        let check = |most: usize| check_headers(&mut File::open(&archive).unwrap(), &archive, most);
        assert!(check(100).is_ok());
        assert!(check(99).unwrap_err().to_string().contains("more than 500000 files"), "{:?}", check(99));
        let archive = archive_of(scratch.path(), MAX_ENTRIES + 1);
        let refused = restore(&archive, &scratch.path().join("to")).unwrap_err().to_string();
        assert!(refused.contains("more than 500000 files"), "{refused}");
        assert_eq!(fs::read_dir(scratch.path()).unwrap().count(), 1);
    }

    /// Neither a long name nor an extended header of gigabytes is read into memory; sparse files, which are larger than
    /// the archive, are refused.
    #[test]
    fn names_of_gigabytes_and_sparse_files_are_refused() {
        let scratch = tempfile::tempdir().unwrap();
        let refused = |kind: tar::EntryType, size: u64| {
            let archive = scratch.path().join("bad.tar");
            let mut header = tar::Header::new_gnu();
            header.set_path(if kind.is_gnu_sparse() { "jobs/sparse.toml" } else { "././@LongLink" }).unwrap();
            header.set_entry_type(kind);
            header.set_mode(0o644);
            header.set_size(size);
            if kind.is_gnu_sparse() {
                header.as_gnu_mut().unwrap().set_real_size(1 << 40);
            }
            header.set_cksum();
            let mut file = File::create(&archive).unwrap();
            file.write_all(header.as_bytes()).unwrap();
            file.set_len(BLOCK + size.next_multiple_of(BLOCK) + 2 * BLOCK).unwrap();
            restore(&archive, &scratch.path().join("to")).unwrap_err().to_string()
        };
        for kind in [tar::EntryType::GNULongName, tar::EntryType::GNULongLink, tar::EntryType::XHeader] {
            let told = refused(kind, 8 << 30);
            assert!(told.contains("longer than 4 KiB"), "{kind:?}: {told}");
        }
        let told = refused(tar::EntryType::GNUSparse, 0);
        assert!(told.contains("foreign to a backup"), "{told}");
        assert!(!scratch.path().join("to").exists());
    }

    /// A backup without users holds no password hashes; after a restore the users stay unchanged.
    #[test]
    fn a_backup_without_users_has_none() {
        let scratch = tempfile::tempdir().unwrap();
        let (from, to) = (scratch.path().join("from"), scratch.path().join("to"));
        let data = folder(&from);
        let archive = scratch.path().join("backup.tar");
        data.back_up_without_users(File::create(&archive).unwrap()).unwrap();
        restore(&archive, &to).unwrap();
        assert!(to.join("jobs/mine.toml").is_file() && !to.join(USERS).exists());
    }

    #[test]
    fn archives_that_lead_elsewhere_are_refused() {
        let scratch = tempfile::tempdir().unwrap();
        for name in ["elsewhere.txt", "welds-not/x"] {
            let archive = scratch.path().join("bad.tar");
            let mut builder = tar::Builder::new(File::create(&archive).unwrap());
            let mut header = tar::Header::new_gnu();
            header.set_size(1);
            header.set_mode(0o644);
            builder.append_data(&mut header, name, &b"x"[..]).unwrap();
            builder.finish().unwrap();
            let told = restore(&archive, &scratch.path().join("to")).unwrap_err().to_string();
            assert!(told.contains("unchanged archive"), "{told}");
            assert!(!scratch.path().join("to").exists());
        }
    }
}
