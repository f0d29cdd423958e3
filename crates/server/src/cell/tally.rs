use crate::diagnostics::LatencyHistogram;
use crate::wire::QueueView;
use seamwright_executive::realtime::{QueueFill, Shown};

/// Lateness of the cycles so far, and fill of the queues to and from the cycle.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tally {
    pub(crate) latency: LatencyHistogram,
    /// Fill in the last report, and the maximum so far; empty before the first report.
    queues: Vec<(QueueFill, usize)>,
}

impl Tally {
    pub(super) fn cycle(&mut self, shown: &Shown) {
        self.latency.add(shown.reports.late_ns);
    }

    /// Takes a report of the fill of the queues.
    pub(super) fn queue_fill(&mut self, queues: Vec<QueueFill>) {
        let most = |fill: &QueueFill| {
            let before = self.queues.iter().find(|(before, _)| before.name == fill.name);
            fill.waiting.max(before.map_or(0, |(_, most)| *most))
        };
        self.queues = queues.into_iter().map(|fill| (most(&fill), fill)).map(|(most, fill)| (fill, most)).collect();
    }

    pub(crate) fn queues(&self) -> Vec<QueueView> {
        let view = |(fill, most): &(QueueFill, usize)| QueueView {
            name: fill.name.to_string(),
            waiting: fill.waiting,
            most: Some(*most),
            capacity: fill.capacity,
        };
        self.queues.iter().map(view).collect()
    }
}
