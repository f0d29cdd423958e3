//! Random solids, and distances by an independent method: alternating closed-form projections onto each body.

use glam::{DAffine3, DQuat, DVec3};
use seamwright_clearance::{Mesh, Shape, Solid};
use seamwright_testkit::Random;
use std::sync::Arc;

pub(crate) fn pose(random: &mut Random, size: f64) -> DAffine3 {
    let turn = match random.below(4) {
        // Parallel and square bodies are difficult for iterations.
        0 => DQuat::from_axis_angle(DVec3::X, random.below(4) as f64 * std::f64::consts::FRAC_PI_2),
        _ => DQuat::from_axis_angle(random.direction(), random.within(0.0, 6.0)),
    };
    DAffine3::from_rotation_translation(turn, random.vector(size))
}

pub(crate) const KINDS: usize = 8;

pub(crate) fn shape(kind: usize, random: &mut Random) -> Shape {
    let mut size = || random.within(1.0, 30.0);
    match kind {
        0 => Shape::Box { size: DVec3::new(size(), size(), size()) },
        1 => Shape::Sphere { radius: size() },
        2 => Shape::Cylinder { radius: size(), length: size() },
        3 => Shape::Cone { radius: size(), top_radius: (size() - 10.0).max(0.0), length: size() },
        4 => {
            let radius = size() / 2.0;
            Shape::Capsule { radius, length: 2.0 * radius + size() }
        }
        5 => Shape::Ellipsoid { semi_axes: DVec3::new(size(), size(), size()) / 2.0 },
        6 => Shape::HalfSpace,
        _ => Shape::Mesh(Arc::new(bumpy_torus(9, 6, size() + 10.0, size() / 3.0, 0.2))),
    }
}

/// A closed torus about z with bumps: `n` times `m` quads.
pub(crate) fn bumpy_torus(n: usize, m: usize, large: f64, small: f64, bump: f64) -> Mesh {
    let tau = std::f64::consts::TAU;
    let point = |i: usize, j: usize| {
        let (i, j) = (i % n, j % m);
        let (u, v) = (tau * i as f64 / n as f64, tau * j as f64 / m as f64);
        let r = small * (1.0 + bump * (5.0 * u + 3.0 * v).sin());
        DVec3::new((large + r * v.cos()) * u.cos(), (large + r * v.cos()) * u.sin(), r * v.sin())
    };
    let mut triangles = Vec::new();
    for i in 0..n {
        for j in 0..m {
            let [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Mesh::new(&triangles).unwrap()
}

pub(crate) fn solid(shape: Shape, pose: DAffine3) -> Solid {
    Solid::new("solid", shape, pose).unwrap()
}

/// The corners of a box as twelve triangles.
pub(crate) fn box_triangles(size: DVec3) -> Vec<[DVec3; 3]> {
    let p = |i: usize| size * DVec3::new((i & 1) as f64 - 0.5, (i >> 1 & 1) as f64 - 0.5, (i >> 2 & 1) as f64 - 0.5);
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        .into_iter()
        .flat_map(|[a, b, c, d]| [[p(a), p(b), p(c)], [p(a), p(c), p(d)]])
        .collect()
}

/// A convex piece in the common frame: a whole convex solid or a triangle of a mesh.
pub(crate) enum Piece<'a> {
    Solid(&'a Shape, DAffine3),
    Triangle([DVec3; 3]),
}

pub(crate) fn pieces<'a>(shape: &'a Shape, pose: &DAffine3) -> Vec<Piece<'a>> {
    match shape {
        Shape::Mesh(mesh) => {
            mesh.triangles().iter().map(|t| Piece::Triangle(t.map(|p| pose.transform_point3(p)))).collect()
        }
        _ => vec![Piece::Solid(shape, *pose)],
    }
}

impl Piece<'_> {
    pub(crate) fn project(&self, p: DVec3) -> DVec3 {
        match self {
            Self::Solid(shape, pose) => pose.transform_point3(project(shape, pose.inverse().transform_point3(p))),
            Self::Triangle(t) => project_on_triangle(t, p),
        }
    }

    pub(crate) fn start(&self) -> DVec3 {
        match self {
            Self::Solid(_, pose) => pose.translation,
            Self::Triangle(t) => (t[0] + t[1] + t[2]) / 3.0,
        }
    }

    /// A radius around `start` in which it lies.
    pub(crate) fn reach(&self) -> f64 {
        match self {
            Self::Solid(Shape::HalfSpace, _) => f64::INFINITY,
            Self::Solid(..) => 120.0,
            Self::Triangle(t) => t.iter().map(|p| p.distance(self.start())).fold(0.0, f64::max),
        }
    }
}

