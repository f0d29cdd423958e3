//! A stepper motor that loses steps when the demand exceeds its torque curve.

use crate::error::Error;
use std::f64::consts::{PI, TAU};

/// Full steps of an electrical period, the unit of a rotor's slip.
const PERIOD: i64 = 4;
/// Maximum time step, as an angle of the rotor's own oscillation, rad.
const FINEST: f64 = 0.05;

/// Parameters of a stepper motor, all at the motor's shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct StepperParameters {
    /// Full steps per turn, a multiple of 4.
    pub full_steps_per_turn: u32,
    /// Pulses per full step.
    pub microsteps: u32,
    /// Inertia of rotor and load, kg m^2.
    pub inertia: f64,
    /// Coulomb friction, N m; static friction is the same.
    pub coulomb: f64,
    /// Viscous friction, N m s/rad.
    pub viscous: f64,
    /// Pull-out torque (N m) over speed (rad/s): increasing speeds from 0, which has the holding torque.
    pub torque: Vec<(f64, f64)>,
}

/// Simulation of a two-phase hybrid stepper with a microstepping driver.
///
/// The field stands at the position of the counted pulses. It pulls the rotor, with `n` full steps a turn, by
/// `T(|w|) sin(n/4 (field - rotor))`. This acts as a spring that is stiff within a full step and strongest one full
/// step away; beyond two it pulls to the next tooth. `T` is the pull-out torque at the rotor's speed `w`, linear
/// between the points of the curve and zero beyond the last. So a curve should cover all speeds in use. Inertia,
/// friction and an outside torque act against it. Detent torque and the currents' own dynamics are not modelled.
///
/// **Lost steps.** A rotor with a demand above `T` falls behind by whole electrical periods, 4 full steps each, and
/// stays behind: [`StepperMotor::lost_full_steps`].
///
/// **Accuracy.** Time steps of at most a twentieth of a radian of the rotor's own oscillation use the torque at their
/// midpoint. Without friction the oscillation neither grows nor decays; friction is of first order in the step.
#[derive(Debug, Clone, PartialEq)]
pub struct StepperMotor {
    curve: Vec<(f64, f64)>,
    inertia: f64,
    coulomb: f64,
    viscous: f64,
    microsteps_per_turn: f64,
    teeth: f64,
    longest_s: f64,
    pulses: i64,
    angle: f64,
    speed: f64,
}

impl StepperMotor {
    /// Creates a motor at rest at 0, its rotor in line with the field.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for an invalid value: steps not a multiple of 4, inertia not above 0, negative friction or
    /// torque. Also for a curve that does not start at rest with a holding torque and increase in speed.
    pub fn new(parameters: &StepperParameters) -> Result<Self, Error> {
        let p = parameters;
        let check = |name, value, good: bool, allowed| {
            if good { Ok(()) } else { Err(Error::OutOfRange { name, value, allowed }) }
        };
        let whole = p.full_steps_per_turn > 0 && p.full_steps_per_turn.is_multiple_of(4);
        check("full_steps_per_turn", f64::from(p.full_steps_per_turn), whole, "a multiple of 4")?;
        check("microsteps", f64::from(p.microsteps), p.microsteps > 0, "1 or more")?;
        let fits = |v: f64| v > 0.0 && v <= 1e12;
        check("inertia", p.inertia, fits(p.inertia), "above 0, up to 1e12")?;
        for (name, v) in [("coulomb", p.coulomb), ("viscous", p.viscous)] {
            check(name, v, (0.0..=1e12).contains(&v), "0 to 1e12")?;
        }
        let holding = p.torque.first().copied().unwrap_or((f64::NAN, f64::NAN));
        check("torque", holding.0, holding.0.abs() <= 0.0, "a curve that begins at rest")?;
        check("torque", holding.1, fits(holding.1), "a holding torque above 0, up to 1e12")?;
        for pair in p.torque.windows(2) {
            check("torque", pair[1].0, pair[1].0 > pair[0].0 && fits(pair[1].0), "a curve that goes up in speed")?;
            check("torque", pair[1].1, pair[1].1 >= 0.0 && pair[1].1 <= 1e12, "torques of 0 or more")?;
        }
        let teeth = f64::from(p.full_steps_per_turn) / PERIOD as f64;
        let most = p.torque.iter().map(|t| t.1).fold(0.0, f64::max);
        Ok(Self {
            curve: p.torque.clone(),
            inertia: p.inertia,
            coulomb: p.coulomb,
            viscous: p.viscous,
            microsteps_per_turn: f64::from(p.full_steps_per_turn) * f64::from(p.microsteps),
            teeth,
            longest_s: FINEST / (teeth * most / p.inertia).sqrt(),
            pulses: 0,
            angle: 0.0,
            speed: 0.0,
        })
    }

