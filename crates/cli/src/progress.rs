use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use seamwright_message::Message;
use seamwright_motion::SearchProgress;
use std::time::Duration;

/// A progress bar on standard error: only on a terminal, and only for work that takes a while.
pub(crate) struct Progress {
    bar: ProgressBar,
    count: u64,
}

/// Steps of a bar that shows a part.
const PER_MILLE: u64 = 1000;
/// Steps between updates, so that the cost of the bar is negligible.
const STRIDE: u64 = 4096;

impl Progress {
    /// For `total` steps of the work that the words of `code` name.
    pub(crate) fn new(code: &'static str, total: u64) -> Self {
        Self::with_template(code, total, "{msg} {wide_bar} {percent}% {eta}")
    }

    /// The same, also with the number of steps done and their rate.
    pub(crate) fn with_rate(code: &'static str, total: u64) -> Self {
        Self::with_template(code, total, "{msg} {wide_bar} {pos}/{len} {per_sec} {eta}")
    }

    fn with_template(code: &'static str, total: u64, template: &str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr_with_hz(10));
        // Templates are fixed; were one wrong, the plain bar would do.
        let style = ProgressStyle::with_template(template);
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.set_message(Message::new(code).to_string());
        bar.enable_steady_tick(Duration::from_millis(500));
        Self { bar, count: 0 }
    }

    pub(crate) fn of_searches() -> Self {
        Self::new("cli-progress-planning", PER_MILLE)
    }

    /// Shows how far a search has come.
    pub(crate) fn searched(&self, progress: &SearchProgress) {
        let SearchProgress { pass, passes, stage, part, begins, .. } = progress;
        if *begins {
            let message = Message::new("cli-progress-pass").pass("pass", *pass).pass("passes", *passes);
            self.bar.set_message(message.message("stage", stage.message()).to_string());
        }
        self.bar.set_position((part * PER_MILLE as f64) as u64);
    }

    pub(crate) fn at(&self, count: u64) {
        self.bar.set_position(count);
    }

    /// `count` more steps done, each of which takes a while.
    pub(crate) fn all(&self, count: u64) {
        self.bar.inc(count);
    }

    /// Calls `does`, which writes to the terminal, with the bar hidden.
    pub(crate) fn aside<R>(&self, does: impl FnOnce() -> R) -> R {
        self.bar.suspend(does)
    }

    pub(crate) fn step(&mut self) {
        self.count += 1;
        if self.count.is_multiple_of(STRIDE) {
            self.bar.set_position(self.count);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
