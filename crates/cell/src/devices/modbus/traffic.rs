use crate::realtime::Latency;
use std::sync::{Arc, Mutex, PoisonError};

/// What went over the line to a device since it was connected.
#[derive(Debug, Clone, Default)]
pub struct Traffic {
    /// Polls that were answered.
    pub polls: u64,
    /// Polls left out while there was a connection, because the one before took too long.
    pub missed: u64,
    /// Polls that were refused or not answered.
    pub failed: u64,
    /// Connections made.
    pub connections: u32,
    /// Time without a connection, s.
    pub away_s: f64,
    /// How long a poll took, from its first request to its last answer.
    pub round: Latency,
    /// What went wrong last.
    pub trouble: Option<String>,
    /// At the end: whether the device has taken the safe states of its outputs, or why not.
    pub safe: Option<Result<(), String>>,
}

/// A view of the traffic, for whoever is not the cycle: it takes a lock.
#[derive(Debug, Clone, Default)]
pub struct TrafficView(Arc<Mutex<Traffic>>);

impl TrafficView {
    /// The traffic so far.
    pub fn get(&self) -> Traffic {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    pub(super) fn change(&self, change: impl FnOnce(&mut Traffic)) {
        change(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner));
    }
}
