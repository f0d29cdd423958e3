//! Parameters of a drive and its load in physical units, reduced to accelerations in axis units.

use std::f64::consts::TAU;

use crate::encoder::Encoder;
use crate::error::{Error, non_negative, positive, within};
use crate::mechanism::Friction;

/// Maximum product of velocity bandwidth (rad/s) and the current loop's lag: time constant and dead time (s).
///
/// With the gains of [`Drive`](crate::Drive) the velocity loop's poles solve `tau s^3 + s^2 + 2 w s + w^2 = 0`. At
/// `tau w = 1/4` the complex pair has a damping of 0.69, at 2 it is unstable. Above 1/4 the simulated drive would ring
/// more than any tuned drive.
const LARGEST_LAG: f64 = 0.25;

/// The moving part of a linear axis, everything referred to the axis (after screw and gear).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearLoad {
    /// Moved mass (kg), with motor and screw inertia reduced to the axis.
    pub mass_kg: f64,
    /// Maximum force of the drive (N), at peak current.
    pub peak_force_n: f64,
    /// Coulomb friction (N), also the static friction.
    pub coulomb_n: f64,
    /// Viscous friction (N s/m).
    pub viscous_n_s_per_m: f64,
}

/// The moving part of a rotary axis, everything referred to the axis (after the gear).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotaryLoad {
    /// Moment of inertia (kg m^2), with the motor's times the ratio squared.
    pub inertia_kg_m2: f64,
    /// Maximum torque of the drive (N m), at peak current.
    pub peak_torque_nm: f64,
    /// Coulomb friction (N m), also the static friction.
    pub coulomb_nm: f64,
    /// Viscous friction (N m s/rad).
    pub viscous_nm_s_per_rad: f64,
}

/// The drive's electronics and its encoder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveTuning {
    /// Frequency (Hz) at which the speed has fallen to -3 dB of its command.
    pub velocity_bandwidth_hz: f64,
    /// Time constant (s) of the current loop, a first-order lag; 0 without lag.
    pub current_time_constant_s: f64,
    /// Dead time (s) from the velocity loop's measurement to the current; 0 without dead time.
    pub current_delay_s: f64,
    /// Counts per mm (linear) or per rad (rotary).
    pub encoder_counts_per_unit: f64,
}

/// Side of the transmission measured by the position encoder. The velocity loop always uses the motor's speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum EncoderSide {
    /// The motor; the wind-up of the transmission is not measured.
    #[default]
    Motor,
    /// The load.
    Load,
}

/// Transmission between motor and load: a spring with damping, and a gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transmission {
    /// Frequency (Hz) at which motor and load oscillate against each other, both free. With the motor held, the load
    /// oscillates at this over `sqrt(1 + load_ratio)`.
    pub resonance_hz: f64,
    /// Damping of that oscillation, as a part of critical damping.
    pub damping: f64,
    /// Inertia of the load over that of the motor.
    pub load_ratio: f64,
    /// Whole width of the gap (u).
    pub backlash: f64,
    /// Part of the friction at the motor, 0 to 1; the rest is at the load.
    pub motor_friction: f64,
    /// Side of the encoder.
    pub encoder_on: EncoderSide,
}

/// Parameters of [`Drive`](crate::Drive), with forces divided by the inertia.
///
/// Built by [`DriveParameters::linear`] (unit mm) or [`DriveParameters::rotary`] (unit rad).
/// Guarantee: every value is finite and in range, friction is below the peak, and the current loop
/// is fast enough for the velocity loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveParameters {
    /// Acceleration at peak current without friction (u/s^2).
    pub(crate) peak: f64,
    /// Deceleration by Coulomb friction alone (u/s^2).
    pub(crate) coulomb: f64,
    /// Viscous friction over inertia (1/s): the decay rate of a coasting speed.
    pub(crate) viscous: f64,
    /// Acceleration (u/s^2) per N or N m of disturbance.
    pub(crate) per_force: f64,
    pub(crate) bandwidth: f64,
    pub(crate) current_time_constant: f64,
    pub(crate) current_delay: f64,
    /// Maximum acceleration demand; the peak or less.
    pub(crate) limit: f64,
    pub(crate) encoder: Encoder,
    pub(crate) transmission: Option<Transmission>,
}

