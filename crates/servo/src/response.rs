//! Frequency responses of a simulated axis, measured in motion.
//!
//! The axis runs at a constant speed, so that friction keeps its sign, with a superimposed sine.

use std::f64::consts::TAU;

use crate::axis::ServoAxis;
use crate::drive::Drive;
use crate::error::Error;
use crate::parameters::DriveParameters;
use crate::position_loop::{Gains, SetPoint};
use crate::sweep::{Line, Measured, Range, Signals, sweep};

/// Lines per decade, before refinement where the response changes fast.
const PER_DECADE: f64 = 20.0;
/// Highest frequency, as a part of half the sampling rate.
const HIGHEST: f64 = 0.9;
/// Lowest frequency, as a part of the velocity loop's bandwidth or of the loop's gain, whichever is lower.
const LOWEST: f64 = 0.05;
/// Negligible differences of the open loop's response: under 0.1 dB at the gain margin.
const FLOOR: f64 = 0.004;
/// Speed amplitudes of the sine, as parts of the constant speed, without and with the position loop.
const OPEN_AMPLITUDE: f64 = 0.3;
const CLOSED_AMPLITUDE: f64 = 0.2;
/// Maximum deviation of the speed, as a part of the constant one; beyond it the axis nearly stands or reverses.
const SPOILED: f64 = 0.9;

/// Acceleration for reaching a speed: a part of the drive's reserve beyond friction.
pub(crate) fn gentle(drive: &DriveParameters) -> f64 {
    0.2 * (drive.limit - drive.coulomb)
}

/// Maximum acceleration phase of a measurement, s.
const RUN_UP_S: f64 = 60.0;

/// Rejects a drive with too little force beyond friction to reach `speed` (u/s) in time.
pub(crate) fn check_run_up(drive: &DriveParameters, speed: f64) -> Result<(), Error> {
    if speed.abs() > RUN_UP_S * gentle(drive) { Err(Error::NotMeasurable { speed }) } else { Ok(()) }
}

/// Returns true if the drive is limited, or so far off `speed` that friction may change its sign.
fn spoiled(drive: &Drive, speed: f64) -> bool {
    let off = |v: f64| (v - speed).abs() > SPOILED * speed;
    drive.limited() || off(drive.velocity()) || off(drive.motor_velocity())
}

/// Returns the sweep range for a loop of gain `kp` (1/s) on the drive.
fn range(drive: &DriveParameters, kp: f64, period_s: f64) -> Range {
    Range {
        low: LOWEST * drive.velocity_bandwidth_hz().min(kp),
        high: HIGHEST * 0.5 / period_s,
        per_decade: PER_DECADE,
        period_s,
        resolution: drive.encoder().count(),
        floor: FLOOR,
    }
}

/// Measures the drive alone: from the speed command to the encoder, and from its current to the encoder.
pub(crate) fn drive_response(parameters: &DriveParameters, period_s: f64, speed: f64) -> Result<Vec<Measured>, Error> {
    check_run_up(parameters, speed)?;
    let mut drive = Drive::new(*parameters, period_s)?;
    let mut command = 0.0;
    while command < speed {
        drive.step(command, 0.0, 0.0);
        command += gentle(parameters) * period_s;
    }
    let start = drive.measured();
    let mut k = 0u64;
    let system = |excitation: f64| {
        let output = drive.measured() - start - speed * period_s * k as f64;
        k += 1;
        drive.step(speed + excitation, 0.0, 0.0);
        Signals { input: excitation, output, effort: drive.mean_current(), spoiled: spoiled(&drive, speed) }
    };
    // The position loop to be closed about it has a gain of this order.
    let kp = Gains::suggested(parameters.velocity_bandwidth_hz(), period_s).kp;
    let range = Range { floor: FLOOR / kp, ..range(parameters, kp, period_s) };
    sweep(system, |_| OPEN_AMPLITUDE * speed, &range).ok_or(Error::NotMeasurable { speed })
}

/// Measures the open-loop response of a position loop with the loop closed. `axis`, at rest, is brought to `speed`
/// (u/s); sines are added to its set position. The ratio is that of the encoder's reading to the position error. The
/// feed-forwards do not contain the sines. Lines are in order of frequency, up to 0.9 of half the sampling rate.
///
/// The response contains friction, backlash, whole counts, sampling and filters. The sines are reduced until neither a
/// limit nor a standstill occurs.
///
/// # Errors
/// [`Error::OutOfRange`] for a speed not above 0, [`Error::NotMeasurable`] if limits or standstills occur with every
/// sine, as in an unstable loop.
pub fn loop_response(axis: &ServoAxis, speed: f64) -> Result<Vec<Line>, Error> {
    crate::error::positive("speed", speed)?;
    let mut axis = *axis;
    let parameters = *axis.drive().parameters();
    let (period_s, kp) = (axis.position_loop().period_s(), axis.position_loop().gains().kp);
    let (mut position, mut velocity) = (axis.drive().measured(), 0.0);
    let acceleration = gentle(&parameters).min(speed / (10.0 * period_s));
    while velocity < speed {
        axis.step(SetPoint { position, velocity, acceleration }, 0.0);
        position += (velocity + 0.5 * acceleration * period_s) * period_s;
        velocity += acceleration * period_s;
    }
    let mut k = 0u64;
    let system = |excitation: f64| {
        let base = speed * period_s * k as f64;
        k += 1;
        let set = SetPoint { position: position + base + excitation, velocity: speed, acceleration: 0.0 };
        let state = axis.step(set, 0.0);
        let output = state.measured - position - base;
        let spoiled = spoiled(axis.drive(), speed) || axis.position_loop().limited();
        Signals { input: set.position - state.measured, output, effort: axis.drive().mean_current(), spoiled }
    };
    // Below the crossover the axis follows the sine; above it the loop turns it into a speed of kp times the sine.
    let amplitude = |hz: f64| CLOSED_AMPLITUDE * speed / (TAU * hz).min(kp);
    let lines = sweep(system, amplitude, &range(&parameters, kp, period_s)).ok_or(Error::NotMeasurable { speed })?;
    Ok(lines.into_iter().map(|measured| measured.line).collect())
}
