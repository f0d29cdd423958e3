//! Supervision of the cycle by a thread of its own: deadlock, endless loop, paging.

use super::clock::{SteadyTime, SystemTime, TimeSource as _};
use super::{RealtimeRights, Shutdown, ShutdownCause};
use crate::executive::CutOff;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

/// Minimum limit of the supervisor, s: shorter gaps occur on ordinary computers.
const MIN_LIMIT_S: f64 = 0.05;
/// Minimum limit of the supervisor, periods.
const MIN_LIMIT_PERIODS: f64 = 5.0;
/// Looks of the supervisor per limit.
const LOOKS: u32 = 5;
/// Time for the thread of a device to confirm its safe outputs; then the supervisor writes them itself.
const CONFIRMED: Duration = Duration::from_millis(50);
/// A cycle that stands still for so long ends the cell.
const ENDS: Duration = Duration::from_secs(1);

/// State that the cycle and its supervisor share without locks.
#[derive(Debug, Default)]
struct Shared {
    /// Number of cycles so far.
    cycles: AtomicU64,
    /// The supervisor took the process off, and the cycle has not learnt it yet.
    cut_off: AtomicBool,
    ended: AtomicBool,
}

/// A thread that takes the process off when the cycle stops; dropping it ends the supervision.
#[derive(Debug)]
pub(super) struct CycleSupervisor {
    shared: Arc<Shared>,
}

impl CycleSupervisor {
    /// Starts the thread. A cycle of `period_s` may miss `tolerated_s`, a longer gap makes the devices write their safe
    /// outputs by `cut_offs`. A cycle that does not come back requests `shutdown`. The supervision starts with the
    /// first cycle.
    pub(super) fn start(period_s: f64, tolerated_s: f64, cut_offs: Vec<Box<dyn CutOff>>, shutdown: &Shutdown) -> Self {
        let shared = Arc::new(Shared::default());
        let thread = Thread {
            shared: Arc::clone(&shared),
            watch: StallWatch::new(limit(period_s, tolerated_s), SteadyTime::now()),
            cut_offs,
            shutdown: shutdown.clone(),
        };
        // Without the thread the devices' own watchdogs remain: the cell works as it did before.
        let started = std::thread::Builder::new().name("cycle supervisor".into()).spawn(move || thread.run());
        debug_assert!(started.is_ok());
        Self { shared }
    }

    /// Counts a cycle; returns true if the process was taken off since the last one.
    pub(super) fn count_cycle(&self) -> bool {
        self.shared.cycles.fetch_add(1, Ordering::Release);
        self.shared.cut_off.swap(false, Ordering::AcqRel)
    }
}

impl Drop for CycleSupervisor {
    /// Does not wait for the thread: it may be writing to a slow device.
    fn drop(&mut self) {
        self.shared.ended.store(true, Ordering::Release);
    }
}

/// Returns the maximum time without a cycle. It is never shorter than a gap that the cell tolerates.
fn limit(period_s: f64, tolerated_s: f64) -> Duration {
    Duration::from_secs_f64((tolerated_s + period_s).max(MIN_LIMIT_S).max(MIN_LIMIT_PERIODS * period_s))
}

struct Thread {
    shared: Arc<Shared>,
    watch: StallWatch,
    cut_offs: Vec<Box<dyn CutOff>>,
    shutdown: Shutdown,
}

impl Thread {
    fn run(mut self) {
        RealtimeRights::ask_above_cycle();
        while !self.shared.ended.load(Ordering::Acquire) {
            SystemTime.sleep_until(SystemTime.now().later_by(self.watch.interval_ns()));
            match self.watch.look(SystemTime.now(), self.shared.cycles.load(Ordering::Acquire)) {
                Verdict::Runs | Verdict::Waits => {}
                Verdict::CutOff => {
                    self.cut_off();
                    // The time for slow devices is no freeze of the process.
                    self.watch.looked = SystemTime.now();
                }
                Verdict::Ends => self.shutdown.request(ShutdownCause::CycleStopped),
            }
        }
    }

    /// Takes the process off at all devices: by their own threads, and if these do not succeed, by a new connection.
    fn cut_off(&self) {
        self.shared.cut_off.store(true, Ordering::Release);
        self.cut_offs.iter().for_each(|device| device.order());
        SystemTime.sleep_until(SystemTime.now().later_by(CONFIRMED.as_nanos() as u64));
        for device in &self.cut_offs {
            // A cycle that came back has taken over.
            let stands = self.shared.cut_off.load(Ordering::Acquire) && !self.shared.ended.load(Ordering::Acquire);
            if stands && !device.is_confirmed() {
                // If that fails, the device's own watchdog remains, and its thread goes on trying.
                device.write();
            }
        }
    }
}

/// Judgement of the supervisor after a look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Verdict {
    /// Cycles come.
    Runs,
    /// No cycle has come since the last look.
    Waits,
    /// The cycle has stopped: take the process off. Once for each stop.
    CutOff,
    /// The cycle does not come back: end the cell. Once for each stop.
    Ends,
}

/// Judges by the count of cycles whether the cycle has stopped.
#[derive(Debug)]
struct StallWatch {
    limit: Duration,
    cycles: u64,
    /// Time at which the last cycle was seen, and of the last look.
    since: SteadyTime,
    looked: SteadyTime,
    /// Part of the time since then in which the supervisor itself did not run: the whole process was frozen.
    frozen: Duration,
    said: Verdict,
}

