//! The rules of `deny.toml` on this repository, and on packages that violate them.

mod command;
mod repository;
mod violations;

use std::path::{Path, PathBuf};

/// The repository's root.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
