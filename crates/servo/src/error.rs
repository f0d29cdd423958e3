//! What can be wrong with a servo's parameters.

use std::fmt;

/// A servo parameter that cannot be used: which one, what was asked, what is allowed.
///
/// Only constructors return it; the cycle itself cannot fail.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A number outside its range, or not a number.
    OutOfRange {
        /// The parameter's name, with its unit as suffix.
        name: &'static str,
        /// What was asked.
        value: f64,
        /// What is allowed, in words.
        allowed: &'static str,
    },
    /// Coulomb friction at or above the peak force: the axis could never move.
    FrictionBeyondPeak {
        /// Coulomb friction (N or N m).
        coulomb: f64,
        /// Peak force (N) or torque (N m).
        peak: f64,
    },
    /// More notches than the loop has places for.
    TooManyNotches {
        /// How many it has.
        places: usize,
    },
    /// The velocity loop does not settle at any bandwidth that was tried: nothing to build a position loop on.
    VelocityLoopSwings {
        /// The slowest that was tried (Hz).
        bandwidth_hz: f64,
    },
    /// No frequency response can be measured: limits or standstills are met with every sine.
    NotMeasurable {
        /// The speed (u/s) at which it was tried.
        speed: f64,
    },
    /// The best loop found does not have the margins that are required.
    MarginsNotReached {
        /// Gain margin (dB).
        gain_db: f64,
        /// Phase margin (degrees).
        phase_deg: f64,
    },
    /// The tuned loop swings at constant speed.
    Swings {
        /// Greatest following error (counts of the encoder).
        counts: f64,
    },
    /// The current loop is too slow for the velocity loop asked: it would ring.
    VelocityLoopTooFast {
        /// What was asked (Hz).
        bandwidth_hz: f64,
        /// The fastest that this current loop carries (Hz).
        limit_hz: f64,
    },
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

/// `value`, if it lies in `low..=high`. NaN does not.
pub(crate) fn within(
    name: &'static str,
    value: f64,
    (low, high): (f64, f64),
    allowed: &'static str,
) -> Result<f64, Error> {
    if value >= low && value <= high { Ok(value) } else { Err(Error::OutOfRange { name, value, allowed }) }
}

/// `value`, if it is above zero and no larger than 1e12.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<f64, Error> {
    within(name, value, (f64::MIN_POSITIVE, 1e12), "above 0, up to 1e12")
}

/// `value`, if it is zero or above and no larger than 1e12.
pub(crate) fn non_negative(name: &'static str, value: f64) -> Result<f64, Error> {
    within(name, value, (0.0, 1e12), "0 to 1e12")
}

/// `period_s`, if it is a servo period that makes sense: 1 microsecond to 1 second.
pub(crate) fn servo_period(period_s: f64) -> Result<f64, Error> {
    within("period_s", period_s, (1e-6, 1.0), "1e-6 to 1 s")
}
