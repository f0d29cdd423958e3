//! The position loop: PID with velocity and acceleration feed-forward (DUALBEAM-2013).

use std::f64::consts::TAU;

use crate::compensation::{BacklashCompensation, BacklashOffset, FrictionCompensation};
use crate::error::{Error, positive, servo_period, within};
use crate::notch::Notch;
use serde::{Deserialize, Serialize};

/// Time constant of the derivative's filter, in servo periods.
///
/// One encoder count then appears in the derivative as a fifth of a count per period, at the cost of four periods of
/// lag.
const DERIVATIVE_FILTER_PERIODS: f64 = 4.0;
/// Maximum number of notches of a loop.
pub(crate) const NOTCHES: usize = 2;
/// Position errors are clamped to this many units: far beyond any machine, and sums stay finite.
const LARGEST_ERROR: f64 = 1e9;

/// Set position, speed and acceleration of an axis at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct SetPoint {
    /// Position (u).
    pub position: f64,
    /// Speed (u/s).
    pub velocity: f64,
    /// Acceleration (u/s^2).
    pub acceleration: f64,
}

/// Gains of a [`PositionLoop`], all non-negative.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Gains {
    /// Proportional gain (1/s): speed per unit of position error.
    pub kp: f64,
    /// Integral gain (1/s^2).
    pub ki: f64,
    /// Derivative gain (-): speed per unit of error rate.
    pub kd: f64,
    /// Velocity feed-forward (-); 1 is the whole set speed.
    pub kvff: f64,
    /// Acceleration feed-forward (s): the lag of the velocity loop that it compensates.
    pub kaff: f64,
}

impl Gains {
    /// Suggests gains for a drive with the given velocity bandwidth (Hz), commanded every `period_s` (s).
    ///
    /// The drive's speed lags its command by `1/w` (`w` in rad/s), holding a command for a period adds
    /// half a period on average: together a lag `L = 1/w + period/2`. Then
    /// - `kp = 1 / (4 L)`: the poles of `L s^2 + s + kp` meet on the real axis, the fastest
    ///   loop that does not overshoot (with the slowest current loop allowed, by less than 2 %);
    /// - `kvff = 1` and `kaff = L`: the inverse of that lag, so an acceleration is anticipated;
    /// - `ki = 0`, `kd = 0`: a velocity loop with integral action already removes the error of
    ///   a constant force. A second integrator makes every step overshoot and helps only where
    ///   the drive lacks the first or its speed command is offset.
    pub fn suggested(velocity_bandwidth_hz: f64, period_s: f64) -> Self {
        let lag = 1.0 / (TAU * velocity_bandwidth_hz) + 0.5 * period_s;
        Self { kp: 0.25 / lag, ki: 0.0, kd: 0.0, kvff: 1.0, kaff: lag }
    }
}

/// Discrete position loop of one axis (DUALBEAM-2013), with up to two notches (SADDLE-2020) and compensation of
/// friction and backlash.
///
/// `command = kp e + ki * sum(e T) + kd * rate(e) + kvff * set speed + kaff * set acceleration`, held until the next
/// update. Here `e = set position - measured position` at the same instant and `T` is the period. `rate` is that of the
/// error behind a first-order low-pass of time constant `4 T` (backward Euler), as differences of whole encoder counts
/// are rough.
///
/// Anti-windup by conditional integration: while the command is limited, the sum grows only in
/// the direction that leads out of the limit; it never exceeds the speed limit itself.
///
/// Guarantee: the command is finite and within `+-max_speed` whatever the inputs. If an input is
/// not a finite number the command is zero, and the loop's memory stays as it was.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PositionLoop {
    gains: Gains,
    period_s: f64,
    max_speed: f64,
    integral: f64,
    filtered: Option<f64>,
    notches: [Option<Notch>; NOTCHES],
    friction: Option<FrictionCompensation>,
    backlash: Option<BacklashOffset>,
    error: f64,
    force: f64,
    limited: bool,
}

impl PositionLoop {
    /// Creates a loop that runs every `period_s` (s) and commands at most `max_speed` (u/s).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a gain outside 0 to 1e9, a period outside 1e-6 to 1 s or a
    /// speed limit that is not above 0.
    pub fn new(gains: Gains, period_s: f64, max_speed: f64) -> Result<Self, Error> {
        let Gains { kp, ki, kd, kvff, kaff } = gains;
        for (name, value) in [("kp", kp), ("ki", ki), ("kd", kd), ("kvff", kvff), ("kaff", kaff)] {
            within(name, value, 0.0..=1e9, "0 to 1e9")?;
        }
        Ok(Self {
            gains,
            period_s: servo_period(period_s)?,
            max_speed: positive("max_speed", max_speed)?,
            integral: 0.0,
            filtered: None,
            notches: [None; NOTCHES],
            friction: None,
            backlash: None,
            error: 0.0,
            force: 0.0,
            limited: false,
        })
    }

