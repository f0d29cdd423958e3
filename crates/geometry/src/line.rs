use crate::curve::{Curve, Jet};
use crate::error::{Error, positive};
use glam::DVec3;

/// A straight line from one point to another, parametrised by length: `u` in mm from 0 to the line's length.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    start: DVec3,
    direction: DVec3,
    length: f64,
}

impl Line {
    /// The line from `start` to `end`, mm.
    ///
    /// # Errors
    /// [`Error::Size`] if the two points are equal or not finite.
    pub fn new(start: DVec3, end: DVec3) -> Result<Self, Error> {
        let length = positive("geometry-line-length", (end - start).length())?;
        Ok(Self { start, direction: (end - start) / length, length })
    }
}

impl Curve for Line {
    fn domain(&self) -> (f64, f64) {
        (0.0, self.length)
    }
    fn jet(&self, u: f64) -> Jet {
        Jet { point: self.start + u * self.direction, d1: self.direction, d2: DVec3::ZERO }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives() {
        let line = Line::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(4.0, -2.0, 3.0)).unwrap();
        crate::curve::testing::check_derivatives(&line, 5.0);
        assert!((line.point(5.0) - DVec3::new(4.0, -2.0, 3.0)).length() < 1e-15);
    }

    #[test]
    fn a_point_is_no_line() {
        assert!(Line::new(DVec3::ONE, DVec3::ONE).is_err());
        assert!(Line::new(DVec3::ONE, DVec3::NAN).is_err());
    }
}
