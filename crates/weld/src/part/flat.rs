//! Plates with parts that stand on them along a circle, an arc or a rectangle.

use super::swept::{Section, WITHIN_MM, sweep_through};
use super::{Extent, Impossible, Making, PLATE_MM, standing};
use crate::plane_seam::zero;
use crate::t_joint::Middle;
use glam::{DAffine3, DMat3, DVec2, DVec3};
use seamwright_clearance::{Shape, Solid};
use seamwright_document::Direction;
use seamwright_geometry::Curve;
use seamwright_program::{Arc, Circle, FilletOrButt, RimJoint, RoundedRectangle, Spline, WallFaces};
use std::f64::consts::PI;

/// A seam that leaves a plane by no more than this part of its length lies in it.
const FLAT: f64 = 1e-6;

impl Making<'_> {
    /// A round tube on a plate, or the plate alone.
    pub(super) fn circle(&self, c: &Circle) -> Result<Vec<Solid>, Impossible> {
        let (centre, normal, radius) = (c.centre_mm.get(), c.normal.unit(), c.radius_mm.get());
        if c.joint == RimJoint::Corner {
            let tube = Shape::Cylinder { radius, length: self.nozzle_mm };
            return Ok(vec![Solid::new("tube", tube, standing(centre - self.nozzle_mm * normal, normal))?]);
        }
        let plate = self.plate("plate", centre, normal, self.body(6.0 * radius, 2.0 * radius)?)?;
        if c.joint == RimJoint::Butt {
            return Ok(vec![plate]);
        }
        let tube = Shape::Cylinder { radius, length: self.nozzle_mm };
        Ok(vec![plate, Solid::new("tube", tube, standing(centre, normal))?])
    }

    /// A square tube on a plate, or the plate alone.
    pub(super) fn rectangle(&self, r: &RoundedRectangle) -> Result<Vec<Solid>, Impossible> {
        let (centre, normal) = (r.centre_mm.get(), r.normal.unit());
        let half = 0.5 * DVec2::new(r.width_mm.get(), r.height_mm.get());
        let is_corner = r.joint == RimJoint::Corner;
        let mut solids = Vec::new();
        if !is_corner {
            let side = self.body(6.0 * half.max_element(), 2.0 * half.length())?;
            solids.push(self.plate("plate", centre, normal, side)?);
        }
        if r.joint == RimJoint::Butt {
            return Ok(solids);
        }
        let x = zero(normal, r.width_direction);
        let x = (x - x.dot(normal) * normal).normalize();
        let frame = DAffine3::from_mat3_translation(DMat3::from_cols(x, normal.cross(x), normal), centre);
        let outline = outline(half, r.corner_mm.get());
        let section = |z: f64| outline.iter().map(|p| p.extend(z)).collect::<Vec<_>>();
        let [low, high] = if is_corner { [-self.nozzle_mm, 0.0] } else { [0.0, self.nozzle_mm] };
        let tube = sweep_through(&[section(low), section(high)])?;
        solids.push(Solid::new("tube", Shape::Mesh(std::sync::Arc::new(tube)), frame)?);
        Ok(solids)
    }

    /// A plate with a wall along an arc, behind its face, or the plate alone.
    pub(super) fn arc(&self, a: &Arc, curve: &seamwright_geometry::Arc) -> Result<Vec<Solid>, Impossible> {
        let (start, normal) = (a.start_mm.get(), a.normal.unit());
        let plate = self.plate_below(start, normal)?;
        if a.joint == FilletOrButt::Butt {
            return Ok(vec![plate]);
        }
        let left = normal.cross(curve.jet(0.0).d1.normalize());
        let sweep = curve.domain().1;
        let along = Middle { start, end: a.end_mm.get(), left, skin: normal, arc: Some((curve.clone(), sweep)) };
        let across = match a.wall_faces {
            WallFaces::Right => Extent { low: 0.0, high: self.plate_mm() },
            WallFaces::Left => Extent { low: -self.plate_mm(), high: 0.0 },
        };
        // Its foot is within the plate, so that no gap is between them.
        let wall = Section { left: across, out: Extent { low: -0.5 * PLATE_MM, high: self.nozzle_mm } };
        Ok(vec![plate, along.solid("wall", wall)?])
    }

    /// The plate under a spline that lies in the plane of its one normal; empty under others.
    pub(super) fn spline(&self, s: &Spline) -> Result<Vec<Solid>, Impossible> {
        let (Some(first), true) = (s.points_mm.first(), s.first_normals.is_empty()) else { return Ok(Vec::new()) };
        let (first, normal) = (first.get(), s.normal.unwrap_or_else(Direction::z).unit());
        let Extent { low, high } = self.heights(first, normal);
        let flat = high - low <= FLAT * self.seam.length();
        if flat { self.plate_below(first, normal).map(|plate| vec![plate]) } else { Ok(Vec::new()) }
    }

    /// The plate that a seam in a plane lies on, through `point` with outward `normal`.
    pub(super) fn plate_below(&self, point: DVec3, normal: DVec3) -> Result<Solid, Impossible> {
        let middle = self.middle();
        let centre = middle - (middle - point).dot(normal) * normal;
        let farthest = -self.least(|p| -p.distance(centre));
        Ok(self.plate("plate", centre, normal, self.body(0.0, 2.0 * farthest)?)?)
    }
}

/// The corners of a polygon around a rectangle with rounded corners, counter-clockwise: its sides touch the arcs, also
/// at their ends.
fn outline(half: DVec2, radius: f64) -> Vec<DVec2> {
    let count = (0.25 * PI * (radius / (2.0 * WITHIN_MM)).sqrt()).ceil().max(1.0) as usize;
    let step = 0.5 * PI / count as f64;
    let out = radius / (0.5 * step).cos();
    let corners = [DVec2::ONE, DVec2::new(-1.0, 1.0), DVec2::NEG_ONE, DVec2::new(1.0, -1.0)].into_iter().enumerate();
    let around = |(i, quadrant): (usize, DVec2)| {
        let angle = move |k: usize| 0.5 * PI * i as f64 + (k as f64 + 0.5) * step;
        (0..count).map(move |k| quadrant * (half - radius) + out * DVec2::from_angle(angle(k)))
    };
    corners.flat_map(around).collect()
}
