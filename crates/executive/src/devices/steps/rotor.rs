use seamwright_machine::{Axis, AxisKind, Load, Stepper};
use seamwright_servo::{StepperMotor, StepperParameters};
use std::f64::consts::TAU;

/// Rotor of an axis, driven by its pulses; positions in mm or rad.
#[derive(Debug, Clone)]
pub(super) struct Rotor {
    per_step: f64,
    microsteps: f64,
    /// Travel of the axis per rad of the shaft, mm or rad.
    per_rad: f64,
    positive: bool,
    /// Signed pulse count, including the count at the start.
    count: f64,
    /// Pulse count at angle 0, and the motor; `None` if the file does not describe it.
    motor: Option<(f64, StepperMotor)>,
    /// Time up to which the motor was simulated, s.
    at_s: f64,
}

impl Rotor {
    pub(super) fn new(
        axis: &Axis,
        stepper: &Stepper,
        microsteps: u32,
        start: f64,
    ) -> Result<Self, seamwright_servo::Error> {
        let motor = match (&stepper.motor, axis.drive.as_ref().map(|d| d.load)) {
            (Some(motor), Some(Load { inertia, coulomb, viscous, .. })) => {
                // Travel of the axis per rad of the shaft, m or rad.
                let unit = if axis.kind == AxisKind::Linear { 1e-3 } else { 1.0 };
                let lever = stepper.per_turn * unit / TAU;
                let parameters = StepperParameters {
                    full_steps_per_turn: stepper.full_steps_per_turn,
                    microsteps,
                    inertia: motor.inertia + inertia * lever * lever,
                    coulomb: motor.friction + coulomb * lever,
                    viscous: viscous * lever * lever,
                    torque: motor.torque.clone(),
                };
                Some((start, StepperMotor::new(&parameters)?))
            }
            _ => None,
        };
        Ok(Self {
            per_step: 1.0 / (stepper.full_steps_per_unit() * f64::from(microsteps)),
            microsteps: f64::from(microsteps),
            per_rad: stepper.per_turn / TAU,
            positive: true,
            count: start,
            motor,
            at_s: 0.0,
        })
    }

    pub(super) fn turn(&mut self, positive: bool) {
        self.positive = positive;
    }

    pub(super) fn pulse(&mut self, tick: u64, tick_s: f64) {
        self.advance(tick as f64 * tick_s);
        self.count += if self.positive { 1.0 } else { -1.0 };
        if let Some((_, motor)) = &mut self.motor {
            motor.pulse(self.positive);
        }
    }

    /// Simulates the motor up to `until_s`, s.
    pub(super) fn advance(&mut self, until_s: f64) {
        if let Some((_, motor)) = &mut self.motor {
            motor.advance(until_s - self.at_s, 0.0);
        }
        self.at_s = until_s;
    }

    /// Keeps the rotor at rest up to `until_s`, s: the brake holds it.
    pub(super) fn rest(&mut self, until_s: f64) {
        self.at_s = until_s;
    }

    /// Position, mm or rad.
    pub(super) fn position(&self) -> f64 {
        match &self.motor {
            Some((start, motor)) => start * self.per_step + motor.angle() * self.per_rad,
            None => self.count * self.per_step,
        }
    }

    /// Steps that the rotor has lost.
    pub(super) fn lost(&self) -> f64 {
        self.motor.as_ref().map_or(0.0, |(_, motor)| motor.lost_full_steps() as f64 * self.microsteps)
    }
}
