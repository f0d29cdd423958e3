//! Observation of the running server and its cell: counts, state of disk and memory, readiness, metrics.
//!
//! [`view()`] gathers everything for the page *Diagnostics* and for `/metrics`. It neither waits for a disk nor for the
//! cycle: the cycle's numbers come through the desk, and a thread of its own looks at the disk. So monitoring is
//! answered while a disk hangs.

mod counts;
mod disk_probe;
mod latency_histogram;
mod metrics;
mod process_memory;
mod readiness;
mod view;

pub(crate) use counts::{Counts, Ended, WorkerCounts, WorkerEnd};
pub(crate) use latency_histogram::LatencyHistogram;
pub(crate) use metrics::text as metrics_text;
pub(crate) use readiness::{log_changes as log_readiness, reasons as not_ready};
pub(crate) use view::view;

#[cfg(test)]
pub(crate) use metrics::tests::{Family, parse};

use disk_probe::DiskProbe;
use std::path::Path;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

/// Metrics are made anew at most once in this time: many requests cost little.
const FRESH: Duration = Duration::from_millis(200);

/// Counts and observations of the server beside the cell.
pub(crate) struct Diagnostics {
    pub(crate) counts: Arc<Counts>,
    pub(crate) started: Instant,
    /// Token of monitoring tools without a session on other computers.
    pub(crate) token: Option<String>,
    disk: OnceLock<DiskProbe>,
    printed: Mutex<Option<(Instant, Arc<str>)>>,
}

impl Default for Diagnostics {
    fn default() -> Self {
        static STARTED: OnceLock<Instant> = OnceLock::new();
        Self {
            counts: Arc::default(),
            // A restore makes new diagnostics in the same process.
            started: *STARTED.get_or_init(Instant::now),
            token: None,
            disk: OnceLock::new(),
            printed: Mutex::default(),
        }
    }
}

impl Diagnostics {
    /// Starts to look at the disk of a data folder.
    pub(crate) fn watch_disk(&self, folder: &Path) {
        self.disk.get_or_init(|| DiskProbe::start(folder));
    }

    /// Ends looking at the disk and closes the library there. Returns false if the disk hangs.
    pub(crate) fn close(&self) -> bool {
        self.disk.get().is_none_or(DiskProbe::close)
    }

    /// Returns the metrics of a moment ago, or makes them.
    pub(crate) fn printed(&self, make: impl FnOnce() -> String) -> Arc<str> {
        let mut printed = self.printed.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((at, text)) = &*printed
            && at.elapsed() < FRESH
        {
            return Arc::clone(text);
        }
        let text: Arc<str> = make().into();
        *printed = Some((Instant::now(), Arc::clone(&text)));
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A flood of requests makes the metrics a few times a second.
    #[test]
    fn many_requests_cost_little() {
        let (diagnostics, mut made, begun) = (Diagnostics::default(), 0, Instant::now());
        for _ in 0..10_000 {
            let _ = diagnostics.printed(|| {
                made += 1;
                String::new()
            });
        }
        let most = 1 + begun.elapsed().as_millis() / FRESH.as_millis();
        assert!(made >= 1 && made <= most, "{made} {most}");
    }
}
