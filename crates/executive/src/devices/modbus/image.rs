use super::coding;
use crate::executive::ProcessOrders;
use seamwright_machine::{Place, Register, Role, Table, Word};

/// Maximum number of cells in a write request: 123 registers, 1968 bits (functions 15 and 16).
const MAX_WRITE_CELLS: [usize; 2] = [123, 1968];

/// Orders of the cycle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ordered {
    pub(super) process: ProcessOrders,
    /// Number of cycles so far with arc or beam off, so that a slower reader misses no off order.
    pub(super) offs: u64,
}

/// Required and written outputs of a device.
#[derive(Debug)]
pub(super) struct Image {
    units: Vec<Unit>,
    outputs: Vec<Output>,
    /// The watchdog's count.
    count: u16,
    /// Arc or beam is locked until this count of off orders is exceeded. Set at the start and at a loss of the cycle or
    /// of the connection.
    locked: Option<u64>,
    /// Arc or beam is ordered on.
    on: bool,
}

/// Cells of one write: one, or the two of a 32-bit number.
#[derive(Debug)]
struct Unit {
    table: Table,
    at: u16,
    cells: [u16; 2],
    len: usize,
    written: Option<[u16; 2]>,
    /// The cells that the device refused last.
    refused: Option<[u16; 2]>,
    /// Contains the arc or beam output.
    has_on: bool,
}

/// An output and the unit that contains it.
#[derive(Debug)]
struct Output {
    role: Role,
    word: Word,
    safe: f64,
    unit: usize,
    /// Index among the job's process values.
    value: Option<usize>,
}

/// A write request and its units.
#[derive(Debug, PartialEq)]
pub(super) struct Run {
    pub(super) table: Table,
    pub(super) at: u16,
    pub(super) cells: Vec<u16>,
    pub(super) units: std::ops::Range<usize>,
}

impl Image {
    /// Creates the image of the outputs among `registers`: all safe, none written; `values` are the names of the job's
    /// process values.
    pub(super) fn new(registers: &[Register], values: &[String]) -> Self {
        let mut outputs: Vec<&Register> = registers.iter().filter(|r| r.role.is_output()).collect();
        outputs.sort_by_key(|r| (r.place.table, r.place.at));
        let mut image = Self { units: Vec::new(), outputs: Vec::new(), count: 0, locked: Some(0), on: false };
        for register in outputs {
            let Place { table, at, word } = register.place;
            // Bits of the same register are written together.
            if image.units.last().is_none_or(|unit| (unit.table, unit.at) != (table, at)) {
                let len = usize::from(register.place.cells());
                image.units.push(Unit { table, at, cells: [0; 2], len, written: None, refused: None, has_on: false });
            }
            let unit = image.units.len() - 1;
            image.units[unit].has_on |= register.role == Role::On;
            let value = match &register.role {
                Role::Set(name) => values.iter().position(|v| v == name),
                _ => None,
            };
            image.outputs.push(Output { role: register.role.clone(), word, safe: register.safe, unit, value });
        }
        image.make_safe(0);
        image
    }

    /// Sets all outputs except the watchdog to their safe states. `offs` is the count of off orders so far.
    pub(super) fn make_safe(&mut self, offs: u64) {
        (self.locked, self.on) = (Some(offs), false);
        for i in 0..self.outputs.len() {
            if self.outputs[i].role != Role::Watchdog {
                self.put(i, self.outputs[i].safe);
            }
        }
    }

    /// Sets all outputs to their orders. Arc or beam stays off until one off order has come: it never comes on by
    /// itself.
    pub(super) fn order(&mut self, ordered: &Ordered) {
        let orders = &ordered.process;
        self.locked = self.locked.filter(|offs| *offs == ordered.offs);
        self.on = orders.on && self.locked.is_none();
        for i in 0..self.outputs.len() {
            let output = &self.outputs[i];
            let bit = |on: bool| if on { 1.0 } else { 0.0 };
            let value = match &output.role {
                Role::Gas => bit(orders.gas),
                Role::On => bit(self.on),
                Role::Set(_) => {
                    let asked = output.value.map_or(f64::NAN, |k| orders.values[k]);
                    if asked.is_finite() { asked } else { output.safe }
                }
                _ => continue,
            };
            self.put(i, value);
        }
    }

    /// Advances the watchdog.
    pub(super) fn beat(&mut self) {
        self.count = self.count.wrapping_add(1);
        for i in 0..self.outputs.len() {
            if self.outputs[i].role == Role::Watchdog {
                let counts = matches!(self.outputs[i].word, Word::Number(_));
                self.put(i, f64::from(if counts { self.count } else { self.count & 1 }));
            }
        }
    }

    fn put(&mut self, output: usize, value: f64) {
        let output = &self.outputs[output];
        coding::put(output.word, value, &mut self.units[output.unit].cells);
    }

