use super::options::Feed;
use super::writer::Writer;
use crate::part_program::{Arc, Move};

/// Feed mode of the control, and the last feed that stays in force.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub(super) struct FeedMode {
    /// Whether feeds are in inverse time, if this pass has set the mode.
    pub(super) inverse: Option<bool>,
    /// The last feed per minute.
    feed: Option<f64>,
}

impl FeedMode {
    /// Returns the words needed before a move: the mode, if it changes, and the feed. In inverse time every block needs its own.
    pub(super) fn words_before(
        &mut self,
        w: &Writer,
        step: &Move,
        arc: Option<&Arc>,
        to: &[f64],
    ) -> (Option<&'static str>, Option<f64>) {
        let per_minute = if w.options.feed == Feed::PerMinute { w.feed(step, arc, to) } else { None };
        let inverse = per_minute.is_none();
        let mode = (self.inverse != Some(inverse)).then_some(if inverse { "G93" } else { "G94" });
        if mode.is_some() {
            *self = Self { inverse: Some(inverse), feed: None };
        }
        let feed = match per_minute {
            None => Some(60.0 / step.seconds),
            feed if self.feed == feed => None,
            feed => {
                self.feed = feed;
                feed
            }
        };
        (mode, feed)
    }
}
