//! Rows of grey values across a line, interpolated between pixels.

use super::axis::Station;
use super::levels::OF_16_BITS;
use super::strip::{COLS, Line, MID, greater, lesser};
use crate::frame::Size;
use crate::simd::LANES;

/// Fractions of a pixel that positions within a row are counted in.
const PARTS: f32 = (1 << PARTS_BITS) as f32;
const PARTS_BITS: u32 = 15;
/// Maximum side of a picture: products of numbers known to be below it are fast.
const LONGEST: u32 = 0x7fff;
/// Positions are clamped to this distance, pixels.
const FARTHEST: f32 = 60000.0;

/// Pixel type of a picture.
pub(super) trait Pixel: Copy {
    /// Two neighbouring pixels as one number, loaded at once.
    type Pair: Copy + Default;
    /// Combines a pixel with the one to its right.
    fn pair(self, right: Self) -> Self::Pair;
    /// Returns the grey values, 0 to 255, of the left and of the right pixels of pairs.
    fn greys(pairs: &[Self::Pair; LANES]) -> ([f32; LANES], [f32; LANES]);
    fn grey(self) -> f32;
}

impl Pixel for u8 {
    type Pair = u16;
    #[inline(always)]
    fn pair(self, right: Self) -> u16 {
        u16::from_le_bytes([self, right])
    }
    #[inline(always)]
    fn greys(pairs: &[u16; LANES]) -> ([f32; LANES], [f32; LANES]) {
        let pairs = pairs.map(i32::from);
        (pairs.map(|pair| (pair & 0xff) as f32), pairs.map(|pair| (pair >> 8) as f32))
    }
    #[inline(always)]
    fn grey(self) -> f32 {
        f32::from(self)
    }
}

impl Pixel for u16 {
    type Pair = u32;
    #[inline(always)]
    fn pair(self, right: Self) -> u32 {
        u32::from(self) | u32::from(right) << 16
    }
    #[inline(always)]
    fn greys(pairs: &[u32; LANES]) -> ([f32; LANES], [f32; LANES]) {
        let grey = |number: u32| number as i32 as f32 * (1.0 / OF_16_BITS);
        (pairs.map(|pair| grey(pair & 0xffff)), pairs.map(|pair| grey(pair >> 16)))
    }
    #[inline(always)]
    fn grey(self) -> f32 {
        f32::from(self) * (1.0 / OF_16_BITS)
    }
}

impl Pixel for f32 {
    type Pair = u64;
    #[inline(always)]
    fn pair(self, right: Self) -> u64 {
        u64::from(self.to_bits()) | u64::from(right.to_bits()) << 32
    }
    #[inline(always)]
    fn greys(pairs: &[u64; LANES]) -> ([f32; LANES], [f32; LANES]) {
        (pairs.map(|pair| Self::from_bits(pair as u32)), pairs.map(|pair| Self::from_bits((pair >> 32) as u32)))
    }
    #[inline(always)]
    fn grey(self) -> f32 {
        self
    }
}

/// Unrolls rows of a picture of at least two by two pixels.
pub(super) struct Sampler<'a, P: Pixel> {
    pixels: &'a [P],
    width: u32,
    /// The last column and row.
    last: [i32; 2],
    /// Pairs of pixels around each column's position, in the rows above and below it. They are loaded first and
    /// interpolated later, several columns at a time.
    around: [[P::Pair; COLS]; 2],
}

impl<'a, P: Pixel> Sampler<'a, P> {
    pub(super) fn new(pixels: &'a [P], size: Size) -> Self {
        let last = [size.width, size.height].map(|side| side as i32 - 1);
        Self { pixels, width: size.width as u32, last, around: [[P::Pair::default(); COLS]; 2] }
    }

    /// Samples grey values across `station`; beyond the border the border pixels are repeated.
    #[inline(always)]
    pub(super) fn row(&mut self, line: &mut Line, station: &Station) {
        let [right, bottom] = self.last;
        // The last pixels only have neighbours before them.
        let within = |v: i32, last: i32| (v.clamp(0, last << PARTS_BITS), last - 1);
        let places = Places::new(station, 0.0);
        let (mut at, mut parts) = ([0; COLS], [[0; COLS]; 2]);
        let mut place = places.first;
        for j in 0..COLS {
            let ((x, most_left), (y, most_top)) = (within(place[0], right), within(place[1], bottom));
            let (left, top) = ((x >> PARTS_BITS).min(most_left), (y >> PARTS_BITS).min(most_top));
            (parts[0][j], parts[1][j]) = (x - (left << PARTS_BITS), y - (top << PARTS_BITS));
            at[j] = (top as u32 & LONGEST) * (self.width & LONGEST) + left as u32;
            place = places.next(place);
        }
        self.fetch(&at);
        let [us, vs] = parts.each_ref().map(|parts| parts.as_chunks::<LANES>().0);
        let [upper, lower] = self.around.each_ref().map(|pairs| pairs.as_chunks::<LANES>().0);
        let all = us.iter().zip(vs).zip(upper.iter().zip(lower));
        for (values, ((us, vs), (upper, lower))) in line.as_chunks_mut::<LANES>().0.iter_mut().zip(all) {
            let [us, vs] = [us, vs].map(|parts| parts.map(|part| part as f32 * (1.0 / PARTS)));
            let (upper, lower) = (mix(P::greys(upper), &us), mix(P::greys(lower), &us));
            *values = mix((upper, lower), &vs);
        }
    }

