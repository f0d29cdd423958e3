//! Depth of each pixel against the metal about it, under any light: the black top-hat, a closing less the picture
//! (Serra, Image Analysis and Mathematical Morphology, 1982). A closing fills dark structures narrower than its square.
//! It keeps the edges of shadows and tacks, so that the difference removes them.

use super::levels::{Grey, Picture};
use super::make_room;
use crate::aligned::CACHE_LINE;
use crate::frame::Size;
use crate::simd::{Work, wide};
use pulp::Simd;

/// Resolution of grey values, parts of one. (A sum of two of them fits into 16 bits.)
const PARTS: f32 = 64.0;
/// Resolution of depths, parts of a grey value, and the number of depths.
const DEPTH_PARTS: i16 = 8;
const DEPTHS: i16 = 256 * DEPTH_PARTS;
/// Pixels processed at a time.
const LANES: usize = 32;
/// Limit of the depths as a part of the depth at the start: an open gap beside lighter metal is deeper.
const DEEPEST: f32 = 0.8;
/// Grey value of the metal.
const METAL: f32 = 255.0;

/// A picture of the joint on uniform metal; reuses its buffers.
#[derive(Debug, Clone, Default)]
pub(super) struct TopHat {
    width: usize,
    height: usize,
    /// The slightly blurred picture with a margin of repeated border pixels, in parts of grey values.
    smooth: Vec<i16>,
    /// The closing of `smooth`.
    metal: Vec<i16>,
    pixels: Vec<f32>,
}

impl TopHat {
    /// Reserves capacity for a picture of this size and squares of `around` pixels to either side.
    pub(super) fn make_room(&mut self, size: Size, around: usize) {
        let Size { width, height } = size;
        let room = room(line(width, around) * (height + 2 * margin(around)), around);
        make_room(&mut self.smooth, room);
        make_room(&mut self.metal, room);
        make_room(&mut self.pixels, width * height);
    }

    /// Computes the top-hat of a picture, with squares of `around` pixels to either side, for joints narrower than
    /// these and about `contrast` grey values deep.
    pub(super) fn take(&mut self, pixels: &[f32], size: Size, around: usize, contrast: f32) {
        let Size { width, height } = size;
        (self.width, self.height) = (width, height);
        let (margin, square) = (margin(around), 2 * around + 1);
        let (line, rows) = (line(width, around), height + 2 * margin);
        self.smooth.resize(room(line * rows, around), 0);
        self.metal.resize(self.smooth.len(), 0);
        self.pixels.resize(width * height, 0.0);
        let [smooth, metal] = [&mut self.smooth[..], &mut self.metal[..]].map(from_cache_line);
        let out = &mut self.pixels;
        wide(Take { pixels, size, smooth, metal, out, line, rows, margin, square, most: DEEPEST * contrast });
    }

    pub(super) fn picture(&self) -> Picture<'_> {
        Picture { width: self.width, height: self.height, grey: Grey::F32(&self.pixels), is_top_hat: true }
    }
}

/// Converts a grey value to parts.
#[inline(always)]
fn parts(grey: f32) -> i16 {
    // At this magnitude `f32` has no fraction bits: the low bits are the integer.
    const WHOLE: f32 = 8_388_608.0;
    (PARTS * grey + WHOLE).to_bits() as i16
}

/// Returns the margin about a picture for squares of `around` pixels to either side.
fn margin(around: usize) -> usize {
    2 * around + 2
}

/// Returns the pixels from one row of a picture with its margin to the next, in whole lanes.
fn line(width: usize, around: usize) -> usize {
    (width + 2 * margin(around)).next_multiple_of(LANES)
}

/// Returns the buffer size for `pixels`. It includes whole lanes or the longest step behind the last row, and the
/// alignment to a cache line before the first one.
fn room(pixels: usize, around: usize) -> usize {
    pixels + around.max(LANES) + LANES
}

/// Returns the pixels from the first cache line boundary on.
fn from_cache_line(pixels: &mut [i16]) -> &mut [i16] {
    const { assert!(LANES * size_of::<i16>() >= CACHE_LINE, "there is room for it") };
    let from = pixels.as_ptr().align_offset(CACHE_LINE);
    &mut pixels[from..]
}

/// Returns steps of doubling length, after which a pixel combines `count` pixels from it on.
fn steps(count: usize) -> impl Iterator<Item = usize> + Clone {
    let more = move |done: usize| (done < count).then(|| done.min(count - done));
    let mut done = 1;
    std::iter::from_fn(move || more(done).inspect(|step| done += step))
}

