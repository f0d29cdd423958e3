use super::cut_off::CutOff;
use seamwright_machine::{Joints, MAX_AXES};
use seamwright_servo::SetPoint;
use seamwright_tracking::beam::{Beam, Picture};
use seamwright_tracking::lead::Measurement;
use serde::{Deserialize, Serialize};
use std::ops::DerefMut;

/// Maximum number of process values of a weld.
pub const VALUES: usize = 16;
/// Maximum age of fresh inputs and of a fresh source report, s.
pub(super) const LATE_S: f64 = 0.1;

/// Orders to the devices in a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Orders {
    /// Drives on.
    pub power: bool,
    /// Homing: each drive finds its reference in its own way and ignores set-points.
    pub home: bool,
    /// Set-point of each axis, mm or rad; followed only with power.
    pub set: [SetPoint; MAX_AXES],
    /// Process orders.
    pub process: ProcessOrders,
    /// Orders to the joint sensors and the beam deflection.
    pub seam: SeamOrders,
    /// Sign of life.
    pub watchdog: Watchdog,
}

/// Sign of life of the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Watchdog {
    /// Changes in every cycle: if it stops, outputs go to their safe states.
    pub toggle: bool,
    /// A cycle was late, and the cell has not been reset since: watchdog outputs stand still.
    pub late: bool,
}

impl Watchdog {
    /// Returns the sign of life of the next cycle.
    #[must_use]
    pub fn next(self, late: bool) -> Self {
        Self { toggle: !self.toggle, late }
    }
}

impl Orders {
    /// Returns true if all set-points are at rest.
    pub fn rests(&self) -> bool {
        /// Speed below which an axis is at rest, mm/s or rad/s. Corrected set-points come from an iteration, so that
        /// their differences are not exactly 0.
        const AT_REST: f64 = 1e-6;
        self.set.iter().all(|set| set.velocity.abs() < AT_REST)
    }
}

/// Orders to the process source.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ProcessOrders {
    /// The gas valve is open.
    pub gas: bool,
    /// Arc or beam on.
    pub on: bool,
    /// Process values, in the order of [`super::Work::values`]; NaN for values that are not requested.
    pub values: [f64; VALUES],
}

/// Orders to the joint sensors and to the deflected beam.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SeamOrders {
    /// The cell's clock at the start of the period, s: exposures are stamped with it.
    pub t_s: f64,
    /// The pass whose joint is observed, counted from 1; 0 for no pass.
    pub pass: usize,
    /// Path length of the torch's set-point in it, mm; negative before its start.
    pub s_mm: f64,
    /// The torch is on its path and may weave.
    pub weaves: bool,
    /// Beam mode.
    pub beam: Beam,
    /// Lateral beam deflection, mm.
    pub deflection_mm: f64,
}

impl Default for SeamOrders {
    fn default() -> Self {
        Self { t_s: 0.0, pass: 0, s_mm: 0.0, weaves: false, beam: Beam::Weld, deflection_mm: 0.0 }
    }
}

/// Device reports; by default of infinite age.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Reports {
    /// The drives.
    pub drives: DriveReport,
    /// The process source.
    pub source: SourceReport,
    /// Inputs, one bit each, in the order of the machine's conditions.
    pub inputs: u64,
    /// Age of the inputs, s.
    pub inputs_age_s: f64,
    /// Number of starts of the input device.
    pub inputs_starts: u32,
    /// Joint sensors.
    pub sensors: SensorReport,
    /// Number of cycles missed before this one.
    pub missed: u32,
    /// The gap before this cycle was too long: the process was taken off.
    pub late: bool,
    /// Lateness of the start of this cycle, ns; 0 in simulated time.
    pub late_ns: u64,
    /// True axis positions, of simulated drives: for the evaluation of a weld, never for its control.
    pub truth: Option<Joints>,
}

/// Report of the sensors ahead of the torches.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct SensorReport {
    /// Measurement of each head that arrived in this period.
    pub measured: [Option<Measurement>; 2],
    /// Time since the last expected report, s.
    pub age_s: f64,
    /// Number of starts.
    pub starts: u32,
}

impl Default for Reports {
    fn default() -> Self {
        Self {
            drives: DriveReport { age_s: f64::INFINITY, ..DriveReport::default() },
            source: SourceReport { age_s: f64::INFINITY, ..SourceReport::default() },
            inputs: 0,
            inputs_age_s: f64::INFINITY,
            inputs_starts: 0,
            sensors: SensorReport::default(),
            missed: 0,
            late: false,
            late_ns: 0,
            truth: None,
        }
    }
}

