//! What is wrong, and what follows from it: reports against limits and conditions, every cycle.

use super::alarm_list::{AlarmState, Place, Raised};
use super::bus::Devices;
use super::mode::{Event, Mode};
use super::state::{Note, Port};
use super::{Alarm, Executive, ProcessState, Reaction, VALUES};
use seamwright_machine::{AxisKind, Level, MAX_AXES, Machine};

/// Age of inputs and source that is still fresh, s.
pub(super) const LATE_S: f64 = 0.1;
/// Time that the drives have to come up, s.
const POWER_S: f64 = 1.0;
/// A following error counts from so many periods on.
const PERIODS: u32 = 3;
/// Allowed following error: 1 mm or degree at rest, and what a speed makes in this time, s.
const FOLLOWING_S: f64 = 0.01;

/// Missed cycles are noted if the longest time without one is at least this, s; together, no more often than this, s.
const NOTED_GAP_S: f64 = 0.02;
const NOTED_EVERY_S: f64 = 10.0;

/// Reports with an age of their own, and their places among [`Supervision::gaps_s`].
const REPORTS: usize = 3;
const DRIVES: usize = 0;
const INPUTS: usize = 1;
const SOURCE: usize = 2;

/// What supervision remembers from cycle to cycle.
#[derive(Debug, Clone)]
pub(super) struct Supervision {
    /// Starts of drives, inputs and source that are known; 0 before the first report.
    starts: [u32; 3],
    /// Times that the drives ran out of set-points that are known.
    starved: u32,
    /// Periods for which each axis' following error was too great.
    following: [u32; MAX_AXES],
    /// Time for which each process value was off, s.
    off: [f64; VALUES],
    /// Cycles missed that the drives have not made up for, and whether these are too many.
    missed: f64,
    too_many: bool,
    /// Cycles missed since they were noted last, the most of them at once, and when that was, s.
    unnoted: (u32, u32, f64),
    /// Time without cycles that the age of each report contains, without a fault of its device, s: of [`REPORTS`].
    gaps_s: [f64; REPORTS],
    /// Time since power was asked for, s.
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

/// Missed cycles of this cycle, and those that the drives ride out at once, as times, s.
#[derive(Debug, Clone, Copy)]
struct Gap {
    lost_s: f64,
    rides_out_s: f64,
}

impl Gap {
    /// Time without cycles that a report's age contains: `before`, and this gap. Never more than the age itself, so none of before the
    /// report was read; never more than the longest gap, or those that the drives ride out: many short gaps do not add up to
    /// time in which a dead device goes unnoticed.
    fn in_age(self, before: f64, age_s: f64) -> f64 {
        let longest = self.rides_out_s.max(before).max(self.lost_s);
        (before + self.lost_s).min(longest).min(age_s)
    }
}

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Judges the reports of a cycle.
    pub(super) fn supervise(&mut self) {
        self.judge_cycles();
        self.judge_drives();
        self.judge_following();
        self.judge_inputs();
        self.judge_source();
        self.judge_values();
        self.condition(Alarm::RecordFailing, 0, self.port.record_fails());
    }

    /// Counts and notes missed cycles; more than the drives ride out are an alarm.
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

    /// True if a report is older than `usual_s`, without the time in which there was no cycle to take a newer one.
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
            // The first report of all is no restart.
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
            // A position that is no number is none.
            let fault = drives.fault >> i & 1 == 1 || !drives.position[i].is_finite();
            self.condition(Alarm::DriveFault, i as u8, fault);
            self.condition(Alarm::LimitSwitch, i as u8, drives.limit_switch >> i & 1 == 1);
        }
        // Without power they have nothing to do with set-points.
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
            // No number is no position.
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
        // Nobody needs them while nothing has power.
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
        // A source that is switched off at the wall is no alarm while nobody welds.
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

    /// An alarm that is there while `is`, with the reaction of the catalogue.
    fn condition(&mut self, alarm: Alarm, detail: u8, is: bool) {
        if is {
            self.raise(alarm, detail, alarm.entry().reaction);
        } else {
            self.clear(alarm, detail);
        }
    }

    pub(super) fn clear(&mut self, alarm: Alarm, detail: u8) {
        if self.alarms.clear(alarm, detail) {
            self.port.note(self.now(), Note::Cleared(alarm, detail));
        }
    }

    /// Something that happens at an instant: it is on the list, as what has gone, until it is acknowledged.
    pub(super) fn happened(&mut self, alarm: Alarm, detail: u8) {
        self.tell_raised(alarm, detail, alarm.entry().reaction, AlarmState::Returned);
        self.alarms.clear(alarm, detail);
    }

    pub(super) fn raise(&mut self, alarm: Alarm, detail: u8, reaction: Reaction) {
        self.tell_raised(alarm, detail, reaction, AlarmState::Unacknowledged);
    }

    /// Puts it on the list, and tells it in the state that it then is in.
    fn tell_raised(&mut self, alarm: Alarm, detail: u8, reaction: Reaction, state: AlarmState) {
        let place: Place = self.doing.place;
        let now = self.now();
        if let Some(raised) = self.alarms.raise(alarm, detail, reaction, (now, place)) {
            self.port.note(now, Note::Alarm(Raised { state, ..raised }));
            self.react(reaction);
        }
    }

    /// Does what an alarm asks for.
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
        // What is held may go back: then it stands still too.
        self.halt = true;
        if matches!(self.mode, Mode::DryRun | Mode::Weld) {
            self.event(Event::Hold);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Gap;

    /// Feeds a gap of `lost_s` each `every_s` to the age of a device that dies; the age at which it counts as late, s.
    fn late_at(lost_s: f64, every_s: f64, rides_out_s: f64) -> f64 {
        let (mut gap_s, mut age_s) = (0.0, 0.0);
        while age_s <= super::LATE_S + gap_s {
            age_s += every_s;
            gap_s = Gap { lost_s, rides_out_s }.in_age(gap_s, age_s);
            assert!(age_s < 10.0, "never");
        }
        age_s
    }

    /// Short gaps, as often as a desktop has them, and long ones, of drives that stand still meanwhile.
    #[test]
    fn a_dead_device_is_noticed_however_often_cycles_are_missed() {
        assert!(late_at(0.005, 0.05, 0.25) <= 0.16, "{}", late_at(0.005, 0.05, 0.25));
        assert!(late_at(0.2, 0.201, 0.25) <= 0.61, "{}", late_at(0.2, 0.201, 0.25));
    }

    /// One gap, and the device has the usual time from there; once it was heard of, the gap is over.
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
