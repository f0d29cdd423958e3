use crate::error::{Error, positive, unit};
use crate::quadric::Surface;
use crate::signed_distance::{Foot, SignedDistance};
use glam::{DMat3, DVec3};

/// A torus: everything within `tube` mm of a circle of radius `ring` about an axis.
///
/// As a [`Surface`] its function is the signed distance in mm, `hypot(rho - ring, z) - tube` with the distance `rho`
/// from the axis and the height `z` along it. Its zeros are those of the torus' quartic, but it does not lose digits
/// with the fourth power of the size.
#[derive(Debug, Clone, PartialEq)]
pub struct Torus {
    centre: DVec3,
    axis: DVec3,
    ring: f64,
    pub(crate) tube: f64,
}

/// Maximum number of Newton steps: each step at least halves the error, even on a tangent line.
const MAX_NEWTON_STEPS: usize = 100;

/// A position relative to the ring, in unit vectors and mm.
struct Seen {
    /// Distance from the axis.
    rho: f64,
    /// Away from the axis.
    out: DVec3,
    /// From the nearest point of the ring: the distance, and the direction (sine along `out`, cosine along the axis).
    distance: f64,
    sin: f64,
    cos: f64,
}

impl Torus {
    /// A torus about the `axis` through `centre`.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`].
    pub fn new(centre: DVec3, axis: DVec3, ring: f64, tube: f64) -> Result<Self, Error> {
        let (ring, tube) =
            (positive("geometry-torus-ring-radius", ring)?, positive("geometry-torus-tube-radius", tube)?);
        let axis = unit("geometry-torus-axis", axis)?;
        if centre.is_finite() {
            Ok(Self { centre, axis, ring, tube })
        } else {
            Err(Error::Direction { what: "geometry-torus-centre" })
        }
    }

    fn seen(&self, p: DVec3) -> Seen {
        let d = p - self.centre;
        let height = d.dot(self.axis);
        let across = d - height * self.axis;
        let rho = across.length();
        let out = if rho > 0.0 { across / rho } else { self.axis.any_orthonormal_vector() };
        let beyond = rho - self.ring;
        let distance = beyond.hypot(height);
        let (sin, cos) = if distance > 0.0 { (beyond / distance, height / distance) } else { (1.0, 0.0) };
        Seen { rho, out, distance, sin, cos }
    }

    /// Height over `foot`, along the unit vector `d`, of the last point of a line on the torus; NaN if the line misses
    /// it.
    ///
    /// Along the line the torus is a quartic `t^4 + c2 t^2 + c1 t + c0`, with `t` from the point nearest to the centre.
    /// It is convex beyond both its points of inflection and concave between them, so that Newton's method or halving
    /// finds the last zero and no other. The torus' own distance then gives back the digits that the fourth powers
    /// cost.
    pub(crate) fn leaves(&self, foot: DVec3, d: DVec3) -> f64 {
        let size = self.ring + self.tube;
        let q = foot - self.centre;
        let nearest = -q.dot(d);
        let m = (q + nearest * d) / size;
        let (ring, tube) = (self.ring / size, self.tube / size);
        let (up, along) = (m.dot(self.axis), d.dot(self.axis));
        let k = m.length_squared() + (ring - tube) * (ring + tube);
        let four = 4.0 * ring * ring;
        let quartic = Quartic {
            c2: 2.0 * k - four * (1.0 - along * along),
            c1: 2.0 * four * up * along,
            c0: k * k - four * (m.length_squared() - up * up),
        };
        let mut h = nearest + size * quartic.last_zero();
        for _ in 0..3 {
            let s = self.seen(foot + h * d);
            let step = (s.distance - self.tube) / (s.sin * s.out + s.cos * self.axis).dot(d);
            // Skip the correction on a tangent line: it would not improve the height.
            if step.abs() < 1e-3 * self.tube {
                h -= step;
            }
        }
        h
    }

    /// Height over `foot`, along the unit vector `d`, at which a line leaves the torus' outer half (farther from the
    /// axis than the ring); NaN where it misses it. Meaningless on lines that leave within the ring.
    ///
    /// The disc inside the ring, thickened by the tube, is convex, and the outer half is a part of its surface. So its
    /// distance along the line is convex: Newton's method from outside goes to the last zero without passing it.
    pub(crate) fn leaves_outer_half(&self, foot: DVec3, d: DVec3) -> f64 {
        let q = foot - self.centre;
        let (reach, b) = (self.ring + self.tube, q.dot(d));
        let (up, along) = (q.dot(self.axis), d.dot(self.axis));
        let (across, sideways) = (q - up * self.axis, d - along * self.axis);
        // From the ball around the torus inwards; not a number if the line misses that.
        let mut h = (b * b - q.length_squared() + reach * reach).sqrt() - b;
        for _ in 0..MAX_NEWTON_STEPS {
            let (v, z) = (across + h * sideways, up + h * along);
            let rho = v.length();
            let beyond = (rho - self.ring).max(0.0);
            let distance = (beyond * beyond + z * z).sqrt();
            let slope = (beyond * v.dot(sideways) / rho + z * along) / distance;
            let next = h - (distance - self.tube) / slope;
            if next < h {
                h = next;
                continue;
            }
            return if distance - self.tube > 1e-9 * reach { f64::NAN } else { h };
        }
        h
    }
}

