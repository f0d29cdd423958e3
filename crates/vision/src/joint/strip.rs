use super::axis::Station;
use super::levels::{Grey, Picture};
use super::make_room;
use super::sample::{Pixel, Sampler};
use crate::aligned::Aligned;
use crate::simd::{LANES, Work, wide};
use pulp::Simd;
use std::ops::Range;

/// Columns of a strip.
pub(super) const COLS: usize = 48;
/// Column on the axis.
pub(super) const MID: usize = COLS / 2;
/// Rows before and after that are averaged to a group.
pub(super) const GROUP: usize = 4;
/// Rows before and after that decide whether a joint is seen.
pub(super) const SEEN_AROUND: usize = 6;
/// Minimum mean depth of these rows, as a part of the joint's ...
const PART: f32 = 0.45;
/// ... and in standard deviations of a depth.
const STANDS_OUT: f32 = 2.2;
/// Distance from the middle at which metal begins, in widths.
pub(super) const METAL: f32 = 1.1;
/// Rows over which the light's change across is measured together.
pub(super) const LIT: usize = 24;
/// Columns of each of the two boxes on either side.
pub(super) const SIDE: usize = 3;

/// Half of the box on the widest joint of a level, columns.
const MAX_HALF: usize = 3;

/// Returns the columns of the box on a joint of this width.
pub(super) fn box_columns(width: f32) -> usize {
    2 * (((width - 1.0) / 2.0).round().max(0.0) as usize).min(MAX_HALF) + 1
}

/// Returns the distance from a joint's middle at which metal begins, columns, for half of the box on it.
const fn away(half: usize) -> usize {
    half + 1 + half.div_ceil(2)
}

/// One value per column.
pub(super) type Line = Aligned<COLS>;

/// `f32::max` without NaN handling: one instruction.
#[inline(always)]
pub(super) fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// `f32::min` without NaN handling.
#[inline(always)]
pub(super) fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// Returns the maximum of a line, several values at a time.
#[inline(always)]
pub(super) fn greatest<const N: usize>(line: &[f32; N]) -> f32 {
    const { assert!(N.is_multiple_of(LANES), "whole lanes") };
    let mut lanes = [f32::MIN; LANES];
    for eight in line.as_chunks::<LANES>().0 {
        for (lane, value) in lanes.iter_mut().zip(eight) {
            *lane = greater(*lane, *value);
        }
    }
    lanes.into_iter().fold(f32::MIN, greater)
}

/// Sums of [`SIDE`] columns from each column on, padded by a SIMD step.
type Boxes = [f32; COLS + LANES];

#[inline(always)]
fn boxes(boxes: &mut Boxes, sum: &Line) {
    for (j, value) in boxes[..COLS - SIDE + 1].iter_mut().enumerate() {
        *value = sum[j] + sum[j + 1] + sum[j + 2];
    }
}

/// Computes the depth of the box of `HALF` columns to both sides of each column, against boxes beside it, for the sum
/// of `count` rows. On each side the lighter of two boxes counts, so a scratch or the foot of a step beside the joint
/// does not matter. Of the two sides the darker one counts.
#[inline(always)]
fn depths<const HALF: usize>(depth: &mut Line, sum: &Line, boxes: &Boxes, count: f32) {
    // Whole lanes, some of them behind the last column.
    let (away, reach, lanes) = const {
        let reach = away(HALF) + 2 * SIDE;
        (away(HALF), reach, (COLS - 2 * reach).next_multiple_of(LANES))
    };
    let (per_centre, per_side) = (1.0 / ((2 * HALF + 1) as f32 * count), 1.0 / (SIDE as f32 * count));
    let (left, right) = (reach - away - SIDE, reach + away + 1);
    let near = [&boxes[left..left + lanes], &boxes[right..right + lanes]];
    let far = [&boxes[left - SIDE..left - SIDE + lanes], &boxes[right + SIDE..right + SIDE + lanes]];
    // Columns of the box on the joint, each for all positions.
    let centre: [&[f32]; 2 * MAX_HALF + 1] = std::array::from_fn(|k| {
        let from = reach - HALF + k.min(2 * HALF);
        &sum[from..from + lanes]
    });
    for (j, depth) in depth[reach..reach + lanes].iter_mut().enumerate() {
        let sides = [0, 1].map(|side| greater(near[side][j], far[side][j]));
        let mut on_joint = 0.0;
        for column in &centre[..=2 * HALF] {
            on_joint += column[j];
        }
        *depth = lesser(sides[0], sides[1]) * per_side - on_joint * per_centre;
    }
    depth[..reach].fill(0.0);
    depth[COLS - reach..].fill(0.0);
}

