//! Parabolas through rows that are all there.

use super::make_room;

/// Most rows before and after.
pub(super) const MOST: usize = 24;
/// Rows that are summed at a time.
const LANES: usize = 8;
/// Room for most rows, in whole lanes.
const ROOM: usize = (2 * MOST + 1).next_multiple_of(LANES);

/// Rows in a picture, to the right and down, pixels; behind the last ones as many zeros as are summed at a time.
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
#[derive(Debug, Clone, Default)]
pub(super) struct Even {
    reach: usize,
    /// Weights, and those times the rows' numbers and squares; with zeros up to whole lanes.
    weights: [Vec<f32>; 3],
    /// Sums of the weights times the rows' numbers to the powers 0, 2 and 4.
    moments: [f32; 3],
}

impl Even {
    /// For `reach` rows before and after, up to [`MOST`].
    pub(super) fn prepare(&mut self, reach: usize) {
        self.reach = reach;
        for list in &mut self.weights {
            list.clear();
            list.reserve(ROOM);
        }
        self.moments = [0.0; 3];
        for k in 0..=2 * reach {
            let row = k as f32 - reach as f32;
            let weight = 1.0 - (row / (reach + 1) as f32).powi(2);
            for (list, value) in self.weights.iter_mut().zip([weight, weight * row, weight * row * row]) {
                list.push(value);
            }
            for (moment, value) in self.moments.iter_mut().zip([1.0, row.powi(2), row.powi(4)]) {
                *moment += weight * value;
            }
        }
        for list in &mut self.weights {
            list.resize(list.len().next_multiple_of(LANES), 0.0);
        }
    }

    /// How far to the right of a place, seen along `tangent`, the parabola through the rows about row `i` crosses that row's
    /// line, and the standard error of that. As many rows as were prepared for lie before and after.
    pub(super) fn across(&self, rows: &Rows, i: usize, [x0, y0]: [f32; 2], [cos, sin]: [f32; 2]) -> (f32, f32) {
        let from = i - self.reach;
        let near = from..from + self.weights[0].len();
        let [w0, w1, w2] = self.weights.each_ref().map(Vec::as_slice);
        // How far off each row is, and that times its weight.
        let (mut off, mut weighted) = ([0.0; ROOM], [0.0; ROOM]);
        let (off, weighted) = (&mut off[..w0.len()], &mut weighted[..w0.len()]);
        for ((off, x), y) in off.iter_mut().zip(&rows.x[near.clone()]).zip(&rows.y[near]) {
            *off = (y - y0) * cos - (x - x0) * sin;
        }
        weighted.iter_mut().zip(&*off).zip(w0).for_each(|((weighted, off), w)| *weighted = w * off);
        let (r0, r1, r2) = (sum(weighted, |w, _| w, off), sum(off, product, w1), sum(off, product, w2));
        let squares = sum(weighted, product, off);
        let [m0, m2, m4] = self.moments;
        let determinant = m0 * m4 - m2 * m2;
        let (value, slope, bend) = ((r0 * m4 - r2 * m2) / determinant, r1 / m2, (r2 * m0 - r0 * m2) / determinant);
        let rest = (squares - value * r0 - slope * r1 - bend * r2).max(0.0) / m0;
        (value, (rest * m4 / determinant).sqrt())
    }
}

fn product(a: f32, b: f32) -> f32 {
    a * b
}

/// The sum over two lists of whole lanes.
fn sum(a: &[f32], of: impl Fn(f32, f32) -> f32, b: &[f32]) -> f32 {
    let mut lanes = [0.0; LANES];
    for (a, b) in a.as_chunks::<LANES>().0.iter().zip(b.as_chunks::<LANES>().0) {
        lanes.iter_mut().zip(a).zip(b).for_each(|((lane, a), b)| *lane += of(*a, *b));
    }
    lanes.iter().sum()
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
            for i in reach..count - reach {
                let at = [200.0 + cos * i as f32, 90.0 + sin * i as f32];
                let (found, error) = even.across(&rows, i, at, [cos, sin]);
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
