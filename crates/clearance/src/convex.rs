//! The distance of two convex bodies: parry's iteration finds a direction, a plane across it proves the distance. Only
//! this module uses parry.

use glam::DVec3;
use parry3d_f64::math::Pose;
use parry3d_f64::query::gjk::{CsoPoint, GJKResult, VoronoiSimplex, closest_points};
use parry3d_f64::shape::SupportMap;

/// A convex core with everything within `radius` of it. Round bodies have small cores (a sphere's is a point), on
/// which the iteration is exact after a few steps.
pub(crate) trait Convex {
    /// The farthest point of the core in a direction of any length.
    fn support(&self, direction: DVec3) -> DVec3;
    /// Radius around the core.
    fn radius(&self) -> f64;
    /// A lower bound of the distance of a point to the core, quick to compute.
    fn at_least(&self, point: DVec3) -> f64;
    /// A point of the core, not on its surface unless the core is flat.
    fn inner_point(&self) -> DVec3;

    /// The farthest point in a unit direction, radius included.
    fn extreme(&self, direction: DVec3) -> DVec3 {
        self.support(direction) + direction * self.radius()
    }
}

impl Convex for [DVec3; 3] {
    fn support(&self, direction: DVec3) -> DVec3 {
        let [a, b, c] = self.map(|p| p.dot(direction));
        if a >= b && a >= c {
            self[0]
        } else if b >= c {
            self[1]
        } else {
            self[2]
        }
    }

    fn radius(&self) -> f64 {
        0.0
    }

    fn at_least(&self, _: DVec3) -> f64 {
        0.0
    }

    fn inner_point(&self) -> DVec3 {
        (self[0] + self[1] + self[2]) / 3.0
    }
}

/// Distance of two bodies: `distance` is proven, the points are as accurate as the iteration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gap {
    pub(crate) distance: f64,
    pub(crate) on_a: DVec3,
    pub(crate) on_b: DVec3,
}

/// Bound of the rounding error of a difference of projections, as a share of the points' sizes: about fifty roundings.
const ROUNDING: f64 = 1e-14;

/// Distance of the cores' planes across the unit direction `n` from a to b: a lower bound of the cores' distance.
fn between_planes(a: &impl Convex, b: &impl Convex, n: DVec3) -> f64 {
    let (p, q) = (a.support(n), b.support(-n));
    (q - p).dot(n) - ROUNDING * (p.abs().max_element() + q.abs().max_element())
}

/// Adapter of a convex body for parry, already in the common frame: poses are ignored.
struct Map<'a, C>(&'a C);

impl<C: Convex> SupportMap for Map<'_, C> {
    fn local_support_point(&self, direction: DVec3) -> DVec3 {
        self.0.support(direction)
    }
    fn support_point(&self, _: &Pose, direction: DVec3) -> DVec3 {
        self.0.support(direction)
    }
    fn support_point_toward(&self, _: &Pose, direction: DVec3) -> DVec3 {
        self.0.support(direction)
    }
}

/// The distance of two convex bodies in a common frame, or none if it is proven to be `limit` or more. `towards` is a
/// guess of the direction from a to b. If they touch or overlap, the distance is 0 and both points are equal.
pub(crate) fn nearest(a: &impl Convex, b: &impl Convex, towards: DVec3, limit: f64) -> Option<Gap> {
    let around = a.radius() + b.radius();
    let mut simplex = VoronoiSimplex::new();
    simplex.reset(CsoPoint::new(a.support(towards), b.support(-towards)));
    // A negative limit would stop parry before its first iteration.
    let far = (limit + around).max(0.0);
    let (p, q, mut proven) = match closest_points(&Pose::IDENTITY, &Map(a), &Map(b), far, true, &mut simplex) {
        GJKResult::Intersection => {
            let at = common_point(&simplex);
            return (limit > 0.0).then_some(Gap { distance: 0.0, on_a: at, on_b: at });
        }
        GJKResult::ClosestPoints(p, q, n) => (p, q, between_planes(a, b, n)),
        GJKResult::NoIntersection(n) | GJKResult::Proximity(n) => {
            let proven = between_planes(a, b, n);
            if proven - around >= limit {
                return None;
            }
            // Out of iterations: use its current simplex.
            let (p, q) = witnesses(&simplex);
            (p, q, proven)
        }
    };
    let apart = q - p;
    let Some(n) = apart.try_normalize() else {
        return (limit > 0.0).then_some(Gap { distance: 0.0, on_a: p, on_b: p });
    };
    proven = proven.max(between_planes(a, b, n)).min(apart.length());
    let distance = (proven - around).max(0.0);
    if distance >= limit {
        return None;
    }
    let length = apart.length();
    let (from_a, from_b) = if length >= around {
        (a.radius(), length - b.radius())
    } else {
        // Overlap: the middle of the common range.
        let middle = ((length - b.radius()).max(0.0) + a.radius().min(length)) / 2.0;
        (middle, middle)
    };
    Some(Gap { distance, on_a: p + n * from_a, on_b: p + n * from_b })
}

/// The points of both bodies represented by the simplex.
fn witnesses(simplex: &VoronoiSimplex) -> (DVec3, DVec3) {
    (0..=simplex.dimension()).fold((DVec3::ZERO, DVec3::ZERO), |(p, q), i| {
        let (weight, point) = (simplex.proj_coord(i), simplex.point(i));
        (p + point.orig1 * weight, q + point.orig2 * weight)
    })
}

/// A point of both bodies, from a simplex that holds the origin.
fn common_point(simplex: &VoronoiSimplex) -> DVec3 {
    if simplex.dimension() < 3 {
        return witnesses(simplex).0;
    }
    let p = [0, 1, 2, 3].map(|i| simplex.point(i).point);
    let volume = |a: DVec3, b: DVec3, c: DVec3| a.dot(b.cross(c));
    let weights =
        [volume(p[1], p[2], p[3]), -volume(p[0], p[2], p[3]), volume(p[0], p[1], p[3]), -volume(p[0], p[1], p[2])];
    let total: f64 = weights.iter().sum();
    if total == 0.0 {
        return simplex.point(0).orig1;
    }
    (0..4).fold(DVec3::ZERO, |sum, i| sum + simplex.point(i).orig1 * (weights[i] / total))
}
