use crate::{Frame, Pixels};

/// Rows of a strip.
pub(super) const ROWS: usize = 56;
/// Columns to either side of the axis.
pub(super) const HALF: usize = 22;
/// Columns of a strip.
pub(super) const COLS: usize = 2 * HALF + 1;
/// A group is the mean of this many rows before and after.
const GROUP: usize = 4;
/// Least noise of a difference of means, grey values of 255.
const LEAST_NOISE: f32 = 0.4;
/// Evidence begins at this many standard deviations.
pub(super) const EVIDENCE_FROM: f32 = 2.5;

/// A predicted axis: an arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axis {
    pub(super) x: f32,
    pub(super) y: f32,
    /// Heading, rad.
    pub(super) heading: f32,
    /// Change of heading, rad/px.
    pub(super) curvature: f32,
    /// Pixels between rows.
    pub(super) along: f32,
    /// Pixels between columns.
    pub(super) across: f32,
    /// The row at (x, y): those before it look back.
    pub(super) origin: usize,
}

impl Axis {
    /// The same axis, sampled for a joint of this width, pixels: never many columns, rows closer than columns.
    pub(super) fn for_width(self, width: f32) -> Self {
        Self { along: (width / 12.0).max(1.0), across: (width / 6.0).max(1.0), ..self }
    }

    /// The axis' place at row `i` (fractions too) and its unit tangent there.
    pub(super) fn at(&self, i: f32) -> ([f32; 2], [f32; 2]) {
        let s = (i - self.origin as f32) * self.along;
        let turn = s * self.curvature;
        // Chord of an arc: the mean direction is that of half the turn.
        let chord = s * (1.0 - turn * turn / 24.0);
        let (sin, cos) = (self.heading + turn / 2.0).sin_cos();
        let (tangent_sin, tangent_cos) = (self.heading + turn).sin_cos();
        ([self.x + chord * cos, self.y + chord * sin], [tangent_cos, tangent_sin])
    }

    /// The place `across` columns beside row `i`.
    pub(super) fn beside(&self, i: f32, across: f32) -> [f32; 2] {
        let ([x, y], [cos, sin]) = self.at(i);
        let across = across * self.across;
        [x - across * sin, y + across * cos]
    }
}

/// Grey values along a predicted axis, unrolled, and how much darker than both sides each place is.
#[derive(Debug, Clone)]
pub(super) struct Strip {
    /// Grey values, 0 to 255.
    pub(super) grey: Vec<[f32; COLS]>,
    /// Means of groups of rows.
    pub(super) group: Vec<[f32; COLS]>,
    /// How much darker than the lighter metal on both sides, grey values; the least of both.
    pub(super) depth: Vec<[f32; COLS]>,
    /// Standard deviation of such a difference where there is no joint.
    pub(super) noise: f32,
    /// First and last column where there is a depth.
    pub(super) columns: (usize, usize),
    /// The mean of both sides less the joint's box: what noise is measured on.
    pub(super) even: Vec<[f32; COLS]>,
    magnitudes: Vec<f32>,
}

impl Strip {
    pub(super) fn new() -> Self {
        let rows = || vec![[0.0; COLS]; ROWS];
        let magnitudes = Vec::with_capacity(ROWS * COLS);
        Self {
            grey: rows(),
            group: rows(),
            depth: rows(),
            noise: 1.0,
            columns: (0, COLS - 1),
            even: rows(),
            magnitudes,
        }
    }

    /// Fills the strip from `frame` along `axis`; its depths for a joint of `width` columns.
    pub(super) fn fill(&mut self, frame: &Frame, axis: &Axis, width: f32) {
        let size = (frame.width(), frame.height());
        match frame.pixels() {
            Pixels::U8(pixels) => self.unroll(|i| f32::from(pixels[i]), size, axis),
            Pixels::U16(pixels) => self.unroll(|i| f32::from(pixels[i]) / 257.0, size, axis),
        }
        self.groups();
        self.depths(width);
    }

