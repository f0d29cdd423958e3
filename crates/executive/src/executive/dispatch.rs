//! Choice of the activity by the mode.

use super::activity::Doing;
use super::core::Executive;
use super::device_interface::Devices;
use super::mode::{Event, Mode};
use super::port::Port;
use super::requests::End;
use super::work::Work;

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Runs cycles until [`Ask::Quit`](super::Ask::Quit) or [`Ask::Load`](super::Ask::Load). `work` contains the
    /// program of dry runs and welds, and the surroundings for jogging: without it both are refused.
    pub fn serve(&mut self, work: Option<&Work<'_>>) -> End {
        self.requests.end = None;
        while self.requests.end.is_none() {
            match (self.mode, work) {
                (Mode::Homing, _) => self.home(work),
                (Mode::Jog | Mode::Teach, _) => self.jog_on(work),
                (Mode::DryRun | Mode::Weld, Some(work)) => self.run(work),
                _ => {
                    // A tripped cell is at rest here.
                    self.io.power &= self.mode.has_power();
                    self.rest();
                    self.tick(Doing::default(), work);
                    if self.mode == Mode::Idle && self.io.reports.drives.powered && self.io.unreferenced() == 0 {
                        self.event(Event::Homed);
                    }
                }
            }
        }
        if self.requests.end == Some(End::Load) {
            return End::Load;
        }
        // Switches all outputs off on exit.
        self.process.kill();
        self.io.switch_off();
        End::Quit
    }
}
