//! `[devices.<name>]`: devices of drives, process source, inputs and outputs. All others are simulated.

mod file;
mod linuxcnc;
mod modbus;
mod register_check;
mod steps;

pub use file::{DeviceFile, LinuxCncFile, StepsFile};
pub use linuxcnc::LinuxCnc;
pub use modbus::{
    BitFile, ModbusDevice, ModbusFile, NumberFile, NumberType, OutputsFile, Place, Register, ReportsFile, Role, Scaled,
    Table, Word, WordOrder,
};

pub use steps::Steps;

use crate::axis::Axis;
use seamwright_document::{Document, DocumentError};
use seamwright_message::Message;

/// The devices of a machine, checked.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MachineDevices {
    /// Over Modbus TCP, by their names.
    pub modbus: Vec<ModbusDevice>,
    /// The drives, if they are LinuxCNC's.
    pub linuxcnc: Option<LinuxCnc>,
    /// The drives, if they are steppers that get pulses from here.
    pub steps: Option<Steps>,
}

impl MachineDevices {
    /// True if the machine file names none: all are simulated.
    pub fn is_empty(&self) -> bool {
        self.modbus.is_empty() && self.linuxcnc.is_none() && self.steps.is_none()
    }
}

pub(crate) fn devices(
    file: &Document<crate::file::MachineFile>,
    axes: &[Axis],
) -> Result<MachineDevices, DocumentError> {
    let mut devices = MachineDevices::default();
    for (name, device) in &file.value.devices {
        let has_drives = devices.linuxcnc.is_some() || devices.steps.is_some();
        let taken = |kind: &str| {
            let message = Message::new("machine-drives-taken");
            file.error_at(&format!("devices.{name}.{kind}"), message, Message::new("machine-one-device-of-drives"))
        };
        match device {
            DeviceFile::Modbus(modbus) => devices.modbus.push(register_check::modbus(file, name, modbus)?),
            DeviceFile::LinuxCnc(_) if has_drives => return Err(taken("linuxcnc")),
            DeviceFile::Steps(_) if has_drives => return Err(taken("steps")),
            DeviceFile::LinuxCnc(linuxcnc) => devices.linuxcnc = Some(linuxcnc::linuxcnc(file, name, linuxcnc)?),
            DeviceFile::Steps(steps) => devices.steps = Some(steps::steps(file, axes, name, steps)?),
        }
    }
    register_check::together(file, &devices.modbus)?;
    Ok(devices)
}
