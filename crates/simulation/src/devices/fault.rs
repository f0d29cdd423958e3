use glam::DVec2;
use seamwright_executive::devices::{Drives, InputBits, Inputs, Sensors, Source};
use seamwright_executive::{
    CutOff, DriveReport, Orders, ProcessOrders, SeamOrders, SensorReport, Slack, SourceReport, Watchdog,
};
use seamwright_machine::Joints;
use seamwright_message::{Message, display_by_message, named_enum};
use seamwright_tracking::beam::Picture;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Device that a fault affects.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Device {
    /// The drives.
    Drives,
    /// The process source.
    Source,
    /// The inputs.
    Inputs,
    /// The joint sensors: camera or beam.
    Sensors,
    /// The cell's own cycle, which comes late. A fault plan cannot name it.
    Cycle,
}

named_enum! {
    /// Kind of fault.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum FaultKind {
        /// The device executes orders but its reports stop.
        Silent => "silent",
        /// Reports are delayed by some periods.
        Slow => "slow",
        /// Reports are wrong: a jump of a position, an inverted arc state, an inverted input, a random joint deviation.
        Wrong => "wrong",
        /// The connection is cut: no orders, no reports. The device's watchdog switches it off.
        Disconnect => "disconnect",
        /// The device restarts and loses its state.
        Reboot => "reboot",
        /// The connection is cut for one second.
        Reconnect => "reconnect",
    }
}

/// Start of a fault.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum When {
    /// At this time after the start, s.
    At(f64),
    /// As soon as the flag of [`Faulty::flagged_by`] is set.
    Flagged,
}

/// A fault of a device.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fault {
    /// Affected device.
    pub device: Device,
    /// Kind of fault.
    pub kind: FaultKind,
    /// Start of the fault.
    pub when: When,
    /// Duration, s; infinite if the fault is permanent.
    pub lasts_s: f64,
    /// Index of the wrong axis or input.
    pub which: u8,
}

impl Device {
    /// Devices that a fault plan may name.
    pub const ALL: [Self; 4] = [Self::Drives, Self::Source, Self::Inputs, Self::Sensors];

    /// Name in a fault plan.
    pub fn name(self) -> &'static str {
        match self {
            Self::Drives => "drives",
            Self::Source => "source",
            Self::Inputs => "inputs",
            Self::Sensors => "sensors",
            Self::Cycle => "cycle",
        }
    }
}

impl FaultKind {
    /// True if no report arrives from the device.
    fn is_mute(self) -> bool {
        matches!(self, Self::Silent | Self::Disconnect | Self::Reboot | Self::Reconnect)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.device.name(), self.kind.name())?;
        if let When::At(t) = self.when {
            write!(f, "@{t}")?;
        }
        if self.lasts_s.is_finite() { write!(f, "+{}", self.lasts_s) } else { Ok(()) }
    }
}

/// Reason why a text is not a [`Fault`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum InvalidFault {
    /// It has another form.
    Form,
    /// Unknown device.
    Device(String),
    /// Unknown kind of fault.
    Kind(String),
    /// Invalid time or duration.
    Time(String),
}

impl InvalidFault {
    /// Returns its message.
    pub fn message(&self) -> Message {
        let of =
            |code, name: &str, names: &[&str]| Message::new(code).text("name", name).text("names", names.join(", "));
        match self {
            Self::Form => Message::new("cell-fault-form"),
            Self::Device(name) => of("cell-fault-no-device", name, &Device::ALL.map(Device::name)),
            Self::Kind(name) => of("cell-fault-no-kind", name, &FaultKind::ALL.map(FaultKind::name)),
            Self::Time(text) => Message::new("cell-fault-no-time").text("text", text),
        }
    }
}

display_by_message!(InvalidFault);

/// Parses the form of the command line, `drives:silent@12.5` or `inputs:disconnect@3+0.5`: device, kind, time and
/// duration in s.
impl FromStr for Fault {
    type Err = InvalidFault;

    fn from_str(text: &str) -> Result<Self, InvalidFault> {
        let (device, rest) = text.split_once(':').ok_or(InvalidFault::Form)?;
        let (kind, when) = rest.split_once('@').ok_or(InvalidFault::Form)?;
        let known = Device::ALL.into_iter().find(|d| d.name() == device);
        let device = known.ok_or_else(|| InvalidFault::Device(device.to_owned()))?;
        let known = FaultKind::ALL.into_iter().find(|k| k.name() == kind);
        let kind = known.ok_or_else(|| InvalidFault::Kind(kind.to_owned()))?;
        let seconds = |text: &str| {
            let number = text.parse::<f64>().ok().filter(|t| t.is_finite() && *t >= 0.0);
            number.ok_or_else(|| InvalidFault::Time(text.to_owned()))
        };
        let (at, lasts_s) = match when.split_once('+') {
            Some((at, lasts)) => (seconds(at)?, seconds(lasts)?),
            None => (seconds(when)?, f64::INFINITY),
        };
        Ok(Self { device, kind, when: When::At(at), lasts_s, which: 0 })
    }
}

