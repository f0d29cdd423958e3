use super::answer::Refused;
use super::turns::Turns;
use axum::body::Bytes;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::borrow::Cow;
use std::collections::HashMap;
use std::io::Write as _;
use std::sync::{Arc, Mutex, PoisonError};
use tokio::sync::OnceCell;

/// Compressed files by tag; all are small beside the program. Each is compressed once, however many pages open at once:
/// the first thing a page shows is its STOP button.
pub(crate) struct Compressed {
    files: Mutex<HashMap<String, Arc<OnceCell<Bytes>>>>,
    turns: Turns,
}

impl Default for Compressed {
    fn default() -> Self {
        Self { files: Mutex::default(), turns: Turns::new(1, MAX_FILES) }
    }
}

impl Compressed {
    pub(super) fn cell(&self, tag: &str) -> Arc<OnceCell<Bytes>> {
        let mut files = self.files.lock().unwrap_or_else(PoisonError::into_inner);
        Arc::clone(files.entry(tag.to_owned()).or_default())
    }

    /// Returns the compressed file of a tag, whose contents are `data`.
    pub(super) async fn of(&self, tag: &str, data: Cow<'static, [u8]>) -> Result<Bytes, Refused> {
        let make = async || {
            let made = move || gzip(&data).map_err(|e| Refused::server(e.to_string()));
            self.turns.run(made).await.map(Bytes::from)
        };
        self.cell(tag).get_or_try_init(make).await.cloned()
    }
}

/// Maximum number of files that wait for compression: more than exist.
pub(super) const MAX_FILES: usize = 4096;

pub(super) fn gzip(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    encoder.finish()
}
