use crate::devices::fault::{Device, FaultKind};

/// State of a cell at the start of a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Situation {
    /// Without power.
    Off,
    /// With power, references unknown.
    Idle,
    /// Homing.
    Homing,
    /// At rest.
    Ready,
    /// Jogging.
    Jog,
    /// In a pass without process.
    DryRun,
    /// On the approach to a weld.
    Approach,
    /// Gas flows.
    Preflow,
    /// Arc or beam is igniting or on, the torch rests.
    Strike,
    /// Welding.
    Travel,
    /// The crater is filled.
    Crater,
    /// Held on the path.
    Hold,
    /// After another fault.
    Fault,
}

impl Situation {
    /// All situations.
    pub const ALL: [Self; 13] = [
        Self::Off,
        Self::Idle,
        Self::Homing,
        Self::Ready,
        Self::Jog,
        Self::DryRun,
        Self::Approach,
        Self::Preflow,
        Self::Strike,
        Self::Travel,
        Self::Crater,
        Self::Hold,
        Self::Fault,
    ];

    /// Name in a word or two.
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Idle => "idle",
            Self::Homing => "homing",
            Self::Ready => "ready",
            Self::Jog => "jog",
            Self::DryRun => "dry run",
            Self::Approach => "approach",
            Self::Preflow => "gas",
            Self::Strike => "strike",
            Self::Travel => "travel",
            Self::Crater => "crater",
            Self::Hold => "hold",
            Self::Fault => "fault",
        }
    }

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
