use crate::curve::{Curve, Jet};
use crate::edge::{Edge, EdgePoint};
use crate::error::Error;
use crate::quadric::{Quadric, Surface};
use crate::signed_distance::{Ball, Foot, QuadricDistance, SignedDistance, way_out};
use crate::tube::Tube;
use crate::tube_intersection::check_margin;
use glam::{DMat3, DVec3};
use std::f64::consts::TAU;

/// The surface everywhere `depth` mm below an ellipsoid: the inside of a wall of this thickness. It is no quadric.
#[derive(Debug, Clone, PartialEq)]
pub struct ParallelSurface {
    ellipsoid: Quadric,
    distance: QuadricDistance,
    depth: f64,
    /// Radius of a ball about the centre that contains it.
    ball: f64,
}

impl ParallelSurface {
    /// The surface below the ellipsoid with the semi-axes `semi` (mm) along `x_direction`, `z_direction` x `x_direction`
    /// and `z_direction`.
    ///
    /// # Errors
    /// Those of [`Quadric::ellipsoid`]; [`Error::Range`] if it would have an edge: `depth` is not less than the minimum
    /// radius of curvature, the square of the smallest semi-axis by the largest.
    pub fn below_ellipsoid(
        centre: DVec3,
        z_direction: DVec3,
        x_direction: DVec3,
        semi: DVec3,
        depth: f64,
    ) -> Result<Self, Error> {
        let ellipsoid = Quadric::ellipsoid(centre, z_direction, x_direction, semi)?;
        let most = semi.min_element().powi(2) / semi.max_element();
        if !(depth >= 0.0 && depth < most) {
            return Err(Error::Range { what: "geometry-wall-of-ellipsoid", value: depth, min: 0.0, max: most });
        }
        let distance = QuadricDistance::new(&ellipsoid);
        Ok(Self { ellipsoid, distance, depth, ball: semi.max_element() })
    }

    /// Hessian of the distance at a point `p` with this foot.
    ///
    /// Along a normal the curvatures of parallel surfaces are `k / (1 + d k)`, d mm outside of the ellipsoid.
    fn hessian(&self, p: DVec3, foot: Foot) -> DMat3 {
        let outside = foot.distance - self.depth;
        let on_ellipsoid = p - outside * foot.normal;
        let gradient = self.ellipsoid.gradient(on_ellipsoid);
        let n = foot.normal;
        let tangential = DMat3::IDENTITY - DMat3::from_cols(n * n.x, n * n.y, n * n.z);
        let bend = tangential * self.ellipsoid.hessian(on_ellipsoid) * tangential * (1.0 / gradient.length());
        bend * (DMat3::IDENTITY + outside * bend).inverse()
    }

    /// Height over `foot` at which the line along the unit vector `d` leaves the body; NaN if it does not meet it.
    fn leaves(&self, foot: DVec3, d: DVec3) -> f64 {
        let ball = Ball { centre: self.ellipsoid.centre, radius: self.ball };
        way_out(self, ball, foot, d).unwrap_or(f64::NAN)
    }
}

impl SignedDistance for ParallelSurface {
    fn foot(&self, p: DVec3) -> Foot {
        let foot = self.distance.foot(p);
        Foot { distance: foot.distance + self.depth, ..foot }
    }
}

/// The curve where a tube's wall leaves a [`ParallelSurface`], parametrised by the angle about the tube's axis (rad).
/// Derivatives follow from differentiating the distance along it, so they are exact.
#[derive(Debug, Clone, PartialEq)]
pub struct ParallelIntersection {
    tube: Tube,
    body: ParallelSurface,
}

impl ParallelIntersection {
    /// The closed curve where `tube` leaves `body`.
    ///
    /// # Errors
    /// [`Error::TubeLargerThanBody`], [`Error::TubeBesideBody`], [`Error::NotClosed`] or [`Error::Tangent`] if the curve
    /// does not exist or is not closed and smooth.
    pub fn new(tube: Tube, body: ParallelSurface) -> Result<Self, Error> {
        let curve = Self::unchecked(tube, body);
        let steepness = |phi: f64| {
            let EdgePoint { point, n2, .. } = curve.edge(phi);
            if point.is_nan() { -1.0 } else { n2.dot(curve.tube.e3).powi(2) }
        };
        let axis_meets = !curve.body.leaves(curve.tube.origin, curve.tube.e3).is_nan();
        check_margin(&steepness, axis_meets)?;
        Ok(curve)
    }

