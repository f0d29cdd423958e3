//! Files that jobs, machines and tables name: on the disk, within a folder of it, or carried to a computer that does not
//! have them.

use crate::failure::Failure;
use crate::files::unreadable;
use std::collections::BTreeMap;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// Source of files by path. Names in texts become paths in `FileScope`, which keeps the fence.
#[derive(Debug, Clone, Default)]
pub enum FileStore {
    /// The disk.
    #[default]
    Disk,
    /// Plain files in a folder and below: the author of the text may not read others.
    Fenced(PathBuf),
    /// Copies, by the paths under which the author of a job sees them; there are no other files.
    Carried(Arc<BTreeMap<PathBuf, Vec<u8>>>),
}

impl FileStore {
    /// A store with these files.
    pub fn carrying(files: impl IntoIterator<Item = (PathBuf, Vec<u8>)>) -> Self {
        Self::Carried(Arc::new(files.into_iter().map(|(path, bytes)| (plain(&path), bytes)).collect()))
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// A missing or unreadable file.
    pub fn bytes(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self {
            Self::Disk | Self::Fenced(_) => std::fs::read(path),
            Self::Carried(files) => files.get(&plain(path)).cloned().ok_or_else(missing),
        }
    }

    /// The text of a file.
    ///
    /// # Errors
    /// A missing or unreadable file, or one that is no text.
    pub fn text(&self, path: &Path) -> Result<String, Failure> {
        let text = match self {
            Self::Disk | Self::Fenced(_) => std::fs::read_to_string(path),
            Self::Carried(_) => self.bytes(path).and_then(|bytes| {
                String::from_utf8(bytes).map_err(|e| io::Error::new(io::ErrorKind::InvalidData, e.utf8_error()))
            }),
        };
        text.map_err(|e| unreadable(&path.display().to_string(), &e))
    }

    /// True if the file is there.
    pub fn has(&self, path: &Path) -> bool {
        match self {
            Self::Disk | Self::Fenced(_) => path.is_file(),
            Self::Carried(files) => files.contains_key(&plain(path)),
        }
    }
}

/// The error of a missing file, with the words of the system: faults of rows are the same wherever they are planned.
fn missing() -> io::Error {
    /// `ENOENT`, on all systems that this program runs on.
    const NO_ENTRY: i32 = 2;
    io::Error::from_raw_os_error(NO_ENTRY)
}

/// The path without `.` and `..`, as far as its words decide it.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(plain.components().next_back(), Some(Component::Normal(_))) => {
                plain.pop();
            }
            part => plain.push(part),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carried_files_are_found_as_on_the_disk() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("a.toml"), "a = 1\n").unwrap();
        let stores = [FileStore::Disk, FileStore::carrying([(at("./a.toml"), b"a = 1\n".to_vec())])];
        for name in ["a.toml", "./a.toml", "b/../a.toml", "b.toml", ""] {
            let [disk, carried] =
                stores.each_ref().map(|store| (store.has(&at(name)), store.text(&at(name)).map_err(|e| e.text())));
            // Only the disk knows that `b` is missing.
            if name.starts_with("b/") {
                assert!(carried.0, "{name}");
            } else if name.is_empty() {
                assert!(!carried.0 && carried.1.is_err());
            } else {
                assert_eq!(disk, carried, "{name}");
            }
        }
    }
}
