use super::{Drives, InputBits, Inputs, Sensors, Source};
use crate::executive::{DriveReport, Orders, ProcessOrders, SeamOrders, SensorReport, Slack, SourceReport};
use glam::DVec2;
use seamwright_machine::Joints;
use seamwright_tracking::beam::Picture;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// What a fault happens to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Device {
    /// The drives.
    Drives,
    /// The process source.
    Source,
    /// The inputs.
    Inputs,
    /// What sees the joint.
    Sensors,
    /// The cell's own cycle, which comes late: no device that a plan of faults has.
    Cycle,
}

/// What happens to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FaultKind {
    /// It does what it is told, and reports nothing.
    Silent,
    /// It reports what was, some periods ago.
    Slow,
    /// It reports what is not so: a jump of a position, an arc that is out, an input upside down, a joint anywhere.
    Wrong,
    /// No line to it: no orders, no reports. What watches orders switches off by itself.
    Disconnect,
    /// It starts anew, and has forgotten what it was told.
    Reboot,
    /// No line to it for a second.
    Reconnect,
}

/// When a fault begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum When {
    /// After so many seconds.
    At(f64),
    /// When it is told: see [`Faulty::told_by`].
    Told,
}

/// A fault of a device.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fault {
    /// What it happens to.
    pub device: Device,
    /// What happens.
    pub kind: FaultKind,
    /// When it begins.
    pub when: When,
    /// How long it lasts, s; infinite if it does not end.
    pub lasts_s: f64,
    /// Which axis or input is wrong.
    pub which: u8,
}

impl Device {
    /// All that a plan of faults may name.
    pub const ALL: [Self; 4] = [Self::Drives, Self::Source, Self::Inputs, Self::Sensors];

    /// In one word.
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
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Silent, Self::Slow, Self::Wrong, Self::Disconnect, Self::Reboot, Self::Reconnect];

    /// Nothing is heard of the device.
    fn is_mute(self) -> bool {
        matches!(self, Self::Silent | Self::Disconnect | Self::Reboot | Self::Reconnect)
    }

    /// In one word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Silent => "silent",
            Self::Slow => "slow",
            Self::Wrong => "wrong",
            Self::Disconnect => "disconnect",
            Self::Reboot => "reboot",
            Self::Reconnect => "reconnect",
        }
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

/// As on the command line: `drives:silent@12.5` or `inputs:disconnect@3+0.5`: device, kind, time and duration in s.
impl FromStr for Fault {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = "DEVICE:KIND@TIME[+DURATION], like drives:silent@12.5 or inputs:disconnect@3+0.5";
        let bad = |what: &str| format!("{what}; allowed is {form}");
        let (device, rest) = text.split_once(':').ok_or_else(|| bad("there is no `:` after the device"))?;
        let (kind, when) = rest.split_once('@').ok_or_else(|| bad("there is no `@` with the time"))?;
        let device = Device::ALL.into_iter().find(|d| d.name() == device).ok_or_else(|| {
            format!("there is no device `{device}`; allowed are {}", Device::ALL.map(Device::name).join(", "))
        })?;
        let kind = FaultKind::ALL.into_iter().find(|k| k.name() == kind).ok_or_else(|| {
            format!("there is no fault `{kind}`; allowed are {}", FaultKind::ALL.map(FaultKind::name).join(", "))
        })?;
        let number = |text: &str, what: &str| {
            let number = text.parse::<f64>().ok().filter(|t| t.is_finite() && *t >= 0.0);
            number.ok_or_else(|| bad(&format!("`{text}` is no {what} in seconds")))
        };
        let (at, lasts_s) = match when.split_once('+') {
            Some((at, lasts)) => (number(at, "time")?, number(lasts, "duration")?),
            None => (number(when, "time")?, f64::INFINITY),
        };
        Ok(Self { device, kind, when: When::At(at), lasts_s, which: 0 })
    }
}

/// Periods by which a slow device is late.
const LATE: usize = 8;
/// Time that a device needs to start, s.
const STARTS_S: f64 = 0.5;
/// Time without a line to a device that is heard again, s.
const AWAY_S: f64 = 1.0;
/// By how far a wrong position jumps, mm or rad.
const JUMP: f64 = 5.0;

/// A device before which a plan of faults stands.
#[derive(Debug, Clone)]
pub struct Faulty<T, R> {
    device: T,
    period: f64,
    faults: Vec<(Fault, Option<f64>)>,
    /// Periods since the start, as time in s.
    t: f64,
    /// What was reported in the last periods, newest last.
    late: Vec<R>,
    /// What the device itself reported last.
    own: Option<R>,
    /// Starts that the plan added.
    starts: u32,
    /// What was known before the last start is forgotten.
    forgotten: bool,
    /// Nothing is to be seen.
    dark: bool,
    /// Faults that wait to be told begin when this is true.
    told: Option<Arc<AtomicBool>>,
}