impl Reports {
    /// Adds time without a cycle to the age of every report, s.
    pub(crate) fn age_by(&mut self, gap_s: f64) {
        self.drives.age_s += gap_s;
        self.source.age_s += gap_s;
        self.inputs_age_s += gap_s;
        self.sensors.age_s += gap_s;
    }
}

/// Report of the drives.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct DriveReport {
    /// The drives have power.
    pub powered: bool,
    /// Measured positions, mm or rad.
    pub position: Joints,
    /// Following error of each axis, mm or rad.
    pub following_error: Joints,
    /// Current of each drive, relative to its peak.
    pub current: Joints,
    /// Axes with a fault, one bit each.
    pub fault: u16,
    /// Axes on a limit switch, one bit each.
    pub limit_switch: u16,
    /// Axes with a known reference, one bit each.
    pub referenced: u16,
    /// Age of this report, s.
    pub age_s: f64,
    /// Number of starts.
    pub starts: u32,
    /// Number of underruns of set-points since the start: at each one all axes stop at once, beyond their limits.
    pub starved: u32,
    /// Age of the set-point that the positions show, s, from the order of this exchange on; 0 of drives that follow
    /// within a period.
    pub lag_s: f64,
}

/// Report of the process source.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct SourceReport {
    /// Ready to switch on.
    pub ready: bool,
    /// Arc or beam is burning.
    pub burning: bool,
    /// The wire sticks.
    pub stuck: bool,
    /// The source's own fault code; 0 without a fault.
    pub fault: u16,
    /// Actual process values; NaN for values without a measurement.
    pub values: [f64; VALUES],
    /// Age of this report, s.
    pub age_s: f64,
    /// Number of starts.
    pub starts: u32,
}

/// Missed cycles that the drives tolerate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slack {
    /// Number of consecutive missed cycles without harm.
    pub cycles: u32,
    /// Part of a missed cycle recovered in each later cycle: the refill rate of the drives' store.
    pub regained: f64,
}

/// Maximum standstill with the process on of drives without a clock of their own (simulated ones and pulses), s. Longer
/// than a desktop delays a thread without real-time rights, much shorter than the time to burn through.
const STANDS_S: f64 = 0.25;

impl Slack {
    /// Slack of drives that stand still without cycles and continue unchanged.
    pub fn standing(period_s: f64) -> Self {
        Self { cycles: (STANDS_S / period_s).round() as u32, regained: f64::INFINITY }
    }

    /// Limits the gap to `gap_s` in a cycle of `period_s`.
    #[must_use]
    pub fn up_to(self, gap_s: f64, period_s: f64) -> Self {
        // Rounding of the file's milliseconds is permitted.
        let cycles = (gap_s / period_s + 1e-6).floor() as u32;
        Self { cycles: self.cycles.min(cycles), ..self }
    }

    /// Slack of drives with this many stored set-points.
    pub fn stored(cycles: u32) -> Self {
        /// Part of a cycle by which the store refills per cycle.
        const REFILLS: f64 = 0.01;
        Self { cycles, regained: REFILLS }
    }
}

/// All devices of the executive.
pub trait Devices {
    /// Gives `orders` for the next period, waits for its start, and writes the current state to `reports`. Must neither
    /// allocate nor lock.
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports);
    /// Returns the number of missed cycles that the drives tolerate without harm.
    fn rides_out(&self) -> Slack;
    /// Returns the maximum age of a fresh drive report, s.
    fn drives_late_s(&self) -> f64;
    /// Returns the joint picture that arrived in the last exchange, from a scanning beam.
    fn picture(&self) -> Option<Picture<'_>> {
        None
    }
    /// Returns the ways to take the process off without the cycle. Not for the cycle: it may allocate.
    fn cut_offs(&self) -> Vec<Box<dyn CutOff>> {
        Vec::new()
    }
}

/// Boxes and references of devices.
impl<T: DerefMut<Target: Devices>> Devices for T {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        (**self).exchange(orders, reports);
    }

    fn rides_out(&self) -> Slack {
        (**self).rides_out()
    }

    fn drives_late_s(&self) -> f64 {
        (**self).drives_late_s()
    }

    fn picture(&self) -> Option<Picture<'_>> {
        (**self).picture()
    }

    fn cut_offs(&self) -> Vec<Box<dyn CutOff>> {
        (**self).cut_offs()
    }
}
