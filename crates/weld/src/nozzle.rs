use crate::head;
use crate::seam::tube;
use glam::DVec3;
use seamwright_document::{Document, DocumentError, Positive};
use seamwright_geometry::{
    Edge, Error, Head, HeadIntersection, Quadric, QuadricDistance, SignedDistance, Torus, TorusIntersection, Tube,
    TubeIntersection,
};
use seamwright_program::{Body, Nozzle};

/// A nozzle where it stands on its body.
pub(crate) struct OnBody {
    /// The seam.
    pub(crate) edge: Box<dyn Edge + Send + Sync>,
    /// The nozzle's outside.
    pub(crate) tube: Tube,
    /// The body's outside.
    pub(crate) body: Box<dyn SignedDistance>,
}

impl OnBody {
    /// The nozzle of a job or program file.
    ///
    /// # Errors
    /// With the key's address: sizes that contradict each other, a nozzle whose wall is not on the body all round.
    pub(crate) fn new<T>(file: &Document<T>, n: &Nozzle) -> Result<Self, DocumentError> {
        let radius = n.radius_mm.get();
        let tube = tube(n.origin_mm.get(), n.direction.unit(), n.zero_direction, radius)
            .map_err(|e| file.error_at("seam.nozzle.zero_direction", e.to_string(), "not along `direction`"))?;
        let (name, size, surface) = body(file, &n.body)?;
        let unfit = |e: Error| unfit(file, &e, radius, (name, &size));
        Ok(match surface {
            Surface::Quadric(body) => {
                let distance = Box::new(QuadricDistance::new(&body));
                let curve = TubeIntersection::new(tube.clone(), body).map_err(unfit)?;
                Self { edge: Box::new(curve), tube, body: distance }
            }
            Surface::Torus(torus) => {
                let curve = TorusIntersection::new(tube.clone(), torus.clone()).map_err(unfit)?;
                Self { edge: Box::new(curve), tube, body: Box::new(torus) }
            }
            Surface::Head(head) => {
                let curve = HeadIntersection::new(tube.clone(), head.clone()).map_err(unfit)?;
                Self { edge: Box::new(curve), tube, body: Box::new(head) }
            }
        })
    }
}

/// A body's outside.
enum Surface {
    Quadric(Quadric),
    Torus(Torus),
    Head(Head),
}

/// Why a nozzle of `radius` does not stand on a body with this name and size.
fn unfit<T>(file: &Document<T>, e: &Error, radius: f64, (name, size): (&str, &str)) -> DocumentError {
    let (at, allowed) = match e {
        Error::TubeLargerThanBody => ("radius_mm", format!("a nozzle that fits the {name} ({size})")),
        Error::TubeBesideBody => ("origin_mm", format!("an axis that meets the {name} ({size})")),
        Error::NotClosed { .. } => (
            "radius_mm",
            format!("a radius and an axis with the whole wall ({radius} mm about it) on the {name} ({size})"),
        ),
        Error::BeyondHead { .. } => (
            "origin_mm",
            format!("a nozzle with the whole wall ({radius} mm about its axis) on the {name} ({size}) and its flange"),
        ),
        Error::Tangent { .. } => ("radius_mm", format!("a nozzle smaller than the {name} ({size})")),
        _ => ("direction", format!("a direction out of the {name}")),
    };
    file.error_at(&format!("seam.nozzle.{at}"), e.to_string(), allowed)
}

/// The body with its name and size in words.
fn body<T>(file: &Document<T>, body: &Body) -> Result<(&'static str, String, Surface), DocumentError> {
    let across = |diameter: Positive| format!("{} mm in diameter", diameter.get());
    let of_head = |name, diameter, head| Ok((name, across(diameter), Surface::Head(head)));
    let (name, size, quadric) = match body {
        Body::Cylinder { radius_mm, point_mm, axis } => {
            let r = radius_mm.get();
            ("cylinder", format!("radius {r} mm"), Quadric::cylinder(point_mm.get(), axis.unit(), r))
        }
        Body::Cone { half_angle_deg, apex_mm, axis } => {
            let angle = half_angle_deg.get();
            if angle >= 90.0 {
                let path = "seam.nozzle.body.cone.half_angle_deg";
                return Err(file.error_at(path, "not the half angle of a cone", "more than 0 and less than 90"));
            }
            let quadric = Quadric::cone(apex_mm.get(), axis.unit(), angle.to_radians());
            ("cone", format!("half angle {angle} degrees"), quadric)
        }
        Body::Sphere { radius_mm, centre_mm } => {
            let r = radius_mm.get();
            ("sphere", format!("radius {r} mm"), Quadric::sphere(centre_mm.get(), r))
        }
        Body::Ellipsoid { semi_axes_mm, centre_mm, axis, x_direction } => {
            let semi = DVec3::from_array(semi_axes_mm.map(Positive::get));
            let size = format!("semi-axes {} x {} x {} mm", semi.x, semi.y, semi.z);
            ("ellipsoid", size, Quadric::ellipsoid(centre_mm.get(), axis.unit(), x_direction.unit(), semi))
        }
        Body::Plane { point_mm, normal } => {
            ("plane", "its normal points out of the plate".to_owned(), Quadric::plane(point_mm.get(), normal.unit()))
        }
        Body::Torus { bend_radius_mm, radius_mm, centre_mm, axis } => {
            let (ring, radius) = (bend_radius_mm.get(), radius_mm.get());
            let path = "seam.nozzle.body.torus.bend_radius_mm";
            if ring <= radius {
                let message = "the pipe would meet itself in the middle of the bend";
                return Err(file.error_at(path, message, format!("more than radius_mm = {radius}")));
            }
            let torus = Torus::new(centre_mm.get(), axis.unit(), ring, radius)
                .map_err(|e| file.error_at(path, e.to_string(), "see the job's schema"))?;
            return Ok(("torus", format!("radius {radius} mm"), Surface::Torus(torus)));
        }
        Body::TorisphericalHead(h) => {
            return of_head("torispherical head", h.outer_diameter_mm, head::torispherical(file, h)?);
        }
        Body::EllipsoidalHead(h) => {
            return of_head("ellipsoidal head", h.outer_diameter_mm, head::ellipsoidal(file, h)?);
        }
        Body::HemisphericalHead(h) => {
            return of_head("hemispherical head", h.outer_diameter_mm, head::hemispherical(file, h)?);
        }
        Body::FlatHead(h) => return of_head("flat head", h.outer_diameter_mm, head::flat(file, h)?),
        Body::ConicalHead(h) => return of_head("conical head", h.outer_diameter_mm, head::conical(file, h)?),
    };
    let path = format!("seam.nozzle.body.{name}");
    let quadric = quadric.map_err(|e| file.error_at(&path, e.to_string(), "see the job's schema"))?;
    Ok((name, size, Surface::Quadric(quadric)))
}
