//! Release of devices, and the confirmation of their safe outputs.

use crate::devices::{CellDevices, Connection};
use seamwright_message::Message;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::JoinHandle;

/// Name of a released device, and why its outputs may be on.
pub(crate) type Released = (String, Result<(), Message>);

/// Releases devices in threads of their own: they have some seconds to answer.
pub(crate) struct SafeOutputs {
    to: Sender<Released>,
    from: Receiver<Released>,
    waiting: Vec<JoinHandle<()>>,
}

impl SafeOutputs {
    pub(crate) fn new() -> Self {
        let (to, from) = channel();
        Self { to, from, waiting: Vec::new() }
    }

    /// Drops `devices`.
    pub(crate) fn release(&mut self, devices: CellDevices) {
        let to = self.to.clone();
        self.waiting.retain(|thread| !thread.is_finished());
        self.waiting.push(std::thread::spawn(move || {
            let connection = devices.to().clone();
            drop(devices);
            // The receiver lives as long as the link.
            released(&connection).for_each(|device| drop(to.send(device)));
        }));
    }

    /// Devices that have been released since the last call.
    pub(crate) fn come(&self) -> impl Iterator<Item = Released> + '_ {
        self.from.try_iter()
    }

    /// Waits for all.
    pub(crate) fn wait(&mut self) {
        self.waiting.drain(..).for_each(|thread| drop(thread.join()));
    }
}

/// Outcome for each real device of `connection`, which has been dropped.
pub(crate) fn released(connection: &Connection) -> impl Iterator<Item = Released> + '_ {
    connection.lines.iter().map(|(name, line)| {
        let safe = line.get().safe.unwrap_or_else(|| Err(Message::new("cell-safe-not-asked")));
        (name.clone(), safe)
    })
}
