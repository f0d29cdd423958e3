//! Mechanism behind the motor: one rigid mass, or two masses with a spring and a gap between them.

use std::f64::consts::TAU;

use crate::load::Load;
use crate::parameters::{EncoderSide, Transmission};

/// Friction of the whole axis, divided by its whole inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Friction {
    /// Coulomb friction (u/s^2).
    pub(crate) coulomb: f64,
    pub(crate) viscous: f64,
}

/// Motor and load. Forces are divided by the whole inertia, so they are accelerations (u/s^2).
///
/// Without a transmission it is one [`Load`], exact for a constant push. With one, `xm`, `vm` and the part `m` of the
/// inertia belong to the motor; `xl`, `vl` and the part `l = 1 - m` to the load. The force between them is
/// `k z + c dz/dt`, with the wind-up `z = xm - xl` less the gap. For a free oscillation of `w` (rad/s) and damping
/// `zeta`, `k = w^2 m l` and `c = 2 zeta w m l`. There is no force in the gap, and a contact does not pull.
///
/// **Accuracy.** Each call applies the force at its midpoint; the masses then move in closed form under it. For a
/// spring alone this is the symplectic method of Verlet: second order, no drift of the energy, frequency high by the
/// part `(w h)^2 / 24`. The damper is evaluated at the midpoint as well. The error of a contact or a stop within a call
/// is of first order in the call's duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Mechanism {
    motor: Load,
    far: Option<Far>,
}

/// The load at the far end of the transmission.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Far {
    load: Load,
    encoder_on: EncoderSide,
    motor_part: f64,
    load_part: f64,
    stiffness: f64,
    damping: f64,
    half_gap: f64,
}

impl Mechanism {
    /// Creates a mechanism at rest at 0, in the middle of its gap.
    pub(crate) fn new(friction: Friction, transmission: Option<Transmission>) -> Self {
        let Friction { coulomb, viscous } = friction;
        let Some(t) = transmission else {
            return Self { motor: Load::new(coulomb, viscous), far: None };
        };
        let (motor_part, load_part) = (1.0 / (1.0 + t.load_ratio), t.load_ratio / (1.0 + t.load_ratio));
        let w = TAU * t.resonance_hz;
        let (near, there) = (t.motor_friction / motor_part, (1.0 - t.motor_friction) / load_part);
        Self {
            motor: Load::new(coulomb * near, viscous * near),
            far: Some(Far {
                load: Load::new(coulomb * there, viscous * there),
                encoder_on: t.encoder_on,
                motor_part,
                load_part,
                stiffness: w * w * motor_part * load_part,
                damping: 2.0 * t.damping * w * motor_part * load_part,
                half_gap: 0.5 * t.backlash,
            }),
        }
    }

    /// Applies `push` to the motor and `outside` to the load for `duration` (s).
    pub(crate) fn advance(&mut self, push: f64, outside: f64, duration: f64) {
        match &mut self.far {
            None => self.motor.advance(push + outside, duration),
            Some(far) => {
                let force = far.force(&self.motor, push, outside, duration);
                self.motor.advance((push - force) / far.motor_part, duration);
                far.load.advance((force + outside) / far.load_part, duration);
            }
        }
    }

    /// Puts it at rest with the encoder at `position` (u), the motor holding with `hold` (u/s^2) against a force on the
    /// load.
    pub(crate) fn settle_at(&mut self, position: f64, hold: f64) {
        let rest = |load: &mut Load, at: f64| (load.position, load.velocity) = (at, 0.0);
        rest(&mut self.motor, position);
        if let Some(far) = &mut self.far {
            let contact = if hold == 0.0 { 0.0 } else { hold.signum() * far.half_gap };
            let wound = contact + hold / far.stiffness;
            match far.encoder_on {
                EncoderSide::Motor => rest(&mut far.load, position - wound),
                EncoderSide::Load => {
                    rest(&mut self.motor, position + wound);
                    rest(&mut far.load, position);
                }
            }
        }
    }

    pub(crate) fn motor(&self) -> &Load {
        &self.motor
    }

    pub(crate) fn load(&self) -> &Load {
        self.far.as_ref().map_or(&self.motor, |far| &far.load)
    }

    pub(crate) fn measured(&self) -> &Load {
        match &self.far {
            Some(far) if far.encoder_on == EncoderSide::Load => &far.load,
            _ => &self.motor,
        }
    }
}

impl Far {
    /// Returns the force from the motor to the load through the transmission, half way through `duration`.
    fn force(&self, motor: &Load, push: f64, outside: f64, duration: f64) -> f64 {
        let half = 0.5 * duration;
        let rate = motor.velocity - self.load.velocity;
        let wound = motor.position - self.load.position + rate * half;
        let pressed = wound - wound.clamp(-self.half_gap, self.half_gap);
        if self.half_gap > 0.0 && pressed == 0.0 {
            return 0.0;
        }
        // The rate half way depends on the force itself: a linear equation, for masses that continue to slide or stick.
        let (near, there) = (motor.mobility(), self.load.mobility());
        let share = near.part / self.motor_part + there.part / self.load_part;
        let spring = self.stiffness * pressed;
        let free = near.part * push / self.motor_part - near.drag - there.part * outside / self.load_part + there.drag;
        let rate = (rate + half * (free - spring * share)) / (1.0 + half * self.damping * share);
        let force = spring + self.damping * rate;
        if self.half_gap > 0.0 && force * pressed < 0.0 { 0.0 } else { force }
    }
}

#[cfg(test)]
mod tests;
