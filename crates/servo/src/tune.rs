//! Automatic tuning: a test on the drive, a design, and a measurement of the result.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::axis::ServoAxis;
use crate::compensation::{BacklashCompensation, FrictionCompensation};
use crate::design::{Design, NotchSettings, design};
use crate::error::{Error, positive, servo_period};
use crate::margins::{Margins, decibels};
use crate::parameters::DriveParameters;
use crate::position_loop::{Gains, NOTCHES, PositionLoop};
use crate::response::{drive_response, loop_response};
use crate::sweep::{Line, Measured};
use crate::trial::{following, friction, lost_motion, settles};

/// Minimum margins of a tuned loop (dB, degrees).
pub const REQUIRED: (f64, f64) = (6.0, 35.0);
/// Speed of the test, as a part of the axis' maximum speed.
const TEST_SPEED: f64 = 0.2;
/// Factor from one velocity loop to the next slower one, and the slowest one as a part of the first.
const SLOWER: f64 = 0.65;
const SLOWEST: f64 = 0.05;
/// Factor of bandwidth at which the velocity loop must still be stable: a gain margin of 3.5 dB of its own.
const VELOCITY_RESERVE: f64 = 1.5;
/// Gain below which slower velocity loops are tried, as a part of that of a rigid axis: they damp a resonance more.
const POOR: f64 = 0.6;
/// A gain below this part of the best one so far ends the search.
const GONE_DOWN: f64 = 0.8;
/// Factor to the next lower gain if the measured margins are too small, and the maximum number of such steps.
const LOWER: f64 = 0.75;
const LOWERINGS: u32 = 5;
/// Minimum height of a resonance above the rest of the response (dB).
const STANDS_OUT_DB: f64 = 6.0;
/// Maximum frequency of a resonance, as a part of the sampling rate.
const RESONANCES: f64 = 0.35;
/// Set speed at which compensated friction has risen to 76 %, as a part of the maximum speed.
const SMOOTHING: f64 = 0.002;
/// Duration of a reversal with backlash compensation, in parts of 1 / kp.
const REVERSAL: f64 = 1.0;

/// A tuned loop and its measurements. Lengths and angles are in the axis' unit u.
#[derive(Debug, Clone, PartialEq)]
pub struct Tuned {
    /// Gains of the position loop.
    pub gains: Gains,
    /// Notches, two at most.
    pub notches: Vec<NotchSettings>,
    /// Bandwidth (Hz) to set in the drive's velocity loop: that of the drive or less.
    pub velocity_bandwidth_hz: f64,
    /// Measured Coulomb friction, fed forward; `None` for negligible friction.
    pub friction: Option<FrictionCompensation>,
    /// Compensation of the lost motion, as measured at the load; `None` if it is below an encoder count, or the encoder
    /// measures it.
    pub backlash: Option<BacklashCompensation>,
    /// Resonance (Hz) of the motion over the current of the drive, if it is distinct.
    pub resonance_hz: Option<f64>,
    /// Speed (u/s) of all measurements.
    pub speed: f64,
    /// Measured margins of the finished loop.
    pub margins: Margins,
    /// Maximum following error in the loop at constant speed (encoder counts).
    pub following_counts: f64,
    /// Maximum distance of the load from the set position then (u), which an encoder on the motor does not measure.
    pub load_error: f64,
    /// Measured open-loop response of the finished loop.
    pub response: Vec<Line>,
}

impl Tuned {
    /// Builds the loop, stepped every `period_s` (s), its command limited to `max_speed` (u/s).
    ///
    /// # Errors
    /// Those of [`PositionLoop::new`], for a period other than that of the tuning.
    pub fn position_loop(&self, period_s: f64, max_speed: f64) -> Result<PositionLoop, Error> {
        let mut position_loop = PositionLoop::new(self.gains, period_s, max_speed)?;
        for notch in &self.notches {
            position_loop = position_loop.with_notch(notch.build(period_s)?)?;
        }
        if let Some(friction) = self.friction {
            position_loop = position_loop.with_friction(friction)?;
        }
        match self.backlash {
            Some(backlash) => position_loop.with_backlash(backlash),
            None => Ok(position_loop),
        }
    }
}

