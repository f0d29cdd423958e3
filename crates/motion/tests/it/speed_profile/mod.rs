//! The jerk-limited speed profile on paths independent of our own kinematics.

#![allow(unreachable_pub, clippy::float_cmp, reason = "one test program; exact ends are exact")]

mod campaign;
mod check;
mod curves;
mod odd;
mod optimum;
mod random;
mod stream;
mod timing;
