//! The jerk-limited speed law on paths that are not made by our own kinematics.

#![allow(unreachable_pub, clippy::float_cmp, reason = "one test program; exact ends are exact")]

mod campaign;
mod check;
mod curves;
mod odd;
mod optimum;
mod random;
mod stream;
mod timing;
