//! The distance of any two shapes.
//!
//! Every pair of kinds has its own way: half-spaces and meshes here, convex bodies in `convex` (an iteration of parry,
//! GJK, finds a direction; a plane across it proves the distance). Meshes search their tree of boxes (`mesh`).

use crate::boxes::Bounds;
use crate::convex::{self, Convex, Gap};
use crate::mesh::{Last, Mesh};
use crate::placed::Placed;
use crate::shape::{Shape, Solid};
use crate::swept::Swept;
use glam::{DAffine3, DVec3};

/// Nearest points of two solids, in their common frame. This is returned by [`nearest`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Near {
    /// Distance, mm: a tight lower bound; 0 if they touch or overlap.
    pub distance: f64,
    /// Nearest point of the first solid; if they overlap, a point of both (or near one).
    pub on_a: DVec3,
    /// Nearest point of the second solid.
    pub on_b: DVec3,
}

/// Computes the distance of two solids.
///
/// `frame_a` and `frame_b` map the frames of the solids to a common one. Returns `None` if the solids are `limit` (mm)
/// or more apart: a small limit is faster. Pass `f64::INFINITY` for the distance in any case.
///
/// For many solids that move, use a [`Scene`](crate::Scene).
///
/// # Guarantees
///
/// - The distance is a lower bound. It is proven by planes between the solids (for a mesh, one for each triangle), less
///   the rounding error.
/// - It is 0 if the solids touch or overlap, also if one lies wholly inside a mesh.
/// - Invalid frames never look clear: the distance is 0 if they are not finite or more than 1e9 mm apart.
///
/// # Examples
///
/// A sphere of radius 5 mm stands 30 mm beside the middle of a cube of 40 mm. Its centre moves with the frame:
///
/// ```
/// use glam::{DAffine3, DVec3};
/// use seamwright_clearance::{Shape, Solid, nearest};
///
/// let cube = Solid::new("part", Shape::Box { size: DVec3::splat(40.0) }, DAffine3::IDENTITY)?;
/// let ball = Solid::new("probe", Shape::Sphere { radius: 5.0 }, DAffine3::IDENTITY)?;
/// let (fixed, beside) = (DAffine3::IDENTITY, DAffine3::from_translation(DVec3::new(30.0, 0.0, 0.0)));
/// let near = nearest(&cube, &fixed, &ball, &beside, f64::INFINITY);
/// assert!(near.is_some_and(|near| (near.distance - 5.0).abs() < 1e-3));
/// assert!(near.is_some_and(|near| (near.on_a - DVec3::new(20.0, 0.0, 0.0)).length() < 1e-3));
/// // Overlapping solids have the distance 0.
/// let within = DAffine3::from_translation(DVec3::new(10.0, 3.0, 2.0));
/// let inside = nearest(&cube, &fixed, &ball, &within, f64::INFINITY);
/// assert!(inside.is_some_and(|near| near.distance <= 0.0));
/// # Ok::<(), seamwright_clearance::ClearanceError>(())
/// ```
pub fn nearest(a: &Solid, frame_a: &DAffine3, b: &Solid, frame_b: &DAffine3, limit: f64) -> Option<Near> {
    // In a frame at the first solid, to keep precision far from the common origin.
    let to_a = frame_a.inverse() * *frame_b;
    if !is_usable(&to_a) {
        return (limit > 0.0).then_some(Near { distance: 0.0, on_a: DVec3::ZERO, on_b: DVec3::ZERO });
    }
    let gap = of_shapes(Posed::new(a, *a.pose()), Posed::new(b, to_a * *b.pose()), limit, &mut 0)?;
    let [on_a, on_b] = [gap.on_a, gap.on_b].map(|p| frame_a.transform_point3(p));
    Some(Near { distance: gap.distance, on_a, on_b })
}

/// True for frames valid for distances: finite, and at most 1e9 mm away.
pub(crate) fn is_usable(frame: &DAffine3) -> bool {
    frame.is_finite() && frame.translation.abs().max_element() <= 1e9
}

#[derive(Clone, Copy)]
pub(crate) struct Posed<'a> {
    pub(crate) shape: &'a Shape,
    pub(crate) pose: DAffine3,
}

impl<'a> Posed<'a> {
    pub(crate) fn new(solid: &'a Solid, pose: DAffine3) -> Self {
        Self { shape: solid.shape(), pose }
    }
}

