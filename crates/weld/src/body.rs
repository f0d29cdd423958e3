//! The bodies that nozzles stand on, from the keys of a job or program: their outside, and the inside of their wall.

use crate::head;
use glam::DVec3;
use seamwright_document::{Document, DocumentError, Positive};
use seamwright_geometry::{
    Edge, Error, Head, HeadIntersection, Quadric, QuadricDistance, SignedDistance, Torus, TorusIntersection, Tube,
    TubeIntersection,
};
use seamwright_program::Body;

/// A body's surface with its name and size in words.
pub(crate) struct Shell {
    name: &'static str,
    size: String,
    surface: Surface,
}

enum Surface {
    Quadric(Quadric),
    Torus(Torus),
    Head(Head),
}

impl Shell {
    /// The outside.
    ///
    /// # Errors
    /// With the key's address: sizes that contradict each other.
    pub(crate) fn outside<T>(file: &Document<T>, body: &Body) -> Result<Self, DocumentError> {
        Self::below(file, body, 0.0)
    }

    /// The inside of the wall: everywhere its thickness below the outside.
    ///
    /// # Errors
    /// With the key's address: a thickness that is missing or too large, a body whose inside has no closed form.
    pub(crate) fn inside<T>(file: &Document<T>, body: &Body) -> Result<Self, DocumentError> {
        let shell = Self::below(file, body, thickness(file, body)?)?;
        Ok(Self { size: format!("inside of the wall; outside {}", shell.size), ..shell })
    }

    /// The surface `depth` mm below the outside.
    fn below<T>(file: &Document<T>, body: &Body, depth: f64) -> Result<Self, DocumentError> {
        let across = |diameter: Positive| format!("{} mm in diameter", diameter.get());
        let of_head = |name, diameter, head| Ok(Self { name, size: across(diameter), surface: Surface::Head(head) });
        let (name, size, quadric) = match body {
            Body::Cylinder { radius_mm, point_mm, axis, .. } => {
                let r = radius_mm.get();
                ("cylinder", format!("radius {r} mm"), Quadric::cylinder(point_mm.get(), axis.unit(), r - depth))
            }
            Body::Cone { half_angle_deg, apex_mm, axis, .. } => {
                let (degrees, axis) = (half_angle_deg.get(), axis.unit());
                if degrees >= 90.0 {
                    let path = "seam.nozzle.body.cone.half_angle_deg";
                    return Err(file.error_at(path, "not the half angle of a cone", "more than 0 and less than 90"));
                }
                let angle = degrees.to_radians();
                let apex = apex_mm.get() + depth / angle.sin() * axis;
                ("cone", format!("half angle {degrees} degrees"), Quadric::cone(apex, axis, angle))
            }
            Body::Sphere { radius_mm, centre_mm, .. } => {
                let r = radius_mm.get();
                ("sphere", format!("radius {r} mm"), Quadric::sphere(centre_mm.get(), r - depth))
            }
            Body::Ellipsoid { semi_axes_mm, centre_mm, axis, x_direction } => {
                let semi = DVec3::from_array(semi_axes_mm.map(Positive::get));
                let size = format!("semi-axes {} x {} x {} mm", semi.x, semi.y, semi.z);
                ("ellipsoid", size, Quadric::ellipsoid(centre_mm.get(), axis.unit(), x_direction.unit(), semi))
            }
            Body::Plane { point_mm, normal, .. } => {
                let normal = normal.unit();
                let plane = Quadric::plane(point_mm.get() - depth * normal, normal);
                ("plane", "its normal points out of the plate".to_owned(), plane)
            }
            Body::Torus { bend_radius_mm, radius_mm, centre_mm, axis, .. } => {
                let (ring, radius) = (bend_radius_mm.get(), radius_mm.get());
                let path = "seam.nozzle.body.torus.bend_radius_mm";
                if ring <= radius {
                    let message = "the pipe would meet itself in the middle of the bend";
                    return Err(file.error_at(path, message, format!("more than radius_mm = {radius}")));
                }
                let torus = Torus::new(centre_mm.get(), axis.unit(), ring, radius - depth)
                    .map_err(|e| file.error_at(path, e.to_string(), "see the job's schema"))?;
                return Ok(Self { name: "torus", size: format!("radius {radius} mm"), surface: Surface::Torus(torus) });
            }
            Body::TorisphericalHead(h) => {
                return of_head("torispherical head", h.outer_diameter_mm, head::torispherical(file, h, depth)?);
            }
            Body::EllipsoidalHead(h) => {
                return of_head("ellipsoidal head", h.outer_diameter_mm, head::ellipsoidal(file, h)?);
            }
            Body::HemisphericalHead(h) => {
                return of_head("hemispherical head", h.outer_diameter_mm, head::hemispherical(file, h, depth)?);
            }
            Body::FlatHead(h) => return of_head("flat head", h.outer_diameter_mm, head::flat(file, h, depth)?),
            Body::ConicalHead(h) => {
                return of_head("conical head", h.outer_diameter_mm, head::conical(file, h, depth)?);
            }
        };
        let path = format!("seam.nozzle.body.{name}");
        let quadric = quadric.map_err(|e| file.error_at(&path, e.to_string(), "see the job's schema"))?;
        Ok(Self { name, size, surface: Surface::Quadric(quadric) })
    }

