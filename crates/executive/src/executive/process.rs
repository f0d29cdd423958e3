use super::alarm::Alarm;
use super::device_interface::{LATE_S, SourceReport};
use seamwright_machine::Source;
use serde::{Deserialize, Serialize};

/// Validity of an arming, s.
const ARMED_S: f64 = 60.0;

/// State of arc or beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum ProcessState {
    /// Not requested.
    #[default]
    Off,
    /// Switched on, not burning yet.
    Strikes,
    /// Off for a moment between two attempts.
    Pauses,
    /// Burning.
    Burns,
    /// Failed or taken away: off until the request ends.
    Failed,
}

/// Controller of arc or beam between the request and the source's reports: ignition attempts, losses, failed
/// switch-off.
#[derive(Debug, Clone)]
pub(super) struct Process {
    settings: Source,
    state: ProcessState,
    tries: u8,
    /// Time in this state, s.
    since: f64,
    /// The state was entered after the last cycle: the time of that cycle does not belong to it.
    is_new: bool,
    /// Time without arc while it should burn, s.
    out_for: f64,
    /// Possibly burning: it was switched on or reported burning, and no fresh report of extinction has come since.
    lit: bool,
    /// Time for which it may burn although it is off, s.
    lit_for: f64,
    /// End of the arming, s.
    armed_until: f64,
}

impl Process {
    pub(super) fn new(settings: Source) -> Self {
        Self {
            settings,
            state: ProcessState::Off,
            tries: 0,
            since: 0.0,
            is_new: false,
            out_for: 0.0,
            lit: false,
            lit_for: 0.0,
            armed_until: f64::NEG_INFINITY,
        }
    }

    /// Allows the next start.
    pub(super) fn arm(&mut self, now: f64) {
        self.armed_until = now + ARMED_S;
    }

    pub(super) fn is_armed(&self, now: f64) -> bool {
        now < self.armed_until
    }

    pub(super) fn disarm(&mut self) {
        self.armed_until = f64::NEG_INFINITY;
    }

    pub(super) fn state(&self) -> ProcessState {
        self.state
    }

    /// Returns true while the source is to be on.
    pub(super) fn on(&self) -> bool {
        matches!(self.state, ProcessState::Strikes | ProcessState::Burns)
    }

    /// Returns true if it may still burn after its switch-off time.
    pub(super) fn stays_on(&self) -> bool {
        self.lit_for > self.settings.off_s
    }

    /// Switches it off at once, until the next request.
    pub(super) fn kill(&mut self) {
        if !matches!(self.state, ProcessState::Off | ProcessState::Failed) {
            self.go(ProcessState::Failed);
            self.is_new = true;
        }
    }

    fn go(&mut self, state: ProcessState) {
        if self.state != state {
            (self.state, self.since, self.out_for) = (state, 0.0, 0.0);
        }
    }

    /// Runs one cycle with this request and report, after a cycle of `elapsed_s`; returns an alarm on failure.
    pub(super) fn step(&mut self, asked: bool, report: &SourceReport, elapsed_s: f64) -> Option<Alarm> {
        let elapsed_s = if std::mem::take(&mut self.is_new) { 0.0 } else { elapsed_s };
        self.since += elapsed_s;
        self.judge_off(report, elapsed_s);
        if !asked {
            self.go(ProcessState::Off);
            self.tries = 0;
        }
        match self.state {
            ProcessState::Off if asked => {
                self.go(ProcessState::Strikes);
                self.tries = 1;
            }
            ProcessState::Strikes if report.burning => self.go(ProcessState::Burns),
            ProcessState::Strikes if self.since >= self.settings.strike_s => {
                if self.tries >= self.settings.tries {
                    self.go(ProcessState::Failed);
                    return Some(Alarm::NoArc);
                }
                self.go(ProcessState::Pauses);
            }
            ProcessState::Pauses if self.since >= self.settings.pause_s => {
                self.go(ProcessState::Strikes);
                self.tries += 1;
            }
            ProcessState::Burns => {
                self.out_for = if report.burning { 0.0 } else { self.out_for + elapsed_s };
                if self.out_for > self.settings.out_s {
                    self.go(ProcessState::Failed);
                    return Some(Alarm::ArcLost);
                }
            }
            ProcessState::Off | ProcessState::Failed | ProcessState::Strikes | ProcessState::Pauses => {}
        }
        None
    }

