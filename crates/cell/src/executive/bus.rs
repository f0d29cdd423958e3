use super::guide::SeamOrders;
use seamwright_machine::{Joints, MAX_AXES};
use seamwright_servo::SetPoint;
use seamwright_tracking::beam::Picture;
use seamwright_tracking::lead::Measurement;

/// Most process values of a weld.
pub const VALUES: usize = 16;

/// What the executive wants of the devices in a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Orders {
    /// The drives shall have power.
    pub power: bool,
    /// The drives shall find their references, each by its own way; set-points do not count then.
    pub home: bool,
    /// Where each axis shall be, mm or rad; followed only with power.
    pub set: [SetPoint; MAX_AXES],
    /// The process.
    pub process: ProcessOrders,
    /// What sees the joint, and the beam's deflection.
    pub seam: SeamOrders,
    /// Changes its value in every cycle: outputs fall to their safe states if it stops to.
    pub watchdog: bool,
}

/// What the process source shall do.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ProcessOrders {
    /// The gas valve is open.
    pub gas: bool,
    /// Arc or beam.
    pub on: bool,
    /// Process values, in the order of [`super::Work::values`]; no number for one that is not asked for.
    pub values: [f64; VALUES],
}

/// What the devices know of themselves; by default nothing, since ever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reports {
    /// The drives.
    pub drives: DriveReport,
    /// The process source.
    pub source: SourceReport,
    /// Inputs, a bit each, in the order of the machine's conditions.
    pub inputs: u64,
    /// Age of the inputs, s.
    pub inputs_age_s: f64,
    /// How often the device of the inputs has started.
    pub inputs_starts: u32,
    /// What sees the joint.
    pub sensors: SensorReport,
    /// Cycles missed before this one.
    pub missed: u32,
    /// Where the axes truly are, of simulated drives: for who judges a weld, never for what controls it.
    pub truth: Option<Joints>,
}

/// What the sensors ahead of the torches report.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SensorReport {
    /// Of each head, what has arrived in this period.
    pub measured: [Option<Measurement>; 2],
    /// Time since anything came while it should, s.
    pub age_s: f64,
    /// How often they have started.
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
            truth: None,
        }
    }
}

/// What the drives report.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DriveReport {
    /// They have power.
    pub powered: bool,
    /// Measured positions, mm or rad.
    pub position: Joints,
    /// Following error of each axis, mm or rad.
    pub following_error: Joints,
    /// Current of each drive as a part of its peak.
    pub current: Joints,
    /// Axes with a fault, a bit each.
    pub fault: u16,
    /// Axes on a limit switch, a bit each.
    pub limit_switch: u16,
    /// Axes whose reference is known, a bit each.
    pub referenced: u16,
    /// Age of all this, s.
    pub age_s: f64,
    /// How often they have started.
    pub starts: u32,
    /// How often they ran out of set-points since they started: all axes stand still at once then, beyond their limits.
    pub starved: u32,
}

/// What the process source reports.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SourceReport {
    /// It could be switched on.
    pub ready: bool,
    /// Arc or beam is there.
    pub burning: bool,
    /// The wire sticks.
    pub stuck: bool,
    /// Its own fault code; 0 is none.
    pub fault: u16,
    /// Actual process values; no number where it does not measure one.
    pub values: [f64; VALUES],
    /// Age of all this, s.
    pub age_s: f64,
    /// How often it has started.
    pub starts: u32,
}

/// Missed cycles that the drives ride out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slack {
    /// So many at once do no harm.
    pub cycles: u32,
    /// Part of a missed cycle that is made up for in each cycle after it: how fast what the drives have in store fills again.
    pub regained: f64,
}

/// Longest time that drives without a clock of their own, simulated ones and pulses, may stand still at a place with the process
/// on, s. Above what a desktop without real-time rights makes a thread wait, far below what burns through.
const STANDS_S: f64 = 0.25;

impl Slack {
    /// Of drives that stand where they are while no cycle comes, and go on as if nothing had been.
    pub fn standing(period_s: f64) -> Self {
        Self { cycles: (STANDS_S / period_s).round() as u32, regained: f64::INFINITY }
    }

    /// Of drives with this many set-points in store.
    pub fn stored(cycles: u32) -> Self {
        /// Part of a cycle by which the store fills again in a cycle.
        const REFILLS: f64 = 0.01;
        Self { cycles, regained: REFILLS }
    }
}

/// Everything that the executive drives.
pub trait Devices {
    /// Gives `orders` for the next period, waits until it begins, and puts into `reports` what is known then. Must neither
    /// allocate nor lock.
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports);
    /// Missed cycles that the drives ride out without harm.
    fn rides_out(&self) -> Slack;
    /// Greatest age of the drives' report that is still fresh, s.
    fn drives_late_s(&self) -> f64;
    /// The picture of the joint that has arrived in the last exchange, of a beam that looks.
    fn picture(&self) -> Option<Picture<'_>> {
        None
    }
}

impl<D: Devices + ?Sized> Devices for Box<D> {
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
}

impl<D: Devices + ?Sized> Devices for &mut D {
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
}
