//! How much darker each place of a picture is than the metal about it, whatever light is on it: the black top-hat, a closing
//! less the picture (Serra, Image Analysis and Mathematical Morphology, 1982). A closing fills what is darker and narrower than
//! its square and leaves the edges of shadows and of tacks as they are, so these are not seen any longer.

use super::levels::{Grey, Picture};
use super::make_room;
use crate::wide::{Work, wide};

/// Parts of a grey value that are told apart. (Two grey values together are no more than 16 bits.)
const PARTS: f32 = 64.0;
/// Parts of a grey value that depths are told apart by, and the depths.
const DEPTH_PARTS: i16 = 8;
const DEPTHS: i16 = 256 * DEPTH_PARTS;
/// Pixels that are combined at a time.
const LANES: usize = 32;
/// Depths go towards this part of the depth at the start: where it is lighter beside an open gap it is deeper.
const DEEPEST: f32 = 0.8;
/// Grey value of the metal.
const METAL: f32 = 255.0;

/// A picture of the joint on even metal; keeps its buffers.
#[derive(Debug, Clone, Default)]
pub(super) struct TopHat {
    width: usize,
    height: usize,
    /// The picture within a margin of its rims' values, a little out of focus, in parts of grey values.
    smooth: Vec<i16>,
    /// The same, closed.
    metal: Vec<i16>,
    pixels: Vec<f32>,
}

impl TopHat {
    /// Room for a picture of this size and squares of so many pixels to either side.
    pub(super) fn make_room(&mut self, (width, height): (usize, usize), around: usize) {
        let whole = line(width, around) * (height + 2 * margin(around)) + behind(around);
        make_room(&mut self.smooth, whole);
        make_room(&mut self.metal, whole);
        make_room(&mut self.pixels, width * height);
    }

    /// Takes it of a picture, by squares of `around` pixels to either side, for joints that are narrower than those and about
    /// `contrast` grey values deep.
    pub(super) fn take(&mut self, pixels: &[f32], (width, height): (usize, usize), around: usize, contrast: f32) {
        (self.width, self.height) = (width, height);
        let (margin, square) = (margin(around), 2 * around + 1);
        let (line, rows) = (line(width, around), height + 2 * margin);
        self.put_within(pixels, margin, line);
        self.smooth.resize(line * rows + behind(around), 0);
        self.metal.resize(self.smooth.len(), 0);
        wide(Close { smooth: &mut self.smooth, metal: &mut self.metal, size: (line, rows), square });
        self.pixels.resize(width * height, 0.0);
        let most = DEEPEST * contrast;
        for (y, out) in self.pixels.chunks_exact_mut(width).enumerate() {
            // A group of three, then two squares to the upper left.
            let at = |less: usize| (y + margin - less) * line + margin - less;
            let (smooth, metal) = (&self.smooth[at(1)..][..width], &self.metal[at(square)..][..width]);
            wide(Bend { smooth, metal, most, out });
        }
    }

    pub(super) fn picture(&self) -> Picture<'_> {
        Picture { width: self.width, height: self.height, grey: Grey::F32(&self.pixels), is_top_hat: true }
    }

    /// The picture within a margin, lines of so many pixels.
    fn put_within(&mut self, pixels: &[f32], margin: usize, line: usize) {
        self.smooth.clear();
        for y in 0..self.height + 2 * margin {
            let row = &pixels[y.saturating_sub(margin).min(self.height - 1) * self.width..][..self.width];
            self.smooth.extend(std::iter::repeat_n(parts(row[0]), margin));
            self.smooth.extend(row.iter().map(|grey| parts(*grey)));
            self.smooth.extend(std::iter::repeat_n(parts(row[self.width - 1]), line - margin - self.width));
        }
    }
}

/// A grey value in parts.
fn parts(grey: f32) -> i16 {
    // The last bits of what has no place for fractions.
    const WHOLE: f32 = 8_388_608.0;
    (PARTS * grey + WHOLE).to_bits() as i16
}

/// Pixels that are needed about a picture for squares of so many to either side.
fn margin(around: usize) -> usize {
    2 * around + 2
}

/// Pixels from one row of a picture within its margin to the next, in whole lanes.
fn line(width: usize, around: usize) -> usize {
    (width + 2 * margin(around)).next_multiple_of(LANES)
}

/// Pixels behind the last row that its own are combined with: whole lanes, or the longest step.
fn behind(around: usize) -> usize {
    around.max(LANES)
}

