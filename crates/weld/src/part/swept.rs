use super::{Extent, Impossible, Making, PLATE_MM};
use crate::t_joint::Middle;
use glam::{DAffine3, DMat3, DQuat, DVec3};
use seamwright_clearance::{ClearanceError, Mesh, Shape, Solid};
use seamwright_program::{Ellipse, RimJoint, TJoint};
use std::f64::consts::PI;
use std::sync::Arc;

/// Maximum distance of a mesh's flat sides from the round ones, mm.
pub(super) const WITHIN_MM: f64 = 0.01;

impl Making<'_> {
    /// An elliptic tube on a plate, or the plate alone.
    pub(super) fn ellipse(&self, e: &Ellipse) -> Result<Vec<Solid>, Impossible> {
        let (centre, normal) = (e.centre_mm.get(), e.normal.unit());
        let (a, b) = (e.a_mm.get(), e.b_mm.get());
        let is_corner = e.joint == RimJoint::Corner;
        let mut solids = Vec::new();
        if !is_corner {
            solids.push(self.plate("plate", centre, normal, self.body(6.0 * a.max(b), 2.0 * a.max(b))?)?);
        }
        if e.joint == RimJoint::Butt {
            return Ok(solids);
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
        let ends = if is_corner { [-self.nozzle_mm, 0.0] } else { [0.0, self.nozzle_mm] };
        let sections = ends.map(|z| (0..count).map(|i| corner(i, z)).collect::<Vec<_>>());
        solids.push(Solid::new("tube", Shape::Mesh(Arc::new(sweep_through(&sections)?)), frame)?);
        Ok(solids)
    }

    /// The skin, and the web on it.
    pub(super) fn t_joint(&self, joint: &TJoint, along: &Middle) -> Result<Vec<Solid>, Impossible> {
        let web_mm = joint.web_mm.get();
        let width = self.body(2.0 * self.nozzle_mm, web_mm)?;
        let about_middle = |width: f64| Extent { low: -0.5 * width, high: 0.5 * width };
        let skin = Section { left: about_middle(width), out: Extent { low: -PLATE_MM, high: 0.0 } };
        // The web's foot is within the skin, so that no gap is between them where both are meshes.
        let height = Extent { low: -0.5 * PLATE_MM, high: self.nozzle_mm };
        let web = Section { left: about_middle(web_mm), out: height };
        Ok(vec![along.solid("skin", skin)?, along.solid("web", web)?])
    }
}

/// A rectangle across the middle line: its extent to the left, and out of the skin.
#[derive(Clone, Copy)]
pub(super) struct Section {
    pub(super) left: Extent,
    pub(super) out: Extent,
}

impl Section {
    /// The same with each side moved outwards by its part of `more` mm along a direction with these components.
    fn grown(self, more: f64, left: f64, out: f64) -> Self {
        let wider =
            |side: Extent, c: f64| Extent { low: side.low - more * (-c).max(0.0), high: side.high + more * c.max(0.0) };
        Self { left: wider(self.left, left), out: wider(self.out, out) }
    }

    fn corners(self) -> [(f64, f64); 4] {
        let Self { left, out } = self;
        [(left.low, out.low), (left.high, out.low), (left.high, out.high), (left.low, out.high)]
    }
}

impl Middle {
    /// The solid with this cross-section: a box, or a mesh around the arc's.
    pub(super) fn solid(&self, name: &str, section: Section) -> Result<Solid, ClearanceError> {
        let Some((arc, sweep)) = &self.arc else {
            let length = self.start.distance(self.end);
            let axes = DMat3::from_cols((self.end - self.start) / length, self.left, self.skin);
            let low = DVec3::new(0.0, section.left.low, section.out.low);
            let high = DVec3::new(length, section.left.high, section.out.high);
            let pose = DAffine3::from_mat3_translation(axes, self.start + axes * (0.5 * (low + high)));
            return Solid::new(name, Shape::Box { size: high - low }, pose);
        };
        let outward = (self.start - arc.centre()).normalize();
        let (left, out) = (self.left.dot(outward), self.skin.dot(outward));
        // Far from the weld it ends before the arc's axis, where it would meet itself.
        let room = 0.45 * arc.radius();
        let section = Section { left: short_of(section.left, left, room), out: short_of(section.out, out, room) };
        let farthest =
            section.corners().map(|(l, o)| arc.radius() + l * left + o * out).into_iter().fold(0.0, f64::max);
        // Between two cross-sections a flat side lies nearer to the axis by up to the cosine of half the angle between
        // them. So the outer faces are moved out by that, and the solid is nowhere smaller than the true one.
        let most = WITHIN_MM / farthest;
        let pieces = (sweep / (2.0 * (most * (2.0 + most)).sqrt().atan())).ceil().max(1.0);
        let half = 0.5 * sweep / pieces;
        let more = farthest * 2.0 * (0.5 * half).sin().powi(2) / half.cos();
        let corners = section.grown(more, left, out).corners();
        let at = |i: usize| {
            let turn = DQuat::from_axis_angle(arc.axis(), sweep * i as f64 / pieces);
            let corner =
                |(l, o): (f64, f64)| arc.centre() + turn * (self.start - arc.centre() + l * self.left + o * self.skin);
            corners.map(corner).to_vec()
        };
        let sections: Vec<Vec<DVec3>> = (0..=pieces as usize).map(at).collect();
        Solid::new(name, Shape::Mesh(Arc::new(sweep_through(&sections)?)), DAffine3::IDENTITY)
    }
}

/// The part of a range that goes no more than `room` mm towards the axis, which one mm of it does by `-outward`.
fn short_of(range: Extent, outward: f64, room: f64) -> Extent {
    let Extent { low, high } = range;
    let end = room / outward.abs();
    if outward > 0.0 { Extent { low: low.max(-end), high } } else { Extent { low, high: high.min(end) } }
}

/// The closed mesh through cross-sections with as many corners each.
pub(super) fn sweep_through(sections: &[Vec<DVec3>]) -> Result<Mesh, ClearanceError> {
    close_ring(sections, false)
}

/// The same; in a `ring` the first cross-section follows the last.
pub(super) fn close_ring(sections: &[Vec<DVec3>], ring: bool) -> Result<Mesh, ClearanceError> {
    let mut triangles = Vec::new();
    let next = sections.iter().skip(1).chain(sections.first().filter(|_| ring));
    for (a, b) in sections.iter().zip(next) {
        for i in 0..a.len() {
            let j = (i + 1) % a.len();
            triangles.push([a[i], a[j], b[j]]);
            triangles.push([a[i], b[j], b[i]]);
        }
    }
    if ring {
        return Mesh::new(&triangles);
    }
    for end in [sections.first(), sections.last()].into_iter().flatten() {
        triangles.extend((1..end.len() - 1).map(|i| [end[0], end[i], end[i + 1]]));
    }
    Mesh::new(&triangles)
}
