use crate::{Error, Foot, SignedDistance, Surface, error::positive, error::unit};
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
    tube: f64,
}

/// Most Newton steps: even on a line that only touches the torus each step halves what is left.
const MOST_STEPS: usize = 100;

/// A place seen from the ring: all its parts are unit vectors or mm.
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
        let (ring, tube) = (positive("the torus' ring radius", ring)?, positive("the torus' tube radius", tube)?);
        let axis = unit("the torus' axis", axis)?;
        if centre.is_finite() {
            Ok(Self { centre, axis, ring, tube })
        } else {
            Err(Error::Direction { what: "the torus' centre" })
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
        for _ in 0..MOST_STEPS {
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