/// Samples grey values across each station.
struct Unroll<'a, P: Pixel, S, const NEAREST: bool> {
    sampler: Sampler<'a, P>,
    stations: S,
    lines: &'a mut [Line],
}

impl<P: Pixel, S: Iterator<Item = Station>, const NEAREST: bool> Work for Unroll<'_, P, S, NEAREST> {
    #[inline(always)]
    fn run(mut self, _: impl Simd) {
        for (line, station) in self.lines.iter_mut().zip(self.stations) {
            if NEAREST {
                self.sampler.row_of_nearest(line, &station);
            } else {
                self.sampler.row(line, &station);
            }
        }
    }
}

/// Computes the depths of a strip for a joint of `width` pixels; see [`Strip::measure`].
struct Measure<'a, const HALF: usize> {
    grey: &'a mut [Line],
    depth: &'a mut [Line],
    width: f32,
    most: f32,
}

impl<const HALF: usize> Work for Measure<'_, HALF> {
    #[inline(always)]
    fn run(mut self, _: impl Simd) {
        self.level_light();
        let mut sum = Line::default();
        let rows = self.grey.len();
        for row in &self.grey[..GROUP.min(rows)] {
            for (s, g) in sum.iter_mut().zip(row) {
                *s += g;
            }
        }
        let mut count = GROUP.min(rows) as f32;
        // Several rows at a time, step by step, since a value just written is not available at once.
        let (mut sums, mut counts) = ([Line::default(); LANES], [0.0; LANES]);
        let mut box_sums: [Boxes; LANES] = [[0.0; COLS + LANES]; LANES];
        for first in (0..rows).step_by(LANES) {
            let last = (first + LANES).min(rows);
            for i in first..last {
                if let Some(row) = self.grey.get_mut(i + GROUP) {
                    let part = 1.0 / count;
                    for (s, g) in sum.iter_mut().zip(row) {
                        let mean = *s * part;
                        *g = lesser(greater(*g, mean - self.most), mean + self.most);
                        *s += *g;
                    }
                    count += 1.0;
                }
                if i > GROUP {
                    let past = self.grey[i - GROUP - 1];
                    sum = Line::from_fn(|j| sum[j] - past[j]);
                    count -= 1.0;
                }
                sums[i - first] = sum;
                counts[i - first] = count;
            }
            for (box_sums, sum) in box_sums.iter_mut().zip(&sums) {
                boxes(box_sums, sum);
            }
            for (k, depth) in self.depth[first..last].iter_mut().enumerate() {
                depths::<HALF>(depth, &sums[k], &box_sums[k], counts[k]);
            }
        }
    }
}

impl<const HALF: usize> Measure<'_, HALF> {
    /// Removes the light's linear change across, as far as it is the same on both sides of a joint in the middle. A
    /// ramp would pull the middle of a wide joint to its darker side.
    #[inline(always)]
    fn level_light(&mut self) {
        let away = (METAL * self.width + 2.0) as usize;
        let side = |row: &Line, columns: Range<usize>| {
            let middle = 0.5 * (columns.start + columns.end - 1) as f32;
            let (product, square) = columns.fold((0.0, 0.0), |(product, square), j| {
                let off = j as f32 - middle;
                (product + off * row[j], square + off * off)
            });
            product / square
        };
        for rows in self.grey.chunks_mut(LIT) {
            let mut mean = Line::default();
            let part = 1.0 / rows.len() as f32;
            for row in &*rows {
                for (m, g) in mean.iter_mut().zip(row) {
                    *m += part * g;
                }
            }
            let (left, right) = (side(&mean, 1..MID - away), side(&mean, MID + away + 1..COLS - 1));
            if left * right <= 0.0 {
                continue;
            }
            let slope = lesser(left.abs(), right.abs()).copysign(left);
            let ramp = Line::from_fn(|j| slope * (j as f32 - MID as f32));
            for row in rows {
                for (g, r) in row.iter_mut().zip(&ramp) {
                    *g -= r;
                }
            }
        }
    }
}

/// Finds the maximum depth of each row.
struct Deepest<'a> {
    depth: &'a [Line],
    deepest: &'a mut [f32],
}

impl Work for Deepest<'_> {
    #[inline(always)]
    fn run(self, _: impl Simd) {
        for (deepest, depth) in self.deepest.iter_mut().zip(self.depth) {
            *deepest = greatest(depth);
        }
    }
}

/// First and last column of a range.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Columns {
    pub(super) first: usize,
    pub(super) last: usize,
}

/// Unrolled grey values along a line of stations, and the depth of each place against the metal on both sides.
#[derive(Debug, Clone, Default)]
pub(super) struct Strip {
    /// Grey values, 0 to 255.
    pub(super) grey: Vec<Line>,
    /// Depth of a group of rows against the metal on both sides, grey values; the smaller of both sides.
    pub(super) depth: Vec<Line>,
    /// Standard deviation of a depth without a joint.
    pub(super) noise: f32,
    pub(super) columns: Columns,
    pub(super) magnitudes: Vec<f32>,
}