impl DriveParameters {
    /// Creates the parameters of a linear axis: positions in mm, disturbances in N.
    ///
    /// # Errors
    /// [`Error`] for a value out of range and for friction not below the peak force. Also for a velocity loop too fast
    /// for the current loop (bandwidth in rad/s times time constant above 1/4).
    pub fn linear(load: LinearLoad, tuning: DriveTuning) -> Result<Self, Error> {
        let mass = within("mass_kg", load.mass_kg, 1e-9..=1e9, "1e-9 to 1e9 kg")?;
        let peak = positive("peak_force_n", load.peak_force_n)?;
        let coulomb = non_negative("coulomb_n", load.coulomb_n)?;
        let viscous = non_negative("viscous_n_s_per_m", load.viscous_n_s_per_m)?;
        // N / kg is m/s^2; the axis counts in mm.
        Self::reduced([peak, coulomb, viscous], mass, 1000.0, tuning)
    }

    /// Creates the parameters of a rotary axis: positions in rad, disturbances in N m.
    ///
    /// # Errors
    /// As [`DriveParameters::linear`].
    pub fn rotary(load: RotaryLoad, tuning: DriveTuning) -> Result<Self, Error> {
        let inertia = within("inertia_kg_m2", load.inertia_kg_m2, 1e-9..=1e9, "1e-9 to 1e9 kg m^2")?;
        let peak = positive("peak_torque_nm", load.peak_torque_nm)?;
        let coulomb = non_negative("coulomb_nm", load.coulomb_nm)?;
        let viscous = non_negative("viscous_nm_s_per_rad", load.viscous_nm_s_per_rad)?;
        Self::reduced([peak, coulomb, viscous], inertia, 1.0, tuning)
    }

    fn reduced(
        [peak, coulomb, viscous]: [f64; 3],
        inertia: f64,
        units_per_si: f64,
        tuning: DriveTuning,
    ) -> Result<Self, Error> {
        if coulomb >= peak {
            return Err(Error::FrictionBeyondPeak { coulomb, peak });
        }
        let lag = within("current_time_constant_s", tuning.current_time_constant_s, 0.0..=1.0, "0 to 1 s")?;
        let delay = within("current_delay_s", tuning.current_delay_s, 0.0..=1.0, "0 to 1 s")?;
        let per_force = units_per_si / inertia;
        let drive = Self {
            peak: peak * per_force,
            coulomb: coulomb * per_force,
            viscous: viscous / inertia,
            per_force,
            bandwidth: 0.0,
            current_time_constant: lag,
            current_delay: delay,
            limit: peak * per_force,
            encoder: Encoder::new(tuning.encoder_counts_per_unit)?,
            transmission: None,
        };
        drive.with_velocity_bandwidth(tuning.velocity_bandwidth_hz)
    }

    /// Puts the load behind an elastic transmission; inertia and friction are those of motor and load together.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the resonance is 0.1 to 10 000 Hz, the damping and the motor's part of the friction
    /// 0 to 1, the ratio 0.001 to 1000 and the backlash 0 or above.
    pub fn with_transmission(self, transmission: Transmission) -> Result<Self, Error> {
        let t = &transmission;
        within("resonance_hz", t.resonance_hz, 0.1..=1e4, "0.1 to 10000 Hz")?;
        within("resonance_damping", t.damping, 0.0..=1.0, "0 to 1")?;
        within("load_ratio", t.load_ratio, 1e-3..=1e3, "0.001 to 1000")?;
        non_negative("backlash", t.backlash)?;
        within("motor_friction", t.motor_friction, 0.0..=1.0, "0 to 1")?;
        Ok(Self { transmission: Some(transmission), ..self })
    }

    /// Limits the force to `limit` (N or N m), at most the peak.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a limit not above zero or beyond the peak, [`Error::FrictionBeyondPeak`] for one not
    /// above the Coulomb friction.
    pub fn with_force_limit(self, limit: f64) -> Result<Self, Error> {
        let allowed = "above 0, up to the peak force or torque";
        // A limit equal to the peak passes in spite of rounding.
        let most = self.peak / self.per_force * (1.0 + 1e-12);
        within("force_limit", limit, f64::MIN_POSITIVE..=most, allowed)?;
        let coulomb = self.coulomb / self.per_force;
        if coulomb >= limit {
            return Err(Error::FrictionBeyondPeak { coulomb, peak: limit });
        }
        Ok(Self { limit: (limit * self.per_force).min(self.peak), ..self })
    }

