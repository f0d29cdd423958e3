//! Passes over whole rows: sums of rows, their means in cells, and pairs of sums above a floor.

use super::CELL;
use crate::simd::Work;
use pulp::Simd;

/// Pixels of 8 or 16 bits.
pub(super) trait Grey: Copy {
    /// Value of [`Grey::part`] for one grey value.
    const A_GREY: f32;
    /// Value for sums: eight of them fit into 16 bits.
    fn part(self) -> i16;
    /// Grey value, 0 to 255.
    fn grey(self) -> f32;
}

impl Grey for u8 {
    const A_GREY: f32 = 1.0;
    #[inline(always)]
    fn part(self) -> i16 {
        i16::from(self)
    }
    fn grey(self) -> f32 {
        f32::from(self)
    }
}

impl Grey for u16 {
    const A_GREY: f32 = 4095.0 / 255.0;
    #[inline(always)]
    fn part(self) -> i16 {
        (self >> 4) as i16
    }
    fn grey(self) -> f32 {
        f32::from(self) / 257.0
    }
}

pub(super) struct FourRows<'a, G> {
    pub(super) rows: &'a [G],
    pub(super) sums: &'a mut [i16],
}

impl<G: Grey> Work for FourRows<'_, G> {
    #[inline(always)]
    fn run(self, _: impl Simd) {
        let (r0, rest) = self.rows.split_at(self.sums.len());
        let (r1, rest) = rest.split_at(self.sums.len());
        let (r2, r3) = rest.split_at(self.sums.len());
        for ((((s, a), b), c), d) in self.sums.iter_mut().zip(r0).zip(r1).zip(r2).zip(r3) {
            *s = a.part() + b.part() + c.part() + d.part();
        }
    }
}

/// Adds the means of a row of sums to cells of `count` rows.
pub(super) struct CellMeans<'a> {
    pub(super) sums: &'a [i16],
    pub(super) count: usize,
    pub(super) cells: &'a mut [f32],
}

impl Work for CellMeans<'_> {
    #[inline(always)]
    fn run(self, _: impl Simd) {
        let (whole, rest) = self.sums.as_chunks::<CELL>();
        let part = 1.0 / (CELL * self.count) as f32;
        for (cell, sums) in self.cells.iter_mut().zip(whole) {
            let mut sum = 0;
            for s in sums {
                sum += i32::from(*s);
            }
            *cell += sum as f32 * part;
        }
        if let ([_, ..], Some(cell)) = (rest, self.cells.last_mut()) {
            *cell += rest.iter().map(|s| i32::from(*s)).sum::<i32>() as f32 / (rest.len() * self.count) as f32;
        }
    }
}

/// Sums of two rows of sums above a floor.
pub(super) struct Pairs<'a> {
    pub(super) sums: &'a [i16],
    pub(super) floor: &'a [i16],
    pub(super) pairs: &'a mut [i16],
}

impl Work for Pairs<'_> {
    #[inline(always)]
    fn run(self, _: impl Simd) {
        let (upper, lower) = self.sums.split_at(self.pairs.len());
        for (((p, u), l), f) in self.pairs.iter_mut().zip(upper).zip(lower).zip(self.floor) {
            *p = u + l - f;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::wide;
    use seamwright_testkit::Random;

    #[test]
    fn sums_means_and_pairs_are_those_of_single_pixels_at_any_width() {
        let mut numbers = Random::new(7);
        let mut random = || numbers.below(65535) as u16;
        for width in 1..200 {
            let pixels: Vec<u16> = (0..4 * width).map(|_| random()).collect();
            let mut sums = vec![0; width];
            wide(FourRows { rows: &pixels, sums: &mut sums });
            let wanted = |i: usize| (0..4).map(|r| i32::from(pixels[r * width + i] >> 4)).sum::<i32>();
            assert!(sums.iter().enumerate().all(|(i, s)| i32::from(*s) == wanted(i)), "{width}");
            // A second row of sums, and the mean of both.
            let mut cells = vec![0.0; width.div_ceil(CELL)];
            let more: Vec<i16> = (0..width).map(|_| (random() >> 2) as i16).collect();
            for sums in [&sums, &more] {
                wide(CellMeans { sums, count: 2, cells: &mut cells });
            }
            for (k, cell) in cells.iter().enumerate() {
                let within = CELL * k..(CELL * (k + 1)).min(width);
                let count = 2.0 * within.len() as f64;
                let wanted = within.map(|i| f64::from(sums[i]) + f64::from(more[i])).sum::<f64>() / count;
                assert!((f64::from(*cell) - wanted).abs() < 1e-2, "{width}, {k}: {cell} {wanted}");
            }
            let floor: Vec<i16> = (0..width).map(|_| (random() >> 3) as i16).collect();
            let [upper, lower] = [0, 1].map(|_| (0..width).map(|_| (random() >> 2) as i16).collect::<Vec<_>>());
            let mut pairs = vec![0; width];
            wide(Pairs { sums: &[upper.clone(), lower.clone()].concat(), floor: &floor, pairs: &mut pairs });
            assert!((0..width).all(|i| pairs[i] == upper[i] + lower[i] - floor[i]), "{width}");
        }
    }
}
