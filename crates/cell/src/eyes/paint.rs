//! A dark joint on lighter metal.

use glam::DVec2;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;

/// Light and noise of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// Grey value of the metal, 0 to 255.
    pub bright: f64,
    /// By how much the joint is darker.
    pub contrast: f64,
    /// Standard deviation of the noise of a pixel.
    pub noise: f64,
    /// How much brighter one rim of the frame is than the other.
    pub ramp: f64,
}

impl Default for Look {
    fn default() -> Self {
        Self { bright: 150.0, contrast: 45.0, noise: 8.0, ramp: 40.0 }
    }
}

/// How dark each pixel is, 0 to 1.
pub(super) struct Canvas {
    width: usize,
    height: usize,
    dark: Vec<f32>,
}

impl Canvas {
    pub(super) fn new((width, height): (usize, usize)) -> Self {
        Self { width, height, dark: vec![0.0; width * height] }
    }

    /// A piece of the joint, `wide` pixels at half of its depth, its profile a bell.
    pub(super) fn line(&mut self, a: DVec2, b: DVec2, wide: f64) {
        let reach = 1.3 * wide + 1.0;
        let clamp = |v: f64, size: usize| v.clamp(0.0, size as f64) as usize;
        let (low, high) = (a.min(b) - reach, a.max(b) + reach + 1.0);
        let along = b - a;
        let length = along.length();
        for y in clamp(low.y, self.height)..clamp(high.y, self.height) {
            for x in clamp(low.x, self.width)..clamp(high.x, self.width) {
                let off = DVec2::new(x as f64, y as f64) - a;
                let part = off.dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
                // Square ends, half a pixel over so that pieces join: the joint ends where it ends.
                if (part - 0.5).abs() * length > 0.5 * length + 0.5 {
                    continue;
                }
                let d = (off - part.clamp(0.0, 1.0) * along).length() / wide;
                let pixel = &mut self.dark[y * self.width + x];
                *pixel = pixel.max((-4.0 * std::f64::consts::LN_2 * d * d).exp() as f32);
            }
        }
    }

    pub(super) fn finish(self, look: &Look, random: &mut Pcg64Mcg) -> Vec<u8> {
        let Self { width, height, dark } = self;
        let mut pixels = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let light = look.bright + look.ramp * (x as f64 / width as f64 + y as f64 / height as f64 - 1.0) * 0.5;
                let grey = light - look.contrast * f64::from(dark[y * width + x]) + look.noise * bell(random);
                pixels.push(grey.round().clamp(0.0, 255.0) as u8);
            }
        }
        pixels
    }
}

/// A number near to normally distributed: the sum of four even ones.
fn bell(random: &mut Pcg64Mcg) -> f64 {
    let bits = random.next_u64();
    let sum: u64 = (0..4).map(|k| bits >> (16 * k) & 0xffff).sum();
    (sum as f64 / 65535.0 - 2.0) * 3f64.sqrt()
}
