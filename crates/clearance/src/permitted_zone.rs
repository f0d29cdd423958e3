//! Margins inside permitted zones.

use crate::boxes::Bounds;
use crate::distance::{Posed, extreme};
use crate::shape::{Shape, Solid};
use glam::{DAffine3, DVec3};
use std::f64::consts::TAU;

/// Margin of a body in a zone: its minimum distance from the zone's surface, negative outside.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Room {
    pub(crate) distance: f64,
    /// The body's point with the minimum margin.
    pub(crate) on_body: DVec3,
    /// The zone's surface point next to it.
    pub(crate) on_zone: DVec3,
}

/// Bound of the rounding error, as a share of the coordinates.
const ROUNDING: f64 = 1e-14;

/// Number of corners of the polygon around a round rim, at most 0.12 % of its radius outside.
const RIM: usize = 64;

/// Margin of a body, with `to_zone` mapping its group's frame to the zone's group's; points in the latter frame.
///
/// Exact for boxes and half-spaces as zones (the body's farthest point in each face's direction). In round zones exact
/// for boxes, meshes, spheres and capsules; up to 0.12 % of the radius too small for cylinders and cones, and up to the
/// difference of the semi-axes for ellipsoids.
pub(crate) fn room(body: &Solid, to_zone: &DAffine3, zone: &Solid) -> Room {
    let body = Posed::new(body, zone.pose().inverse() * *to_zone * *body.pose());
    let over_face = |n: DVec3, height: f64| {
        let p = extreme(body, n);
        (height - p.dot(n) - ROUNDING * (height + p.abs().max_element()), p, n)
    };
    let in_round = |mask: DVec3, radius: f64| {
        let (distance, p) = farthest(body, mask);
        (radius - distance - ROUNDING * (radius + distance), p, (p * mask).normalize_or(DVec3::X))
    };
    let candidates = match *zone.shape() {
        Shape::HalfSpace => vec![over_face(DVec3::Z, 0.0)],
        Shape::Sphere { radius } => vec![in_round(DVec3::ONE, radius)],
        Shape::Cylinder { radius, length } => {
            let mask = DVec3::new(1.0, 1.0, 0.0);
            vec![over_face(DVec3::Z, length), over_face(-DVec3::Z, 0.0), in_round(mask, radius)]
        }
        Shape::Box { size } => {
            let faces = DVec3::AXES.into_iter().flat_map(|n| [n, -n]);
            faces.map(|n| over_face(n, size.dot(n.abs()) / 2.0)).collect()
        }
        // `Scene::new` refuses other shapes.
        _ => Vec::new(),
    };
    let outside = (f64::NEG_INFINITY, DVec3::ZERO, DVec3::X);
    let (distance, p, n) = candidates.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or(outside);
    let [on_body, on_zone] = [p, p + n * distance].map(|p| zone.pose().transform_point3(p));
    Room { distance, on_body, on_zone }
}

/// Upper bound of the length of the body's points after `mask` (the distance from the origin, or from z), and its
/// point.
fn farthest(body: Posed, mask: DVec3) -> (f64, DVec3) {
    let Posed { shape, pose } = body;
    let at = |p: DVec3| pose.transform_point3(p);
    let length = |p: DVec3| (p * mask).length();
    let best = |points: &[DVec3]| {
        points.iter().map(|p| (length(at(*p)), at(*p))).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default()
    };
    // A point with a ball around it.
    let ball = |(distance, p): (f64, DVec3), radius: f64| {
        (distance + radius, p + (p * mask).normalize_or(mask.with_y(0.0).with_z(0.0)) * radius)
    };
    match *shape {
        Shape::Box { size } => {
            let corner = |i: u32| [1, 2, 4].map(|bit| if i & bit == 0 { -0.5 } else { 0.5 });
            best(&[0, 1, 2, 3, 4, 5, 6, 7].map(|i| size * DVec3::from_array(corner(i))))
        }
        Shape::Sphere { radius } => ball(best(&[DVec3::ZERO]), radius),
        Shape::Capsule { radius, length } => ball(best(&[DVec3::Z * radius, DVec3::Z * (length - radius)]), radius),
        Shape::Ellipsoid { semi_axes } => ball(best(&[DVec3::ZERO]), semi_axes.max_element()),
        Shape::Cylinder { radius, length } => rims([(radius, 0.0), (radius, length)], best, ball),
        Shape::Cone { radius, top_radius, length } => rims([(radius, 0.0), (top_radius, length)], best, ball),
        Shape::Mesh(ref mesh) => {
            let most = |b: &Bounds| length(at(b.centre())) + b.half().length();
            let p = at(mesh.greatest(most, |p| length(at(p))));
            (length(p), p)
        }
        Shape::HalfSpace => (f64::INFINITY, DVec3::ZERO),
    }
}

/// The farther of two rims, each a radius and a height: bounded by corners around it, or by a ball if that is tighter.
fn rims(
    rims: [(f64, f64); 2],
    best: impl Fn(&[DVec3]) -> (f64, DVec3),
    ball: impl Fn((f64, DVec3), f64) -> (f64, DVec3),
) -> (f64, DVec3) {
    let [bottom, top] = rims.map(|(radius, height)| {
        let corners: [DVec3; RIM] = std::array::from_fn(|i| {
            let (sin, cos) = (i as f64 * TAU / RIM as f64).sin_cos();
            let outer = radius / (TAU / (2.0 * RIM as f64)).cos();
            DVec3::new(outer * cos, outer * sin, height)
        });
        let (by_corners, by_ball) = (best(&corners), ball(best(&[DVec3::Z * height]), radius));
        if by_ball.0 < by_corners.0 { by_ball } else { by_corners }
    });
    if bottom.0 > top.0 { bottom } else { top }
}
