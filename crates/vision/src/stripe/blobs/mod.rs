//! Bright blobs of every column of an image.
//!
//! Rows are summed in blocks of [`BLOCK`], and pairs of sums are compared with a background. The background is an
//! opening of coarse means along the column: structures narrower than about 80 rows do not belong to it. Local maxima
//! of a column above the noise are refined pixel by pixel. Work is linear in the pixels, and all passes over whole rows
//! are 16-bit sums and comparisons.

mod sums;

use self::sums::{CellMeans, FourRows, Grey, Pairs};
use crate::frame::{Frame, Pixels};
use crate::simd::wide;

/// Maximum blobs per column.
pub(super) const MAX_BLOBS: usize = 5;

/// Rows per sum.
const BLOCK: usize = 4;

/// Columns per cell of the background, and sums in its height.
const CELL: usize = 16;
const CELL_SUMS: usize = 4;

/// Cells in the window of the opening.
const OPENING: usize = 6;

/// Minimum contrast of a pair of sums, in standard deviations of its noise and in grey values.
const STANDS_OUT: f32 = 6.0;
const MIN_CONTRAST: f32 = 24.0;

/// Maximum rows of sums sampled for the noise, and the column step within them.
const NOISE_ROWS: usize = 24;
const NOISE_COLUMNS: usize = 5;

/// Level of a blob's border between background (0) and peak (1).
const BORDER: f32 = 0.2;

/// Maximum distance of a border from the peak, pixels.
const FARTHEST: usize = 60;

/// Minimum grey value of a saturated pixel.
const SATURATED: f32 = 250.0;

/// A bright section of a column.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Blob {
    /// Row of the centre.
    pub(super) row: f32,
    /// Sum of the grey values above the background.
    pub(super) strength: f32,
    /// Rows from border to border.
    pub(super) width: f32,
    /// True if some of its pixels are saturated.
    pub(super) saturated: bool,
}

/// Finds blobs; reuses its buffers from image to image.
#[derive(Debug, Clone, Default)]
pub(super) struct Blobs {
    /// Blobs of each column, the strongest first.
    columns: Vec<[Blob; MAX_BLOBS]>,
    counts: Vec<u8>,
    /// Sums of rows, block by block.
    sums: Vec<i16>,
    /// Background of sums, and the buffer to open it.
    cells: Vec<f32>,
    opened: Vec<f32>,
    /// Value of a sum for one grey value.
    a_grey: f32,
    /// Pairs of sums above their background: of the row before the last, the last one and this one.
    pairs: [Vec<i16>; 3],
    floor: Vec<i16>,
    /// Block and contrast of the best pairs of each column.
    candidates: Vec<[(u16, i16); MAX_BLOBS]>,
}

impl Blobs {
    /// Finds the blobs of `frame`. Returns false if more than half of its background is saturated.
    pub(super) fn find(&mut self, frame: &Frame) -> bool {
        let width = frame.width();
        self.columns.clear();
        self.columns.resize(width, [Blob::default(); MAX_BLOBS]);
        self.counts.clear();
        self.counts.resize(width, 0);
        match frame.pixels() {
            Pixels::U8(pixels) => self.search(pixels, width, frame.height()),
            Pixels::U16(pixels) => self.search(pixels, width, frame.height()),
        }
    }

    /// Returns the number of columns.
    pub(super) fn width(&self) -> usize {
        self.columns.len()
    }

    /// Returns the blobs of a column, the strongest first.
    pub(super) fn of(&self, column: usize) -> &[Blob] {
        &self.columns[column][..usize::from(self.counts[column])]
    }

    /// Returns the background about a pixel, grey values.
    pub(super) fn background_at(&self, column: usize, row: usize) -> f64 {
        let across = self.columns.len().div_ceil(CELL);
        let cell = self.opened.get(row / (CELL_SUMS * BLOCK) * across + column / CELL);
        f64::from(cell.copied().unwrap_or(0.0) / self.a_grey)
    }

