use std::ops::{Add, Sub};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

/// A time on the computer's steady clock: it never jumps, and it counts while the computer is suspended.
///
/// On Linux it is `CLOCK_BOOTTIME`. `CLOCK_MONOTONIC`, the clock of [`std::time::Instant`], stands still during a
/// suspend: the arc of a welding source does not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct SteadyTime {
    ns: u64,
}

impl SteadyTime {
    /// Returns the current time.
    pub fn now() -> Self {
        Self { ns: system::now_ns() }
    }

    /// Returns the time since `earlier`; zero if that is later.
    #[must_use]
    pub fn since(self, earlier: Self) -> Duration {
        Duration::from_nanos(self.ns.saturating_sub(earlier.ns))
    }

    /// Returns the time since then, s.
    #[must_use]
    pub fn elapsed_s(self) -> f64 {
        Self::now().since(self).as_secs_f64()
    }

    /// Returns the time `ns` nanoseconds later.
    #[must_use]
    pub(super) fn later_by(self, ns: u64) -> Self {
        Self { ns: self.ns.saturating_add(ns) }
    }

    /// Returns the nanoseconds since `earlier`; zero if that is later.
    pub(super) fn ns_since(self, earlier: Self) -> u64 {
        self.ns.saturating_sub(earlier.ns)
    }
}

impl Add<Duration> for SteadyTime {
    type Output = Self;

    fn add(self, by: Duration) -> Self {
        self.later_by(u64::try_from(by.as_nanos()).unwrap_or(u64::MAX))
    }
}

impl Sub<Duration> for SteadyTime {
    type Output = Self;

    fn sub(self, by: Duration) -> Self {
        Self { ns: self.ns.saturating_sub(u64::try_from(by.as_nanos()).unwrap_or(u64::MAX)) }
    }
}

/// A source of time for cycles: the computer's clock, or one that a test sets.
pub trait TimeSource {
    /// Returns the current time.
    fn now(&self) -> SteadyTime;
    /// Waits until `time`. Must neither allocate nor lock.
    fn sleep_until(&self, time: SteadyTime);
}

/// The computer's clock.
#[derive(Debug, Clone, Copy, Default)]
pub struct SystemTime;

impl TimeSource for SystemTime {
    fn now(&self) -> SteadyTime {
        SteadyTime::now()
    }

    fn sleep_until(&self, time: SteadyTime) {
        system::sleep_until(time.ns);
    }
}

/// A clock for tests: a sleep sets it to the end of the sleep, and [`ManualTime::advance`] lets time pass. Clones are
/// the same clock.
#[derive(Debug, Clone, Default)]
pub struct ManualTime(Arc<AtomicU64>);

impl ManualTime {
    /// Lets time pass.
    pub fn advance(&self, by: Duration) {
        self.0.fetch_add(u64::try_from(by.as_nanos()).unwrap_or(u64::MAX), Ordering::Relaxed);
    }
}

impl TimeSource for ManualTime {
    fn now(&self) -> SteadyTime {
        SteadyTime { ns: self.0.load(Ordering::Relaxed) }
    }

    fn sleep_until(&self, time: SteadyTime) {
        self.0.fetch_max(time.ns, Ordering::Relaxed);
    }
}

#[cfg(target_os = "linux")]
mod system {
    use rustix::thread::{ClockId as SleepClock, clock_nanosleep_absolute};
    use rustix::time::{ClockId, Timespec, clock_gettime};

    pub(super) fn now_ns() -> u64 {
        let now = clock_gettime(ClockId::Boottime);
        now.tv_sec as u64 * 1_000_000_000 + now.tv_nsec as u64
    }

    pub(super) fn sleep_until(ns: u64) {
        let until = Timespec { tv_sec: (ns / 1_000_000_000) as i64, tv_nsec: (ns % 1_000_000_000) as i64 };
        // A signal ends the sleep early: go on sleeping.
        while clock_nanosleep_absolute(SleepClock::Boottime, &until).is_err() && now_ns() < ns {}
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
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

    #[test]
    fn a_sleep_ends_at_its_time() {
        let begin = SystemTime.now();
        SystemTime.sleep_until(begin.later_by(3_000_000));
        assert!(begin.elapsed_s() >= 3e-3);
        let manual = ManualTime::default();
        manual.sleep_until(manual.now().later_by(7));
        manual.advance(Duration::from_nanos(5));
        assert_eq!(manual.now().ns_since(SteadyTime::default()), 12);
        assert_eq!(SteadyTime::default().since(manual.now()), Duration::ZERO);
    }
}