impl Strip {
    /// Reserves capacity for this many rows.
    pub(super) fn make_room(&mut self, rows: usize) {
        make_room(&mut self.grey, rows);
        make_room(&mut self.depth, rows);
        // At most every other row and every other column is used.
        make_room(&mut self.magnitudes, rows * COLS / 4);
    }

    /// Unrolls `picture` along `stations`, interpolated between its pixels.
    pub(super) fn unroll(&mut self, picture: &Picture, stations: impl ExactSizeIterator<Item = Station>) {
        self.rows::<false>(picture, stations);
    }

    /// Unrolls the nearest pixels of a frame; interpolates a coarser level. It takes half the time, and means over
    /// groups and boxes have the same noise.
    pub(super) fn unroll_nearest(&mut self, picture: &Picture, stations: impl ExactSizeIterator<Item = Station>) {
        self.rows::<true>(picture, stations);
    }

    fn rows<const NEAREST: bool>(&mut self, picture: &Picture, stations: impl ExactSizeIterator<Item = Station>) {
        self.grey.resize(stations.len(), Line::default());
        let size = picture.size();
        let lines = &mut self.grey;
        match picture.grey {
            Grey::U8(p) => wide(Unroll::<_, _, NEAREST> { sampler: Sampler::new(p, size), stations, lines }),
            Grey::U16(p) => wide(Unroll::<_, _, NEAREST> { sampler: Sampler::new(p, size), stations, lines }),
            Grey::F32(p) => wide(Unroll::<_, _, false> { sampler: Sampler::new(p, size), stations, lines }),
        }
    }

    /// Computes depths for a joint of `width` pixels. Pixels are clipped to `most` grey values from those before them
    /// along the joint.
    pub(super) fn measure(&mut self, width: f32, most: f32) {
        let half = box_columns(width) / 2;
        let reach = away(half) + 2 * SIDE;
        self.columns = Columns { first: reach, last: COLS - 1 - reach };
        self.depth.resize(self.grey.len(), Line::default());
        let Self { grey, depth, .. } = self;
        match half {
            0 => wide(Measure::<0> { grey, depth, width, most }),
            1 => wide(Measure::<1> { grey, depth, width, most }),
            2 => wide(Measure::<2> { grey, depth, width, most }),
            _ => wide(Measure::<3> { grey, depth, width, most }),
        }
    }

    /// Finds the maximum depth of each row.
    pub(super) fn find_deepest(&self, deepest: &mut Vec<f32>) {
        deepest.resize(self.depth.len(), 0.0);
        wide(Deepest { depth: &self.depth, deepest });
    }

    /// Determines which rows show a joint of depth `contrast` along `path`, by the rows about each.
    pub(super) fn shows(&self, path: &[usize], contrast: impl Fn(usize) -> f32, seen: &mut Vec<bool>) {
        seen.clear();
        seen.extend(self.showing(path.len(), |k| self.depth[k][path[k]], contrast));
    }

    /// Returns an upper bound of the `first` rows that show a joint of this depth on any path, given each row's maximum
    /// depth.
    pub(super) fn shows_at_most(&self, deepest: &[f32], contrast: f32, first: usize) -> usize {
        self.showing(deepest.len(), |k| deepest[k], |_| contrast).take(first).filter(|shows| *shows).count()
    }