    /// Applies a pulse of the driver: the field moves by a microstep.
    pub fn pulse(&mut self, positive: bool) {
        self.pulses += if positive { 1 } else { -1 };
    }

    /// Advances by `duration` (s) without a pulse, under an outside torque (N m, positive towards positive angles). A
    /// value that is not finite counts as zero.
    pub fn advance(&mut self, duration: f64, outside: f64) {
        let [duration, outside] = [duration, outside].map(|v| if v.is_finite() { v } else { 0.0 });
        let steps = (duration / self.longest_s).ceil().max(0.0) as u64;
        let step = duration / steps as f64;
        let field = self.field_angle();
        for _ in 0..steps {
            self.step(step, field, outside);
        }
    }

    fn step(&mut self, h: f64, field: f64, outside: f64) {
        let middle = self.angle + 0.5 * h * self.speed;
        let torque = self.pull_out_torque(self.speed) * (self.teeth * (field - middle)).sin() + outside;
        let free = (self.speed + torque / self.inertia * h) / (1.0 + self.viscous / self.inertia * h);
        // Friction removes speed, but at most all of it.
        let braked = (free.abs() - self.coulomb / self.inertia * h).max(0.0).copysign(free);
        self.angle += 0.5 * h * (self.speed + braked);
        self.speed = braked;
    }

    /// Returns the torque curve at `speed` (rad/s), N m.
    pub fn pull_out_torque(&self, speed: f64) -> f64 {
        let speed = speed.abs();
        let above = self.curve.partition_point(|p| p.0 <= speed);
        let (Some(a), Some(b)) = (self.curve.get(above.wrapping_sub(1)), self.curve.get(above)) else { return 0.0 };
        a.1 + (b.1 - a.1) * (speed - a.0) / (b.0 - a.0)
    }

    /// Returns the angle of the rotor, rad.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// Returns the speed of the rotor, rad/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Returns the angle commanded by the pulses, rad.
    pub fn field_angle(&self) -> f64 {
        self.pulses as f64 / self.microsteps_per_turn * TAU
    }

