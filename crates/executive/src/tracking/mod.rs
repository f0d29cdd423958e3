//! Seam tracking as the executive's guide: heads guided by sensors ahead of the torches, by the beam or by the record of
//! an earlier pass, and the axes that carry out their corrections.
//!
//! [`Tracking`] is the guide of a program. [`PassSeams`] prepares a pass: its sensors, heads and axes.

mod alarm_number;
mod beam_head;
mod beam_use;
mod carrier;
mod error;
mod guide;
mod head_requests;
mod leading_head;
mod limit_use;
mod live_beam;
mod live_head;
mod pass_seams;
mod pass_sensors;
mod path_offset;
mod retreat;
mod seam;
mod tracked_pass;

pub use alarm_number::trouble;
pub use beam_head::{BeamHead, END_MM, LATENCY_VARIATION_S, LOOK_S, STEP_MM};
pub use beam_use::BeamUse;
pub use error::{Error, OffLine};
pub use guide::{Tracking, TrackingConditions};
pub use limit_use::LimitUse;
pub use live_beam::{BeamFit, BeamSample, BeamSummary};
pub use live_head::{AlarmAt, HeadReport, swing_at};
pub use pass_seams::{Correction, PassSeams};
pub use pass_sensors::{BeamCamera, FIELD_MM, LeadingSensor, PLACES, PassSensors};
pub use seam::{PassPosition, Seam};
pub use seamwright_tracking::actuator::RESERVE;