    /// The curve where a tube leaves this surface; its faces are the tube's outside and this surface's.
    ///
    /// # Errors
    /// With the key's address: a tube whose wall is not on this surface all round.
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
        };
        edge.map_err(|e| self.unfit(file, &e, radius))
    }

    /// Distances from this surface.
    pub(crate) fn distance(self) -> Box<dyn SignedDistance> {
        match self.surface {
            Surface::Quadric(quadric) => Box::new(QuadricDistance::new(&quadric)),
            Surface::Torus(torus) => Box::new(torus),
            Surface::Head(head) => Box::new(head),
        }
    }

    /// Error of a nozzle of `radius` that does not stand on it.
    fn unfit<T>(&self, file: &Document<T>, e: &Error, radius: f64) -> DocumentError {
        let Self { name, size, .. } = self;
        let (at, allowed) = match e {
            Error::TubeLargerThanBody => ("radius_mm", format!("a nozzle that fits the {name} ({size})")),
            Error::TubeBesideBody => ("origin_mm", format!("an axis that meets the {name} ({size})")),
            Error::NotClosed { .. } => (
                "radius_mm",
                format!("a radius and an axis with the whole wall ({radius} mm about it) on the {name} ({size})"),
            ),
            Error::BeyondHead { .. } => (
                "origin_mm",
                format!(
                    "a nozzle with the whole wall ({radius} mm about its axis) on the {name} ({size}) and its flange"
                ),
            ),
            Error::Tangent { .. } => ("radius_mm", format!("a nozzle smaller than the {name} ({size})")),
            _ => ("direction", format!("a direction out of the {name}")),
        };
        file.error_at(&format!("seam.nozzle.{at}"), e.to_string(), allowed)
    }
}

/// Bodies whose inside is known.
const WITH_INSIDE: &str = "`mount = \"set_on\"`, or a cylinder, cone, sphere, plane, torus, torispherical_head, \
                           hemispherical_head, flat_head or conical_head";

/// The thickness of a body's wall, mm.
///
/// # Errors
/// With the key's address: a missing thickness, a wall without room inside, a body whose inside has no closed form.
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
        Body::Ellipsoid { .. } | Body::EllipsoidalHead(_) => {
            let message = "what lies a thickness below an ellipsoid is no ellipsoid: its inside is not known";
            return Err(file.error_at("seam.nozzle.body", message, WITH_INSIDE));
        }
    };
    let path = format!("seam.nozzle.body.{name}.thickness_mm");
    let allowed = match most {
        Some(("outer_diameter_mm", d)) => format!("more than 0 and less than half of outer_diameter_mm = {}", d.get()),
        Some((key, size)) => format!("more than 0 and less than {key} = {}", size.get()),
        None => "more than 0".to_owned(),
    };
    let Some(given) = given.map(Positive::get) else {
        let message = "the nozzle is set in: the thickness of the body's wall is missing";
        return Err(file.error_at(&path, message, allowed));
    };
    let room = most.map_or(f64::INFINITY, |(key, size)| size.get() * if key == "radius_mm" { 1.0 } else { 0.5 });
    if given >= room {
        return Err(file.error_at(&path, "the wall leaves no room inside", allowed));
    }
    Ok(given)
}
