//! Inputs that were kept: in `fuzz/regressions/` those that once failed, a file each; in `fuzz/corpus/` those that reach
//! the most code, an archive for each target.

use crate::target::Target;
use flate2::read::GzDecoder;
use std::fs::{self, File};
use std::io::Read as _;
use std::path::PathBuf;

/// An input that was kept.
#[derive(Debug, Clone)]
pub struct KeptInput {
    /// Its file, or its name in the archive.
    pub name: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// A path in the repository.
pub(crate) fn in_repository(path: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "..", "..", path].iter().collect()
}

/// Files of the repository in a folder with this ending, sorted by name.
pub(crate) fn files(folder: &str, ending: &str) -> Vec<Vec<u8>> {
    let folder = in_repository(folder);
    let entries = fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == ending));
    paths.sort();
    paths.iter().map(|path| fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))).collect()
}

/// Returns all kept inputs of a target.
///
/// # Panics
/// If files of the repository cannot be read.
pub fn kept_inputs(target: &Target) -> Vec<KeptInput> {
    let mut inputs: Vec<KeptInput> = Vec::new();
    let folder = in_repository("fuzz/regressions").join(target.name);
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let bytes = fs::read(entry.path()).unwrap_or_else(|e| panic!("{}: {e}", entry.path().display()));
        inputs.push(KeptInput { name: entry.path().display().to_string(), bytes });
    }
    let archive = in_repository("fuzz/corpus").join(format!("{}.tar.gz", target.name));
    if let Ok(file) = File::open(&archive) {
        let mut unpacked = tar::Archive::new(GzDecoder::new(file));
        let unreadable = |e| panic!("{}: {e}", archive.display());
        for entry in unpacked.entries().unwrap_or_else(unreadable) {
            let mut entry = entry.unwrap_or_else(|e| panic!("{}: {e}", archive.display()));
            let name = format!("{}: {}", archive.display(), String::from_utf8_lossy(&entry.path_bytes()));
            let mut bytes = Vec::new();
            entry.read_to_end(&mut bytes).unwrap_or_else(|e| panic!("{name}: {e}"));
            inputs.push(KeptInput { name, bytes });
        }
    }
    inputs.sort_by(|a, b| a.name.cmp(&b.name));
    inputs
}
