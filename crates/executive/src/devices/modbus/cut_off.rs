//! Safe outputs without the cycle: for its supervisor, and for other processes.

use super::image::Image;
use super::link::Life;
use super::wire::{Trouble, Wire, runtime};
use crate::executive::CutOff;
use seamwright_machine::ModbusDevice;
use seamwright_message::Message;
use std::sync::Arc;

/// Takes the process off at a device without the cycle.
#[derive(Debug)]
pub(super) struct ModbusCutOff {
    pub(super) device: ModbusDevice,
    pub(super) life: Arc<Life>,
}

impl CutOff for ModbusCutOff {
    fn order(&self) {
        self.life.cut_off();
    }

    fn is_confirmed(&self) -> bool {
        self.life.is_safe()
    }

    fn write(&self) -> bool {
        // Another connection may end the only one that a device accepts, and with it the orders in transit.
        self.device.connections > 1 && write_safe_outputs(&self.device).is_ok()
    }
}

/// Writes the safe states of all outputs of `device`, arc or beam first, over a connection of its own, and waits for
/// the answers: up to 1 s for the connection, and the time-out of the device for each of a few requests. Watchdog
/// outputs with a register or coil of their own stay as they are.
///
/// # Errors
/// The device is not reached, or refuses an output; the other outputs are written all the same.
pub fn write_safe_outputs(device: &ModbusDevice) -> Result<(), Message> {
    let runs = Image::new(&device.registers, &[]).safe_changes();
    let runtime = runtime().map_err(|trouble| trouble.message())?;
    runtime.block_on(async {
        let mut wire = Wire::connect(device).await.map_err(|trouble| trouble.message())?;
        let mut refused = None;
        for run in runs {
            match wire.write(run.table, run.at, &run.cells).await {
                Ok(()) => {}
                Err(trouble @ Trouble::Refused { .. }) => refused = refused.or(Some(trouble.message())),
                Err(trouble) => return Err(trouble.message()),
            }
        }
        refused.map_or(Ok(()), Err)
    })
}
