use crate::library::Library;
use crate::{DataFolder, Error};
use std::fs::{self, File};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Folders and files of a data folder that go with its library: welds, jobs of the panel, its users.
const WITH: [&str; 3] = ["welds", "jobs", USERS];
/// Users with hashes of their passwords.
pub(crate) const USERS: &str = "users.json";
/// Bytes that an archive is made of.
const BLOCK: u64 = 512;
/// The library in the archive.
pub(crate) const LIBRARY: &str = "library.sqlite";

impl DataFolder {
    /// Writes everything into one tar archive: the library as it is at this moment, and all files of welds, jobs and users. Keys of
    /// encrypted connections stay where they are. Welds may go on meanwhile; what runs is in it as the library has it, without its trace.
    ///
    /// # Errors
    /// If something cannot be read, there is no room for a copy of the library, or `out` fails.
    pub fn back_up(&self, out: impl Write) -> Result<(), Error> {
        let scratch = tempfile::tempdir_in(self.path()).map_err(|e| Error::io(self.path(), "cannot be written", e))?;
        let copy = scratch.path().join(LIBRARY);
        self.library().copy_to(&copy)?;
        let failed = |path: &Path, e| Error::io(path, "cannot be put into the archive", e);
        let mut archive = tar::Builder::new(out);
        add(&mut archive, &copy, Path::new(LIBRARY)).map_err(|e| failed(&copy, e))?;
        for name in WITH {
            let path = self.path().join(name);
            add(&mut archive, &path, Path::new(name)).map_err(|e| failed(&path, e))?;
        }
        archive.into_inner().and_then(|mut out| out.flush()).map_err(|e| failed(self.path(), e))
    }
}

/// Adds a file, or a folder with what is in it; what is not there, or goes meanwhile, is left out. So are raw traces: they grow
/// while a weld runs.
fn add(archive: &mut tar::Builder<impl Write>, path: &Path, name: &Path) -> std::io::Result<()> {
    let Ok(kind) = fs::symlink_metadata(path) else { return Ok(()) };
    if kind.is_dir() {
        let entries = fs::read_dir(path)?.collect::<Result<Vec<_>, _>>()?;
        let mut names: Vec<_> = entries.into_iter().map(|entry| entry.file_name()).collect();
        names.sort();
        return names.iter().try_for_each(|inner| add(archive, &path.join(inner), &name.join(inner)));
    }
    let Some(file) = File::open(path).ok().filter(|_| kind.is_file() && path.extension().is_none_or(|e| e != "raw"))
    else {
        return Ok(());
    };
    let mut header = tar::Header::new_gnu();
    header.set_metadata(&file.metadata()?);
    let size = header.size()?;
    archive.append_data(&mut header, name, file.take(size))
}

/// Makes the data folder `folder`, which must not be there or be empty, from an archive of [`DataFolder::back_up`]: all of it, or
/// nothing.
///
/// # Errors
/// A folder with something in it, an archive that is damaged or has no library, a disk that is full.
pub fn restore(archive: &Path, folder: &Path) -> Result<(), Error> {
    let used = fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some()) || folder.is_file();
    if used {
        let what = format!("{}: there is something in it", folder.display());
        return Err(Error::wrong(what, "a folder that is empty or not there yet"));
    }
    let file = File::open(archive).map_err(|e| Error::io(archive, "cannot be read", e))?;
    let parent = folder.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let scratch = tempfile::tempdir_in(parent).map_err(|e| Error::io(parent, "cannot be written", e))?;
    let inside = scratch.path().join("data");
    unpack(file, &inside).map_err(|e| Error::io(archive, "is no whole archive", e))?;
    // It opens, and is of this version or an older one.
    drop(Library::open(&inside.join(LIBRARY))?);
    if folder.is_dir() {
        fs::remove_dir(folder).map_err(|e| Error::io(folder, "cannot be replaced", e))?;
    }
    fs::rename(&inside, folder).map_err(|e| Error::io(folder, "cannot be made", e))
}

/// Only plain files and folders of the kinds that an archive has; nothing outside `folder`.
fn unpack(mut file: impl Read + Seek, folder: &Path) -> std::io::Result<()> {
    fs::create_dir(folder)?;
    let mut end = 0;
    let wrong = |what: String| std::io::Error::new(std::io::ErrorKind::InvalidData, what);
    let mut archive = tar::Archive::new(&mut file);
    for entry in archive.entries()? {
        let mut entry = entry?;
        let path = entry.path()?.into_owned();
        let first = path.components().next().and_then(|c| c.as_os_str().to_str().map(str::to_owned));
        let known = first.is_some_and(|first| first == LIBRARY || WITH.contains(&first.as_str()));
        let kind = entry.header().entry_type();
        if !known || !(kind.is_file() || kind.is_dir()) {
            return Err(wrong(format!("{} does not belong into it", path.display())));
        }
        // Nobody else's to write, users nobody else's to read, whatever the archive says.
        entry.set_mask(if path == Path::new(USERS) { 0o7177 } else { 0o7022 });
        end = entry.raw_file_position() + entry.size().next_multiple_of(BLOCK);
        if !entry.unpack_in(folder)? {
            return Err(wrong(format!("{} leads out of it", path.display())));
        }
    }
    // The mark of its end: without it, files may be missing.
    file.seek(SeekFrom::Start(end))?;
    let mut mark = [1; 2 * BLOCK as usize];
    if file.read_exact(&mut mark).is_err() || mark.iter().any(|byte| *byte != 0) {
        return Err(wrong("its end is missing".to_owned()));
    }
    if !folder.join(LIBRARY).is_file() {
        return Err(wrong("it has no library".to_owned()));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::{AuditEntry, DocumentKind};
    use crate::{Moment, sha256_of_file};

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
        assert!(!to.join("tls").exists());
        // Nothing is overwritten.
        assert!(restore(&archive, &to).is_err());
        // Cut off anywhere it is refused, and nothing is left behind.
        let bytes = fs::read(&archive).unwrap();
        for part in 1..40 {
            let cut = scratch.path().join("cut.tar");
            fs::write(&cut, &bytes[..bytes.len() * part / 50]).unwrap();
            let there = scratch.path().join("there");
            assert!(restore(&cut, &there).is_err(), "{part}");
            assert!(!there.exists());
        }
    }

    /// Whatever an archive says, users are their owner's alone.
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
            assert!(told.contains("whole archive"), "{told}");
            assert!(!scratch.path().join("to").exists());
        }
    }
}
