//! The cycle.

use super::activity::Doing;
use super::core::Executive;
use super::device_interface::{Devices, ProcessOrders, SeamOrders};
use super::port::{Cycle, Port, Status};
use super::work::Work;

/// Maximum number of commands taken in a cycle.
const COMMANDS: usize = 8;

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Runs one cycle: orders out, reports in, supervision, commands, display.
    pub(super) fn tick(&mut self, mut doing: Doing, work: Option<&Work<'_>>) {
        if self.port.shuts_down() {
            self.shut_down(&mut doing);
        }
        self.activity.doing = doing;
        self.exchange(&doing);
        self.supervise();
        self.take_commands(work);
        self.show(&doing);
    }

    /// Sends the orders, waits for the start of the cycle, and reads the reports.
    fn exchange(&mut self, doing: &Doing) {
        let alarm = self.process.step(doing.asked, &self.io.reports.source, self.clock.last_s());
        let process = ProcessOrders { gas: doing.gas, on: self.process.on(), values: doing.values };
        let late = self.was_late();
        self.io.exchange(process, SeamOrders { t_s: self.now(), ..doing.seam }, late);
        self.clock.advance(self.io.reports.missed);
        if let Some(alarm) = alarm {
            self.happened(alarm, 0);
        }
    }

    fn take_commands(&mut self, work: Option<&Work<'_>>) {
        self.requests.jog = None;
        for _ in 0..COMMANDS {
            if self.shutdown.runs() {
                break;
            }
            let Some(command) = self.port.command(self.now()) else { break };
            self.take(command, work);
        }
    }

    fn show(&mut self, doing: &Doing) {
        let status = Status {
            t: self.now(),
            mode: self.mode,
            place: doing.place,
            phase: doing.phase,
            speed: doing.speed,
            steady: doing.steady,
            welded_mm: doing.welded_mm,
            process: self.process.state(),
            armed: self.process.is_armed(self.now()),
            feed_override: self.requests.feed_override,
            tracked: self.guide.tracked(),
        };
        self.port.show(&Cycle { status, orders: &self.io.orders, reports: &self.io.reports, alarms: &self.alarms });
    }
}
