use crate::diagnostics::LatencyHistogram;
use crate::wire::QueueView;
use seamwright_executive::realtime::{Outside, QueueFill, Shown};

/// Lateness of the cycles so far, and fill of the queues to and from the cycle.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tally {
    pub(crate) latency: LatencyHistogram,
    /// Fill at the last look, and the maximum so far; `None` before the first look.
    queues: Option<[(QueueFill, usize); 3]>,
}

impl Tally {
    pub(super) fn cycle(&mut self, shown: &Shown) {
        self.latency.add(shown.reports.late_ns);
    }

    /// Looks at the queues before they are emptied.
    pub(super) fn look(&mut self, outside: &Outside) {
        let mut queues = outside.queues().map(|fill| (fill, fill.waiting));
        for ((_, most), (_, before)) in queues.iter_mut().zip(self.queues.iter().flatten()) {
            *most = (*most).max(*before);
        }
        self.queues = Some(queues);
    }

    pub(crate) fn queues(&self) -> Vec<QueueView> {
        let view = |(fill, most): &(QueueFill, usize)| QueueView {
            name: fill.name.to_owned(),
            waiting: fill.waiting,
            most: Some(*most),
            capacity: fill.capacity,
        };
        self.queues.iter().flatten().map(view).collect()
    }
}
