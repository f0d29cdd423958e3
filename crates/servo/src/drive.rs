//! The simulated servo drive: speed command in, motion of the load out.

use std::f64::consts::TAU;

use crate::error::{Error, servo_period, within};
use crate::mechanism::Mechanism;
use crate::parameters::DriveParameters;

/// Maximum product of velocity gain and sub-step chosen by [`Drive::new`].
///
/// The velocity loop then runs at 20 times its bandwidth in rad/s (126 times that in Hz).
const FINEST: f64 = 0.1;
/// Maximum angle of the transmission's oscillation in a sub-step (rad): its frequency is then at most 0.04 % high.
const FINEST_SWING: f64 = 0.1;
/// Minimum sub-steps in a servo period.
const MIN_SUB_STEPS: f64 = 8.0;
/// Maximum sub-steps in a servo period.
const MAX_SUB_STEPS: f64 = 20_000.0;
/// Maximum sub-steps of dead time, plus one for the fraction of a sub-step.
const PENDING: usize = 128;

/// Outside forces on an axis (N or N m), positive towards positive positions. A plain number acts on the load.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Disturbance {
    /// On the motor: ripple of its torque.
    pub motor: f64,
    /// On the load: its weight, the process.
    pub load: f64,
}

impl From<f64> for Disturbance {
    fn from(load: f64) -> Self {
        Self { motor: 0.0, load }
    }
}

/// Simulation of a vector-controlled servo drive with its load (DUALBEAM-2013).
///
/// The signal path is speed command -> velocity loop -> limited current demand -> current loop (dead time and
/// first-order lag) -> mechanism. The mechanism is one mass, or motor and load with a spring and a gap between
/// ([`Transmission`](crate::Transmission)), with friction and an outside force on the load. Current is expressed as the
/// acceleration (u/s^2) of motor and load together.
///
/// **Velocity loop.** `demand = Kv (r/2 - v) + Kv (w/2) * integral(r - v)` with the bandwidth `w` (rad/s) and
/// `Kv = 2 w`: a PI controller with a set-point weight of one half. The weight puts the zero on one of the two poles at
/// `-w`. So the speed follows its command `r` as the plain lag `1 / (1 + s/w)`, without overshoot; a force `d` (u/s^2)
/// is rejected as `s / (s + w)^2`. The integrator stops while the demand is limited and the error would only increase
/// it. The speed fed back is the motor's true one: drives interpolate their resolver far below a count.
///
/// **Accuracy.** Each servo period consists of a fixed number of sub-steps. The velocity loop runs once in each, like
/// that of a digital drive, with a first-order error in the sub-step against a continuous loop. Between, the current's
/// lag is exact. A single mass moves in closed form under the current's exact mean over the sub-step: exact for a
/// steady current, second order otherwise, stops included to first order. A spring is integrated to second order as
/// well. If dead time makes a demand change within a sub-step, its mean acts.
///
/// **Guarantee.** `|current()| <= 1` always; inputs of any physical size give finite states.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    parameters: DriveParameters,
    mechanism: Mechanism,
    sub_steps: u32,
    step_s: f64,
    /// Part of the current's distance to its demand that remains at the end of a sub-step, and on average.
    lag_end: f64,
    lag_mean: f64,
    /// Dead time in whole sub-steps, and the fraction of one.
    delay: (usize, f64),
    /// Ring buffer of the last demands, newest at `newest`.
    pending: [f64; PENDING],
    newest: usize,
    current: f64,
    /// Mean of the current over the last period.
    mean: f64,
    integral: f64,
    limited: bool,
}

impl Drive {
    /// Creates a drive at rest at 0, with the sub-steps per `period_s` (s) that its bandwidth needs.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a period outside 1e-6 to 1 s or a dead time of more than 127 sub-steps. Also for a
    /// period that needs more than 20 000 sub-steps at this bandwidth or resonance.
    pub fn new(parameters: DriveParameters, period_s: f64) -> Result<Self, Error> {
        let swing = parameters.transmission.map_or(0.0, |t| TAU * t.resonance_hz / FINEST_SWING);
        let needed = (servo_period(period_s)? * swing.max(2.0 * parameters.bandwidth / FINEST)).ceil();
        let allowed = "at most 20000 sub-steps of 1 / (40 pi * velocity_bandwidth_hz) or 1 / (20 pi * resonance_hz)";
        within("period_s", needed, 0.0..=MAX_SUB_STEPS, allowed).map_err(|_| Error::OutOfRange {
            name: "period_s",
            value: period_s,
            allowed,
        })?;
        // In range by the line above, so the cast is exact.
        Self::with_sub_steps(parameters, period_s, needed.max(MIN_SUB_STEPS) as u32)
    }

