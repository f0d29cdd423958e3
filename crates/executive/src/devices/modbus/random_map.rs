//! Random register maps and contents, for tests.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng as _;
use seamwright_machine::{NumberType, Place, Register, Role, Scaled, Table, Word, WordOrder};

/// Contents of all four tables, each cell computed from its address.
pub(super) struct Bank(u64);

impl Bank {
    pub(super) fn random(random: &mut Pcg64Mcg) -> Self {
        Self(random.next_u64())
    }

    pub(super) fn read(&self, table: Table, at: u16, count: u16) -> Vec<u16> {
        let cell = |k: u16| {
            let address = u64::from(at) + u64::from(k);
            assert!(address < 65536, "beyond the table");
            let mixed = (self.0 ^ (address << 2 | table as u64)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            let mixed = (mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 40;
            if table.has_bits() { (mixed & 1) as u16 } else { mixed as u16 }
        };
        (0..count).map(cell).collect()
    }
}

/// Returns up to 120 registers in clusters without overlap, sometimes at the end of a table.
pub(super) fn random_registers(random: &mut Pcg64Mcg) -> Vec<Register> {
    let below = |random: &mut Pcg64Mcg, n: u32| random.next_u32() % n;
    let mut registers = Vec::new();
    for table in [Table::Coil, Table::Discrete, Table::Holding, Table::Input] {
        let mut next = below(random, 70_000).min(65_500);
        for _ in 0..below(random, 30) {
            next += match below(random, 4) {
                0 | 1 => 0,
                2 => below(random, 40),
                _ => below(random, 1500),
            };
            let word = random_word(random, table);
            let cells = match word {
                Word::Number(number) => u32::from(number.kind.registers()),
                _ => 1,
            };
            if next + cells > 65536 {
                break;
            }
            let place = Place { table, at: next as u16, word };
            let role = Role::Actual(String::new());
            registers.push(Register { name: String::new(), role, place, safe: 0.0, unit: String::new() });
            next += cells;
        }
    }
    // Shuffle, so that the order in the file is independent of the addresses.
    for i in (1..registers.len()).rev() {
        registers.swap(i, random.next_u32() as usize % (i + 1));
    }
    registers
}

fn random_word(random: &mut Pcg64Mcg, table: Table) -> Word {
    if table.has_bits() {
        return Word::Single;
    }
    let kind = match random.next_u32() % 6 {
        0 => return Word::Bit((random.next_u32() % 16) as u8),
        1 => NumberType::U16,
        2 => NumberType::I16,
        3 => NumberType::U32,
        4 => NumberType::I32,
        _ => NumberType::F32,
    };
    let order = if uniform(random) < 0.5 { WordOrder::HighFirst } else { WordOrder::LowFirst };
    Word::Number(Scaled { kind, order, scale: 0.01 + uniform(random), offset: uniform(random) })
}

/// Returns a uniform random number in [0, 1).
pub(super) fn uniform(random: &mut Pcg64Mcg) -> f64 {
    (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}
