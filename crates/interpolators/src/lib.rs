//! Interpolators of papers and textbooks, for comparison with the exact one.
//!
//! A [`Request`] names a [`Shape`] (ellipse or saddle), a [`Method`], speed, period and pulse. [`Request::interpolate`]
//! gives its points one by one, [`Request::statistics`] their statistics. Lengths are mm, angles rad, times s.
//!
//! Sources: ELLIPSE-2015 (Li, Zhao, Huang: ellipse interpolation by the change of the eccentric angle, and the methods
//! it is compared with), SADDLE-2020 (Li, Guo, Sun: direct interpolation of the saddle), INTERSECT-2006 (equal angles).

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod comparison_integral;
mod course;
mod dda;
mod eccentric_angle;
mod error;
mod exact;
mod grid;
mod interpolation;
mod method;
mod nearest;
mod path;
mod point;
mod point_by_point;
mod request;
mod shape;
mod spread;
mod statistics;
#[cfg(test)]
mod testing;

pub use error::Error;
pub use interpolation::Interpolation;
pub use method::{AngleRule, EqualStep, Method};
pub use nearest::Nearest;
pub use path::Path;
pub use point::Point;
pub use request::{Request, STEP_LIMIT};
pub use shape::{ON_ELLIPSE_TOLERANCE_MM, SWEEP_LIMIT_RAD, Shape};
pub use spread::Spread;
pub use statistics::{Statistics, Tally};
