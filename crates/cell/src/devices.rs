//! The devices of the cell, and the program and values they serve.

use crate::prepared_task::Prepared;
use crate::task::SEED;
use seamwright_executive::{CutOff, Devices, Orders, Reports, Slack};
use seamwright_message::Message;
use seamwright_project::devices::{self, Lines};
use std::path::Path;
use std::sync::{Arc, Weak};

pub(crate) struct CellDevices {
    cell: devices::Cell,
    to: Connection,
    /// Dropped after the devices.
    _there: Arc<()>,
}

/// Machine and process values that connected devices serve.
#[derive(Debug, Clone)]
pub(crate) struct Connection {
    /// See [`crate::fingerprint`].
    fingerprint: String,
    /// Number of the machine's axes.
    pub(crate) axes: usize,
    /// Process values, by whose index real devices know them; `None`: all devices are simulated.
    values: Option<Vec<String>>,
    /// The lines to real devices.
    pub(crate) lines: Arc<Lines>,
    /// Expires once the devices are dropped.
    there: Weak<()>,
}

impl Connection {
    /// Returns true if they serve this machine's programs with these process values.
    pub(crate) fn serves(&self, fingerprint: &str, values: &[String]) -> bool {
        self.fingerprint == fingerprint && self.values.as_ref().is_none_or(|known| known == values)
    }

    pub(crate) fn serves_it(&self, prepared: &Prepared) -> bool {
        prepared.with(|work| self.serves(prepared.fingerprint(), work.values()))
    }

    /// Returns true for real devices. They must be dropped before others connect: a device may accept one connection
    /// only.
    pub(crate) fn is_real(&self) -> bool {
        self.values.is_some()
    }

    /// Returns true if the devices still exist.
    pub(crate) fn is_there(&self) -> bool {
        self.there.strong_count() > 0
    }
}

impl CellDevices {
    /// Connects the devices of the machine file of `prepared`, or simulated ones if it names none. Paths are relative
    /// to `beside`; `values` are the process values of the program to be run.
    ///
    /// # Errors
    /// In words: an invalid period, invalid drives, a device that does not answer or has no register for a value.
    pub(crate) fn new(prepared: &Prepared, beside: &Path, values: &[String]) -> Result<Self, String> {
        let machine = prepared.machine();
        devices::check_period(machine).map_err(|e| e.text())?;
        // Connecting waits for answers, which the panel's threads must not do.
        let connect = || devices::of_machine(machine, beside, values, &[], SEED).map_err(|e| e.text());
        let connected = std::thread::scope(|scope| scope.spawn(connect).join());
        let (cell, lines) = connected.map_err(|_| Message::new("server-devices-not-connected").to_string())??;
        let there = Arc::new(());
        let values = (!machine.devices.is_empty()).then(|| values.to_vec());
        let fingerprint = prepared.fingerprint().to_owned();
        let to = Connection {
            fingerprint,
            axes: machine.axes.len(),
            values,
            lines: Arc::new(lines),
            there: Arc::downgrade(&there),
        };
        Ok(Self { cell, to, _there: there })
    }

    /// Machine and process values that the devices serve.
    pub(crate) fn to(&self) -> &Connection {
        &self.to
    }
}

impl Devices for CellDevices {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        self.cell.exchange(orders, reports);
    }

    fn rides_out(&self) -> Slack {
        self.cell.rides_out()
    }

    fn drives_late_s(&self) -> f64 {
        self.cell.drives_late_s()
    }

    fn cut_offs(&self) -> Vec<Box<dyn CutOff>> {
        self.cell.cut_offs()
    }
}