    fn search<G: Grey>(&mut self, pixels: &[G], width: usize, height: usize) -> bool {
        if height < 2 * BLOCK {
            return true;
        }
        let blocks = height.div_ceil(BLOCK);
        self.sum(pixels, width, height, blocks);
        self.background(width, blocks);
        self.a_grey = G::A_GREY * BLOCK as f32;
        let full = SATURATED * self.a_grey;
        let bright = self.opened.iter().filter(|&&v| v > full).count();
        if 2 * bright > self.opened.len() {
            return false;
        }
        let threshold = (STANDS_OUT * self.noise(width, blocks)).max(MIN_CONTRAST * G::A_GREY).min(32000.0) as i16;
        self.maxima(width, blocks, threshold);
        for column in 0..width {
            self.refine(pixels, width, height, column);
        }
        true
    }

    /// Sums blocks of rows; the last block ends with the last row.
    fn sum<G: Grey>(&mut self, pixels: &[G], width: usize, height: usize, blocks: usize) {
        self.sums.clear();
        self.sums.resize(width * blocks, 0);
        for (b, sums) in self.sums.chunks_exact_mut(width).enumerate() {
            let first = (b * BLOCK).min(height - BLOCK);
            let rows = &pixels[first * width..(first + BLOCK) * width];
            wide(FourRows { rows, sums });
        }
    }

    /// Computes the background of sums in cells: the opening of their means along the columns.
    fn background(&mut self, width: usize, blocks: usize) {
        let (across, down) = (width.div_ceil(CELL), blocks.div_ceil(CELL_SUMS));
        self.cells.clear();
        self.cells.resize(across * down, 0.0);
        for (i, cells) in self.cells.chunks_exact_mut(across).enumerate() {
            let rows = CELL_SUMS * i..(CELL_SUMS * (i + 1)).min(blocks);
            let count = rows.len();
            for row in rows {
                wide(CellMeans { sums: &self.sums[row * width..(row + 1) * width], count, cells });
            }
        }
        self.opened.clear();
        self.opened.resize(across * down, 0.0);
        slide(&self.cells, &mut self.opened, across, Reach { before: 0, after: OPENING - 1 }, f32::min);
        slide(&self.opened, &mut self.cells, across, Reach { before: OPENING - 1, after: 0 }, f32::max);
        std::mem::swap(&mut self.cells, &mut self.opened);
    }

    /// Returns the standard deviation of a pair of sums, from the median difference of neighbouring sums in a column.
    fn noise(&self, width: usize, blocks: usize) -> f32 {
        // Two alternating histograms, since a count just raised is not available at once.
        let mut counts = [[0u32; 512]; 2];
        let mut total = 0;
        for b in (0..blocks - 1).step_by(blocks.div_ceil(NOISE_ROWS)) {
            let (upper, lower) = self.sums[b * width..(b + 2) * width].split_at(width);
            for (i, (u, l)) in upper.iter().zip(lower).step_by(NOISE_COLUMNS).enumerate() {
                counts[i % 2][usize::from(u.abs_diff(*l)).min(511)] += 1;
            }
            total += width.div_ceil(NOISE_COLUMNS) as u32;
        }
        let mut below = 0;
        let median = counts[0].iter().zip(&counts[1]).position(|(a, b)| {
            below += a + b;
            2 * below > total
        });
        (median.unwrap_or(0) as f32 + 0.5) / 0.6745
    }

