use super::wire::CellRange;
use seamwright_machine::Register;

/// Maximum number of registers in a read request (Modbus specification, functions 3 and 4).
const MAX_READ_REGISTERS: u16 = 125;
/// Maximum number of bits in a read request (functions 1 and 2).
const MAX_READ_BITS: u16 = 2000;
/// Maximum gap that a request reads across, registers: its 64 bytes are fewer than the headers of another request and
/// its answer.
const BRIDGED_REGISTERS: u16 = 32;
/// Maximum gap that a request reads across, bits.
const BRIDGED_BITS: u16 = 512;

/// A request that reads the cells of several registers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Batch {
    pub(super) range: CellRange,
    /// Indices of the registers in the list, and the offset of their cells in the answer.
    pub(super) registers: Vec<(usize, usize)>,
}

/// Returns requests that read the `wanted` ones of `registers`. If `bridged`, a request reads across gaps where that is
/// cheaper than another request. Some devices refuse requests that touch missing addresses.
pub(super) fn batches(registers: &[Register], wanted: impl Fn(&Register) -> bool, bridged: bool) -> Vec<Batch> {
    let mut order: Vec<usize> = (0..registers.len()).filter(|i| wanted(&registers[*i])).collect();
    order.sort_by_key(|i| (registers[*i].place.table, registers[*i].place.at));
    let mut batches: Vec<Batch> = Vec::new();
    for i in order {
        let place = registers[i].place;
        let (most, gap) = match (place.table.has_bits(), bridged) {
            (true, true) => (MAX_READ_BITS, BRIDGED_BITS),
            (true, false) => (MAX_READ_BITS, 0),
            (false, true) => (MAX_READ_REGISTERS, BRIDGED_REGISTERS),
            (false, false) => (MAX_READ_REGISTERS, 0),
        };
        let range = CellRange::of(&place);
        let first = u32::from(range.at);
        if let Some(batch) = batches.last_mut().filter(|b| b.range.table == range.table) {
            let (begin, batch_end) = (u32::from(batch.range.at), batch.range.end());
            let count = range.end().max(batch_end) - begin;
            if first <= batch_end + u32::from(gap) && count <= u32::from(most) {
                batch.range.count = count as u16;
                batch.registers.push((i, (first - begin) as usize));
                continue;
            }
        }
        batches.push(Batch { range, registers: vec![(i, 0)] });
    }
    batches
}

#[cfg(test)]
mod tests {
    use super::super::coding;
    use super::super::random_map::{Bank, random_registers};
    use super::*;
    use rand_pcg::Pcg64Mcg;
    use rand_pcg::rand_core::SeedableRng;

    /// Batches of random maps give the same values as single reads, read no register twice, and keep the protocol's
    /// limits.
    #[test]
    fn batches_give_what_single_reads_would() {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let (mut requests, mut singles) = (0, 0);
        for _ in 0..2000 {
            let registers = random_registers(&mut random);
            let bank = Bank::random(&mut random);
            for bridged in [false, true] {
                let mut seen = vec![0u32; registers.len()];
                let batches = batches(&registers, |_| true, bridged);
                for batch in &batches {
                    let CellRange { table, at, count } = batch.range;
                    assert!(count <= if table.has_bits() { 2000 } else { 125 });
                    assert!(batch.range.end() <= 65536);
                    let cells = bank.read(table, at, count);
                    for (i, from) in &batch.registers {
                        let place = registers[*i].place;
                        assert_eq!(place.table, table);
                        let single = bank.read(place.table, place.at, place.cells());
                        let many = &cells[*from..*from + single.len()];
                        assert_eq!(many, single);
                        assert_eq!(
                            coding::value(place.word, many).to_bits(),
                            coding::value(place.word, &single).to_bits()
                        );
                        seen[*i] += 1;
                    }
                    if !bridged {
                        let used: u16 = covered(&registers, batch);
                        assert_eq!(used, count, "cells that nobody wants");
                    }
                }
                assert!(seen.iter().all(|n| *n == 1));
                requests += batches.len();
            }
            singles += 2 * registers.len();
        }
        assert!(requests * 2 < singles, "{requests} requests instead of {singles}");
    }

    /// Cells of a batch that belong to its registers.
    fn covered(registers: &[Register], batch: &Batch) -> u16 {
        let has = |cell: u32| {
            batch.registers.iter().any(|(i, _)| {
                let place = registers[*i].place;
                (u32::from(place.at)..u32::from(place.at) + u32::from(place.cells())).contains(&cell)
            })
        };
        (u32::from(batch.range.at)..batch.range.end()).filter(|cell| has(*cell)).count() as u16
    }
}
