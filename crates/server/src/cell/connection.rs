//! The devices of the cell, and what they are connected for.

use super::prepared::{Prepared, SEED};
use seamwright_cell::executive::{Devices, Orders, Reports, Slack};
use seamwright_project::devices::{self, Lines};
use std::path::Path;
use std::sync::{Arc, Weak};

/// Devices, for the cycle.
pub(crate) struct CellDevices {
    cell: devices::Cell,
    to: Connection,
    /// Goes after them.
    _there: Arc<()>,
}

/// What devices are connected for.
#[derive(Debug, Clone)]
pub(crate) struct Connection {
    /// See [`super::Prepared::fingerprint`].
    fingerprint: String,
    /// Process values, by whose places real devices know them; none: all devices are simulated.
    values: Option<Vec<String>>,
    /// The lines to real devices.
    pub(crate) lines: Arc<Lines>,
    /// Gone as soon as the devices are.
    there: Weak<()>,
}

impl Connection {
    /// They serve this machine's programs with these process values.
    pub(crate) fn serves(&self, fingerprint: &str, values: &[String]) -> bool {
        self.fingerprint == fingerprint && self.values.as_ref().is_none_or(|known| known == values)
    }

    /// They serve what is prepared.
    pub(crate) fn serves_it(&self, prepared: &Prepared) -> bool {
        prepared.with(|work| self.serves(prepared.fingerprint(), work.values()))
    }

    /// They must be gone before others come: a device may take one connection only.
    pub(crate) fn is_real(&self) -> bool {
        self.values.is_some()
    }

    /// The devices are still somewhere.
    pub(crate) fn is_there(&self) -> bool {
        self.there.strong_count() > 0
    }
}

impl CellDevices {
    /// Connects those that the machine file of what is `prepared` names, with files as seen from `beside`; `values` are the process
    /// values of what is to be run. Simulated ones if it names none.
    ///
    /// # Errors
    /// In words: a period at which no cell runs, drives that are none, a device that does not answer or has no register for a value.
    pub(crate) fn new(prepared: &Prepared, beside: &Path, values: &[String]) -> Result<Self, String> {
        let machine = prepared.machine();
        devices::check_period(machine).map_err(|e| e.text())?;
        // Connecting waits for answers, which no thread of the panel's own may do.
        let connect = || devices::of_machine(machine, beside, values, &[], SEED).map_err(|e| e.text());
        let connected = std::thread::scope(|scope| scope.spawn(connect).join());
        let (cell, lines) = connected.map_err(|_| "the devices cannot be connected".to_owned())??;
        let there = Arc::new(());
        let values = (!machine.devices.is_empty()).then(|| values.to_vec());
        let fingerprint = prepared.fingerprint().to_owned();
        let to = Connection { fingerprint, values, lines: Arc::new(lines), there: Arc::downgrade(&there) };
        Ok(Self { cell, to, _there: there })
    }

    /// What they are connected for.
    pub(super) fn to(&self) -> &Connection {
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
}
