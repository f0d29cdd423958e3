use super::Stage;
use super::expected::{Expected, expected};
use super::witness::{Orders as Wishes, Witness};
use crate::Error;
use crate::devices::{
    Device, DeviceSet, Fault, FaultKind, Faulty, SimulatedDrives, SimulatedInputs, SimulatedSource, When,
};
use crate::executive::{Alarm, Executive, Interlocks, Mode, Place};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// What a cell is doing when a fault comes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Situation {
    /// Without power.
    Off,
    /// With power, references unknown.
    Idle,
    /// Looking for references.
    Homing,
    /// At rest.
    Ready,
    /// Jogged.
    Jog,
    /// In a pass without process.
    DryRun,
    /// On the way to a weld.
    Approach,
    /// Gas flows.
    Preflow,
    /// Arc or beam is on or comes on, the torch rests.
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
    /// All of them.
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

    /// In a word or two.
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

    /// True in a program with process.
    pub fn welds(self) -> bool {
        matches!(self, Self::Approach | Self::Preflow | Self::Strike | Self::Travel | Self::Crater)
    }
}

/// A fault in a situation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Case {
    /// What it happens to.
    pub device: Device,
    /// What happens; it lasts.
    pub kind: FaultKind,
    /// Which axis or input is wrong.
    pub which: u8,
    /// When.
    pub situation: Situation,
}

/// What came of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// The mode in which the cell was some seconds later.
    pub mode: Mode,
    /// The alarm that came first after the fault.
    pub first_alarm: Option<Alarm>,
    /// Cycles from an alarm that takes the process away until it is ordered off; 0 if there was none with the process on.
    pub off_cycles: u32,
    /// Path length from the alarm to rest, mm.
    pub stop_mm: f64,
    /// Where a weld was left.
    pub left: Option<Place>,
    /// The situation was reached.
    pub reached: bool,
    /// What must not be and was.
    pub violations: Vec<String>,
}

impl Outcome {
    /// True if everything is as it must be.
    pub fn is_kept(&self) -> bool {
        let Expected { mode, alarm } = expected(self.case);
        self.reached && self.mode == mode && self.first_alarm == alarm && self.violations.is_empty()
    }
}

/// A case at work.
pub struct Trial<'a> {
    stage: Stage<'a>,
    case: Case,
    devices: Devices,
    witness: Witness,
}

type Devices = DeviceSet<
    Faulty<SimulatedDrives, crate::executive::DriveReport>,
    Faulty<SimulatedSource, crate::executive::SourceReport>,
    Faulty<Faulty<SimulatedInputs, crate::devices::InputBits>, crate::devices::InputBits>,
>;

/// When the fault before the fault comes, s.
const BEFORE_S: f64 = 1.0;

impl<'a> Trial<'a> {
    /// The case on simulated devices; `seed` says when exactly the fault comes.
    ///
    /// # Errors
    /// A machine whose values make no drives.
    pub fn new(stage: Stage<'a>, case: Case, seed: u64) -> Result<Self, Error> {
        let machine = stage.machine;
        let period = machine.servo_period_s;
        let told = Arc::new(AtomicBool::new(false));
        let Case { device, kind, which, situation } = case;
        let fault = [Fault { device, kind, when: When::Told, lasts_s: f64::INFINITY, which }];
        // What takes the cell into fault first is over when the case begins.
        let first =
            Fault { device: Device::Inputs, kind: FaultKind::Wrong, when: When::At(BEFORE_S), lasts_s: 0.05, which: 0 };
        let before: &[Fault] = if situation == Situation::Fault { &[first] } else { &[] };
        let inputs = SimulatedInputs::new(Interlocks::new(&machine.interlocks).all_met());
        let inputs = Faulty::new(inputs, Device::Inputs, before, period);
        let devices = DeviceSet {
            drives: Faulty::new(SimulatedDrives::new(machine, seed)?, Device::Drives, &fault, period).told_by(&told),
            source: Faulty::new(SimulatedSource::new(seed, period), Device::Source, &fault, period).told_by(&told),
            inputs: Faulty::new(inputs, Device::Inputs, &fault, period).told_by(&told),
            period_s: period,
        };
        let witness = Witness::new(machine, Wishes { situation, told, seed });
        Ok(Self { stage, case, devices, witness })
    }

    /// Runs it.
    ///
    /// # Errors
    /// None so far.
    pub fn run(mut self) -> Result<Outcome, Error> {
        let work = if self.case.situation == Situation::Crater { self.stage.end } else { self.stage.begin };
        let mut executive = Executive::new(self.stage.machine, &mut self.devices, &mut self.witness);
        executive.serve(Some(work));
        let left = executive.left();
        Ok(self.witness.outcome(self.case, left))
    }
}
