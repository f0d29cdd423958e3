//! Files and folders that nobody but their owner reads, whatever the folder that they are in allows.

use std::fs::{DirBuilder, OpenOptions};
use std::path::Path;

/// Makes a folder and those above it, as far as they are missing.
pub(crate) fn folder(path: &Path) -> std::io::Result<()> {
    let mut builder = DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.recursive(true).create(path)
}

/// To open files with; new ones are the owner's alone.
pub(crate) fn options() -> OpenOptions {
    let mut options = OpenOptions::new();
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options
}
