//! Events and commands of a crawl.

use crate::work_shape::{FrameEnd, Row, View};
use glam::DVec3;
use seamwright_message::Message;

/// Camera pose: the optical axis passes through `point`, against `normal`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CameraPose {
    /// On the joint, in the work frame, mm.
    pub point: DVec3,
    /// Unit normal of the surface there, out of the work.
    pub normal: DVec3,
    /// Unit direction of the joint.
    pub along: DVec3,
}

/// A frame with its detected midline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen<'a> {
    /// Camera view of the frame.
    pub view: View,
    /// The midline's rows in order.
    pub rows: &'a [Row],
    /// Reason for their end.
    pub end: FrameEnd,
}

/// Answer of the operator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Answer {
    /// The joint continues at this point (mm, work frame), optionally in this direction; the default is that from the
    /// last point.
    Point(DVec3, Option<DVec3>),
    /// The joint ends where it was lost.
    End,
}

/// Input of a crawl.
#[derive(Debug, Clone, PartialEq)]
pub enum Event<'a> {
    /// The crawl starts.
    Start,
    /// The camera has reached its target.
    Reached,
    /// The machine cannot reach the target (limit, zone); description.
    Refused(Message),
    /// A frame was taken and evaluated, from any pose.
    Seen(Seen<'a>),
    /// The operator has answered.
    Operator(Answer),
}

/// Output of a crawl: the next action.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// Move the camera straight to the pose, then send [`Event::Reached`] or [`Event::Refused`].
    Move(CameraPose),
    /// Take a frame, search its midline from [`Crawl::aim`](super::Crawl::aim), then send [`Event::Seen`].
    Look,
    /// Ask the operator for help, with the reason, then send [`Event::Operator`].
    Ask(Message),
    /// Finished.
    Done(End),
}

/// Reason for the end of a crawl.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// The joint ends.
    JointEnd,
    /// The joint has returned to its start.
    Closed {
        /// Distance of the line's end from its start across the joint, mm.
        gap_mm: f64,
    },
    /// The machine cannot go further, and the reason.
    Limit(Message),
    /// The operator ended it.
    Operator,
    /// The joint exceeds the maximum length.
    TooLong,
}
