//! Supervision: history of the reports, and its limits.

use super::device_interface::{Reports, Slack, VALUES};
use super::interlocks::Interlocks;
use super::port::Note;
use seamwright_machine::{AxisKind, MAX_AXES, Machine};

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
pub(super) const DRIVES: usize = 0;
pub(super) const INPUTS: usize = 1;
pub(super) const SOURCE: usize = 2;

#[derive(Debug, Clone)]
pub(super) struct Supervision {
    pub(super) interlocks: Interlocks,
    period_s: f64,
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
    pub(super) too_many: bool,
    /// A cycle was late, and the cell has not been reset since.
    pub(super) late: bool,
    /// Length of the last gap in the cycle, s.
    pub(super) gap_s: f64,
    /// Duration of the last cycle with the missed ones before it, s.
    elapsed_s: f64,
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
            interlocks: Interlocks::new(&machine.interlocks),
            period_s: machine.servo_period_s,
            starts: [0; 3],
            starved: 0,
            following: [0; MAX_AXES],
            off: [0.0; VALUES],
            missed: 0.0,
            too_many: false,
            late: false,
            gap_s: 0.0,
            elapsed_s: machine.servo_period_s,
            unnoted: (0, 0, f64::NEG_INFINITY),
            gaps_s: [0.0; REPORTS],
            powered_for: 0.0,
            allowed,
        }
    }

    pub(super) fn switched_on(&mut self) {
        (self.powered_for, self.following) = (0.0, [0; MAX_AXES]);
    }

    /// Counts missed cycles; returns the note that is due.
    pub(super) fn count_missed(&mut self, now: f64, reports: &Reports, slack: Slack) -> Option<Note> {
        let (period, lost) = (self.period_s, reports.missed);
        self.missed = (self.missed - slack.regained).max(0.0) + f64::from(lost);
        let are_too_many = reports.late || self.missed > f64::from(slack.cycles);
        self.late |= are_too_many;
        let were_too_many = std::mem::replace(&mut self.too_many, are_too_many);
        self.elapsed_s = f64::from(lost).mul_add(period, period);
        if lost > 0 {
            self.gap_s = f64::from(lost) * period;
        }
        let gap = Gap { lost_s: f64::from(lost) * period, rides_out_s: f64::from(slack.cycles) * period };
        let ages_s = [reports.drives.age_s, reports.inputs_age_s, reports.source.age_s];
        for (gap_s, age_s) in self.gaps_s.iter_mut().zip(ages_s) {
            *gap_s = gap.in_age(*gap_s, age_s);
        }
        let (cycles, longest, since) = self.unnoted;
        let (cycles, longest) = (cycles.saturating_add(lost), longest.max(lost));
        let long = f64::from(longest) * period >= NOTED_GAP_S && now - since >= NOTED_EVERY_S;
        let due = long || (self.too_many && !were_too_many);
        self.unnoted = if due { (0, 0, now) } else { (cycles, longest, since) };
        due.then(|| Note::Missed(cycles, 1e3 * f64::from(longest) * period))
    }

    /// Returns true if a report is older than `usual_s`, not counting missed cycles.
    pub(super) fn is_late(&self, report: usize, age_s: f64, usual_s: f64) -> bool {
        age_s.is_nan() || age_s > usual_s + self.gaps_s[report]
    }

    /// Returns which of drives, inputs and source have restarted.
    pub(super) fn restarted(&mut self, reports: &Reports) -> [bool; 3] {
        let starts = [reports.drives.starts, reports.inputs_starts, reports.source.starts];
        let known = std::mem::replace(&mut self.starts, starts);
        // The very first report is not a restart.
        std::array::from_fn(|i| starts[i] != known[i] && known[i] > 0)
    }

    /// Returns true if the count of underruns has changed.
    pub(super) fn starves(&mut self, starved: u32) -> bool {
        std::mem::replace(&mut self.starved, starved) != starved
    }

    /// Returns true if the drives have had enough time, but do not report power.
    pub(super) fn lacks_power(&mut self, power: bool, powered: bool) -> bool {
        self.powered_for = if power { self.powered_for + self.elapsed_s } else { 0.0 };
        power && !powered && self.powered_for > POWER_S
    }

    /// Returns true in the period in which the following error of axis `i` becomes a fault.
    pub(super) fn strays(&mut self, i: usize, error: f64, speed: f64, counts: bool) -> bool {
        // A NaN following error counts as too large.
        let within = error.abs() <= self.allowed[i] + FOLLOWING_S * speed.abs();
        let periods = &mut self.following[i];
        *periods = if within || !counts { 0 } else { *periods + 1 };
        *periods == PERIODS
    }

    /// Returns true in the period in which process value `i` has been out of tolerance for `within_s`.
    pub(super) fn deviates(&mut self, i: usize, off: bool, within_s: f64) -> bool {
        let before = self.off[i];
        // The first report of a deviation says nothing about a gap before it.
        let passed_s = if before > 0.0 { self.elapsed_s } else { self.period_s };
        self.off[i] = if off { before + passed_s } else { 0.0 };
        before <= within_s && self.off[i] > within_s
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

#[cfg(test)]
mod tests {
    use super::Gap;
    use crate::executive::device_interface::LATE_S;

    /// Returns the age at which a dead device counts as late, s, with a gap of `lost_s` every `every_s`.
    fn late_at(lost_s: f64, every_s: f64, rides_out_s: f64) -> f64 {
        let (mut gap_s, mut age_s) = (0.0, 0.0);
        while age_s <= LATE_S + gap_s {
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