/// Tunes a position loop for `drive`, with a servo period of `period_s` (s), on an axis with the maximum speed
/// `max_speed` (u/s).
///
/// 1. The velocity loop is slowed down, in steps, until it settles on the transmission even with 1.5 times the
///    bandwidth.
/// 2. Stepped sines over a constant speed give the response from speed command to encoder.
/// 3. `kp` is the highest gain with margins of 8 dB and 50 degrees, behind up to two notches if they raise it. If a
///    resonance keeps it low, slower velocity loops, which damp it more, are tried too.
/// 4. `kvff` is 1, `kaff` the measured lag, `ki` and `kd` are 0, as in [`Gains::suggested`].
/// 5. Friction is the current at constant speeds. Lost motion is the difference between load and encoder after either
///    direction.
/// 6. The closed loop is measured. While it does not reach the margins of [`REQUIRED`], `kp` is lowered.
///
/// Deterministic: the same drive gives the same loop.
///
/// # Errors
/// [`Error::OutOfRange`] for an invalid period or speed; [`Error::VelocityLoopSwings`], [`Error::NotMeasurable`],
/// [`Error::MarginsNotReached`] and [`Error::Swings`] if the drive cannot be tuned.
pub fn tune(drive: &DriveParameters, period_s: f64, max_speed: f64) -> Result<Tuned, Error> {
    servo_period(period_s)?;
    let speed = uneven(TEST_SPEED * positive("max_speed", max_speed)?, drive.encoder().count() / period_s);
    let (drive, test, found) = best_design(drive, period_s, speed)?;
    let lag = measured_lag(&test, drive.velocity_bandwidth_hz());
    let notch_delay = found.notches.iter().map(|n| n.build(period_s).map(|n| n.delay_s())).sum::<Result<f64, _>>()?;
    let gains = Gains { kp: found.kp, ki: 0.0, kd: 0.0, kvff: 1.0, kaff: (lag + notch_delay).max(0.0) };
    let coulomb = friction(&drive, period_s, speed)?;
    let lost = lost_motion(&drive, period_s, 0.1 * speed)?;
    let (smoothing, time_s) = (SMOOTHING * max_speed, (REVERSAL / found.kp).max(period_s));
    let mut tuned = Tuned {
        gains,
        notches: found.notches,
        velocity_bandwidth_hz: drive.velocity_bandwidth_hz(),
        friction: (coulomb > 0.0).then_some(FrictionCompensation { force: coulomb, smoothing }),
        backlash: (lost > drive.encoder().count()).then_some(BacklashCompensation { width: lost, time_s }),
        resonance_hz: resonance(&test, period_s),
        speed,
        margins: Margins::of(&[]),
        following_counts: f64::INFINITY,
        load_error: f64::INFINITY,
        response: Vec::new(),
    };
    verified(&mut tuned, &drive, period_s, max_speed).map(|()| tuned)
}

/// Returns `speed`, or a little less, so that a period is not a whole number of counts (each a speed of `count`). With
/// whole counts the encoder would always round the same way, and hide small sines.
fn uneven(speed: f64, count: f64) -> f64 {
    // The golden section is the furthest from any simple fraction.
    let whole = (speed / count).floor();
    if whole < 1.0 { speed } else { (whole - 1.0 + 0.5 * (5.0_f64.sqrt() - 1.0)) * count }
}

