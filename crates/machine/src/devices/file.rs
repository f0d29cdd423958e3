use super::modbus::ModbusFile;
use super::robot_file::{EgmFile, RsiFile, RtdeFile};
use schemars::JsonSchema;
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
    /// The drives by step and direction pulses.
    Steps(StepsFile),
    /// The drives by a Universal Robots control, over RTDE.
    Rtde(RtdeFile),
    /// The drives by an ABB control, over EGM.
    Egm(EgmFile),
    /// The drives by a KUKA control, over RSI.
    Rsi(RsiFile),
}

/// The drives by LinuxCNC's HAL, as a real-time engine.
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinuxCncFile {
    /// HAL file that connects the hardware, beside the machine file; axes without hardware that follow at once if missing.
    pub hal: Option<String>,
    /// Set-points that the drives have in store, 2 to 200; 10 if missing. So many periods late is a correction, and so many
    /// cycles may be missed.
    pub store: Option<u32>,
    /// Period of a second, faster thread called `cell-base` (software step pulses), us, 10 to 1000; none if missing.
    pub base_period_us: Option<u32>,
}

/// The drives by step and direction pulses to the steppers of `[drives.<axis>.stepper]`.
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepsFile {
    /// File or named pipe that the pulses go to as a value change dump, beside the machine file; none if missing.
    pub stream: Option<String>,
    /// Tick of the timer that makes the pulses, ns, 10 to 100000; 100 if missing. The period is a whole number of them.
    pub tick_ns: Option<u32>,
}
