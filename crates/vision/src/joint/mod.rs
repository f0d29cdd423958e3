//! Joint detection: a dark line on lighter metal (EBW-2004), followed from a point on it in a rough direction.
//!
//! 1. Trail: on a level of the image pyramid (`levels`) the joint is a few pixels wide. Strips along the predicted,
//!    curved axis are unrolled there (`axis`, `strip`). The best path across their rows (`lattice`) gives the joint to
//!    a pixel or two (`trail`).
//! 2. Midline: a second pass along the whole trail finds the best path and its margin over other paths. It then finds
//!    the middle between pixels (`profile`, `readings`, `midline`).
//! 3. The end of the joint (`end`) and the confidence of each row (`confidence`) follow. Unconfident rows of wide gaps are
//!    placed between the rims (`rims`).
//! 4. A lost joint is followed again with the edges of light removed (`again`, `top_hat`). It is also followed
//!    straight on behind the point where another line led it aside (`straight_on`).

mod axis;
mod bend;
mod confidence;
mod end;
mod follow;
mod lattice;
mod levels;
mod midline;
mod noise;
mod parabola;
mod profile;
mod readings;
mod rims;
mod sample;
mod second_attempt;
mod sliding_parabola;
mod straight_on;
mod strip;
#[cfg(test)]
mod testing;
mod top_hat;
mod trail;

pub use follow::Follower;

/// Reserves capacity for `count` elements in all, so that later frames do not allocate.
fn make_room<T>(list: &mut Vec<T>, count: usize) {
    list.reserve(count.saturating_sub(list.len()));
}

/// Minimum confidence of a confident row.
pub const CONFIDENT: f32 = 0.5;

/// Zone of the frame in which the joint may be detected, pixels; its borders belong to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zone {
    /// Left border.
    pub left: f32,
    /// Upper border.
    pub top: f32,
    /// Right border.
    pub right: f32,
    /// Lower border.
    pub bottom: f32,
}

/// Options of a [`Follower`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options {
    /// Maximum stretch without a visible joint (a tack weld) that is coasted over, pixels; `None`: a fifth of the
    /// frame's shorter side.
    pub gap: Option<f32>,
    /// Maximum path length, pixels; `None`: twice the frame's width and height together.
    pub length: Option<f32>,
    /// Detection zone; `None`: the whole frame.
    pub zone: Option<Zone>,
    /// The start is known to lie on the joint, so a short line is not taken for a scratch.
    pub on_joint: bool,
}

/// Point and direction from which a joint is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    /// X of a point on the joint, pixels to the right.
    pub x: f32,
    /// Y of the point, pixels down.
    pub y: f32,
    /// Rough direction, rad, from x to y (clockwise as seen).
    pub direction: f32,
    /// Full width at half depth, pixels, if known.
    pub width: Option<f32>,
}

/// Detection state of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// The joint is visible.
    Seen,
    /// The joint is not visible; the line continues without it.
    Coasted,
}

/// A point of the midline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// X, pixels to the right.
    pub x: f32,
    /// Y, pixels down.
    pub y: f32,
    /// 0 to 1; see [`CONFIDENT`].
    pub confidence: f32,
    /// Full width at half depth, pixels.
    pub width: f32,
    /// Seen or coasted.
    pub state: State,
}

impl Row {
    /// Returns the distance to another row, pixels.
    fn away(&self, other: &Self) -> f32 {
        axis::length([other.x - self.x, other.y - self.y])
    }
}

/// Reason why the following of a joint stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The joint leaves the frame or the zone, or the maximum length is reached.
    LeftImage,
    /// The joint ends: a clear line stops and clear metal follows.
    JointEnd,
    /// The joint returns to its start.
    Closed,
    /// The joint is not visible any more, or never was.
    Lost,
}

/// The midline of the joint found in a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Rows in order, about a pixel apart, or up to a third of the width of a wide joint.
    pub rows: Vec<Row>,
    /// Reason why the following stopped.
    pub end: End,
}
