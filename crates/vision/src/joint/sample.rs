//! Rows of grey values across a line, between pixels.

use super::axis::Station;
use super::levels::OF_16_BITS;
use super::strip::{COLS, Line, MID, greater, lesser};

/// Places within a row are counted in these parts of a pixel.
const PARTS: f32 = 65536.0;
/// No side of a picture is longer: products of numbers that are sure to be below it are fast.
const LONGEST: u32 = 0x7fff;

/// What a picture is made of.
pub(super) trait Pixel: Copy {
    /// Grey values, 0 to 255, of a square of four.
    fn greys(square: [Self; 4]) -> [f32; 4];
    /// The grey value of one.
    fn grey(self) -> f32;
}

impl Pixel for u8 {
    #[inline(always)]
    fn greys(square: [Self; 4]) -> [f32; 4] {
        // Taken apart as one number, several of them at a time.
        let all = u32::from_le_bytes(square);
        [all & 0xff, all >> 8 & 0xff, all >> 16 & 0xff, all >> 24].map(|grey| grey as i32 as f32)
    }
    #[inline(always)]
    fn grey(self) -> f32 {
        f32::from(self)
    }
}

impl Pixel for u16 {
    #[inline(always)]
    fn greys(square: [Self; 4]) -> [f32; 4] {
        square.map(|p| f32::from(p) * (1.0 / OF_16_BITS))
    }
    #[inline(always)]
    fn grey(self) -> f32 {
        f32::from(self) * (1.0 / OF_16_BITS)
    }
}

impl Pixel for f32 {
    #[inline(always)]
    fn greys(square: [Self; 4]) -> [f32; 4] {
        square
    }
    #[inline(always)]
    fn grey(self) -> f32 {
        self
    }
}

/// Unrolls rows of a picture of at least two by two pixels.
pub(super) struct Sampler<'a, P> {
    pixels: &'a [P],
    width: usize,
    right: f32,
    bottom: f32,
    /// The four pixels around each column's place, first fetched, then mixed: mixing is done for several columns at a time.
    around: [[P; 4]; COLS],
}

impl<'a, P: Pixel> Sampler<'a, P> {
    pub(super) fn new(pixels: &'a [P], (width, height): (usize, usize)) -> Self {
        let (right, bottom) = ((width - 1) as f32, (height - 1) as f32);
        Self { pixels, width, right, bottom, around: [[pixels[0]; 4]; COLS] }
    }

    /// Grey values across `station`.
    #[inline(always)]
    pub(super) fn row(&mut self, line: &mut Line, station: &Station) {
        let (right, bottom) = (self.right - 0.5, self.bottom - 0.5);
        let ends = [0, COLS - 1].map(|j| station.beside(j as f32 - MID as f32));
        if ends.iter().all(|[x, y]| *x > 0.5 && *y > 0.5 && *x < right && *y < bottom) {
            self.inside(line, station);
        } else {
            self.at_rim(line, station);
        }
    }

    /// The pixels that are nearest to the places across `station`.
    #[inline(always)]
    pub(super) fn row_of_nearest(&mut self, line: &mut Line, station: &Station) {
        let mut at = [0; COLS];
        let row = self.width as u32 & LONGEST;
        let ends = [0, COLS - 1].map(|j| station.beside(j as f32 - MID as f32));
        if ends.iter().all(|[x, y]| *x >= 0.0 && *y >= 0.0 && *x <= self.right && *y <= self.bottom) {
            let [cos, sin] = station.tangent;
            let [mut x, mut y] = station.beside(-(MID as f32)).map(|v| ((v + 0.5) * PARTS) as i32);
            let [step_x, step_y] = [-sin, cos].map(|v| (v * PARTS) as i32);
            for at in &mut at {
                *at = (y as u32 >> 16 & LONGEST) * row + (x as u32 >> 16);
                (x, y) = (x + step_x, y + step_y);
            }
        } else {
            for (j, at) in at.iter_mut().enumerate() {
                let [x, y] = station.beside(j as f32 - MID as f32).map(|v| v + 0.5);
                let left = lesser(greater(x, 0.0), self.right) as i32;
                let top = lesser(greater(y, 0.0), self.bottom) as i32;
                *at = (top as u32 & LONGEST) * row + left as u32;
            }
        }
        for (value, at) in line.iter_mut().zip(&at) {
            *value = self.pixels[*at as usize].grey();
        }
    }

