use super::clock::{SteadyTime, SystemTime, TimeSource};
use super::cycle_supervisor::CycleSupervisor;
use super::{Latency, Shutdown};
use crate::executive::{CutOff, Devices, Orders, ProcessOrders, Reports, Slack, Watchdog};
use seamwright_machine::{Machine, Role};
use seamwright_tracking::beam::Picture;

/// Starts of cycles at whole multiples of a period, by a steady clock.
#[derive(Debug)]
pub struct Pacer<T = SystemTime> {
    time: T,
    period_ns: u64,
    next: SteadyTime,
    late_ns: u64,
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
        Self { time, period_ns, next, late_ns: 0, latency: Latency::default() }
    }

    /// Sleeps until the start of the next cycle; returns the number of missed cycles, which are skipped.
    pub fn wait(&mut self) -> u32 {
        self.time.sleep_until(self.next);
        let late = self.time.now().ns_since(self.next);
        let missed = late / self.period_ns;
        self.next = self.next.later_by((missed + 1) * self.period_ns);
        let missed = u32::try_from(missed).unwrap_or(u32::MAX);
        self.late_ns = late;
        self.latency.add(late, missed);
        missed
    }

    /// Returns the lateness of the start of this cycle, ns.
    pub fn late_ns(&self) -> u64 {
        self.late_ns
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
    /// Time without a cycle after which the process source sets its outputs safe by itself, s.
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
        let modbus = machine.devices.modbus.iter();
        let sources = modbus.filter(|device| device.registers.iter().any(|register| register.role == Role::On));
        let outputs_safe_s = sources.map(|device| device.watchdog_s).fold(f64::INFINITY, f64::min);
        Self { supervisor: None, devices, pacer, longest_gap_s: machine.longest_gap_s, outputs_safe_s }
    }

    /// Returns true if the process must not go on after a gap of `missed` cycles. A source whose outputs went safe
    /// meanwhile has taken the process off.
    fn is_late(&self, missed: u32, orders: &Orders) -> bool {
        let gap_s = f64::from(missed) * self.pacer.period_s();
        missed > self.rides_out().cycles || (orders.process.on && gap_s > self.outputs_safe_s + 1e-9)
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
        reports.late_ns = self.pacer.late_ns();
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

#[cfg(test)]
mod tests {
    use super::super::ManualTime;
    use super::*;
    use seamwright_machine::shipped;
    use seamwright_testkit::Random;
    use std::time::Duration;

    /// Cycles keep to the grid of the clock, whatever the duration of the work between them; the time of all cycles and
    /// missed cycles is that of the clock.
    #[test]
    fn cycles_keep_to_the_grid() {
        let time = ManualTime::default();
        let (begin, period) = (time.now(), Duration::from_millis(2));
        let mut pacer = Pacer::by(time.clone(), 2e-3);
        let (mut cycles, mut random) = (0u64, Random::new(3));
        for _ in 0..5000 {
            // Mostly shorter than a period, sometimes up to a quarter of an hour.
            let work_us = random.bits() % 10u64.pow(1 + random.below(9) as u32);
            time.advance(Duration::from_micros(work_us));
            cycles += 1 + u64::from(pacer.wait());
            let now = time.now().since(begin);
            let grid = Duration::from_millis(2 * cycles);
            assert!(now >= grid && now < grid + period, "cycle {cycles} at {now:?}");
        }
        assert_eq!(pacer.latency().count() + pacer.latency().missed(), cycles);
    }

    /// Keeps the last orders; its reports never come.
    #[derive(Default)]
    struct Mute {
        orders: Orders,
        slack: u32,
    }

    impl Devices for Mute {
        fn exchange(&mut self, orders: &Orders, _reports: &mut Reports) {
            self.orders = *orders;
        }

        fn rides_out(&self) -> Slack {
            Slack::stored(self.slack)
        }

        fn drives_late_s(&self) -> f64 {
            0.0
        }
    }

    /// The ages of all devices grow by the true length of every gap. A gap that is too long takes the process off: for
    /// the drives, for the machine file, or for the process source.
    #[test]
    fn reports_age_and_the_process_goes_off_over_a_gap() {
        let text = shipped("ellipse-xy").unwrap().text;
        let key = "servo_period_ms = 1\n";
        assert!(text.contains(key));
        let limited = text.replace(key, &format!("{key}longest_gap_ms = 40\n"));
        let source = "[devices.io.modbus]\naddress = \"a:1\"\nwatchdog_s = 0.03\noutputs.on = { coil = 1 }\n\
                      reports.burning = { discrete = 1 }\n";
        let with_source = format!("{text}\n{source}");
        for (text, slack, limit_ms) in
            [(text, 10, 10), (&limited, 10, 10), (&limited, 250, 40), (&with_source, 250, 30)]
        {
            let machine = Machine::read("m.toml", text).unwrap_or_else(|e| panic!("{e}"));
            for gap_ms in [0, limit_ms, limit_ms + 1, 300, 2000, 10_000, 3_600_000] {
                let time = ManualTime::default();
                let pacer = Pacer::by(time.clone(), machine.servo_period_s);
                let mut paced = Paced::new(Mute { slack, ..Mute::default() }, &machine, pacer);
                let mut orders = Orders::default();
                orders.process.on = true;
                let mut reports = Reports::default();
                (reports.drives.age_s, reports.source.age_s, reports.inputs_age_s) = (0.5, 0.25, 0.125);
                paced.exchange(&orders, &mut reports);
                assert!(paced.devices.orders == orders && reports.missed == 0 && !reports.late);
                time.advance(Duration::from_millis(1 + gap_ms));
                paced.exchange(&orders, &mut reports);
                let late = gap_ms > limit_ms;
                assert_eq!((u64::from(reports.missed), reports.late), (gap_ms, late), "{gap_ms} ms");
                let given = paced.devices.orders;
                assert_eq!((given.process.on, given.watchdog.late), (!late, late), "{gap_ms} ms");
                let gap_s = 1e-3 * gap_ms as f64;
                let ages = [reports.drives.age_s, reports.source.age_s, reports.inputs_age_s, reports.sensors.age_s];
                for (age_s, before_s) in ages.into_iter().zip([0.5, 0.25, 0.125, 0.0]) {
                    assert!((age_s - before_s - gap_s).abs() < 1e-6, "{age_s}");
                }
            }
        }
    }
}
