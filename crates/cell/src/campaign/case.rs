use super::expected::{Expected, expected};
use super::witness::{Orders as Wishes, Witness};
use super::{Stage, TrackedStage};
use crate::Error;
use crate::devices::{
    Device, DeviceSet, Fault, FaultKind, Faulty, InputBits, SimulatedDrives, SimulatedInputs, SimulatedSource, When,
    WithSensors,
};
use crate::executive::{
    Alarm, Devices, DriveReport, Executive, Interlocks, Mode, Orders, Place, Reports, SensorReport, Slack, SourceReport,
};
use crate::tracking::SimulatedSensors;
use seamwright_tracking::beam::Picture;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

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
    /// Of a stop, the part of what the axes' limits allow for it that was needed; more than 1 is too much.
    pub stop_part: f64,
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
    devices: Late<TrialDevices<'a>>,
    witness: Witness,
}

type TrialDevices<'a> = WithSensors<
    DeviceSet<
        Faulty<SimulatedDrives, DriveReport>,
        Faulty<SimulatedSource, SourceReport>,
        Faulty<Faulty<SimulatedInputs, InputBits>, InputBits>,
    >,
    Faulty<SimulatedSensors<'a>, SensorReport>,
>;

/// Devices whose cycle comes late once, when it is told to.
struct Late<D> {
    devices: D,
    told: Option<Arc<AtomicBool>>,
}

/// Cycles that are missed then, and those that may be.
const MISSED: u32 = 20;
const RIDES_OUT: u32 = 3;

impl<D: Devices> Devices for Late<D> {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        self.devices.exchange(orders, reports);
        if self.told.as_ref().is_some_and(|told| told.load(Ordering::Relaxed)) {
            (self.told, reports.missed) = (None, MISSED);
        }
    }

    fn rides_out(&self) -> Slack {
        Slack::stored(RIDES_OUT)
    }

    fn drives_late_s(&self) -> f64 {
        self.devices.drives_late_s()
    }

    fn picture(&self) -> Option<Picture<'_>> {
        self.devices.picture()
    }
}

/// When the fault before the fault comes, s.
const BEFORE_S: f64 = 1.0;

impl<'a> Trial<'a> {
    /// The case on simulated devices; `seed` says when exactly the fault comes.
    ///
    /// # Errors
    /// A machine whose values make no drives.
    pub fn new(stage: Stage<'a>, case: Case, seed: u64, anywhere: bool) -> Result<Self, Error> {
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
        };
        let sensors = match stage.tracked.filter(|_| device == Device::Sensors) {
            Some(tracked) => tracked.cell.sensors()?,
            None => SimulatedSensors::none(machine),
        };
        let sensors = Faulty::new(sensors, Device::Sensors, &fault, period).told_by(&told);
        let late = (device == Device::Cycle).then(|| Arc::clone(&told));
        let devices = Late { devices: WithSensors { devices, sensors }, told: late };
        let witness = Witness::new(machine, Wishes { case, told, seed, anywhere });
        Ok(Self { stage, case, devices, witness })
    }

    /// Runs it.
    ///
    /// # Errors
    /// A weld that cannot be tracked.
    pub fn run(mut self) -> Result<Outcome, Error> {
        let at_end = self.case.situation == Situation::Crater;
        let tracked = self.stage.tracked.filter(|_| self.case.device == Device::Sensors);
        let (work, mut tracking) = match tracked {
            Some(TrackedStage { cell, works, near_end }) => {
                let start = if at_end { near_end } else { Place::default() };
                (works[usize::from(at_end)], cell.tracking(start)?)
            }
            None => (if at_end { self.stage.end } else { self.stage.begin }, None),
        };
        let guide = tracking.as_mut().map(|tracking| tracking as _);
        let executive = Executive::new(self.stage.machine, &mut self.devices, &mut self.witness);
        let mut executive = executive.with_guide(guide);
        executive.serve(Some(work));
        let left = executive.left();
        drop(executive);
        Ok(self.witness.outcome(left))
    }
}
