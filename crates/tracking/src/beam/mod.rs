//! Beam mode (EBW-2004): the welding beam is also the camera. It interrupts the weld for a few milliseconds to scan the
//! work ahead of the pool, and is deflected to the detected joint.
//!
//! [`Schedule`] decides when the beam scans, [`ZoneNeeds`] which zone: ahead of pool and heat, within the frame.
//! [`BeamTracking`] combines the points of all frames by path length and splits corrections between the deflection and
//! the axes that carry the gun. The result is a [`DeviationRecord`] stored with the program. [`BeamReplay`] corrects
//! later passes with it without a sensor, once a few frames have confirmed that it still fits.
//!
//! Deviations are stored by the seam's path length. So a later pass may start elsewhere, or run in the other direction.
//! The zone begins beyond the decay of heat ahead of the pool (Rosenthal, 1946).

mod beam_authority;
mod error;
mod picture;
mod record;
mod replay;
mod schedule;
mod settings;
mod tracking;
mod zone;

pub use error::Error;
pub use picture::{Picture, Point, Taken};
pub use record::{DeviationRecord, RecordError, Recorder, Row};
pub use replay::{BeamReplay, Fit, Misfit, Replay, ReplaySettings};
pub use schedule::{Allowed, Beam, Schedule};
pub use settings::Settings;
pub use tracking::{BeamTracking, Orders};
pub use zone::{Zone, ZoneNeeds};
