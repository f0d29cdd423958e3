use super::swept::WITHIN_MM;
use super::vessel_heads::{bend, turned};
use super::{Extent, Impossible, Making, PLATE_MM, standing};
use crate::branch::{Joint, Leg};
use crate::vessel_head;
use glam::{DAffine3, DMat3, DVec3};
use seamwright_clearance::{ClearanceError, Mesh, Shape, Solid};
use seamwright_document::{Document, Positive};
use seamwright_program::{Body, Branch, Girth, Helix, Nozzle, NozzleCurve};
use std::f64::consts::PI;
use std::sync::Arc;

/// Maximum distance of a dome's mesh outside the ellipsoid, mm.
const DOME_MM: f64 = 0.1;
/// Larger ellipsoids stay whole, mm: their domes would take millions of triangles.
const LARGEST_DOME_MM: f64 = 5_000.0;

/// The upper half of an ellipsoid as a mesh around it.
fn dome(semi_axes: DVec3) -> Result<Shape, ClearanceError> {
    let step = 2.0 * (DOME_MM / semi_axes.max_element()).sqrt();
    let rings = (0.5 * PI / step).ceil().max(6.0) as usize;
    let around = 4 * rings;
    // Flat sides between points of the unit sphere come nearer to its middle by the cosines of half the steps.
    let (d, e) = (0.25 * PI / rings as f64, PI / around as f64);
    let outside = semi_axes / (d.cos() * e.cos());
    let point = |ring: usize, i: usize| {
        let (up, out) = (0.5 * PI * ring as f64 / rings as f64).sin_cos();
        let (sin, cos) = (2.0 * PI * (i % around) as f64 / around as f64).sin_cos();
        outside * DVec3::new(out * cos, out * sin, up)
    };
    let top = outside * DVec3::Z;
    let mut triangles = Vec::with_capacity(2 * rings * around);
    for i in 0..around {
        for ring in 0..rings - 1 {
            let [a, b] = [point(ring, i), point(ring, i + 1)];
            let [c, d] = [point(ring + 1, i), point(ring + 1, i + 1)];
            triangles.extend([[a, b, d], [a, d, c]]);
        }
        triangles.push([point(rings - 1, i), point(rings - 1, i + 1), top]);
        triangles.push([point(0, i + 1), point(0, i), DVec3::ZERO]);
    }
    Mesh::new(&triangles).map(|mesh| Shape::Mesh(Arc::new(mesh)))
}

/// The end of a nozzle inside its body: a disc.
pub(super) struct Foot {
    pub(super) centre: DVec3,
    pub(super) along: DVec3,
    pub(super) radius: f64,
}

impl Foot {
    /// The seam's `heights` over `from` along `axis`, and this end's too.
    fn with(&self, heights: Extent, from: DVec3, axis: DVec3) -> Extent {
        let middle = (self.centre - from).dot(axis);
        let half = self.radius * self.along.cross(axis).length();
        Extent { low: heights.low.min(middle - half), high: heights.high.max(middle + half) }
    }
}

