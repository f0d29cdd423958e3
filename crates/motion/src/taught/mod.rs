//! Motion along any number of taught points: read on demand, in constant memory.
//!
//! Points near the chord of their neighbours are left out; the others form a cubic spline in axis space, twice
//! continuously differentiable between corners. At a corner the motion stops or follows a blend.

mod path;
mod spline;
mod thin;

pub(crate) use spline::Piece;

pub use path::{Corner, TaughtPath};
