//! Parabolas through evenly spaced rows, several at a time.

use super::axis::Station;
use super::make_room;
use super::parabola::Parabola;
use crate::simd::LANES;
use std::ops::Range;

/// Maximum rows before and after.
pub(super) const MAX_REACH: usize = 24;
/// Rows of the longest parabola.
const LONGEST: usize = 2 * MAX_REACH + 1;

/// Zeros before the first row and behind the last one: a parabola's reach, plus the rows of a SIMD step.
const BEFORE: usize = MAX_REACH;
const BEHIND: usize = MAX_REACH + LANES;

/// Positions of rows in a picture, to the right and down, pixels; `seen` is 1 for seen rows.
#[derive(Debug, Clone, Default)]
pub(super) struct Rows {
    x: Vec<f32>,
    y: Vec<f32>,
    seen: Vec<f32>,
}

impl Rows {
    /// Reserves capacity for this many rows.
    pub(super) fn make_room(&mut self, rows: usize) {
        [&mut self.x, &mut self.y, &mut self.seen].into_iter().for_each(|list| make_room(list, BEFORE + rows + BEHIND));
    }

    /// Replaces the rows.
    pub(super) fn put(&mut self, rows: impl Iterator<Item = ([f32; 2], bool)>) {
        [&mut self.x, &mut self.y, &mut self.seen].into_iter().for_each(|list| {
            list.clear();
            list.resize(BEFORE, 0.0);
        });
        for ([x, y], seen) in rows {
            self.x.push(x);
            self.y.push(y);
            self.seen.push(f32::from(u8::from(seen)));
        }
        let behind = self.x.len() + BEHIND;
        [&mut self.x, &mut self.y, &mut self.seen].into_iter().for_each(|list| list.resize(behind, 0.0));
    }

    pub(super) fn places(&self, rows: Range<usize>) -> impl Iterator<Item = [f32; 2]> {
        let rows = BEFORE + rows.start..BEFORE + rows.end;
        self.x[rows.clone()].iter().zip(&self.y[rows]).map(|(x, y)| [*x, *y])
    }
}

/// Parabola fit across rows equally far before and after one, with parabolic weights. Holds the factors that do not
/// depend on the rows' positions.
#[derive(Debug, Clone)]
pub(super) struct SlidingParabola {
    reach: usize,
    /// Weights times the rows' numbers to the powers 0 to 4, for `2 * reach + 1` rows.
    weights: [[f32; LONGEST]; 5],
    /// Sums of the weights for the powers 0, 2 and 4.
    moments: [f32; 3],
}

impl Default for SlidingParabola {
    fn default() -> Self {
        Self { reach: 0, weights: [[0.0; LONGEST]; 5], moments: [0.0; 3] }
    }
}

impl SlidingParabola {
    /// Prepares for `reach` rows before and after, up to [`MAX_REACH`].
    pub(super) fn prepare(&mut self, reach: usize) {
        self.reach = reach;
        for k in 0..=2 * reach {
            let row = k as f32 - reach as f32;
            let mut weight = 1.0 - (row / (reach + 1) as f32).powi(2);
            for list in &mut self.weights {
                list[k] = weight;
                weight *= row;
            }
        }
        self.moments = [0, 2, 4].map(|power| self.weights[power][..=2 * reach].iter().sum());
    }