/// Steps after each of which a pixel holds so many more from it on, until they are `count`.
fn steps(count: usize) -> impl Iterator<Item = usize> + Clone {
    let more = move |done: usize| (done < count).then(|| done.min(count - done));
    let mut done = 1;
    std::iter::from_fn(move || more(done).inspect(|step| done += step))
}

/// Makes a picture a little smoother and closes it, by squares of so many pixels a side. The upper left pixel of each group becomes
/// what the group is. Rows are done one after the other, as far as each goes: so they stay at hand.
struct Close<'a> {
    smooth: &'a mut [i16],
    metal: &'a mut [i16],
    /// Pixels of a row, and rows.
    size: (usize, usize),
    square: usize,
}

impl Work for Close<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { smooth, metal, size, square } = self;
        let mean = |a: i16, b: i16| (a + b) >> 1;
        let (twice, square) = (&[1, 1].into_iter(), &steps(square));
        across(smooth, size, twice, mean);
        down(smooth, size, twice, mean);
        metal.copy_from_slice(smooth);
        across(metal, size, square, i16::max);
        down(metal, size, square, i16::max);
        down(metal, size, square, i16::min);
        across(metal, size, square, i16::min);
    }
}

/// Combines each pixel with those of its row from it on, step by step. (Behind the rim a row goes on with the next one: nobody asks.)
#[inline(always)]
fn across(
    pixels: &mut [i16],
    (line, rows): (usize, usize),
    steps: &(impl Iterator<Item = usize> + Clone),
    of: impl Fn(i16, i16) -> i16,
) {
    for from in (0..rows).map(|row| row * line) {
        for step in steps.clone() {
            let row = &mut pixels[from..][..line + step];
            for i in (0..line).step_by(LANES) {
                let mut behind = [0; LANES];
                behind.copy_from_slice(&row[i + step..][..LANES]);
                for (a, b) in row[i..][..LANES].iter_mut().zip(behind) {
                    *a = of(*a, b);
                }
            }
        }
    }
}

/// Combines each row with those from it on, step by step; the last ones stay as they are.
#[inline(always)]
fn down(
    pixels: &mut [i16],
    (line, rows): (usize, usize),
    steps: &(impl Iterator<Item = usize> + Clone),
    of: impl Fn(i16, i16) -> i16,
) {
    for row in 0..rows {
        // Each step as soon as the one before it is done with the row it reaches.
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
}

/// The grey values of a row for depths that are bent over at `most`.
struct Bend<'a> {
    smooth: &'a [i16],
    metal: &'a [i16],
    most: f32,
    out: &'a mut [f32],
}

impl Work for Bend<'_> {
    #[inline(always)]
    fn run(self) {
        for ((out, smooth), metal) in self.out.iter_mut().zip(self.smooth).zip(self.metal) {
            let depth = ((metal - smooth) / (PARTS as i16 / DEPTH_PARTS)).min(DEPTHS - 1);
            let depth = f32::from(depth) * (1.0 / f32::from(DEPTH_PARTS));
            let part = depth / self.most;
            *out = METAL - depth / (1.0 + part * part).sqrt();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::random;

    /// The same by the definition: the least of the greatest of squares, of means of three by three with weights 1, 2, 1.
    fn slowly(pixels: &[f32], (width, height): (usize, usize), around: isize) -> Vec<f32> {
        let (w, h) = (width as isize, height as isize);
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
        let mut random = random();
        let mut hat = TopHat::default();
        for around in 1..=5 {
            let size @ (width, height) = (17 + (20.0 * random()) as usize, 17 + (20.0 * random()) as usize);
            let pixels: Vec<f32> = (0..width * height).map(|_| 200.0 * random()).collect();
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
            hat.take(&[90.0; 20 * 20], (20, 20), around, 50.0);
            assert!(hat.pixels.iter().all(|grey| *grey >= METAL), "{around}");
        }
    }

    /// What it is for: a line across the edge of a shadow and a bright disc is there, and nothing else.
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
        hat.take(&pixels, (width, height), 3, 30.0);
        for (i, grey) in hat.pixels.iter().enumerate() {
            let (x, y) = place(i);
            let off = (y - 0.2 * x - 20.0).abs();
            match METAL - grey {
                // Across the edge itself the line is half as deep.
                _ if (x + 0.3 * y - 70.0).abs() < 2.0 => {}
                depth if off < 0.5 => assert!(depth > 15.0, "{x} {y}: {depth}"),
                // The corners between the disc's rim and the square's are filled in part.
                depth if off > 4.0 => assert!(depth < 8.0, "{x} {y}: {depth}"),
                _ => {}
            }
        }
    }
}