/// See [`TopHat::take`]. Each row is processed as soon as its inputs are ready, so that they stay in the cache. The
/// upper left pixel of each group holds the result.
struct Take<'a> {
    pixels: &'a [f32],
    size: Size,
    smooth: &'a mut [i16],
    metal: &'a mut [i16],
    out: &'a mut [f32],
    /// Pixels per row with the margin, and rows.
    line: usize,
    rows: usize,
    margin: usize,
    square: usize,
    most: f32,
}

impl Work for Take<'_> {
    #[inline(always)]
    fn run(self, _: impl Simd) {
        let Self { pixels, size: Size { width, height }, smooth, metal, out, line, rows, margin, square, most } = self;
        let mean = |a: i16, b: i16| (a + b) >> 1;
        let (twice, steps) = ([1, 1].into_iter(), steps(square));
        for row in 0..rows {
            let from = &pixels[row.saturating_sub(margin).min(height - 1) * width..][..width];
            put_within(&mut smooth[row * line..][..line], from, margin);
            across(smooth, RowAt { line, row }, &twice, mean);
            down(smooth, RowAt { line, row }, &twice, mean);
            // A row is smoothed when the two below it are there. The maximum or minimum of a square is ready with its
            // last row.
            let Some(row) = row.checked_sub(2) else { continue };
            let this = row * line..(row + 1) * line;
            metal[this.clone()].copy_from_slice(&smooth[this]);
            across(metal, RowAt { line, row }, &steps, i16::max);
            down(metal, RowAt { line, row }, &steps, i16::max);
            let Some(row) = row.checked_sub(square - 1) else { continue };
            down(metal, RowAt { line, row }, &steps, i16::min);
            let Some(row) = row.checked_sub(square - 1) else { continue };
            across(metal, RowAt { line, row }, &steps, i16::min);
            // A group of three is shifted by one to the upper left, the two squares by their size.
            let Some(y) = (row + square).checked_sub(margin).filter(|y| *y < height) else { continue };
            let at = |less: usize| (y + margin - less) * line + margin - less;
            let (smooth, metal) = (&smooth[at(1)..][..width], &metal[at(square)..][..width]);
            bend(&mut out[y * width..][..width], smooth, metal, most);
        }
    }
}

/// Writes a row of grey values in parts, with a margin.
#[inline(always)]
fn put_within(row: &mut [i16], from: &[f32], margin: usize) {
    let (before, rest) = row.split_at_mut(margin);
    let (within, behind) = rest.split_at_mut(from.len());
    before.fill(parts(from[0]));
    for (parts_of, grey) in within.iter_mut().zip(from) {
        *parts_of = parts(*grey);
    }
    behind.fill(parts(from[from.len() - 1]));
}

#[derive(Debug, Clone, Copy)]
struct RowAt {
    /// Pixels from one row of the buffer to the next.
    line: usize,
    row: usize,
}

/// Combines each pixel with those behind it in its row, step by step. (Behind the border a row continues in the next
/// one; those results are unused.)
#[inline(always)]
fn across(pixels: &mut [i16], at: RowAt, steps: &(impl Iterator<Item = usize> + Clone), of: impl Fn(i16, i16) -> i16) {
    let RowAt { line, row } = at;
    for step in steps.clone() {
        let row = &mut pixels[row * line..][..line + step];
        for i in (0..line).step_by(LANES) {
            let mut behind = [0; LANES];
            behind.copy_from_slice(&row[i + step..][..LANES]);
            for (a, b) in row[i..][..LANES].iter_mut().zip(behind) {
                *a = of(*a, b);
            }
        }
    }
}

/// Combines rows with those below them, step by step, for all rows whose inputs end at this row.
#[inline(always)]
fn down(pixels: &mut [i16], at: RowAt, steps: &(impl Iterator<Item = usize> + Clone), of: impl Fn(i16, i16) -> i16) {
    let RowAt { line, row } = at;
    // Each step follows once the previous one is done with the row it reaches.
    let mut reached = row;
    for step in steps.clone() {
        let Some(upper) = reached.checked_sub(step) else { break };
        let (above, below) = pixels.split_at_mut(reached * line);
        for (a, b) in above[upper * line..][..line].iter_mut().zip(&below[..line]) {
            *a = of(*a, *b);
        }
        reached = upper;
    }
}

