//! Compensation of friction and backlash in the position loop.

use crate::error::{Error, non_negative, positive, within};

/// Coulomb friction fed forward: a force with the sign of the set speed, `force * tanh(set speed / smoothing)`.
///
/// Without it, the velocity loop's integrator must move to the other sign of the friction at a reversal. The axis
/// stands still meanwhile. The force goes to the drive in addition to the speed command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionCompensation {
    /// Force (N) or torque (N m) at full speed; 0 or above.
    pub force: f64,
    /// Set speed (u/s) at which the force has risen to 76 %, so that it does not jump at rest; above 0.
    pub smoothing: f64,
}

impl FrictionCompensation {
    /// Default of [`Self::smoothing`], as a part of the axis' maximum speed.
    pub const SMOOTHING: f64 = 0.002;

    pub(crate) fn checked(self) -> Result<Self, Error> {
        non_negative("friction_compensation", self.force)?;
        positive("friction_smoothing", self.smoothing)?;
        Ok(self)
    }

    pub(crate) fn force_at(&self, set_speed: f64) -> f64 {
        self.force * (set_speed / self.smoothing).tanh()
    }
}

/// Compensation of lost motion: half of it is added to the set position in the direction of motion.
///
/// A reversal moves that offset by the whole width at a constant rate; its speed is fed forward too. Use it only with
/// an encoder on the motor: one on the load measures the gap itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BacklashCompensation {
    /// Whole lost motion (u): the gap and the wind-up of the transmission under friction, both ways; 0 or above.
    pub width: f64,
    /// Duration of a reversal (s).
    pub time_s: f64,
}

/// Minimum set speed (u/s) with a direction, so that rounding in a planner's rates does not count as a reversal.
const STANDSTILL: f64 = 1e-6;

impl BacklashCompensation {
    /// Default of [`Self::time_s`].
    pub const TIME_S: f64 = 0.02;

    pub(crate) fn checked(self) -> Result<Self, Error> {
        within("backlash_compensation", self.width, 0.0..=1e6, "0 to 1e6")?;
        within("backlash_compensation_time_s", self.time_s, 1e-6..=100.0, "1e-6 to 100 s")?;
        Ok(self)
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BacklashOffset {
    settings: BacklashCompensation,
    target: f64,
    offset: f64,
}

impl BacklashOffset {
    pub(crate) fn new(settings: BacklashCompensation) -> Self {
        Self { settings, target: 0.0, offset: 0.0 }
    }

    /// Returns the offset (u) at the instant of a set-point with this speed, and its rate (u/s) until the next.
    pub(crate) fn update(&mut self, set_speed: f64, period_s: f64) -> (f64, f64) {
        let BacklashCompensation { width, time_s } = self.settings;
        if set_speed.abs() > STANDSTILL {
            self.target = 0.5 * width * set_speed.signum();
        }
        let most = width * period_s / time_s;
        let (now, step) = (self.offset, (self.target - self.offset).clamp(-most, most));
        self.offset += step;
        (now, step / period_s)
    }

    pub(crate) fn reset(&mut self) {
        *self = Self::new(self.settings);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_is_odd_smooth_and_saturates() {
        let friction = FrictionCompensation { force: 30.0, smoothing: 0.5 }.checked().unwrap();
        assert!(friction.force_at(0.0) == 0.0);
        assert!((friction.force_at(0.5) - 30.0 * 1.0_f64.tanh()).abs() < 1e-12);
        for speed in [0.01, 0.3, 20.0] {
            assert!((friction.force_at(speed) + friction.force_at(-speed)).abs() < 1e-12);
        }
        assert!((friction.force_at(-20.0) + 30.0).abs() < 1e-12);
    }

    #[test]
    fn a_reversal_moves_the_offset_by_the_width_over_its_time() {
        let settings = BacklashCompensation { width: 0.04, time_s: 0.02 }.checked().unwrap();
        let mut backlash = BacklashOffset::new(settings);
        // Without a direction the offset is zero.
        assert!(backlash.update(0.0, 1e-3) == (0.0, 0.0));
        assert!(backlash.update(1e-9, 1e-3) == (0.0, 0.0));
        let mut before = 0.0;
        for k in 0..100 {
            let (offset, rate) = backlash.update(3.0, 1e-3);
            // The previous offset and its rate give the present one.
            assert!((offset - before).abs() < 1e-15);
            before = offset + rate * 1e-3;
            assert!((offset - (2e-3 * f64::from(k)).min(0.02)).abs() < 1e-12);
        }
        // It is constant at rest; a reversal takes 20 periods.
        assert!((backlash.update(0.0, 1e-3).0 - 0.02).abs() < 1e-12);
        let offsets: Vec<f64> = (0..30).map(|_| backlash.update(-1.0, 1e-3).0).collect();
        assert!(
            (offsets[10]).abs() < 1e-12 && (offsets[20] + 0.02).abs() < 1e-12 && (offsets[29] + 0.02).abs() < 1e-12
        );
        backlash.reset();
        assert!(backlash == BacklashOffset::new(settings));
    }

    #[test]
    fn nonsense_is_refused() {
        for (force, smoothing) in [(-1.0, 1.0), (1.0, 0.0), (f64::NAN, 1.0), (1.0, f64::NAN), (1.0, -2.0)] {
            assert!(FrictionCompensation { force, smoothing }.checked().is_err());
        }
        for (width, time_s) in [(-1.0, 1.0), (1.0, 0.0), (f64::NAN, 1.0), (1.0, f64::NAN), (f64::INFINITY, 1.0)] {
            assert!(BacklashCompensation { width, time_s }.checked().is_err());
        }
    }
}