    /// Marks the device's state as unknown: everything is written again, with arc or beam off.
    pub(super) fn forget(&mut self, offs: u64) {
        self.make_safe(offs);
        self.rewrite();
    }

    /// Marks everything as unwritten, because the device may have lost it; orders stay as they are.
    pub(super) fn rewrite(&mut self) {
        self.units.iter_mut().for_each(|unit| unit.written = None);
    }

    /// Returns write requests for the changes, neighbours together. The request that switches arc or beam off comes
    /// first and alone, so that a refused neighbour cannot block it. The request that switches it on comes last.
    pub(super) fn changes(&self) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for (i, unit) in self.units.iter().enumerate().filter(|(_, unit)| unit.written != Some(unit.cells)) {
            let cells = &unit.cells[..unit.len];
            let most = MAX_WRITE_CELLS[usize::from(unit.table.has_bits())];
            let apart = |unit: &Unit| unit.has_on && !self.on;
            let last = runs.last_mut().filter(|_| !apart(unit)).filter(|run| {
                if apart(&self.units[run.units.start]) {
                    return false;
                }
                let end = usize::from(run.at) + run.cells.len();
                run.table == unit.table && end == usize::from(unit.at) && run.cells.len() + unit.len <= most
            });
            if let Some(run) = last {
                run.cells.extend_from_slice(cells);
                run.units.end = i + 1;
            } else {
                runs.push(Run { table: unit.table, at: unit.at, cells: cells.to_vec(), units: i..i + 1 });
            }
        }
        let has_on = |run: &Run| self.units[run.units.clone()].iter().any(|unit| unit.has_on);
        runs.sort_by_key(|run| has_on(run) == self.on);
        runs
    }

    /// Returns the [changes](Self::changes) without units that contain only a watchdog.
    pub(super) fn safe_changes(mut self) -> Vec<Run> {
        for (i, unit) in self.units.iter_mut().enumerate() {
            let mut roles = self.outputs.iter().filter(|output| output.unit == i).map(|output| &output.role);
            if roles.all(|role| *role == Role::Watchdog) {
                unit.written = Some(unit.cells);
            }
        }
        self.changes()
    }

    /// Returns the request that switches arc or beam off, if it is pending and the device has not just refused it.
    pub(super) fn off(&self) -> Option<Run> {
        if self.on {
            return None;
        }
        let is_new = |unit: &Unit| ![unit.written, unit.refused].contains(&Some(unit.cells));
        let (i, unit) = self.units.iter().enumerate().find(|(_, unit)| unit.has_on && is_new(unit))?;
        Some(Run { table: unit.table, at: unit.at, cells: unit.cells[..unit.len].to_vec(), units: i..i + 1 })
    }

    /// Marks `run` as written.
    pub(super) fn written(&mut self, run: &Run) {
        for unit in &mut self.units[run.units.clone()] {
            (unit.written, unit.refused) = (Some(unit.cells), None);
        }
    }

    /// Marks `run` as refused.
    pub(super) fn refused(&mut self, run: &Run) {
        for unit in &mut self.units[run.units.clone()] {
            unit.refused = Some(unit.cells);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::{Machine, shipped};

    fn image() -> Image {
        let map = "[devices.io.modbus.outputs]\ngas = { coil = 0 }\non = { coil = 1 }\nwatchdog = { coil = 2 }\n\
                   [devices.io.modbus.reports]\nburning = { discrete = 4 }";
        let machine = shipped("ellipse-xy").unwrap().text;
        let text = format!("{machine}\n[devices.io.modbus]\naddress = \"127.0.0.1:1\"\n{map}");
        let device = Machine::read("m.toml", &text).unwrap_or_else(|e| panic!("{e}")).devices.modbus.remove(0);
        Image::new(&device.registers, &[])
    }

    fn ordered(on: bool, offs: u64) -> Ordered {
        let process = ProcessOrders { on, gas: on, ..ProcessOrders::default() };
        Ordered { process, offs }
    }

    /// The device may refuse gas and watchdog: off is a separate request and the first, while on joins its neighbours.
    #[test]
    fn off_is_written_apart_from_its_neighbours() {
        let mut image = image();
        image.order(&ordered(false, 1));
        image.order(&ordered(true, 1));
        let runs = image.changes();
        assert_eq!((runs.len(), runs[0].cells.len()), (1, 3), "{runs:?}");
        assert_eq!(image.off(), None);
        image.written(&runs[0]);
        image.order(&ordered(false, 2));
        image.beat();
        let runs = image.changes();
        assert_eq!((runs[0].at, runs[0].cells.as_slice()), (1, &[0][..]), "{runs:?}");
        assert_eq!(image.off().as_ref(), Some(&runs[0]));
        image.refused(&runs[0]);
        assert_eq!(image.off(), None, "what was refused waits for the next poll");
        image.written(&runs[0]);
        assert!(image.changes().iter().all(|run| run.at != 1));
    }
}
