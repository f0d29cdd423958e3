/// The cell's clock. It counts servo periods, missed ones included.
#[derive(Debug)]
pub(super) struct Clock {
    cycles: u64,
    period_s: f64,
    /// Duration of the last cycle with the missed ones before it, s.
    last_s: f64,
}

impl Clock {
    pub(super) fn new(period_s: f64) -> Self {
        Self { cycles: 0, period_s, last_s: period_s }
    }

    /// Returns the time since the start, s.
    pub(super) fn now(&self) -> f64 {
        self.cycles as f64 * self.period_s
    }

    /// Counts a cycle, and the `missed` ones before it.
    pub(super) fn advance(&mut self, missed: u32) {
        let passed = 1 + u64::from(missed);
        self.cycles += passed;
        self.last_s = passed as f64 * self.period_s;
    }

    /// Returns the duration of the last cycle, missed ones before it included, s.
    pub(super) fn last_s(&self) -> f64 {
        self.last_s
    }
}

/// Maximum time until the axes are at rest, s: then the power is switched off and the brakes hold.
pub(super) const REST_S: f64 = 3.0;

/// Measures the time since the start of a stop.
#[derive(Debug, Default)]
pub(super) struct StopTimer {
    since_s: Option<f64>,
}

impl StopTimer {
    /// Returns the time since the first call, s.
    pub(super) fn elapsed(&mut self, now: f64) -> f64 {
        now - *self.since_s.get_or_insert(now)
    }

    pub(super) fn runs(&self) -> bool {
        self.since_s.is_some()
    }
}
