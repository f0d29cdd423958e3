//! T-joints: the fillets on both sides of a web.

use seamwright_document::{Document, DocumentError, Point};
use seamwright_geometry::{Arc, Curve, CurvedEdge, Edge, Error, FaceRule, Line};
use seamwright_program::{Side, TJoint};

/// Sine of the least angle between the skin's normal as given and the web: below it the two were mixed up.
const LEAST_SINE: f64 = 0.1;

/// The left fillet's edge, or the right one's: the web's middle line moved sideways by half its thickness. First face the
/// web, second the skin.
pub(crate) fn edge<T>(file: &Document<T>, joint: &TJoint) -> Result<Box<dyn Edge + Send + Sync>, DocumentError> {
    let key = |k: &str| format!("seam.t_joint.{k}");
    let (start, end) = (joint.start_mm.get(), joint.end_mm.get());
    let end_wrong = |e: Error| file.error_at(&key("end_mm"), e.to_string(), "another point than `start_mm`");
    let line = Line::new(start, end).map_err(end_wrong)?;
    let arc = joint.via_mm.map(|via| Arc::through(start, Point::get(via), end)).transpose().map_err(|e| {
        file.error_at(&key("via_mm"), e.to_string(), "a point off the straight line from start to end, or no such key")
    })?;
    let along = arc.as_ref().map_or_else(|| line.jet(0.0).d1, |a| a.jet(0.0).d1).normalize();
    let given = joint.skin_normal.unit();
    let across = given - given.dot(along) * along;
    let skin = across.try_normalize().filter(|_| across.length() > LEAST_SINE).ok_or_else(|| {
        let message = "the skin's normal lies along the web";
        file.error_at(&key("skin_normal"), message, "a direction out of the skin")
    })?;
    // To the left of the weld with the skin below.
    let left = skin.cross(along);
    let web = if joint.fillet == Side::Right { -left } else { left };
    let shift = 0.5 * joint.web_mm.get() * web;
    match arc {
        None => {
            let curve = Line::new(start + shift, end + shift).map_err(end_wrong)?;
            Ok(Box::new(CurvedEdge { curve, faces: FaceRule::Fixed { n1: web, n2: skin } }))
        }
        Some(arc) => {
            let curve = arc.shifted(shift).map_err(|e| {
                file.error_at(&key("web_mm"), e.to_string(), "a web that is thin against the arc's radius")
            })?;
            let faces = FaceRule::Turning { axis: arc.axis(), n1: web, n2: skin };
            Ok(Box::new(CurvedEdge { curve, faces }))
        }
    }
}
