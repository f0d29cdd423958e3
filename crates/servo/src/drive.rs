//! The simulated servo drive: speed command in, motion of the load out.

use crate::error::{Error, servo_period, within};
use crate::load::Load;
use crate::parameters::DriveParameters;

/// Largest product of velocity gain and sub-step chosen by [`Drive::new`].
///
/// The velocity loop then runs at 20 times its bandwidth in rad/s (126 times that in Hz).
const FINEST: f64 = 0.1;
/// Fewest and most sub-steps in a servo period.
const SUB_STEPS: (f64, f64) = (8.0, 20_000.0);

/// A vector-controlled servo drive with its load (DUALBEAM-2013), in simulation.
///
/// Speed command -> velocity loop -> current demand, limited to the peak -> current loop (first-order
/// lag) -> [`Load`] with friction and an outside force. Current is counted as the acceleration
/// (u/s^2) it gives the load.
///
/// **Velocity loop.** `demand = Kv (r/2 - v) + Kv (w/2) * integral(r - v)` with `w` the bandwidth
/// (rad/s) and `Kv = 2 w`: a PI controller that weighs its set-point `r` by one half. The weight
/// puts the zero on one of the two poles at `-w`, so the speed follows its command as the plain
/// lag `1 / (1 + s/w)`, without overshoot, while a force `d` (u/s^2) is rejected as `s / (s + w)^2`.
/// The integrator stops while the demand is limited and the error would only push it further.
/// The speed fed back is the true one: drives interpolate their resolver far below a count.
///
/// **Accuracy.** Each servo period is cut in a fixed number of sub-steps. The velocity loop runs
/// once in each, as the loop of a digital drive does, which brings a first-order error in the sub-step
/// against a continuous loop. Between, the current's lag is exact and the load moves in closed form
/// under the current's exact mean over the sub-step: exact for a steady current, second order
/// otherwise, stops included to first order.
///
/// **Guarantee.** `|current()| <= 1` always; inputs of any physical size give finite states.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    parameters: DriveParameters,
    load: Load,
    sub_steps: u32,
    step_s: f64,
    /// Part of the current's distance to its demand left at the end of a sub-step, and on average.
    lag_end: f64,
    lag_mean: f64,
    current: f64,
    integral: f64,
    limited: bool,
}

impl Drive {
    /// A drive at rest at 0, with as many sub-steps per `period_s` (s) as its bandwidth needs.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a period outside 1e-6 to 1 s, or so long against the bandwidth that
    /// it would take more than 20 000 sub-steps.
    pub fn new(parameters: DriveParameters, period_s: f64) -> Result<Self, Error> {
        let needed = (servo_period(period_s)? * 2.0 * parameters.bandwidth / FINEST).ceil();
        let allowed = "at most 20000 sub-steps of 1 / (40 pi * velocity_bandwidth_hz)";
        within("period_s", needed, (0.0, SUB_STEPS.1), allowed).map_err(|_| Error::OutOfRange {
            name: "period_s",
            value: period_s,
            allowed,
        })?;
        // In range by the line above, so the cast is exact.
        Self::with_sub_steps(parameters, period_s, needed.max(SUB_STEPS.0) as u32)
    }

    /// As [`Drive::new`], with the number of sub-steps given: to study convergence.
    ///
    /// Far below what [`Drive::new`] takes, the sampled velocity loop becomes unstable.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a period outside 1e-6 to 1 s or a number of sub-steps outside 1 to 1e6.
    pub fn with_sub_steps(parameters: DriveParameters, period_s: f64, sub_steps: u32) -> Result<Self, Error> {
        let count = within("sub_steps", f64::from(sub_steps), (1.0, 1e6), "1 to 1e6")?;
        let step_s = servo_period(period_s)? / count;
        let lags = step_s / parameters.current_time_constant;
        let (lag_end, lag_mean) = if lags.is_finite() { ((-lags).exp(), -(-lags).exp_m1() / lags) } else { (0.0, 0.0) };
        Ok(Self {
            parameters,
            load: Load::new(parameters.coulomb, parameters.viscous),
            sub_steps,
            step_s,
            lag_end,
            lag_mean,
            current: 0.0,
            integral: 0.0,
            limited: false,
        })
    }

    /// Runs one servo period under a speed `command` (u/s) and an outside force `disturbance`
    /// (N or N m, positive towards positive positions), both constant over the period.
    ///
    /// A command or disturbance that is not a finite number counts as zero.
    pub fn step(&mut self, command: f64, disturbance: f64) {
        let command = finite_or_zero(command);
        let outside = finite_or_zero(disturbance) * self.parameters.per_force;
        self.limited = false;
        for _ in 0..self.sub_steps {
            let demand = self.velocity_loop(command);
            let distance = self.current - demand;
            self.load.advance(demand + distance * self.lag_mean + outside, self.step_s);
            self.current = demand + distance * self.lag_end;
        }
    }

    fn velocity_loop(&mut self, command: f64) -> f64 {
        let peak = self.parameters.peak;
        let gain = 2.0 * self.parameters.bandwidth;
        let error = command - self.load.velocity;
        let proportional = gain * (0.5 * command - self.load.velocity);
        let integral = self.integral + gain * 0.5 * self.parameters.bandwidth * error * self.step_s;
        let wanted = proportional + integral;
        if wanted.abs() <= peak || wanted * error < 0.0 {
            self.integral = integral;
        }
        let demand = proportional + self.integral;
        self.limited |= demand.abs() > peak;
        demand.clamp(-peak, peak)
    }

    /// Puts the load at rest at `position` (u), the drive holding against `disturbance` (N or N m)
    /// as far as its peak allows. A value that is not a finite number counts as zero.
    pub fn settle_at(&mut self, position: f64, disturbance: f64) {
        let peak = self.parameters.peak;
        let disturbance = finite_or_zero(disturbance);
        self.load.position = finite_or_zero(position);
        self.load.velocity = 0.0;
        self.current = (-disturbance * self.parameters.per_force).clamp(-peak, peak);
        self.integral = self.current;
        self.limited = false;
    }

    /// True position (u).
    #[must_use]
    pub fn position(&self) -> f64 {
        self.load.position
    }

    /// True speed (u/s).
    #[must_use]
    pub fn velocity(&self) -> f64 {
        self.load.velocity
    }

    /// Current as a fraction of peak current, -1 to 1.
    #[must_use]
    pub fn current(&self) -> f64 {
        self.current / self.parameters.peak
    }

    /// Whether the current demand was cut to the peak anywhere in the last period.
    #[must_use]
    pub fn limited(&self) -> bool {
        self.limited
    }

    /// The parameters it was built with.
    #[must_use]
    pub fn parameters(&self) -> &DriveParameters {
        &self.parameters
    }
}

fn finite_or_zero(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}
