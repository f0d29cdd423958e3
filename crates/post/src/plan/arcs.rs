//! Arcs through three points of the plan.

use crate::part_program::Arc;
use glam::DVec3;
use std::f64::consts::TAU;

/// Arcs that a control supports.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Arcs {
    None,
    /// Arcs about X, Y or Z, with motion along that axis.
    Planes,
    /// Those, and circles in any plane.
    Any,
}

/// Permitted normal of an arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Normal {
    /// This one; along it the arc may climb.
    Along(DVec3),
    /// The normal of the plane of three points.
    OfPlane,
}

impl Arcs {
    /// The normals that may be tried.
    pub(crate) fn normals(self) -> &'static [Normal] {
        const ALL: [Normal; 4] =
            [Normal::Along(DVec3::Z), Normal::Along(DVec3::Y), Normal::Along(DVec3::X), Normal::OfPlane];
        match self {
            Self::None => &[],
            Self::Planes => &ALL[..3],
            Self::Any => &ALL,
        }
    }
}

/// Larger radii (mm) are lines: centres lose digits.
const LARGEST_MM: f64 = 1e5;
/// Smaller ones are corners.
const SMALLEST_MM: f64 = 1e-3;
/// Longest arc, rad: with ends near to each other, a circle is not distinguishable from a point.
const LONGEST: f64 = 0.95 * TAU;

/// The arc from `start` through `middle` to `end`; `None` if they are in line, or its radius or angle are out of
/// bounds.
pub(crate) fn through(start: DVec3, middle: DVec3, end: DVec3, normal: Normal) -> Option<Arc> {
    let (b, c) = (middle - start, end - start);
    let normal = match normal {
        Normal::Along(normal) => normal,
        Normal::OfPlane => b.cross(c).try_normalize()?,
    };
    let (b, c) = (b.reject_from_normalized(normal), c.reject_from_normalized(normal));
    let area = b.cross(c).dot(normal);
    // The centre of the circle round a triangle, from its first corner.
    let to_centre = (c.length_squared() * b - b.length_squared() * c).cross(normal) * (-0.5 / area);
    let radius = to_centre.length();
    if !(SMALLEST_MM..LARGEST_MM).contains(&radius) {
        return None;
    }
    between(start, end, start + to_centre, normal * area.signum()).filter(|arc| arc.sweep < LONGEST)
}

/// The arc from `start` to `end` about `normal` through `centre` by the right-hand rule, up to one turn.
pub(crate) fn between(start: DVec3, end: DVec3, centre: DVec3, normal: DVec3) -> Option<Arc> {
    let sweep = Arc::angle(start, end, centre, normal);
    (sweep > 0.0 && sweep.is_finite()).then_some(Arc { centre, normal, sweep })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;
    use seamwright_testkit::Random;

    /// Arcs made by turning a point give back their centre, normal and angle, in the plane and as a helix.
    #[test]
    fn three_places_make_the_arc() {
        let mut random = Random::new(1);
        for k in 0..4000 {
            let climbs = k % 2 == 0;
            let normal = if climbs { [DVec3::X, DVec3::NEG_Y, DVec3::Z][k % 3] } else { random.direction() };
            let (centre, radius) = (random.vector(50.0), random.within(0.5, 50.5));
            let (sweep, climb) = (random.within(0.02, 5.82), if climbs { random.within(-5.0, 5.0) } else { 0.0 });
            let out = normal.any_orthonormal_vector() * radius;
            let at = |f: f64| centre + DQuat::from_axis_angle(normal, f * sweep) * out + f * climb * normal;
            let asked = if climbs { Normal::Along(normal.abs()) } else { Normal::OfPlane };
            let arc = through(at(0.0), at(0.5), at(1.0), asked).unwrap();
            assert!((arc.sweep - sweep).abs() < 1e-7 && arc.normal.distance(normal) < 1e-7, "{arc:?} {sweep} {normal}");
            for f in [0.1, 0.37, 0.9] {
                assert!(arc.at(at(0.0), at(1.0), f).distance(at(f)) < 1e-6, "{arc:?}");
            }
        }
        assert_eq!(through(DVec3::ZERO, DVec3::X, 2.0 * DVec3::X, Normal::OfPlane), None);
        assert_eq!(through(DVec3::ZERO, DVec3::X, 2.0 * DVec3::X, Normal::Along(DVec3::Z)), None);
    }
}