    /// Sets the bandwidth of the velocity loop to `hz`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless `hz` is 0.001 to 1e5, [`Error::VelocityLoopTooFast`] if the current loop is too
    /// slow for it.
    pub fn with_velocity_bandwidth(self, hz: f64) -> Result<Self, Error> {
        within("velocity_bandwidth_hz", hz, 1e-3..=1e5, "0.001 to 1e5 Hz")?;
        let lag = self.current_time_constant + self.current_delay;
        if TAU * hz * lag > LARGEST_LAG {
            return Err(Error::VelocityLoopTooFast { bandwidth_hz: hz, limit_hz: LARGEST_LAG / (TAU * lag) });
        }
        Ok(Self { bandwidth: TAU * hz, ..self })
    }

    /// Multiplies the velocity loop's bandwidth by `factor`, without a check against the current loop, to measure the
    /// distance from oscillation.
    pub(crate) fn faster(&self, factor: f64) -> Self {
        Self { bandwidth: factor * self.bandwidth, ..*self }
    }

    pub(crate) fn friction(&self) -> Friction {
        Friction { coulomb: self.coulomb, viscous: self.viscous }
    }

    /// Returns the bandwidth of the velocity loop (Hz).
    pub fn velocity_bandwidth_hz(&self) -> f64 {
        self.bandwidth / TAU
    }

    /// Returns the transmission; `None` if motor and load are one rigid mass.
    pub fn transmission(&self) -> Option<Transmission> {
        self.transmission
    }

    /// Returns the encoder.
    pub fn encoder(&self) -> Encoder {
        self.encoder
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TUNING: DriveTuning = DriveTuning {
        velocity_bandwidth_hz: 100.0,
        current_time_constant_s: 2e-4,
        current_delay_s: 0.0,
        encoder_counts_per_unit: 1000.0,
    };
    const LINEAR: LinearLoad =
        LinearLoad { mass_kg: 40.0, peak_force_n: 400.0, coulomb_n: 20.0, viscous_n_s_per_m: 80.0 };

    #[test]
    fn physical_units_become_accelerations() {
        let linear = DriveParameters::linear(LINEAR, TUNING).unwrap();
        assert!((linear.peak - 10_000.0).abs() < 1e-9); // 10 m/s^2 in mm/s^2
        assert!((linear.coulomb - 500.0).abs() < 1e-9);
        assert!((linear.viscous - 2.0).abs() < 1e-12);
        assert!((linear.per_force - 25.0).abs() < 1e-12);
        let load = RotaryLoad { inertia_kg_m2: 0.5, peak_torque_nm: 20.0, coulomb_nm: 1.0, viscous_nm_s_per_rad: 0.25 };
        let rotary = DriveParameters::rotary(load, TUNING).unwrap();
        assert!((rotary.peak - 40.0).abs() < 1e-12);
        assert!((rotary.coulomb - 2.0).abs() < 1e-12);
        assert!((rotary.viscous - 0.5).abs() < 1e-12);
        assert!((rotary.per_force - 2.0).abs() < 1e-12);
    }

    #[test]
    fn nonsense_is_refused_by_name() {
        let stuck = LinearLoad { coulomb_n: 400.0, ..LINEAR };
        assert!(matches!(DriveParameters::linear(stuck, TUNING), Err(Error::FrictionBeyondPeak { .. })));
        let sluggish = DriveTuning { current_time_constant_s: 1e-3, ..TUNING };
        let error = DriveParameters::linear(LINEAR, sluggish).unwrap_err();
        assert!(
            matches!(error, Error::VelocityLoopTooFast { limit_hz, .. } if (limit_hz - 39.788_735_77).abs() < 1e-6)
        );
        let light = LinearLoad { mass_kg: f64::NAN, ..LINEAR };
        assert!(DriveParameters::linear(light, TUNING).unwrap_err().to_string().starts_with("mass_kg is NaN"));
    }
}
