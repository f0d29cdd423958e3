//! Parabolas through rows that are all there.

use super::axis::Station;
use super::make_room;
use crate::wide::LANES;

/// Most rows before and after.
pub(super) const MOST: usize = 24;
/// Rows of the longest parabola.
const LONGEST: usize = 2 * MOST + 1;

/// Rows in a picture, to the right and down, pixels; behind the last ones as many zeros as are done at a time.
#[derive(Debug, Clone, Default)]
pub(super) struct Rows {
    pub(super) x: Vec<f32>,
    pub(super) y: Vec<f32>,
}

impl Rows {
    /// Room for so many rows.
    pub(super) fn make_room(&mut self, rows: usize) {
        make_room(&mut self.x, rows + LANES);
        make_room(&mut self.y, rows + LANES);
    }

    /// Takes other rows.
    pub(super) fn put(&mut self, places: impl Iterator<Item = [f32; 2]>) {
        self.x.clear();
        self.y.clear();
        for [x, y] in places.chain([[0.0; 2]; LANES]) {
            self.x.push(x);
            self.y.push(y);
        }
    }
}

/// A parabola across rows as far before as after one, their weights falling as a parabola: what does not depend on where they
/// are, once for all rows.
#[derive(Debug, Clone)]
pub(super) struct Even {
    reach: usize,
    /// Weights, and those times the rows' numbers and squares, of `2 * reach + 1` rows.
    weights: [[f32; LONGEST]; 3],
    /// Sums of the weights times the rows' numbers to the powers 0, 2 and 4.
    moments: [f32; 3],
}

impl Default for Even {
    fn default() -> Self {
        Self { reach: 0, weights: [[0.0; LONGEST]; 3], moments: [0.0; 3] }
    }
}

impl Even {
    /// For `reach` rows before and after, up to [`MOST`].
    pub(super) fn prepare(&mut self, reach: usize) {
        self.reach = reach;
        self.moments = [0.0; 3];
        for k in 0..=2 * reach {
            let row = k as f32 - reach as f32;
            let weight = 1.0 - (row / (reach + 1) as f32).powi(2);
            for (list, value) in self.weights.iter_mut().zip([weight, weight * row, weight * row * row]) {
                list[k] = value;
            }
            for (moment, value) in self.moments.iter_mut().zip([1.0, row.powi(2), row.powi(4)]) {
                *moment += weight * value;
            }
        }
    }

    /// How far to the right of each of up to [`LANES`] stations in a row, the first that of row `i`, the parabola through the rows about
    /// it crosses its line, and the standard error of that. About each lie as many rows before and after as were prepared for.
    #[inline(always)]
    pub(super) fn across(&self, rows: &Rows, i: usize, stations: &[Station]) -> [(f32, f32); LANES] {
        debug_assert!(stations.len() <= LANES, "{} stations", stations.len());
        let [mut x0, mut y0, mut cos, mut sin] = [[0.0; LANES]; 4];
        for (k, station) in stations.iter().enumerate().take(LANES) {
            ([x0[k], y0[k]], [cos[k], sin[k]]) = (station.at, station.tangent);
        }
        let from = i - self.reach;
        let [w0, w1, w2] = self.weights.each_ref().map(|list| list[..=2 * self.reach].iter());
        let near = rows.x[from..].windows(LANES).zip(rows.y[from..].windows(LANES));
        // Sums of each row's weight times how far it is off, times its number, its number's square, and how far it is off.
        let [mut r0, mut r1, mut r2, mut squares] = [[0.0; LANES]; 4];
        for (((x, y), w0), (w1, w2)) in near.zip(w0).zip(w1.zip(w2)) {
            let (Some(x), Some(y)) = (x.first_chunk::<LANES>(), y.first_chunk::<LANES>()) else { break };
            let off: [f32; LANES] = std::array::from_fn(|k| (y[k] - y0[k]) * cos[k] - (x[k] - x0[k]) * sin[k]);
            r0 = std::array::from_fn(|k| r0[k] + w0 * off[k]);
            r1 = std::array::from_fn(|k| r1[k] + w1 * off[k]);
            r2 = std::array::from_fn(|k| r2[k] + w2 * off[k]);
            squares = std::array::from_fn(|k| squares[k] + w0 * off[k] * off[k]);
        }
        let [m0, m2, m4] = self.moments;
        let determinant = m0 * m4 - m2 * m2;
        std::array::from_fn(|k| {
            let (value, slope) = ((r0[k] * m4 - r2[k] * m2) / determinant, r1[k] / m2);
            let bend = (r2[k] * m0 - r0[k] * m2) / determinant;
            let rest = (squares[k] - value * r0[k] - slope * r1[k] - bend * r2[k]).max(0.0) / m0;
            (value, (rest * m4 / determinant).sqrt())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::parabola::Parabola;

    #[test]
    fn it_is_the_parabola_of_least_squares() {
        let mut even = Even::default();
        for (reach, angle) in [(6usize, 0.3f32), (7, -2.0), (11, 1.2), (24, 2.9)] {
            even.prepare(reach);
            let (sin, cos) = angle.sin_cos();
            let count = 2 * reach + 7;
            // A bend with a scatter that is the same each time.
            let across = |k: usize| 0.01 * (k as f32 - 9.0).powi(2) + 0.3 * (7.3 * k as f32).sin();
            let place = |k: usize| [200.0 + cos * k as f32 - sin * across(k), 90.0 + sin * k as f32 + cos * across(k)];
            let mut rows = Rows::default();
            rows.put((0..count).map(place));
            let station =
                |i: usize| Station { at: [200.0 + cos * i as f32, 90.0 + sin * i as f32], tangent: [cos, sin] };
            for i in reach..count - reach {
                let (found, error) = even.across(&rows, i, &[station(i)])[0];
                // The same as one of several.
                let from = (i - i % LANES).max(reach);
                let together: Vec<Station> = (from..=i).map(station).collect();
                let again = even.across(&rows, from, &together)[i - from];
                assert!((found - again.0).abs() < 1e-4 && (error - again.1).abs() < 1e-4, "{i}: {found} {again:?}");
                let weight = |k: usize| 1.0 - (k.abs_diff(i) as f32 / (reach + 1) as f32).powi(2);
                let near = (i - reach..=i + reach).map(|k| (k as f32 - i as f32, across(k), weight(k)));
                let parabola = Parabola::through(near, 0.0).unwrap();
                assert!((found - parabola.terms[0]).abs() < 1e-3, "{reach} {i}: {found} {parabola:?}");
                let expected = (parabola.rest * parabola.variance).sqrt();
                assert!((error - expected).abs() < 1e-3, "{reach} {i}: {error} {expected}");
            }
        }
    }
}
