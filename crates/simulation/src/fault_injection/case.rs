use crate::devices::fault::{Device, FaultKind};
use seamwright_message::named_enum;

named_enum! {
    /// State of a cell at the start of a fault.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Situation {
        /// Without power.
        Off => "off",
        /// With power, references unknown.
        Idle => "idle",
        /// Homing.
        Homing => "homing",
        /// At rest.
        Ready => "ready",
        /// Jogging.
        Jog => "jog",
        /// In a pass without process.
        DryRun => "dry run",
        /// On the approach to a weld.
        Approach => "approach",
        /// Gas flows.
        Preflow => "gas",
        /// Arc or beam is igniting or on, the torch rests.
        Strike => "strike",
        /// Welding.
        Travel => "travel",
        /// The crater is filled.
        Crater => "crater",
        /// Held on the path.
        Hold => "hold",
        /// After another fault.
        Fault => "fault",
    }
}

impl Situation {
    /// Returns true in a program with process.
    pub fn welds(self) -> bool {
        matches!(self, Self::Approach | Self::Preflow | Self::Strike | Self::Travel | Self::Crater)
    }
}

/// A fault in a situation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Case {
    /// Affected device.
    pub device: Device,
    /// Kind of fault; it is permanent.
    pub kind: FaultKind,
    /// Index of the wrong axis or input.
    pub which: u8,
    /// Situation at the start of the fault.
    pub situation: Situation,
}
