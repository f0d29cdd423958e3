//! Beam mode (EBW-2004): the beam that welds is the eye. It interrupts the weld for a few milliseconds to scan the work ahead
//! of the pool, and is deflected to where the joint was seen.
//!
//! [`Schedule`] says when the beam scans, [`ZoneNeeds`] where: ahead of pool and heat, within the frame. [`BeamTracking`]
//! puts the places that a frame shows together by path length and divides corrections between deflection and the axes
//! that carry the gun. What was found is a [`DeviationRecord`] that is stored with the program; [`BeamReplay`] corrects later
//! passes by it without a sensor, once a few frames have shown that it still fits.

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
