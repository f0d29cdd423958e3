//! Where the seam is, from a sensor that leads the torch.
//!
//! What the sensor measures at exposure is put together with where torch and slide were then, so the deviation of the
//! seam is known *absolutely*, by path length: `d(s + L) = measured + slide - own curve`. Nothing is summed up, so
//! nothing drifts, and speed changes, holds and going back change nothing. A gate and a Kalman filter at the sensor
//! sort out what cannot be; what passes is kept by path length until the torch is there, and smoothed from both sides,
//! so without lag.
//!
//! [`Tracker`] is that. [`SampleBuffer`] is the algorithm of DUALBEAM-2013, to compare with.

mod cells;
mod error;
mod filter;
mod fit;
mod history;
mod measurement;
mod node;
mod own_curve;
mod ring;
mod sample_buffer;
mod settings;
mod suspects;
mod tracker;

pub use error::Error;
pub(crate) use history::History;
pub use history::Moment;
pub use measurement::{Measurement, Refusal, Verdict};
pub use node::{Estimate, Sight};
pub use own_curve::{OwnCurve, SeamFrame, View};
pub use sample_buffer::SampleBuffer;
pub use settings::Settings;
pub use tracker::{Ahead, Tracker};