impl Making<'_> {
    /// A nozzle's tube from the seam's lowest point on, and its body.
    pub(super) fn nozzle<T>(&self, file: &Document<T>, nozzle: &Nozzle) -> Result<Vec<Solid>, Impossible> {
        if nozzle.curve == NozzleCurve::InnerRoot {
            return self.root(file, nozzle);
        }
        let (origin, along, radius) = (nozzle.origin_mm.get(), nozzle.direction.unit(), nozzle.radius_mm.get());
        let Extent { low, high } = self.heights(origin, along);
        let length = high - low + self.nozzle_mm;
        let foot = Foot { centre: origin + low * along, along, radius };
        let tube = Solid::new("nozzle", Shape::Cylinder { radius, length }, standing(foot.centre, along))?;
        Ok(vec![tube, self.nozzle_body(file, &nozzle.body, &foot)?])
    }

    /// A branch's tube from the seam's lowest point on, and the chord.
    pub(super) fn branch<T>(&self, file: &Document<T>, branch: &Branch) -> Result<Vec<Solid>, Impossible> {
        let Joint { tube, chord, other, .. } = Joint::new(file, branch)?;
        let (origin, along, radius) = (tube.origin(), tube.direction(), tube.radius());
        let Extent { low, high } = self.heights(origin, along);
        let length = high - low + self.nozzle_mm;
        let foot = Foot { centre: origin + low * along, along, radius };
        let mut solids = vec![Solid::new("branch", Shape::Cylinder { radius, length }, standing(foot.centre, along))?];
        let mut extent = foot.with(self.heights(DVec3::ZERO, DVec3::X), DVec3::ZERO, DVec3::X);
        if let Some(Leg { origin, direction, radius }) = other {
            let beside = radius / direction.z + chord * (direction.x / direction.z).abs();
            extent = Extent { low: extent.low.min(origin.x - beside), high: extent.high.max(origin.x + beside) };
        }
        let length = self.body(6.0 * radius, extent.high - extent.low)?;
        let start = 0.5 * (extent.low + extent.high - length) * DVec3::X;
        solids.push(Solid::new("chord", Shape::Cylinder { radius: chord, length }, standing(start, DVec3::X))?);
        Ok(solids)
    }

    /// The other branch of a K-joint.
    pub(super) fn other_branch<T>(&self, file: &Document<T>, branch: &Branch) -> Result<Option<Solid>, Impossible> {
        let Joint { chord, other, .. } = Joint::new(file, branch)?;
        let Some(Leg { origin, direction, radius }) = other else { return Ok(None) };
        // Above the chord on all sides, and beyond the seam.
        let out = (chord + radius * direction.x.abs()) / direction.z;
        let length = self.heights(origin, direction).high.max(out) + self.nozzle_mm;
        Ok(Some(Solid::new("other branch", Shape::Cylinder { radius, length }, standing(origin, direction))?))
    }

    pub(super) fn nozzle_body<T>(&self, file: &Document<T>, body: &Body, foot: &Foot) -> Result<Solid, Impossible> {
        let usual = 6.0 * foot.radius;
        let solid = match body {
            Body::Cylinder { radius_mm, point_mm, axis, .. } => {
                let (point, axis) = (point_mm.get(), axis.unit());
                let Extent { low, high } = foot.with(self.heights(point, axis), point, axis);
                let length = self.body(usual, high - low)?;
                let start = point + 0.5 * (low + high - length) * axis;
                Solid::new("shell", Shape::Cylinder { radius: radius_mm.get(), length }, standing(start, axis))
            }
            Body::Cone { half_angle_deg, apex_mm, axis, .. } => {
                let (apex, axis) = (apex_mm.get(), axis.unit());
                let slope = half_angle_deg.get().to_radians().tan();
                let Extent { low, high } = foot.with(self.heights(apex, axis), apex, axis);
                let more = 0.5 * (self.body(usual, high - low)? - (high - low));
                let (from, to) = ((low - more).max(0.0), high + more);
                let shape = Shape::Cone { radius: from * slope, top_radius: to * slope, length: to - from };
                Solid::new("cone", shape, standing(apex + from * axis, axis))
            }
            Body::Sphere { radius_mm, centre_mm, .. } => {
                let pose = DAffine3::from_translation(centre_mm.get());
                Solid::new("sphere", Shape::Sphere { radius: radius_mm.get() }, pose)
            }
            Body::Ellipsoid { semi_axes_mm, centre_mm, axis, x_direction, .. } => {
                let z = axis.unit();
                let x = x_direction.unit();
                // The seam was made from the same directions: they are not parallel.
                let x = (x - x.dot(z) * z).normalize();
                let semi_axes = DVec3::from_array(semi_axes_mm.map(Positive::get));
                // A head is half an ellipsoid, unless the seam goes over its rim.
                let Extent { low, high } = self.heights(centre_mm.get(), z);
                let z = if high < 0.0 { -z } else { z };
                let axes = DMat3::from_cols(x, z.cross(x), z);
                let pose = DAffine3::from_mat3_translation(axes, centre_mm.get());
                let head = low * high > 0.0 && semi_axes.max_element() <= LARGEST_DOME_MM;
                let shape = if head { dome(semi_axes)? } else { Shape::Ellipsoid { semi_axes } };
                Solid::new("head", shape, pose)
            }
            Body::Plane { point_mm, normal, .. } => {
                let (middle, normal) = (self.middle(), normal.unit());
                let centre = middle - (middle - point_mm.get()).dot(normal) * normal;
                let farthest = -self.least(|p| -p.distance(centre));
                self.plate("plate", centre, normal, self.body(usual, 2.0 * farthest)?)
            }
            Body::Torus { bend_radius_mm, radius_mm, centre_mm, axis, .. } => {
                let pose = standing(centre_mm.get(), axis.unit());
                Solid::new("bend", bend(bend_radius_mm.get(), radius_mm.get())?, pose)
            }
            Body::TorisphericalHead(h) => self.vessel_head(&vessel_head::torispherical(file, h, 0.0)?),
            Body::EllipsoidalHead(h) => self.vessel_head(&vessel_head::ellipsoidal(file, h, 0.0)?),
            Body::HemisphericalHead(h) => self.vessel_head(&vessel_head::hemispherical(file, h, 0.0)?),
            Body::FlatHead(h) => self.vessel_head(&vessel_head::flat(file, h, 0.0)?),
            Body::ConicalHead(h) => self.vessel_head(&vessel_head::conical(file, h, 0.0)?),
        };
        Ok(solid?)
    }

    /// The cylinder that a helix lies on, going on to both sides of it.
    pub(super) fn helix(&self, helix: &Helix) -> Result<Vec<Solid>, Impossible> {
        let (centre, along) = (helix.origin_mm.get(), helix.direction.unit());
        self.cylinder("cylinder", &Foot { centre, along, radius: helix.radius_mm.get() }, 0.0)
    }

    /// A tube that extends to both sides of the cut; with the torch inside, its wall.
    pub(super) fn girth(&self, girth: &Girth) -> Result<Vec<Solid>, Impossible> {
        let (centre, along, radius) = (girth.origin_mm.get(), girth.direction.unit(), girth.radius_mm.get());
        if girth.inside {
            let Extent { low, high } = self.heights(centre, along);
            let length = self.body(6.0 * radius, high - low)?;
            let outside = radius + PLATE_MM;
            let shape = turned(&[(outside, 0.0), (outside, length)], &[(radius, length), (radius, 0.0)], WITHIN_MM)?;
            let start = centre + 0.5 * (low + high - length) * along;
            return Ok(vec![Solid::new("tube", shape, standing(start, along))?]);
        }
        self.cylinder("tube", &Foot { centre, along, radius }, 6.0 * radius)
    }

    /// A cylinder that goes on to both sides of the seam.
    fn cylinder(&self, name: &str, foot: &Foot, usual: f64) -> Result<Vec<Solid>, Impossible> {
        let Foot { centre, along, radius } = *foot;
        let Extent { low, high } = self.heights(centre, along);
        let length = self.body(usual, high - low)?;
        let start = centre + (0.5 * (low + high - length)) * along;
        Ok(vec![Solid::new(name, Shape::Cylinder { radius, length }, standing(start, along))?])
    }
}
