//! The noise of depths in a strip.

use super::strip::{COLS, GROUP, Strip};

/// Groups this many rows apart share none.
const APART: usize = 2 * GROUP + 1;
/// About so many rows tell the noise of a long strip.
const NOISE_ROWS: usize = 100;
/// A joint so many times as deep as the noise is clear.
const CLEAR: f32 = 10.0;
/// A path that goes no more columns to and fro is straight.
const STRAIGHT: usize = 1;
/// Least noise of a depth, grey values of 255.
const LEAST_NOISE: f32 = 0.3;

impl Strip {
    /// The noise of all depths.
    pub(super) fn noise_everywhere(&mut self) -> f32 {
        let (first, last) = self.columns;
        self.measure_noise(|_| [([first; 2], last + 1 - first)])
    }

    /// The noise, without what is near the path of a joint so wide and so many grey values deep.
    pub(super) fn noise_beside(&mut self, path: &[usize], (width, contrast): (f32, f32)) -> f32 {
        let (first, last) = self.columns;
        let away = width as usize + 2;
        let noise = self.measure_noise(|i| {
            let near = &path[i..(i + APART + 1).min(path.len())];
            // In numbers that are small, several at a time.
            let columns = near.iter().map(|j| *j as i16);
            let (low, high) = columns.fold((COLS as i16, 0), |(low, high), j| (low.min(j), high.max(j)));
            let left = (low as usize + 1).saturating_sub(first + away);
            let right = (last + 1).saturating_sub(high as usize + away);
            let (from, behind) = (low as usize + 1, high as usize + away);
            [[from.saturating_sub(away + left); 2], [behind; 2]].into_iter().zip([left, right])
        });
        let straight = path.iter().max().zip(path.iter().min()).is_none_or(|(most, least)| most - least <= STRAIGHT);
        if straight || contrast > CLEAR * noise {
            return noise;
        }
        // What a bend moves along with the joint is no noise.
        let moved = self.measure_noise(|i| {
            let (a, b) = (path[i], path[i + APART]);
            let left = (a.min(b) + 1).saturating_sub(first + away);
            let right = (last + 1).saturating_sub(a.max(b) + away);
            let from = [a, b].map(|j| (j + 1).saturating_sub(away + left));
            [from, [a + away, b + away]].into_iter().zip([left, right])
        });
        if contrast > CLEAR * moved { moved } else { noise }
    }

    /// What differs between groups that share no row is noise, the joint goes on; a low quantile, as it may slant. `within`: from which
    /// columns of a row and of the one that is compared with it on how many are.
    fn measure_noise<W: IntoIterator<Item = ([usize; 2], usize)>>(&mut self, within: impl Fn(usize) -> W) -> f32 {
        let step = (self.depth.len() / NOISE_ROWS).max(2);
        // No more are told than there is room for: it grows with the longest strip, and is not emptied.
        let mut told = 0;
        let most = self.depth.len().saturating_sub(APART).div_ceil(step) * COLS / 2;
        if self.magnitudes.len() < most {
            self.magnitudes.resize(most, 0.0);
        }
        for (i, (a, b)) in self.depth.iter().zip(self.depth.iter().skip(APART)).enumerate().step_by(step) {
            // Every other column, over the gap between ranges too.
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
        self.deviation(told).unwrap_or(self.noise).max(LEAST_NOISE)
    }

    /// Standard deviation of what the first `told` differ by, by a low quantile: the joint may slant, or a shadow's edge.
    fn deviation(&mut self, told: usize) -> Option<f32> {
        let place = told * 3 / 10;
        if place == 0 {
            return None;
        }
        // Numbers of no sign are in the order of their bits.
        let (_, quantile, _) =
            self.magnitudes[..told].select_nth_unstable_by_key(place, |magnitude| magnitude.to_bits());
        Some(*quantile / (0.385 * std::f32::consts::SQRT_2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::strip::{Line, MID, SIDE, box_columns};
    use crate::testing::random;

    const ROWS: usize = 480;

    /// A strip along a joint of this width in noise of this deviation, to and fro by so many pixels, and the joint's path.
    fn along(width: f32, deviation: f32, bent: f32) -> (Strip, Vec<usize>) {
        let mut even = random();
        let mut random = || (0..12).map(|_| even() - 0.5).sum::<f32>();
        let middle = |i: usize| MID as f32 + bent * (i as f32 / 40.0).sin();
        let dark = |off: f32| 60.0 * (-4.0 * std::f32::consts::LN_2 * (off / width).powi(2)).exp();
        let mut row = |i| Line::from_fn(|j| 150.0 - dark(j as f32 - middle(i)) + deviation * random());
        let mut strip = Strip { grey: (0..ROWS).map(&mut row).collect(), ..Strip::default() };
        strip.measure(width, f32::INFINITY);
        (strip, (0..ROWS).map(|i| middle(i).round() as usize).collect())
    }

    /// Along a joint of any width in even noise: the deviation of the mean of a box on the joint less that of one beside it.
    #[test]
    fn the_noise_of_depths_is_told() {
        for (width, deviation) in [(1.0, 4.0), (3.0, 2.0), (5.0, 4.0), (6.8, 8.0)] {
            let (mut strip, path) = along(width, deviation, 0.0);
            let told = strip.noise_beside(&path, (width, 50.0));
            let boxes = 1.0 / SIDE as f32 + 1.0 / box_columns(width) as f32;
            let noise = deviation * (boxes / (2 * GROUP + 1) as f32).sqrt();
            assert!((0.6..1.5).contains(&(told / noise)), "{width}: {told}, {noise}");
        }
    }

    /// Of a joint that is clear, its bends are not taken for noise; of one that is not, whatever differs is.
    #[test]
    fn what_moves_along_with_a_clear_joint_is_no_noise() {
        for width in [5.0, 6.8] {
            let (mut strip, path) = along(width, 1.0, 5.0);
            let all = strip.noise_beside(&path, (width, 0.0));
            let clear = strip.noise_beside(&path, (width, 0.95 * CLEAR * all));
            assert!(clear < 0.9 * all, "{width}: {clear}, {all}");
        }
    }
}