impl<T, R: Copy + Default> Faulty<T, R> {
    /// `device` with those of `faults` that are of this `kind`; `period_s` is that of the cycle.
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
            told: None,
        }
    }

    /// The device itself.
    pub fn device(&self) -> &T {
        &self.device
    }

    /// Faults that wait to be told begin when `told` becomes true.
    #[must_use]
    pub fn told_by(mut self, told: &Arc<AtomicBool>) -> Self {
        self.told = Some(Arc::clone(told));
        self
    }

    /// The fault of this period, and if this is its first.
    fn now(&mut self) -> Option<(Fault, bool)> {
        self.t += self.period;
        let t = self.t;
        let told = self.told.as_ref().is_some_and(|told| told.load(Ordering::Relaxed));
        let mut found = None;
        for (fault, begun) in &mut self.faults {
            let comes = match fault.when {
                When::At(at) => t >= at,
                When::Told => told,
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

    /// What is reported `LATE` periods after it was so.
    fn delayed(&mut self, fresh: R, slow: bool) -> R {
        if self.late.len() > LATE {
            self.late.remove(0);
        }
        self.late.push(fresh);
        if slow { self.late[0] } else { fresh }
    }
}

impl<T: Drives> Drives for Faulty<T, DriveReport> {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        let fault = self.now();
        let kind = fault.map(|(f, _)| f.kind);
        let cut = matches!(kind, Some(FaultKind::Disconnect | FaultKind::Reboot | FaultKind::Reconnect));
        // Without orders the drives' own watchdog takes the power.
        let orders = if cut { Orders { power: false, ..*orders } } else { *orders };
        let mut fresh = self.own.unwrap_or(*report);
        self.device.exchange(&orders, &mut fresh);
        self.own = Some(fresh);
        if matches!(fault, Some((Fault { kind: FaultKind::Reboot, .. }, true))) {
            (self.starts, self.forgotten) = (self.starts + 1, true);
        }
        fresh.starts += self.starts;
        // A drive that has started anew looks for its reference again.
        self.forgotten &= !(orders.home && fresh.powered);
        if self.forgotten {
            fresh.referenced = 0;
        }
        let delayed = self.delayed(fresh, kind == Some(FaultKind::Slow));
        *report = match fault {
            Some((Fault { kind: k, .. }, _)) if k.is_mute() => {
                DriveReport { age_s: report.age_s + self.period, ..*report }
            }
            Some((Fault { kind: FaultKind::Slow, .. }, _)) => {
                DriveReport { age_s: LATE as f64 * self.period, ..delayed }
            }
            Some((Fault { kind: FaultKind::Wrong, which, .. }, _)) => {
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
    fn exchange(&mut self, orders: &ProcessOrders, report: &mut SourceReport) {
        let fault = self.now();
        let kind = fault.map(|(f, _)| f.kind);
        let cut = matches!(kind, Some(FaultKind::Disconnect | FaultKind::Reboot | FaultKind::Reconnect));
        let orders = if cut { ProcessOrders::default() } else { *orders };
        let mut fresh = self.own.unwrap_or(*report);
        self.device.exchange(&orders, &mut fresh);
        self.own = Some(fresh);
        if matches!(fault, Some((Fault { kind: FaultKind::Reboot, .. }, true))) {
            self.starts += 1;
        }
        fresh.starts += self.starts;
        let delayed = self.delayed(fresh, kind == Some(FaultKind::Slow));
        *report = match kind {
            Some(k) if k.is_mute() => SourceReport { age_s: report.age_s + self.period, ..*report },
            Some(FaultKind::Slow) => SourceReport { age_s: LATE as f64 * self.period, ..delayed },
            Some(FaultKind::Wrong) => SourceReport { burning: !fresh.burning, ..fresh },
            _ => fresh,
        };
    }
}

impl<T: Inputs> Inputs for Faulty<T, InputBits> {
    fn exchange(&mut self, watchdog: bool, inputs: &mut InputBits) {
        let fault = self.now();
        let kind = fault.map(|(f, _)| f.kind);
        let mut fresh = self.own.unwrap_or(*inputs);
        self.device.exchange(watchdog, &mut fresh);
        self.own = Some(fresh);
        if matches!(fault, Some((Fault { kind: FaultKind::Reboot, .. }, true))) {
            self.starts += 1;
        }
        fresh.starts += self.starts;
        let delayed = self.delayed(fresh, kind == Some(FaultKind::Slow));
        match fault {
            Some((Fault { kind: k, .. }, _)) if k.is_mute() => inputs.age_s += self.period,
            Some((Fault { kind: FaultKind::Slow, .. }, _)) => {
                *inputs = InputBits { age_s: LATE as f64 * self.period, ..delayed };
            }
            Some((Fault { kind: FaultKind::Wrong, which, .. }, _)) => {
                *inputs = InputBits { bits: fresh.bits ^ (1 << which), ..fresh };
            }
            _ => *inputs = fresh,
        }
    }
}

impl<T: Sensors> Sensors for Faulty<T, SensorReport> {
    fn exchange(&mut self, orders: &SeamOrders, truth: Option<&Joints>, report: &mut SensorReport) {
        let fault = self.now();
        let kind = fault.map(|(f, _)| f.kind);
        let mut fresh = *report;
        self.device.exchange(orders, truth, &mut fresh);
        if matches!(fault, Some((Fault { kind: FaultKind::Reboot, .. }, true))) {
            self.starts += 1;
        }
        fresh.starts = 1 + self.starts;
        let delayed = self.delayed(fresh, kind == Some(FaultKind::Slow));
        // Pictures that are wrong or late are none.
        self.dark = kind.is_some();
        *report = match kind {
            Some(k) if k.is_mute() => {
                SensorReport { measured: [None; 2], age_s: report.age_s + self.period, ..*report }
            }
            Some(FaultKind::Slow) => SensorReport { age_s: LATE as f64 * self.period, ..delayed },
            Some(FaultKind::Wrong) => {
                for measured in fresh.measured.iter_mut().flatten() {
                    // Anywhere within a jump, never twice in one place.
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
            ("drives", "`:`"),
            ("drives:silent", "`@`"),
            ("drivers:silent@1", "drives, source, inputs, sensors"),
            ("drives:dead@1", "silent, slow, wrong, disconnect, reboot, reconnect"),
            ("drives:silent@soon", "`soon`"),
            ("drives:silent@1+-2", "`-2`"),
            ("drives:silent@nan", "`nan`"),
        ] {
            let error = bad.parse::<Fault>().unwrap_err();
            assert!(error.contains(says) && error.contains("allowed"), "{bad}: {error}");
        }
    }
}