    /// Does the same as [`Drive::new`] with a given number of sub-steps, to study convergence.
    ///
    /// With far fewer sub-steps than [`Drive::new`] takes, the sampled velocity loop becomes unstable.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a period outside 1e-6 to 1 s, a number of sub-steps outside 1 to 1e6 or a dead time
    /// of more than 127 sub-steps.
    pub fn with_sub_steps(parameters: DriveParameters, period_s: f64, sub_steps: u32) -> Result<Self, Error> {
        let count = within("sub_steps", f64::from(sub_steps), 1.0..=1e6, "1 to 1e6")?;
        let step_s = servo_period(period_s)? / count;
        let delay = parameters.current_delay / step_s;
        let most = (PENDING - 1) as f64;
        within("current_delay_s", parameters.current_delay, 0.0..=most * step_s, "at most 127 sub-steps of the drive")?;
        let lags = step_s / parameters.current_time_constant;
        let (lag_end, lag_mean) = if lags.is_finite() { ((-lags).exp(), -(-lags).exp_m1() / lags) } else { (0.0, 0.0) };
        Ok(Self {
            parameters,
            mechanism: Mechanism::new(parameters.friction(), parameters.transmission),
            sub_steps,
            step_s,
            lag_end,
            lag_mean,
            // In range by the line above, so the cast is exact.
            delay: (delay as usize, delay.fract()),
            pending: [0.0; PENDING],
            newest: 0,
            current: 0.0,
            mean: 0.0,
            integral: 0.0,
            limited: false,
        })
    }

    /// Runs one servo period with constant inputs: a speed `command` (u/s), a force `feed_forward` (N or N m) added to
    /// the velocity loop's demand, and outside forces `disturbance`.
    ///
    /// An input that is not finite counts as zero.
    pub fn step(&mut self, command: f64, feed_forward: f64, disturbance: impl Into<Disturbance>) {
        let Disturbance { motor, load } = disturbance.into();
        let command = finite_or_zero(command);
        let ahead = finite_or_zero(feed_forward) * self.parameters.per_force;
        let ripple = finite_or_zero(motor) * self.parameters.per_force;
        let outside = finite_or_zero(load) * self.parameters.per_force;
        self.limited = false;
        let mut sum = 0.0;
        for _ in 0..self.sub_steps {
            let demand = self.velocity_loop(command, ahead);
            let demand = self.delayed(demand);
            let distance = self.current - demand;
            let push = demand + distance * self.lag_mean;
            self.mechanism.advance(push + ripple, outside, self.step_s);
            sum += push;
            self.current = demand + distance * self.lag_end;
        }
        self.mean = sum / f64::from(self.sub_steps);
    }

    fn velocity_loop(&mut self, command: f64, ahead: f64) -> f64 {
        let peak = self.parameters.limit;
        let gain = 2.0 * self.parameters.bandwidth;
        let velocity = self.mechanism.motor().velocity;
        let error = command - velocity;
        let proportional = gain * (0.5 * command - velocity) + ahead;
        let integral = self.integral + gain * 0.5 * self.parameters.bandwidth * error * self.step_s;
        let wanted = proportional + integral;
        if wanted.abs() <= peak || wanted * error < 0.0 {
            self.integral = integral;
        }
        let demand = proportional + self.integral;
        self.limited |= demand.abs() > peak;
        demand.clamp(-peak, peak)
    }

    /// Stores the demand of this sub-step and returns the mean of the delayed demand.
    fn delayed(&mut self, demand: f64) -> f64 {
        let (whole, part) = self.delay;
        self.newest = (self.newest + 1) % PENDING;
        self.pending[self.newest] = demand;
        let before = |steps: usize| self.pending[(self.newest + PENDING - steps) % PENDING];
        if part == 0.0 { before(whole) } else { before(whole) * (1.0 - part) + before(whole + 1) * part }
    }

    /// Puts the axis at rest with its encoder at `position` (u), the drive holding against `disturbance` (N or N m)
    /// within its limit. A value that is not finite counts as zero.
    pub fn settle_at(&mut self, position: f64, disturbance: f64) {
        let peak = self.parameters.limit;
        let disturbance = finite_or_zero(disturbance);
        self.current = (-disturbance * self.parameters.per_force).clamp(-peak, peak);
        self.mechanism.settle_at(finite_or_zero(position), self.current);
        (self.mean, self.integral) = (self.current, self.current);
        self.pending = [self.current; PENDING];
        self.limited = false;
    }

    /// Returns the true position of the load (u).
    pub fn position(&self) -> f64 {
        self.mechanism.load().position
    }

    /// Returns the true speed of the load (u/s).
    pub fn velocity(&self) -> f64 {
        self.mechanism.load().velocity
    }

    /// Returns the true speed of the motor, referred to the axis (u/s).
    pub fn motor_velocity(&self) -> f64 {
        self.mechanism.motor().velocity
    }

    /// Returns the encoder's reading (u).
    pub fn measured(&self) -> f64 {
        self.parameters.encoder.read(self.mechanism.measured().position)
    }

    /// Returns the current as a fraction of peak current, -1 to 1.
    pub fn current(&self) -> f64 {
        self.current / self.parameters.peak
    }

    /// Returns the mean current over the last period, as a fraction of peak current.
    pub fn mean_current(&self) -> f64 {
        self.mean / self.parameters.peak
    }

    /// Returns true if the current demand was limited in the last period.
    pub fn limited(&self) -> bool {
        self.limited
    }

    /// Returns the parameters of the drive.
    pub fn parameters(&self) -> &DriveParameters {
        &self.parameters
    }
}

fn finite_or_zero(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}
