use crate::path::{Base, Path};
use glam::DVec3;
use seamwright_geometry::Curve;
use std::f64::consts::FRAC_PI_2;

/// Maximum number of fraction bits of a size counted in pulses.
const FRACTION_BITS: u32 = 16;

/// A path on the lattice of whole pulses, in integers: sizes, ends and the deviation functions, all free of drift.
///
/// Sizes are rounded to 2^-k pulse, k = 16 or the number of bits that keeps a size below 2^29 (k >= 1 at the maximum
/// number of pulses). A clockwise path is mirrored (y to -y), so that the rules handle only counter-clockwise motion.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pulse_mm: f64,
    mirror: i64,
    fraction: u32,
    /// Semi-axes seen along z, in 2^-k pulse, squared.
    a2: i128,
    b2: i128,
    /// `a^2 b^2` in the units of `a2` times pulses squared.
    constant: i128,
    /// Saddle: `R^2` and `R^2 - r^2` in 2^-2k pulses squared.
    shell: Option<(i128, i128)>,
    /// Lattice points nearest to the path's ends, in pulses.
    pub(crate) start: [i64; 3],
    pub(crate) end: [i64; 3],
    /// Number of changes of the path from one quadrant to the next.
    pub(crate) crossings: u32,
}

impl Grid {
    /// Builds the lattice of a checked path: semi-axes of at least 4 pulses and sizes up to 2^28 pulses.
    pub(crate) fn new(path: &Path, pulse_mm: f64) -> Self {
        let size = path.size() / pulse_mm;
        let fraction = FRACTION_BITS.min((28.0 - size.log2().floor()).max(0.0) as u32);
        let count = |mm: f64| (mm / pulse_mm * f64::from(1u32 << fraction)).round() as i128;
        let (a, b) = path.plan_axes();
        let (a2, b2) = (count(a).pow(2), count(b).pow(2));
        let shell = match &path.base {
            Base::Ellipse { .. } => None,
            Base::Saddle { shell, .. } => Some((count(*shell).pow(2), count(*shell).pow(2) - a2)),
        };
        let mirror = if path.direction() < 0.0 { -1 } else { 1 };
        let lattice = |travelled: f64| {
            let p = (Curve::point(path, travelled) / pulse_mm).round();
            [p.x as i64, mirror * p.y as i64, p.z as i64]
        };
        let (start, end) = (lattice(0.0), lattice(path.span_rad()));
        let crossings = crossings(leaving(start), arriving(end), path.span_rad());
        let constant = (a2 * b2) >> (2 * fraction);
        Self { pulse_mm, mirror, fraction, a2, b2, constant, shell, start, end, crossings }
    }

    pub(crate) fn position(&self, at: [i64; 3]) -> DVec3 {
        DVec3::new(at[0] as f64, (self.mirror * at[1]) as f64, at[2] as f64) * self.pulse_mm
    }

    /// `a^2` and `b^2`, up to a common factor.
    pub(crate) fn squares(&self) -> (i128, i128) {
        (self.a2, self.b2)
    }

    /// Four times the deviation function `F = b^2 x^2 + a^2 y^2 - a^2 b^2` at a point given in half pulses: negative
    /// inside the ellipse, positive outside. F is twice the sum of the integrals of `b^2 x dx` and `a^2 y dy` from a
    /// point of the ellipse to this one.
    pub(crate) fn deviation_at_half_pulses(&self, x: i64, y: i64) -> i128 {
        self.b2 * i128::from(x).pow(2) + self.a2 * i128::from(y).pow(2) - 4 * self.constant
    }

    /// The same at a lattice point.
    pub(crate) fn deviation(&self, at: [i64; 3]) -> i128 {
        self.deviation_at_half_pulses(2 * at[0], 2 * at[1])
    }

    /// True if x is the faster axis: the ellipse's tangent is closer to the x axis.
    pub(crate) fn x_is_faster(&self, at: [i64; 3]) -> bool {
        self.b2 * i128::from(at[0].abs()) < self.a2 * i128::from(at[1].abs())
    }

    /// The pulse of z, -1, 0 or 1, that brings z nearest to the saddle over the lattice point. It is the third
    /// comparison: of `z^2` with `R^2 - y^2` if y is the faster axis, else with `R^2 - r^2 + x^2`, which is equal on
    /// the circle. The faster axis gives the most accurate position along the path.
    pub(crate) fn height_pulse(&self, at: [i64; 3]) -> i64 {
        let Some((shell2, difference)) = self.shell else { return 0 };
        let square = |v: i64| i128::from(v).pow(2) << (2 * self.fraction);
        let wanted = if self.x_is_faster(at) { difference + square(at[0]) } else { shell2 - square(at[1]) };
        let z = at[2];
        if square(2 * z + 1) <= 4 * wanted {
            1
        } else if z > 0 && square(2 * z - 1) > 4 * wanted {
            -1
        } else {
            0
        }
    }
}

/// Quadrant 0..4 in which a counter-clockwise path leaves a point; on an axis the next one.
pub(crate) fn leaving(at: [i64; 3]) -> u32 {
    let [x, y, _] = at;
    if x > 0 && y >= 0 {
        0
    } else if x <= 0 && y > 0 {
        1
    } else if x < 0 {
        2
    } else {
        3
    }
}

/// Quadrant in which a counter-clockwise path arrives at a point; on an axis the previous one.
fn arriving(at: [i64; 3]) -> u32 {
    // Arrival is the mirror image of leaving, a quarter turn back.
    let [x, y, z] = at;
    3 - leaving([x, -y, z])
}

/// Number of quadrant changes of a path from quadrant `from` to quadrant `to` over the angle `span`.
fn crossings(from: u32, to: u32, span: f64) -> u32 {
    let least = (4 + to - from) % 4;
    // The angle is within a quarter turn of the crossings' own; whole turns are four crossings.
    let turns = ((span / FRAC_PI_2 - f64::from(least)) / 4.0).round();
    (turns * 4.0 + f64::from(least)).max(0.0) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadrants_of_points_on_the_axes() {
        let at = |x, y| [x, y, 0];
        assert_eq!([at(5, 0), at(0, 5), at(-5, 0), at(0, -5)].map(leaving), [0, 1, 2, 3]);
        assert_eq!([at(5, 0), at(0, 5), at(-5, 0), at(0, -5)].map(arriving), [3, 0, 1, 2]);
        for (x, y, q) in [(3, 4, 0), (-3, 4, 1), (-3, -4, 2), (3, -4, 3)] {
            assert_eq!((leaving(at(x, y)), arriving(at(x, y))), (q, q));
        }
    }

    #[test]
    fn crossings_of_arcs() {
        let q = FRAC_PI_2;
        assert_eq!(crossings(0, 0, 0.9 * q), 0);
        assert_eq!(crossings(0, 0, 3.1 * q), 4);
        assert_eq!(crossings(0, 3, 4.0 * q), 3);
        assert_eq!(crossings(1, 0, 4.0 * q), 3);
        assert_eq!(crossings(1, 0, 8.0 * q), 7);
        assert_eq!(crossings(1, 1, 4.0 * q), 4);
        assert_eq!(crossings(3, 0, 0.01 * q), 1);
        // Both ends round to the same point on an axis.
        assert_eq!(crossings(1, 0, 0.001 * q), 0);
    }
}