    /// Samples the pixels nearest to the positions across `station`.
    #[inline(always)]
    pub(super) fn row_of_nearest(&mut self, line: &mut Line, station: &Station) {
        let [right, bottom] = self.last;
        let places = Places::new(station, 0.5);
        let (mut at, mut place) = ([0; COLS], places.first);
        for at in &mut at {
            let (left, top) = ((place[0] >> PARTS_BITS).clamp(0, right), (place[1] >> PARTS_BITS).clamp(0, bottom));
            *at = (top as u32 & LONGEST) * (self.width & LONGEST) + left as u32;
            place = places.next(place);
        }
        for (value, at) in line.iter_mut().zip(&at) {
            *value = self.pixels[*at as usize].grey();
        }
    }

    /// Loads the pixels at these positions, those to their right, and the ones below both.
    #[inline(always)]
    fn fetch(&mut self, at: &[u32; COLS]) {
        // Slices of equal length for pixels and their neighbours, so that one bounds check is enough.
        let width = self.width as usize;
        let (count, below) = (self.pixels.len() - width - 1, &self.pixels[width..]);
        let [a, b, c, d] = [&self.pixels[..count], &self.pixels[1..=count], &below[..count], &below[1..=count]];
        let [upper, lower] = &mut self.around;
        let pairs = upper.as_chunks_mut::<LANES>().0.iter_mut().zip(lower.as_chunks_mut::<LANES>().0);
        for ((upper, lower), at) in pairs.zip(at.as_chunks::<LANES>().0) {
            for k in 0..LANES {
                let at = at[k] as usize;
                (upper[k], lower[k]) = (a[at].pair(b[at]), c[at].pair(d[at]));
            }
        }
    }
}

/// Interpolates between two values each.
#[inline(always)]
fn mix((from, to): ([f32; LANES], [f32; LANES]), parts: &[f32; LANES]) -> [f32; LANES] {
    std::array::from_fn(|k| from[k] + parts[k] * (to[k] - from[k]))
}

/// Positions across a station in fractions of a pixel, from left to right.
struct Places {
    first: [i32; 2],
    step: [i32; 2],
}

impl Places {
    /// `more`: offset, pixels.
    #[inline(always)]
    fn new(station: &Station, more: f32) -> Self {
        let [cos, sin] = station.tangent;
        let parts = |v: f32| (lesser(greater(v + more, -FARTHEST), FARTHEST) * PARTS) as i32;
        let first = station.beside(-(MID as f32)).map(parts);
        Self { first, step: [-sin, cos].map(|v| (v * PARTS) as i32) }
    }

    #[inline(always)]
    fn next(&self, [x, y]: [i32; 2]) -> [i32; 2] {
        [x + self.step[0], y + self.step[1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::axis::Axis;
    use seamwright_testkit::Random;

    #[test]
    fn rows_are_of_nearest_pixels_and_of_those_around_each_place() {
        let mut random = Random::new(7);
        let (width, height) = (90, 70);
        let pixels: Vec<u8> = (0..width * height).map(|_| random.below(255) as u8).collect();
        let grey = |x: i32, y: i32| {
            let (x, y) = (x.clamp(0, width as i32 - 1) as usize, y.clamp(0, height as i32 - 1) as usize);
            f32::from(pixels[y * width + x])
        };
        let mut sampler = Sampler::new(&pixels, Size { width, height });
        for i in 0..3000 {
            // Beyond the borders too, and far away.
            let far = if i % 10 == 0 { 1e6 } else { 1.0 };
            let at = [far * random.within(-15.0, 105.0) as f32, far * random.within(-15.0, 85.0) as f32];
            let station = Axis { at, heading: random.within(0.0, 7.0) as f32, curvature: 0.0 }.station(0.0);
            let (mut nearest, mut between) = (Line::default(), Line::default());
            sampler.row_of_nearest(&mut nearest, &station);
            sampler.row(&mut between, &station);
            for j in 0..COLS {
                let [x, y] = station.beside(j as f32 - MID as f32);
                // Positions are counted in fractions of a pixel: next to a boundary either side is right.
                let about = |v: f32| [v - 2e-3, v + 2e-3].map(|v| v.round() as i32);
                let near = about(x).into_iter().flat_map(|x| about(y).map(|y| grey(x, y)));
                assert!(near.clone().any(|grey| (grey - nearest[j]).abs() < 0.5), "{x} {y}: {}", nearest[j]);
                let (x, y) = (x.clamp(0.0, width as f32 - 1.0), y.clamp(0.0, height as f32 - 1.0));
                let ((left, top), (u, v)) = ((x.floor() as i32, y.floor() as i32), (x.fract(), y.fract()));
                let upper = grey(left, top) * (1.0 - u) + grey(left + 1, top) * u;
                let lower = grey(left, top + 1) * (1.0 - u) + grey(left + 1, top + 1) * u;
                let wanted = upper * (1.0 - v) + lower * v;
                assert!((between[j] - wanted).abs() < 1.0, "{x} {y}: {} {wanted}", between[j]);
            }
        }
    }
}
