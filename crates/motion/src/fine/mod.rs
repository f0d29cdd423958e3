//! Two-level interpolation (SADDLE-2020): coarse set-points joined by a spline that the fine level plays.
//!
//! [`CoarseSpline`] takes equally spaced set-points one by one and gives a [`Knot`] for each: the position itself,
//! and the speed and acceleration there of the cubic spline through all of them that is twice continuously
//! differentiable.
//! [`Segment`] is the curve between two knots. A [`Knot`] is also what a control needs that does the fine level itself:
//! position and speed for moves by position, velocity and time, or [`Knot::control_point`] for a uniform cubic
//! B-spline.
//!
//! **Ends.** The motion begins and ends at rest: speed and acceleration are 0 there. A cubic cannot have both, so the
//! first and the last segment are of the fourth degree, and a motion of two points is of the fifth.
//!
//! **Look-ahead.** Each speed depends on all set-points, but one that is n periods away has a part of (2 - sqrt 3)^n: a
//! window of [`LOOK_AHEAD`] = 32 periods leaves 5e-19, less than a rounding. What came before is kept exactly by
//! eliminating forwards. Memory is the window; nothing is allocated.
//!
//! **Guarantees**, tested: at a coarse point the curve is the set-point to the last bit; position, speed and
//! acceleration are the same numbers on both sides of a join; the speeds are those of a dense solver of the whole
//! motion; the error against a smooth path falls with the fourth power of the period.

mod segment;
mod spline;

pub use segment::Segment;
pub use spline::{CoarseSpline, Knot, LOOK_AHEAD};
