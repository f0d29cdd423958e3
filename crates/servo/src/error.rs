//! Errors of a servo's parameters and tuning.

use std::fmt;
use std::ops::RangeInclusive;

/// A servo parameter is invalid, or a drive cannot be tuned: the parameter, its value and the allowed range or the
/// cause.
///
/// Only constructors, measurements and the tuning return it; a servo cycle always succeeds.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum Error {
    /// The number of this name, which ends in its unit, is outside the allowed range, or NaN.
    OutOfRange { name: &'static str, value: f64, allowed: &'static str },
    /// Coulomb friction is at or above the peak force (N or N m), so the axis could never move.
    FrictionBeyondPeak { coulomb: f64, peak: f64 },
    /// More notches than the loop supports.
    TooManyNotches { places: usize },
    /// The velocity loop does not settle down to this bandwidth, so no position loop can be tuned on it.
    VelocityLoopSwings { bandwidth_hz: f64 },
    /// No frequency response can be measured at this speed (u/s): limits or standstills occur with every sine.
    NotMeasurable { speed: f64 },
    /// The best loop does not reach the required margins.
    MarginsNotReached { gain_db: f64, phase_deg: f64 },
    /// The tuned loop oscillates at constant speed: the maximum following error, in encoder counts.
    Swings { counts: f64 },
    /// The current loop is too slow for this velocity loop, which would ring.
    VelocityLoopTooFast { bandwidth_hz: f64, limit_hz: f64 },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::OutOfRange { name, value, allowed } => {
                write!(f, "{name} is {value}, allowed: {allowed}")
            }
            Self::FrictionBeyondPeak { coulomb, peak } => write!(
                f,
                "Coulomb friction {coulomb} is not below the peak force or torque {peak}: the axis could not move"
            ),
            Self::TooManyNotches { places } => write!(f, "the position loop has places for {places} notches"),
            Self::VelocityLoopSwings { bandwidth_hz } => write!(
                f,
                "the velocity loop does not settle down to {bandwidth_hz:.2} Hz: a stiffer transmission, a faster current loop, or more force over friction"
            ),
            Self::NotMeasurable { speed } => write!(
                f,
                "no frequency response can be measured at a speed of {speed}: the drive meets a limit or stands still with every sine"
            ),
            Self::MarginsNotReached { gain_db, phase_deg } => write!(
                f,
                "the best loop has a gain margin of {gain_db:.1} dB and a phase margin of {phase_deg:.0} degrees, short of 6 dB and 35 degrees"
            ),
            Self::Swings { counts } => {
                write!(f, "the tuned loop swings: a following error of {counts:.1} counts at constant speed, above 1")
            }
            Self::VelocityLoopTooFast { bandwidth_hz, limit_hz } => {
                write!(f, "velocity_bandwidth_hz is {bandwidth_hz}, the current loop carries at most {limit_hz}")
            }
        }
    }
}

impl std::error::Error for Error {}

/// Returns `value` if it lies in `range`; NaN does not.
pub(crate) fn within(
    name: &'static str,
    value: f64,
    range: RangeInclusive<f64>,
    allowed: &'static str,
) -> Result<f64, Error> {
    let (low, high) = range.into_inner();
    if value >= low && value <= high { Ok(value) } else { Err(Error::OutOfRange { name, value, allowed }) }
}

/// Returns `value` if it is above zero and at most 1e12.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<f64, Error> {
    within(name, value, f64::MIN_POSITIVE..=1e12, "above 0, up to 1e12")
}

/// Returns `value` if it is zero or above and at most 1e12.
pub(crate) fn non_negative(name: &'static str, value: f64) -> Result<f64, Error> {
    within(name, value, 0.0..=1e12, "0 to 1e12")
}

/// Returns `period_s` if it is a valid servo period: 1 microsecond to 1 second.
pub(crate) fn servo_period(period_s: f64) -> Result<f64, Error> {
    within("period_s", period_s, 1e-6..=1.0, "1e-6 to 1 s")
}
