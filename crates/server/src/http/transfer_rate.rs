//! Minimum rate of archives that are sent or received.

use crate::limits::ARCHIVE_RATE_BYTES_PER_S;
use std::time::{Duration, Instant};

/// A transfer that ends if its other side is too slow: for a piece, or in the mean since its start.
#[derive(Debug)]
pub(super) struct Transfer {
    begun: Instant,
    bytes: u64,
    /// Maximum time for a piece, and initial time of the mean.
    patience: Duration,
}

impl Transfer {
    pub(super) fn begin(patience: Duration) -> Self {
        Self { begun: Instant::now(), bytes: 0, patience }
    }

    pub(super) fn moved(&mut self, bytes: usize) {
        self.bytes += bytes as u64;
    }

    /// Returns the time left for the next piece.
    pub(super) fn left(&self) -> Duration {
        self.left_after(self.begun.elapsed())
    }

    fn left_after(&self, elapsed: Duration) -> Duration {
        let whole = self.patience + Duration::from_secs_f64(self.bytes as f64 / ARCHIVE_RATE_BYTES_PER_S as f64);
        whole.saturating_sub(elapsed).min(self.patience)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A byte every 20 s is given up, however short each pause is; a steady transfer goes on for hours.
    #[test]
    fn a_trickle_is_given_up_and_a_steady_transfer_is_not() {
        let patience = Duration::from_secs(30);
        let (mut trickle, mut steady) = (Transfer::begin(patience), Transfer::begin(patience));
        assert_eq!(trickle.left_after(Duration::ZERO), patience);
        let mut ended = None;
        for i in 1..=500 {
            let elapsed = Duration::from_secs(20 * i);
            trickle.moved(1);
            steady.moved(20 * ARCHIVE_RATE_BYTES_PER_S as usize);
            if trickle.left_after(elapsed).is_zero() {
                ended.get_or_insert(elapsed);
            }
            assert_eq!(steady.left_after(elapsed), patience);
        }
        assert_eq!(ended, Some(Duration::from_secs(40)));
    }
}
