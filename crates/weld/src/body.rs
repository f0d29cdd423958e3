//! The bodies that nozzles stand on, from the keys of a job or program: their outside, and the inside of their wall.

use crate::allowed::{by_key, more_than, strictly_between};
use crate::{plane_seam, vessel_head};
use glam::DVec3;
use seamwright_document::{Direction, Document, DocumentError, Positive};
use seamwright_geometry::{
    Edge, Error, Head, HeadIntersection, ParallelIntersection, ParallelSurface, Quadric, QuadricDistance,
    SignedDistance, Torus, TorusIntersection, Tube, TubeIntersection,
};
use seamwright_message::{Message, Unit};
use seamwright_program::Body;

/// A body's surface with its description.
pub(crate) struct Shell {
    description: Message,
    surface: Surface,
}

enum Surface {
    Quadric(Quadric),
    Torus(Torus),
    Head(Head),
    Parallel(ParallelSurface),
}

impl Shell {
    /// The outside. Fails with the key's address: sizes that contradict each other.
    pub(crate) fn outside<T>(file: &Document<T>, body: &Body) -> Result<Self, DocumentError> {
        Self::below(file, body, 0.0)
    }

    /// The inside of the wall: everywhere its thickness below the outside. Fails with the key's address: a thickness
    /// that is missing or too large.
    pub(crate) fn inside<T>(file: &Document<T>, body: &Body) -> Result<Self, DocumentError> {
        let shell = Self::below(file, body, thickness(file, body)?)?;
        Ok(Self { description: Message::new("weld-body-inside").message("body", shell.description), ..shell })
    }

