//! Time, cancellation and progress of planning.

use seamwright_motion::{SearchProgress, Stop, Watch};
use std::cell::Cell;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Limits on planning's searches, and the display of their progress.
#[derive(Clone, Copy)]
pub struct Planning<'a> {
    /// Time limit of all searches of a plan together; `None` for no limit.
    pub limit: Option<Duration>,
    /// Set to cancel the plan.
    pub cancel: Option<&'a AtomicBool>,
    /// Shown the progress, a few hundred times a second.
    pub progress: Option<&'a dyn Fn(&SearchProgress)>,
}

impl Planning<'_> {
    /// Default time limit of all searches.
    pub const LIMIT: Duration = Duration::from_secs(60);
}

impl Default for Planning<'_> {
    fn default() -> Self {
        Self { limit: Some(Self::LIMIT), cancel: None, progress: None }
    }
}

/// Planning under the clock. Time between searches, as for the speed profile, does not count against the limit.
pub(crate) struct Clocked<'a> {
    planning: &'a Planning<'a>,
    spent: Cell<Duration>,
    last: Cell<Instant>,
}

impl<'a> Clocked<'a> {
    /// Searches under `planning`, of whose limit `spent` is gone.
    pub(crate) fn new(planning: &'a Planning<'a>, spent: Duration) -> Self {
        Self { planning, spent: Cell::new(spent), last: Cell::new(Instant::now()) }
    }

    /// Time spent by searches.
    pub(crate) fn spent(&self) -> Duration {
        self.spent.get()
    }

    pub(crate) fn is_cancelled(&self) -> bool {
        self.planning.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed))
    }
}

impl Watch for Clocked<'_> {
    fn look(&self, progress: &SearchProgress) -> Result<(), Stop> {
        if self.is_cancelled() {
            return Err(Stop::Cancelled);
        }
        let now = Instant::now();
        if !progress.begins {
            self.spent.set(self.spent.get() + now.duration_since(self.last.get()));
        }
        self.last.set(now);
        if let Some(show) = self.planning.progress {
            show(progress);
        }
        match self.planning.limit {
            Some(limit) if self.spent.get() > limit => Err(Stop::OutOfTime(limit.as_secs_f64())),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::failure::Failure;
    use crate::load::load;
    use std::path::Path;

    /// An arm: its search takes a while.
    const ARM: &str = "../../tests/data/field-trial/u3.toml";

    #[test]
    fn a_plan_that_is_no_longer_wanted_is_cancelled() {
        let loaded = load(Path::new(ARM)).unwrap();
        let cancel = AtomicBool::new(false);
        let looks = Cell::new(0u32);
        let show = |_: &SearchProgress| {
            looks.set(looks.get() + 1);
            cancel.store(looks.get() >= 3, Ordering::Relaxed);
        };
        let planning = Planning { limit: None, cancel: Some(&cancel), progress: Some(&show) };
        let planned = loaded.try_plan_under(&loaded.machine, &planning);
        assert!(matches!(planned, Err(Failure::Cancelled)));
        assert_eq!(looks.get(), 3);
    }

    #[test]
    fn a_plan_that_takes_too_long_ends_with_a_finding() {
        let loaded = load(Path::new(ARM)).unwrap();
        let planning = Planning { limit: Some(Duration::from_millis(1)), ..Planning::default() };
        let Err(findings) = loaded.try_plan_under(&loaded.machine, &planning).unwrap() else { panic!("planned") };
        assert!(
            findings.iter().any(|f| f.kind == "search" && f.message.to_string().contains("no plan within")),
            "{findings:?}"
        );
    }
}
