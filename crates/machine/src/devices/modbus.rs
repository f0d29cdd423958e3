use schemars::JsonSchema;
use seamwright_document::{Finite, Positive};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt;

/// A device on Modbus TCP, and what its registers mean. Addresses count from 0, as in the protocol: what a manual calls 40001 is
/// holding register 0.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ModbusFile {
    /// Host and port, like `192.168.1.20:502`; port 502 if missing.
    pub address: String,
    /// Unit (slave) address, 0 to 247 or 255; 1 if missing.
    pub unit: Option<u8>,
    /// Frequency of reading, Hz, 20 to 1000; 100 if missing.
    pub poll_hz: Option<Positive>,
    /// Longest time for an answer, s, 0.01 to 5, or to 1 if the device switches the process; 0.2 if missing. Then the connection is
    /// made anew.
    pub timeout_s: Option<Positive>,
    /// Connections that are made: 2, orders on one of their own, or 1 if the device takes no more; 2 if missing.
    pub connections: Option<u8>,
    /// Time without a cycle after which outputs go to their safe states, s, 0.01 to 2; 0.1 if missing.
    pub watchdog_s: Option<Positive>,
    /// Longest time in which the device's heart-beat stays the same, s, 0.05 to 10; 0.5 if missing.
    pub heartbeat_s: Option<Positive>,
    /// Inputs of the machine's conditions, by the input's name.
    #[serde(default)]
    pub inputs: BTreeMap<String, BitFile>,
    /// Outputs that switch the process, and the watchdog.
    #[serde(default)]
    pub outputs: OutputsFile,
    /// Process values that are set, by their names (like `current_a`).
    #[serde(default)]
    pub set: BTreeMap<String, NumberFile>,
    /// Reports of the process source, and the device's heart-beat.
    #[serde(default)]
    pub reports: ReportsFile,
    /// Process values that are measured, by their names.
    #[serde(default)]
    pub actual: BTreeMap<String, NumberFile>,
}

/// Outputs.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OutputsFile {
    /// The gas valve.
    pub gas: Option<BitFile>,
    /// Arc or beam.
    pub on: Option<BitFile>,
    /// Changes with every poll as long as cycles are on time; a whole register (without `bit`) counts.
    pub watchdog: Option<BitFile>,
}

/// Reports that are read from the process source.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReportsFile {
    /// It could be switched on; true if missing.
    pub ready: Option<BitFile>,
    /// Arc or beam is there.
    pub burning: Option<BitFile>,
    /// The wire sticks; false if missing.
    pub stuck: Option<BitFile>,
    /// Fault code of the source, a u16; 0 means no fault.
    pub fault: Option<NumberFile>,
    /// Changes by itself while the device works; a whole register (without `bit`) changes in whatever way.
    pub heartbeat: Option<BitFile>,
}

/// A bit: exactly one of `coil`, `discrete`, `holding` and `input`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BitFile {
    /// Address of a coil: read and written.
    pub coil: Option<u16>,
    /// Address of a discrete input: only read.
    pub discrete: Option<u16>,
    /// Address of a holding register: read and written.
    pub holding: Option<u16>,
    /// Address of an input register: only read.
    pub input: Option<u16>,
    /// Which bit of a register, 0 (lowest) to 15.
    pub bit: Option<u8>,
    /// State of an output that is safe; off if missing.
    pub safe: Option<bool>,
}

/// A number: exactly one of `holding` and `input`.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NumberFile {
    /// Address of a holding register: read and written.
    pub holding: Option<u16>,
    /// Address of an input register: only read.
    pub input: Option<u16>,
    /// Coding of the number; `u16` if missing.
    #[serde(rename = "type", default)]
    pub kind: NumberType,
    /// Which of the two registers of 32 bits comes first; the high one if missing.
    pub words: Option<WordOrder>,
    /// The value is the number times this, plus `offset`; 1 if missing.
    pub scale: Option<Finite>,
    /// The value at the number 0; 0 if missing.
    #[serde(default)]
    pub offset: Finite,
    /// Unit of the value, for people; if missing what its name ends in.
    pub unit: Option<String>,
    /// Value of an output that is safe; if missing that of the number 0.
    pub safe: Option<Finite>,
}

/// Coding of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NumberType {
    /// 16 bits, 0 to 65535.
    #[default]
    U16,
    /// 16 bits, -32768 to 32767.
    I16,
    /// 32 bits, 0 to 4294967295.
    U32,
    /// 32 bits, -2147483648 to 2147483647.
    I32,
    /// 32 bits, IEEE 754.
    F32,
}

impl NumberType {
    /// Number of registers.
    pub fn registers(self) -> u16 {
        match self {
            Self::U16 | Self::I16 => 1,
            Self::U32 | Self::I32 | Self::F32 => 2,
        }
    }

