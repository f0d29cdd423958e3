//! Structured log lines of a running process: events of `tracing` with the code, the arguments and the English words
//! of a message.
//!
//! [`start`] writes them to standard error: as text, as JSON, or for the journal of systemd. A separate thread writes,
//! so nothing waits for a slow reader; lines beyond a queue of fixed size are dropped and counted. A program that uses
//! Seamwright's crates may install its own subscriber of `tracing` instead.
//!
//! The thread of a control cycle must not log: an event allocates.
//!
//! # Examples
//!
//! ```
//! use seamwright_log::{Format, Level, Settings};
//! use seamwright_message::Message;
//!
//! let _logging = seamwright_log::start(Settings { level: Level::Info, format: Some(Format::Json) });
//! seamwright_log::info(&Message::verbatim("the cell starts"));
//! ```

mod event;
mod format;
mod journal;
mod level;
mod queue;

pub use event::{debug, error, event, info, warn};
pub use format::Format;
pub use level::Level;

use format::Lines;
use queue::{Queue, Writer};
use tracing_subscriber::filter::LevelFilter;

/// Settings of the log.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Settings {
    /// The mildest level that is written.
    pub level: Level,
    /// Format of the lines; `None`: for the journal if standard error is connected to it, else text.
    pub format: Option<Format>,
}

/// Logging of this process. Dropping it writes the lines that still wait.
#[derive(Debug)]
pub struct Logging {
    writer: Option<Writer>,
}

impl Drop for Logging {
    fn drop(&mut self) {
        if let Some(writer) = &self.writer {
            writer.flush();
        }
    }
}

/// Starts to write log lines to standard error. Has no effect if the process has a subscriber of `tracing` already.
pub fn start(settings: Settings) -> Logging {
    let format =
        settings.format.unwrap_or_else(|| if journal::is_connected() { Format::Journal } else { Format::Text });
    let Some((queue, writer)) = Queue::to_standard_error(format) else { return Logging { writer: None } };
    let subscriber = tracing_subscriber::fmt()
        .with_max_level(LevelFilter::from_level(settings.level.into()))
        .event_format(Lines { format })
        .with_writer(queue)
        .finish();
    let is_first = tracing::subscriber::set_global_default(subscriber).is_ok();
    Logging { writer: is_first.then_some(writer) }
}
