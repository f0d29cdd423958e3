use super::play::Place;
use super::timer::{Clock, Stepped};
use crate::refusals::in_file;
use seamwright_machine::{AxisKind, Load};
use seamwright_message::Message;
use seamwright_motion::pulses::{Edge, Event};
use seamwright_project::failure::Failure;
use seamwright_servo::{StepperMotor, StepperParameters};
use std::f64::consts::TAU;

/// Long enough for a rotor to come to rest after the last pulse, s.
const REST_S: f64 = 1.0;

/// The model of a motor that hears the pulses.
pub(super) struct Motor {
    model: StepperMotor,
    positive: bool,
    tick: u64,
    /// Tick and position of the last pulse up to which no step was lost.
    pub(super) held: Option<(u64, Place)>,
}

impl Motor {
    /// The motor of an axis, with the axis' load on its shaft; `None` if the machine file does not describe it.
    pub(super) fn new(axis: &Stepped) -> Result<Option<Self>, Failure> {
        let (Some(motor), Some(Load { inertia, coulomb, viscous, .. })) = (&axis.stepper.motor, axis.load) else {
            return Ok(None);
        };
        // Way of the axis for a rad of the shaft, m or rad.
        let unit = if axis.axis.kind == AxisKind::Linear { 1e-3 } else { 1.0 };
        let lever = axis.stepper.per_turn * unit / TAU;
        let parameters = StepperParameters {
            full_steps_per_turn: axis.stepper.full_steps_per_turn,
            microsteps: axis.choice.microsteps,
            inertia: motor.inertia + inertia * lever * lever,
            coulomb: motor.friction + coulomb * lever,
            viscous: viscous * lever * lever,
            torque: motor.torque.clone(),
        };
        let model = StepperMotor::new(&parameters)
            .map_err(|e| Failure::input(in_file(&format!("drives.{}.stepper", axis.name), Message::outside(&e))))?;
        Ok(Some(Self { model, positive: true, tick: 0, held: None }))
    }

    pub(super) fn hear(&mut self, event: Event, place: &Place, clock: &Clock) {
        match event.edge {
            Edge::Fall => {}
            Edge::Direction(positive) => self.positive = positive,
            Edge::Rise => {
                self.model.advance(clock.seconds(event.tick - self.tick), 0.0);
                self.model.pulse(self.positive);
                self.tick = event.tick;
                if self.held.is_none() || self.model.lost_full_steps() == 0 {
                    self.held = Some((event.tick, *place));
                }
            }
        }
    }

    /// Full steps lost for good.
    pub(super) fn lost(&mut self) -> i64 {
        self.model.advance(REST_S, 0.0);
        self.model.lost_full_steps()
    }
}
