use super::{Making, standing};
use glam::DVec3;
use seamwright_clearance::{ClearanceError, Mesh, Shape, Solid};
use seamwright_geometry::Head;
use std::f64::consts::PI;
use std::sync::Arc;

/// Maximum distance of a head's mesh outside the true surface, mm, by half along the meridian and by half around.
const HEAD_MM: f64 = 0.1;
/// The same as a part of the head's radius, if that is more: finer meshes would take millions of triangles.
const HEAD_PART: f64 = 2e-5;

impl Making<'_> {
    /// A vessel's head as a closed mesh around it, down to the end of its flange.
    pub(super) fn vessel_head(&self, head: &Head) -> Result<Solid, ClearanceError> {
        let within = head_within(head);
        let line = head.outline(within);
        let bottom = (0.0, line[line.len() - 1].1);
        Solid::new("head", turned(&line, &[bottom], within)?, standing(head.centre(), head.axis()))
    }
}

/// Maximum error of a head's mesh, mm, along the meridian, and as much around.
pub(super) fn head_within(head: &Head) -> f64 {
    0.5 * HEAD_MM.max(HEAD_PART * head.radius())
}

/// The solid of revolution about z between an outer and an inner line of points (distance from the axis, height). The
/// inner one goes back from the end of the outer one. Around the axis the mesh lies at most `within` mm outside it, and
/// nowhere inside.
pub(super) fn turned(outer: &[(f64, f64)], inner: &[(f64, f64)], within: f64) -> Result<Shape, ClearanceError> {
    let farthest = outer.iter().fold(0.0, |m: f64, p| m.max(p.0));
    let count = (PI * (farthest / (2.0 * within)).sqrt()).ceil().max(24.0) as usize;
    // Flat sides come nearer to the axis by the cosine: those of the outside are moved out, those of the inside stay.
    let outside = 1.0 / (PI / count as f64).cos();
    let line: Vec<(f64, f64)> = outer.iter().map(|p| (p.0 * outside, p.1)).chain(inner.iter().copied()).collect();
    let point = |(rho, z): (f64, f64), i: usize| {
        let (sin, cos) = (2.0 * PI * (i % count) as f64 / count as f64).sin_cos();
        DVec3::new(rho * cos, rho * sin, z)
    };
    let mut triangles = Vec::with_capacity(2 * line.len() * count);
    for (k, &a) in line.iter().enumerate() {
        let b = line[(k + 1) % line.len()];
        for i in 0..count {
            // On the axis all points are one.
            if a.0 > 0.0 {
                triangles.push([point(a, i), point(b, i), point(a, i + 1)]);
            }
            if b.0 > 0.0 {
                triangles.push([point(a, i + 1), point(b, i), point(b, i + 1)]);
            }
        }
    }
    Ok(Shape::Mesh(Arc::new(Mesh::new(&triangles)?)))
}

/// A closed mesh around a torus about z.
pub(super) fn bend(ring: f64, tube: f64) -> Result<Shape, ClearanceError> {
    let within = 0.5 * HEAD_MM.max(HEAD_PART * (ring + tube));
    let count = |radius: f64| (PI * (radius / (2.0 * within)).sqrt()).ceil().max(24.0);
    // A multiple of 4, so that flat sides lie on top and below.
    let (about, around) = (4.0 * (count(tube) / 4.0).ceil(), count(ring + tube));
    let (beside, outside) = (tube / (PI / about).cos(), 1.0 / (PI / around).cos());
    let point = |k: usize, i: usize| {
        let (up, out) = (2.0 * PI * (k as f64 + 0.5) / about).sin_cos();
        let rho = ring + beside * out;
        // Flat sides around come nearer to the axis: on the outside into the pipe, on the inside out of it.
        let rho = if out > 0.0 { rho * outside } else { rho };
        let (sin, cos) = (2.0 * PI * i as f64 / around).sin_cos();
        DVec3::new(rho * cos, rho * sin, beside * up)
    };
    let (about, around) = (about as usize, around as usize);
    let mut triangles = Vec::with_capacity(2 * about * around);
    for i in 0..around {
        for k in 0..about {
            let (j, l) = ((i + 1) % around, (k + 1) % about);
            let [a, b, c, d] = [point(k, i), point(k, j), point(l, i), point(l, j)];
            triangles.extend([[a, b, d], [a, d, c]]);
        }
    }
    Mesh::new(&triangles).map(|mesh| Shape::Mesh(Arc::new(mesh)))
}
