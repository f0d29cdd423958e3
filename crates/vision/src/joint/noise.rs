//! The noise of depths in a strip.

use super::strip::{COLS, GROUP, Strip};
use std::ops::Range;

/// Groups this many rows apart share none.
const APART: usize = 2 * GROUP + 1;
/// About so many rows tell the noise of a long strip.
const NOISE_ROWS: usize = 100;
/// Least noise of a depth, grey values of 255.
const LEAST_NOISE: f32 = 0.3;

impl Strip {
    /// The noise of all depths.
    pub(super) fn noise_everywhere(&mut self) -> f32 {
        let (first, last) = self.columns;
        self.measure_noise(|_| [first..last + 1, 0..0])
    }

    /// The noise, without what is near a path.
    pub(super) fn noise_beside(&mut self, path: &[usize], width: f32) -> f32 {
        let (first, last) = self.columns;
        let away = width as usize + 2;
        self.measure_noise(|i| {
            let near = &path[i..(i + APART + 1).min(path.len())];
            // In numbers that are small, several at a time.
            let columns = near.iter().map(|j| *j as i16);
            let (low, high) = columns.fold((COLS as i16, 0), |(low, high), j| (low.min(j), high.max(j)));
            let (low, high) = (low as usize, high as usize);
            [first..(low + 1).saturating_sub(away).max(first), (high + away).min(last + 1)..last + 1]
        })
    }

    /// What differs between groups that share no row is noise, the joint goes on; a low quantile, as it may slant. In the
    /// columns of each row that `within` tells.
    fn measure_noise(&mut self, within: impl Fn(usize) -> [Range<usize>; 2]) -> f32 {
        let step = (self.depth.len() / NOISE_ROWS).max(2);
        self.magnitudes.clear();
        for (i, (a, b)) in self.depth.iter().zip(self.depth.iter().skip(APART)).enumerate().step_by(step) {
            // Every other column, over the gap between the two ranges too.
            let mut skipped = 0;
            for Range { start, end } in within(i) {
                let start = (start + skipped).min(end);
                skipped = (end - start) % 2;
                let ((a, last_a), (b, last_b)) = (a[start..end].as_chunks::<2>(), b[start..end].as_chunks::<2>());
                self.magnitudes.extend(a.iter().zip(b).map(|(a, b)| (a[0] - b[0]).abs()));
                self.magnitudes.extend(last_a.iter().zip(last_b).map(|(a, b)| (a - b).abs()));
            }
        }
        self.deviation().unwrap_or(self.noise).max(LEAST_NOISE)
    }

    /// Standard deviation of what differs so much, by a low quantile: the joint may slant, or a shadow's edge.
    fn deviation(&mut self) -> Option<f32> {
        let place = self.magnitudes.len() * 3 / 10;
        if place == 0 {
            return None;
        }
        // Numbers of no sign are in the order of their bits.
        let (_, quantile, _) = self.magnitudes.select_nth_unstable_by_key(place, |magnitude| magnitude.to_bits());
        Some(*quantile / (0.385 * std::f32::consts::SQRT_2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::strip::{MID, SIDE, box_columns};
    use crate::joint::testing::random;

    /// Along a joint of any width in even noise: the deviation of the mean of a box on the joint less that of one beside it.
    #[test]
    fn the_noise_of_depths_is_told() {
        const ROWS: usize = 480;
        let mut even = random();
        let mut random = || (0..12).map(|_| even() - 0.5).sum::<f32>();
        for (width, deviation) in [(1.0, 4.0), (3.0, 2.0), (5.0, 4.0), (6.8, 8.0)] {
            let dark = |off: f32| 30.0 * (-4.0 * std::f32::consts::LN_2 * (off / width).powi(2)).exp();
            let mut row = |_| std::array::from_fn(|j| 150.0 - dark(j as f32 - MID as f32) + deviation * random());
            let mut strip = Strip { grey: (0..ROWS).map(&mut row).collect(), ..Strip::default() };
            strip.measure(width, f32::INFINITY);
            let told = strip.noise_beside(&[MID; ROWS], width);
            let boxes = 1.0 / SIDE as f32 + 1.0 / box_columns(width) as f32;
            let noise = deviation * (boxes / (2 * GROUP + 1) as f32).sqrt();
            assert!((0.6..1.5).contains(&(told / noise)), "{width}: {told}, {noise}");
        }
    }
}
