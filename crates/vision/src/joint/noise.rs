//! The noise of depths in a strip.

use super::strip::{COLS, GROUP, METAL, SIDE, Strip, box_columns};
use std::ops::Range;

/// Groups this many rows apart share none.
const APART: usize = 2 * GROUP + 1;
/// About so many rows tell the noise of a long strip.
const NOISE_ROWS: usize = 100;
/// Least noise of a depth, grey values of 255.
const LEAST_NOISE: f32 = 0.3;
/// Fewer differences than this tell no noise of the metal.
const FEW: usize = 24;

/// What noise is told by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum NoiseBy {
    /// Depths beside the joint, as they are looked for. Beside a wide joint there are few that are none of its own, and where it
    /// bends those are taken for noise.
    #[default]
    Depths,
    /// The metal beyond the joint too, if it is quieter.
    Metal,
}

impl Strip {
    /// The noise of all depths.
    pub(super) fn noise_everywhere(&mut self) -> f32 {
        let (first, last) = self.columns;
        self.measure_noise(|_| [first..last + 1, 0..0])
    }

    /// The noise, without what is near a path.
    pub(super) fn noise_beside(&mut self, path: &[usize], width: f32) -> f32 {
        let noise = self.noise_of_depths(path, width);
        match self.noise_by {
            NoiseBy::Depths => noise,
            NoiseBy::Metal => self.noise_of_metal(path, width).map_or(noise, |metal| noise.min(metal)),
        }
    }

    fn noise_of_depths(&mut self, path: &[usize], width: f32) -> f32 {
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

    /// The noise that a depth would have by the difference of boxes beside each other on the metal, for a joint of this width.
    fn noise_of_metal(&mut self, path: &[usize], width: f32) -> Option<f32> {
        let away = (METAL * width + 1.0) as usize;
        let last = self.grey.len().checked_sub(APART + GROUP)?;
        self.magnitudes.clear();
        for i in (GROUP..last).step_by((self.grey.len() / NOISE_ROWS).max(2)) {
            let near = &path[i - GROUP..=i + APART + GROUP];
            let (low, high) = near.iter().fold((COLS, 0), |(low, high), j| (low.min(*j), high.max(*j)));
            // What differs between two groups that share no row.
            let mut differs = [0.0; COLS];
            for (a, b) in self.grey[i - GROUP..=i + GROUP].iter().zip(&self.grey[i + APART - GROUP..]) {
                differs.iter_mut().zip(a.iter().zip(b)).for_each(|(d, (a, b))| *d += a - b);
            }
            for side in [&differs[..low.saturating_sub(away)], &differs[(high + away + 1).min(COLS)..]] {
                self.magnitudes.extend(side.windows(2 * SIDE).step_by(2).map(|boxes| {
                    let (a, b) = boxes.split_at(SIDE);
                    (a.iter().sum::<f32>() - b.iter().sum::<f32>()).abs()
                }));
            }
        }
        if self.magnitudes.len() < FEW {
            return None;
        }
        // From the difference of two sums over boxes of a side to that of such a box and one on the joint, both means.
        let (side, rows) = (SIDE as f32, APART as f32);
        let part = (0.5 * side * (1.0 / side + 1.0 / box_columns(width) as f32)).sqrt() / (side * rows);
        Some((part * self.deviation()?).max(LEAST_NOISE))
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
    use crate::joint::strip::MID;

    /// A joint that slants across a strip of even noise: what each way of telling says the noise of a depth is.
    fn told(width: f32, slant: f32, deviation: f32) -> (f32, f32, f32) {
        const ROWS: usize = 480;
        let mut state = 7u32;
        let mut random = || {
            let mut even = || {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (state >> 8) as f32 / (1 << 24) as f32 - 0.5
            };
            (0..12).map(|_| even()).sum::<f32>()
        };
        let middle = |i: usize| MID as f32 + slant * (((i % 48) as f32) - 24.0);
        let dark = |off: f32| 30.0 * (-4.0 * std::f32::consts::LN_2 * (off / width).powi(2)).exp();
        let mut strip = Strip { noise_by: NoiseBy::Metal, ..Strip::default() };
        strip.grey = (0..ROWS)
            .map(|i| std::array::from_fn(|j| 150.0 - dark(j as f32 - middle(i)) + deviation * random()))
            .collect();
        strip.measure(width, f32::INFINITY);
        let path: Vec<usize> = (0..ROWS).map(|i| middle(i).round() as usize).collect();
        let pixels = (1.0 / 3.0 + 1.0 / box_columns(width) as f32) / APART as f32;
        let depths = strip.noise_of_depths(&path, width);
        (depths, strip.noise_of_metal(&path, width).unwrap_or(f32::NAN), deviation * pixels.sqrt())
    }

    #[test]
    fn the_metal_tells_the_noise_beside_a_joint_that_bends() {
        for (width, deviation) in [(1.0, 4.0), (3.0, 2.0), (5.0, 4.0), (6.8, 8.0)] {
            for slant in [0.0, 0.2] {
                let (depths, metal, true_noise) = told(width, slant, deviation);
                assert!((metal / true_noise - 1.0).abs() < 0.25, "{width} {slant}: {metal}, {true_noise}");
                assert!(slant > 0.0 || depths < 1.5 * true_noise, "{width}: {depths}, {true_noise}");
            }
        }
        // What the metal is asked for: beside a wide joint that bends, depths tell several times the noise.
        let (depths, _, true_noise) = told(6.4, 0.2, 2.0);
        assert!(depths > 3.0 * true_noise, "{depths}, {true_noise}");
    }
}
