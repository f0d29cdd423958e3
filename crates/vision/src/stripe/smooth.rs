//! Smoothing of the stripe's centres over several columns.

use super::blob_chain::StripePoint;
use crate::simd::{Work, wide};
use pulp::Simd;

/// Columns to each side in a window, and the maximum distance of its centres from their straight line, pixels. Beside
/// corners and ends, columns stay unchanged.
const TOGETHER: usize = 2;
const STRAIGHT: f64 = 1.0;

const WINDOW: usize = 2 * TOGETHER + 1;

/// Smooths chains; reuses its buffers.
#[derive(Debug, Clone, Default)]
pub(super) struct Smoother {
    columns: Vec<f64>,
    rows: Vec<f64>,
    weights: Vec<f64>,
    smoothed: Vec<f64>,
}

impl Smoother {
    /// Reserves capacity for this many points.
    pub(super) fn reserve(&mut self, places: usize) {
        for list in [&mut self.columns, &mut self.rows, &mut self.weights, &mut self.smoothed] {
            list.clear();
            list.reserve(places);
        }
    }

    /// Moves every centre to the straight line through those of [`TOGETHER`] columns to both sides, by least squares
    /// weighted with the strengths. Grains of light vary much between columns, and the lens mixes neighbours. On a
    /// slope this shifts the centre of a single column, but not the line through several.
    pub(super) fn smooth(&mut self, chain: &mut [StripePoint]) {
        let Self { columns, rows, weights, smoothed } = self;
        if chain.len() < WINDOW {
            return;
        }
        [&mut *columns, &mut *rows, &mut *weights].into_iter().for_each(Vec::clear);
        for p in &*chain {
            columns.push(p.at.x);
            rows.push(p.at.y);
            weights.push(p.strength.max(1.0));
        }
        smoothed.clear();
        smoothed.resize(chain.len() - 2 * TOGETHER, 0.0);
        wide(Lines { columns, rows, weights, smoothed });
        for (place, row) in chain[TOGETHER..].iter_mut().zip(smoothed) {
            place.at.y = *row;
        }
    }
}

/// Fits a line to each window of points and computes its middle, or keeps the centre.
struct Lines<'a> {
    columns: &'a [f64],
    rows: &'a [f64],
    weights: &'a [f64],
    smoothed: &'a mut [f64],
}

impl Work for Lines<'_> {
    #[inline(always)]
    fn run(self, _: impl Simd) {
        let count = self.smoothed.len();
        // For each list, the first points of all windows, then the second ones, and so on.
        let [columns, rows, weights]: [[&[f64]; WINDOW]; 3] =
            [self.columns, self.rows, self.weights].map(|list| std::array::from_fn(|k| &list[k..k + count]));
        for i in 0..count {
            let (x0, y0) = (columns[TOGETHER][i], rows[TOGETHER][i]);
            let (mut sums, mut products) = ([0.0; 3], [0.0; 2]);
            for k in 0..WINDOW {
                let (x, y, w) = (columns[k][i] - x0, rows[k][i] - y0, weights[k][i]);
                sums = [sums[0] + w, sums[1] + w * x, sums[2] + w * x * x];
                products = [products[0] + w * y, products[1] + w * x * y];
            }
            let det = sums[0] * sums[2] - sums[1] * sums[1];
            let row = (sums[2] * products[0] - sums[1] * products[1]) / det;
            let slope = (sums[0] * products[1] - sums[1] * products[0]) / det;
            let mut straight = columns[WINDOW - 1][i] - columns[0][i] < WINDOW as f64 + 1.0;
            for k in 0..WINDOW {
                straight &= (rows[k][i] - y0 - row - slope * (columns[k][i] - x0)).abs() < STRAIGHT;
            }
            self.smoothed[i] = if straight { y0 + row } else { y0 };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use nalgebra::{DMatrix, DVector};
    use seamwright_testkit::Random;

    /// Reference: least-squares line through the points of a window, by singular values. Returns its row in the middle,
    /// and true if all points are near it.
    fn fitted(window: &[StripePoint]) -> (f64, bool) {
        let root = |p: &StripePoint| p.strength.max(1.0).sqrt();
        let x = |p: &StripePoint| p.at.x - window[TOGETHER].at.x;
        let a = DMatrix::from_fn(WINDOW, 2, |i, k| root(&window[i]) * if k == 0 { 1.0 } else { x(&window[i]) });
        let b = DVector::from_fn(WINDOW, |i, _| root(&window[i]) * window[i].at.y);
        let line = a.svd(true, true).solve(&b, 1e-12).unwrap();
        (line[0], window.iter().all(|p| (p.at.y - line[0] - line[1] * x(p)).abs() < STRAIGHT))
    }

    #[test]
    fn centres_are_on_the_line_through_their_neighbours_where_these_are_straight() {
        let mut random = Random::new(7);
        let mut smoother = Smoother::default();
        let (mut moved, mut kept) = (0, 0);
        for length in (0..300).chain([2000]) {
            let (mut column, mut row, mut slope) = (5.0, 400.0, 0.3);
            let chain: Vec<StripePoint> = (0..length)
                .map(|_| {
                    // Missing columns, corners, steps and grains.
                    column += if random.chance(0.05) { 1.0 + random.below(4) as f64 } else { 1.0 };
                    slope = if random.chance(0.03) { random.within(-2.0, 2.0) } else { slope };
                    row += slope + if random.chance(0.02) { 9.0 } else { random.within(0.0, 0.6) };
                    StripePoint {
                        at: DVec2::new(column, row),
                        strength: random.within(0.0, 500.0),
                        width: 8.0,
                        saturated: false,
                    }
                })
                .collect();
            let mut smoothed = chain.clone();
            smoother.smooth(&mut smoothed);
            for (i, (before, after)) in chain.iter().zip(&smoothed).enumerate() {
                let window = i.checked_sub(TOGETHER).and_then(|first| chain.get(first..first + WINDOW));
                let near = window.filter(|w| w[WINDOW - 1].at.x - w[0].at.x < WINDOW as f64 + 1.0).map(fitted);
                let wanted = near.filter(|(_, straight)| *straight).map_or(before.at.y, |(row, _)| row);
                assert!((after.at.y - wanted).abs() < 1e-9, "{length}, {i}: {} {wanted}", after.at.y);
                let at = DVec2::new(after.at.x, before.at.y);
                assert_eq!(StripePoint { at, ..*after }, *before);
                *if near.is_some_and(|(_, straight)| straight) { &mut moved } else { &mut kept } += 1;
            }
        }
        assert!(moved > 10_000 && kept > 5_000, "{moved} {kept}");
    }
}