    /// The surface `depth` mm below the outside.
    fn below<T>(file: &Document<T>, body: &Body, depth: f64) -> Result<Self, DocumentError> {
        let radius_of = |code, r| Message::new(code).value("radius", r, Unit::Mm);
        let of_head = |code, diameter: Positive, head| {
            let description = Message::new(code).value("diameter", diameter.get(), Unit::Mm);
            Ok(Self { description, surface: Surface::Head(head) })
        };
        let (key, description, quadric) = match body {
            Body::Cylinder { radius_mm, point_mm, axis, .. } => {
                let r = radius_mm.get();
                let cylinder = Quadric::cylinder(point_mm.get(), axis.unit(), r - depth);
                ("cylinder", radius_of("weld-body-cylinder", r), cylinder)
            }
            Body::Cone { half_angle_deg, apex_mm, axis, .. } => {
                let (degrees, axis) = (half_angle_deg.get(), axis.unit());
                if degrees >= 90.0 {
                    let path = "seam.nozzle.body.cone.half_angle_deg";
                    let message = Message::new("weld-cone-angle-too-large");
                    return Err(file.error_at(path, message, strictly_between(0.0, 90.0, Unit::Deg)));
                }
                let angle = degrees.to_radians();
                let apex = apex_mm.get() + depth / angle.sin() * axis;
                let description = Message::new("weld-body-cone").value("angle", degrees, Unit::Deg);
                ("cone", description, Quadric::cone(apex, axis, angle))
            }
            Body::Sphere { radius_mm, centre_mm, .. } => {
                let r = radius_mm.get();
                ("sphere", radius_of("weld-body-sphere", r), Quadric::sphere(centre_mm.get(), r - depth))
            }
            Body::Ellipsoid { semi_axes_mm, centre_mm, axis, x_direction, .. } => {
                let semi = DVec3::from_array(semi_axes_mm.map(Positive::get));
                let description = Message::new("weld-body-ellipsoid").value("a", semi.x, Unit::Mm);
                let description = description.value("b", semi.y, Unit::Mm).value("c", semi.z, Unit::Mm);
                let (centre, z, x) = (centre_mm.get(), axis.unit(), x_direction.unit());
                if depth > 0.0 {
                    let wall = ParallelSurface::below_ellipsoid(centre, z, x, semi, depth).map_err(|e| {
                        let path = "seam.nozzle.body.ellipsoid.thickness_mm";
                        file.error_at(path, e.message(), Message::new("weld-allowed-schema"))
                    })?;
                    return Ok(Self { description, surface: Surface::Parallel(wall) });
                }
                ("ellipsoid", description, Quadric::ellipsoid(centre, z, x, semi))
            }
            Body::Plane { point_mm, normal, .. } => {
                let normal = normal.unit();
                let plane = Quadric::plane(point_mm.get() - depth * normal, normal);
                ("plane", Message::new("weld-body-plane"), plane)
            }
            Body::Torus { bend_radius_mm, radius_mm, centre_mm, axis, .. } => {
                let (ring, radius) = (bend_radius_mm.get(), radius_mm.get());
                let path = "seam.nozzle.body.torus.bend_radius_mm";
                if ring <= radius {
                    let message = Message::new("weld-torus-meets-itself");
                    return Err(file.error_at(
                        path,
                        message,
                        by_key("weld-allowed-more-than-key", "radius_mm", radius),
                    ));
                }
                let torus = Torus::new(centre_mm.get(), axis.unit(), ring, radius - depth)
                    .map_err(|e| file.error_at(path, e.message(), Message::new("weld-allowed-schema")))?;
                return Ok(Self { description: radius_of("weld-body-torus", radius), surface: Surface::Torus(torus) });
            }
            Body::TorisphericalHead(h) => {
                return of_head(
                    "weld-body-torispherical-head",
                    h.outer_diameter_mm,
                    vessel_head::torispherical(file, h, depth)?,
                );
            }
            Body::EllipsoidalHead(h) => {
                return of_head(
                    "weld-body-ellipsoidal-head",
                    h.outer_diameter_mm,
                    vessel_head::ellipsoidal(file, h, depth)?,
                );
            }
            Body::HemisphericalHead(h) => {
                return of_head(
                    "weld-body-hemispherical-head",
                    h.outer_diameter_mm,
                    vessel_head::hemispherical(file, h, depth)?,
                );
            }
            Body::FlatHead(h) => {
                return of_head("weld-body-flat-head", h.outer_diameter_mm, vessel_head::flat(file, h, depth)?);
            }
            Body::ConicalHead(h) => {
                return of_head("weld-body-conical-head", h.outer_diameter_mm, vessel_head::conical(file, h, depth)?);
            }
        };
        let path = format!("seam.nozzle.body.{key}");
        let allowed = || Message::new("weld-allowed-schema");
        let quadric = quadric.map_err(|e| file.error_at(&path, e.message(), allowed()))?;
        Ok(Self { description, surface: Surface::Quadric(quadric) })
    }

    /// The curve where a tube leaves this surface; its faces are the tube's outside and this surface's. Fails with the
    /// key's address: a tube whose wall is not on this surface all round.
    pub(crate) fn edge<T>(
        &self,
        file: &Document<T>,
        tube: &Tube,
    ) -> Result<Box<dyn Edge + Send + Sync>, DocumentError> {
        let tube = tube.clone();
        let radius = tube.radius();
        let edge: Result<Box<dyn Edge + Send + Sync>, Error> = match &self.surface {
            Surface::Quadric(quadric) => TubeIntersection::new(tube, quadric.clone()).map(|e| Box::new(e) as _),
            Surface::Torus(torus) => TorusIntersection::new(tube, torus.clone()).map(|e| Box::new(e) as _),
            Surface::Head(head) => HeadIntersection::new(tube, head.clone()).map(|e| Box::new(e) as _),
            Surface::Parallel(body) => ParallelIntersection::new(tube, body.clone()).map(|e| Box::new(e) as _),
        };
        edge.map_err(|e| self.unfit(file, &e, radius))
    }

    pub(crate) fn distance(self) -> Box<dyn SignedDistance> {
        match self.surface {
            Surface::Quadric(quadric) => Box::new(QuadricDistance::new(&quadric)),
            Surface::Torus(torus) => Box::new(torus),
            Surface::Head(head) => Box::new(head),
            Surface::Parallel(body) => Box::new(body),
        }
    }

