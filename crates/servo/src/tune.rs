//! Automatic tuning: a test on the drive, a design, and a measurement of what came out.

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

/// Margins (dB, degrees) without which a loop is not tuned.
pub const REQUIRED: (f64, f64) = (6.0, 35.0);
/// The test runs at this part of the axis' highest speed.
const TEST_SPEED: f64 = 0.2;
/// Each next slower velocity loop that is tried, and the slowest, as parts of the one before and of the first.
const SLOWER: f64 = 0.65;
const SLOWEST: f64 = 0.05;
/// The velocity loop must be stable with this much more bandwidth: a gain margin of 3.5 dB of its own.
const VELOCITY_RESERVE: f64 = 1.5;
/// A gain below this part of that of a rigid axis makes slower velocity loops worth a look: they damp a resonance more.
const POOR: f64 = 0.6;
/// A gain below this part of the best one so far ends the search.
const GONE_DOWN: f64 = 0.8;
/// Each next lower gain, if the measured margins fall short, and how often.
const LOWER: f64 = 0.75;
const LOWERINGS: u32 = 5;
/// A resonance stands out of the rest of the response by this much (dB).
const STANDS_OUT_DB: f64 = 6.0;
/// Resonances are looked for up to this part of the sampling rate.
const RESONANCES: f64 = 0.35;
/// Set speed at which compensated friction has risen to 76 %, as a part of the highest speed.
const SMOOTHING: f64 = 0.002;
/// Time that a reversal of compensated backlash is spread over, in parts of 1 / kp.
const REVERSAL: f64 = 1.0;

/// A tuned loop and what was measured of it. Lengths and angles in the axis' unit u.
#[derive(Debug, Clone, PartialEq)]
pub struct Tuned {
    /// Gains of the position loop.
    pub gains: Gains,
    /// Its notches, two at most.
    pub notches: Vec<NotchSettings>,
    /// Bandwidth (Hz) that the drive's velocity loop should have: that of the drive or less.
    pub velocity_bandwidth_hz: f64,
    /// Coulomb friction fed forward, as measured; `None` if there is none.
    pub friction: Option<FrictionCompensation>,
    /// Lost motion made up for, as measured at the load; `None` if it is below an encoder count, or seen by the
    /// encoder.
    pub backlash: Option<BacklashCompensation>,
    /// Where current and motion of the drive resonate (Hz), if that stands out.
    pub resonance_hz: Option<f64>,
    /// Speed (u/s) at which everything was measured.
    pub speed: f64,
    /// Measured margins of the finished loop.
    pub margins: Margins,
    /// Greatest following error that the loop sees at constant speed (counts of the encoder).
    pub following_counts: f64,
    /// Greatest distance of the load from the set position then (u), which an encoder on the motor does not see.
    pub load_error: f64,
    /// Measured open-loop response of the finished loop.
    pub response: Vec<Line>,
}

impl Tuned {
    /// The loop, stepped every `period_s` (s), its command limited to `max_speed` (u/s).
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

/// Tunes a position loop for `drive`, to run every `period_s` (s) on an axis that goes up to `max_speed` (u/s).
///
/// 1. The velocity loop is slowed down, in steps, until it settles on the transmission even with half as much
///    bandwidth again.
/// 2. Stepped sines over a constant speed give the response from speed command to encoder.
/// 3. `kp` is the highest gain with margins of 8 dB and 50 degrees, behind up to two notches where they raise it.
///    Where a resonance keeps it low, slower velocity loops, which damp it more, are tried as well.
/// 4. `kvff` is 1, `kaff` the lag that was measured, `ki` and `kd` are 0, as in [`Gains::suggested`].
/// 5. Friction is the current at constant speeds; lost motion what load and encoder differ by after either direction.
/// 6. The loop is closed and measured as it is; while it has not the margins of [`REQUIRED`], `kp` is lowered.
///
/// Deterministic: the same drive gives the same loop.
///
/// # Errors
/// [`Error::OutOfRange`] for a period or speed that makes no sense, [`Error::VelocityLoopSwings`],
/// [`Error::NotMeasurable`], [`Error::MarginsNotReached`] and [`Error::Swings`] if the drive cannot be tuned.
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

/// `speed`, or a little less, so that a period is no whole number of counts (each a speed of `count`): with whole ones
/// the encoder would round the same way every time, and small sines would not be seen at all.
fn uneven(speed: f64, count: f64) -> f64 {
    // The golden section is the furthest from any fraction.
    let whole = (speed / count).floor();
    if whole < 1.0 { speed } else { (whole - 1.0 + 0.5 * (5.0_f64.sqrt() - 1.0)) * count }
}

/// The velocity loop, its response and the design with the highest gain.
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
            // Slower still would be worse still.
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

/// By how much (s) a slow motion lags its speed command: from the phase beyond that of an integrator.
fn measured_lag(test: &[Measured], bandwidth_hz: f64) -> f64 {
    let slow = test.iter().take_while(|m| m.line.frequency_hz < bandwidth_hz / 6.0);
    let sums = slow.fold((0.0, 0.0), |(phase, square), Measured { line, .. }| {
        let w = TAU * line.frequency_hz;
        (phase - w * (line.ratio.arg() + FRAC_PI_2), square + w * w)
    });
    sums.0 / sums.1
}

/// Where the acceleration for a current is greatest, if that is well above the one of slow motion.
fn resonance(test: &[Measured], period_s: f64) -> Option<f64> {
    // Nearer to half the sampling rate the counts are all noise.
    let test = &test[..test.partition_point(|m| m.line.frequency_hz < RESONANCES / period_s)];
    let inertance: Vec<f64> = test.iter().map(|m| m.per_effort.norm() * m.line.frequency_hz.powi(2)).collect();
    let slow = &inertance[..test.len() / 10 + 1];
    let rigid = slow.iter().sum::<f64>() / slow.len() as f64;
    // The noise of the counts stands out in single lines; a resonance has been refined until its lines are alike.
    let alike = |w: &[f64]| w[0].min(w[2]) > w[1] / 1.5;
    let peaks = inertance.windows(3).enumerate().filter(|(_, w)| alike(w));
    let (i, height) = peaks.map(|(i, w)| (i + 1, w[1])).max_by(|a, b| a.1.total_cmp(&b.1))?;
    (decibels(height / rigid) > STANDS_OUT_DB).then_some(test[i].line.frequency_hz)
}

/// Measures the closed loop, with less gain until the margins are there.
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
