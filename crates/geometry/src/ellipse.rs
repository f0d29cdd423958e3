use crate::curve::{Curve, Jet};
use crate::error::{Error, positive, unit};
use glam::DVec3;
use std::f64::consts::TAU;

/// An ellipse in space: `centre + a cos(u) e1 + b sin(u) e2`, `u` the eccentric angle in rad over one turn.
#[derive(Debug, Clone, PartialEq)]
pub struct Ellipse {
    centre: DVec3,
    /// Semi-axis vectors, mm.
    a: DVec3,
    b: DVec3,
}

impl Ellipse {
    /// The ellipse about `centre` in the plane with `normal`, with semi-axis `a` along `a_direction` (made
    /// perpendicular to the normal) and `b` along `normal` x `a_direction`; counter-clockwise seen from the
    /// tip of the normal.
    ///
    /// # Errors
    /// [`Error::Size`] for a semi-axis not greater than 0, [`Error::Direction`] and [`Error::Parallel`] for
    /// directions that span no plane.
    pub fn new(centre: DVec3, normal: DVec3, a_direction: DVec3, a: f64, b: f64) -> Result<Self, Error> {
        positive("geometry-semi-axis-a", a)?;
        positive("geometry-semi-axis-b", b)?;
        let n = unit("geometry-ellipse-normal", normal)?;
        let x = unit("geometry-semi-axis-a-direction", a_direction)?;
        let across = x - x.dot(n) * n;
        if across.length() < 1e-9 {
            return Err(Error::Parallel { first: "geometry-ellipse-normal", second: "geometry-semi-axis-a-direction" });
        }
        let e1 = across.normalize();
        Ok(Self { centre, a: a * e1, b: b * n.cross(e1) })
    }

    /// Centre, mm.
    pub fn centre(&self) -> DVec3 {
        self.centre
    }
}

impl Curve for Ellipse {
    fn domain(&self) -> (f64, f64) {
        (0.0, TAU)
    }
    fn closed(&self) -> bool {
        true
    }
    fn jet(&self, u: f64) -> Jet {
        let (sin, cos) = u.sin_cos();
        let radius = cos * self.a + sin * self.b;
        Jet { point: self.centre + radius, d1: cos * self.b - sin * self.a, d2: -radius }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives() {
        let e = Ellipse::new(DVec3::new(3.0, 1.0, 2.0), DVec3::new(0.1, 0.2, 1.0), DVec3::X, 20.0, 16.0).unwrap();
        crate::curve::testing::check_derivatives(&e, 40.0);
    }

    #[test]
    fn refuses_what_is_no_ellipse() {
        let new = |n, d, a, b| Ellipse::new(DVec3::ZERO, n, d, a, b);
        assert!(matches!(new(DVec3::Z, DVec3::X, 0.0, 1.0), Err(Error::Size { .. })));
        assert!(matches!(new(DVec3::Z, DVec3::X, 1.0, f64::NAN), Err(Error::Size { .. })));
        assert!(matches!(new(DVec3::Z, -DVec3::Z, 1.0, 1.0), Err(Error::Parallel { .. })));
        assert!(matches!(new(DVec3::ZERO, DVec3::X, 1.0, 1.0), Err(Error::Direction { .. })));
    }
}
