use crate::file_store::FileStore;
use seamwright_message::{Message, Unit, display_by_message};
use std::borrow::Cow;
use std::io;
use std::path::{Component, Path, PathBuf};

/// Maximum size of a file that a text from elsewhere names, bytes.
const MAX_BYTES: u64 = 64 << 20;

/// Reason why a file that a text from elsewhere names is not read; within an [`io::Error`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FileRefusal {
    /// Its name leads out of the folder.
    Outside,
    /// A link leads out of the folder.
    LinkOutside,
    /// A folder, pipe or device.
    NotPlain,
    /// Larger than [`MAX_BYTES`].
    TooLarge,
}

impl FileRefusal {
    pub(crate) fn message(&self) -> Message {
        match self {
            Self::Outside => Message::new("project-file-outside"),
            Self::LinkOutside => Message::new("project-link-outside"),
            Self::NotPlain => Message::new("project-not-a-plain-file"),
            Self::TooLarge => {
                Message::new("project-file-above").quantity("max", (MAX_BYTES >> 20) as f64, Unit::MiB, 0)
            }
        }
    }
}

display_by_message!(FileRefusal);

/// Location of the files that a job or a machine file names.
#[derive(Debug, Clone)]
pub(crate) struct FileScope<'a> {
    /// Names are seen from here.
    folder: Cow<'a, Path>,
    store: FileStore,
}

impl<'a> FileScope<'a> {
    /// Names lead anywhere.
    pub(crate) fn open(folder: &'a Path) -> Self {
        Self::of(folder, FileStore::Disk)
    }

    /// Names lead to the files of `store`.
    pub(crate) fn of(folder: &'a Path, store: FileStore) -> Self {
        Self { folder: Cow::Borrowed(folder), store }
    }

    /// Names lead to plain files in `folder` and below.
    pub(crate) fn fenced(folder: &'a Path) -> Self {
        Self::of(folder, FileStore::Fenced(folder.to_owned()))
    }

    /// The same for names in the file at `path`.
    pub(crate) fn beside(&self, path: &Path) -> Self {
        let folder = path.parent().unwrap_or(Path::new(".")).to_owned();
        Self { folder: Cow::Owned(folder), store: self.store.clone() }
    }

    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Source of its files.
    pub(crate) fn store(&self) -> &FileStore {
        &self.store
    }

    /// The bytes of the file called `name`.
    ///
    /// # Errors
    /// As [`FileScope::file`]; a missing or unreadable file.
    pub(crate) fn bytes(&self, name: &str) -> io::Result<Vec<u8>> {
        self.store.bytes(&self.file(name)?)
    }

    /// The file called `name`.
    ///
    /// # Errors
    /// A file outside the fence; with a fence also a missing one.
    pub(crate) fn file(&self, name: &str) -> io::Result<PathBuf> {
        let path = self.folder.join(name);
        let FileStore::Fenced(fence) = &self.store else { return Ok(path) };
        let refused = |why: FileRefusal| Err(io::Error::new(io::ErrorKind::PermissionDenied, why));
        // By its name first: the error must not reveal whether a file outside exists.
        if !Path::new(name).components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)) {
            return refused(FileRefusal::Outside);
        }
        let real = path.canonicalize()?;
        if !real.starts_with(fence.canonicalize()?) {
            return refused(FileRefusal::LinkOutside);
        }
        // Pipes and devices are refused: reading them may block for ever.
        let about = real.metadata()?;
        match about.len() {
            _ if !about.is_file() => refused(FileRefusal::NotPlain),
            size if size > MAX_BYTES => refused(FileRefusal::TooLarge),
            _ => Ok(real),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn names_stay_within_the_fence() {
        let scratch = tempfile::tempdir().unwrap();
        let jobs = scratch.path().join("jobs");
        fs::create_dir_all(jobs.join("machines")).unwrap();
        for file in ["jobs/a.csv", "jobs/machines/b.stl", "users.json"] {
            fs::write(scratch.path().join(file), "x").unwrap();
        }
        fs::File::create(jobs.join("large.stl")).unwrap().set_len(MAX_BYTES + 1).unwrap();
        let within = FileScope::fenced(&jobs);
        for good in ["a.csv", "./a.csv", "machines/b.stl"] {
            assert!(within.file(good).unwrap().is_file(), "{good}");
        }
        let outside = scratch.path().join("users.json");
        let mut bad = vec!["../users.json", "machines/../a.csv", "..", "/etc/passwd", "/dev/zero", "", ".", "machines"];
        bad.extend(["large.stl", "not there", "a.csv/x", "a\0b", outside.to_str().unwrap()]);
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(&outside, jobs.join("link.csv")).unwrap();
            std::os::unix::fs::symlink("/", jobs.join("root")).unwrap();
            bad.extend(["link.csv", "root/etc/passwd"]);
        }
        for bad in bad {
            assert!(within.file(bad).is_err(), "{bad}");
        }
        // A machine file in a folder of its own sees its own files, and no others.
        let beside = within.beside(&jobs.join("machines/m.toml"));
        assert!(beside.file("b.stl").is_ok() && beside.file("../a.csv").is_err());
        assert!(beside.file("../../users.json").is_err());
        // Existing and missing files outside give the same message.
        let (there, not) = (within.file("../users.json").unwrap_err(), within.file("../nobody.json").unwrap_err());
        assert_eq!(there.to_string(), not.to_string());
        // Without a fence all files can be named.
        assert!(FileScope::open(&jobs).file("../users.json").unwrap().is_file());
    }
}
