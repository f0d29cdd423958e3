//! The speed along a path, as fast as every limit allows.
//!
//! **Problem.** A path is any parameter `u` with channels `q(u)` that have limits of speed, acceleration and jerk,
//! and with the speed asked of the tip ([`Channels`]). With `b = (du/dt)^2` as a function of `u` a channel's speed is
//! `q' sqrt(b)`, its acceleration `q'' b + q' b' / 2`, its jerk `sqrt(b) (q''' b + 3/2 q'' b' + 1/2 q' b'')`; the
//! time is the integral of `1 / sqrt(b)` (Bobrow, Dubowsky and Gibson, 1985; Verscheure et al., 2009; jerk as convex
//! less concave: Debrouwere et al., 2013).
//!
//! **Method.** Rest is a singular place of `b`, so run-up and run-down have a parameter of their own in which it is
//! nothing special (`rest`). There `b` is a quadratic B-spline: accelerations are continuous, time follows in closed
//! form (`cell`). Its coefficients come from a primal-dual interior-point method (Mehrotra, 1992) with the jerk
//! divided by `sqrt(b)`, whose only part that is not convex, `1 / sqrt(b)`, stays in the Newton matrix as far as it
//! remains positive (`interior`, `problem`; `rows` says which rows there are). Each iterate satisfies all rows. The law
//! is first solved in few wide cells, each made of some of those wanted, and from there in finer and finer ones; then
//! cells in which it bends are halved and it is solved again from where it was (`jerk_limited`). Rows that a law known
//! before is far from are left out; all limits are looked at afterwards (`peak`), and what is then missing is added
//! to the problem, whose multipliers are kept. The matrix has five diagonals, so the cost grows
//! with the number of cells. Without limits of jerk the problem is solved by reachability instead (Pham and Pham,
//! 2018; `reach`), in cells that are small where the tip will be slow (`spread`).
//!
//! **Guarantees.** No channel exceeds a limit at any time, if the path keeps the contract of [`Channels`]: between the
//! places of rows the use of each limit is bounded by
//! what the values around leave open, and the law is solved again, at last slowed as a whole, until it fits. The tip is
//! never faster than asked, and exactly as fast wherever all coefficients of a cell are at that bound. Begin and end
//! are at rest with no acceleration. [`Certificate`] says what was reached and what binds where.
//!
//! **Weaknesses.** The optimum found is a local one: no worse one is known, none is excluded (tests look for faster
//! laws with an optimiser of another kind and find none 2 % faster). At least half a thousandth of each limit is kept
//! in reserve, a ten-thousandth where windows of a stream join. Breaks nearer to each other than a millionth of the
//! path cost digits. A path that is not twice continuously differentiable has to stop there.
//!
//! **Streaming.** [`LawStream`] plans windows from rest to rest and lets one law pass into the next where they overlap.

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
mod reach;
mod rest;
mod rows;
mod speed_law;
mod spread;
mod stream;

pub use certificate::{Bound, Certificate, Interval, Use};
pub use channels::{Bend, Channels, Limits};
pub use error::LawError;
pub use speed_law::{LawPoint, Leg, SpeedLaw, SpeedReport};
pub use stream::{Feed, LawStream};
