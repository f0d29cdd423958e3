//! Supervision: compares reports with limits and conditions in every cycle, and reacts.

use super::alarm_list::{AlarmState, Place, Raised};
use super::bus::Devices;
use super::mode::{Event, Mode};
use super::state::{Note, Port};
use super::{Alarm, Executive, ProcessState, Reaction, VALUES};
use seamwright_machine::{AxisKind, Level, MAX_AXES, Machine};

/// Maximum age of fresh inputs and of a fresh source report, s.
pub(super) const LATE_S: f64 = 0.1;
/// Maximum time for the drives to power up, s.
const POWER_S: f64 = 1.0;
/// Number of periods after which a following error counts.
const PERIODS: u32 = 3;
/// Allowed following error: 1 mm or degree at rest, plus the travel in this time, s.
const FOLLOWING_S: f64 = 0.01;

/// Minimum longest gap for a note about missed cycles, s; and minimum time between such notes, s.
const NOTED_GAP_S: f64 = 0.02;
const NOTED_EVERY_S: f64 = 10.0;

/// Reports with an age of their own, and their indices in [`Supervision::gaps_s`].
const REPORTS: usize = 3;
const DRIVES: usize = 0;
const INPUTS: usize = 1;
const SOURCE: usize = 2;

/// State of the supervision.
#[derive(Debug, Clone)]
pub(super) struct Supervision {
    /// Last start counts of drives, inputs and source; 0 before the first report.
    starts: [u32; 3],
    /// Last underrun count of the drives.
    starved: u32,
    /// Consecutive periods with an excessive following error of each axis.
    following: [u32; MAX_AXES],
    /// Time for which each process value was out of tolerance, s.
    off: [f64; VALUES],
    /// Missed cycles that the drives have not recovered, and whether these are too many.
    missed: f64,
    too_many: bool,
    /// Missed cycles since the last note, the longest gap in cycles, and the time of that note, s.
    unnoted: (u32, u32, f64),
    /// Part of each report's age due to missed cycles rather than its device, s: of [`REPORTS`].
    gaps_s: [f64; REPORTS],
    /// Time since power was requested, s.
    powered_for: f64,
    /// Allowed following error of each axis at rest, mm or rad.
    allowed: [f64; MAX_AXES],
}

impl Supervision {
    pub(super) fn new(machine: &Machine) -> Self {
        let mut allowed = [f64::INFINITY; MAX_AXES];
        for (allowed, axis) in allowed.iter_mut().zip(&machine.axes) {
            *allowed = if axis.kind == AxisKind::Linear { 1.0 } else { 1f64.to_radians() };
        }
        Self {
            starts: [0; 3],
            starved: 0,
            following: [0; MAX_AXES],
            off: [0.0; VALUES],
            missed: 0.0,
            too_many: false,
            unnoted: (0, 0, f64::NEG_INFINITY),
            gaps_s: [0.0; REPORTS],
            powered_for: 0.0,
            allowed,
        }
    }

    pub(super) fn switched_on(&mut self) {
        (self.powered_for, self.following) = (0.0, [0; MAX_AXES]);
    }
}

/// Missed cycles of this cycle, and those that the drives tolerate at once, as times, s.
#[derive(Debug, Clone, Copy)]
struct Gap {
    lost_s: f64,
    rides_out_s: f64,
}

