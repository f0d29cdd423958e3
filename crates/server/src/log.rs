//! Log lines on standard error, each with its time and level.
//!
//! A separate thread writes them, so callers never wait for standard error. Lines beyond [`MAX_WAITING`] are dropped
//! and counted.

use seamwright_record::Moment;
use std::io::Write as _;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

/// Maximum number of queued lines.
const MAX_WAITING: usize = 256;

static LINES: OnceLock<Option<SyncSender<String>>> = OnceLock::new();
static LEFT_OUT: AtomicU64 = AtomicU64::new(0);

/// Logs a routine event: start, end, login.
pub(crate) fn info(text: &str) {
    line("INFO", text);
}

pub(crate) fn warning(text: &str) {
    line("WARN", text);
}

fn line(level: &str, text: &str) {
    let to = LINES.get_or_init(|| {
        let (to, from) = sync_channel(MAX_WAITING);
        let writer = std::thread::Builder::new().name("panel-log".to_owned()).spawn(move || write(&from));
        writer.ok().map(|_| to)
    });
    let line = format!("{} {level} {text}\n", Moment::now());
    if to.as_ref().is_none_or(|to| to.try_send(line).is_err()) {
        LEFT_OUT.fetch_add(1, Ordering::Relaxed);
    }
}

fn write(from: &Receiver<String>) {
    for line in from {
        let left_out = LEFT_OUT.swap(0, Ordering::Relaxed);
        let gap = if left_out > 0 {
            format!("{} WARN {left_out} lines were left out\n", Moment::now())
        } else {
            String::new()
        };
        // A failed write is ignored: logging stops nothing.
        let _ = std::io::stderr().lock().write_all(format!("{gap}{line}").as_bytes());
    }
}