    /// Fits a parabola about each of up to [`LANES`] consecutive stations, the first that of row `i`. Returns its
    /// crossing of the station's line, pixels to the right, and the standard error. Each station needs the prepared
    /// number of rows before and after it.
    #[inline(always)]
    pub(super) fn across(&self, rows: &Rows, i: usize, stations: &[Station]) -> [(f32, f32); LANES] {
        let [x0, y0, cos, sin] = lanes(stations);
        let from = BEFORE + i - self.reach;
        let [w0, w1, w2, ..] = self.weights.each_ref().map(|list| list[..=2 * self.reach].iter());
        let near = rows.x[from..].windows(LANES).zip(rows.y[from..].windows(LANES));
        // Weighted sums of the offsets, of the offsets times the row number and its square, and of the squared offsets.
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

    /// Fits through the seen rows only, held to a line by `stiff`; `None` for too few rows.
    #[inline(always)]
    pub(super) fn across_seen(
        &self,
        rows: &Rows,
        i: usize,
        stations: &[Station],
        stiff: f32,
    ) -> [Option<Parabola>; LANES] {
        let [x0, y0, cos, sin] = lanes(stations);
        let from = BEFORE + i - self.reach;
        let [xs, ys, all_seen] = [&rows.x, &rows.y, &rows.seen].map(|list| list[from..].windows(LANES));
        let mut moments = [[0.0; LANES]; 5];
        let [mut r0, mut r1, mut r2, mut squares] = [[0.0; LANES]; 4];
        for (m, ((x, y), seen)) in xs.zip(ys).zip(all_seen).enumerate().take(2 * self.reach + 1) {
            let (Some(x), Some(y)) = (x.first_chunk::<LANES>(), y.first_chunk::<LANES>()) else { break };
            let Some(seen) = seen.first_chunk::<LANES>() else { break };
            let [w0, w1, w2, w3, w4] = self.weights.each_ref().map(|list| list[m]);
            for (sum, weight) in moments.iter_mut().zip([w0, w1, w2, w3, w4]) {
                *sum = std::array::from_fn(|k| sum[k] + weight * seen[k]);
            }
            let off: [f32; LANES] = std::array::from_fn(|k| (y[k] - y0[k]) * cos[k] - (x[k] - x0[k]) * sin[k]);
            let seen: [f32; LANES] = std::array::from_fn(|k| seen[k] * off[k]);
            r0 = std::array::from_fn(|k| r0[k] + w0 * seen[k]);
            r1 = std::array::from_fn(|k| r1[k] + w1 * seen[k]);
            r2 = std::array::from_fn(|k| r2[k] + w2 * seen[k]);
            squares = std::array::from_fn(|k| squares[k] + w0 * seen[k] * off[k]);
        }
        std::array::from_fn(|k| {
            Parabola::of(moments.each_ref().map(|sum| sum[k]), [r0[k], r1[k], r2[k]], squares[k], stiff)
        })
    }
}

/// Positions and tangents of up to [`LANES`] stations.
#[inline(always)]
fn lanes(stations: &[Station]) -> [[f32; LANES]; 4] {
    debug_assert!(stations.len() <= LANES, "{} stations", stations.len());
    let mut lanes = [[0.0; LANES]; 4];
    for (k, Station { at: [x, y], tangent: [cos, sin] }) in stations.iter().enumerate().take(LANES) {
        for (lane, value) in lanes.iter_mut().zip([x, y, cos, sin]) {
            lane[k] = *value;
        }
    }
    lanes
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    #[test]
    fn it_is_the_parabola_of_least_squares() {
        let mut even = SlidingParabola::default();
        for (reach, angle) in [(6usize, 0.3f32), (7, -2.0), (11, 1.2), (24, 2.9)] {
            even.prepare(reach);
            let (sin, cos) = angle.sin_cos();
            let count = 2 * reach + 7;
            // A bend with deterministic scatter.
            let across = |k: usize| 0.01 * (k as f32 - 9.0).powi(2) + 0.3 * (7.3 * k as f32).sin();
            let place = |k: usize| [200.0 + cos * k as f32 - sin * across(k), 90.0 + sin * k as f32 + cos * across(k)];
            let mut rows = Rows::default();
            rows.put((0..count).map(|k| (place(k), true)));
            let station =
                |i: usize| Station { at: [200.0 + cos * i as f32, 90.0 + sin * i as f32], tangent: [cos, sin] };
            for i in reach..count - reach {
                let (found, error) = even.across(&rows, i, &[station(i)])[0];
                // The same station as one of several.
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

    #[test]
    fn what_is_not_seen_or_not_there_does_not_count() {
        let (mut even, mut random) = (SlidingParabola::default(), Random::new(7));
        for _ in 0..2000 {
            let (reach, count) = (6 + random.below(19), 1 + random.below(70));
            even.prepare(reach);
            let seen: Vec<bool> = (0..count).map(|_| random.chance(0.6)).collect();
            let across: Vec<f32> = (0..count).map(|_| random.within(0.0, 3.0) as f32).collect();
            let (sin, cos) = (random.within(0.0, 7.0) as f32).sin_cos();
            let at = |k: usize, off: f32| [200.0 + cos * k as f32 - sin * off, 90.0 + sin * k as f32 + cos * off];
            let mut rows = Rows::default();
            rows.put((0..count).map(|k| (at(k, across[k]), seen[k])));
            let stations: Vec<_> = (0..count).map(|k| Station { at: at(k, 0.0), tangent: [cos, sin] }).collect();
            for i in (0..count).step_by(LANES) {
                let several = &stations[i..count.min(i + LANES)];
                let found = even.across_seen(&rows, i, several, 100.0);
                for (row, found) in (i..i + several.len()).zip(found) {
                    let near = (row.saturating_sub(reach)..count.min(row + reach + 1)).filter(|k| seen[*k]);
                    let weight = |k: usize| 1.0 - (k.abs_diff(row) as f32 / (reach + 1) as f32).powi(2);
                    let told = Parabola::through(near.map(|k| (k as f32 - row as f32, across[k], weight(k))), 100.0);
                    // For a few points far aside one method may give a parabola and the other none.
                    let Some((found, told)) = found.zip(told).filter(|(_, told)| told.variance < 10.0) else {
                        assert!(told.is_none_or(|told| told.variance > 3.0), "{row} of {count}: {told:?}");
                        continue;
                    };
                    assert!((found.terms[0] - told.terms[0]).abs() < 0.01, "{found:?} {told:?}");
                    assert!((found.error() - told.error()).abs() < 0.01 || found.weights < 4.1, "{found:?} {told:?}");
                }
            }
        }
    }
}
