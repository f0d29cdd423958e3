//! `[devices.<name>]`: where drives, process source, inputs and outputs are. What no entry names is simulated.

mod check;
mod linuxcnc;
mod modbus;

pub use linuxcnc::{LinuxCnc, LinuxCncFile};
pub use modbus::{
    BitFile, ModbusDevice, ModbusFile, NumberFile, NumberType, OutputsFile, Place, Register, ReportsFile, Role, Scaled,
    Table, Word, WordOrder,
};

use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError};
use serde::Deserialize;

/// A device, by how it is reached. Exactly one of them.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[allow(clippy::large_enum_variant, reason = "read once")]
pub enum DeviceFile {
    /// Process source, inputs and outputs over Modbus TCP.
    Modbus(ModbusFile),
    /// The drives by LinuxCNC's HAL.
    #[serde(rename = "linuxcnc")]
    LinuxCnc(LinuxCncFile),
}

/// The devices of a machine, checked.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MachineDevices {
    /// Over Modbus TCP, by their names.
    pub modbus: Vec<ModbusDevice>,
    /// The drives, if they are LinuxCNC's.
    pub linuxcnc: Option<LinuxCnc>,
}

impl MachineDevices {
    /// True if the machine file names none: all are simulated.
    pub fn is_empty(&self) -> bool {
        self.modbus.is_empty() && self.linuxcnc.is_none()
    }
}

/// Puts the devices of a machine file together.
pub(crate) fn devices(file: &Document<crate::MachineFile>) -> Result<MachineDevices, DocumentError> {
    let mut devices = MachineDevices::default();
    for (name, device) in &file.value.devices {
        match device {
            DeviceFile::Modbus(modbus) => devices.modbus.push(check::modbus(file, name, modbus)?),
            DeviceFile::LinuxCnc(_) if devices.linuxcnc.is_some() => {
                let message = "another device has the drives already";
                return Err(file.error_at(&format!("devices.{name}.linuxcnc"), message, "one device with `linuxcnc`"));
            }
            DeviceFile::LinuxCnc(linuxcnc) => {
                devices.linuxcnc = Some(linuxcnc::linuxcnc(file, name, linuxcnc)?);
            }
        }
    }
    check::together(file, &devices.modbus)?;
    Ok(devices)
}
