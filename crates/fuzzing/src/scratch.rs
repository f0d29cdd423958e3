use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use tempfile::TempDir;

/// A folder for readers of files, the same for the whole process. It stays at its end: the starter of the process sets
/// `TMPDIR` to a folder that it removes.
static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    TempDir::with_prefix("seamwright-fuzz-").map(TempDir::keep).unwrap_or_else(|e| panic!("no temporary folder: {e}"))
});

/// An empty folder, for texts that may name files in it.
pub(crate) fn empty_folder() -> &'static Path {
    static EMPTY: LazyLock<PathBuf> = LazyLock::new(|| folder("empty"));
    &EMPTY
}

/// A folder of this name, made if missing.
pub(crate) fn folder(name: &str) -> PathBuf {
    let path = FOLDER.join(name);
    std::fs::create_dir_all(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    path
}

/// Writes a new file: cutting down an old one waits for the disk on some systems.
pub(crate) fn write(path: &Path, bytes: &[u8]) {
    let _ = std::fs::remove_file(path);
    std::fs::write(path, bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
}
