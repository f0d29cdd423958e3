use super::{Found, Midline};
use seamwright_tracking::teach::{Aim, FrameEnd, Row};
use seamwright_vision::{Frame, RidgeEnd, follow_ridge};

/// The midline by [`follow_ridge`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RidgeFollower {
    /// Longest tack that is coasted over, pixels.
    pub longest_gap_px: f64,
}

impl Midline for RidgeFollower {
    fn find(&mut self, frame: &Frame, aim: &Aim) -> Found {
        let ridge = follow_ridge(frame, aim.start, aim.direction, self.longest_gap_px);
        let rows = ridge.rows.iter().map(|r| Row { px: r.px, confidence: r.confidence, seen: r.seen }).collect();
        let end = match ridge.end {
            RidgeEnd::LeftImage => FrameEnd::LeftImage,
            RidgeEnd::Ended => FrameEnd::JointEnd,
            RidgeEnd::Lost => FrameEnd::Lost,
        };
        Found { rows, end }
    }
}
