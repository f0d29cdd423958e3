//! The devices of a run: those that the machine file names, and simulated ones for the rest.

use crate::failure::{Failure, with_hint};
use crate::pulse_file::StreamedSteps;
use seamwright_executive::devices::TrafficView;
use seamwright_executive::devices::modbus::ModbusError;
use seamwright_executive::devices::robot::{RobotDrives, RobotError, RobotFault};
#[cfg(target_os = "linux")]
use seamwright_executive::devices::{DeviceSet, Drives, InputBits, Inputs, LinuxCncDrives, Source, modbus};
use seamwright_executive::{DriveReport, SourceReport};
use seamwright_machine::{LinuxCnc, Machine};
use seamwright_message::{Argument, Language, Message, Unit};
use seamwright_simulation::devices::{Device, Fault, Faulty, SimulatedDrives, SimulatedInputs, SimulatedSource};
use serde_json::{Value, json};
use std::io::Write as _;
use std::path::Path;

/// Devices, each with its plan of faults.
pub type Cell = DeviceSet<
    Faulty<Box<dyn Drives + Send>, DriveReport>,
    Faulty<Box<dyn Source + Send>, SourceReport>,
    Faulty<Box<dyn Inputs + Send>, InputBits>,
>;

/// Traffic on the lines to devices, by their names.
pub type Lines = Vec<(String, TrafficView)>;

/// Periods at which a cell runs, ms.
const PERIODS_MS: [f64; 2] = [0.25, 4.0];

/// Refuses a period at which no cell runs in real time.
///
/// # Errors
/// The machine file's period, and the allowed range.
pub fn check_period(machine: &Machine) -> Result<(), Failure> {
    let [least, most] = PERIODS_MS;
    let ms = 1e3 * machine.servo_period_s;
    // Rounding of the file's milliseconds is permitted.
    if (least - 1e-9..=most + 1e-9).contains(&ms) {
        return Ok(());
    }
    let message =
        Message::new("project-period-of-no-cell").text("machine", &machine.name).value("period", ms, Unit::Ms);
    let allowed = Message::new("project-periods").value("min", least, Unit::Ms).value("max", most, Unit::Ms);
    Err(Failure::refused(message, allowed))
}

/// Simulated devices.
///
/// # Errors
/// Values in the machine file that make no drive.
pub fn simulated(machine: &Machine, faults: &[Fault], seed: u64) -> Result<Cell, Failure> {
    let inputs = SimulatedInputs::all_met(machine);
    let source = SimulatedSource::new(seed, machine.servo_period_s);
    Ok(put_together(machine, simulated_drives(machine, seed)?, Box::new(source), Box::new(inputs), faults))
}

fn simulated_drives(machine: &Machine, seed: u64) -> Result<Box<dyn Drives + Send>, Failure> {
    Ok(Box::new(SimulatedDrives::new(machine, seed).map_err(|e| Failure::Input(e.message()))?))
}

/// Connects the drives that the machine file names; a robot control has a line of its own.
fn drives(machine: &Machine, folder: &Path, lines: &mut Lines) -> Result<Option<Box<dyn Drives + Send>>, Failure> {
    if let Some(device) = &machine.devices.robot {
        let (drives, traffic) = RobotDrives::connect(machine, device).map_err(|e| unconnected(&e))?;
        lines.push((device.name.clone(), traffic));
        return Ok(Some(Box::new(drives)));
    }
    if let Some(device) = &machine.devices.linuxcnc {
        return linuxcnc_drives(machine, folder, device).map(Some);
    }
    let Some(device) = &machine.devices.steps else { return Ok(None) };
    Ok(Some(Box::new(StreamedSteps::start(machine, device, folder)?)))
}

/// The failure of a robot control, with what to check if it does not answer.
fn unconnected(error: &RobotError) -> Failure {
    let is_silent = matches!(error.fault, RobotFault::Unreachable(_) | RobotFault::NoReports);
    let hint = || Message::new("project-check-robot").text("protocol", error.protocol);
    Failure::Environment(if is_silent { with_hint(error.message(), hint()) } else { error.message() })
}

fn note(text: &str) {
    // Errors are ignored: standard error may be closed.
    let _ = writeln!(std::io::stderr(), "{}", Message::new("project-note").text("note", text));
}

