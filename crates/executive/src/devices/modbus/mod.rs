//! Process source, inputs and outputs over Modbus TCP.
//!
//! A client in a thread of its own polls the device and writes changes, on one connection each. The cycle exchanges
//! orders and reports with it through buffers that neither lock nor allocate. Reports age while the device is silent;
//! `starts` counts its connections. When the cycle stops for longer than the watchdog's time, or the devices are
//! dropped, the outputs go to their safe states. Arc or beam comes on again only after it was ordered off.
//!
//! The cycle only swaps buffers with the client, orders in one direction and reports in the other, and counts. Silence
//! is age, a new connection is a restart, and the executive judges both as with any device. An order to switch off
//! could be missed between two polls, so these orders are counted; arc or beam waits for one after any loss.

mod batches;
mod client;
mod coding;
mod cut_off;
mod image;
mod inspector;
mod link;
mod orders;
#[cfg(test)]
mod random_map;
mod reports;
mod wire;

pub use cut_off::write_safe_outputs;
pub use inspector::{InspectedRegister, RegisterInspector};

use super::traffic::{TrafficLog, TrafficView};
use super::{InputBits, Inputs, Source};
use crate::executive::{CutOff, ProcessOrders, SourceReport, Watchdog};
use client::{Client, Ends};
use cut_off::ModbusCutOff;
use image::Ordered;
use link::Life;
use reports::Stamped;
use seamwright_machine::{ModbusDevice, Role};
use seamwright_message::{Message, display_by_message};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread::JoinHandle;
use triple_buffer::{Input, Output, triple_buffer};

/// Reasons why a device cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ModbusError {
    /// The device cannot be reached, or does not answer as its registers require.
    Unreachable {
        /// Its name in the machine file.
        device: String,
        /// Host and port.
        address: String,
        /// The reason.
        why: Message,
    },
    /// A process value of the job has no register.
    NoRegister {
        /// Its name in the machine file.
        device: String,
        /// The value's name.
        value: String,
    },
}

impl ModbusError {
    /// Returns its message.
    pub fn message(&self) -> Message {
        match self {
            Self::Unreachable { device, address, why } => Message::new("cell-modbus-unreachable")
                .text("device", device)
                .text("address", address)
                .message("why", why.clone()),
            Self::NoRegister { device, value } => {
                Message::new("cell-modbus-no-register").text("device", device).text("value", value)
            }
        }
    }
}

display_by_message!(ModbusError);

/// A connected device, as parts of a cell.
#[derive(Debug)]
pub struct ModbusParts {
    /// The process source, if the device is one.
    pub source: Option<ModbusSource>,
    /// The inputs, if it has them.
    pub inputs: Option<ModbusInputs>,
    /// Traffic on the connections.
    pub traffic: TrafficView,
}

/// A process source on Modbus.
#[derive(Debug)]
pub struct ModbusSource {
    orders: Input<Ordered>,
    offs: u64,
    known: Output<Stamped<SourceReport>>,
    toggle: bool,
    thread: Arc<ClientThread>,
}

/// Inputs on Modbus.
#[derive(Debug)]
pub struct ModbusInputs {
    known: Output<Stamped<InputBits>>,
    toggle: bool,
    thread: Arc<ClientThread>,
}

/// The client's thread; dropping the last reference ends it.
#[derive(Debug)]
struct ClientThread {
    device: ModbusDevice,
    life: Arc<Life>,
    handle: Option<JoinHandle<()>>,
}

impl ClientThread {
    /// Counts a cycle, if `toggle` shows a new one.
    fn count_cycle(&self, toggle: &mut bool, watchdog: Watchdog) {
        if std::mem::replace(toggle, watchdog.toggle) != watchdog.toggle {
            self.life.count_cycle(watchdog);
        }
    }

    fn cut_off(&self) -> Option<Box<dyn CutOff>> {
        Some(Box::new(ModbusCutOff { device: self.device.clone(), life: Arc::clone(&self.life) }))
    }
}

impl Drop for ClientThread {
    /// Waits until the outputs are safe or the device is unreachable.
    fn drop(&mut self) {
        self.life.ended.store(true, Ordering::Release);
        if let Some(handle) = self.handle.take() {
            // A panicked client has dropped its connection: the device's own watchdog remains.
            let _ = handle.join();
        }
    }
}

/// Connects `device`, brings its outputs to their safe states and reads it once. `values` are the names of the job's
/// process values in the order of [`crate::executive::Work::values`].
///
/// # Errors
/// If the device cannot be reached, refuses a register, or has no register for a value.
pub fn connect(device: &ModbusDevice, values: &[String]) -> Result<ModbusParts, ModbusError> {
    let has = |wanted: &dyn Fn(&Role) -> bool| device.registers.iter().any(|r| wanted(&r.role));
    let (is_source, has_inputs) = (has(&Role::is_source), has(&|role| matches!(role, Role::Input(_))));
    let unset = values.iter().find(|value| !has(&|role| matches!(role, Role::Set(name) if name == *value)));
    if let Some(value) = unset.filter(|_| is_source) {
        return Err(ModbusError::NoRegister { device: device.name.clone(), value: value.clone() });
    }
    let (orders_in, orders) = triple_buffer(&Ordered::default());
    let (source, source_out) = triple_buffer(&None);
    let (inputs, inputs_out) = triple_buffer(&None);
    let (log, traffic) = TrafficLog::new();
    let life = Arc::new(Life::default());
    let ends = Ends { orders, source, inputs, life: Arc::clone(&life), traffic: log };
    let unreachable =
        |why: Message| ModbusError::Unreachable { device: device.name.clone(), address: device.address.clone(), why };
    let mut client = Client::new(device, values, ends).map_err(|trouble| unreachable(trouble.message()))?;
    client.connect().map_err(|trouble| unreachable(trouble.message()))?;
    let named = std::thread::Builder::new().name(format!("modbus {}", device.name));
    let handle = named.spawn(move || client.run()).map_err(|e| unreachable(Message::outside(&e)))?;
    let thread = Arc::new(ClientThread { device: device.clone(), life, handle: Some(handle) });
    Ok(ModbusParts {
        source: is_source.then(|| ModbusSource {
            orders: orders_in,
            offs: 0,
            known: source_out,
            toggle: false,
            thread: Arc::clone(&thread),
        }),
        inputs: has_inputs.then_some(ModbusInputs { known: inputs_out, toggle: false, thread }),
        traffic,
    })
}

impl Source for ModbusSource {
    fn exchange(&mut self, orders: &ProcessOrders, watchdog: Watchdog, report: &mut SourceReport) {
        self.offs += u64::from(!orders.on);
        self.orders.write(Ordered { process: *orders, offs: self.offs });
        self.thread.count_cycle(&mut self.toggle, watchdog);
        // Ages follow the clock, so that they grow while the cycle stands still.
        if let Some((known, read)) = self.known.read() {
            *report = SourceReport { age_s: read.elapsed_s(), ..*known };
        }
    }

    fn cut_off(&self) -> Option<Box<dyn CutOff>> {
        self.thread.cut_off()
    }
}

impl Inputs for ModbusInputs {
    fn exchange(&mut self, watchdog: Watchdog, inputs: &mut InputBits) {
        self.thread.count_cycle(&mut self.toggle, watchdog);
        if let Some((known, read)) = self.known.read() {
            *inputs = InputBits { age_s: read.elapsed_s(), ..*known };
        }
    }

    fn cut_off(&self) -> Option<Box<dyn CutOff>> {
        self.thread.cut_off()
    }
}
