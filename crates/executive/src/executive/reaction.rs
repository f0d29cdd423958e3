//! Alarms, their reactions, and changes of the mode.

use super::alarm::{Alarm, Reaction};
use super::alarm_list::{AlarmState, Raised};
use super::core::Executive;
use super::device_interface::Devices;
use super::mode::{Event, Mode};
use super::port::{Note, Port};

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Enters the mode after `event`; false if the mode does not accept it.
    pub(super) fn event(&mut self, event: Event) -> bool {
        let Ok(mode) = self.mode.after(event) else { return false };
        if mode != self.mode {
            self.port.note(self.now(), Note::Mode(self.mode, mode));
            if mode != Mode::Weld {
                self.process.disarm();
            }
            self.mode = mode;
        }
        true
    }

    /// Raises the alarm with its catalogue reaction while `is`, else clears it.
    pub(super) fn condition(&mut self, alarm: Alarm, detail: u8, is: bool) {
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
        let place = self.activity.doing.place;
        let now = self.now();
        let gap_s = (alarm == Alarm::Overrun).then_some(self.supervision.gap_s);
        let new = Raised { alarm, detail, reaction, state, first_out: false, t: now, place, gap_s };
        if let Some(raised) = self.alarms.raise(new) {
            self.port.note(now, Note::Alarm(Raised { state, ..raised }));
            self.react(reaction);
        }
    }

    pub(super) fn react(&mut self, reaction: Reaction) {
        match reaction {
            Reaction::Tell => {}
            Reaction::Hold => self.hold(),
            Reaction::ProcessOff => {
                self.process.kill();
                if self.activity.welds {
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
                self.io.power = false;
                self.event(Event::Trip);
            }
        }
    }

    fn hold(&mut self) {
        // In a hold the torch may move in reverse: that stops too.
        self.requests.halt = true;
        if matches!(self.mode, Mode::DryRun | Mode::Weld) {
            self.event(Event::Hold);
        }
    }

    /// Switches the process off, stops on the path and aborts the program.
    pub(super) fn stop(&mut self) {
        self.process.kill();
        self.requests.halt = true;
        self.event(Event::Abort);
    }
}
