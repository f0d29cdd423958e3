//! The end that nobody at the desk has to order: by a signal, or by a fault of the program.

use super::bus::Devices;
use super::core::{Doing, End};
use super::mode::Event;
use super::state::Port;
use super::{Executive, Reaction};

/// Longest time from there to rest, s: then power goes and the brakes hold.
const REST_S: f64 = 3.0;

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Takes the process out of `doing`, brings everything to rest on its path, then takes the power away and ends.
    pub(super) fn shut_down(&mut self, doing: &mut Doing) {
        let now = self.now();
        let since = *self.shuts_down_since.get_or_insert(now);
        // Asked for in no cycle from here on, so that nothing strikes anew before the program has ended.
        doing.asked = false;
        self.process.kill();
        self.disarm();
        if self.busy || self.mode.moves() {
            if now <= since {
                self.stop();
            } else if now - since > REST_S {
                self.react(Reaction::PowerOff);
            } else if self.rests() {
                // Gas that would flow on is not waited for.
                self.power = false;
            }
            return;
        }
        self.power = false;
        self.event(Event::SwitchOff);
        self.end = Some(End::Quit);
    }

    /// Process off, stop on the path, program given up.
    pub(super) fn stop(&mut self) {
        self.process.kill();
        self.halt = true;
        self.event(Event::Abort);
    }
}
