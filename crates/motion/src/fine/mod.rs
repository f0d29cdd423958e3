//! Two-level interpolation (SADDLE-2020): coarse set-points joined by a spline that the fine level plays.
//!
//! [`CoarseSpline`] takes equally spaced set-points one by one and gives a [`Knot`] for each: the position itself,
//! and the speed and acceleration there of the twice continuously differentiable cubic spline through all of them.
//! [`Segment`] is the curve between two knots. A control with its own fine level also takes a [`Knot`]: position and
//! speed for moves by position, velocity and time, or [`Knot::control_point`] for a uniform cubic B-spline.
//!
//! **Ends.** The motion starts and ends at rest: speed and acceleration are 0 there. A cubic cannot have both, so the
//! first and the last segment are quartic, and a motion of two points is quintic.
//!
//! **Look-ahead.** Each speed depends on all set-points, but the weight of one n periods away is (2 - sqrt 3)^n: a
//! window of [`LOOK_AHEAD`] = 32 periods leaves 5e-19, less than a rounding. Forward elimination keeps all earlier
//! set-points exactly. Memory is the window, without allocation.
//!
//! **Guarantees**, tested: at a coarse point the curve is the set-point to the last bit; position, speed and
//! acceleration are the same numbers on both sides of a join; the speeds are those of a dense solver of the whole
//! motion; the error against a smooth path falls with the fourth power of the period.
//!
//! The speeds solve a tridiagonal system (de Boor, A Practical Guide to Splines, chapter IV).

mod segment;
mod spline;

pub use segment::Segment;
pub use spline::{CoarseSpline, Knot, LOOK_AHEAD};