impl Gap {
    /// Returns the part of a report's age due to missed cycles: `before`, plus this gap. Limited to the age itself,
    /// which excludes gaps before the report was read. Also limited to the longest gap or the drives' tolerance, so
    /// that many short gaps never hide a dead device.
    fn in_age(self, before: f64, age_s: f64) -> f64 {
        let longest = self.rides_out_s.max(before).max(self.lost_s);
        (before + self.lost_s).min(longest).min(age_s)
    }
}

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Evaluates the reports of a cycle.
    pub(super) fn supervise(&mut self) {
        self.judge_cycles();
        self.judge_drives();
        self.judge_following();
        self.judge_inputs();
        self.judge_source();
        self.judge_values();
        self.condition(Alarm::RecordFailing, 0, self.port.record_fails());
    }

    /// Counts and notes missed cycles; more than the drives tolerate raise an alarm.
    fn judge_cycles(&mut self) {
        let (now, period, slack) = (self.now(), self.machine.servo_period_s, self.devices.rides_out());
        let lost = self.reports.missed;
        let ages_s = [self.reports.drives.age_s, self.reports.inputs_age_s, self.reports.source.age_s];
        let Supervision { missed, too_many, unnoted, gaps_s, .. } = &mut self.supervision;
        *missed = (*missed - slack.regained).max(0.0) + f64::from(lost);
        let were_too_many = std::mem::replace(too_many, *missed > f64::from(slack.cycles));
        let gap = Gap { lost_s: f64::from(lost) * period, rides_out_s: f64::from(slack.cycles) * period };
        for (gap_s, age_s) in gaps_s.iter_mut().zip(ages_s) {
            *gap_s = gap.in_age(*gap_s, age_s);
        }
        let (cycles, longest, since) = *unnoted;
        let (cycles, longest) = (cycles.saturating_add(lost), longest.max(lost));
        let long = f64::from(longest) * period >= NOTED_GAP_S && now - since >= NOTED_EVERY_S;
        *unnoted = (cycles, longest, since);
        let too_many = *too_many;
        if long || (too_many && !were_too_many) {
            *unnoted = (0, 0, now);
            self.port.note(now, Note::Missed(cycles, 1e3 * f64::from(longest) * period));
        }
        self.condition(Alarm::Overrun, 0, too_many);
    }

    /// Returns true if a report is older than `usual_s`, not counting missed cycles.
    fn is_late(&self, report: usize, age_s: f64, usual_s: f64) -> bool {
        age_s.is_nan() || age_s > usual_s + self.supervision.gaps_s[report]
    }

    fn judge_drives(&mut self) {
        let period = self.machine.servo_period_s;
        let drives = self.reports.drives;
        let starts = [drives.starts, self.reports.inputs_starts, self.reports.source.starts];
        let known = std::mem::replace(&mut self.supervision.starts, starts);
        let restarted = [Alarm::DrivesRestarted, Alarm::InputsRestarted, Alarm::SourceRestarted];
        for (i, alarm) in restarted.into_iter().enumerate() {
            // The very first report is not a restart.
            if starts[i] != known[i] && known[i] > 0 {
                self.happened(alarm, 0);
            }
        }
        let fresh = !self.is_late(DRIVES, drives.age_s, self.devices.drives_late_s());
        let lost = fresh && drives.referenced & self.all_axes() != self.all_axes();
        if lost && self.power && !matches!(self.mode, Mode::Idle | Mode::Homing) {
            self.happened(Alarm::DrivesRestarted, 0);
        }
        self.condition(Alarm::DrivesSilent, 0, !fresh);
        for i in 0..self.machine.axes.len() {
            // A NaN or infinite position is a drive fault.
            let fault = drives.fault >> i & 1 == 1 || !drives.position[i].is_finite();
            self.condition(Alarm::DriveFault, i as u8, fault);
            self.condition(Alarm::LimitSwitch, i as u8, drives.limit_switch >> i & 1 == 1);
        }
        // Without power the drives do not follow set-points.
        if std::mem::replace(&mut self.supervision.starved, drives.starved) != drives.starved && self.power {
            self.happened(Alarm::Starved, 0);
        }
        self.supervision.powered_for = if self.power { self.supervision.powered_for + period } else { 0.0 };
        let dropped = self.power && !drives.powered && self.supervision.powered_for > POWER_S;
        if dropped {
            self.happened(Alarm::DrivePower, 0);
        }
    }

    fn judge_following(&mut self) {
        for i in 0..self.machine.axes.len() {
            let allowed = self.supervision.allowed[i] + FOLLOWING_S * self.orders.set[i].velocity.abs();
            // A NaN following error counts as too large.
            let within = self.reports.drives.following_error[i].abs() <= allowed;
            let counts = self.power && self.reports.drives.powered && !self.orders.home;
            let periods = &mut self.supervision.following[i];
            *periods = if within || !counts { 0 } else { *periods + 1 };
            if *periods == PERIODS {
                self.happened(Alarm::FollowingError, i as u8);
            }
        }
    }

    fn judge_inputs(&mut self) {
        let silent = self.is_late(INPUTS, self.reports.inputs_age_s, LATE_S);
        // Inputs are not needed without power.
        self.condition(Alarm::InputsSilent, 0, silent && self.mode.has_power());
        let inputs = self.reports.inputs;
        let burns = self.process.on() || self.doing.asked;
        let moves = self.mode.moves() || self.orders.set.iter().any(|set| set.velocity != 0.0);
        for (level, needed, reaction) in [
            (Level::Power, self.power, Reaction::PowerOff),
            (Level::Motion, moves || burns, Reaction::Stop),
            (Level::Process, burns || self.mode == Mode::Weld, Reaction::ProcessOff),
        ] {
            let unmet = self.interlocks.unmet_of(level, inputs);
            for i in 0..self.interlocks.conditions().len() as u8 {
                if self.interlocks.conditions()[usize::from(i)].level != level {
                    continue;
                }
                let is = unmet >> i & 1 == 1;
                if is && needed {
                    self.raise(Alarm::Interlock, i, reaction);
                } else if !is {
                    self.clear(Alarm::Interlock, i);
                }
            }
        }
    }

    fn judge_source(&mut self) {
        let source = self.reports.source;
        let used = self.process.on() || self.mode == Mode::Weld;
        // A source without mains is not an alarm outside of welding.
        let silent = self.is_late(SOURCE, source.age_s, LATE_S);
        self.condition(Alarm::SourceSilent, 0, silent && used);
        self.condition(Alarm::SourceFault, 0, source.fault != 0 && used);
        self.condition(Alarm::WireStuck, 0, source.stuck);
        self.condition(Alarm::ProcessStuckOn, 0, self.process.stays_on());
    }

    fn judge_values(&mut self) {
        let settings = self.machine.source;
        let period = self.machine.servo_period_s;
        let burns = self.process.state() == ProcessState::Burns && self.reports.source.age_s <= LATE_S;
        for i in 0..VALUES {
            let (asked, actual) = (self.orders.process.values[i], self.reports.source.values[i]);
            let off = burns
                && actual.is_finite()
                && asked.is_finite()
                && (actual - asked).abs() > settings.within * asked.abs().max(1e-9);
            let time = &mut self.supervision.off[i];
            let before = *time;
            *time = if off { *time + period } else { 0.0 };
            if before <= settings.within_s && *time > settings.within_s {
                self.happened(Alarm::ProcessValue, i as u8);
            }
        }
    }

    /// Raises the alarm with its catalogue reaction while `is`, else clears it.
    fn condition(&mut self, alarm: Alarm, detail: u8, is: bool) {
        if is {
            self.raise(alarm, detail, alarm.reaction());
        } else {
            self.clear(alarm, detail);
        }
    }

    pub(super) fn clear(&mut self, alarm: Alarm, detail: u8) {
        if self.alarms.clear(alarm, detail) {
            self.port.note(self.now(), Note::Cleared(alarm, detail));
        }
    }

    /// Raises a momentary alarm: it stays on the list as returned until it is acknowledged.
    pub(super) fn happened(&mut self, alarm: Alarm, detail: u8) {
        self.tell_raised(alarm, detail, alarm.reaction(), AlarmState::Returned);
        self.alarms.clear(alarm, detail);
    }

    pub(super) fn raise(&mut self, alarm: Alarm, detail: u8, reaction: Reaction) {
        self.tell_raised(alarm, detail, reaction, AlarmState::Unacknowledged);
    }

    /// Puts the alarm on the list, and notes it in its resulting state.
    fn tell_raised(&mut self, alarm: Alarm, detail: u8, reaction: Reaction, state: AlarmState) {
        let place: Place = self.doing.place;
        let now = self.now();
        if let Some(raised) = self.alarms.raise(alarm, detail, reaction, now, place) {
            self.port.note(now, Note::Alarm(Raised { state, ..raised }));
            self.react(reaction);
        }
    }

    /// Executes the reaction of an alarm.
    pub(super) fn react(&mut self, reaction: Reaction) {
        match reaction {
            Reaction::Tell => {}
            Reaction::Hold => self.hold(),
            Reaction::ProcessOff => {
                self.process.kill();
                if self.welds {
                    self.hold();
                }
            }
            Reaction::Stop => {
                self.process.kill();
                if self.mode.has_power() {
                    self.event(Event::Trip);
                }
            }
            Reaction::PowerOff => {
                self.process.kill();
                self.power = false;
                self.event(Event::Trip);
            }
        }
    }

    fn hold(&mut self) {
        // In a hold the torch may move in reverse: that stops too.
        self.halt = true;
        if matches!(self.mode, Mode::DryRun | Mode::Weld) {
            self.event(Event::Hold);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Gap;

    /// Returns the age at which a dead device counts as late, s, with a gap of `lost_s` every `every_s`.
    fn late_at(lost_s: f64, every_s: f64, rides_out_s: f64) -> f64 {
        let (mut gap_s, mut age_s) = (0.0, 0.0);
        while age_s <= super::LATE_S + gap_s {
            age_s += every_s;
            gap_s = Gap { lost_s, rides_out_s }.in_age(gap_s, age_s);
            assert!(age_s < 10.0, "never");
        }
        age_s
    }

    /// Frequent short gaps, as on a desktop, and long ones, of drives that stand still meanwhile.
    #[test]
    fn a_dead_device_is_noticed_however_often_cycles_are_missed() {
        assert!(late_at(0.005, 0.05, 0.25) <= 0.16, "{}", late_at(0.005, 0.05, 0.25));
        assert!(late_at(0.2, 0.201, 0.25) <= 0.61, "{}", late_at(0.2, 0.201, 0.25));
    }

    /// After one gap the device has its usual time; its next report ends the effect of the gap.
    #[test]
    fn a_gap_counts_until_the_next_report() {
        let gap = Gap { lost_s: 0.08, rides_out_s: 0.25 };
        let none = Gap { lost_s: 0.0, ..gap };
        let in_age = gap.in_age(0.0, 0.09);
        assert!((in_age - 0.08).abs() < 1e-12);
        assert!((none.in_age(in_age, 0.1) - 0.08).abs() < 1e-12);
        assert!((none.in_age(in_age, 0.001) - 0.001).abs() < 1e-12);
    }
}
