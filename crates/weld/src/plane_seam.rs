//! Seams in a plane: circles, arcs, rectangles and straight lines on plates.

use crate::allowed::{at_least, between, not_along};
use glam::{DVec2, DVec3};
use seamwright_document::{Direction, Document, DocumentError};
use seamwright_geometry::{self as geometry, Chain, CurvedEdge, Ellipse, FaceRule};
use seamwright_message::{Message, Unit};
use seamwright_program::{Arc, Circle, FilletOrButt, Polyline, RimJoint, RoundedRectangle, Seam, WallFaces};

/// Sine of the largest angle between a plate's normal as given and as its points have it.
const TILTED: f64 = 1e-6;

/// The faces along a curve in the plate with unit `normal`; the wall of a fillet stands on it.
pub(crate) fn faces(joint: FilletOrButt, wall: WallFaces, normal: DVec3) -> FaceRule {
    match joint {
        FilletOrButt::Fillet => FaceRule::WallOnPlate { plate: normal, left: wall == WallFaces::Left },
        FilletOrButt::Butt => FaceRule::Fixed { n1: normal, n2: normal },
    }
}

/// The faces along a closed curve in the plate with unit `normal`: of a wall that stands on it, of the plate, or of the
/// wall below the plate's rim.
pub(crate) fn rim_faces(joint: RimJoint, normal: DVec3) -> FaceRule {
    let joint = if joint == RimJoint::Butt { FilletOrButt::Butt } else { FilletOrButt::Fillet };
    faces(joint, WallFaces::Right, normal)
}

/// True if the seam runs along an outside corner.
pub(crate) fn is_corner(seam: &Seam) -> bool {
    let joint = match seam {
        Seam::Circle(c) => c.joint,
        Seam::Ellipse(e) => e.joint,
        Seam::RoundedRectangle(r) => r.joint,
        _ => return false,
    };
    joint == RimJoint::Corner
}

/// Direction of angle 0 about `axis`: as given, or x, or y about an axis along x.
pub(crate) fn zero(axis: DVec3, given: Option<Direction>) -> DVec3 {
    let along_x = axis.dot(DVec3::X).abs() > 1.0 - 1e-9;
    given.map_or(if along_x { DVec3::Y } else { DVec3::X }, Direction::unit)
}

/// The edge of a circular seam, by the angle about its normal.
pub(crate) fn circle<T>(file: &Document<T>, c: &Circle) -> Result<CurvedEdge<Ellipse>, DocumentError> {
    let (normal, radius) = (c.normal.unit(), c.radius_mm.get());
    let curve =
        Ellipse::new(c.centre_mm.get(), normal, zero(normal, c.zero_direction), radius, radius).map_err(|_| {
            let message = Message::new("weld-zero-direction-along-normal");
            file.error_at("seam.circle.zero_direction", message, not_along("normal"))
        })?;
    Ok(CurvedEdge { curve, faces: rim_faces(c.joint, normal) })
}

pub(crate) fn arc<T>(file: &Document<T>, a: &Arc) -> Result<CurvedEdge<geometry::Arc>, DocumentError> {
    let curve = geometry::Arc::through(a.start_mm.get(), a.via_mm.get(), a.end_mm.get()).map_err(|e| {
        file.error_at("seam.arc.via_mm", e.message(), Message::new("weld-allowed-point-off-line-or-line-seam"))
    })?;
    let (normal, axis) = (a.normal.unit(), curve.axis());
    if normal.cross(axis).length() > TILTED {
        let off = normal.dot(axis).abs().acos().to_degrees();
        let message = Message::new("weld-arc-normal-off").quantity("angle", off, Unit::Deg, 4);
        // Without the sign of a zero.
        let [x, y, z] = axis.to_array().map(|x| (x * 1e9).round() / 1e9 + 0.0);
        let allowed = Message::new("weld-allowed-arc-normal").text("normal", format!("[{x}, {y}, {z}]"));
        return Err(file.error_at("seam.arc.normal", message, allowed));
    }
    Ok(CurvedEdge { curve, faces: faces(a.joint, a.wall_faces, normal) })
}

pub(crate) fn rectangle<T>(
    file: &Document<T>,
    r: &RoundedRectangle,
) -> Result<CurvedEdge<geometry::RoundedRectangle>, DocumentError> {
    let normal = r.normal.unit();
    let size = DVec2::new(r.width_mm.get(), r.height_mm.get());
    let most = 0.5 * size.min_element();
    if r.corner_mm.get() > most {
        let message = Message::new("weld-corner-radius-too-large");
        return Err(file.error_at("seam.rounded_rectangle.corner_mm", message, between(0.0, most, Unit::Mm)));
    }
    let direction = zero(normal, r.width_direction);
    let curve = geometry::RoundedRectangle::new(r.centre_mm.get(), normal, direction, size, r.corner_mm.get())
        .map_err(|e| file.error_at("seam.rounded_rectangle.width_direction", e.message(), not_along("normal")))?;
    Ok(CurvedEdge { curve, faces: rim_faces(r.joint, normal) })
}

/// The edge of a seam along straight lines.
pub(crate) fn polyline<T>(file: &Document<T>, p: &Polyline) -> Result<CurvedEdge<Chain>, DocumentError> {
    let path = "seam.polyline.points_mm";
    let (points, normal): (Vec<DVec3>, _) = (p.points_mm.iter().map(|p| p.get()).collect(), p.normal.unit());
    let least: u8 = if p.closed { 3 } else { 2 };
    if points.len() < usize::from(least) {
        let message = Message::new("weld-point-count").count("count", points.len());
        return Err(file.error_at(path, message, at_least(f64::from(least), Unit::One)));
    }
    let size = points.iter().map(|p| p.distance(points[0])).fold(0.0, f64::max);
    for (i, point) in points.iter().enumerate() {
        let path = format!("{path}[{i}]");
        let height = (point - points[0]).dot(normal);
        if height.abs() > TILTED * size {
            let code = if height > 0.0 { "weld-point-above-plate" } else { "weld-point-below-plate" };
            let message = Message::new(code).quantity("height", height.abs(), Unit::Mm, 6);
            return Err(file.error_at(&path, message, Message::new("weld-allowed-point-in-plane")));
        }
        if i > 0 && point.distance(points[i - 1]) <= TILTED * size {
            let message = Message::new("weld-point-repeated");
            return Err(file.error_at(&path, message, Message::new("weld-allowed-points-apart")));
        }
    }
    let last = points.len() - 1;
    if p.closed && points[last].distance(points[0]) <= TILTED * size {
        let message = Message::new("weld-last-point-repeated");
        return Err(file.error_at(&format!("{path}[{last}]"), message, Message::new("weld-allowed-leave-point-out")));
    }
    let allowed = || Message::new("weld-allowed-other-points");
    let curve = Chain::through(&points, p.closed).map_err(|e| file.error_at(path, e.message(), allowed()))?;
    Ok(CurvedEdge { curve, faces: faces(p.joint, p.wall_faces, normal) })
}
