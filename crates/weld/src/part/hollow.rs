//! Parts that the torch goes into: a nozzle with its bore, and the wall of a body, open where the torch comes in.

use super::swept::WITHIN_MM;
use super::tubes::Foot;
use super::vessel_heads::{head_within, turned};
use super::{Extent, Impossible, Making, standing};
use crate::body::thickness;
use crate::nozzle::{NozzleEdges, bore};
use crate::vessel_head;
use glam::{DAffine3, DMat3, DVec3};
use seamwright_clearance::{Shape, Solid};
use seamwright_document::Document;
use seamwright_geometry::{Curve, Flange, Head};
use seamwright_message::Message;
use seamwright_program::{Body, Mount, Nozzle};
use std::f64::consts::TAU;

/// Number of points around a curve that give its extent.
const PLACES: u32 = 720;

impl Making<'_> {
    /// Solids around the torch at a nozzle's root.
    ///
    /// Set on: the nozzle with its bore, and the body with its outside. Set in: the nozzle, as far beyond the seam
    /// inside as it goes on outside, and the body's wall. Cylinders and cones are open at their ends. A sphere is the
    /// half that the nozzle is in, a head is open at its flange; a pipe bend is left out.
    pub(super) fn root<T>(&self, file: &Document<T>, nozzle: &Nozzle) -> Result<Vec<Solid>, Impossible> {
        let (origin, along, radius) = (nozzle.origin_mm.get(), nozzle.direction.unit(), nozzle.radius_mm.get());
        let edges = NozzleEdges::new(file, nozzle)?;
        let height = |curve: &dyn Curve| {
            let at = |i: u32| (curve.point(TAU * f64::from(i) / f64::from(PLACES)) - origin).dot(along);
            (0..PLACES).map(at).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)))
        };
        let (toe, root) = (height(&edges.outer_toe), height(&edges.inner_root));
        let top = toe.1.max(root.1) + self.nozzle_mm;
        match (nozzle.mount, bore(file, nozzle)?) {
            (Mount::SetOn, Some(bore)) => {
                // A little within the body, so that no gap is left between stations.
                let low = toe.0.min(root.0) - 0.01 * radius;
                let foot = Foot { centre: origin + low * along, along, radius };
                let wall = [(radius, 0.0), (radius, top - low)];
                let inner = [(bore.radius(), top - low), (bore.radius(), 0.0)];
                let shape = turned(&wall, &inner, WITHIN_MM)?;
                Ok(vec![
                    Solid::new("nozzle", shape, standing(foot.centre, along))?,
                    self.nozzle_body(file, &nozzle.body, &foot)?,
                ])
            }
            _ => {
                let low = root.0 - self.nozzle_mm;
                let shape = Shape::Cylinder { radius, length: top - low };
                let mut solids = vec![Solid::new("nozzle", shape, standing(origin + low * along, along))?];
                solids.extend(self.wall(file, nozzle)?);
                Ok(solids)
            }
        }
    }

    /// The wall of the body that a nozzle is set into.
    fn wall<T>(&self, file: &Document<T>, nozzle: &Nozzle) -> Result<Option<Solid>, Impossible> {
        let thick = thickness(file, &nozzle.body)?;
        let usual = 6.0 * nozzle.radius_mm.get();
        let lengthwise = |point: DVec3, axis: DVec3| -> Result<(f64, f64), Impossible> {
            let Extent { low, high } = self.heights(point, axis);
            let more = 0.5 * (self.body(usual, high - low)? - (high - low));
            Ok((low - more, high + more))
        };
        let vessel =
            |outer: Head, inner: &dyn Fn(f64) -> Result<Head, Impossible>| -> Result<Option<Solid>, Impossible> {
                let within = head_within(&outer);
                let mut inside = inner(thick + within)?.outline(within);
                inside.reverse();
                let shape = turned(&outer.outline(within), &inside, within)?;
                Ok(Some(Solid::new("head", shape, standing(outer.centre(), outer.axis()))?))
            };
        Ok(match &nozzle.body {
            Body::Cylinder { radius_mm, point_mm, axis, .. } => {
                let (radius, axis) = (radius_mm.get(), axis.unit());
                let (from, to) = lengthwise(point_mm.get(), axis)?;
                let inside = radius - thick;
                let shape =
                    turned(&[(radius, 0.0), (radius, to - from)], &[(inside, to - from), (inside, 0.0)], WITHIN_MM)?;
                Some(Solid::new("shell", shape, standing(point_mm.get() + from * axis, axis))?)
            }
            Body::Cone { half_angle_deg, apex_mm, axis, .. } => {
                let (angle, axis) = (half_angle_deg.get().to_radians(), axis.unit());
                let (from, to) = lengthwise(apex_mm.get(), axis)?;
                // The inside starts with an apex of its own; a cone that reaches it is closed there.
                let (slope, apex) = (angle.tan(), thick / angle.sin());
                let from = if from > apex { from } else { 0.0 };
                let inner = from.max(apex);
                let shape = turned(
                    &[(from * slope, from), (to * slope, to)],
                    &[((to - apex) * slope, to), ((inner - apex) * slope, inner)],
                    WITHIN_MM,
                )?;
                Some(Solid::new("cone", shape, standing(apex_mm.get(), axis))?)
            }
            Body::Plane { point_mm, normal, .. } => {
                let (middle, normal) = (self.middle(), normal.unit());
                let centre = middle - (middle - point_mm.get()).dot(normal) * normal;
                let farthest = -self.least(|p| -p.distance(centre));
                let side = self.body(usual, 2.0 * farthest)?;
                let x = normal.any_orthonormal_vector();
                let axes = DMat3::from_cols(x, normal.cross(x), normal);
                let pose = DAffine3::from_mat3_translation(axes, centre - 0.5 * thick * normal);
                Some(Solid::new("plate", Shape::Box { size: DVec3::new(side, side, thick) }, pose)?)
            }
            Body::Sphere { radius_mm, centre_mm, .. } => {
                // The middle of the seam is off the sphere's centre: the nozzle is smaller than the sphere.
                let up = self.middle() - centre_mm.get();
                let half = |depth: f64| {
                    let radius = radius_mm.get() - depth;
                    let flange = Flange { centre: centre_mm.get(), axis: up, radius, length: 0.0 };
                    Head::hemispherical(flange).map_err(|e| {
                        let allowed = Message::new("weld-allowed-sphere");
                        Impossible::Document(file.error_at("seam.nozzle.body.sphere", e.message(), allowed))
                    })
                };
                vessel(half(0.0)?, &half)?
            }
            Body::TorisphericalHead(h) => vessel(vessel_head::torispherical(file, h, 0.0)?, &|depth| {
                Ok(vessel_head::torispherical(file, h, depth)?)
            })?,
            Body::HemisphericalHead(h) => vessel(vessel_head::hemispherical(file, h, 0.0)?, &|depth| {
                Ok(vessel_head::hemispherical(file, h, depth)?)
            })?,
            Body::FlatHead(h) => {
                vessel(vessel_head::flat(file, h, 0.0)?, &|depth| Ok(vessel_head::flat(file, h, depth)?))?
            }
            Body::ConicalHead(h) => {
                vessel(vessel_head::conical(file, h, 0.0)?, &|depth| Ok(vessel_head::conical(file, h, depth)?))?
            }
            Body::EllipsoidalHead(h) => {
                vessel(vessel_head::ellipsoidal(file, h, 0.0)?, &|depth| Ok(vessel_head::ellipsoidal(file, h, depth)?))?
            }
            Body::Torus { .. } | Body::Ellipsoid { .. } => None,
        })
    }
}
