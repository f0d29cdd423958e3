/// A two-phase stepper and its driver, fed with step and direction pulses; mm or rad, s.
#[derive(Debug, Clone, PartialEq)]
pub struct Stepper {
    /// Full steps per turn of the motor, a multiple of 4.
    pub full_steps_per_turn: u32,
    /// Displacement of the axis per turn of the motor, mm or rad.
    pub per_turn: f64,
    /// Available microsteps per full step, increasing, at least one.
    pub microsteps: Vec<u32>,
    /// Required displacement per pulse, mm or rad.
    pub resolution: f64,
    /// Maximum pulse frequency of the driver, Hz.
    pub max_pulse_hz: f64,
    /// Minimum time of the step line high, and of the step line low, s.
    pub min_pulse_s: f64,
    /// Time from a change of the direction line to the next pulse's rising edge, s.
    pub direction_setup_s: f64,
    /// Time from a pulse's falling edge to a change of the direction line, s.
    pub direction_hold_s: f64,
    /// Data for the model of the motor, if the file has them.
    pub motor: Option<StepperMotor>,
}

/// Data of a stepper's motor, for the model that detects lost steps.
#[derive(Debug, Clone, PartialEq)]
pub struct StepperMotor {
    /// Inertia of the rotor, kg m^2.
    pub inertia: f64,
    /// Coulomb friction of the rotor, N m.
    pub friction: f64,
    /// Pull-out torque (N m) at speeds of the motor (rad/s): increasing, the first 0 with the holding torque.
    pub torque: Vec<(f64, f64)>,
}

/// A driver's times in ticks of a timer, each rounded so that the driver's limit holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PulseTicks {
    /// The step line is high for this long, and low for at least as long.
    pub width: u64,
    /// Minimum spacing of rising edges.
    pub spacing: u64,
    /// From a change of direction to the next rising edge.
    pub setup: u64,
    /// From a falling edge to a change of direction.
    pub hold: u64,
}

/// Maximum ticks of a driver's time: longer times are clamped to it, since no pulse fits beside them.
const LONGEST: f64 = 1e12;

impl Stepper {
    /// Its driver's times on a timer with ticks of `tick_s` (s).
    pub fn ticks(&self, tick_s: f64) -> PulseTicks {
        // Rounds up, ignoring rounding errors of the quotient.
        let ticks = |s: f64| (s / tick_s * (1.0 - 1e-12)).ceil().clamp(0.0, LONGEST) as u64;
        let width = ticks(self.min_pulse_s).max(1);
        let spacing = ticks(1.0 / self.max_pulse_hz).max(2 * width);
        PulseTicks { width, spacing, setup: ticks(self.direction_setup_s), hold: ticks(self.direction_hold_s) }
    }

    /// The minimum microsteps per full step that meet the resolution; none if the driver's finest setting does not.
    pub fn least_microsteps(&self) -> Option<u32> {
        let meets = |m: u32| 1.0 / (self.full_steps_per_unit() * f64::from(m)) <= self.resolution * (1.0 + 1e-12);
        self.microsteps.iter().copied().find(|m| meets(*m))
    }

    /// Full steps per mm or rad of the axis.
    pub fn full_steps_per_unit(&self) -> f64 {
        f64::from(self.full_steps_per_turn) / self.per_turn
    }
}
