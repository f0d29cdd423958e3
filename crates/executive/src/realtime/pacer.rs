use super::clock::{SteadyTime, SystemTime, TimeSource};
use super::cycle_supervisor::CycleSupervisor;
use super::{Latency, Shutdown};
use crate::executive::{CutOff, Devices, Orders, ProcessOrders, Reports, Slack, Watchdog};
use seamwright_machine::Machine;
use seamwright_tracking::beam::Picture;

/// Starts of cycles at whole multiples of a period, by a steady clock.
#[derive(Debug)]
pub struct Pacer<T = SystemTime> {
    time: T,
    period_ns: u64,
    next: SteadyTime,
    latency: Latency,
}

impl Pacer {
    /// Starts now, with a cycle every `period_s`.
    pub fn new(period_s: f64) -> Self {
        Self::by(SystemTime, period_s)
    }
}

impl<T: TimeSource> Pacer<T> {
    /// Starts now by the clock `time`, with a cycle every `period_s`.
    pub fn by(time: T, period_s: f64) -> Self {
        let period_ns = (period_s * 1e9).round().max(1.0) as u64;
        let next = time.now().later_by(period_ns);
        Self { time, period_ns, next, latency: Latency::default() }
    }

    /// Sleeps until the start of the next cycle; returns the number of missed cycles, which are skipped.
    pub fn wait(&mut self) -> u32 {
        self.time.sleep_until(self.next);
        let late = self.time.now().ns_since(self.next);
        let missed = late / self.period_ns;
        self.next = self.next.later_by((missed + 1) * self.period_ns);
        let missed = u32::try_from(missed).unwrap_or(u32::MAX);
        self.latency.add(late, missed);
        missed
    }

    /// Returns the lateness of the cycles so far.
    pub fn latency(&self) -> &Latency {
        &self.latency
    }

    /// Returns the period, s.
    fn period_s(&self) -> f64 {
        self.period_ns as f64 * 1e-9
    }
}

/// Devices in real time: each exchange starts after a wait for the period.
///
/// After a gap that is longer than the drives tolerate, or than the machine file allows, the first exchange orders the
/// process off and stops the watchdog outputs, whatever the executive ordered before the gap. All reports age by the
/// gap.
#[derive(Debug)]
pub struct Paced<D, T = SystemTime> {
    /// Ends before the devices, whose end may take long.
    supervisor: Option<CycleSupervisor>,
    /// The devices.
    pub devices: D,
    /// Pacer of the cycles.
    pub pacer: Pacer<T>,
    /// Maximum gap of the machine file, s.
    longest_gap_s: Option<f64>,
    /// Time without a cycle after which a device sets its outputs safe by itself, s.
    outputs_safe_s: f64,
}

impl<D: Devices> Paced<D> {
    /// Creates the devices of `machine` in real time. A thread of its own takes the process off when the cycle stops,
    /// and requests `shutdown` if it does not come back.
    pub fn supervised(devices: D, machine: &Machine, shutdown: &Shutdown) -> Self {
        let mut paced = Self::new(devices, machine, Pacer::new(machine.servo_period_s));
        let tolerated_s = f64::from(paced.rides_out().cycles) * machine.servo_period_s;
        let cut_offs = paced.devices.cut_offs();
        paced.supervisor = Some(CycleSupervisor::start(machine.servo_period_s, tolerated_s, cut_offs, shutdown));
        paced
    }
}

impl<D: Devices, T: TimeSource> Paced<D, T> {
    /// Creates the devices of `machine` without a supervisor.
    pub fn new(devices: D, machine: &Machine, pacer: Pacer<T>) -> Self {
        let outputs_safe_s =
            machine.devices.modbus.iter().map(|device| device.watchdog_s).fold(f64::INFINITY, f64::min);
        Self { supervisor: None, devices, pacer, longest_gap_s: machine.longest_gap_s, outputs_safe_s }
    }

    /// Returns true if the process must not go on after a gap of `missed` cycles. A device that has set its outputs
    /// safe meanwhile has taken the process off.
    fn is_late(&self, missed: u32, orders: &Orders) -> bool {
        let gap_s = f64::from(missed) * self.pacer.period_s();
        missed > self.rides_out().cycles || (orders.process.on && gap_s > self.outputs_safe_s)
    }
}

impl<D: Devices, T: TimeSource> Devices for Paced<D, T> {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        let missed = self.pacer.wait();
        let cut_off = self.supervisor.as_ref().is_some_and(CycleSupervisor::count_cycle);
        reports.age_by(f64::from(missed) * self.pacer.period_s());
        let late = cut_off || self.is_late(missed, orders);
        if late {
            // These orders date from before the gap: the process must not burn on by them.
            let process = ProcessOrders { on: false, ..orders.process };
            let watchdog = Watchdog { late: true, ..orders.watchdog };
            self.devices.exchange(&Orders { process, watchdog, ..*orders }, reports);
        } else {
            self.devices.exchange(orders, reports);
        }
        (reports.missed, reports.late) = (missed, late);
    }

    fn rides_out(&self) -> Slack {
        let slack = self.devices.rides_out();
        self.longest_gap_s.map_or(slack, |gap_s| slack.up_to(gap_s, self.pacer.period_s()))
    }

    fn drives_late_s(&self) -> f64 {
        self.devices.drives_late_s()
    }

    fn picture(&self) -> Option<Picture<'_>> {
        self.devices.picture()
    }

    fn cut_offs(&self) -> Vec<Box<dyn CutOff>> {
        self.devices.cut_offs()
    }
}
