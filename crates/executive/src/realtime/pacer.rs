use super::Latency;
use crate::executive::{Devices, Orders, ProcessOrders, Reports, Slack};
use seamwright_tracking::beam::Picture;

/// Starts of cycles at whole multiples of a period, by the monotonic clock.
#[derive(Debug)]
pub struct Pacer {
    period_ns: u64,
    next_ns: u64,
    late_ns: u64,
    latency: Latency,
}

impl Pacer {
    /// Starts now, with a cycle every `period_s`.
    pub fn new(period_s: f64) -> Self {
        let period_ns = (period_s * 1e9).round() as u64;
        Self { period_ns, next_ns: clock::now_ns() + period_ns, late_ns: 0, latency: Latency::default() }
    }

    /// Sleeps until the start of the next cycle; returns the number of missed cycles, which are skipped.
    pub fn wait(&mut self) -> u32 {
        clock::sleep_until(self.next_ns);
        let late = clock::now_ns().saturating_sub(self.next_ns);
        let missed = late / self.period_ns;
        self.next_ns += (missed + 1) * self.period_ns;
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
}

/// Devices in real time: each exchange starts after a wait for the period.
#[derive(Debug)]
pub struct Paced<D> {
    /// The devices.
    pub devices: D,
    /// Pacer of the cycles.
    pub pacer: Pacer,
}

impl<D: Devices> Devices for Paced<D> {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        let missed = self.pacer.wait();
        if missed > self.devices.rides_out().cycles {
            // These orders date from before the gap: the process must not burn on by them.
            let process = ProcessOrders { on: false, ..orders.process };
            self.devices.exchange(&Orders { process, ..*orders }, reports);
        } else {
            self.devices.exchange(orders, reports);
        }
        reports.missed = missed;
        reports.late_ns = self.pacer.late_ns();
    }

    fn rides_out(&self) -> Slack {
        self.devices.rides_out()
    }

    fn drives_late_s(&self) -> f64 {
        self.devices.drives_late_s()
    }

    fn picture(&self) -> Option<Picture<'_>> {
        self.devices.picture()
    }
}

#[cfg(target_os = "linux")]
mod clock {
    use rustix::thread::{ClockId as SleepClock, clock_nanosleep_absolute};
    use rustix::time::{ClockId, Timespec, clock_gettime};

    pub(super) fn now_ns() -> u64 {
        let now = clock_gettime(ClockId::Monotonic);
        now.tv_sec as u64 * 1_000_000_000 + now.tv_nsec as u64
    }

    pub(super) fn sleep_until(ns: u64) {
        let until = Timespec { tv_sec: (ns / 1_000_000_000) as i64, tv_nsec: (ns % 1_000_000_000) as i64 };
        // A signal ends the sleep early: go on sleeping.
        while clock_nanosleep_absolute(SleepClock::Monotonic, &until).is_err() && now_ns() < ns {}
    }
}

#[cfg(not(target_os = "linux"))]
mod clock {
    use std::sync::OnceLock;
    use std::time::{Duration, Instant};

    static BEGIN: OnceLock<Instant> = OnceLock::new();

    pub(super) fn now_ns() -> u64 {
        BEGIN.get_or_init(Instant::now).elapsed().as_nanos() as u64
    }

    pub(super) fn sleep_until(ns: u64) {
        std::thread::sleep(Duration::from_nanos(ns.saturating_sub(now_ns())));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cycles are never early and keep to the grid, whatever the duration of the work between them.
    #[test]
    fn cycles_keep_to_the_grid() {
        let mut pacer = Pacer::new(2e-3);
        let begin = pacer.next_ns;
        let (mut cycles, mut most_late) = (0u64, 0);
        for k in 0..50 {
            cycles += 1 + u64::from(pacer.wait());
            most_late = most_late.max(pacer.late_ns());
            assert_eq!(pacer.next_ns, begin + cycles * 2_000_000);
            assert!(clock::now_ns() >= begin + (cycles - 1) * 2_000_000);
            if k % 10 == 0 {
                std::thread::sleep(std::time::Duration::from_millis(5));
            }
        }
        // Each of the five sleeps of 5 ms skips at least one cycle.
        assert!(pacer.latency().missed() >= 5, "{}", pacer.latency().missed());
        assert_eq!(pacer.latency().count(), 50);
        assert!(most_late >= 2_000_000, "{most_late}");
    }
}
