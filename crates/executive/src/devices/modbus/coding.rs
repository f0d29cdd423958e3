use seamwright_machine::{NumberType, Scaled, Word, WordOrder};

/// Returns the unscaled number in `cells`; a bit is 0 or 1. `cells` start at the register and contain all of it.
pub(super) fn raw(word: Word, cells: &[u16]) -> f64 {
    match word {
        Word::Single => f64::from(u8::from(cells[0] != 0)),
        Word::Bit(bit) => f64::from(cells[0] >> bit & 1),
        Word::Number(number) => match number.kind {
            NumberType::U16 => f64::from(cells[0]),
            NumberType::I16 => f64::from(cells[0].cast_signed()),
            NumberType::U32 => f64::from(joined(number.order, cells)),
            NumberType::I32 => f64::from(joined(number.order, cells).cast_signed()),
            NumberType::F32 => f64::from(f32::from_bits(joined(number.order, cells))),
        },
    }
}

/// Returns the scaled value in `cells`.
pub(super) fn value(word: Word, cells: &[u16]) -> f64 {
    let raw = raw(word, cells);
    if let Word::Number(number) = word { raw * number.scale + number.offset } else { raw }
}

/// Writes the nearest value that `cells` can hold; in a register with bits only that bit changes.
pub(super) fn put(word: Word, value: f64, cells: &mut [u16]) {
    match word {
        Word::Single => cells[0] = u16::from(value > 0.5),
        Word::Bit(bit) => cells[0] = cells[0] & !(1 << bit) | u16::from(value > 0.5) << bit,
        Word::Number(number) => put_number(number, value, cells),
    }
}

fn put_number(number: Scaled, value: f64, cells: &mut [u16]) {
    let (low, high) = number.kind.range();
    let raw = ((value - number.offset) / number.scale).clamp(low, high);
    // The line above clamps to the range of the type, so that the casts are exact.
    let whole = raw.round() as i64;
    match number.kind {
        NumberType::U16 | NumberType::I16 => cells[0] = whole as u16,
        NumberType::U32 | NumberType::I32 => part(number.order, whole as u32, cells),
        NumberType::F32 => part(number.order, (raw as f32).to_bits(), cells),
    }
}

fn joined(order: WordOrder, cells: &[u16]) -> u32 {
    let (high, low) = match order {
        WordOrder::HighFirst => (cells[0], cells[1]),
        WordOrder::LowFirst => (cells[1], cells[0]),
    };
    u32::from(high) << 16 | u32::from(low)
}

fn part(order: WordOrder, bits: u32, cells: &mut [u16]) {
    let (high, low) = ((bits >> 16) as u16, bits as u16);
    (cells[0], cells[1]) = match order {
        WordOrder::HighFirst => (high, low),
        WordOrder::LowFirst => (low, high),
    };
}

#[cfg(test)]
mod tests {
    use super::super::random_map::uniform;
    use super::*;
    use rand_pcg::Pcg64Mcg;
    use rand_pcg::rand_core::{Rng as _, SeedableRng};

    const KINDS: [NumberType; 5] =
        [NumberType::U16, NumberType::I16, NumberType::U32, NumberType::I32, NumberType::F32];

    fn number(kind: NumberType, order: WordOrder, scale: f64, offset: f64) -> Word {
        Word::Number(Scaled { kind, order, scale, offset })
    }

    /// 123456.0 is 0x47F12000, as written down in IEEE 754; 100000 is 0x000186A0.
    #[test]
    fn known_patterns() {
        let read = |kind, order, cells: [u16; 2]| raw(number(kind, order, 1.0, 0.0), &cells);
        for (order, float, whole) in [
            (WordOrder::HighFirst, [0x47f1, 0x2000], [0x0001, 0x86a0]),
            (WordOrder::LowFirst, [0x2000, 0x47f1], [0x86a0, 0x0001]),
        ] {
            assert_eq!(read(NumberType::F32, order, float).to_bits(), 123_456f64.to_bits());
            assert_eq!(read(NumberType::U32, order, whole).to_bits(), 100_000f64.to_bits());
        }
        assert_eq!(read(NumberType::I16, WordOrder::HighFirst, [0xfffe, 0]).to_bits(), (-2f64).to_bits());
        assert_eq!(read(NumberType::I32, WordOrder::HighFirst, [0xffff, 0xfffd]).to_bits(), (-3f64).to_bits());
    }

    /// Values are written as they were read, in every type, word order and scale: every u16, and random 32-bit
    /// patterns.
    #[test]
    fn what_is_read_is_written_alike() {
        let mut random = Pcg64Mcg::seed_from_u64(3);
        for kind in KINDS {
            for order in [WordOrder::HighFirst, WordOrder::LowFirst] {
                for case in 0..70_000u32 {
                    let scale = 10f64.powf(6.0 * uniform(&mut random) - 3.0) * if case % 2 == 0 { 1.0 } else { -1.0 };
                    let offset = 2000.0 * (uniform(&mut random) - 0.5) * scale;
                    // Adding an offset rounds off digits of a float.
                    let offset = if kind == NumberType::F32 { 0.0 } else { offset };
                    let word = number(kind, order, scale, offset);
                    let cells = if kind.registers() == 1 {
                        [case as u16, 0]
                    } else {
                        [random.next_u32() as u16, random.next_u32() as u16]
                    };
                    if !raw(word, &cells).is_finite() {
                        continue;
                    }
                    let mut back = [0, 0];
                    put(word, value(word, &cells), &mut back);
                    // Both zeros of a float are equal.
                    let zero = raw(word, &cells).abs() <= 0.0 && raw(word, &back).abs() <= 0.0;
                    assert!(back == cells || zero, "{word:?} {cells:x?} {back:x?}");
                }
            }
        }
    }

    /// Every value comes back within half a step, or as the nearest that the register can hold.
    #[test]
    fn values_come_back_within_half_a_step() {
        let mut random = Pcg64Mcg::seed_from_u64(4);
        for kind in KINDS {
            for _ in 0..20_000 {
                let scale = 10f64.powf(4.0 * uniform(&mut random) - 3.0);
                let scaled = Scaled { kind, order: WordOrder::LowFirst, scale, offset: 100.0 * uniform(&mut random) };
                let (low, high) = scaled.range();
                let wanted = 1e5 * (uniform(&mut random) - 0.5);
                let mut cells = [0, 0];
                put(Word::Number(scaled), wanted, &mut cells);
                let nearest = wanted.clamp(low, high);
                let step = if kind == NumberType::F32 { 1.2e-7 * (nearest.abs() + 100.0) } else { 0.5 * scale };
                let off = (value(Word::Number(scaled), &cells) - nearest).abs();
                assert!(off <= step * (1.0 + 1e-6) + 1e-9, "{scaled:?} {wanted}: {off}");
            }
        }
    }

    #[test]
    fn bits_leave_their_neighbours_alone() {
        for word in 0..=u16::MAX {
            let bit = (word % 16) as u8;
            for on in [0.0, 1.0] {
                let mut cells = [word];
                put(Word::Bit(bit), on, &mut cells);
                assert_eq!(cells[0] & !(1 << bit), word & !(1 << bit));
                assert_eq!(raw(Word::Bit(bit), &cells).to_bits(), on.to_bits());
            }
        }
    }
}