/// Bound of the rounding error of a height over a plane, as a share of the coordinates.
const ROUNDING: f64 = 1e-14;

/// Lower bound of the distance of two shapes while `a` moves to the pose `to`, every point along a straight line; none if
/// it is `limit` or more. The second shape rests.
pub(crate) fn of_swept(a: Posed, to: DAffine3, b: Posed, limit: f64, last: &mut Last) -> Option<f64> {
    if limit <= 0.0 {
        return None;
    }
    let at_end = Posed { pose: to, ..a };
    let Some(body) = Placed::new(a.shape, a.pose) else {
        return match b.shape {
            // A straight line is nearest to a plane at one of its ends.
            Shape::HalfSpace => {
                let ends = [a, at_end].map(|body| over_plane(&b.pose, body, limit).map(|gap| gap.distance));
                ends.into_iter().flatten().reduce(f64::min)
            }
            _ => apart_at_ends(a, at_end, b, limit),
        };
    };
    let body = Swept::new(body, to);
    let gap = match b.shape {
        Shape::HalfSpace => over(&b.pose, body.extreme(-b.pose.matrix3.z_axis), limit),
        Shape::Mesh(mesh) => {
            let from_b = b.pose.inverse();
            let local = Swept::new(Placed::new(a.shape, from_b * a.pose)?, from_b * to);
            mesh_and_body(mesh, &local, limit, last)
        }
        _ => {
            let fixed = Placed::new(b.shape, b.pose)?;
            convex::nearest(&body, &fixed, fixed.inner_point() - body.inner_point(), limit)
        }
    };
    gap.map(|gap| gap.distance)
}

/// The same for a mesh that moves, by its distances at both ends and the displacement of its box.
fn apart_at_ends(a: Posed, at_end: Posed, b: Posed, limit: f64) -> Option<f64> {
    let Shape::Mesh(mesh) = a.shape else { return Some(0.0) };
    let (low, high) = mesh.bounds();
    let corner = |i: usize| DVec3::from_array(std::array::from_fn(|k| if i >> k & 1 == 0 { low[k] } else { high[k] }));
    let moved = |p: DVec3| a.pose.transform_point3(p).distance(at_end.pose.transform_point3(p));
    let travel = (0..8).map(|i| moved(corner(i))).fold(0.0, f64::max);
    let far = limit + travel;
    let mut last = Last::MAX;
    let mut distance = |body: Posed| of_shapes(body, b, far, &mut last).map_or(far, |gap| gap.distance);
    let bound = ((distance(a) + distance(at_end) - travel) / 2.0).max(0.0);
    (bound < limit).then_some(bound)
}

/// Distance of two shapes in a common frame, or none if it is `limit` or more. `last` is the index of the last nearest
/// triangle of a mesh.
pub(crate) fn of_shapes(a: Posed, b: Posed, limit: f64, last: &mut Last) -> Option<Gap> {
    if limit <= 0.0 {
        return None;
    }
    match (a.shape, b.shape) {
        (Shape::HalfSpace, Shape::HalfSpace) => half_spaces(&a.pose, &b.pose, limit),
        (Shape::HalfSpace, _) => over_plane(&a.pose, b, limit),
        (_, Shape::HalfSpace) => over_plane(&b.pose, a, limit).map(swapped),
        (Shape::Mesh(m), Shape::Mesh(n)) => meshes(m, &a.pose, n, &b.pose, limit),
        (Shape::Mesh(m), _) => mesh_and_convex(m, &a.pose, b, limit, last).map(swapped),
        (_, Shape::Mesh(m)) => mesh_and_convex(m, &b.pose, a, limit, last),
        _ => {
            let (p, q) = (Placed::new(a.shape, a.pose)?, Placed::new(b.shape, b.pose)?);
            convex::nearest(&p, &q, q.inner_point() - p.inner_point(), limit)
        }
    }
}

fn swapped(gap: Gap) -> Gap {
    Gap { distance: gap.distance, on_a: gap.on_b, on_b: gap.on_a }
}

fn moved(gap: Gap, pose: &DAffine3) -> Gap {
    let [on_a, on_b] = [gap.on_a, gap.on_b].map(|p| pose.transform_point3(p));
    Gap { distance: gap.distance, on_a, on_b }
}

