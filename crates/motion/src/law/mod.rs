//! The speed along a path, as fast as every limit allows.

mod cell;
mod cells;
mod certificate;
mod channels;
mod error;
mod grid;
mod interior;
mod jerk_limited;
mod lanes;
mod pentadiagonal;
mod problem;
mod reach;
mod rest;
mod speed_law;
mod stream;

pub use certificate::{Bound, Certificate, Interval, Use};
pub use channels::{Channels, Limits};
pub use error::LawError;
pub use speed_law::{LawPoint, SpeedLaw, SpeedReport};
pub use stream::{Feed, LawStream};
