use crate::curve::{Curve, Jet};
use crate::error::{Error, positive};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// An arc of a circle in space: `u` is the angle in rad from its start, counter-clockwise about its axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Arc {
    centre: DVec3,
    axis: DVec3,
    start: DVec3,
    sweep: f64,
}

impl Arc {
    /// The arc from `start` about the line through `about` along `axis`, over the angle `sweep` (rad, up to a turn).
    ///
    /// # Errors
    /// [`Error::Size`] if the start lies on the axis or the sweep is not in (0, a turn].
    pub fn new(about: DVec3, axis: DVec3, start: DVec3, sweep: f64) -> Result<Self, Error> {
        let axis = axis.try_normalize().ok_or(Error::Direction { what: "geometry-arc-axis" })?;
        let centre = about + (start - about).dot(axis) * axis;
        positive("geometry-arc-radius", (start - centre).length())?;
        positive("geometry-arc-angle", if sweep <= TAU { sweep } else { -1.0 })?;
        Ok(Self { centre, axis, start: start - centre, sweep })
    }

    /// The arc from `start` through `via` to `end`.
    ///
    /// # Errors
    /// [`Error::Parallel`] if the three points lie on a straight line.
    pub fn through(start: DVec3, via: DVec3, end: DVec3) -> Result<Self, Error> {
        let (a, b) = (via - start, end - start);
        let normal = a.cross(b);
        if normal.length() <= 1e-9 * a.length() * b.length() || a.length() == 0.0 || b.length() == 0.0 {
            return Err(Error::Parallel { first: "geometry-chord-to-via-point", second: "geometry-chord-to-end" });
        }
        // The centre is equidistant from all three points.
        let centre = start
            + (a.length_squared() * b.cross(normal) - b.length_squared() * a.cross(normal))
                / (2.0 * normal.length_squared());
        let axis = normal.normalize();
        let (from, to) = (start - centre, end - centre);
        let angle = axis.dot(from.cross(to)).atan2(from.dot(to)).rem_euclid(TAU);
        Self::new(centre, axis, start, angle)
    }

    /// Unit vector about which the arc runs counter-clockwise.
    pub fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Centre, mm.
    pub fn centre(&self) -> DVec3 {
        self.centre
    }

    /// Radius, mm.
    pub fn radius(&self) -> f64 {
        self.start.length()
    }

    /// The arc that starts `shift` from this one's start and turns with it about the same axis.
    ///
    /// # Errors
    /// As [`Arc::new`].
    pub fn shifted(&self, shift: DVec3) -> Result<Self, Error> {
        Self::new(self.centre, self.axis, self.centre + self.start + shift, self.sweep)
    }
}

impl Curve for Arc {
    fn domain(&self) -> (f64, f64) {
        (0.0, self.sweep)
    }
    fn jet(&self, u: f64) -> Jet {
        let out = DQuat::from_axis_angle(self.axis, u) * self.start;
        Jet { point: self.centre + out, d1: self.axis.cross(out), d2: -out }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_through_its_points() {
        for k in 0..500 {
            let f = |i: f64| (f64::from(k) * 0.731 + i * 1.93).sin() * 100.0;
            let [p, q, r] = [0.0, 3.0, 6.0].map(|i| DVec3::new(f(i), f(i + 1.0), f(i + 2.0)));
            let arc = Arc::through(p, q, r).unwrap();
            let end = arc.domain().1;
            let scale = arc.start.length();
            assert!((arc.point(0.0) - p).length() < 1e-9 * scale && (arc.point(end) - r).length() < 1e-9 * scale);
            let nearest = (0..=2000).map(|i| (arc.point(end * f64::from(i) / 2000.0) - q).length());
            assert!(nearest.fold(f64::INFINITY, f64::min) < scale * end / 1000.0);
        }
        let (a, b) = (DVec3::X, DVec3::new(3.0, 0.0, 0.0));
        assert!(Arc::through(DVec3::ZERO, a, b).is_err());
        assert!(Arc::new(DVec3::ZERO, DVec3::Z, DVec3::Z, 1.0).is_err());
        assert!(Arc::new(DVec3::ZERO, DVec3::Z, DVec3::X, 7.0).is_err());
    }

    #[test]
    fn derivatives_are_right() {
        let arc = Arc::new(DVec3::Y, DVec3::new(1.0, 1.0, 0.0), DVec3::new(3.0, -4.0, 9.0), 5.0).unwrap();
        crate::curve::testing::check_derivatives(&arc, 14.0);
        let shifted = arc.shifted(2.0 * arc.axis()).unwrap();
        assert!((shifted.point(1.3) - arc.point(1.3) - 2.0 * arc.axis()).length() < 1e-12);
    }
}