    /// Adds `notch` to the path of the speed command, after the one it may have.
    ///
    /// A notch also delays the feed-forward: add [`Notch::delay_s`] to `kaff`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the notch was built for another period, which would shift its frequency;
    /// [`Error::TooManyNotches`] for a third one.
    pub fn with_notch(mut self, notch: Notch) -> Result<Self, Error> {
        let same = self.period_s * (1.0 - 1e-9)..=self.period_s * (1.0 + 1e-9);
        within("notch period_s", notch.period_s(), same, "the period of the position loop")?;
        let free = self.notches.iter_mut().find(|place| place.is_none());
        *free.ok_or(Error::TooManyNotches { places: NOTCHES })? = Some(notch);
        Ok(self)
    }

    /// Adds the feed-forward of `friction`: see [`PositionLoop::force`].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a negative force or a smoothing speed that is not above 0.
    pub fn with_friction(self, friction: FrictionCompensation) -> Result<Self, Error> {
        Ok(Self { friction: Some(friction.checked()?), ..self })
    }

    /// Adds the compensation of `backlash`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a negative width or a time that is not above 0.
    pub fn with_backlash(self, backlash: BacklashCompensation) -> Result<Self, Error> {
        Ok(Self { backlash: Some(BacklashOffset::new(backlash.checked()?)), ..self })
    }

    /// Computes the speed command (u/s) for the set-point and the measurement (u) of one instant.
    pub fn update(&mut self, set: SetPoint, measured: f64) -> f64 {
        let error = set.position - measured;
        let feed_forward = self.gains.kvff * set.velocity + self.gains.kaff * set.acceleration;
        if !error.is_finite() || !feed_forward.is_finite() {
            self.limited = true;
            self.force = 0.0;
            return 0.0;
        }
        let (offset, rate) = self.backlash.as_mut().map_or((0.0, 0.0), |b| b.update(set.velocity, self.period_s));
        self.force = self.friction.map_or(0.0, |f| f.force_at(set.velocity));
        let error = (error + offset).clamp(-LARGEST_ERROR, LARGEST_ERROR);
        self.error = error;
        let feed_forward = feed_forward + self.gains.kvff * rate;
        let rest = self.gains.kp * error + self.gains.kd * self.error_rate(error) + feed_forward;

        let integral = self.integral + self.gains.ki * error * self.period_s;
        let wanted = rest + integral;
        if wanted.abs() <= self.max_speed || wanted * error < 0.0 {
            self.integral = integral.clamp(-self.max_speed, self.max_speed);
        }
        let command = rest + self.integral;
        self.limited = command.abs() > self.max_speed;
        let limit = |command: f64| command.clamp(-self.max_speed, self.max_speed);
        // A notch overshoots on a step, so the limit applies before and after it.
        self.notches.iter_mut().flatten().fold(limit(command), |command, notch| limit(notch.update(command)))
    }

    /// Returns the following error (u) of the last update: set position, with the offset for backlash, less
    /// measurement.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Returns the force (N or N m) that the drive must add to its demand until the next update: the friction
    /// feed-forward.
    pub fn force(&self) -> f64 {
        self.force
    }

    fn error_rate(&mut self, error: f64) -> f64 {
        // The first error after a reset is not a jump, so it has no rate.
        let before = self.filtered.unwrap_or(error);
        let rate = (error - before) / ((DERIVATIVE_FILTER_PERIODS + 1.0) * self.period_s);
        self.filtered = Some(before + rate * self.period_s);
        rate
    }

    /// Clears integral, derivative filter, notches and direction; gains and limits stay.
    pub fn reset(&mut self) {
        self.integral = 0.0;
        self.filtered = None;
        self.limited = false;
        (self.error, self.force) = (0.0, 0.0);
        self.notches.iter_mut().flatten().for_each(Notch::reset);
        if let Some(backlash) = &mut self.backlash {
            backlash.reset();
        }
    }

    /// Returns true if the last command was clamped to the speed limit, or its inputs were not finite.
    pub fn limited(&self) -> bool {
        self.limited
    }

    /// Returns the gains.
    pub fn gains(&self) -> &Gains {
        &self.gains
    }

    /// Returns the notches, in the order in which the command passes them.
    pub fn notches(&self) -> impl Iterator<Item = &Notch> {
        self.notches.iter().flatten()
    }

    /// Returns the servo period (s).
    pub fn period_s(&self) -> f64 {
        self.period_s
    }
}

#[cfg(test)]
mod tests;
