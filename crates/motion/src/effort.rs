//! The effort that planning may spend on its searches.
//!
//! The thoroughness of the searches is fixed, so that the same job always gives the same motion. A [`Watch`] only
//! limits their duration: motion has no clock, so the caller brings one. Once stopped, an [`Effort`] stays stopped:
//! every search ends early, and planning ends with one finding that reports its progress.

use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, PathRange};
use std::cell::Cell;
use std::fmt;

/// Units of work between two calls of the watch: a unit is about one inverse solution.
const STRIDE: u64 = 64;

/// A search of planning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SearchStage {
    /// Poses along the path are solved for the axes.
    #[default]
    Reach,
    /// Positions of redundant axes are sampled along the path.
    Sampling,
    /// Sampled positions are joined along the path.
    Joining,
    /// The motions of the redundant axes are refined.
    Refining,
    /// The speed profile is planned.
    Speed,
    /// A faster weave is tried.
    Weave,
    /// A transfer move round obstacles is searched.
    Transfer,
    /// Changes that could cure a finding are tried.
    Cure,
    /// Torch angles are tried.
    TorchAngles,
}

impl SearchStage {
    /// Message that names the search.
    pub fn message(self) -> Message {
        Message::new(match self {
            Self::Reach => "motion-search-reach",
            Self::Sampling => "motion-search-sampling",
            Self::Joining => "motion-search-joining",
            Self::Refining => "motion-search-refining",
            Self::Speed => "motion-search-speed",
            Self::Weave => "motion-search-weave",
            Self::Transfer => "motion-search-transfer",
            Self::Cure => "motion-search-cure",
            Self::TorchAngles => "motion-search-torch-angles",
        })
    }
}

impl fmt::Display for SearchStage {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.message().fmt(f)
    }
}

/// Progress of planning.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SearchProgress {
    /// Pass that is planned, counted from 1; 0 before the first.
    pub pass: usize,
    /// Number of passes.
    pub passes: usize,
    /// The search under way.
    pub stage: SearchStage,
    /// Completed fraction of the stage, 0 to 1.
    pub part: f64,
    /// Inverse solutions and tried moves so far, in all passes.
    pub work: u64,
    /// True at the start of a stage: the time since the previous call was spent outside of searches.
    pub begins: bool,
}

/// Reason why planning ends early.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stop {
    /// The searches took longer than this, s.
    OutOfTime(f64),
    /// Its result is no longer wanted.
    Cancelled,
}

/// Decides whether planning goes on: brings a clock, listens for cancellation, shows progress.
pub trait Watch {
    /// Called regularly with the progress made.
    ///
    /// # Errors
    /// The reason to stop planning.
    fn look(&self, progress: &SearchProgress) -> Result<(), Stop>;
}

/// Counts the work of planning's searches and stops them on request of its watch.
pub(crate) struct Effort<'a> {
    watch: Option<&'a dyn Watch>,
    progress: Cell<SearchProgress>,
    unseen: Cell<u64>,
    stop: Cell<Option<Stop>>,
}

impl<'a> Effort<'a> {
    /// Effort under `watch`; without one, searches end by themselves only.
    pub(crate) fn new(watch: Option<&'a dyn Watch>) -> Self {
        Self { watch, progress: Cell::default(), unseen: Cell::new(0), stop: Cell::new(None) }
    }

    pub(crate) fn begin_pass(&self, pass: usize, passes: usize) {
        self.progress.set(SearchProgress { pass, passes, ..self.progress.get() });
    }

    /// Begins a stage. Returns false if planning is stopped.
    pub(crate) fn begin(&self, stage: SearchStage) -> bool {
        if self.is_stopped() {
            return false;
        }
        self.progress.set(SearchProgress { stage, part: 0.0, begins: true, ..self.progress.get() });
        self.look()
    }

