//! Noise of the depths in a strip.

use super::levels::DarkLine;
use super::strip::{COLS, Columns, GROUP, Strip};

/// Distance of groups without a common row, rows.
const APART: usize = 2 * GROUP + 1;
/// Approximate number of rows sampled from a long strip.
const NOISE_ROWS: usize = 100;
/// Minimum depth of a clear joint, in standard deviations of the noise.
const CLEAR: f32 = 10.0;
/// Maximum range of a straight path, columns.
const STRAIGHT: usize = 1;
/// Minimum noise of a depth, grey values of 255.
const MIN_NOISE: f32 = 0.3;

impl Strip {
    /// Measures the noise of all depths.
    pub(super) fn noise_everywhere(&mut self) -> f32 {
        let Columns { first, last } = self.columns;
        self.measure_noise(|_| [([first; 2], last + 1 - first)])
    }

    /// Measures the noise away from the path of a joint.
    pub(super) fn noise_beside(&mut self, path: &[usize], joint: DarkLine) -> f32 {
        let Columns { first, last } = self.columns;
        let away = joint.width as usize + 2;
        let noise = self.measure_noise(|i| {
            let near = &path[i..(i + APART + 1).min(path.len())];
            // 16-bit numbers, so that several are compared at a time.
            let columns = near.iter().map(|j| *j as i16);
            let (low, high) = columns.fold((COLS as i16, 0), |(low, high), j| (low.min(j), high.max(j)));
            let left = (low as usize + 1).saturating_sub(first + away);
            let right = (last + 1).saturating_sub(high as usize + away);
            let (from, behind) = (low as usize + 1, high as usize + away);
            [[from.saturating_sub(away + left); 2], [behind; 2]].into_iter().zip([left, right])
        });
        let straight = path.iter().max().zip(path.iter().min()).is_none_or(|(most, least)| most - least <= STRAIGHT);
        if straight || joint.contrast > CLEAR * noise {
            return noise;
        }
        // Changes that follow the joint's bend are not noise.
        let moved = self.measure_noise(|i| {
            let (a, b) = (path[i], path[i + APART]);
            let left = (a.min(b) + 1).saturating_sub(first + away);
            let right = (last + 1).saturating_sub(a.max(b) + away);
            [[a, b].map(|j| (j + 1).saturating_sub(away + left)), [a + away, b + away]].into_iter().zip([left, right])
        });
        if joint.contrast > CLEAR * moved { moved } else { noise }
    }

    /// Measures noise as the difference between groups without a common row, where the joint continues. `within` gives
    /// the first columns of both rows and the number of columns to compare.
    fn measure_noise<W: IntoIterator<Item = ([usize; 2], usize)>>(&mut self, within: impl Fn(usize) -> W) -> f32 {
        let step = (self.depth.len() / NOISE_ROWS).max(2);
        // The buffer has room for the longest strip and is not emptied; only its first part is valid.
        let mut told = 0;
        let most = self.depth.len().saturating_sub(APART).div_ceil(step) * COLS / 2;
        if self.magnitudes.len() < most {
            self.magnitudes.resize(most, 0.0);
        }
        for (i, (a, b)) in self.depth.iter().zip(self.depth.iter().skip(APART)).enumerate().step_by(step) {
            // Every other column is used, also across the gap between ranges.
            let mut skipped = 0;
            for ([from_a, from_b], count) in within(i).into_iter().filter(|(_, count)| *count > 0) {
                let less = skipped.min(count);
                skipped = (count - less) % 2;
                let (a, b) = (&a[from_a + less..from_a + count], &b[from_b + less..from_b + count]);
                let magnitudes = &mut self.magnitudes[told..];
                for (magnitude, (a, b)) in magnitudes.iter_mut().zip(a.iter().step_by(2).zip(b.iter().step_by(2))) {
                    *magnitude = (a - b).abs();
                }
                told += a.len().div_ceil(2);
            }
        }
        self.deviation(told).unwrap_or(self.noise).max(MIN_NOISE)
    }

    /// Returns the standard deviation from the collected differences, by a low quantile: the joint may slant, or a
    /// shadow's edge.
    fn deviation(&mut self, told: usize) -> Option<f32> {
        let place = told * 3 / 10;
        if place == 0 {
            return None;
        }
        // Non-negative numbers are ordered like their bits.
        let (_, quantile, _) =
            self.magnitudes[..told].select_nth_unstable_by_key(place, |magnitude| magnitude.to_bits());
        Some(*quantile / (0.385 * std::f32::consts::SQRT_2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::strip::{Line, MID, SIDE, box_columns};
    use seamwright_testkit::Random;

    const ROWS: usize = 480;

    /// A strip along a joint of this width in noise of this deviation, wavy by `bent` pixels, and the joint's path.
    fn along(width: f32, deviation: f32, bent: f32) -> (Strip, Vec<usize>) {
        let mut random = Random::new(7);
        let middle = |i: usize| MID as f32 + bent * (i as f32 / 40.0).sin();
        let dark = |off: f32| 60.0 * (-4.0 * std::f32::consts::LN_2 * (off / width).powi(2)).exp();
        let mut row = |i| Line::from_fn(|j| 150.0 - dark(j as f32 - middle(i)) + deviation * random.normal() as f32);
        let mut strip = Strip { grey: (0..ROWS).map(&mut row).collect(), ..Strip::default() };
        strip.measure(width, f32::INFINITY);
        (strip, (0..ROWS).map(|i| middle(i).round() as usize).collect())
    }

    /// Expected noise, for any width: the deviation of the difference between the means of a box on the joint and one
    /// beside it.
    #[test]
    fn the_noise_of_depths_is_told() {
        for (width, deviation) in [(1.0, 4.0), (3.0, 2.0), (5.0, 4.0), (6.8, 8.0)] {
            let (mut strip, path) = along(width, deviation, 0.0);
            let told = strip.noise_beside(&path, DarkLine { width, contrast: 50.0 });
            let boxes = 1.0 / SIDE as f32 + 1.0 / box_columns(width) as f32;
            let noise = deviation * (boxes / (2 * GROUP + 1) as f32).sqrt();
            assert!((0.6..1.5).contains(&(told / noise)), "{width}: {told}, {noise}");
        }
    }

    /// Bends of a clear joint are not counted as noise; without a clear joint all differences are.
    #[test]
    fn what_moves_along_with_a_clear_joint_is_no_noise() {
        for width in [5.0, 6.8] {
            let (mut strip, path) = along(width, 1.0, 5.0);
            let all = strip.noise_beside(&path, DarkLine { width, contrast: 0.0 });
            let clear = strip.noise_beside(&path, DarkLine { width, contrast: 0.95 * CLEAR * all });
            assert!(clear < 0.9 * all, "{width}: {clear}, {all}");
        }
    }
}