/// The farthest point of a bounded shape, in a unit direction of the frame that `pose` maps to.
pub(crate) fn extreme(body: Posed, direction: DVec3) -> DVec3 {
    let Posed { shape, pose } = body;
    match shape {
        Shape::Mesh(mesh) => pose.transform_point3(mesh.extreme(pose.matrix3.transpose() * direction)),
        Shape::HalfSpace => direction * f64::INFINITY,
        _ => Placed::new(shape, pose).map_or(DVec3::ZERO, |p| p.extreme(direction)),
    }
}

/// Distance of two half-spaces: 0 unless they face each other (to 1e-12 rad).
fn half_spaces(a: &DAffine3, b: &DAffine3, limit: f64) -> Option<Gap> {
    let n = a.matrix3.z_axis;
    let facing = (n + b.matrix3.z_axis).length() < 1e-12;
    let distance = if facing { (b.translation - a.translation).dot(n).max(0.0) } else { 0.0 };
    (distance < limit).then(|| Gap { distance, on_a: a.translation, on_b: a.translation + n * distance })
}

/// Distance of a half-space and a bounded body; `a` is the half-space.
fn over_plane(plane: &DAffine3, body: Posed, limit: f64) -> Option<Gap> {
    over(plane, extreme(body, -plane.matrix3.z_axis), limit)
}

/// Distance of a half-space and a body whose lowest point over it is given; `a` is the half-space.
fn over(plane: &DAffine3, lowest: DVec3, limit: f64) -> Option<Gap> {
    let n = plane.matrix3.z_axis;
    let height = (lowest - plane.translation).dot(n);
    let size = lowest.abs().max_element() + plane.translation.abs().max_element();
    let distance = (height - ROUNDING * size).max(0.0);
    let gap = Gap { distance, on_a: lowest - n * height.max(0.0), on_b: lowest };
    (distance < limit).then_some(gap)
}

/// Distance of a mesh and a convex body; `a` is the convex one.
fn mesh_and_convex(mesh: &Mesh, pose: &DAffine3, body: Posed, limit: f64, last: &mut Last) -> Option<Gap> {
    let body = Placed::new(body.shape, pose.inverse() * body.pose)?;
    mesh_and_body(mesh, &body, limit, last).map(|gap| moved(gap, pose))
}

/// The same in the frame of the mesh.
fn mesh_and_body(mesh: &Mesh, body: &impl Convex, limit: f64, last: &mut Last) -> Option<Gap> {
    let high = DVec3::AXES.map(|n| body.extreme(n).dot(n));
    let low = DVec3::AXES.map(|n| body.extreme(-n).dot(n));
    let around = Bounds { low: low.into(), high: high.into() };
    let around = padded(around);
    let surface = mesh.nearest_to(body, &around, limit, last);
    let inside = || {
        let p = body.inner_point();
        (limit > 0.0 && mesh.contains(p)).then_some(Gap { distance: 0.0, on_a: p, on_b: p })
    };
    surface.filter(|g| g.distance <= 0.0).or_else(inside).or(surface)
}

/// The box enlarged by the rounding error, so that culling stays safe.
fn padded(b: Bounds) -> Bounds {
    let more = DVec3::splat(ROUNDING) * (b.low.abs() + b.high.abs());
    Bounds { low: b.low - more, high: b.high + more }
}

fn meshes(m: &Mesh, pose_m: &DAffine3, n: &Mesh, pose_n: &DAffine3, limit: f64) -> Option<Gap> {
    let from_n = pose_m.inverse() * *pose_n;
    let surface = m.nearest_surface(n, &from_n, limit);
    let inside = || {
        let at = |p| Gap { distance: 0.0, on_a: p, on_b: p };
        let n_in_m = n.pieces().iter().map(|p| from_n.transform_point3(*p)).find(|p| m.contains(*p));
        let to_n = from_n.inverse();
        let m_in_n = || m.pieces().iter().copied().find(|p| n.contains(to_n.transform_point3(*p)));
        n_in_m.or_else(m_in_n).map(at).filter(|_| limit > 0.0)
    };
    let gap = surface.filter(|g| g.distance <= 0.0).or_else(inside).or(surface)?;
    Some(moved(gap, pose_m))
}
