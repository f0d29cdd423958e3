use super::Alarm;
use super::bus::SourceReport;
use super::supervision::LATE_S;
use seamwright_machine::Source;

/// What arc or beam does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ProcessState {
    /// It is not asked for.
    #[default]
    Off,
    /// It is switched on and does not burn yet.
    Strikes,
    /// Off for a moment between two tries.
    Pauses,
    /// It burns.
    Burns,
    /// It failed, or was taken away: off until it is not asked for any more.
    Failed,
}

/// Arc or beam between what is asked for and what the source reports: tries, losses, and what does not go off.
#[derive(Debug, Clone)]
pub(super) struct Process {
    settings: Source,
    period: f64,
    state: ProcessState,
    tries: u8,
    /// Time in this state, s.
    since: f64,
    /// Time without arc while it should burn, or with it while it should not, s.
    amiss: f64,
}

impl Process {
    pub(super) fn new(settings: Source, period: f64) -> Self {
        Self { settings, period, state: ProcessState::Off, tries: 0, since: 0.0, amiss: 0.0 }
    }

    pub(super) fn state(&self) -> ProcessState {
        self.state
    }

    /// True while the source is to be on.
    pub(super) fn on(&self) -> bool {
        matches!(self.state, ProcessState::Strikes | ProcessState::Burns)
    }

    /// Takes it away: off at once, until it is asked for anew.
    pub(super) fn kill(&mut self) {
        if self.state != ProcessState::Off {
            self.go(ProcessState::Failed);
        }
    }

    fn go(&mut self, state: ProcessState) {
        if self.state != state {
            (self.state, self.since, self.amiss) = (state, 0.0, 0.0);
        }
    }

    /// A cycle in which it is `asked` for, or not, and the source reports this: what went wrong.
    pub(super) fn step(&mut self, asked: bool, report: &SourceReport) -> Option<Alarm> {
        self.since += self.period;
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
                self.amiss = if report.burning { 0.0 } else { self.amiss + self.period };
                if self.amiss > self.settings.out_s {
                    self.go(ProcessState::Failed);
                    return Some(Alarm::ArcLost);
                }
            }
            ProcessState::Off | ProcessState::Failed => {
                // What an old report says is not known. It goes out in its own time.
                let stays = report.burning && report.age_s <= LATE_S;
                self.amiss = if stays { self.amiss + self.period } else { 0.0 };
                if self.amiss > self.settings.off_s {
                    return Some(Alarm::ProcessStuckOn);
                }
            }
            ProcessState::Strikes | ProcessState::Pauses => {}
        }
        None
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
        let mut process = Process::new(SETTINGS, PERIOD);
        let (mut on, mut tries, mut was) = (0, 0, false);
        let alarm = (0..1000).find_map(|k| {
            let alarm = process.step(true, &report(false));
            on += u32::from(process.on());
            tries += u32::from(process.on() && !was);
            was = process.on();
            alarm.map(|a| (k, a))
        });
        let (k, alarm) = alarm.unwrap();
        assert_eq!((alarm, tries), (Alarm::NoArc, 3));
        assert!((f64::from(on) * PERIOD - 0.3).abs() < 5e-3 && (f64::from(k) * PERIOD - 0.4).abs() < 6e-3);
        // It stays off, whatever is asked, until it is not asked for.
        assert!(!process.on() && process.step(true, &report(false)).is_none() && !process.on());
        process.step(false, &report(false));
        process.step(true, &report(false));
        assert!(process.on());
    }

    #[test]
    fn short_gaps_are_ridden_out_and_long_ones_are_not() {
        for (gap, lost) in [(5, false), (9, false), (12, true), (50, true)] {
            let mut process = Process::new(SETTINGS, PERIOD);
            process.step(true, &report(false));
            process.step(true, &report(true));
            assert_eq!(process.state(), ProcessState::Burns);
            let alarms: Vec<Alarm> = (0..gap).filter_map(|_| process.step(true, &report(false))).collect();
            assert_eq!(alarms, if lost { vec![Alarm::ArcLost] } else { vec![] });
            assert_eq!(process.on(), !lost);
        }
    }

    #[test]
    fn what_does_not_go_out_is_told() {
        let mut process = Process::new(SETTINGS, PERIOD);
        process.step(true, &report(true));
        process.step(true, &report(true));
        process.kill();
        assert!(!process.on());
        let alarm = (0..1000).find_map(|k| process.step(true, &report(true)).map(|a| (k, a)));
        let (k, alarm) = alarm.unwrap();
        assert!(alarm == Alarm::ProcessStuckOn && (195..=205).contains(&k), "{k}");
    }
}
