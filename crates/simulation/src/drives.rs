use crate::disturbance::Disturbance;
use seamwright_executive::Error;
use seamwright_machine::{Axis, AxisKind, Drive, Load, Machine};
use seamwright_message::Message;
use seamwright_servo::{
    AxisState, DriveParameters, DriveTuning, Gains, LinearLoad, PositionLoop, RotaryLoad, ServoAxis, SetPoint, Tuned,
    tune,
};

/// All drives of a machine in simulation.
#[derive(Debug, Clone)]
pub(crate) struct DriveSet {
    axes: Vec<(ServoAxis, Disturbance)>,
}

/// Maximum speed of the position loop relative to the axis limit, so that it can catch up.
const SPEED_RESERVE: f64 = 1.2;

impl DriveSet {
    pub(crate) fn new(machine: &Machine, seed: u64) -> Result<Self, Error> {
        let axes = machine.axes.iter().enumerate().map(|(i, axis)| {
            let drive = axis.drive.clone().unwrap_or_else(|| assumed(axis));
            let pitch = match axis.kind {
                AxisKind::Linear => 10.0,
                AxisKind::Rotary => 5f64.to_radians(),
            };
            let servo = servo(axis, &drive, machine.servo_period_s)
                .map_err(|e| Error::Drive { axis: axis.name.clone(), reason: Message::outside(&e) })?;
            Ok::<_, Error>((servo, Disturbance::new(seed, i, drive.load.peak, pitch)))
        });
        Ok(Self { axes: axes.collect::<Result<_, Error>>()? })
    }

    /// Puts every axis at rest at its position in `q`.
    pub(crate) fn settle_at(&mut self, q: &[f64]) {
        for ((servo, _), position) in self.axes.iter_mut().zip(q) {
            servo.settle_at(*position, 0.0);
        }
    }

    /// Simulates one servo period of axis `i`.
    pub(crate) fn step(&mut self, i: usize, set: SetPoint) -> AxisState {
        let (servo, disturbance) = &mut self.axes[i];
        let force = disturbance.next(servo.drive().position());
        // Cogging acts on the motor.
        servo.step(set, seamwright_servo::Disturbance { motor: force, load: 0.0 })
    }
}

/// Checks the drive values of the machine file.
///
/// # Errors
/// [`Error::Drive`] with the first axis whose values are invalid.
pub fn check_drives(machine: &Machine) -> Result<(), Error> {
    DriveSet::new(machine, 0).map(drop)
}

/// Default drive for an axis without one in the file: unit inertia, three times the required acceleration, 5 %
/// friction.
fn assumed(axis: &Axis) -> Drive {
    let per_metre = if axis.kind == AxisKind::Linear { 1e-3 } else { 1.0 };
    let peak = 3.0 * axis.max_acceleration * per_metre;
    let counts = if axis.kind == AxisKind::Linear { 1000.0 } else { 10_000f64 * 1f64.to_degrees() };
    Drive {
        load: Load { inertia: 1.0, peak, coulomb: 0.05 * peak, viscous: 0.0 },
        force_limit: None,
        encoder_counts_per_unit: counts,
        velocity_bandwidth_hz: 40.0,
        current_time_constant_s: 2e-4,
        current_delay_s: 0.0,
        transmission: None,
        gains: None,
        notches: Vec::new(),
        friction_compensation: None,
        backlash_compensation: None,
    }
}

/// Tunes the position loop of `axis` on its drive in simulation, or on the default one if the file has no drive.
///
/// # Errors
/// [`Error::Drive`] if its values are invalid, or the drive cannot be tuned.
pub fn tune_axis(axis: &Axis, period_s: f64) -> Result<Tuned, Error> {
    parameters(axis, &axis.drive.clone().unwrap_or_else(|| assumed(axis)))
        .and_then(|parameters| tune(&parameters, period_s, axis.max_speed))
        .map_err(|e| Error::Drive { axis: axis.name.clone(), reason: Message::outside(&e) })
}

fn parameters(axis: &Axis, drive: &Drive) -> Result<DriveParameters, seamwright_servo::Error> {
    let Load { inertia, peak, coulomb, viscous } = drive.load;
    let tuning = DriveTuning {
        velocity_bandwidth_hz: drive.velocity_bandwidth_hz,
        current_time_constant_s: drive.current_time_constant_s,
        current_delay_s: drive.current_delay_s,
        encoder_counts_per_unit: drive.encoder_counts_per_unit,
    };
    let mut parameters = match axis.kind {
        AxisKind::Linear => DriveParameters::linear(
            LinearLoad { mass_kg: inertia, peak_force_n: peak, coulomb_n: coulomb, viscous_n_s_per_m: viscous },
            tuning,
        ),
        AxisKind::Rotary => DriveParameters::rotary(
            RotaryLoad {
                inertia_kg_m2: inertia,
                peak_torque_nm: peak,
                coulomb_nm: coulomb,
                viscous_nm_s_per_rad: viscous,
            },
            tuning,
        ),
    }?;
    if let Some(limit) = drive.force_limit {
        parameters = parameters.with_force_limit(limit)?;
    }
    match drive.transmission {
        Some(transmission) => parameters.with_transmission(transmission),
        None => Ok(parameters),
    }
}

fn servo(axis: &Axis, drive: &Drive, period: f64) -> Result<ServoAxis, seamwright_servo::Error> {
    let gains = drive.gains.unwrap_or_else(|| Gains::suggested(drive.velocity_bandwidth_hz, period));
    let mut position_loop = PositionLoop::new(gains, period, SPEED_RESERVE * axis.max_speed)?;
    for n in &drive.notches {
        position_loop = position_loop.with_notch(n.build(period)?)?;
    }
    if let Some(friction) = drive.friction_compensation {
        position_loop = position_loop.with_friction(friction)?;
    }
    if let Some(backlash) = drive.backlash_compensation {
        position_loop = position_loop.with_backlash(backlash)?;
    }
    ServoAxis::with_loop(position_loop, parameters(axis, drive)?)
}
