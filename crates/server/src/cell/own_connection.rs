//! Safe outputs written by the panel itself, over a connection of its own, while the cell cannot.

use seamwright_executive::devices::modbus::write_safe_outputs;
use seamwright_machine::ModbusDevice;
use seamwright_message::{Message, Unit};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

/// Maximum time of devices to answer when no cell takes the place of a dead one.
const LAST: Duration = Duration::from_secs(10);

/// A device, and why its outputs may be on.
pub(super) type Outcome = (String, Result<(), Message>);

/// Writes safe outputs in threads of its own.
pub(super) struct OwnConnection {
    tell: Sender<Outcome>,
    outcomes: Receiver<Outcome>,
    /// The devices have been written since the cell fell silent.
    is_done: bool,
    /// Names of devices that have not answered.
    waits: Vec<String>,
}

impl OwnConnection {
    pub(super) fn new() -> Self {
        let (tell, outcomes) = channel();
        Self { tell, outcomes, is_done: false, waits: Vec::new() }
    }

    /// Looks after a cell that is silent or not. Those `devices` that accept more than one connection are written once
    /// for each silence.
    pub(super) fn watch(&mut self, is_silent: bool, devices: &[ModbusDevice]) {
        if is_silent && !self.is_done {
            // A further connection may end the only one that a device accepts.
            devices.iter().filter(|device| device.connections > 1).for_each(|device| self.write(device));
        }
        self.is_done = is_silent;
    }

    fn write(&mut self, device: &ModbusDevice) {
        self.waits.push(device.name.clone());
        let (tell, device) = (self.tell.clone(), device.clone());
        // The desk may have ended.
        std::thread::spawn(move || drop(tell.send((device.name.clone(), write_safe_outputs(&device)))));
    }

    /// The next device that has answered, or has not in time.
    pub(super) fn outcome(&mut self) -> Option<Outcome> {
        let outcome = self.outcomes.try_recv().ok()?;
        self.waits.retain(|name| *name != outcome.0);
        Some(outcome)
    }

    /// Writes all `devices` of a cell that has gone and is not replaced, and waits for their answers.
    pub(super) fn write_all(&mut self, devices: &[ModbusDevice]) -> Vec<Outcome> {
        devices.iter().for_each(|device| self.write(device));
        let begin = Instant::now();
        let mut outcomes = Vec::new();
        while !self.waits.is_empty()
            && let Ok(outcome) = self.outcomes.recv_timeout(LAST.saturating_sub(begin.elapsed()))
        {
            self.waits.retain(|name| *name != outcome.0);
            outcomes.push(outcome);
        }
        let late = || Message::new("cell-modbus-no-answer").value("time", LAST.as_secs_f64(), Unit::S);
        let late = self.waits.drain(..).map(|name| (name, Err(late())));
        outcomes.extend(late);
        outcomes
    }
}
