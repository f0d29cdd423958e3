use crate::quadric::Quadric;
use crate::tube::Tube;
use glam::{DMat3, DVec3};
use nalgebra::Matrix3;

/// A point seen from a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foot {
    /// Distance to the nearest point of the surface, mm: positive outside, negative inside.
    pub distance: f64,
    /// Outward unit normal there: the gradient of the distance.
    pub normal: DVec3,
}

/// A surface with a signed distance at any point.
pub trait SignedDistance {
    /// Distance and normal at `p`. If several points of the surface are equally near (on an axis, at a centre), uses
    /// one of them.
    fn foot(&self, p: DVec3) -> Foot;
}

/// A ball that contains a body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ball {
    pub(crate) centre: DVec3,
    /// Radius, mm.
    pub(crate) radius: f64,
}

/// Height over `foot` at which the line along the unit vector `d` leaves a convex body within `ball`; `None` if it does
/// not meet it.
///
/// The signed distance of a convex body is convex along a line, so Newton's method from outside goes to the last zero
/// without passing it.
pub(crate) fn way_out(body: &impl SignedDistance, ball: Ball, foot: DVec3, d: DVec3) -> Option<f64> {
    let q = foot - ball.centre;
    let (b, radius) = (q.dot(d), 1.001 * ball.radius);
    let mut h = (b * b - q.length_squared() + radius * radius).sqrt() - b;
    for _ in 0..MAX_NEWTON_STEPS {
        let Foot { distance, normal } = body.foot(foot + h * d);
        let next = h - distance / normal.dot(d);
        if next < h {
            h = next;
            continue;
        }
        return (distance < 1e-9 * radius).then_some(h);
    }
    Some(h)
}

impl SignedDistance for Tube {
    fn foot(&self, p: DVec3) -> Foot {
        let d = p - self.origin;
        let across = d - d.dot(self.e3) * self.e3;
        Foot { distance: across.length() - self.radius, normal: across.try_normalize().unwrap_or(self.e1) }
    }
}

/// The signed distance from a quadric body, exact to rounding.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadricDistance(Kind);

#[derive(Debug, Clone, PartialEq)]
enum Kind {
    Plane {
        point: DVec3,
        normal: DVec3,
    },
    /// Apex, direction, sine and cosine of the half angle.
    Cone {
        apex: DVec3,
        axis: DVec3,
        sin: f64,
        cos: f64,
    },
    /// Sphere, cylinder or ellipsoid: `sum a_i x_i^2 = size` along the principal directions about the centre; `a`
    /// decreases.
    Round {
        centre: DVec3,
        directions: DMat3,
        a: DVec3,
        size: f64,
    },
}

/// A point closer to a centre, mm, is moved to this distance: the foot is then one of the nearest points.
const AT_CENTRE_MM: f64 = 1e-10;

/// Maximum number of Newton steps: each reduces the error by at least a third.
const MAX_NEWTON_STEPS: usize = 100;

impl QuadricDistance {
    /// The distance from `body`.
    pub fn new(body: &Quadric) -> Self {
        let (centre, a) = (body.centre, body.a);
        if let Some(axis) = body.nappe {
            // Along its axis a cone's function is -tan(half angle)/2 times the square of the way from the apex.
            let (sin, cos) = (-2.0 * axis.dot(a * axis)).atan().sin_cos();
            return Self(Kind::Cone { apex: centre, axis, sin, cos });
        }
        if a == DMat3::ZERO {
            return Self(Kind::Plane { point: centre, normal: 2.0 * body.b });
        }
        let eigen = Matrix3::from_row_slice(&a.to_cols_array()).symmetric_eigen();
        let mut order = [0, 1, 2];
        order.sort_by(|i, j| eigen.eigenvalues[*j].total_cmp(&eigen.eigenvalues[*i]));
        let direction = |i: usize| DVec3::from_array(std::array::from_fn(|k| eigen.eigenvectors[(k, order[i])]));
        let directions = DMat3::from_cols(direction(0), direction(1), direction(2));
        // A cylinder's eigenvalue 0 may come out as a rounding below it.
        let a = DVec3::from_array(order.map(|i| eigen.eigenvalues[i].max(0.0)));
        Self(Kind::Round { centre, directions, a, size: -body.c })
    }
}

impl SignedDistance for QuadricDistance {
    fn foot(&self, p: DVec3) -> Foot {
        match &self.0 {
            Kind::Plane { point, normal } => Foot { distance: (p - *point).dot(*normal), normal: *normal },
            Kind::Cone { apex, axis, sin, cos } => cone_foot(p - *apex, *axis, *sin, *cos),
            Kind::Round { centre, directions, a, size } => {
                let foot = round_foot(directions.transpose() * (p - *centre), *a, *size);
                Foot { normal: *directions * foot.normal, ..foot }
            }
        }
    }
}

/// In the half plane through the axis the wall is a ray from the apex; behind the apex that is the nearest point.
fn cone_foot(d: DVec3, axis: DVec3, sin: f64, cos: f64) -> Foot {
    let height = d.dot(axis);
    let across = d - height * axis;
    let radius = across.length();
    if height * cos + radius * sin <= 0.0 {
        return Foot { distance: d.length(), normal: d.try_normalize().unwrap_or(-axis) };
    }
    let out = across.try_normalize().unwrap_or_else(|| axis.any_orthonormal_vector());
    Foot { distance: radius * cos - height * sin, normal: cos * out - sin * axis }
}

/// The foot x of q on `sum a_i x_i^2 = size` has `q - x = l a x` with one number l, so `x_i = q_i / (1 + l a_i)`; l is
/// the root of a function that falls and is convex, found by Newton's method from below, where it cannot overshoot.
/// The unknown is `v = 1 + l a_0`, which keeps its digits where a point deep inside makes it small.
fn round_foot(mut q: DVec3, a: DVec3, size: f64) -> Foot {
    if q.x.abs() < AT_CENTRE_MM {
        q.x = AT_CENTRE_MM.copysign(q.x);
    }
    let part = a / a.x;
    let divisor = |v: f64| DVec3::ONE - part + v * part;
    // Each term alone is smaller than the sum: a point where one term reaches `size` lies before the root.
    let reach = |i: usize| match part[i] {
        part if part > 0.0 => (1.0 - 1.0 / part) + (a[i] / size).sqrt() * q[i].abs() / part,
        _ => f64::NEG_INFINITY,
    };
    let mut v = reach(0).max(reach(1)).max(reach(2));
    for _ in 0..MAX_NEWTON_STEPS {
        let below = divisor(v);
        let x = q / below;
        let value = (a * x).dot(x) - size;
        let slope = -2.0 * (a * x * part).dot(x / below);
        let next = v - value / slope;
        if next <= v || !next.is_finite() {
            break;
        }
        v = next;
    }
    let gradient = a * (q / divisor(v));
    Foot { distance: (v - 1.0) / a.x * gradient.length(), normal: gradient.normalize() }
}