/// Delay of a slow device, periods.
const LATE: usize = 8;
/// Restart time of a device, s.
const STARTS_S: f64 = 0.5;
/// Duration of [`FaultKind::Reconnect`], s.
const AWAY_S: f64 = 1.0;
/// Jump of a wrong position, mm or rad.
const JUMP: f64 = 5.0;

/// Device with fault injection.
#[derive(Debug, Clone)]
pub struct Faulty<T, R> {
    device: T,
    period: f64,
    faults: Vec<(Fault, Option<f64>)>,
    /// Time since the start, counted in periods, s.
    t: f64,
    /// Reports of the last periods, newest last.
    late: Vec<R>,
    /// Last report of the device itself.
    own: Option<R>,
    /// Restarts that the fault plan added.
    starts: u32,
    /// The reference is lost since the last restart.
    forgotten: bool,
    /// No pictures arrive.
    dark: bool,
    /// Flag that starts the faults with [`When::Flagged`].
    flag: Option<Arc<AtomicBool>>,
}

impl<T, R: Copy + Default> Faulty<T, R> {
    /// Wraps `device` with those of `faults` that affect this `kind`; `period_s` is the cycle's period.
    pub fn new(device: T, kind: Device, faults: &[Fault], period_s: f64) -> Self {
        let faults = faults.iter().filter(|f| f.device == kind).map(|f| (*f, None)).collect();
        Self {
            device,
            period: period_s,
            faults,
            t: 0.0,
            late: Vec::with_capacity(LATE + 1),
            own: None,
            starts: 0,
            forgotten: false,
            dark: false,
            flag: None,
        }
    }

    /// Returns the wrapped device.
    pub fn device(&self) -> &T {
        &self.device
    }

    /// Sets the flag that starts the faults with [`When::Flagged`].
    #[must_use]
    pub fn flagged_by(mut self, flag: &Arc<AtomicBool>) -> Self {
        self.flag = Some(Arc::clone(flag));
        self
    }

    /// Returns the fault of this period, and whether this is its first period.
    fn now(&mut self) -> Option<(Fault, bool)> {
        self.t += self.period;
        let t = self.t;
        let is_flagged = self.flag.as_ref().is_some_and(|flag| flag.load(Ordering::Relaxed));
        let mut found = None;
        for (fault, begun) in &mut self.faults {
            let comes = match fault.when {
                When::At(at) => t >= at,
                When::Flagged => is_flagged,
            };
            let first = begun.is_none() && comes;
            if first {
                *begun = Some(t);
            }
            let lasts = match fault.kind {
                FaultKind::Reboot => STARTS_S,
                FaultKind::Reconnect => AWAY_S,
                _ => fault.lasts_s,
            };
            if let Some(begun) = *begun
                && t - begun < lasts
            {
                found = Some((*fault, first));
            }
        }
        found
    }

    /// Starts a period: returns its fault, and counts a restart that begins.
    fn begin(&mut self) -> Option<Fault> {
        let (fault, first) = self.now()?;
        if first && fault.kind == FaultKind::Reboot {
            (self.starts, self.forgotten) = (self.starts + 1, true);
        }
        Some(fault)
    }

    /// Stores `fresh`; returns the report of `LATE` periods ago if the fault is slow.
    fn delayed(&mut self, fresh: R, fault: Option<Fault>) -> R {
        if self.late.len() > LATE {
            self.late.remove(0);
        }
        self.late.push(fresh);
        if fault.is_some_and(|f| f.kind == FaultKind::Slow) { self.late[0] } else { fresh }
    }
}

impl<T: Drives> Drives for Faulty<T, DriveReport> {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        let fault = self.begin();
        let cut = fault.is_some_and(|f| f.kind.is_mute() && f.kind != FaultKind::Silent);
        // Without orders the drives' own watchdog switches the power off.
        let orders = if cut { Orders { power: false, ..*orders } } else { *orders };
        let mut fresh = self.own.unwrap_or(*report);
        self.device.exchange(&orders, &mut fresh);
        self.own = Some(fresh);
        fresh.starts += self.starts;
        // A restarted drive needs homing.
        self.forgotten &= !(orders.home && fresh.powered);
        if self.forgotten {
            fresh.referenced = 0;
        }
        let delayed = self.delayed(fresh, fault);
        *report = match fault {
            Some(Fault { kind: k, .. }) if k.is_mute() => DriveReport { age_s: report.age_s + self.period, ..*report },
            Some(Fault { kind: FaultKind::Slow, .. }) => DriveReport { age_s: LATE as f64 * self.period, ..delayed },
            Some(Fault { kind: FaultKind::Wrong, which, .. }) => {
                let mut wrong = fresh;
                wrong.position[usize::from(which)] += JUMP;
                wrong.following_error[usize::from(which)] -= JUMP;
                wrong
            }
            _ => fresh,
        };
    }

    fn rides_out(&self) -> Slack {
        self.device.rides_out()
    }

    fn late_s(&self) -> f64 {
        self.device.late_s()
    }

    fn truth(&self) -> Option<&Joints> {
        self.device.truth()
    }
}

