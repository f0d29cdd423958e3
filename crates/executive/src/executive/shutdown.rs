//! Shutdown without an operator's command: by a signal, or by a fault of the program.

use super::bus::Devices;
use super::core::{Doing, End};
use super::mode::Event;
use super::state::Port;
use super::{Executive, Reaction};

/// Maximum time until the axes are at rest, s: then the power is switched off and the brakes hold.
pub(super) const REST_S: f64 = 3.0;

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Switches the process off in `doing`, stops everything on its path, then switches the power off and ends.
    pub(super) fn shut_down(&mut self, doing: &mut Doing) {
        let now = self.now();
        let since = *self.shuts_down_since.get_or_insert(now);
        // From here on no cycle requests the process, so that it cannot ignite again before the program ends.
        doing.asked = false;
        self.process.kill();
        self.disarm();
        if self.busy || self.mode.moves() {
            if now <= since {
                self.stop();
            } else if now - since > REST_S {
                self.react(Reaction::PowerOff);
            } else if self.rests() {
                // Do not wait for the gas post-flow.
                self.power = false;
            }
            return;
        }
        self.power = false;
        self.event(Event::SwitchOff);
        self.end = Some(End::Quit);
    }

    /// Switches the process off, stops on the path and aborts the program.
    pub(super) fn stop(&mut self) {
        self.process.kill();
        self.halt = true;
        self.event(Event::Abort);
    }
}
