//! Speed profile (time parameterisation) of a path, as fast as every limit allows.
//!
//! **Problem.** A path is any parameter `u` with channels `q(u)` that have limits of speed, acceleration and jerk,
//! and with the requested speed of the tip ([`Channels`]). Anything with three derivatives and limits is a channel, so
//! limits of other quantities than axes are further channels. With `b = (du/dt)^2` as a function of `u`, a channel has
//!
//! - the speed `q' sqrt(b)`,
//! - the acceleration `q'' b + q' b' / 2`,
//! - the jerk `sqrt(b) (q''' b + 3/2 q'' b' + 1/2 q' b'')`.
//!
//! The time is the integral of `1 / sqrt(b)` (Bobrow, Dubowsky and Gibson, 1985; Verscheure et al., 2009; jerk as
//! convex less concave: Debrouwere et al., 2013).
//!
//! **Method.** `b` is singular at rest, so acceleration and deceleration phase have their own parameter, regular at
//! rest (`rest`). In it `b` is a quadratic B-spline: accelerations are continuous, time follows in closed form
//! (`cell`). Its coefficients come from a primal-dual interior-point method (Mehrotra, 1992) with the jerk divided by
//! `sqrt(b)`. The only non-convex part, `1 / sqrt(b)`, stays in the Newton matrix as far as that remains positive
//! (`interior`, `problem`; `rows` selects the rows). Each iterate satisfies all rows. The profile is first solved in
//! few wide cells, each merged from several final ones, and then in successively finer ones. Cells in which it bends
//! are then halved, and it is solved again from the last solution (`jerk_limited`). Rows far from a previous profile
//! are left out. All limits are checked afterwards (`peak`), and missing rows are added to the problem, with its
//! multipliers kept. The matrix has five diagonals, so the cost is linear in the number of cells. Without limits of
//! jerk the problem is solved by reachability instead (Pham and Pham, 2018; `reach`), in cells that are small where the
//! tip is slow (`spread`).
//!
//! **Guarantees.** No channel exceeds a limit at any time, if the path keeps the contract of [`Channels`]. Between the
//! points of rows the use of each limit is bounded from the neighbouring values. The profile is solved again, finally
//! slowed as a whole, until it fits. The tip is never faster than requested, and exactly as fast if all coefficients of
//! a cell are at that bound. Start and end are at rest with zero acceleration. [`Certificate`] reports reached speeds
//! and binding limits.
//!
//! **Weaknesses.** The optimum is local; bad local optima are unknown but not excluded (tests search faster profiles
//! with another kind of optimiser and find none 2 % faster). At least half a thousandth of each limit is kept in
//! reserve, a ten-thousandth where windows of a stream join. Breaks closer than a millionth of the path cost digits. A
//! path must stop where it is not twice continuously differentiable.
//!
//! **Streaming.** [`ProfileStream`] plans windows of the path from rest to rest. Far from their ends two overlapping
//! profiles are the same. A weighted mean of their coefficients, checked against all limits, leads from one into the
//! next. The output always ends at rest within its window.

mod cell;
mod cells;
mod certificate;
mod channels;
mod error;
mod grid;
mod interior;
mod jerk_limited;
mod lanes;
mod peak;
mod pentadiagonal;
mod problem;
mod profile;
mod reach;
mod rest;
mod rows;
mod spread;
mod stream;

pub use certificate::{Bound, Certificate, Interval, Use};
pub use channels::{Bend, Channels, Limits};
pub use error::SpeedProfileError;
pub use profile::{Leg, ProfilePoint, SpeedProfile, SpeedReport};
pub use stream::{Feed, ProfileStream};
