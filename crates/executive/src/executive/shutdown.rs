//! Shutdown without an operator's command: by a signal, or by a fault of the program.

use super::activity::Doing;
use super::alarm::Reaction;
use super::clock::REST_S;
use super::core::Executive;
use super::device_interface::Devices;
use super::mode::Event;
use super::port::Port;
use super::requests::End;

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Switches the process off in `doing`, stops everything on its path, then switches the power off and ends.
    pub(super) fn shut_down(&mut self, doing: &mut Doing) {
        let elapsed_s = self.shutdown.elapsed(self.now());
        // From here on no cycle requests the process, so that it cannot ignite again before the program ends.
        doing.asked = false;
        self.process.kill();
        self.process.disarm();
        if self.activity.busy || self.mode.moves() {
            if elapsed_s <= 0.0 {
                self.stop();
            } else if elapsed_s > REST_S {
                self.react(Reaction::PowerOff);
            } else if self.io.orders.rests() {
                // Do not wait for the gas post-flow.
                self.io.power = false;
            }
            return;
        }
        self.io.power = false;
        self.event(Event::SwitchOff);
        self.requests.end = Some(End::Quit);
    }
}