    /// Minimum and maximum number.
    pub fn range(self) -> (f64, f64) {
        match self {
            Self::U16 => (0.0, f64::from(u16::MAX)),
            Self::I16 => (f64::from(i16::MIN), f64::from(i16::MAX)),
            Self::U32 => (0.0, f64::from(u32::MAX)),
            Self::I32 => (f64::from(i32::MIN), f64::from(i32::MAX)),
            Self::F32 => (f64::from(f32::MIN), f64::from(f32::MAX)),
        }
    }
}

/// Which of the two registers of 32 bits comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WordOrder {
    /// That with the high bits, as most devices have it.
    #[default]
    HighFirst,
    /// That with the low bits.
    LowFirst,
}

/// A device on Modbus TCP, checked.
#[derive(Debug, Clone, PartialEq)]
pub struct ModbusDevice {
    /// Its name in the machine file.
    pub name: String,
    /// Host and port.
    pub address: String,
    /// Unit address.
    pub unit: u8,
    /// Time from poll to poll, s.
    pub poll_s: f64,
    /// Maximum time for an answer, s.
    pub timeout_s: f64,
    /// Number of connections: 2, or 1 for commands and reports together.
    pub connections: u8,
    /// Time without a cycle after which outputs go to their safe states, s.
    pub watchdog_s: f64,
    /// Maximum time without a change of the heart-beat, s.
    pub heartbeat_s: f64,
    /// Registers with a role; they share no bits.
    pub registers: Vec<Register>,
}

/// A register with a role.
#[derive(Debug, Clone, PartialEq)]
pub struct Register {
    /// Its key in the device's table, like `inputs.door_closed`.
    pub name: String,
    /// Its role.
    pub role: Role,
    /// Its address and coding.
    pub place: Place,
    /// The safe value of an output: 0 or 1 for a bit.
    pub safe: f64,
    /// Unit of its value; empty for bits.
    pub unit: String,
}

/// Role of a register.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Role {
    /// Input of the condition with this number.
    Input(usize),
    /// The gas valve.
    Gas,
    /// Arc or beam.
    On,
    /// Changes while the cycle runs.
    Watchdog,
    /// A process value that is set.
    Set(String),
    /// The source could be switched on.
    Ready,
    /// Arc or beam burns.
    Burning,
    /// The wire sticks.
    Stuck,
    /// The source's fault code.
    Fault,
    /// Changes while the device works.
    Heartbeat,
    /// A process value that is measured.
    Actual(String),
}

impl Role {
    /// True if it is written.
    pub fn is_output(&self) -> bool {
        matches!(self, Self::Gas | Self::On | Self::Watchdog | Self::Set(_))
    }

    /// True for roles of the process source.
    pub fn is_source(&self) -> bool {
        !matches!(self, Self::Input(_) | Self::Watchdog | Self::Heartbeat)
    }
}

/// The four tables of a Modbus device.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Table {
    /// Bits, read and written.
    Coil,
    /// Bits, only read.
    Discrete,
    /// Registers, read and written.
    Holding,
    /// Registers, only read.
    Input,
}

impl Table {
    /// As in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Coil => "coil",
            Self::Discrete => "discrete",
            Self::Holding => "holding",
            Self::Input => "input",
        }
    }

    /// True if its cells are bits.
    pub fn has_bits(self) -> bool {
        matches!(self, Self::Coil | Self::Discrete)
    }
}

/// Address of a register, and coding of its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The table.
    pub table: Table,
    /// Address of its first cell, from 0.
    pub at: u16,
    /// Its content.
    pub word: Word,
}

/// Content of an address.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Word {
    /// A coil or a discrete input.
    Single,
    /// A bit of a register.
    Bit(u8),
    /// A number in one register or two.
    Number(Scaled),
}

/// A number with its scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaled {
    /// Its coding.
    pub kind: NumberType,
    /// Order of the two registers of 32 bits.
    pub order: WordOrder,
    /// Factor of the number: value = number * scale + offset.
    pub scale: f64,
    /// The value at the number 0.
    pub offset: f64,
}

impl Scaled {
    /// Minimum and maximum value.
    pub fn range(&self) -> (f64, f64) {
        let (low, high) = self.kind.range();
        let (a, b) = (low * self.scale + self.offset, high * self.scale + self.offset);
        (a.min(b), a.max(b))
    }
}

impl Place {
    /// Number of cells.
    pub fn cells(&self) -> u16 {
        match self.word {
            Word::Number(number) => number.kind.registers(),
            Word::Single | Word::Bit(_) => 1,
        }
    }
}

/// As in `holding 12`, `holding 12 bit 3` or `holding 12 f32`.
impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.table.name(), self.at)?;
        match self.word {
            Word::Single => Ok(()),
            Word::Bit(bit) => write!(f, " bit {bit}"),
            Word::Number(number) => write!(f, " {}", format!("{:?}", number.kind).to_lowercase()),
        }
    }
}