/// The nearest point of a convex shape, in its frame.
fn project(shape: &Shape, p: DVec3) -> DVec3 {
    match *shape {
        Shape::Box { size } => p.clamp(-size / 2.0, size / 2.0),
        Shape::Sphere { radius } => p.clamp_length_max(radius),
        Shape::HalfSpace => p.with_z(p.z.min(0.0)),
        Shape::Cylinder { radius, length } => p.truncate().clamp_length_max(radius).extend(p.z.clamp(0.0, length)),
        Shape::Capsule { radius, length } => {
            let centre = DVec3::Z * p.z.clamp(radius, length - radius);
            centre + (p - centre).clamp_length_max(radius)
        }
        Shape::Cone { radius, top_radius, length } => {
            // In the half plane through the axis: the trapezium 0, bottom, top, apex.
            let (rho, z) = (p.truncate().length(), p.z);
            let inside = (0.0..=length).contains(&z) && rho <= radius + (top_radius - radius) * z / length;
            if inside {
                return p;
            }
            let corners = [[0.0, 0.0], [radius, 0.0], [top_radius, length], [0.0, length]];
            let mut best = (f64::INFINITY, [0.0, 0.0]);
            for [a, b] in [[0, 1], [1, 2], [2, 3]].map(|e| e.map(|i| corners[i])) {
                let (d, q) = ([b[0] - a[0], b[1] - a[1]], [rho - a[0], z - a[1]]);
                let square = d[0] * d[0] + d[1] * d[1];
                let t = if square > 0.0 { ((d[0] * q[0] + d[1] * q[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
                let at = [a[0] + t * d[0], a[1] + t * d[1]];
                let distance = (rho - at[0]).hypot(z - at[1]);
                if distance < best.0 {
                    best = (distance, at);
                }
            }
            let out = p.with_z(0.0).normalize_or(DVec3::X);
            out * best.1[0] + DVec3::Z * best.1[1]
        }
        Shape::Ellipsoid { semi_axes: e } => {
            if (p / e).length() <= 1.0 {
                return p;
            }
            // The root t of sum (e p / (e^2 + t))^2 = 1, by bisection.
            let at = |t: f64| e * e * p / (e * e + t);
            let (mut low, mut high) = (0.0, e.max_element() * p.length() * 2.0);
            for _ in 0..200 {
                let middle = (low + high) / 2.0;
                if (at(middle) / e).length() > 1.0 { low = middle } else { high = middle }
            }
            at(high)
        }
        Shape::Mesh(_) => unreachable!(),
    }
}

fn project_on_triangle(t: &[DVec3; 3], p: DVec3) -> DVec3 {
    let n = (t[1] - t[0]).cross(t[2] - t[0]).normalize_or_zero();
    let foot = p - n * n.dot(p - t[0]);
    let edges = [[0, 1], [1, 2], [2, 0]].map(|e| e.map(|i| t[i]));
    if n != DVec3::ZERO && edges.iter().all(|[a, b]| (*b - *a).cross(foot - *a).dot(n) >= 0.0) {
        return foot;
    }
    let on_edge = |[a, b]: &[DVec3; 2]| {
        let d = *b - *a;
        *a + d * ((p - *a).dot(d) / d.length_squared().max(1e-300)).clamp(0.0, 1.0)
    };
    edges.iter().map(on_edge).min_by(|a, b| a.distance(p).total_cmp(&b.distance(p))).unwrap()
}

/// Upper bound of the distance, tight if `steps` is large: alternating projections, which bring the points of two
/// convex bodies closer.
pub(crate) fn in_turns(a: &Piece, b: &Piece, steps: usize) -> f64 {
    let mut p = a.project(b.start());
    let mut distance = f64::INFINITY;
    for _ in 0..steps {
        let q = b.project(p);
        p = a.project(q);
        let now = p.distance(q);
        if distance - now < 1e-12 * now {
            return now;
        }
        distance = now;
    }
    distance
}

/// The same for whole solids.
pub(crate) fn brute_force(a: (&Shape, &DAffine3), b: (&Shape, &DAffine3), steps: usize) -> f64 {
    let (a, b) = (pieces(a.0, a.1), pieces(b.0, b.1));
    let mut least = f64::INFINITY;
    for p in &a {
        for q in &b {
            if p.start().distance(q.start()) - p.reach() - q.reach() < least {
                least = least.min(in_turns(p, q, steps));
            }
        }
    }
    least
}
