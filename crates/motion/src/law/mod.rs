//! The speed along a path, as fast as every limit allows.

mod cells;
mod certificate;
mod channels;
mod error;
mod grid;
mod interior;
mod jerk_limited;
mod pentadiagonal;
mod problem;
mod reach;
mod rest;
mod speed_law;

pub use certificate::{Bound, Certificate, Interval, Use};
pub use channels::{Channels, Limits};
pub use error::LawError;
pub use speed_law::{LawPoint, SpeedLaw, SpeedReport};
