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
use seamwright_message::Message;
use seamwright_tracking::beam::Picture;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

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

/// Result of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// Mode of the cell some seconds later.
    pub mode: Mode,
    /// First alarm after the fault.
    pub first_alarm: Option<Alarm>,
    /// Cycles from an alarm with process off to the off order; 0 without such an alarm while the process is on.
    pub off_cycles: u32,
    /// Path length from the alarm to rest, mm.
    pub stop_mm: f64,
    /// Stop distance relative to its bound from the axes' limits; more than 1 is a violation.
    pub stop_part: f64,
    /// Position at which a weld was left.
    pub left: Option<Place>,
    /// The situation was reached.
    pub reached: bool,
    /// Violated requirements.
    pub violations: Vec<Message>,
}

impl Outcome {
    /// Returns true if the result is as required.
    pub fn is_kept(&self) -> bool {
        let Expected { mode, alarm } = expected(self.case);
        self.reached && self.mode == mode && self.first_alarm == alarm && self.violations.is_empty()
    }
}

/// A case during execution.
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

/// Devices with one late cycle, triggered by a flag.
struct Late<D> {
    devices: D,
    told: Option<Arc<AtomicBool>>,
}

/// Number of cycles missed then, and the tolerated number.
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

/// Time of the earlier fault of [`Situation::Fault`], s.
const BEFORE_S: f64 = 1.0;

impl<'a> Trial<'a> {
    /// Prepares the case on simulated devices; `seed` sets the exact time of the fault.
    ///
    /// # Errors
    /// Invalid drive values of the machine.
    pub fn new(stage: Stage<'a>, case: Case, seed: u64, anywhere: bool) -> Result<Self, Error> {
        let machine = stage.machine;
        let period = machine.servo_period_s;
        let told = Arc::new(AtomicBool::new(false));
        let Case { device, kind, which, situation } = case;
        let fault = [Fault { device, kind, when: When::Flagged, lasts_s: f64::INFINITY, which }];
        // The earlier fault, which trips the cell, is over when the case starts.
        let first =
            Fault { device: Device::Inputs, kind: FaultKind::Wrong, when: When::At(BEFORE_S), lasts_s: 0.05, which: 0 };
        let before: &[Fault] = if situation == Situation::Fault { &[first] } else { &[] };
        let inputs = SimulatedInputs::new(Interlocks::new(&machine.interlocks).all_met());
        let inputs = Faulty::new(inputs, Device::Inputs, before, period);
        let devices = DeviceSet {
            drives: Faulty::new(SimulatedDrives::new(machine, seed)?, Device::Drives, &fault, period).flagged_by(&told),
            source: Faulty::new(SimulatedSource::new(seed, period), Device::Source, &fault, period).flagged_by(&told),
            inputs: Faulty::new(inputs, Device::Inputs, &fault, period).flagged_by(&told),
        };
        let sensors = match stage.tracked.filter(|_| device == Device::Sensors) {
            Some(tracked) => tracked.cell.sensors()?,
            None => SimulatedSensors::none(machine),
        };
        let sensors = Faulty::new(sensors, Device::Sensors, &fault, period).flagged_by(&told);
        let late = (device == Device::Cycle).then(|| Arc::clone(&told));
        let devices = Late { devices: WithSensors { devices, sensors }, told: late };
        let witness = Witness::new(machine, Wishes { case, told, seed, anywhere });
        Ok(Self { stage, case, devices, witness })
    }

    /// Runs the case.
    ///
    /// # Errors
    /// The weld does not allow tracking.
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