    /// The unchecked curve, of which only a part is used.
    pub(crate) fn unchecked(tube: Tube, body: ParallelSurface) -> Self {
        Self { tube, body }
    }
}

impl Curve for ParallelIntersection {
    fn domain(&self) -> (f64, f64) {
        (0.0, TAU)
    }
    fn closed(&self) -> bool {
        true
    }
    /// Differentiating the distance along the curve twice.
    fn jet(&self, phi: f64) -> Jet {
        let EdgePoint { point, d1, n1, n2 } = self.edge(phi);
        let w2 = -self.tube.radius * n1;
        let bend = d1.dot(self.body.hessian(point, self.body.foot(point)) * d1) + n2.dot(w2);
        Jet { point, d1, d2: w2 - bend / n2.dot(self.tube.e3) * self.tube.e3 }
    }
    fn point(&self, phi: f64) -> DVec3 {
        self.edge(phi).point
    }
    fn speed(&self, phi: f64) -> f64 {
        self.edge(phi).d1.length()
    }
}

impl Edge for ParallelIntersection {
    fn edge(&self, phi: f64) -> EdgePoint {
        let (foot, n1, around) = self.tube.wall(phi);
        let e3 = self.tube.e3;
        let point = foot + self.body.leaves(foot, e3) * e3;
        let n2 = self.body.foot(point).normal;
        let w1 = self.tube.radius * around;
        EdgePoint { point, d1: w1 - n2.dot(w1) / n2.dot(e3) * e3, n1, n2 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tube(origin: DVec3, direction: DVec3, radius: f64) -> Tube {
        Tube::new(origin, direction, direction.any_orthonormal_vector(), radius).unwrap()
    }

    #[test]
    fn below_a_ball_it_is_a_smaller_ball() {
        let ball =
            ParallelSurface::below_ellipsoid(DVec3::ZERO, DVec3::Z, DVec3::X, DVec3::splat(500.0), 20.0).unwrap();
        let stand = tube(DVec3::new(90.0, 40.0, 0.0), DVec3::new(0.3, -0.2, 1.0).normalize(), 80.0);
        let curve = ParallelIntersection::new(stand.clone(), ball).unwrap();
        let exact = crate::TubeIntersection::new(stand, Quadric::sphere(DVec3::ZERO, 480.0).unwrap()).unwrap();
        for i in 0..100 {
            let phi = 0.0628 * f64::from(i);
            let (a, b) = (curve.jet(phi), exact.jet(phi));
            assert!(a.point.distance(b.point) < 1e-9 && a.d1.distance(b.d1) < 1e-9 && a.d2.distance(b.d2) < 1e-8);
        }
    }

    #[test]
    fn the_inside_of_a_2_1_head_is_a_thickness_below_its_outside_with_exact_derivatives() {
        let semi = DVec3::new(600.0, 600.0, 300.0);
        let body = ParallelSurface::below_ellipsoid(DVec3::ZERO, DVec3::Z, DVec3::X, semi, 16.0).unwrap();
        let outside = QuadricDistance::new(&Quadric::ellipsoid(DVec3::ZERO, DVec3::Z, DVec3::X, semi).unwrap());
        for (x, tilt) in [(0.0, 0.0), (250.0, 0.2), (430.0, 0.5)] {
            let stand = tube(DVec3::new(x, 0.0, 0.0), DVec3::new(tilt, 0.1, 1.0).normalize(), 84.0);
            let curve = ParallelIntersection::new(stand, body.clone()).unwrap();
            for i in 0..200 {
                let phi = 0.0314 * f64::from(i);
                let jet = curve.jet(phi);
                assert!((outside.foot(jet.point).distance + 16.0).abs() < 1e-9);
                let h = 1e-4;
                let [before, after] = [-h, h].map(|h| curve.jet(phi + h));
                assert!(((after.point - before.point) / (2.0 * h)).distance(jet.d1) < 1e-5);
                assert!(((after.d1 - before.d1) / (2.0 * h)).distance(jet.d2) < 1e-5);
            }
        }
    }

    #[test]
    fn a_wall_thicker_than_the_knuckle_is_refused() {
        let semi = DVec3::new(600.0, 600.0, 300.0);
        let at = |depth| ParallelSurface::below_ellipsoid(DVec3::ZERO, DVec3::Z, DVec3::X, semi, depth);
        assert!(at(149.0).is_ok());
        assert!(matches!(at(150.0), Err(Error::Range { .. })));
    }
}