    /// Error of a nozzle of `radius` that does not stand on it.
    fn unfit<T>(&self, file: &Document<T>, e: &Error, radius: f64) -> DocumentError {
        let of_radius = |code| Message::new(code).value("radius", radius, Unit::Mm);
        let (at, allowed) = match e {
            Error::TubeLargerThanBody => ("radius_mm", Message::new("weld-allowed-nozzle-fits")),
            Error::TubeBesideBody => ("origin_mm", Message::new("weld-allowed-nozzle-axis")),
            Error::NotClosed { .. } => ("radius_mm", of_radius("weld-allowed-nozzle-on-body")),
            Error::BeyondHead { .. } => ("origin_mm", of_radius("weld-allowed-nozzle-on-head")),
            Error::Tangent { .. } => ("radius_mm", Message::new("weld-allowed-nozzle-smaller")),
            _ => ("direction", Message::new("weld-allowed-nozzle-direction")),
        };
        file.error_at(&format!("seam.nozzle.{at}"), e.message(), allowed.message("body", self.description.clone()))
    }
}

/// The thickness of a body's wall, mm. Fails with the key's address: a missing thickness, a wall without room inside.
pub(crate) fn thickness<T>(file: &Document<T>, body: &Body) -> Result<f64, DocumentError> {
    // Key and size of the upper bound of the wall's thickness.
    let (name, given, most) = match body {
        Body::Cylinder { radius_mm, thickness_mm, .. } => ("cylinder", *thickness_mm, Some(("radius_mm", *radius_mm))),
        Body::Sphere { radius_mm, thickness_mm, .. } => ("sphere", *thickness_mm, Some(("radius_mm", *radius_mm))),
        Body::Torus { radius_mm, thickness_mm, .. } => ("torus", *thickness_mm, Some(("radius_mm", *radius_mm))),
        Body::Cone { thickness_mm, .. } => ("cone", *thickness_mm, None),
        Body::Plane { thickness_mm, .. } => ("plane", *thickness_mm, None),
        Body::HemisphericalHead(h) => {
            ("hemispherical_head", h.thickness_mm, Some(("outer_diameter_mm", h.outer_diameter_mm)))
        }
        // These bodies have checks of their own.
        Body::TorisphericalHead(h) => ("torispherical_head", Some(h.thickness_mm), None),
        Body::FlatHead(h) => ("flat_head", Some(h.thickness_mm), None),
        Body::ConicalHead(h) => ("conical_head", Some(h.thickness_mm), None),
        Body::Ellipsoid { thickness_mm, .. } => ("ellipsoid", *thickness_mm, None),
        Body::EllipsoidalHead(h) => {
            ("ellipsoidal_head", h.thickness_mm, Some(("outer_diameter_mm", h.outer_diameter_mm)))
        }
    };
    let path = format!("seam.nozzle.body.{name}.thickness_mm");
    let allowed = match most {
        Some((key @ "outer_diameter_mm", size)) => by_key("weld-allowed-positive-less-than-half-key", key, size.get()),
        Some((key, size)) => by_key("weld-allowed-positive-less-than-key", key, size.get()),
        None => more_than(0.0, Unit::Mm),
    };
    let Some(given) = given.map(Positive::get) else {
        return Err(file.error_at(&path, Message::new("weld-set-in-wall-missing"), allowed));
    };
    let room = most.map_or(f64::INFINITY, |(key, size)| size.get() * if key == "radius_mm" { 1.0 } else { 0.5 });
    if given >= room {
        return Err(file.error_at(&path, Message::new("weld-wall-leaves-no-room"), allowed));
    }
    Ok(given)
}

/// A tube whose angle phi counts from `zero`; without one from x, or from y on a tube along x.
pub(crate) fn tube(origin: DVec3, direction: DVec3, zero: Option<Direction>, radius: f64) -> Result<Tube, Error> {
    Tube::new(origin, direction, plane_seam::zero(direction, zero), radius)
}
