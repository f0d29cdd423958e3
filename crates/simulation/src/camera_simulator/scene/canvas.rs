use super::Random;
use glam::DVec2;
use seamwright_vision::Image;
use std::f64::consts::{LN_2, TAU};

/// Grinding texture.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Texture {
    /// Standard deviation of its grey value.
    pub deviation: f64,
    /// Direction of its marks, rad.
    pub direction: f64,
}

/// A point of a line and the line's unit normal there, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrientedPoint {
    /// The point.
    pub point: DVec2,
    /// The normal.
    pub normal: DVec2,
}

/// Disturbances of a whole frame. Grey values are of 255.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Disturbances {
    /// Standard deviation of a pixel's noise.
    pub noise: f64,
    /// Change of brightness from the left rim to the right, and from the upper to the lower: plus and minus these.
    pub ramp: [f64; 2],
    /// Loss of brightness in the corners.
    pub vignette: f64,
    /// Grinding texture.
    pub texture: Texture,
    /// Standard deviation of the shift of scan lines, pixels.
    pub jitter: f64,
    /// Standard deviation of the brightness of scan lines (charging).
    pub charging: f64,
    /// Share of pixels that are black or white.
    pub salt: f64,
    /// Radius of defocus, pixels (of a box, twice).
    pub defocus: usize,
}

/// A frame being painted: metal with darker or brighter objects on it.
#[derive(Debug, Clone)]
pub struct Canvas {
    width: usize,
    height: usize,
    /// Brightness of each pixel without noise.
    light: Vec<f32>,
}

impl Canvas {
    /// Creates metal of brightness `grey` (0 to 255).
    #[must_use]
    pub fn new(width: usize, height: usize, grey: f64) -> Self {
        Self { width, height, light: vec![grey as f32; width * height] }
    }

    /// Darkens along a polyline by `depth`, with a bell across it of full width `width` at half depth, pixels. `part`
    /// gives the share of the depth at each length along it, 0 to 1. The ends are square, half a pixel soft.
    pub fn line(&mut self, points: &[DVec2], width: f64, depth: f64, part: impl Fn(f64) -> f64) {
        let dark = self.bell(points, width, part);
        self.light.iter_mut().zip(dark).for_each(|(l, d)| *l -= depth as f32 * d);
    }

    /// Paints a gap along a polyline like [`Self::line`]: as dark as `grey` in its middle, independent of the light
    /// beside it.
    pub fn gap(&mut self, points: &[DVec2], width: f64, grey: f64) {
        let dark = self.bell(points, width, |_| 1.0);
        self.light.iter_mut().zip(dark).for_each(|(l, d)| *l += (grey as f32 - *l) * d);
    }

    /// Darkens the side of a straight line that its normal points to by `depth`, a pixel soft.
    pub fn step(&mut self, depth: f64, line: OrientedPoint) {
        for (i, light) in self.light.iter_mut().enumerate() {
            let at = DVec2::new((i % self.width) as f64, (i / self.width) as f64);
            *light -= (depth * (((at - line.point).dot(line.normal)).clamp(-1.0, 1.0) * 0.5 + 0.5)) as f32;
        }
    }