    /// Returns the full steps that the rotor has lost against the pulses: a multiple of 4, positive if its angle is too
    /// low.
    pub fn lost_full_steps(&self) -> i64 {
        let periods = self.teeth * (self.field_angle() - self.angle) / (2.0 * PI);
        PERIOD * periods.round() as i64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 200 steps, 2 N m, J = 1e-4 kg m^2: its own oscillation has 1000 rad/s.
    fn parameters() -> StepperParameters {
        StepperParameters {
            full_steps_per_turn: 200,
            microsteps: 16,
            inertia: 1e-4,
            coulomb: 0.0,
            viscous: 0.0,
            torque: vec![(0.0, 2.0), (500.0, 2.0)],
        }
    }

    fn motor(change: impl FnOnce(&mut StepperParameters)) -> StepperMotor {
        let mut p = parameters();
        change(&mut p);
        StepperMotor::new(&p).unwrap()
    }

    fn run(m: &mut StepperMotor, duration: f64, outside: f64, speed: impl Fn(f64) -> f64) {
        let (tick, step) = (5e-6, TAU / m.microsteps_per_turn);
        let (mut way, mut made) = (0.0, 0i64);
        for k in 0..(duration / tick) as u64 {
            way += tick * speed(k as f64 * tick);
            while (way / step).round() as i64 != made {
                let positive = way / step > made as f64;
                made += if positive { 1 } else { -1 };
                m.pulse(positive);
            }
            m.advance(tick, outside);
        }
    }

    #[test]
    fn leans_on_its_spring() {
        for part in [0.1, -0.5, 0.9] {
            // Loaded slowly, in 1000 small parts.
            let mut m = motor(|p| p.viscous = 0.05);
            (1..=1000).for_each(|i| m.advance(1e-3, 2.0 * part * f64::from(i) / 1000.0));
            m.advance(0.5, 2.0 * part);
            assert!((m.angle() - part.asin() / 50.0).abs() < 1e-9, "{part}: {}", m.angle());
            assert_eq!(m.lost_full_steps(), 0);
        }
    }

    #[test]
    fn swings_at_its_frequency_and_keeps_its_energy() {
        let mut m = motor(|_| ());
        m.pulse(true);
        // Released a 16th of a step away: an oscillation of small angles, for half a minute.
        let (amplitude, mut last, mut crossings, mut highest) = (TAU / 3200.0, 0.0, Vec::new(), 0.0f64);
        for k in 0..1_000_000u32 {
            m.advance(3e-5, 0.0);
            let now = m.angle() - amplitude;
            if last < 0.0 && now >= 0.0 {
                crossings.push(f64::from(k));
            }
            highest = if k > 990_000 { highest.max(now) } else { 0.0 };
            last = now;
        }
        let period = (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64 * 3e-5;
        // The pendulum's period for this amplitude (0.098 rad electrical) is longer by a 16th of its square.
        let expected = TAU / 1000.0 * (1.0 + (PI / 32.0).powi(2) / 16.0);
        assert!((period / expected - 1.0).abs() < 2e-4, "{period} {expected}");
        assert!((highest / amplitude - 1.0).abs() < 1e-3, "{highest} {amplitude}");
    }

    /// A sudden torque makes the rotor slip at the limit from the pendulum's energy: the root m of m (pi - asin m) -
    /// sqrt(1 - m^2) = 1, 0.7246 of the holding torque. A slowly rising torque makes it slip at the holding torque.
    #[test]
    fn slips_where_energy_says() {
        let excess = |m: f64| m * (PI - m.asin()) - (1.0 - m * m).sqrt() - 1.0;
        let (mut low, mut high) = (0.5, 1.0);
        while high - low > 1e-12 {
            let middle = 0.5 * (low + high);
            if excess(middle) < 0.0 { low = middle } else { high = middle }
        }
        assert!((low - 0.7246).abs() < 1e-4);
        let lost = |part: f64| {
            let mut m = motor(|p| p.torque[1].0 = 1e6);
            m.advance(0.2, 2.0 * part);
            m.lost_full_steps()
        };
        assert_eq!(lost(0.999 * low), 0);
        // The rotor runs away forwards: its angle is too high, so the result is negative.
        assert!(lost(1.001 * low) < -100);
        let slowly = |part: f64| {
            let mut m = motor(|p| (p.viscous, p.coulomb) = (0.05, 0.0));
            (1..=2000).for_each(|i| m.advance(1e-3, -2.0 * part * f64::from(i) / 2000.0));
            m.advance(1.0, -2.0 * part);
            m.lost_full_steps()
        };
        assert_eq!(slowly(0.995), 0);
        assert!(slowly(1.005) > 0);
    }

    /// The speed rises until the motor pulls out: the torque curve meets the load and the friction.
    #[test]
    fn falls_out_where_its_curve_ends() {
        for load in [0.4, 0.8, 1.2] {
            // 2 N m at rest, straight down to 0 at 200 rad/s.
            let mut m = motor(|p| {
                p.torque = vec![(0.0, 2.0), (200.0, 0.0)];
                p.coulomb = 0.1;
            });
            let expected = 200.0 * (1.0 - (load + 0.1) / 2.0);
            // An acceleration of 20 rad/s^2 takes 0.002 N m for the inertia.
            let mut at = 0.0;
            while m.lost_full_steps() == 0 && at < 220.0 {
                let from = at;
                run(&mut m, 0.1, -load, |t| from + 20.0 * t);
                at += 2.0;
            }
            assert!((at / expected - 1.0).abs() < 0.05, "load {load}: {at} rad/s, curve {expected}");
            assert!(m.lost_full_steps() > 0);
        }
    }

    /// Acceleration, constant speed and deceleration with a torque reserve of about 60 % lose no steps. A sudden start
    /// at the same speed loses them all, by multiples of four steps.
    #[test]
    fn a_ramp_keeps_what_a_jump_loses() {
        for microsteps in [1, 4, 16, 64] {
            let new = || motor(|p| (p.microsteps, p.coulomb, p.viscous) = (microsteps, 0.05, 1e-3));
            let ramp = |t: f64| (8e3 * t).min(120.0).min(8e3 * (0.3 - t)).max(0.0);
            let mut m = new();
            run(&mut m, 0.5, 0.0, ramp);
            assert_eq!(m.lost_full_steps(), 0, "{microsteps}");
            assert!((m.angle() - m.field_angle()).abs() < TAU / 800.0 && m.field_angle() > 30.0);
            let mut m = new();
            run(&mut m, 0.5, 0.0, |t| if t < 0.3 { 120.0 } else { 0.0 });
            let lost = m.lost_full_steps();
            assert!(lost > 100 && lost % 4 == 0, "{lost}");
            let stands = m.angle() + lost as f64 / 200.0 * TAU - m.field_angle();
            assert!(stands.abs() < TAU / 800.0 && m.speed().abs() < 1e-9, "{stands}");
        }
    }

    #[test]
    fn values_that_no_motor_has() {
        let wrong = |change: fn(&mut StepperParameters)| {
            let mut p = parameters();
            change(&mut p);
            assert!(StepperMotor::new(&p).is_err(), "{p:?}");
        };
        wrong(|p| p.full_steps_per_turn = 201);
        wrong(|p| p.microsteps = 0);
        wrong(|p| p.inertia = f64::NAN);
        wrong(|p| p.coulomb = -1.0);
        wrong(|p| p.viscous = f64::INFINITY);
        wrong(|p| p.torque.clear());
        wrong(|p| p.torque[0].0 = 1.0);
        wrong(|p| p.torque[0].1 = 0.0);
        wrong(|p| p.torque[1].0 = 0.0);
        wrong(|p| p.torque[1].1 = f64::NAN);
    }
}
