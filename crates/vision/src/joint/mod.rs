//! The joint in a frame: a dark line on lighter metal (EBW-2004), followed from a point on it in a rough direction.
//!
//! On the level of the halved frame on which the joint is a few pixels wide (`levels`), strips along the predicted,
//! curved axis are unrolled (`axis`, `strip`) and the best path across their rows is taken (`lattice`): the way the joint
//! goes, to a pixel or two (`trail`). Along all of that way once more: the best path by everything that is seen, how much
//! worse any other is, and the middle between pixels (`profile`, `readings`, `midline`); then where the joint ends (`end`) and how
//! sure each row is (`judge`); rows of wide gaps that are not sure are put between the rims (`rims`). A joint that is seen no longer is
//! followed once more where the edges of light are gone (`again`, `top_hat`), and
//! straight on behind what led it aside (`straight_on`).

mod again;
mod axis;
mod bend;
mod end;
mod even;
mod follow;
mod judge;
mod lattice;
mod levels;
mod midline;
mod noise;
mod parabola;
mod profile;
mod readings;
mod rims;
mod sample;
mod straight_on;
mod strip;
#[cfg(test)]
mod testing;
mod top_hat;
mod trail;

pub use follow::Follower;

/// Makes room for so many in all, so that no later frame allocates.
fn make_room<T>(list: &mut Vec<T>, count: usize) {
    list.reserve(count.saturating_sub(list.len()));
}

/// Rows with at least this confidence are called confident.
pub const CONFIDENT: f32 = 0.5;

/// Where the joint may be looked for, pixels, rims included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zone {
    /// Left rim.
    pub left: f32,
    /// Upper rim.
    pub top: f32,
    /// Right rim.
    pub right: f32,
    /// Lower rim.
    pub bottom: f32,
}

/// What a follower may do.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options {
    /// Longest stretch without a joint in sight that is coasted over (a tack weld), pixels; none: a fifth of the frame's
    /// shorter side.
    pub gap: Option<f32>,
    /// Longest path, pixels; none: twice the frame's width and height together.
    pub length: Option<f32>,
    /// Where the joint is looked for; none: in the whole frame.
    pub zone: Option<Zone>,
    /// The start is known to lie on the joint: a short line is no scratch.
    pub on_joint: bool,
}

/// Where a joint is to be followed from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    /// Point on the joint, pixels to the right.
    pub x: f32,
    /// Pixels down.
    pub y: f32,
    /// Rough direction, rad, from x to y (clockwise as seen).
    pub direction: f32,
    /// Full width at half depth, pixels, if it is known.
    pub width: Option<f32>,
}

/// How a row came about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// The joint is seen.
    Seen,
    /// It is not; the line goes on as it went.
    Coasted,
}

/// A place of the midline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Pixels to the right.
    pub x: f32,
    /// Pixels down.
    pub y: f32,
    /// 0 to 1; see [`CONFIDENT`].
    pub confidence: f32,
    /// Full width at half depth, pixels.
    pub width: f32,
    /// Seen or coasted.
    pub state: State,
}

impl Row {
    /// How far another row is from it, pixels.
    fn away(&self, other: &Self) -> f32 {
        axis::length([other.x - self.x, other.y - self.y])
    }
}

/// Why a joint was followed no further.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// It leaves the frame or the zone, or the longest path is reached.
    LeftImage,
    /// It ends: a clear line stops and clear metal follows.
    JointEnd,
    /// It comes back to its start.
    Closed,
    /// It is seen no longer, or never was.
    Lost,
}

/// The midline found in a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Its places in order, about a pixel apart, or up to a third of the width of a wide joint.
    pub rows: Vec<Row>,
    /// Why it ends.
    pub end: End,
}
