//! The jerk-limited speed law on paths that are not made by our own kinematics.

mod curves;
mod stream;
mod timing;
