//! Checks of the reports of a cycle: the alarms that they raise or clear.

use super::alarm::{Alarm, Reaction};
use super::core::Executive;
use super::device_interface::{Devices, LATE_S, VALUES};
use super::mode::Mode;
use super::port::Port;
use super::process::ProcessState;
use super::supervision::{DRIVES, INPUTS, SOURCE};
use seamwright_machine::Level;

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

    /// Notes missed cycles; more than the drives tolerate raise an alarm.
    fn judge_cycles(&mut self) {
        let now = self.now();
        let slack = self.io.devices.rides_out();
        if let Some(note) = self.supervision.count_missed(now, &self.io.reports, slack) {
            self.port.note(now, note);
        }
        self.condition(Alarm::Overrun, 0, self.supervision.too_many);
    }

    /// Returns true after too many missed cycles until the cell is reset: their alarm is acknowledged, and the cell has
    /// left its fault.
    pub(super) fn was_late(&mut self) -> bool {
        let listed = self.alarms.iter().any(|raised| raised.alarm == Alarm::Overrun);
        self.supervision.late &= listed || self.mode == Mode::Fault;
        self.supervision.late
    }

    fn judge_drives(&mut self) {
        let drives = self.io.reports.drives;
        let alarms = [Alarm::DrivesRestarted, Alarm::InputsRestarted, Alarm::SourceRestarted];
        let restarted = self.supervision.restarted(&self.io.reports);
        for (alarm, _) in alarms.into_iter().zip(restarted).filter(|(_, restarted)| *restarted) {
            self.happened(alarm, 0);
        }
        let fresh = !self.supervision.is_late(DRIVES, drives.age_s, self.io.devices.drives_late_s());
        let lost = fresh && self.io.unreferenced() != 0;
        if lost && self.io.power && !matches!(self.mode, Mode::Idle | Mode::Homing) {
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
        if self.supervision.starves(drives.starved) && self.io.power {
            self.happened(Alarm::Starved, 0);
        }
        if self.supervision.lacks_power(self.io.power, drives.powered) {
            self.happened(Alarm::DrivePower, 0);
        }
    }

    fn judge_following(&mut self) {
        for i in 0..self.machine.axes.len() {
            let counts = self.io.is_powered() && !self.io.orders.home;
            let (error, set) = (self.io.reports.drives.following_error[i], self.io.orders.set[i]);
            if self.supervision.strays(i, error, set.velocity, counts) {
                self.happened(Alarm::FollowingError, i as u8);
            }
        }
    }

    fn judge_inputs(&mut self) {
        let silent = self.supervision.is_late(INPUTS, self.io.reports.inputs_age_s, LATE_S);
        // Inputs are not needed without power.
        self.condition(Alarm::InputsSilent, 0, silent && self.mode.has_power());
        let inputs = self.io.reports.inputs;
        let burns = self.process.on() || self.activity.doing.asked;
        let moves = self.mode.moves() || self.io.orders.set.iter().any(|set| set.velocity != 0.0);
        for (level, needed, reaction) in [
            (Level::Power, self.io.power, Reaction::PowerOff),
            (Level::Motion, moves || burns, Reaction::Stop),
            (Level::Process, burns || self.mode == Mode::Weld, Reaction::ProcessOff),
        ] {
            let unmet = self.supervision.interlocks.unmet_of(level, inputs);
            for i in 0..self.supervision.interlocks.conditions().len() as u8 {
                if self.supervision.interlocks.conditions()[usize::from(i)].level != level {
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
        let source = self.io.reports.source;
        let used = self.process.on() || self.mode == Mode::Weld;
        // A source without mains is not an alarm outside of welding.
        self.condition(Alarm::SourceSilent, 0, self.supervision.is_late(SOURCE, source.age_s, LATE_S) && used);
        self.condition(Alarm::SourceFault, 0, source.fault != 0 && used);
        self.condition(Alarm::WireStuck, 0, source.stuck);
        self.condition(Alarm::ProcessStuckOn, 0, self.process.stays_on());
    }

    fn judge_values(&mut self) {
        let settings = self.machine.source;
        let burns = self.process.state() == ProcessState::Burns && self.io.reports.source.age_s <= LATE_S;
        for i in 0..VALUES {
            let (asked, actual) = (self.io.orders.process.values[i], self.io.reports.source.values[i]);
            let off = burns
                && actual.is_finite()
                && asked.is_finite()
                && (actual - asked).abs() > settings.within * asked.abs().max(1e-9);
            if self.supervision.deviates(i, off, settings.within_s) {
                self.happened(Alarm::ProcessValue, i as u8);
            }
        }
    }
}
