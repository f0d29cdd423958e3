//! Traffic with a device.

use super::robot::MeasuredLatency;
use crate::realtime::Latency;
use seamwright_message::Message;
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::sync::{Arc, Mutex, PoisonError};
use triple_buffer::{Input, Output, triple_buffer};

/// Traffic with a device since the connection.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Traffic {
    /// Answered polls.
    pub polls: u64,
    /// Polls skipped in spite of a connection, because the previous one took too long.
    pub missed: u64,
    /// Refused or unanswered polls.
    pub failed: u64,
    /// Connections made.
    pub connections: u32,
    /// Time without a connection, s.
    pub away_s: f64,
    /// Duration of a poll, from its first request to its last answer.
    pub round: Latency,
    /// Of a robot: the time from a set-point until a report shows it, once it is measured.
    pub latency: Option<MeasuredLatency>,
    /// Last trouble.
    pub trouble: Option<Message>,
    /// At the end: whether the device has accepted the safe states of its outputs, or why not.
    pub safe: Option<Result<(), Message>>,
}

/// A view of the traffic for threads other than the cycle. Readers lock among themselves; the client never waits.
#[derive(Debug, Clone)]
pub struct TrafficView(Arc<Mutex<Output<Traffic>>>);

impl TrafficView {
    /// The traffic so far.
    pub fn get(&self) -> Traffic {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).read().clone()
    }
}

/// The client's end: it has real-time priority, so it publishes without a lock.
#[derive(Debug)]
pub(crate) struct TrafficLog(RefCell<(Traffic, Input<Traffic>)>);

impl TrafficLog {
    /// Creates an empty log and its view.
    pub(crate) fn new() -> (Self, TrafficView) {
        let (input, output) = triple_buffer(&Traffic::default());
        (Self(RefCell::new((Traffic::default(), input))), TrafficView(Arc::new(Mutex::new(output))))
    }

    pub(crate) fn change(&self, change: impl FnOnce(&mut Traffic)) {
        let (traffic, shown) = &mut *self.0.borrow_mut();
        change(traffic);
        shown.input_buffer_mut().clone_from(traffic);
        shown.publish();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slow reader does not block the client, and sees its records afterwards.
    #[test]
    fn the_client_does_not_wait_for_readers() {
        let (log, view) = TrafficLog::new();
        log.change(|t| t.polls = 1);
        let mut reads = view.0.lock().unwrap();
        assert_eq!(reads.read().polls, 1);
        log.change(|t| t.polls = 2);
        log.change(|t| t.safe = Some(Ok(())));
        drop(reads);
        assert_eq!((view.get().polls, view.get().safe), (2, Some(Ok(()))));
    }
}
