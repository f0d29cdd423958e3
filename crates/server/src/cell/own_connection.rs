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

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::{Machine, shipped};

    /// Devices at a closed port, with one and with two connections.
    fn devices() -> Vec<ModbusDevice> {
        let device = "\n[devices.source.modbus]\naddress = \"127.0.0.1:1\"\nconnections = 2\n\
            [devices.source.modbus.inputs]\ne_stop_ok = { discrete = 0 }\ncurtain_clear = { discrete = 1 }\n\
            gas_ok = { discrete = 2 }\n[devices.source.modbus.outputs]\non = { coil = 0 }\ngas = { coil = 1 }\n\
            [devices.source.modbus.reports]\nburning = { discrete = 4 }\n";
        let text = format!("{}{device}", shipped("ellipse-xy").unwrap().text);
        let own = Machine::read("cell.toml", &text).unwrap().devices.modbus[0].clone();
        vec![ModbusDevice { name: "other".to_owned(), connections: 1, ..own.clone() }, own]
    }

    fn names(outcomes: Vec<Outcome>) -> Vec<String> {
        let mut names: Vec<String> = outcomes
            .into_iter()
            .map(|(name, outcome)| {
                assert!(outcome.is_err());
                name
            })
            .collect();
        names.sort();
        names
    }

    /// A silence is answered once, by devices that accept a further connection; without a cell every device is written,
    /// and named if it is not reached.
    #[test]
    fn each_silence_is_answered_once_and_no_device_is_forgotten() {
        let (mut own, devices) = (OwnConnection::new(), devices());
        for _ in 0..2 {
            own.watch(false, &devices);
            (0..5).for_each(|_| own.watch(true, &devices));
            let begin = Instant::now();
            let outcome = std::iter::from_fn(|| Some(own.outcome())).find(|o| o.is_some() || begin.elapsed() > LAST);
            assert_eq!(names(outcome.flatten().into_iter().collect()), ["source"]);
            assert!(own.outcome().is_none() && own.waits.is_empty());
        }
        assert_eq!(names(own.write_all(&devices)), ["other", "source"]);
    }
}
