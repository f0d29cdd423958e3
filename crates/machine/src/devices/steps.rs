use super::file::StepsFile;
use crate::axis::Axis;
use crate::file::MachineFile;
use seamwright_document::{Document, DocumentError};
use seamwright_message::{Message, Unit};

/// The drives by step and direction pulses. Every axis has a stepper that meets its resolution with valid pulses for
/// its driver. That holds up to the maximum speed, and at reversals under the maximum acceleration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Steps {
    /// File or named pipe for the pulses, beside the machine file.
    pub stream: Option<String>,
    /// Tick of the timer, ns.
    pub tick_ns: u32,
    /// Ticks of a period.
    pub period: u64,
}

impl Steps {
    /// Tick of the timer, s.
    pub fn tick_s(&self) -> f64 {
        f64::from(self.tick_ns) * 1e-9
    }
}

/// Default tick, ns.
const TICK_NS: u32 = 100;
/// Fraction of the maximum frequency reserved for the rounding of positions.
const RESERVE: f64 = 1e-6;

pub(super) fn steps(
    file: &Document<MachineFile>,
    axes: &[Axis],
    name: &str,
    device: &StepsFile,
) -> Result<Steps, DocumentError> {
    let at = |key: &str| format!("devices.{name}.steps.{key}");
    if let Some(stream) = device.stream.as_ref().filter(|stream| !stream.ends_with(".vcd") || stream.len() == 4) {
        let message = Message::new("machine-stream-file").text("file", stream);
        return Err(file.error_at(&at("stream"), message, Message::new("machine-stream-file-allowed")));
    }
    let period_ns = 1e6 * file.value.servo_period_ms.map_or(1.0, seamwright_document::Positive::get);
    let tick_ns = device.tick_ns.unwrap_or(TICK_NS);
    let ticks = period_ns / f64::from(tick_ns);
    if !(10..=100_000).contains(&tick_ns) || ticks < 1.0 || (ticks - ticks.round()).abs() > 1e-9 * ticks {
        let message = Message::new("machine-tick").value("tick", f64::from(tick_ns), Unit::Ns);
        let allowed = Message::new("machine-tick-allowed").value("period", period_ns, Unit::Ns);
        return Err(file.error_at(&at("tick_ns"), message, allowed));
    }
    let steps = Steps { stream: device.stream.clone(), tick_ns, period: ticks.round() as u64 };
    for axis in axes {
        check(file, name, axis, &steps)?;
    }
    Ok(steps)
}

/// Checks that all pulses for the motion of an axis can be generated.
fn check(file: &Document<MachineFile>, name: &str, axis: &Axis, steps: &Steps) -> Result<(), DocumentError> {
    let Some(stepper) = &axis.stepper else {
        let message = Message::new("machine-stepper-missing").axis("axis", &axis.name);
        let allowed = Message::new("machine-stepper-or-other-drives").axis("axis", &axis.name);
        return Err(file.error_at(&format!("devices.{name}.steps"), message, allowed));
    };
    let resolution = format!("resolution_{}", axis.unit());
    let at = |key: &str| format!("drives.{}.stepper.{key}", axis.name);
    let Some(microsteps) = stepper.least_microsteps() else {
        let finest = stepper.microsteps.last().copied().map_or(1.0, f64::from);
        let finest = axis.to_file(1.0 / (stepper.full_steps_per_unit() * finest));
        let message = Message::new("machine-resolution-too-fine");
        let allowed = Message::new("document-at-least").value("min", finest, axis.position_unit());
        return Err(file.error_at(&at(&resolution), message, allowed));
    };
    let per_unit = stepper.full_steps_per_unit() * f64::from(microsteps);
    let driver = stepper.ticks(steps.tick_s());
    let most_hz = (1.0 - RESERVE) / (driver.spacing as f64 * steps.tick_s());
    let needed_hz = axis.max_speed * per_unit;
    if needed_hz > most_hz {
        let message = Message::new("machine-pulse-rate")
            .axis("axis", &axis.name)
            .quantity("needed", needed_hz, Unit::Hz, 0)
            .quantity("speed", axis.to_file(axis.max_speed), axis.speed_unit(), 6)
            .text("microsteps", microsteps.to_string())
            .quantity("possible", most_hz, Unit::Hz, 0);
        let allowed = Message::new("machine-pulse-rate-allowed")
            .quantity("speed", axis.to_file(most_hz / per_unit), axis.speed_unit(), 6)
            .key("resolution", resolution);
        return Err(file.error_at(&at("max_pulse_hz"), message, allowed));
    }
    // The first pulse after a reversal comes within a step of the turning point; then the axis accelerates.
    let period_s = steps.period as f64 * steps.tick_s();
    let (way, a) = (1.0 / per_unit, axis.max_acceleration);
    let fastest = ((2.0 * a * way).sqrt() + 2.0 * a * period_s).min(axis.max_speed);
    let pulses = (fastest * period_s * per_unit).ceil() as u64 + 1;
    let turn = driver.width.saturating_add(driver.hold).saturating_add(driver.setup);
    if turn.saturating_add(pulses * driver.spacing) > steps.period {
        let most = steps.period.saturating_sub(pulses * driver.spacing + driver.width) as f64 * steps.tick_s() * 1e6;
        let message = Message::new("machine-pulses-after-reversal").count("n", pulses as usize);
        let allowed = Message::new("machine-direction-times-allowed").quantity("time", most, Unit::Us, 1);
        return Err(file.error_at(&at("direction_setup_us"), message, allowed));
    }
    Ok(())
}