    /// Updates the burning state. If extinction is not confirmed, treat the arc as lit.
    fn judge_off(&mut self, report: &SourceReport, elapsed_s: f64) {
        let fresh = report.age_s <= LATE_S;
        self.lit = self.on() || if fresh { report.burning } else { self.lit };
        self.lit_for = if self.lit && !self.on() { self.lit_for + elapsed_s } else { 0.0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SETTINGS: Source =
        Source { strike_s: 0.1, tries: 3, pause_s: 0.05, out_s: 0.01, off_s: 0.2, within: 0.1, within_s: 1.0 };
    const PERIOD: f64 = 1e-3;

    fn report(burning: bool) -> SourceReport {
        SourceReport { burning, ready: true, ..SourceReport::default() }
    }

    #[test]
    fn it_is_tried_and_given_up() {
        let mut process = Process::new(SETTINGS);
        let (mut on, mut tries, mut was) = (0, 0, false);
        let alarm = (0..1000).find_map(|k| {
            let alarm = process.step(true, &report(false), PERIOD);
            on += u32::from(process.on());
            tries += u32::from(process.on() && !was);
            was = process.on();
            alarm.map(|a| (k, a))
        });
        let (k, alarm) = alarm.unwrap();
        assert_eq!((alarm, tries), (Alarm::NoArc, 3));
        assert!((f64::from(on) * PERIOD - 0.3).abs() < 5e-3 && (f64::from(k) * PERIOD - 0.4).abs() < 6e-3);
        // It stays off until the request ends.
        assert!(!process.on() && process.step(true, &report(false), PERIOD).is_none() && !process.on());
        process.step(false, &report(false), PERIOD);
        process.step(true, &report(false), PERIOD);
        assert!(process.on());
    }

    #[test]
    fn short_gaps_are_ridden_out_and_long_ones_are_not() {
        for (gap, lost) in [(5, false), (9, false), (12, true), (50, true)] {
            let mut process = Process::new(SETTINGS);
            process.step(true, &report(false), PERIOD);
            process.step(true, &report(true), PERIOD);
            assert_eq!(process.state(), ProcessState::Burns);
            let alarms: Vec<Alarm> = (0..gap).filter_map(|_| process.step(true, &report(false), PERIOD)).collect();
            assert_eq!(alarms, if lost { vec![Alarm::ArcLost] } else { vec![] });
            assert_eq!(process.on(), !lost);
        }
    }

    #[test]
    fn what_does_not_go_out_is_told() {
        let mut process = Process::new(SETTINGS);
        process.step(true, &report(true), PERIOD);
        process.step(true, &report(true), PERIOD);
        process.kill();
        assert!(!process.on());
        // Reported burning, or no fresh report: both may burn.
        for age_s in [0.0, 1.0] {
            let mut process = process.clone();
            let told = SourceReport { age_s, ..report(true) };
            let stays = (0..1000).find(|_| {
                process.step(true, &told, PERIOD);
                process.stays_on()
            });
            assert!((195..=205).contains(&stays.unwrap()), "{stays:?}");
            process.step(true, &report(false), PERIOD);
            assert!(!process.stays_on());
        }
    }

    /// Time without cycles counts: ignition, and the time to go out. The time before a kill does not count as off.
    #[test]
    fn gaps_count_as_time() {
        let mut process = Process::new(SETTINGS);
        process.step(true, &report(false), PERIOD);
        assert_eq!(process.step(true, &report(false), 0.2), None);
        assert_eq!(process.state(), ProcessState::Pauses, "it strikes for longer than `strike_s`");

        let mut process = Process::new(SETTINGS);
        process.step(true, &report(true), PERIOD);
        process.step(true, &report(true), PERIOD);
        process.step(true, &report(true), 2.0);
        process.kill();
        // The gap of two seconds ends with the order to switch off.
        process.step(true, &report(true), 2.0);
        assert!(!process.on() && !process.stays_on());
        process.step(true, &report(true), 0.15);
        assert!(!process.stays_on());
        process.step(true, &report(true), 0.15);
        assert!(process.stays_on());
    }
}
