//! Release of devices, and confirmation of their safe outputs.

use super::connection::{CellDevices, Connection};
use super::event::happening;
use super::hub::Hub;
use seamwright_message::Message;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;

/// Releases devices and checks that they have confirmed their safe outputs.
#[derive(Clone)]
pub(super) struct SafeOutputs {
    hub: Arc<Hub>,
    shared: Arc<Mutex<Shared>>,
}

#[derive(Default)]
struct Shared {
    /// Devices without a confirmation, with the reason.
    unconfirmed: BTreeMap<String, String>,
    /// Threads that wait for devices.
    waiting: Vec<JoinHandle<()>>,
}

impl SafeOutputs {
    pub(super) fn new(hub: Arc<Hub>) -> Self {
        Self { hub, shared: Arc::default() }
    }

    /// Drops `devices` and checks them in a separate thread: they have some seconds to answer.
    pub(super) fn let_go(&self, devices: CellDevices) {
        let own = self.clone();
        let waits = std::thread::spawn(move || {
            let to = devices.to().clone();
            drop(devices);
            own.judge(&to);
        });
        let mut shared = self.shared.lock().unwrap_or_else(PoisonError::into_inner);
        shared.waiting.retain(|thread| !thread.is_finished());
        shared.waiting.push(waits);
    }

    /// Reports the dropped devices of `to` that have not confirmed their safe outputs.
    fn judge(&self, to: &Connection) {
        for (name, line) in to.lines.iter() {
            let safe = line.get().safe.unwrap_or_else(|| Err("it was not asked".into()));
            if let Err(why) = &safe {
                let message = Message::new("server-event-safe-unconfirmed").text("device", name);
                self.hub.event(0.0, happening(message.message("reason", why.clone())));
            }
            let mut shared = self.shared.lock().unwrap_or_else(PoisonError::into_inner);
            match safe {
                // A device that was reconnected and is safe now is removed.
                Ok(()) => shared.unconfirmed.remove(name),
                Err(why) => shared.unconfirmed.insert(name.clone(), why.to_string()),
            };
        }
    }

    /// Waits for all released devices and checks the last ones, of `to`, which have been dropped. Returns one line for
    /// each device without a confirmation.
    pub(super) fn end(&self, to: Option<&Connection>) -> Vec<String> {
        let waiting = std::mem::take(&mut self.shared.lock().unwrap_or_else(PoisonError::into_inner).waiting);
        waiting.into_iter().for_each(|thread| drop(thread.join()));
        to.into_iter().for_each(|to| self.judge(to));
        let shared = self.shared.lock().unwrap_or_else(PoisonError::into_inner);
        let line = |(name, why): (&String, &String)| {
            format!("device `{name}`: its outputs are not confirmed to be safe: {why}")
        };
        shared.unconfirmed.iter().map(line).collect()
    }
}
