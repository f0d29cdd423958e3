//! Motion along any number of taught points: read on demand, in constant memory.
//!
//! Points near the chord of their neighbours are left out; the others form a cubic spline in axis space, twice
//! continuously differentiable between corners. At a corner the motion stops or follows a blend.
//!
//! Distances between the remaining points change gradually, because a spline through points at uneven distances would
//! oscillate. The memory is a window of points. A blend is a quintic, as at the corners of a pass.

mod spline;
mod taught_path;
mod thinning;

pub(crate) use spline::Piece;

pub use taught_path::{Corner, TaughtPath};