    /// Returns which of `count` rows show a joint with these depths.
    fn showing(
        &self,
        count: usize,
        depth: impl Fn(usize) -> f32,
        contrast: impl Fn(usize) -> f32,
    ) -> impl Iterator<Item = bool> {
        let depth = move |k: usize| f64::from(depth(k));
        let mut sum: f64 = (0..SEEN_AROUND.min(count)).map(&depth).sum();
        (0..count).map(move |i| {
            let (from, to) = (i.saturating_sub(SEEN_AROUND), (i + SEEN_AROUND + 1).min(count));
            if i + SEEN_AROUND < count {
                sum += depth(i + SEEN_AROUND);
            }
            if i > SEEN_AROUND {
                sum -= depth(from - 1);
            }
            let least = (PART * contrast(i)).max(STANDS_OUT * self.noise) * (to - from) as f32;
            sum > f64::from(least)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// Reference: clips each pixel to `most` from the mean of up to nine rows before it in its column.
    fn clip(grey: &mut [Line], most: f32) {
        for i in GROUP..grey.len() {
            let (before, rest) = grey.split_at_mut(i);
            let before = &before[i.saturating_sub(2 * GROUP + 1)..];
            for (j, value) in rest[0].iter_mut().enumerate() {
                let mean = before.iter().map(|row| row[j]).sum::<f32>() / before.len() as f32;
                *value = value.clamp(mean - most, mean + most);
            }
        }
    }

    /// Depths by their definition: means over groups, the darker side's lighter box less the box on the joint.
    fn depths_of(grey: &[Line], half: usize) -> Vec<Line> {
        let reach = away(half) + 2 * SIDE;
        let of_row = |i: usize| {
            let near = &grey[i.saturating_sub(GROUP)..(i + GROUP + 1).min(grey.len())];
            let mean = |columns: Range<usize>| {
                let count = (near.len() * columns.len()) as f32;
                near.iter().flat_map(|row| &row[columns.clone()]).sum::<f32>() / count
            };
            let depth = |j: usize| {
                let (left, right) = (j - away(half) - SIDE, j + away(half) + 1);
                let lighter = |a: usize, b: usize| mean(a..a + SIDE).max(mean(b..b + SIDE));
                let sides = lighter(left, left - SIDE).min(lighter(right, right + SIDE));
                sides - mean(j - half..j + half + 1)
            };
            Line::from_fn(|j| if (reach..COLS - reach).contains(&j) { depth(j) } else { 0.0 })
        };
        (0..grey.len()).map(of_row).collect()
    }

    /// A leap relies on this: except for its last rows, the first part of a strip is measured like the whole strip. The
    /// part consists of whole [`LIT`] stretches.
    #[test]
    fn a_begin_of_a_strip_is_measured_like_the_whole() {
        let mut random = Random::new(7);
        for width in [1.0, 3.0, 5.0, 7.0] {
            let grey: Vec<Line> =
                (0..2 * LIT).map(|_| Line::from_fn(|j| 2.0 * j as f32 + random.within(0.0, 90.0) as f32)).collect();
            let measured = |rows: usize| {
                let mut strip = Strip { grey: grey[..rows].to_vec(), ..Strip::default() };
                strip.measure(width, 30.0);
                strip.depth
            };
            let (begin, whole) = (measured(LIT), measured(2 * LIT));
            for (i, (a, b)) in begin.iter().map(|row| **row).zip(whole.iter().map(|row| **row)).enumerate() {
                assert_eq!(a.map(f32::to_bits) == b.map(f32::to_bits), i < LIT - GROUP, "{width}: {i}");
            }
        }
    }

    #[test]
    fn depths_are_those_of_means_in_strips_of_any_length() {
        let mut random = Random::new(7);
        for rows in 1..60 {
            for width in [1.0, 3.0, 5.0, 7.0] {
                let grey: Vec<Line> =
                    (0..rows).map(|_| Line::from_fn(|_| random.within(100.0, 150.0) as f32)).collect();
                let measured = |most: f32| {
                    let mut strip = Strip { grey: grey.clone(), ..Strip::default() };
                    strip.measure(width, most);
                    strip
                };
                let near = |a: &Line, b: &Line| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-2);
                // In levelled light without clipping, then with it.
                let mut grey = measured(f32::INFINITY).grey;
                for most in [f32::INFINITY, 12.0] {
                    clip(&mut grey, most);
                    let strip = measured(most);
                    assert!(strip.grey.iter().zip(&grey).all(|(a, b)| near(a, b)), "{rows} {width} {most}");
                    let depths = depths_of(&grey, box_columns(width) / 2);
                    assert!(strip.depth.iter().zip(&depths).all(|(a, b)| near(a, b)), "{rows} {width} {most}");
                }
            }
        }
    }

    #[test]
    fn no_path_shows_more_than_the_greatest_depths() {
        let mut random = Random::new(7);
        let mut shown = 0;
        for _ in 0..2000 {
            let most = 1 + random.below(40);
            let mut strip = Strip { noise: 0.5 + random.below(50) as f32 * 0.1, ..Strip::default() };
            strip.depth = (0..48).map(|_| Line::from_fn(|_| random.below(10 * most) as f32 * 0.1)).collect();
            let deepest: Vec<f32> = strip.depth.iter().map(|row| greatest(row)).collect();
            assert!(strip.depth.iter().zip(&deepest).all(|(row, d)| row.iter().all(|v| v <= d) && row.contains(d)));
            let path: Vec<usize> = (0..48).map(|_| random.below(COLS)).collect();
            let contrast = random.below(20 * most) as f32 * 0.1;
            let mut seen = Vec::new();
            strip.shows(&path, |_| contrast, &mut seen);
            let count = seen.iter().filter(|s| **s).count();
            assert!(count <= strip.shows_at_most(&deepest, contrast, usize::MAX));
            shown += count;
        }
        assert!(shown > 10_000, "{shown}");
    }
}