    /// Collects the best local maxima of pairs of sums in every column.
    fn maxima(&mut self, width: usize, blocks: usize, threshold: i16) {
        self.candidates.clear();
        self.candidates.resize(width, [(0, 0); MAX_BLOBS]);
        for pair in self.pairs.iter_mut().chain([&mut self.floor]) {
            pair.clear();
            pair.resize(width, 0);
        }
        let across = width.div_ceil(CELL);
        for b in 0..blocks {
            self.pairs.rotate_left(1);
            if b + 1 < blocks {
                if b % CELL_SUMS == 0 {
                    let cells = &self.opened[b / CELL_SUMS * across..][..across];
                    for (floor, cell) in self.floor.chunks_mut(CELL).zip(cells) {
                        floor.fill((2.0 * cell) as i16);
                    }
                }
                let sums = &self.sums[b * width..(b + 2) * width];
                wide(Pairs { sums, floor: &self.floor, pairs: &mut self.pairs[2] });
            } else {
                self.pairs[2].fill(0);
            }
            if b == 0 {
                continue;
            }
            let [before, here, after] = &self.pairs;
            let hit = |c: usize| here[c] > threshold && here[c] >= before[c] && here[c] > after[c];
            for first in (0..width).step_by(64) {
                let columns = first..(first + 64).min(width);
                // One comparison for all 64 columns: most have no maximum.
                if here[columns.clone()].iter().fold(i16::MIN, |m, &v| m.max(v)) <= threshold {
                    continue;
                }
                for column in columns.filter(|&c| hit(c)) {
                    note(&mut self.candidates[column], ((b - 1) as u16, here[column]));
                }
            }
        }
    }

    /// Refines the candidates of a column pixel by pixel.
    fn refine<G: Grey>(&mut self, pixels: &[G], width: usize, height: usize, column: usize) {
        let across = width.div_ceil(CELL);
        let mut spans = [(usize::MAX, 0usize); MAX_BLOBS];
        let mut count = 0;
        for (block, contrast) in self.candidates[column] {
            if contrast == 0 {
                break;
            }
            let background = self.opened[usize::from(block) / CELL_SUMS * across + column / CELL] / self.a_grey;
            let first = usize::from(block) * BLOCK;
            let rows = first.min(height - 1)..(first + 2 * BLOCK).min(height);
            let (blob, span) = blob(|row: usize| pixels[row * width + column].grey(), rows, height, background);
            if spans[..count].iter().any(|s| s.0 <= span.1 && span.0 <= s.1) {
                continue;
            }
            spans[count] = span;
            self.columns[column][count] = blob;
            count += 1;
        }
        self.counts[column] = count as u8;
    }
}

/// Returns the blob whose peak is among `rows`, and its first and last row.
fn blob(
    at: impl Fn(usize) -> f32,
    rows: std::ops::Range<usize>,
    height: usize,
    background: f32,
) -> (Blob, (usize, usize)) {
    let (mut peak, mut top) = (rows.start, f32::MIN);
    for row in rows {
        let v = at(row);
        if v > top {
            (peak, top) = (row, v);
        }
    }
    let level = background + BORDER * (top - background);
    // A border needs two consecutive pixels below the level: speckle makes single dark ones.
    let (mut first, mut last) = (peak, peak);
    while first > 0 && peak - first < FARTHEST && (at(first - 1) > level || (first > 1 && at(first - 2) > level)) {
        first -= 1;
    }
    while last + 1 < height
        && last - peak < FARTHEST
        && (at(last + 1) > level || (last + 2 < height && at(last + 2) > level))
    {
        last += 1;
    }
    let (mut sum, mut moment, mut strength, mut saturated) = (0.0, 0.0, 0.0, 0);
    for row in first..=last {
        let v = at(row);
        let weight = (v - level).max(0.0);
        sum += weight;
        moment += weight * (row - first) as f32;
        strength += v - background;
        saturated += u32::from(v >= SATURATED);
    }
    let centroid = first as f32 + if sum > 0.0 { moment / sum } else { 0.0 };
    let row = if saturated >= 3 { between_flanks(&at, first, last, (top + background) / 2.0) } else { centroid };
    let width = (last - first + 1) as f32;
    (Blob { row, strength, width, saturated: saturated > 0 }, (first, last))
}