impl StallWatch {
    fn new(limit: Duration, now: SteadyTime) -> Self {
        Self { limit, cycles: 0, since: now, looked: now, frozen: Duration::ZERO, said: Verdict::Runs }
    }

    fn interval_ns(&self) -> u64 {
        (self.limit / LOOKS).as_nanos() as u64
    }

    /// Judges the count `cycles` at the time `now`. Before the first cycle nothing is supervised.
    fn look(&mut self, now: SteadyTime, cycles: u64) -> Verdict {
        let own_gap = now.since(self.looked);
        self.looked = now;
        if cycles != self.cycles || cycles == 0 {
            (self.cycles, self.since, self.frozen, self.said) = (cycles, now, Duration::ZERO, Verdict::Runs);
            return Verdict::Runs;
        }
        if own_gap > self.limit {
            self.frozen += own_gap;
        }
        let stands = now.since(self.since);
        let verdict = match self.said {
            Verdict::Runs if stands > self.limit => Verdict::CutOff,
            // After a freeze of the whole process the cycle has its time to come back: it stops the cell by itself.
            Verdict::CutOff if stands.saturating_sub(self.frozen) > ENDS => Verdict::Ends,
            _ => return Verdict::Waits,
        };
        self.said = verdict;
        verdict
    }
}

#[cfg(test)]
mod tests {
    use super::super::clock::ManualTime;
    use super::*;
    use seamwright_testkit::Random;

    const LIMIT: Duration = Duration::from_millis(50);
    const LOOK: Duration = Duration::from_millis(10);

    #[test]
    fn the_limit_exceeds_every_tolerated_gap() {
        assert_eq!(limit(1e-3, 0.0), Duration::from_millis(50));
        assert_eq!(limit(4e-3, 0.009), Duration::from_millis(50));
        assert_eq!(limit(20e-3, 0.0), Duration::from_millis(100));
        assert_eq!(limit(1e-3, 0.25), Duration::from_millis(251));
    }

    /// Looks every 10 ms while `cycles` come; returns the times of the verdicts other than waiting.
    fn verdicts(time: &ManualTime, looks: u32, cycles: impl Fn(u32) -> u64) -> Vec<(u32, Verdict)> {
        let mut watch = StallWatch::new(LIMIT, time.now());
        let mut found = Vec::new();
        for k in 0..looks {
            time.advance(LOOK);
            let verdict = watch.look(time.now(), cycles(k));
            if matches!(verdict, Verdict::CutOff | Verdict::Ends) {
                found.push((k, verdict));
            }
        }
        found
    }

    #[test]
    fn a_stopped_cycle_is_cut_off_once_and_ended_once() {
        let found = verdicts(&ManualTime::default(), 500, |k| u64::from(k.min(100)));
        assert_eq!(found, [(106, Verdict::CutOff), (201, Verdict::Ends)]);
        // A cycle that comes late time and again is cut off each time, and never ended.
        let found = verdicts(&ManualTime::default(), 500, |k| 1 + u64::from(k / 20));
        assert_eq!(found.len(), 25);
        assert!(found.iter().all(|(_, verdict)| *verdict == Verdict::CutOff));
        // Nothing is expected before the first cycle.
        assert!(verdicts(&ManualTime::default(), 500, |_| 0).is_empty());
    }

    /// Stops of the whole process, of the supervisor too: process off at once, but the cell goes on.
    #[test]
    fn a_frozen_process_is_cut_off_and_not_ended() {
        for frozen in [Duration::from_millis(300), Duration::from_secs(2), Duration::from_secs(3600)] {
            let time = ManualTime::default();
            let mut watch = StallWatch::new(LIMIT, time.now());
            assert_eq!(watch.look(time.now(), 1), Verdict::Runs);
            time.advance(frozen);
            assert_eq!(watch.look(time.now(), 1), Verdict::CutOff);
            for _ in 0..50 {
                time.advance(LOOK);
                assert_eq!(watch.look(time.now(), 1), Verdict::Waits);
            }
            time.advance(LOOK);
            assert_eq!(watch.look(time.now(), 2), Verdict::Runs);
        }
    }

    /// Random cycles and looks: cut off if and only if the count stood still for longer than the limit between looks.
    #[test]
    fn random_gaps_are_judged_by_their_length() {
        let mut random = Random::new(11);
        let time = ManualTime::default();
        let mut watch = StallWatch::new(LIMIT, time.now());
        let (mut cycles, mut changed, mut cut) = (1, time.now(), false);
        watch.look(time.now(), cycles);
        for _ in 0..20_000 {
            time.advance(Duration::from_millis(1 + random.below(25) as u64));
            let now = time.now();
            if random.one_in(4) {
                (cycles, changed, cut) = (cycles + 1, now, false);
            }
            let expected = cycles != watch.cycles || now.since(changed) <= LIMIT || cut;
            let verdict = watch.look(now, cycles);
            assert_eq!(verdict != Verdict::CutOff, expected, "{verdict:?}");
            cut |= verdict == Verdict::CutOff;
        }
    }
}
