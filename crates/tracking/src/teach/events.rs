//! What goes into a crawl and what comes out of it.

use super::sight::{FrameEnd, Row, View};
use glam::DVec3;

/// Where the eye goes: its optical axis through `point`, against `normal`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EyePose {
    /// On the joint, in the work frame, mm.
    pub point: DVec3,
    /// Unit normal of the surface there, out of the work.
    pub normal: DVec3,
    /// Unit direction of the joint.
    pub along: DVec3,
}

/// A frame with the midline that was found in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen<'a> {
    /// From where it was taken.
    pub view: View,
    /// The midline's rows in order.
    pub rows: &'a [Row],
    /// Why they end.
    pub end: FrameEnd,
}

/// What the operator says when asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Answer {
    /// The joint goes on here (mm, work frame), perhaps in this direction; otherwise in that from where it was lost.
    Point(DVec3, Option<DVec3>),
    /// The joint ends where it was lost.
    End,
}

/// What happens to a crawl.
#[derive(Debug, Clone, PartialEq)]
pub enum Event<'a> {
    /// It begins.
    Start,
    /// The eye is where it was sent.
    Reached,
    /// The machine cannot go there: a limit, a zone; in words.
    Refused(String),
    /// A frame was taken and looked at, from wherever it was taken.
    Seen(Seen<'a>),
    /// The operator has answered.
    Operator(Answer),
}

/// What the crawl wants next.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// The eye there, straight; then [`Event::Reached`] or [`Event::Refused`].
    Move(EyePose),
    /// A frame; then [`Event::Seen`], its midline looked for where [`Crawl::aim`](super::Crawl::aim) says.
    Look,
    /// The operator's help, and why; then [`Event::Operator`].
    Ask(String),
    /// Nothing more.
    Done(End),
}

/// Why a crawl has ended.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// The joint ends.
    JointEnd,
    /// It has come back to its start.
    Closed {
        /// Distance of the line's end from its start across the joint, mm.
        gap_mm: f64,
    },
    /// The machine can go no further, and why.
    Limit(String),
    /// The operator said so.
    Operator,
    /// The joint is longer than any.
    TooLong,
}
