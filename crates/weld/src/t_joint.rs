//! T-joints: the fillets on both sides of a web.

use crate::allowed::other_point;
use glam::DVec3;
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::{Arc, Curve, CurvedEdge, Edge, Error, FaceRule, Line};
use seamwright_message::Message;
use seamwright_program::{Side, TJoint};

/// Minimum sine of the angle between the skin's normal as given and the web: below it the two were mixed up.
const MIN_SINE: f64 = 0.1;

/// The middle line of a web on its skin, with the directions at its start.
pub(crate) struct Middle {
    pub(crate) start: DVec3,
    pub(crate) end: DVec3,
    /// Unit vectors to the left of the weld with the skin below, and out of the skin; they turn with the arc.
    pub(crate) left: DVec3,
    pub(crate) skin: DVec3,
    /// The arc and its angle, rad, unless the line is straight.
    pub(crate) arc: Option<(Arc, f64)>,
}

impl Middle {
    /// The middle line of a job's or program's joint. Fails with the key's address: no length, no arc, a skin along the
    /// web.
    pub(crate) fn new<T>(file: &Document<T>, joint: &TJoint) -> Result<Self, DocumentError> {
        let key = |k: &str| format!("seam.t_joint.{k}");
        let (start, end) = (joint.start_mm.get(), joint.end_mm.get());
        let line =
            Line::new(start, end).map_err(|e| file.error_at(&key("end_mm"), e.message(), other_point("start_mm")))?;
        let arc = joint
            .via_mm
            .map(|via| Arc::through(start, via.get(), end))
            .transpose()
            .map_err(|e| file.error_at(&key("via_mm"), e.message(), Message::new("weld-allowed-point-off-line")))?;
        let along = arc.as_ref().map_or_else(|| line.jet(0.0).d1, |a| a.jet(0.0).d1).normalize();
        let given = joint.skin_normal.unit();
        let across = given - given.dot(along) * along;
        let skin = across.try_normalize().filter(|_| across.length() > MIN_SINE).ok_or_else(|| {
            let message = Message::new("weld-skin-normal-along-web");
            file.error_at(&key("skin_normal"), message, Message::new("weld-allowed-out-of-skin"))
        })?;
        let arc = arc.map(|a| {
            let sweep = a.domain().1;
            (a, sweep)
        });
        Ok(Self { start, end, left: skin.cross(along), skin, arc })
    }
}

/// The left fillet's edge, or the right one's: the web's middle line moved sideways by half its thickness. First face
/// the web, second the skin.
pub(crate) fn edge<T>(file: &Document<T>, joint: &TJoint) -> Result<Box<dyn Edge + Send + Sync>, DocumentError> {
    let Middle { start, end, left, skin, arc } = Middle::new(file, joint)?;
    let web = if joint.fillet == Side::Right { -left } else { left };
    let shift = 0.5 * joint.web_mm.get() * web;
    let wrong =
        |k: &str, e: &Error, allowed: Message| file.error_at(&format!("seam.t_joint.{k}"), e.message(), allowed);
    match arc {
        None => {
            let curve =
                Line::new(start + shift, end + shift).map_err(|e| wrong("end_mm", &e, other_point("start_mm")))?;
            Ok(Box::new(CurvedEdge { curve, faces: FaceRule::Fixed { n1: web, n2: skin } }))
        }
        Some((arc, _)) => {
            let allowed = || Message::new("weld-allowed-thin-web");
            let curve = arc.shifted(shift).map_err(|e| wrong("web_mm", &e, allowed()))?;
            let faces = FaceRule::Turning { axis: arc.axis(), n1: web, n2: skin };
            Ok(Box::new(CurvedEdge { curve, faces }))
        }
    }
}
