use super::ModbusError;
use super::batches::{Batch, batches};
use super::coding;
use super::wire::{CellRange, Trouble, Wire, runtime};
use seamwright_machine::{ModbusDevice, Register};
use seamwright_message::Message;
use std::time::Instant;
use tokio::runtime::Runtime;

/// Reads every register of a device, outputs too, and writes nothing: inspects a device without a cell.
#[derive(Debug)]
pub struct RegisterInspector {
    device: ModbusDevice,
    wire: Option<(Runtime, Wire)>,
    batches: Vec<Batch>,
    seen: Vec<Seen>,
}

/// A register with its last reading.
#[derive(Debug)]
pub struct InspectedRegister<'a> {
    /// The register.
    pub register: &'a Register,
    /// The unscaled number; a bit is 0 or 1. `None` if it was never read.
    pub raw: Option<f64>,
    /// The value in the register's unit.
    pub value: Option<f64>,
    /// Time since it was read, s; infinite if never.
    pub age_s: f64,
    /// Reason why it was not read this time.
    pub trouble: Option<&'a Message>,
}

#[derive(Debug, Clone, Default)]
struct Seen {
    read: Option<(f64, f64, Instant)>,
    trouble: Option<Message>,
}

impl RegisterInspector {
    /// Creates an unconnected reader.
    pub fn new(device: &ModbusDevice) -> Self {
        let batches = batches(&device.registers, |_| true, true);
        let seen = vec![Seen::default(); device.registers.len()];
        Self { device: device.clone(), wire: None, batches, seen }
    }

    /// Reads everything; refusals are reported register by register.
    ///
    /// # Errors
    /// If the device cannot be reached or does not answer.
    pub fn look(&mut self) -> Result<(), ModbusError> {
        self.read().map_err(|trouble| {
            self.wire = None;
            ModbusError::Unreachable {
                device: self.device.name.clone(),
                address: self.device.address.clone(),
                why: trouble.message(),
            }
        })
    }

    fn read(&mut self) -> Result<(), Trouble> {
        let (runtime, wire) = match &mut self.wire {
            Some(wire) => wire,
            none => {
                let runtime = runtime()?;
                let wire = runtime.block_on(Wire::connect(&self.device))?;
                none.insert((runtime, wire))
            }
        };
        runtime.block_on(read(wire, &self.device, &self.batches, &mut self.seen))
    }

    /// Returns all registers with their last readings.
    pub fn rows(&self) -> impl Iterator<Item = InspectedRegister<'_>> {
        self.device.registers.iter().zip(&self.seen).map(|(register, seen)| InspectedRegister {
            register,
            raw: seen.read.map(|read| read.0),
            value: seen.read.map(|read| read.1),
            age_s: seen.read.map_or(f64::INFINITY, |read| read.2.elapsed().as_secs_f64()),
            trouble: seen.trouble.as_ref(),
        })
    }
}

/// Reads all batches; after a refusal, each register of the batch alone.
async fn read(wire: &mut Wire, device: &ModbusDevice, batches: &[Batch], seen: &mut [Seen]) -> Result<(), Trouble> {
    let mut cells = Vec::new();
    for batch in batches {
        match wire.read(batch.range, &mut cells).await {
            Ok(()) => {
                for (i, from) in &batch.registers {
                    seen[*i].take(&device.registers[*i], &cells[*from..]);
                }
            }
            // Find the refused register; it may also be a gap between registers.
            Err(Trouble::Refused { .. }) => {
                for (i, _) in &batch.registers {
                    let register = &device.registers[*i];
                    match wire.read(CellRange::of(&register.place), &mut cells).await {
                        Ok(()) => seen[*i].take(register, &cells),
                        Err(refused @ Trouble::Refused { .. }) => seen[*i].trouble = Some(refused.message()),
                        Err(gone) => return Err(gone),
                    }
                }
            }
            Err(gone) => return Err(gone),
        }
    }
    Ok(())
}

impl Seen {
    fn take(&mut self, register: &Register, cells: &[u16]) {
        let word = register.place.word;
        *self =
            Self { read: Some((coding::raw(word, cells), coding::value(word, cells), Instant::now())), trouble: None };
    }
}
