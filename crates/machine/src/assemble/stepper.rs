use super::axis::of_another_kind;
use crate::axis::{Axis, AxisKind};
use crate::file::{File, StepperFile};
use crate::stepper::{Stepper, StepperMotor};
use seamwright_document::{DocumentError, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use std::f64::consts::TAU;

const MAX_MICROSTEPS: u32 = 4096;
/// Full steps per electrical period of a two-phase motor.
const PERIOD: u32 = 4;

pub(super) fn stepper(file: &File, axis: &Axis, s: &StepperFile) -> Result<Stepper, DocumentError> {
    let key = |k: &str| format!("drives.{}.stepper.{k}", axis.name);
    let per_turn = of_kind(file, axis, s.mm_per_turn, s.deg_per_turn, ["mm_per_turn", "deg_per_turn"])?;
    let resolution = of_kind(file, axis, s.resolution_mm, s.resolution_deg, ["resolution_mm", "resolution_deg"])?;
    if s.full_steps_per_turn == 0 || !s.full_steps_per_turn.is_multiple_of(PERIOD) {
        return Err(file.fault_at(&key("full_steps_per_turn"), "machine-full-steps", "machine-multiple-of-4"));
    }
    let increasing = s.microsteps.windows(2).all(|w| w[0] < w[1]);
    if s.microsteps.is_empty() || !increasing || s.microsteps.iter().any(|m| !(1..=MAX_MICROSTEPS).contains(m)) {
        let allowed = Message::new("machine-microsteps-allowed").text("max", MAX_MICROSTEPS.to_string());
        return Err(file.error_at(&key("microsteps"), Message::new("machine-microsteps-invalid"), allowed));
    }
    let (max_pulse_hz, min_pulse_s) = (s.max_pulse_hz.get(), s.min_pulse_us.get() * 1e-6);
    if max_pulse_hz * 2.0 * min_pulse_s > 1.0 + 1e-9 {
        let message = Message::new("machine-pulse-time").value("time", s.min_pulse_us.get(), Unit::Us);
        let allowed = Message::new("document-at-most").value("max", 0.5 / min_pulse_s, Unit::Hz);
        return Err(file.error_at(&key("max_pulse_hz"), message, allowed));
    }
    Ok(Stepper {
        full_steps_per_turn: s.full_steps_per_turn,
        per_turn,
        microsteps: s.microsteps.clone(),
        resolution,
        max_pulse_hz,
        min_pulse_s,
        direction_setup_s: s.direction_setup_us.get() * 1e-6,
        direction_hold_s: s.direction_hold_us.get() * 1e-6,
        motor: motor(file, axis, s)?,
    })
}

/// The one of two values that belongs to the axis' kind, in mm or rad; the other must be missing.
fn of_kind(
    file: &File,
    axis: &Axis,
    mm: Option<Positive>,
    deg: Option<Positive>,
    keys: [&str; 2],
) -> Result<f64, DocumentError> {
    let path = format!("drives.{}.stepper", axis.name);
    let (value, wrong, [key, wrong_key]) = match axis.kind {
        AxisKind::Linear => (mm, deg, keys),
        AxisKind::Rotary => (deg, mm, [keys[1], keys[0]]),
    };
    if wrong.is_some() {
        return Err(file.error_at(&format!("{path}.{wrong_key}"), of_another_kind(axis.kind), key));
    }
    let value = value.ok_or_else(|| {
        let message = Message::new("machine-stepper-lacks-key").key("key", key);
        file.error_at(&path, message, Message::new("machine-key-positive").key("key", key))
    })?;
    Ok(axis.from_file(value.get()))
}

fn motor(file: &File, axis: &Axis, s: &StepperFile) -> Result<Option<StepperMotor>, DocumentError> {
    let path = format!("drives.{}.stepper", axis.name);
    let (inertia, rpm, torque) = match (&s.rotor_inertia_kg_m2, &s.torque_rpm, &s.torque_n_m) {
        (None, None, None) if s.rotor_friction_n_m.is_none() => return Ok(None),
        (Some(inertia), Some(rpm), Some(torque)) => (inertia, rpm, torque),
        _ => {
            return Err(file.fault_at(&path, "machine-motor-key-missing", "machine-motor-keys"));
        }
    };
    if rpm.len() != torque.len() || rpm.len() < 2 {
        let message = Message::new("machine-torque-lengths").count("speeds", rpm.len()).count("torques", torque.len());
        let allowed = Message::new("machine-torque-equal-lengths");
        return Err(file.error_at(&format!("{path}.torque_n_m"), message, allowed));
    }
    if rpm[0].get() > 0.0 || rpm.windows(2).any(|w| w[0] >= w[1]) {
        let message = Message::new("machine-torque-speeds");
        let allowed = Message::new("machine-zero-then-increasing");
        return Err(file.error_at(&format!("{path}.torque_rpm"), message, allowed));
    }
    if torque[0].get() <= 0.0 {
        return Err(file.fault_at(&format!("{path}.torque_n_m"), "machine-torque-holding", "machine-torque-first"));
    }
    let points = rpm.iter().zip(torque.iter().copied().map(NonNegative::get));
    let torque = points.map(|(rpm, torque)| (rpm.get() / 60.0 * TAU, torque)).collect();
    let friction = s.rotor_friction_n_m.map_or(0.0, NonNegative::get);
    Ok(Some(StepperMotor { inertia: inertia.get(), friction, torque }))
}