/// Returns the velocity loop, its response and the design with the highest gain.
fn best_design(
    drive: &DriveParameters,
    period_s: f64,
    speed: f64,
) -> Result<(DriveParameters, Vec<Measured>, Design), Error> {
    let first = drive.velocity_bandwidth_hz();
    let mut best: Option<(DriveParameters, Vec<Measured>, Design)> = None;
    let (mut hz, mut failure) = (first, Error::VelocityLoopSwings { bandwidth_hz: SLOWEST * first });
    while hz >= SLOWEST * first {
        let slower = drive.with_velocity_bandwidth(hz)?;
        hz *= SLOWER;
        if !settles(&slower.faster(VELOCITY_RESERVE), period_s, speed)? {
            continue;
        }
        let test = match drive_response(&slower, period_s, speed) {
            Ok(test) => test,
            Err(error) => {
                failure = error;
                continue;
            }
        };
        let lines: Vec<Line> = test.iter().map(|m| m.line).collect();
        let found = design(&lines, period_s, NOTCHES);
        let rigid = Gains::suggested(slower.velocity_bandwidth_hz(), period_s).kp;
        let (kp, enough) = (found.kp, found.kp >= POOR * rigid);
        if !kp.is_finite() {
            continue;
        }
        match &best {
            // A still slower loop would be worse.
            Some((_, _, before)) if kp < GONE_DOWN * before.kp => break,
            Some((_, _, before)) if kp <= before.kp => {}
            _ => best = Some((slower, test, found)),
        }
        if enough {
            break;
        }
    }
    best.ok_or(failure)
}

/// Returns the lag (s) of a slow motion behind its speed command: from the phase beyond that of an integrator.
fn measured_lag(test: &[Measured], bandwidth_hz: f64) -> f64 {
    let slow = test.iter().take_while(|m| m.line.frequency_hz < bandwidth_hz / 6.0);
    let sums = slow.fold((0.0, 0.0), |(phase, square), Measured { line, .. }| {
        let w = TAU * line.frequency_hz;
        (phase - w * (line.ratio.arg() + FRAC_PI_2), square + w * w)
    });
    sums.0 / sums.1
}

/// Returns the frequency with the maximum acceleration per current, if it is well above that of slow motion.
fn resonance(test: &[Measured], period_s: f64) -> Option<f64> {
    // Nearer to half the sampling rate, counts are mostly noise.
    let test = &test[..test.partition_point(|m| m.line.frequency_hz < RESONANCES / period_s)];
    let inertance: Vec<f64> = test.iter().map(|m| m.per_effort.norm() * m.line.frequency_hz.powi(2)).collect();
    let slow = &inertance[..test.len() / 10 + 1];
    let rigid = slow.iter().sum::<f64>() / slow.len() as f64;
    // Noise of the counts appears in single lines; a resonance has been refined until its lines are similar.
    let alike = |w: &[f64]| w[0].min(w[2]) > w[1] / 1.5;
    let peaks = inertance.windows(3).enumerate().filter(|(_, w)| alike(w));
    let (i, height) = peaks.map(|(i, w)| (i + 1, w[1])).max_by(|a, b| a.1.total_cmp(&b.1))?;
    (decibels(height / rigid) > STANDS_OUT_DB).then_some(test[i].line.frequency_hz)
}

/// Measures the closed loop, with a lower gain until it reaches the margins.
fn verified(tuned: &mut Tuned, drive: &DriveParameters, period_s: f64, max_speed: f64) -> Result<(), Error> {
    let mut failure = Error::NotMeasurable { speed: tuned.speed };
    for _ in 0..=LOWERINGS {
        let axis = ServoAxis::with_loop(tuned.position_loop(period_s, max_speed)?, *drive)?;
        match loop_response(&axis, tuned.speed) {
            Ok(response) => {
                tuned.margins = Margins::of(&response);
                tuned.response = response;
                let following = following(&axis, tuned.speed);
                (tuned.following_counts, tuned.load_error) = (following.counts, following.load);
                if !tuned.margins.reach(REQUIRED.0, REQUIRED.1) {
                    let Margins { gain_margin_db, phase_margin_deg, .. } = tuned.margins;
                    failure = Error::MarginsNotReached { gain_db: gain_margin_db, phase_deg: phase_margin_deg };
                } else if tuned.following_counts > 1.0 {
                    failure = Error::Swings { counts: tuned.following_counts };
                } else {
                    return Ok(());
                }
            }
            Err(error) => failure = error,
        }
        tuned.gains.kp *= LOWER;
    }
    Err(failure)
}
