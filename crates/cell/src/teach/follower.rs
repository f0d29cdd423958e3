use super::{Found, Midline};
use seamwright_tracking::teach::{Aim, FrameEnd, Row};
use seamwright_vision::Frame;
use seamwright_vision::joint::{End, Follower, Options, Start, State};

/// The midline by the guided follower of `vision::joint`.
#[derive(Debug, Clone)]
pub struct JointFollower {
    follower: Follower,
}

impl JointFollower {
    /// A follower over tacks of up to `longest_gap_px` pixels.
    #[must_use]
    pub fn new(longest_gap_px: f64) -> Self {
        let gap = Some(longest_gap_px as f32);
        Self { follower: Follower::new(Options { gap, on_joint: true, ..Options::default() }) }
    }
}

impl Midline for JointFollower {
    fn find(&mut self, frame: &Frame, aim: &Aim) -> Found {
        let direction = aim.direction.to_angle() as f32;
        let start = Start { x: aim.start.x as f32, y: aim.start.y as f32, direction, width: None };
        let joint = self.follower.follow(frame, &start);
        let row = |r: &seamwright_vision::joint::Row| Row {
            px: glam::DVec2::new(f64::from(r.x), f64::from(r.y)),
            confidence: f64::from(r.confidence),
            seen: r.state == State::Seen,
        };
        let end = match joint.end {
            End::LeftImage => FrameEnd::LeftImage,
            End::JointEnd => FrameEnd::JointEnd,
            End::Closed => FrameEnd::Closed,
            End::Lost => FrameEnd::Lost,
        };
        Found { rows: joint.rows.iter().map(row).collect(), end }
    }
}