    /// Fetches the pixels at these places, those to their right, and the ones below both.
    #[inline(always)]
    fn fetch(&mut self, at: &[u32; COLS]) {
        // Those that have others to their right and below, and the others: of one length, so that one check is enough.
        let (count, below) = (self.pixels.len() - self.width - 1, &self.pixels[self.width..]);
        let [a, b, c, d] = [&self.pixels[..count], &self.pixels[1..=count], &below[..count], &below[1..=count]];
        for (around, at) in self.around.iter_mut().zip(at) {
            let at = *at as usize;
            *around = [a[at], b[at], c[at], d[at]];
        }
    }

    /// A row that lies within the picture.
    #[inline(always)]
    fn inside(&mut self, line: &mut Line, station: &Station) {
        let [cos, sin] = station.tangent;
        let [x0, y0] = station.beside(-(MID as f32)).map(|v| (v * PARTS) as i32);
        let [step_x, step_y] = [-sin, cos].map(|v| (v * PARTS) as i32);
        let row = self.width as u32 & LONGEST;
        let (mut at, mut x, mut y) = ([0; COLS], x0, y0);
        for at in &mut at {
            *at = (y as u32 >> 16 & LONGEST) * row + (x as u32 >> 16);
            (x, y) = (x + step_x, y + step_y);
        }
        self.fetch(&at);
        (x, y) = (x0, y0);
        for (value, around) in line.iter_mut().zip(&self.around) {
            let [u, v] = [x, y].map(|v| (v & 0xffff) as f32 * (1.0 / PARTS));
            let [a, b, c, d] = P::greys(*around);
            let (upper, lower) = (a + u * (b - a), c + u * (d - c));
            *value = upper + v * (lower - upper);
            (x, y) = (x + step_x, y + step_y);
        }
    }

    /// A row that touches the picture's rim, beyond which the rim goes on.
    #[inline(always)]
    fn at_rim(&mut self, line: &mut Line, station: &Station) {
        let place = |j: usize| {
            let [x, y] = station.beside(j as f32 - MID as f32);
            let within = [lesser(greater(x, 0.0), self.right), lesser(greater(y, 0.0), self.bottom)];
            // The last pixels have others before them only.
            let [left, top] =
                [lesser(within[0], self.right - 1.0), lesser(within[1], self.bottom - 1.0)].map(|v| v as i32);
            ([left, top], [within[0] - left as f32, within[1] - top as f32])
        };
        let row = self.width as u32 & LONGEST;
        let mut at = [0; COLS];
        let mut parts = [[0.0; COLS]; 2];
        for (j, at) in at.iter_mut().enumerate() {
            let ([left, top], [u, v]) = place(j);
            (parts[0][j], parts[1][j]) = (u, v);
            *at = (top as u32 & LONGEST) * row + left as u32;
        }
        self.fetch(&at);
        for (j, (value, around)) in line.iter_mut().zip(&self.around).enumerate() {
            let (u, v) = (parts[0][j], parts[1][j]);
            let [a, b, c, d] = P::greys(*around);
            let (upper, lower) = (a * (1.0 - u) + b * u, c * (1.0 - u) + d * u);
            *value = upper * (1.0 - v) + lower * v;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::axis::Axis;
    use crate::testing::random;

    #[test]
    fn rows_are_of_nearest_pixels_and_of_those_around_each_place() {
        let mut random = random();
        let (width, height) = (90, 70);
        let pixels: Vec<u8> = (0..width * height).map(|_| (255.0 * random()) as u8).collect();
        let grey = |x: i32, y: i32| {
            let (x, y) = (x.clamp(0, width as i32 - 1) as usize, y.clamp(0, height as i32 - 1) as usize);
            f32::from(pixels[y * width + x])
        };
        let mut sampler = Sampler::new(&pixels, (width, height));
        for _ in 0..3000 {
            // Over the rims too.
            let at = [90.0 * random(), 70.0 * random()];
            let station = Axis { at, heading: 7.0 * random(), curvature: 0.0 }.station(0.0);
            let (mut nearest, mut between) = ([0.0; COLS], [0.0; COLS]);
            sampler.row_of_nearest(&mut nearest, &station);
            sampler.row(&mut between, &station);
            for j in 0..COLS {
                let [x, y] = station.beside(j as f32 - MID as f32);
                // Places are counted in parts of a pixel: next to a border either side is right.
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
