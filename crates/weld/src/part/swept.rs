use super::{Making, PLATE_MM};
use crate::t_joint::Middle;
use glam::{DAffine3, DMat3, DQuat, DVec3};
use seamwright_clearance::{ClearanceError, Mesh, Shape, Solid};
use seamwright_program::{Ellipse, FilletOrButt, TJoint};
use std::f64::consts::PI;
use std::sync::Arc;

/// How far a mesh's flat sides may be from the round ones, mm.
const WITHIN_MM: f64 = 0.01;

impl Making<'_> {
    /// An elliptic tube on a plate, or the plate alone.
    pub(super) fn ellipse(&self, e: &Ellipse) -> Result<Vec<Solid>, ClearanceError> {
        let (centre, normal) = (e.centre_mm.get(), e.normal.unit());
        let (a, b) = (e.a_mm.get(), e.b_mm.get());
        let plate = self.plate("plate", centre, normal, self.body(a.max(b)))?;
        if e.joint == FilletOrButt::Butt {
            return Ok(vec![plate]);
        }
        let x = e.a_direction.unit();
        let x = (x - x.dot(normal) * normal).normalize();
        let frame = DAffine3::from_mat3_translation(DMat3::from_cols(x, normal.cross(x), normal), centre);
        // A regular polygon about the unit circle, stretched: it lies outside by this part of the semi-axes at most.
        let count = (PI * (a.max(b) / (2.0 * WITHIN_MM)).sqrt()).ceil().max(24.0) as usize;
        let outside = 1.0 / (PI / count as f64).cos();
        let corner = |i: usize, z: f64| {
            let (sin, cos) = (2.0 * PI * i as f64 / count as f64).sin_cos();
            DVec3::new(outside * a * cos, outside * b * sin, z)
        };
        let sections: Vec<Vec<DVec3>> =
            [0.0, self.nozzle_mm].iter().map(|&z| (0..count).map(|i| corner(i, z)).collect()).collect();
        Ok(vec![plate, Solid::new("tube", Shape::Mesh(Arc::new(sweep(&sections)?)), frame)?])
    }

    /// The skin, and the web on it.
    pub(super) fn t_joint(&self, joint: &TJoint, along: &Middle) -> Result<Vec<Solid>, ClearanceError> {
        let width = self.body_mm.unwrap_or(2.0 * self.nozzle_mm);
        let half = 0.5 * joint.web_mm.get();
        // Corners of the cross-sections: to the left, and out of the skin.
        let skin = [(-0.5 * width, -PLATE_MM), (0.5 * width, -PLATE_MM), (0.5 * width, 0.0), (-0.5 * width, 0.0)];
        let web = [(-half, 0.0), (half, 0.0), (half, self.nozzle_mm), (-half, self.nozzle_mm)];
        let farthest = width.max(self.nozzle_mm);
        let solid = |name: &str, corners: [(f64, f64); 4]| {
            let section = |u: f64| corners.iter().map(|(left, out)| along.corner(u, *left, *out)).collect::<Vec<_>>();
            let pieces = along.pieces(farthest);
            let sections: Vec<_> = (0..=pieces).map(|i| section(i as f64 / pieces as f64)).collect();
            Solid::new(name, Shape::Mesh(Arc::new(sweep(&sections)?)), DAffine3::IDENTITY)
        };
        Ok(vec![solid("skin", skin)?, solid("web", web)?])
    }
}

impl Middle {
    /// A point of the cross-section in the part `u` of the middle line, mm.
    fn corner(&self, u: f64, left: f64, out: f64) -> DVec3 {
        let at_start = self.start + left * self.left + out * self.skin;
        match &self.arc {
            None => at_start + u * (self.end - self.start),
            Some((arc, sweep)) => {
                let turn = DQuat::from_axis_angle(arc.axis(), u * sweep);
                arc.centre() + turn * (at_start - arc.centre())
            }
        }
    }

    /// Pieces that keep flat sides near enough to round ones.
    fn pieces(&self, farthest: f64) -> usize {
        let Some((arc, sweep)) = &self.arc else { return 1 };
        let radius = arc.radius() + farthest;
        let angle = 2.0 * (1.0 - WITHIN_MM / radius).acos();
        (sweep / angle).ceil().max(1.0) as usize
    }
}

/// The closed mesh through cross-sections with as many corners each.
fn sweep(sections: &[Vec<DVec3>]) -> Result<Mesh, ClearanceError> {
    let mut triangles = Vec::new();
    for pair in sections.windows(2) {
        for i in 0..pair[0].len() {
            let j = (i + 1) % pair[0].len();
            triangles.push([pair[0][i], pair[0][j], pair[1][j]]);
            triangles.push([pair[0][i], pair[1][j], pair[1][i]]);
        }
    }
    for end in [sections.first(), sections.last()].into_iter().flatten() {
        triangles.extend((1..end.len() - 1).map(|i| [end[0], end[i], end[i + 1]]));
    }
    Mesh::new(&triangles)
}
