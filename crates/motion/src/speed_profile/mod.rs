//! Speed profile (time parameterisation) of a path, as fast as every limit allows.
//!
//! - [`Channels`] is the input: a path, the limits of everything that moves along it, and the requested speed.
//! - [`SpeedProfile`] is the result for a whole path, by path parameter and by time.
//! - [`Certificate`] reports the reached speeds and which limit binds where.
//! - [`ProfileStream`] plans a path of any length in constant memory; its path is a [`Feed`].
//!
//! Welds get their profile from [`PassMotion::plan`](crate::PassMotion::plan). Use this module for other paths.
//!
//! # Units
//!
//! The parameter `u` has any unit. A channel has its own unit (mm or rad) and time is in s. Speeds of the torch tip are
//! in mm/s.
//!
//! # Examples
//!
//! One axis over 100 mm at 10 mm/s, from rest to rest:
//!
//! ```
//! use seamwright_machine::AxisLimits;
//! use seamwright_motion::speed_profile::{Certificate, Channels, SpeedProfile};
//!
//! struct Line([AxisLimits; 1]);
//!
//! impl Channels for Line {
//!     fn range(&self) -> (f64, f64) {
//!         (0.0, 100.0)
//!     }
//!     fn limits(&self) -> &[AxisLimits] {
//!         &self.0
//!     }
//!     fn derivatives(&self, _u: f64, _before: bool, out: &mut [[f64; 3]]) -> f64 {
//!         out[0] = [1.0, 0.0, 0.0]; // q(u) = u
//!         1.0 // the tip moves 1 mm for each unit of u
//!     }
//!     fn asked(&self, _u: f64) -> f64 {
//!         10.0
//!     }
//!     fn breaks(&self) -> Vec<f64> {
//!         Vec::new()
//!     }
//! }
//!
//! let line = Line([AxisLimits { speed: 50.0, acceleration: 100.0, jerk: 1000.0 }]);
//! let profile = SpeedProfile::new(&line)?;
//! // 10 s at the requested speed, and 0.1 s for each of acceleration and deceleration phase.
//! assert!(profile.duration() > 10.2 && profile.duration() < 10.3);
//! let middle = profile.at(0.5 * profile.duration(), &mut 0);
//! assert!((middle.v - 10.0).abs() < 1e-3);
//! // The requested speed binds on most of the path.
//! assert!(Certificate::new(&line, &profile).at_asked > 0.9);
//! # Ok::<(), seamwright_motion::speed_profile::SpeedProfileError>(())
//! ```
//!
//! # Guarantees
//!
//! They hold if the path keeps the contract of [`Channels`].
//!
//! - No channel exceeds a limit at any time. Between the points of rows the use of each limit is bounded from the
//!   neighbouring values. The profile is solved again, finally slowed as a whole, until it fits.
//! - The tip is never faster than requested. It is exactly as fast if all coefficients of a cell are at that bound.
//! - Start and end are at rest with zero acceleration.
//!
//! # Limitations
//!
//! - The optimum is local. Bad local optima are unknown but not excluded: tests search faster profiles with another
//!   kind of optimiser and find none 2 % faster.
//! - At least half a thousandth of each limit is kept in reserve, a ten-thousandth where windows of a stream join.
//! - Breaks closer than a millionth of the path cost digits.
//! - A path must stop where it is not twice continuously differentiable.
//!
//! # Problem
//!
//! A path has channels `q(u)` with limits of speed, acceleration and jerk, and the requested speed of the tip. Anything
//! with three derivatives and limits is a channel, so limits of other quantities than axes are further channels. With
//! `b = (du/dt)^2` as a function of `u`, a channel has
//!
//! - the speed `q' sqrt(b)`,
//! - the acceleration `q'' b + q' b' / 2`,
//! - the jerk `sqrt(b) (q''' b + 3/2 q'' b' + 1/2 q' b'')`.
//!
//! The time is the integral of `1 / sqrt(b)` (references 1 and 2). The jerk is convex less concave (3).
//!
//! # Method
//!
//! 1. **Cells.** `b` is singular at rest, so acceleration and deceleration phase have their own parameter, regular at
//!    rest (`rest_to_rest`). In it `b` is a quadratic B-spline: accelerations are continuous, time follows in closed
//!    form (`profile_cell`).
//! 2. **Solution.** The coefficients come from a primal-dual interior-point method (4) with the jerk divided by
//!    `sqrt(b)`. The only non-convex part, `1 / sqrt(b)`, stays in the Newton matrix as far as that remains positive
//!    (`interior_point`, `problem`; `row_selection` selects the rows). Each iterate satisfies all rows. The matrix has
//!    five diagonals, so the cost is linear in the number of cells.
//! 3. **Refinement.** The profile is first solved in few wide cells, each merged from several final ones, and then in
//!    successively finer ones. Cells in which it bends are then halved, and it is solved again from the last solution
//!    (`jerk_limited`). Rows far from a previous profile are left out.
//! 4. **Check.** All limits are checked afterwards (`limit_use`), and missing rows are added to the problem, with its
//!    multipliers kept.
//!
//! Without limits of jerk the problem is solved by reachability instead (5; `reachability`), in cells that are small
//! where the tip is slow (`grid_without_jerk`).
//!
//! [`ProfileStream`] plans windows of the path from rest to rest. Far from their ends two overlapping profiles are the
//! same. A weighted mean of their coefficients, checked against all limits, leads from one into the next. The output
//! always ends at rest within its window.
//!
//! # References
//!
//! 1. Bobrow, Dubowsky, Gibson: Time-optimal control of robotic manipulators along specified paths, 1985.
//! 2. Verscheure, Demeulenaere, Swevers, De Schutter, Diehl: Time-optimal path tracking for robots: a convex
//!    optimization approach, 2009.
//! 3. Debrouwere et al.: Time-optimal path following for robots with convex-concave constraints using sequential convex
//!    programming, 2013.
//! 4. Mehrotra: On the implementation of a primal-dual interior point method, 1992.
//! 5. Pham, Pham: A new approach to time-optimal path parameterization based on reachability analysis, 2018.

mod cells;
mod certificate;
mod channels;
mod error;
mod grid;
mod grid_without_jerk;
mod interior_point;
mod jerk_limited;
mod lanes;
mod limit_use;
mod problem;
mod profile;
mod profile_cell;
mod reachability;
mod rest_to_rest;
mod row_selection;
mod stream;

pub use certificate::{Bound, Certificate, Interval, Use};
pub use channels::{Bend, Channels};
pub use error::SpeedProfileError;
pub use profile::{Leg, ProfilePoint, SpeedProfile, SpeedReport};
pub use stream::{Feed, ProfileStream};