/// `t^4 + c2 t^2 + c1 t + c0`, all of whose real zeros lie within 1 of 0.
struct Quartic {
    c2: f64,
    c1: f64,
    c0: f64,
}

impl Quartic {
    fn value(&self, t: f64) -> f64 {
        ((t * t + self.c2) * t + self.c1) * t + self.c0
    }

    /// Its largest zero, or NaN without a real zero.
    fn last_zero(&self) -> f64 {
        let bend = (-self.c2 / 6.0).max(0.0).sqrt();
        let outer = self.descend(1.01, if bend > 0.0 { bend } else { f64::NEG_INFINITY });
        if bend == 0.0 || !outer.is_nan() {
            return outer;
        }
        // Positive from the upper point of inflection on; concave down to the lower one.
        let (mut low, mut high) = (-bend, bend);
        if self.value(low) >= 0.0 {
            return self.descend(low, f64::NEG_INFINITY);
        }
        while high - low > 1e-9 {
            let middle = 0.5 * (low + high);
            if self.value(middle) > 0.0 { high = middle } else { low = middle }
        }
        0.5 * (low + high)
    }

    /// The first zero below `from`, not below `to`, in a range where the quartic is convex and positive at `from`:
    /// Newton's method does not pass it.
    fn descend(&self, from: f64, to: f64) -> f64 {
        let mut t = from;
        for _ in 0..MAX_NEWTON_STEPS {
            let (value, slope) = (self.value(t), (4.0 * t * t + 2.0 * self.c2) * t + self.c1);
            if value <= 0.0 {
                return t;
            }
            let next = t - value / slope;
            if slope <= 0.0 || next < to {
                return f64::NAN;
            }
            if next >= t {
                return t;
            }
            t = next;
        }
        t
    }
}

impl Surface for Torus {
    fn value(&self, p: DVec3) -> f64 {
        self.seen(p).distance - self.tube
    }
    fn gradient(&self, p: DVec3) -> DVec3 {
        let s = self.seen(p);
        s.sin * s.out + s.cos * self.axis
    }
    fn hessian(&self, p: DVec3) -> DMat3 {
        let s = self.seen(p);
        // The distance bends around the ring by 1 / distance, and around the axis by sin / rho.
        let meridian = s.cos * s.out - s.sin * self.axis;
        let around = self.axis.cross(s.out);
        let square = |u: DVec3| DMat3::from_cols(u * u.x, u * u.y, u * u.z);
        square(meridian) * (1.0 / s.distance) + square(around) * (s.sin / s.rho)
    }
}

impl SignedDistance for Torus {
    fn foot(&self, p: DVec3) -> Foot {
        Foot { distance: self.value(p), normal: self.gradient(p) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_points_and_derivatives() {
        let o = DVec3::new(10.0, -20.0, 5.0);
        let torus = Torus::new(o, DVec3::Z, 30.0, 8.0).unwrap();
        for p in [DVec3::new(38.0, 0.0, 0.0), DVec3::new(0.0, 22.0, 0.0), DVec3::new(-30.0, 0.0, -8.0)] {
            assert!(torus.value(o + p).abs() < 1e-13);
        }
        let p = o + DVec3::new(12.0, 31.0, 5.0);
        for axis in DVec3::AXES {
            let h = 1e-4;
            let g = (torus.value(p + h * axis) - torus.value(p - h * axis)) / (2.0 * h);
            assert!((g - torus.gradient(p).dot(axis)).abs() < 1e-8);
            let hess = (torus.gradient(p + h * axis) - torus.gradient(p - h * axis)) / (2.0 * h);
            assert!((hess - torus.hessian(p) * axis).length() < 1e-8);
        }
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Torus::new(o, DVec3::Z, bad, 1.0).is_err() && Torus::new(o, DVec3::Z, 1.0, bad).is_err());
        }
        assert!(Torus::new(DVec3::NAN, DVec3::Z, 2.0, 1.0).is_err());
    }
}
