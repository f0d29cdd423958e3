//! Devices of a cell: axes, process source and inputs, each behind a trait. [`DeviceSet`] joins one of each for
//! the executive.

#[cfg(target_os = "linux")]
mod linuxcnc;
pub mod modbus;
mod power_state;
pub mod robot;
mod steps;
mod traffic;

#[cfg(target_os = "linux")]
pub use linuxcnc::{LinuxCncDrives, LinuxCncError, Sample, Symptom, Taken};
pub use power_state::{PowerState, UNREFERENCED_ERROR};
pub use steps::StepDrives;
pub use traffic::{Traffic, TrafficView};

use crate::executive::{
    CutOff, Devices, DriveReport, Orders, ProcessOrders, Reports, SeamOrders, SensorReport, Slack, SourceReport,
    Watchdog,
};
use seamwright_machine::Joints;
use seamwright_tracking::beam::Picture;

/// The drives of all axes.
pub trait Drives {
    /// Exchanges orders and reports for one period. If no report came, only the age in `report` changes.
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport);
    /// Returns the number of missed cycles that the drives tolerate without harm.
    fn rides_out(&self) -> Slack;
    /// Maximum age of a fresh report, s.
    fn late_s(&self) -> f64;
    /// True axis positions, of simulated drives only.
    fn truth(&self) -> Option<&Joints> {
        None
    }
}

/// Joint sensors: sensors ahead of the torches, or a beam.
pub trait Sensors {
    /// Exchanges orders and reports for one period, at whose end simulated axes are at `truth`. Exposure times are on
    /// the clock of the orders.
    fn exchange(&mut self, orders: &SeamOrders, truth: Option<&Joints>, report: &mut SensorReport);
    /// Returns the picture that came in the last period.
    fn picture(&self) -> Option<Picture<'_>>;
}

/// `None` reports nothing.
impl<S: Sensors> Sensors for Option<S> {
    fn exchange(&mut self, orders: &SeamOrders, truth: Option<&Joints>, report: &mut SensorReport) {
        if let Some(sensors) = self {
            sensors.exchange(orders, truth, report);
        }
    }

    fn picture(&self) -> Option<Picture<'_>> {
        self.as_ref()?.picture()
    }
}

impl<D: Drives + ?Sized> Drives for Box<D> {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        (**self).exchange(orders, report);
    }

    fn rides_out(&self) -> Slack {
        (**self).rides_out()
    }

    fn late_s(&self) -> f64 {
        (**self).late_s()
    }

    fn truth(&self) -> Option<&Joints> {
        (**self).truth()
    }
}

/// Maximum age of a fresh report where one comes with every cycle, periods.
pub const LATE_PERIODS: f64 = 3.5;

/// Arc or beam, with gas and auxiliaries.
pub trait Source {
    /// Exchanges orders, the sign of life and reports for one period. If no report came, only the age in `report`
    /// changes.
    fn exchange(&mut self, orders: &ProcessOrders, watchdog: Watchdog, report: &mut SourceReport);
    /// Returns the way to take the process off without the cycle.
    fn cut_off(&self) -> Option<Box<dyn CutOff>> {
        None
    }
}

/// A source that was selected when the machine file was read.
impl<S: Source + ?Sized> Source for Box<S> {
    fn exchange(&mut self, orders: &ProcessOrders, watchdog: Watchdog, report: &mut SourceReport) {
        (**self).exchange(orders, watchdog, report);
    }

    fn cut_off(&self) -> Option<Box<dyn CutOff>> {
        (**self).cut_off()
    }
}

/// Inputs of doors, valves and switches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InputBits {
    /// One bit each, in the order of the machine's conditions.
    pub bits: u64,
    /// Number of starts of the input device.
    pub starts: u32,
    /// Age of this state, s.
    pub age_s: f64,
}

impl Default for InputBits {
    /// No inputs known, infinite age.
    fn default() -> Self {
        Self { bits: 0, starts: 0, age_s: f64::INFINITY }
    }
}

/// Reads the inputs and passes the sign of life on.
pub trait Inputs {
    /// Exchanges the sign of life and the inputs for one period. If no report came, only the age in `inputs` changes.
    fn exchange(&mut self, watchdog: Watchdog, inputs: &mut InputBits);
    /// Returns the way to stop a watchdog output of the device without the cycle.
    fn cut_off(&self) -> Option<Box<dyn CutOff>> {
        None
    }
}

impl<I: Inputs + ?Sized> Inputs for Box<I> {
    fn exchange(&mut self, watchdog: Watchdog, inputs: &mut InputBits) {
        (**self).exchange(watchdog, inputs);
    }

    fn cut_off(&self) -> Option<Box<dyn CutOff>> {
        (**self).cut_off()
    }
}

/// One device of each kind, for the executive.
#[derive(Debug, Clone)]
pub struct DeviceSet<D, S, I> {
    /// The drives; with real ones, they wait for the period.
    pub drives: D,
    /// The process source.
    pub source: S,
    /// The inputs.
    pub inputs: I,
}

impl<D: Drives, S: Source, I: Inputs> Devices for DeviceSet<D, S, I> {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        (reports.missed, reports.late) = (0, false);
        self.drives.exchange(orders, &mut reports.drives);
        reports.truth = self.drives.truth().copied();
        self.source.exchange(&orders.process, orders.watchdog, &mut reports.source);
        let mut inputs = InputBits { bits: reports.inputs, starts: reports.inputs_starts, age_s: reports.inputs_age_s };
        self.inputs.exchange(orders.watchdog, &mut inputs);
        (reports.inputs, reports.inputs_starts, reports.inputs_age_s) = (inputs.bits, inputs.starts, inputs.age_s);
    }

    fn rides_out(&self) -> Slack {
        self.drives.rides_out()
    }

    fn drives_late_s(&self) -> f64 {
        self.drives.late_s()
    }

    fn cut_offs(&self) -> Vec<Box<dyn CutOff>> {
        self.source.cut_off().into_iter().chain(self.inputs.cut_off()).collect()
    }
}

/// Devices with joint sensors.
#[derive(Debug, Clone)]
pub struct WithSensors<D, S> {
    /// Drives, process source, inputs.
    pub devices: D,
    /// Joint sensors.
    pub sensors: S,
}

impl<D: Devices, S: Sensors> Devices for WithSensors<D, S> {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        self.devices.exchange(orders, reports);
        self.sensors.exchange(&orders.seam, reports.truth.as_ref(), &mut reports.sensors);
    }

    fn rides_out(&self) -> Slack {
        self.devices.rides_out()
    }

    fn drives_late_s(&self) -> f64 {
        self.devices.drives_late_s()
    }

    fn picture(&self) -> Option<Picture<'_>> {
        self.sensors.picture()
    }

    fn cut_offs(&self) -> Vec<Box<dyn CutOff>> {
        self.devices.cut_offs()
    }
}