    fn unroll(&mut self, pixel: impl Fn(usize) -> f32, (width, height): (usize, usize), axis: &Axis) {
        let (right, bottom) = ((width - 1) as f32, (height - 1) as f32);
        // A coarse sample is the mean of the pixels of its place, a fine one lies between four pixels.
        let (along, across) = (axis.along.round() as usize, axis.across.round() as usize);
        let part = 1.0 / (along * across) as f32;
        for (i, row) in self.grey.iter_mut().enumerate() {
            let ([x, y], [cos, sin]) = axis.at(i as f32);
            for (j, grey) in row.iter_mut().enumerate() {
                let offset = (j as f32 - HALF as f32) * axis.across;
                // Beyond the rim the rim goes on.
                let (px, py) = (x - offset * sin, y + offset * cos);
                if along * across == 1 {
                    let (px, py) = (px.clamp(0.0, right), py.clamp(0.0, bottom));
                    let (left, top) = (px as usize, py as usize);
                    let (u, v) = (px - left as f32, py - top as f32);
                    let (next, below) = ((left + 1).min(width - 1), (top + 1).min(height - 1) * width);
                    let top = top * width;
                    let upper = pixel(top + left) * (1.0 - u) + pixel(top + next) * u;
                    let lower = pixel(below + left) * (1.0 - u) + pixel(below + next) * u;
                    *grey = upper * (1.0 - v) + lower * v;
                    continue;
                }
                let mut sum = 0.0;
                for k in 0..along * across {
                    let u = (k / across) as f32 - 0.5 * (along - 1) as f32;
                    let v = (k % across) as f32 - 0.5 * (across - 1) as f32;
                    let (qx, qy) = (px + u * cos - v * sin + 0.5, py + u * sin + v * cos + 0.5);
                    sum += pixel(qy.clamp(0.0, bottom) as usize * width + qx.clamp(0.0, right) as usize);
                }
                *grey = sum * part;
            }
        }
    }

    fn groups(&mut self) {
        let mut sum = [0.0; COLS];
        let add = |sum: &mut [f32; COLS], row: &[f32; COLS], sign: f32| {
            sum.iter_mut().zip(row).for_each(|(s, g)| *s += sign * g);
        };
        self.grey[..GROUP].iter().for_each(|row| add(&mut sum, row, 1.0));
        for i in 0..ROWS {
            if i + GROUP < ROWS {
                add(&mut sum, &self.grey[i + GROUP], 1.0);
            }
            if i > GROUP {
                add(&mut sum, &self.grey[i - GROUP - 1], -1.0);
            }
            let count = (i + GROUP + 1).min(ROWS) - i.saturating_sub(GROUP);
            let part = 1.0 / count as f32;
            self.group[i].iter_mut().zip(&sum).for_each(|(g, s)| *g = s * part);
        }
    }

    fn depths(&mut self, width: f32) {
        let boxes = Boxes::new(width);
        self.columns = (boxes.reach, COLS - 1 - boxes.reach);
        self.magnitudes.clear();
        for ((row, depth), even) in self.group.iter().zip(&mut self.depth).zip(&mut self.even) {
            let sums = sums(row);
            let first = self.columns.0;
            for (j, (depth, even)) in depth[first..=self.columns.1].iter_mut().zip(&mut even[first..]).enumerate() {
                let (left, centre, right) = boxes.means(&sums, first + j);
                *depth = left.min(right) - centre;
                *even = 0.5 * (left + right) - centre;
            }
        }
        // What differs between groups that share no row is noise, the joint goes on; a low quantile, as it may slant.
        for (a, b) in self.even.iter().zip(&self.even[2 * GROUP + 1..]) {
            let columns = self.columns.0..=self.columns.1;
            self.magnitudes.extend(a[columns.clone()].iter().zip(&b[columns]).map(|(a, b)| (a - b).abs()));
        }
        let place = self.magnitudes.len() * 3 / 10;
        let (_, quantile, _) = self.magnitudes.select_nth_unstable_by(place, f32::total_cmp);
        self.noise = (*quantile / (0.385 * std::f32::consts::SQRT_2)).max(LEAST_NOISE);
    }

    /// Depth of row `i` alone at column `j`, not of its group.
    pub(super) fn row_depth(&self, i: usize, j: usize, width: f32) -> f32 {
        let (left, centre, right) =
            Boxes::new(width).means(&sums(&self.grey[i]), j.clamp(self.columns.0, self.columns.1));
        0.5 * (left + right) - centre
    }
}

fn sums(row: &[f32; COLS]) -> [f32; COLS + 1] {
    let mut sums = [0.0; COLS + 1];
    for (j, grey) in row.iter().enumerate() {
        sums[j + 1] = sums[j] + grey;
    }
    sums
}

/// A box on the joint and one on either side, a skirt between.
struct Boxes {
    /// Columns of the joint's box to either side of its middle.
    half: usize,
    skirt: usize,
    side: usize,
    /// From the middle to the last column.
    reach: usize,
}

impl Boxes {
    fn new(width: f32) -> Self {
        let half = ((width - 1.0) / 2.0).round().max(0.0) as usize;
        let (skirt, side) = (1 + half / 2, (2 * half + 1).clamp(3, 5));
        Self { half, skirt, side, reach: half + skirt + side }
    }

    fn means(&self, sums: &[f32; COLS + 1], j: usize) -> (f32, f32, f32) {
        let mean = |from: usize, to: usize| (sums[to] - sums[from]) / (to - from) as f32;
        let (low, high) = (j - self.half - self.skirt, j + self.half + self.skirt + 1);
        (mean(low - self.side, low), mean(j - self.half, j + self.half + 1), mean(high, high + self.side))
    }
}
