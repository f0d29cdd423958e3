//! Seam tracking with a sensor that looks ahead of the torch.
//!
//! A measurement is combined with the torch and slide positions at its exposure. This gives the *absolute* deviation of
//! the seam by path length: `d(s + L) = measured + slide - own curve`. No error accumulates, so there is no drift, and
//! speed changes, holds and reversing have no effect. A gate and a Kalman filter at the sensor reject outliers.
//! Accepted measurements are stored by path length until the torch arrives, and smoothed from both sides, so without
//! lag.
//!
//! [`Tracker`] implements this method. [`SampleBuffer`] is the algorithm of DUALBEAM-2013, for comparison.
//!
//! - **Gate.** The Kalman filter (Kalman, 1960) of deviation and slope at the sensor serves only as the gate.
//! - **Storage.** Accepted measurements lie in the cells of a ring by path length.
//! - **Smoothing.** Local parabolas with Huber's weights (Huber, 1964) use both sides, never across a jump. One node of
//!   the result is computed per cycle, so the cost of a cycle is bounded.

mod deviation_cells;
mod error;
mod estimate;
mod filter;
mod fit;
mod history;
mod measurement;
mod outliers;
mod own_curve;
mod ring;
mod sample_buffer;
mod settings;
mod tracker;

pub use error::Error;
pub use estimate::{Estimate, Sight};
pub(crate) use history::History;
pub use history::Moment;
pub use measurement::{Measurement, Refusal, Verdict};
pub use own_curve::{OwnCurve, SeamFrame, View};
pub use sample_buffer::SampleBuffer;
pub use settings::Settings;
pub use tracker::{Ahead, Tracker};
