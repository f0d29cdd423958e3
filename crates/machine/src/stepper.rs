/// A two-phase stepper and its driver, fed with step and direction pulses; mm or rad, s.
#[derive(Debug, Clone, PartialEq)]
pub struct Stepper {
    /// Full steps of a turn of the motor, a multiple of 4.
    pub full_steps_per_turn: u32,
    /// What a turn of the motor moves the axis by, mm or rad.
    pub per_turn: f64,
    /// Pulses of a full step that the driver can be set to, increasing, at least one.
    pub microsteps: Vec<u32>,
    /// Way of a pulse that is wanted, mm or rad.
    pub resolution: f64,
    /// Highest pulse frequency of the driver, Hz.
    pub max_pulse_hz: f64,
    /// Shortest time of the step line high, and of the step line low, s.
    pub min_pulse_s: f64,
    /// Time from a change of the direction line to the next pulse's rising edge, s.
    pub direction_setup_s: f64,
    /// Time from a pulse's falling edge to a change of the direction line, s.
    pub direction_hold_s: f64,
    /// What the model of the motor needs, if the file has it.
    pub motor: Option<StepperMotor>,
}

/// What is known of a stepper's motor, for the model that shows lost steps.
#[derive(Debug, Clone, PartialEq)]
pub struct StepperMotor {
    /// Inertia of the rotor, kg m^2.
    pub inertia: f64,
    /// Coulomb friction of the rotor, N m.
    pub friction: f64,
    /// Pull-out torque (N m) at speeds of the motor (rad/s): increasing, the first 0 with the holding torque.
    pub torque: Vec<(f64, f64)>,
}

impl Stepper {
    /// Full steps per mm or rad of the axis.
    pub fn full_steps_per_unit(&self) -> f64 {
        f64::from(self.full_steps_per_turn) / self.per_turn
    }
}