    /// Goes back to a stage in which searches with stages of their own are made.
    pub(crate) fn resume(&self, stage: SearchStage) {
        self.progress.set(SearchProgress { stage, ..self.progress.get() });
    }

    /// Counts `work` more units, with `part` (0 to 1) of the stage done. Returns false if planning is stopped.
    pub(crate) fn spend(&self, work: u64, part: f64) -> bool {
        if self.is_stopped() {
            return false;
        }
        let progress = self.progress.get();
        self.progress.set(SearchProgress { work: progress.work + work, part, ..progress });
        self.unseen.set(self.unseen.get() + work);
        self.unseen.get() < STRIDE || self.look()
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.stop.get().is_some()
    }

    pub(crate) fn progress(&self) -> SearchProgress {
        self.progress.get()
    }

    /// Checks that planning of pass `pass`, `length` mm long, was not stopped.
    pub(crate) fn check(&self, pass: usize, length: f64) -> Result<(), Vec<Finding>> {
        self.stop.get().map_or(Ok(()), |stop| Err(vec![self.finding(stop, pass, length)]))
    }

    fn look(&self) -> bool {
        self.unseen.set(0);
        if let Some(watch) = self.watch {
            self.stop.set(watch.look(&self.progress.get()).err());
        }
        self.progress.set(SearchProgress { begins: false, ..self.progress.get() });
        self.stop.get().is_none()
    }

    fn finding(&self, stop: Stop, pass: usize, length: f64) -> Finding {
        let SearchProgress { stage, part, work, .. } = self.progress.get();
        let progress = Message::new("motion-search-progress")
            .message("stage", stage.message())
            .quantity("part", 100.0 * part, Unit::Percent, 0)
            .count("positions", usize::try_from(work).unwrap_or(usize::MAX));
        let (message, cure) = match stop {
            Stop::OutOfTime(limit) => (
                Message::new("motion-search-out-of-time").value("limit", limit, Unit::S),
                Message::new("motion-cure-search"),
            ),
            Stop::Cancelled => (Message::new("motion-search-cancelled"), Message::new("motion-cure-plan-again")),
        };
        Finding::error("search", message.message("progress", progress), pass, PathRange::up_to(length), cure)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    struct StopsAt(u32, Cell<u32>, RefCell<Vec<SearchProgress>>);

    impl Watch for StopsAt {
        fn look(&self, progress: &SearchProgress) -> Result<(), Stop> {
            self.1.set(self.1.get() + 1);
            self.2.borrow_mut().push(*progress);
            if self.1.get() < self.0 { Ok(()) } else { Err(Stop::OutOfTime(5.0)) }
        }
    }

    #[test]
    fn a_stopped_effort_stays_stopped_and_says_how_far_it_came() {
        let watch = StopsAt(3, Cell::new(0), RefCell::default());
        let effort = Effort::new(Some(&watch));
        effort.begin_pass(2, 4);
        assert!(effort.begin(SearchStage::Sampling));
        let steps = (0u32..).take_while(|i| effort.spend(1, f64::from(*i) / 1000.0)).count();
        assert_eq!(steps as u64, 2 * STRIDE - 1);
        assert!(!effort.spend(1, 0.5) && !effort.begin(SearchStage::Refining) && effort.is_stopped());
        assert_eq!(watch.1.get(), 3, "a watch is not asked again after it said stop");
        let looks = watch.2.borrow();
        assert!(looks[0].begins && !looks[1].begins && looks[1].pass == 2 && looks[1].passes == 4);
        let found = effort.check(2, 30.0).unwrap_err();
        assert!(
            found.len() == 1 && found[0].kind == "search" && found[0].message.code == "motion-search-out-of-time",
            "{found:?}"
        );
    }

    #[test]
    fn effort_without_a_watch_never_stops() {
        let effort = Effort::new(None);
        assert!((0..10_000).all(|_| effort.spend(1, 0.0)));
        assert!(effort.check(1, 1.0).is_ok());
    }
}