#[cfg(target_os = "linux")]
fn linuxcnc_drives(machine: &Machine, folder: &Path, device: &LinuxCnc) -> Result<Box<dyn Drives + Send>, Failure> {
    let drives = LinuxCncDrives::start(machine, device, folder, |message| note(&message.to_string()));
    Ok(Box::new(drives.map_err(|e| Failure::Environment(e.message()))?))
}

#[cfg(not(target_os = "linux"))]
fn linuxcnc_drives(_: &Machine, _: &Path, _: &LinuxCnc) -> Result<Box<dyn Drives + Send>, Failure> {
    Err(Failure::Environment(Message::new("project-linuxcnc-needs-linux")))
}

fn put_together(
    machine: &Machine,
    drives: Box<dyn Drives + Send>,
    source: Box<dyn Source + Send>,
    inputs: Box<dyn Inputs + Send>,
    faults: &[Fault],
) -> Cell {
    let period = machine.servo_period_s;
    DeviceSet {
        drives: Faulty::new(drives, Device::Drives, faults, period),
        source: Faulty::new(source, Device::Source, faults, period),
        inputs: Faulty::new(inputs, Device::Inputs, faults, period),
    }
}

/// The devices that the machine file names, connected (a HAL file as seen from `folder`); `values` are the names of the
/// job's process values. Reports which devices are simulated.
///
/// # Errors
/// An unreachable device, or one that has no register for a process value.
pub fn of_machine(
    machine: &Machine,
    folder: &Path,
    values: &[String],
    faults: &[Fault],
    seed: u64,
) -> Result<(Cell, Lines), Failure> {
    let mut source: Option<Box<dyn Source + Send>> = None;
    let mut inputs: Option<Box<dyn Inputs + Send>> = None;
    let mut lines = Lines::new();
    for device in &machine.devices.modbus {
        let parts = modbus::connect(device, values).map_err(|e| failure(&e))?;
        if let Some(part) = parts.source {
            source = Some(Box::new(part));
        }
        if let Some(part) = parts.inputs {
            inputs = Some(Box::new(part));
        }
        lines.push((device.name.clone(), parts.traffic));
    }
    let drives = drives(machine, folder, &mut lines)?;
    let missing = [
        ("project-drives", drives.is_none()),
        ("project-process-source", source.is_none()),
        ("project-inputs", inputs.is_none()),
    ];
    let simulated: Vec<&'static str> = missing.iter().filter(|m| m.1).map(|m| m.0).collect();
    if simulated.len() < missing.len() && !simulated.is_empty() {
        let devices = simulated.into_iter().map(|code| Argument::Message(Box::new(Message::new(code))));
        note(&Message::new("project-simulated").list("devices", devices).to_string());
    }
    let source = source.unwrap_or_else(|| Box::new(SimulatedSource::new(seed, machine.servo_period_s)));
    let inputs = inputs.unwrap_or_else(|| Box::new(SimulatedInputs::all_met(machine)));
    let drives = drives.map_or_else(|| simulated_drives(machine, seed), Ok)?;
    Ok((put_together(machine, drives, source, inputs, faults), lines))
}

fn failure(error: &ModbusError) -> Failure {
    match error {
        ModbusError::NoRegister { device, value } => {
            let allowed = Message::new("project-register-or-no-value").key("value", value).text("device", device);
            Failure::refused(error.message(), allowed)
        }
        ModbusError::Unreachable { .. } => {
            Failure::Environment(with_hint(error.message(), Message::new("project-check-modbus")))
        }
    }
}

/// The traffic, as in `run.json`.
pub fn traffic_report(lines: &Lines) -> Vec<Value> {
    let one = |(name, line): &(String, TrafficView)| {
        let traffic = line.get();
        let round = &traffic.round;
        json!({
            "device": name,
            "polls": traffic.polls, "missed": traffic.missed, "failed": traffic.failed,
            "connections": traffic.connections, "away_s": traffic.away_s,
            "round_us": { "median": round.quantile_us(0.5), "p99_9": round.quantile_us(0.999), "most": round.most_us() },
            "latency_ms": traffic.latency.map(|latency| {
                json!({ "mean": 1e3 * latency.mean_s, "sigma": 1e3 * latency.sigma_s, "reports": latency.reports })
            }),
            "trouble": traffic.trouble.as_ref().map(|trouble| trouble.in_language(Language::English)),
        })
    };
    lines.iter().map(one).collect()
}
