use crate::{Curve, Ellipse, Error, Jet, error::positive};
use glam::DVec3;

/// A circle in space, counter-clockwise about its normal: `u` is the angle in rad over one turn.
#[derive(Debug, Clone, PartialEq)]
pub struct Circle(Ellipse);

impl Circle {
    /// The circle of `radius` (mm) about `centre`, starting (`u = 0`) on the side of `zero_direction`.
    ///
    /// # Errors
    /// As [`Ellipse::new`].
    pub fn new(centre: DVec3, normal: DVec3, zero_direction: DVec3, radius: f64) -> Result<Self, Error> {
        positive("the circle's radius", radius)?;
        Ellipse::new(centre, normal, zero_direction, radius, radius).map(Self)
    }
}

impl Curve for Circle {
    fn domain(&self) -> (f64, f64) {
        self.0.domain()
    }
    fn closed(&self) -> bool {
        true
    }
    fn jet(&self, u: f64) -> Jet {
        self.0.jet(u)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_at_the_radius() {
        let c = Circle::new(DVec3::Y, DVec3::new(1.0, 1.0, 0.0), DVec3::Z, 7.0).unwrap();
        crate::curve::testing::check_derivatives(&c, 14.0);
        for i in 0..100 {
            let p = c.point(f64::from(i) * 0.1);
            assert!(((p - DVec3::Y).length() - 7.0).abs() < 1e-14);
        }
    }
}
