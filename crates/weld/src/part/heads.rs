use super::{Making, standing};
use glam::DVec3;
use seamwright_clearance::{ClearanceError, Mesh, Shape, Solid};
use seamwright_geometry::Head;
use std::f64::consts::PI;
use std::sync::Arc;

/// How far a head's mesh may lie outside the true surface, mm, by half along the meridian and by half around.
const HEAD_MM: f64 = 0.1;
/// The same as a part of the head's radius, if that is more: finer meshes would take millions of triangles.
const HEAD_PART: f64 = 2e-5;

impl Making<'_> {
    /// A vessel's head as a closed mesh around it, down to the end of its flange.
    pub(super) fn vessel_head(&self, head: &Head) -> Result<Solid, ClearanceError> {
        let within = 0.5 * HEAD_MM.max(HEAD_PART * head.radius());
        let line = head.outline(within);
        let around = (PI * (head.radius() / (2.0 * within)).sqrt()).ceil().max(24.0) as usize;
        let outside = 1.0 / (PI / around as f64).cos();
        let point = |(rho, z): (f64, f64), i: usize| {
            let (sin, cos) = (2.0 * PI * (i % around) as f64 / around as f64).sin_cos();
            DVec3::new(outside * rho * cos, outside * rho * sin, z)
        };
        let bottom = DVec3::new(0.0, 0.0, line[line.len() - 1].1);
        let mut triangles = Vec::with_capacity(2 * line.len() * around);
        for i in 0..around {
            // The first ring is a point on the axis.
            triangles.push([point(line[0], 0), point(line[1], i), point(line[1], i + 1)]);
            for pair in line[1..].windows(2) {
                let [a, b, c, d] = [point(pair[0], i), point(pair[0], i + 1), point(pair[1], i), point(pair[1], i + 1)];
                triangles.extend([[a, c, d], [a, d, b]]);
            }
            triangles.push([point(line[line.len() - 1], i + 1), point(line[line.len() - 1], i), bottom]);
        }
        let shape = Shape::Mesh(Arc::new(Mesh::new(&triangles)?));
        Solid::new("head", shape, standing(head.centre(), head.axis()))
    }
}