/// Writes the grey values of a row; depths saturate at `most`.
#[inline(always)]
fn bend(out: &mut [f32], smooth: &[i16], metal: &[i16], most: f32) {
    let part_of_most = 1.0 / most;
    for ((out, smooth), metal) in out.iter_mut().zip(smooth).zip(metal) {
        let depth = ((metal - smooth) / (PARTS as i16 / DEPTH_PARTS)).min(DEPTHS - 1);
        let depth = f32::from(depth) * (1.0 / f32::from(DEPTH_PARTS));
        let part = depth * part_of_most;
        *out = METAL - depth / (1.0 + part * part).sqrt();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// Reference by definition: the minimum of the maximum over squares, of 3 x 3 means with weights 1, 2, 1.
    fn slowly(pixels: &[f32], size: Size, around: isize) -> Vec<f32> {
        let (w, h) = (size.width as isize, size.height as isize);
        let at = |x: isize, y: isize| pixels[(y.clamp(0, h - 1) * w + x.clamp(0, w - 1)) as usize];
        let three = [(-1, 0.25), (0, 0.5), (1, 0.25)];
        let smooth = |x: isize, y: isize| {
            let parts = three.iter().flat_map(|(dy, b)| three.iter().map(move |(dx, a)| (*dx, *dy, a * b)));
            parts.map(|(dx, dy, part)| part * at(x + dx, y + dy)).sum::<f32>()
        };
        let about = |x: isize, y: isize| {
            (-around..=around).flat_map(move |dy| (-around..=around).map(move |dx| (x + dx, y + dy)))
        };
        let opened = |x: isize, y: isize| about(x, y).map(|(x, y)| smooth(x, y)).fold(f32::MIN, f32::max);
        let places = (0..h).flat_map(|y| (0..w).map(move |x| (x, y)));
        places.map(|(x, y)| about(x, y).map(|(x, y)| opened(x, y)).fold(f32::MAX, f32::min) - smooth(x, y)).collect()
    }

    #[test]
    fn it_is_the_closing_less_the_picture() {
        let mut random = Random::new(7);
        let mut hat = TopHat::default();
        for around in 1..=5 {
            let size = Size { width: 17 + random.below(20), height: 17 + random.below(20) };
            let pixels: Vec<f32> = (0..size.width * size.height).map(|_| random.within(0.0, 200.0) as f32).collect();
            hat.take(&pixels, size, around, 50.0);
            for (found, depth) in hat.pixels.iter().zip(slowly(&pixels, size, around as isize)) {
                let told = METAL - depth / (1.0 + (depth / 40.0).powi(2)).sqrt();
                assert!((found - told).abs() < 0.2, "{found} {told}");
            }
        }
    }

    #[test]
    fn squares_may_be_larger_than_what_is_combined_at_a_time_and_than_the_picture() {
        let mut hat = TopHat::default();
        for around in [LANES - 1, LANES, LANES + 1, 3 * LANES] {
            hat.take(&[90.0; 20 * 20], Size { width: 20, height: 20 }, around, 50.0);
            assert!(hat.pixels.iter().all(|grey| *grey >= METAL), "{around}");
        }
    }

    /// The purpose: a line across the edges of a shadow and a bright disc remains, everything else vanishes.
    #[test]
    fn the_edges_of_light_are_gone() {
        let (width, height) = (120, 90);
        let place = |i: usize| ((i % width) as f32, (i / width) as f32);
        let metal = |x: f32, y: f32| {
            let lit = if x + 0.3 * y > 70.0 { 160.0 } else { 110.0 };
            if (x - 22.0).hypot(y - 62.0) < 14.0 { 200.0 } else { lit }
        };
        let line = |x: f32, y: f32| (y - 0.2 * x - 20.0).abs() < 1.5;
        let pixels: Vec<f32> =
            (0..width * height).map(place).map(|(x, y)| metal(x, y) - if line(x, y) { 30.0 } else { 0.0 }).collect();
        let mut hat = TopHat::default();
        hat.take(&pixels, Size { width, height }, 3, 30.0);
        for (i, grey) in hat.pixels.iter().enumerate() {
            let (x, y) = place(i);
            let off = (y - 0.2 * x - 20.0).abs();
            match METAL - grey {
                // Across the edge itself the line has half the depth.
                _ if (x + 0.3 * y - 70.0).abs() < 2.0 => {}
                depth if off < 0.5 => assert!(depth > 15.0, "{x} {y}: {depth}"),
                // The corners between the disc's rim and the square's are partly filled.
                depth if off > 4.0 => assert!(depth < 8.0, "{x} {y}: {depth}"),
                _ => {}
            }
        }
    }
}
