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
        let whole = (width + 2 * margin(around)) * (height + 2 * margin(around));
        make_room(&mut self.smooth, whole);
        make_room(&mut self.metal, whole);
        make_room(&mut self.pixels, width * height);
    }

    /// Takes it of a picture, by squares of `around` pixels to either side, for joints that are narrower than those and about
    /// `contrast` grey values deep.
    pub(super) fn take(&mut self, pixels: &[f32], (width, height): (usize, usize), around: usize, contrast: f32) {
        (self.width, self.height) = (width, height);
        let (margin, square) = (margin(around), 2 * around + 1);
        let line = width + 2 * margin;
        self.put_within(pixels, margin);
        // The upper left pixel of each group becomes what the group is.
        for step in [1, 1, line, line] {
            combine(&mut self.smooth, step, |a, b| (a + b) >> 1);
        }
        self.metal.clone_from(&self.smooth);
        for step in [1, line] {
            each_of(&mut self.metal, square, step, i16::max);
        }
        for step in [1, line] {
            each_of(&mut self.metal, square, step, i16::min);
        }
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

    /// The picture within a margin.
    fn put_within(&mut self, pixels: &[f32], margin: usize) {
        self.smooth.clear();
        for y in 0..self.height + 2 * margin {
            let row = &pixels[y.saturating_sub(margin).min(self.height - 1) * self.width..][..self.width];
            self.smooth.extend(std::iter::repeat_n(parts(row[0]), margin));
            self.smooth.extend(row.iter().map(|grey| parts(*grey)));
            self.smooth.extend(std::iter::repeat_n(parts(row[self.width - 1]), margin));
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

/// Combines each pixel with all of the `count` from it on, `step` apart.
fn each_of(pixels: &mut [i16], count: usize, step: usize, of: impl Fn(i16, i16) -> i16) {
    let mut done = 1;
    while done < count {
        let more = done.min(count - done);
        combine(pixels, more * step, &of);
        done += more;
    }
}

/// Combines each pixel with the one so far behind it.
fn combine(pixels: &mut [i16], apart: usize, of: impl Fn(i16, i16) -> i16) {
    wide(Combine { pixels, apart, of });
}

struct Combine<'a, F> {
    pixels: &'a mut [i16],
    apart: usize,
    of: F,
}

impl<F: Fn(i16, i16) -> i16> Work for Combine<'_, F> {
    #[inline(always)]
    fn run(self) {
        let Self { pixels, apart, of } = self;
        let count = pixels.len().saturating_sub(apart);
        let whole = count - count % LANES;
        for i in (0..whole).step_by(LANES) {
            let mut behind = [0; LANES];
            behind.copy_from_slice(&pixels[i + apart..][..LANES]);
            for (a, b) in pixels[i..][..LANES].iter_mut().zip(behind) {
                *a = of(*a, b);
            }
        }
        for i in whole..count {
            pixels[i] = of(pixels[i], pixels[i + apart]);
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
    use crate::joint::testing::random;

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
