//! Motion along taught points, as many as there may be: read as they are needed, in constant memory.
//!
//! Points near the chord of their neighbours are left out, the rest become a cubic spline in axis space, twice
//! continuously differentiable between corners. At a corner the motion stops or goes through a blend.

mod path;
mod spline;
mod thin;

pub(crate) use spline::Piece;

pub use path::{Corner, TaughtPath};