/// Returns the middle between the flanks of a blob with a clipped peak, at `level`.
fn between_flanks(at: &impl Fn(usize) -> f32, first: usize, last: usize, level: f32) -> f32 {
    let crossing = |below: usize, above: usize| {
        let (low, high) = (at(below), at(above));
        let part = if high > low { ((level - low) / (high - low)).clamp(0.0, 1.0) } else { 0.5 };
        below as f32 + part * (above as f32 - below as f32)
    };
    let rise = (first..last).find(|&r| at(r) >= level).unwrap_or(first);
    let fall = (rise..=last).rev().find(|&r| at(r) >= level).unwrap_or(last);
    let upper = if rise > first { crossing(rise - 1, rise) } else { rise as f32 };
    let lower = if fall < last { crossing(fall + 1, fall) } else { fall as f32 };
    (upper + lower) / 2.0
}

/// Inserts a candidate into the best of its column, by contrast.
fn note(best: &mut [(u16, i16); MAX_BLOBS], new: (u16, i16)) {
    if let Some(place) = best.iter().position(|old| old.1 < new.1) {
        best[place..].rotate_right(1);
        best[place] = new;
    }
}

/// Rows before and after a row.
#[derive(Debug, Clone, Copy)]
struct Reach {
    before: usize,
    after: usize,
}

/// Minimum or maximum over a window of rows of cells.
fn slide(from: &[f32], to: &mut [f32], across: usize, reach: Reach, better: fn(f32, f32) -> f32) {
    let down = from.len() / across;
    for (i, row) in to.chunks_exact_mut(across).enumerate() {
        let window = i.saturating_sub(reach.before)..(i + reach.after + 1).min(down);
        row.copy_from_slice(&from[i * across..(i + 1) * across]);
        for other in window {
            for (v, o) in row.iter_mut().zip(&from[other * across..]) {
                *v = better(*v, *o);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A column with a Gaussian of the given centre and height on a background.
    fn image(centre: f64, height: f64, width: usize) -> Vec<u8> {
        let grey = |row: usize| {
            let d = row as f64 - centre;
            (20.0 + 0.05 * row as f64 + height * (-d * d / (2.0 * 2.5 * 2.5)).exp()).min(255.0) as u8
        };
        (0..200 * width).map(|i| grey(i / width)).collect()
    }

    #[test]
    fn centres_are_sub_pixel_also_saturated() {
        for height in [40.0, 120.0, 200.0, 600.0, 3000.0] {
            for step in 0..10 {
                let centre = 80.0 + f64::from(step) / 10.0 + f64::from(step);
                let pixels = image(centre, height, 40);
                let mut blobs = Blobs::default();
                assert!(blobs.find(&Frame::new(40, 200, Pixels::U8(&pixels)).unwrap()));
                let [blob] = blobs.of(20) else { panic!("{:?}", blobs.of(20)) };
                assert!((f64::from(blob.row) - centre).abs() < 0.1, "{height}: {centre} {}", blob.row);
                assert_eq!(blob.saturated, height > 235.0, "{height}");
                let wide: Vec<u16> = pixels.iter().map(|&p| u16::from(p) * 257).collect();
                assert!(blobs.find(&Frame::new(40, 200, Pixels::U16(&wide)).unwrap()));
                assert!((f64::from(blobs.of(20)[0].row) - centre).abs() < 0.1);
            }
        }
    }

    #[test]
    fn nothing_in_nothing() {
        let mut blobs = Blobs::default();
        for (width, height) in [(1, 1), (3, 7), (16, 8), (17, 9), (100, 100)] {
            assert!(blobs.find(&Frame::new(width, height, Pixels::U8(&vec![3u8; width * height])).unwrap()));
            assert!((0..width).all(|c| blobs.of(c).is_empty()));
            let white = vec![255u8; width * height];
            assert_eq!(blobs.find(&Frame::new(width, height, Pixels::U8(&white)).unwrap()), height < 8);
        }
    }
}