impl<T: Source> Source for Faulty<T, SourceReport> {
    fn exchange(&mut self, orders: &ProcessOrders, watchdog: Watchdog, report: &mut SourceReport) {
        let fault = self.begin();
        let cut = fault.is_some_and(|f| f.kind.is_mute() && f.kind != FaultKind::Silent);
        let orders = if cut { ProcessOrders::default() } else { *orders };
        let mut fresh = self.own.unwrap_or(*report);
        self.device.exchange(&orders, watchdog, &mut fresh);
        self.own = Some(fresh);
        fresh.starts += self.starts;
        let delayed = self.delayed(fresh, fault);
        *report = match fault.map(|f| f.kind) {
            Some(k) if k.is_mute() => SourceReport { age_s: report.age_s + self.period, ..*report },
            Some(FaultKind::Slow) => SourceReport { age_s: LATE as f64 * self.period, ..delayed },
            Some(FaultKind::Wrong) => SourceReport { burning: !fresh.burning, ..fresh },
            _ => fresh,
        };
    }

    fn cut_off(&self) -> Option<Box<dyn CutOff>> {
        self.device.cut_off()
    }
}

impl<T: Inputs> Inputs for Faulty<T, InputBits> {
    fn exchange(&mut self, watchdog: Watchdog, inputs: &mut InputBits) {
        let fault = self.begin();
        let mut fresh = self.own.unwrap_or(*inputs);
        self.device.exchange(watchdog, &mut fresh);
        self.own = Some(fresh);
        fresh.starts += self.starts;
        let delayed = self.delayed(fresh, fault);
        match fault {
            Some(Fault { kind: k, .. }) if k.is_mute() => inputs.age_s += self.period,
            Some(Fault { kind: FaultKind::Slow, .. }) => {
                *inputs = InputBits { age_s: LATE as f64 * self.period, ..delayed };
            }
            Some(Fault { kind: FaultKind::Wrong, which, .. }) => {
                *inputs = InputBits { bits: fresh.bits ^ (1 << which), ..fresh };
            }
            _ => *inputs = fresh,
        }
    }

    fn cut_off(&self) -> Option<Box<dyn CutOff>> {
        self.device.cut_off()
    }
}

impl<T: Sensors> Sensors for Faulty<T, SensorReport> {
    fn exchange(&mut self, orders: &SeamOrders, truth: Option<&Joints>, report: &mut SensorReport) {
        let fault = self.begin();
        let mut fresh = *report;
        self.device.exchange(orders, truth, &mut fresh);
        fresh.starts = 1 + self.starts;
        let delayed = self.delayed(fresh, fault);
        // Every sensor fault drops the pictures.
        self.dark = fault.is_some();
        *report = match fault.map(|f| f.kind) {
            Some(k) if k.is_mute() => {
                SensorReport { measured: [None; 2], age_s: report.age_s + self.period, ..*report }
            }
            Some(FaultKind::Slow) => SensorReport { age_s: LATE as f64 * self.period, ..delayed },
            Some(FaultKind::Wrong) => {
                for measured in fresh.measured.iter_mut().flatten() {
                    // A pseudo-random offset within one jump, different for each measurement.
                    let anywhere = |by: f64| JUMP * (1e3 * by * measured.exposed_s).sin();
                    measured.offset = DVec2::new(anywhere(7.13), anywhere(3.71));
                }
                fresh
            }
            _ => fresh,
        };
    }

    fn picture(&self) -> Option<Picture<'_>> {
        self.device.picture().filter(|_| !self.dark)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_read_as_they_are_written() {
        for device in Device::ALL {
            for kind in FaultKind::ALL {
                for (at, lasts_s) in [(0.0, f64::INFINITY), (12.5, 0.25), (1e-3, 1e6)] {
                    let fault = Fault { device, kind, when: When::At(at), lasts_s, which: 0 };
                    assert_eq!(fault.to_string().parse::<Fault>(), Ok(fault));
                }
            }
        }
        for (bad, says) in [
            ("drives", "DEVICE:KIND@TIME"),
            ("drives:silent", "DEVICE:KIND@TIME"),
            ("drivers:silent@1", "drives, source, inputs, sensors"),
            ("drives:dead@1", "silent, slow, wrong, disconnect, reboot, reconnect"),
            ("drives:silent@soon", "`soon`"),
            ("drives:silent@1+-2", "`-2`"),
            ("drives:silent@nan", "`nan`"),
        ] {
            let error = bad.parse::<Fault>().unwrap_err().to_string();
            assert!(error.contains(says) && error.contains("allowed"), "{bad}: {error}");
        }
    }
}