    /// Returns the share of a line's depth at each pixel.
    fn bell(&self, points: &[DVec2], width: f64, part: impl Fn(f64) -> f64) -> Vec<f32> {
        // Pieces overlap: the darkest counts at a pixel.
        let mut dark = vec![0.0f32; self.light.len()];
        let mut s = 0.0;
        let reach = 1.4 * width + 1.0;
        for pair in points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let (along, length) = (b - a, a.distance(b));
            let (low, high) = (a.min(b) - reach, a.max(b) + reach);
            let range =
                |low: f64, high: f64, size: usize| low.max(0.0) as usize..((high + 1.0).max(0.0) as usize).min(size);
            for y in range(low.y, high.y, self.height) {
                for x in range(low.x, high.x, self.width) {
                    let off = DVec2::new(x as f64, y as f64) - a;
                    let raw = off.dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
                    let u = raw.clamp(0.0, 1.0);
                    let d = (off - u * along).length() / width;
                    let value = (-4.0 * LN_2 * d * d).exp() * part(s + u * length);
                    let pixel = &mut dark[y * self.width + x];
                    *pixel = pixel.max(value as f32);
                }
            }
            s += length;
        }
        if let [first, second, .., before, last] = points
            && first.distance(*last) > 1.0
        {
            for (end, out) in [(*first, *first - *second), (*last, *last - *before)] {
                self.cut(&mut dark, end, out.normalize_or_zero(), reach);
            }
        }
        dark
    }

    /// Removes the paint beyond an end within `reach` of it.
    fn cut(&self, dark: &mut [f32], end: DVec2, out: DVec2, reach: f64) {
        for (i, dark) in dark.iter_mut().enumerate() {
            let off = DVec2::new((i % self.width) as f64, (i / self.width) as f64) - end;
            if off.abs().max_element() <= 1.5 * reach {
                *dark *= (0.5 - off.dot(out)).clamp(0.0, 1.0) as f32;
            }
        }
    }

    /// Paints a weld of radius `radius` on top: bright with ripples.
    pub fn tack(&mut self, at: DVec2, radius: f64, grey: f64, random: &mut Random) {
        let phase = random.within(0.0, TAU);
        for y in 0..self.height {
            for x in 0..self.width {
                let off = DVec2::new(x as f64, y as f64) - at;
                let d = off.length() / radius;
                if d < 1.0 {
                    let ripple = 10.0 * (0.8 * off.x + phase).sin() * (0.6 * off.y).cos();
                    self.light[y * self.width + x] = (grey + 25.0 * (1.0 - d * d) + ripple) as f32;
                }
            }
        }
    }

    /// Returns the frame with its disturbances, 8 bits. The exposure leaves no black within `reach` of the points
    /// `seen`.
    #[must_use]
    pub fn finish(mut self, d: &Disturbances, seen: &[DVec2], reach: f64, random: &mut Random) -> Image {
        self.light_up(d, seen, reach, random);
        self.take(d, random)
    }

    /// Prepares the light from which the frame is taken.
    pub(super) fn light_up(&mut self, d: &Disturbances, seen: &[DVec2], reach: f64, random: &mut Random) {
        self.shade(d);
        self.expose(seen, reach, 3.0 * d.noise);
        if d.texture.deviation > 0.0 {
            self.grind(d.texture, random);
        }
        for _ in 0..if d.defocus > 0 { 2 } else { 0 } {
            self.blur(d.defocus);
        }
    }

    /// Returns the depth of a point below the lightest one within `reach` along its normal, on the side where that is
    /// smaller. Ramps and vignette are excluded; values above 255 count as white.
    pub(super) fn depth(&self, d: &Disturbances, at: OrientedPoint, reach: f64) -> f64 {
        let most = DVec2::new(self.width as f64 - 1.0, self.height as f64 - 1.0);
        let light = |off: f64| {
            let p = (at.point + off * at.normal).clamp(DVec2::ZERO, most).round();
            let light = self.light[p.y as usize * self.width + p.x as usize];
            f64::from(light.clamp(0.0, 255.0)) - self.shading(d, p)
        };
        let lightest = |side: f64| (1..=reach as usize).map(|off| light(side * off as f64)).fold(f64::MIN, f64::max);
        lightest(1.0).min(lightest(-1.0)) - light(0.0)
    }

    pub(super) fn take(&self, d: &Disturbances, random: &mut Random) -> Image {
        let (width, height) = (self.width, self.height);
        let mut pixels = Vec::with_capacity(width * height);
        for y in 0..height {
            let (shift, charge) = (d.jitter * random.normal(), d.charging * random.normal());
            for x in 0..width {
                let at = (x as f64 + shift).clamp(0.0, (width - 1) as f64);
                let (left, part) = (at as usize, at.fract() as f32);
                let row = &self.light[y * width..(y + 1) * width];
                let grey = row[left] * (1.0 - part) + row[(left + 1).min(width - 1)] * part;
                let grey = f64::from(grey) + charge + d.noise * random.normal();
                let grey = if d.salt > 0.0 && random.chance(d.salt) {
                    255.0 * f64::from(u8::from(random.chance(0.5)))
                } else {
                    grey
                };
                pixels.push(grey.round().clamp(0.0, 255.0) as u8);
            }
        }
        Image::U8 { width, height, pixels }
    }

    fn shade(&mut self, d: &Disturbances) {
        for i in 0..self.light.len() {
            let at = DVec2::new((i % self.width) as f64, (i / self.width) as f64);
            self.light[i] += self.shading(d, at) as f32;
        }
    }

    /// Returns the brightness that ramps and vignette add at a point.
    fn shading(&self, d: &Disturbances, at: DVec2) -> f64 {
        let (u, v) = (2.0 * at.x / self.width as f64 - 1.0, 2.0 * at.y / self.height as f64 - 1.0);
        d.ramp[0] * u + d.ramp[1] * v - d.vignette * 0.5 * (u * u + v * v)
    }

    /// Brightens the whole frame if a point near `places` is darker than `least`.
    fn expose(&mut self, places: &[DVec2], reach: f64, least: f64) {
        let offsets = [DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y].map(|o| reach * o);
        let near = places.iter().flat_map(|p| offsets.map(|o| *p + o));
        let inside = |p: &DVec2| p.min_element() >= 0.0 && p.x < self.width as f64 && p.y < self.height as f64;
        let light = |p: DVec2| self.light[p.y as usize * self.width + p.x as usize];
        let darkest = near.filter(inside).map(light).fold(f32::INFINITY, f32::min);
        let lack = (least as f32 - darkest).max(0.0);
        self.light.iter_mut().for_each(|l| *l += lack);
    }

    /// Paints faint long marks: noise smeared along a direction.
    fn grind(&mut self, texture: Texture, random: &mut Random) {
        const LENGTH: isize = 24;
        let size = self.light.len();
        let noise: Vec<f32> = (0..size).map(|_| random.normal() as f32).collect();
        let (sin, cos) = texture.direction.sin_cos();
        let steps: Vec<(isize, isize)> = (-LENGTH..=LENGTH)
            .map(|k| ((k as f64 * cos).round() as isize, (k as f64 * sin).round() as isize))
            .collect();
        let scale = texture.deviation as f32 / (steps.len() as f32).sqrt();
        let (width, height) = (self.width, self.height);
        let mut sums = vec![0.0f32; width];
        for y in 0..height {
            sums.fill(0.0);
            for (dx, dy) in &steps {
                let row = (y as isize + dy).rem_euclid(height as isize) as usize;
                let (wrapped, rest) = noise[row * width..][..width].split_at(dx.rem_euclid(width as isize) as usize);
                let (first, last) = sums.split_at_mut(rest.len());
                first.iter_mut().zip(rest).chain(last.iter_mut().zip(wrapped)).for_each(|(sum, n)| *sum += n);
            }
            let light = &mut self.light[y * width..][..width];
            light.iter_mut().zip(&sums).for_each(|(light, sum)| *light += scale * sum);
        }
    }

    fn blur(&mut self, radius: usize) {
        let (width, height) = (self.width, self.height);
        let part = 1.0 / (2 * radius + 1) as f32;
        for (count, stride, lines, jump) in [(width, 1, height, width), (height, width, width, 1)] {
            let mut line = vec![0.0; count];
            for l in 0..lines {
                let at = |i: usize| l * jump + i * stride;
                line.iter_mut().enumerate().for_each(|(i, v)| *v = self.light[at(i)]);
                for i in 0..count {
                    let sum: f32 = (0..=2 * radius).map(|k| line[(i + k).saturating_sub(radius).min(count - 1)]).sum();
                    self.light[at(i)] = sum * part;
                }
            }
        }
    }
}
