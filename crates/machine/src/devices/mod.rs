//! `[devices.<name>]`: devices of drives, process source, inputs and outputs. All others are simulated.

mod file;
mod linuxcnc;
mod modbus;
mod register_check;
mod robot;
mod robot_file;
mod steps;

pub use file::{DeviceFile, LinuxCncFile, StepsFile};
pub use linuxcnc::LinuxCnc;
pub use modbus::{
    BitFile, ModbusDevice, ModbusFile, NumberFile, NumberType, OutputsFile, Place, Register, ReportsFile, Role, Scaled,
    Table, Word, WordOrder,
};

pub use robot::{Listening, RobotDevice, RobotProtocolKind};
pub use robot_file::{EgmFile, RsiFile, RtdeFile};
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
    /// The drives, if a robot control takes their set-points.
    pub robot: Option<RobotDevice>,
}

impl MachineDevices {
    /// True if the machine file names none: all are simulated.
    pub fn is_empty(&self) -> bool {
        self.modbus.is_empty() && !self.has_drives()
    }

    /// True if one of them drives the axes.
    fn has_drives(&self) -> bool {
        self.linuxcnc.is_some() || self.steps.is_some() || self.robot.is_some()
    }
}

pub(crate) fn devices(
    file: &Document<crate::file::MachineFile>,
    axes: &[Axis],
) -> Result<MachineDevices, DocumentError> {
    let mut devices = MachineDevices::default();
    for (name, device) in &file.value.devices {
        let has_drives = devices.has_drives();
        let taken = |kind: &str| {
            let message = Message::new("machine-drives-taken");
            file.error_at(&format!("devices.{name}.{kind}"), message, Message::new("machine-one-device-of-drives"))
        };
        match device {
            DeviceFile::Modbus(modbus) => devices.modbus.push(register_check::modbus(file, name, modbus)?),
            DeviceFile::LinuxCnc(_) if has_drives => return Err(taken("linuxcnc")),
            DeviceFile::Steps(_) if has_drives => return Err(taken("steps")),
            DeviceFile::LinuxCnc(linuxcnc) => devices.linuxcnc = Some(linuxcnc::linuxcnc(file, name, linuxcnc)?),
            DeviceFile::Rtde(_) if has_drives => return Err(taken("rtde")),
            DeviceFile::Egm(_) if has_drives => return Err(taken("egm")),
            DeviceFile::Rsi(_) if has_drives => return Err(taken("rsi")),
            DeviceFile::Rtde(rtde) => devices.robot = Some(robot::rtde(file, axes, name, rtde)?),
            DeviceFile::Egm(egm) => devices.robot = Some(robot::egm(file, axes, name, egm)?),
            DeviceFile::Rsi(rsi) => devices.robot = Some(robot::rsi(file, axes, name, rsi)?),
            DeviceFile::Steps(steps) => devices.steps = Some(steps::steps(file, axes, name, steps)?),
        }
    }
    register_check::together(file, &devices.modbus)?;
    Ok(devices)
}
