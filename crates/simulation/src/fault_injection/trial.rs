use super::case::{Case, Situation};
use super::outcome::Outcome;
use super::trial_operator::{Orders as Wishes, TrialOperator};
use crate::devices::fault::{Device, Fault, FaultKind, Faulty, When};
use crate::devices::simulated::{SimulatedDrives, SimulatedInputs, SimulatedSource};
use crate::error::Error;
use crate::simulate::SimulatedCell;
use crate::tracking::simulated_sensors::SimulatedSensors;
use seamwright_executive::devices::{DeviceSet, InputBits, WithSensors};
use seamwright_executive::{
    Devices, DriveReport, Executive, Orders, Place, Reports, SensorReport, Slack, SourceReport, Work,
};
use seamwright_machine::Machine;
use seamwright_tracking::beam::Picture;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Environment of a fault injection.
#[derive(Clone, Copy)]
pub struct Stage<'a> {
    /// The machine.
    pub machine: &'a Machine,
    /// A weld from its start.
    pub begin: &'a Work<'a>,
    /// The same weld from shortly before its end.
    pub end: &'a Work<'a>,
    /// The same weld with tracking, for sensor faults: without it these are skipped.
    pub tracked: Option<TrackedStage<'a>>,
}

/// A weld with tracking.
#[derive(Clone, Copy)]
pub struct TrackedStage<'a> {
    /// Its cell.
    pub cell: &'a SimulatedCell<'a>,
    /// From its start, and from shortly before its end.
    pub works: [&'a Work<'a>; 2],
    /// Position shortly before its end.
    pub near_end: Place,
}

/// A case during execution.
pub struct Trial<'a> {
    stage: Stage<'a>,
    case: Case,
    devices: Late<TrialDevices<'a>>,
    operator: TrialOperator,
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
        let inputs = Faulty::new(SimulatedInputs::all_met(machine), Device::Inputs, before, period);
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
        let operator = TrialOperator::new(machine, Wishes { case, told, seed, anywhere });
        Ok(Self { stage, case, devices, operator })
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
        let executive = Executive::new(self.stage.machine, &mut self.devices, &mut self.operator);
        let mut executive = executive.with_guide(guide);
        executive.serve(Some(work));
        let left = executive.left();
        drop(executive);
        Ok(self.operator.outcome(left))
    }
}
