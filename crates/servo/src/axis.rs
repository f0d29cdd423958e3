//! One simulated servo axis: position loop, drive and encoder.

use crate::drive::{Disturbance, Drive};
use crate::error::Error;
use crate::parameters::DriveParameters;
use crate::position_loop::{Gains, PositionLoop, SetPoint};

/// State of an axis over one servo period.
///
/// Position, velocity, measurement and following error are those at the set-point's own instant `t_k`;
/// command, current and saturation are those of the period that follows, `t_k` to `t_k+1`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AxisState {
    /// True position of the load at `t_k` (u).
    pub position: f64,
    /// True speed of the load at `t_k` (u/s).
    pub velocity: f64,
    /// The encoder's reading at `t_k` (u).
    pub measured: f64,
    /// Set position minus true position of the load, both at `t_k` (u).
    pub following_error: f64,
    /// Speed command held from `t_k` to `t_k+1` (u/s).
    pub command: f64,
    /// Current at `t_k+1`, as a fraction of peak current, -1 to 1.
    pub current: f64,
    /// True if the speed command or the current demand was limited between `t_k` and `t_k+1`.
    pub saturated: bool,
}

/// A position loop on a simulated drive.
///
/// The set-point for `t_k` is compared with the measurement at `t_k`; the command acts from `t_k` to `t_k+1`, without a
/// dead time for its computation. At constant speed with `kvff = 1` only the encoder's error of half a count remains.
/// The [crate](crate#examples) has an example.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ServoAxis {
    position_loop: PositionLoop,
    drive: Drive,
}

impl ServoAxis {
    /// Creates an axis at rest at 0 with a servo period of `period_s` (s) and a speed command limited to `max_speed`
    /// (u/s).
    ///
    /// # Errors
    /// Those of [`PositionLoop::new`] and [`Drive::new`].
    pub fn new(gains: Gains, max_speed: f64, parameters: DriveParameters, period_s: f64) -> Result<Self, Error> {
        Self::with_loop(PositionLoop::new(gains, period_s, max_speed)?, parameters)
    }

    /// Creates an axis at rest at 0 with an existing position loop, stepped with that loop's period.
    ///
    /// # Errors
    /// Those of [`Drive::new`].
    pub fn with_loop(position_loop: PositionLoop, parameters: DriveParameters) -> Result<Self, Error> {
        Ok(Self { position_loop, drive: Drive::new(parameters, position_loop.period_s())? })
    }

    /// Runs one servo period, from the set-point's instant to the next, under constant outside forces `disturbance`. A
    /// number is a force on the load (N or N m, positive towards positive positions).
    ///
    /// Guarantee: `|command| <= max_speed` and `|current| <= 1` for any inputs.
    pub fn step(&mut self, set: SetPoint, disturbance: impl Into<Disturbance>) -> AxisState {
        let (position, velocity) = (self.drive.position(), self.drive.velocity());
        let measured = self.drive.measured();
        let command = self.position_loop.update(set, measured);
        self.drive.step(command, self.position_loop.force(), disturbance);
        AxisState {
            position,
            velocity,
            measured,
            following_error: set.position - position,
            command,
            current: self.drive.current(),
            saturated: self.position_loop.limited() || self.drive.limited(),
        }
    }

    /// Puts the axis at rest with its encoder at `position` (u) and with cleared state, the drive already holding
    /// against `disturbance` (N or N m), such as the weight of a vertical axis: stepped with the same disturbance it
    /// does not sag.
    pub fn settle_at(&mut self, position: f64, disturbance: f64) {
        self.position_loop.reset();
        self.drive.settle_at(position, disturbance);
    }

    /// Returns the drive with its load, after the last step.
    pub fn drive(&self) -> &Drive {
        &self.drive
    }

    /// Returns the position loop.
    pub fn position_loop(&self) -> &PositionLoop {
        &self.position_loop
    }
}
