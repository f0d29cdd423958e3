use crate::method::Method;
use crate::path::Path;
use crate::request::Request;
use crate::shape::Shape;
use glam::DVec2;
use seamwright_geometry::Curve;
use std::f64::consts::TAU;

pub(crate) fn pulses(method: Method, shape: Shape, pulse_mm: f64) -> Request {
    Request { shape, method, speed_mm_s: 0.1, period_s: 0.1, pulse_mm }
}

/// A small seeded generator (Knuth's 64-bit linear congruence), so that tests repeat.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Evenly distributed logarithm.
    pub(crate) fn log(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// An ellipse's arc of any start, end and direction; every fourth is a full turn.
    pub(crate) fn ellipse(&mut self, smallest: f64, largest: f64) -> Shape {
        let (a, b) = (self.between(smallest, largest), self.between(smallest, largest));
        let point = |u: f64| DVec2::new(a * u.cos(), b * u.sin());
        let start_mm = point(self.between(0.0, TAU));
        let end_mm = Some(point(self.between(0.0, TAU))).filter(|_| self.unit() > 0.25);
        Shape::Ellipse { a_mm: a, b_mm: b, start_mm, end_mm, clockwise: self.unit() < 0.5 }
    }

    /// A saddle with radii in a ratio of at most `ratio`, of any start and direction, up to one and a half turns.
    pub(crate) fn saddle(&mut self, smallest: f64, largest: f64, ratio: f64) -> Shape {
        let nozzle = self.between(smallest, largest);
        let sweep = self.between(0.3, 1.5 * TAU) * if self.unit() < 0.5 { -1.0 } else { 1.0 };
        Shape::Saddle {
            nozzle_radius_mm: nozzle,
            shell_radius_mm: nozzle / self.between(0.1, ratio),
            start_rad: self.between(0.0, TAU),
            sweep_rad: sweep,
        }
    }
}

/// Arc length between two travelled angles: ten-point Gauss-Legendre on halves until it settles. Independent of the
/// Chebyshev series of [`seamwright_geometry::ByLength`].
pub(crate) fn arc(path: &Path, from: f64, to: f64) -> f64 {
    fn gauss(path: &Path, l: f64, r: f64) -> f64 {
        const X: [f64; 5] = [
            0.148_874_338_981_631_2,
            0.433_395_394_129_247_2,
            0.679_409_568_299_024_4,
            0.865_063_366_688_984_5,
            0.973_906_528_517_171_7,
        ];
        const W: [f64; 5] = [
            0.295_524_224_714_752_9,
            0.269_266_719_309_996_3,
            0.219_086_362_515_982_04,
            0.149_451_349_150_580_6,
            0.066_671_344_308_688_14,
        ];
        let (m, h) = (0.5 * (l + r), 0.5 * (r - l));
        (0..5).map(|i| W[i] * (path.speed(m - h * X[i]) + path.speed(m + h * X[i]))).sum::<f64>() * h
    }
    fn halve(path: &Path, l: f64, r: f64, whole: f64, depth: u32) -> f64 {
        let m = 0.5 * (l + r);
        let (a, b) = (gauss(path, l, m), gauss(path, m, r));
        if depth == 0 || (a + b - whole).abs() < 1e-14 * whole {
            a + b
        } else {
            halve(path, l, m, a, depth - 1) + halve(path, m, r, b, depth - 1)
        }
    }
    halve(path, from, to, gauss(path, from, to), 30)
}
