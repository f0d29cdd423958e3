//! The devices of a run: those that the machine file names, and simulated ones for the rest.

use crate::failure::Failure;
use seamwright_cell::devices::modbus::{self, ModbusError, TrafficView};
use seamwright_cell::devices::{
    Device, DeviceSet, Fault, Faulty, InputBits, Inputs, SimulatedDrives, SimulatedInputs, SimulatedSource, Source,
};
use seamwright_cell::executive::{DriveReport, Interlocks, SourceReport};
use seamwright_machine::Machine;
use serde_json::{Value, json};
use std::io::Write as _;

/// Devices, each with its plan of faults.
pub(super) type Cell = DeviceSet<
    Faulty<SimulatedDrives, DriveReport>,
    Faulty<Box<dyn Source + Send>, SourceReport>,
    Faulty<Box<dyn Inputs + Send>, InputBits>,
>;

/// What goes over the lines to devices, by their names.
pub(super) type Lines = Vec<(String, TrafficView)>;

/// Simulated devices.
pub(super) fn simulated(machine: &Machine, faults: &[Fault], seed: u64) -> Result<Cell, Failure> {
    let inputs = SimulatedInputs::new(Interlocks::new(&machine.interlocks).all_met());
    let source = SimulatedSource::new(seed, machine.servo_period_s);
    put_together(machine, Box::new(source), Box::new(inputs), (faults, seed))
}

fn put_together(
    machine: &Machine,
    source: Box<dyn Source + Send>,
    inputs: Box<dyn Inputs + Send>,
    (faults, seed): (&[Fault], u64),
) -> Result<Cell, Failure> {
    let period = machine.servo_period_s;
    let drives = SimulatedDrives::new(machine, seed).map_err(|e| Failure::Input(e.to_string()))?;
    Ok(DeviceSet {
        drives: Faulty::new(drives, Device::Drives, faults, period),
        source: Faulty::new(source, Device::Source, faults, period),
        inputs: Faulty::new(inputs, Device::Inputs, faults, period),
        period_s: period,
    })
}

/// The devices that the machine file names, connected; `values` are the names of the job's process values. Says what is simulated.
pub(super) fn of_machine(
    machine: &Machine,
    values: &[String],
    faults: &[Fault],
    seed: u64,
) -> Result<(Cell, Lines), Failure> {
    let mut source: Option<Box<dyn Source + Send>> = None;
    let mut inputs: Option<Box<dyn Inputs + Send>> = None;
    let mut lines = Lines::new();
    for device in &machine.devices.modbus {
        let parts = modbus::connect(device, values, machine.servo_period_s).map_err(|e| failure(&e))?;
        if let Some(part) = parts.source {
            source = Some(Box::new(part));
        }
        if let Some(part) = parts.inputs {
            inputs = Some(Box::new(part));
        }
        lines.push((device.name.clone(), parts.traffic));
    }
    if !lines.is_empty() {
        let missing = [("process source", source.is_none()), ("inputs", inputs.is_none())];
        let missing = missing.iter().filter(|m| m.1).map(|m| m.0);
        let simulated: Vec<&str> = std::iter::once("drives").chain(missing).collect();
        // Nothing can be done if standard error is closed.
        let _ = writeln!(std::io::stderr(), "note: simulated: {}", simulated.join(", "));
    }
    let source = source.unwrap_or_else(|| Box::new(SimulatedSource::new(seed, machine.servo_period_s)));
    let inputs =
        inputs.unwrap_or_else(|| Box::new(SimulatedInputs::new(Interlocks::new(&machine.interlocks).all_met())));
    Ok((put_together(machine, source, inputs, (faults, seed))?, lines))
}

fn failure(error: &ModbusError) -> Failure {
    match error {
        ModbusError::NoRegister { device, value } => Failure::Input(format!(
            "{error}\n   allowed: a register `{value}` in [devices.{device}.modbus.set] of the machine file, or a job without it"
        )),
        ModbusError::Unreachable { .. } => Failure::Environment(format!(
            "{error}\n   look at cable, address, unit and registers; `seamwright io MACHINE` reads them one by one"
        )),
    }
}

/// The traffic, as in `run.json`.
pub(super) fn told(lines: &Lines) -> Vec<Value> {
    let one = |(name, line): &(String, TrafficView)| {
        let traffic = line.get();
        let round = &traffic.round;
        json!({
            "device": name,
            "polls": traffic.polls, "missed": traffic.missed, "failed": traffic.failed,
            "connections": traffic.connections, "away_s": traffic.away_s,
            "round_us": { "median": round.quantile_us(0.5), "p99_9": round.quantile_us(0.999), "most": round.most_us() },
            "trouble": traffic.trouble,
        })
    };
    lines.iter().map(one).collect()
}
