//! Heads of vessels from the keys of a job or program: the surface `depth` mm below their outside, 0 for the outside and
//! their thickness for the inside. Errors have the key's address: sizes that contradict each other.

use crate::allowed::{by_key, strictly_between};
use seamwright_document::{Document, DocumentError, Positive};
use seamwright_geometry::{Error, Flange, Head};
use seamwright_message::{Message, Unit};
use seamwright_program::{ConicalHead, EllipsoidalHead, FlatHead, HemisphericalHead, TorisphericalHead};

/// A table of `seam.nozzle.body`.
struct At<'a, T> {
    file: &'a Document<T>,
    key: &'static str,
}

impl<T> At<'_, T> {
    fn error(&self, key: &str, message: Message, allowed: Message) -> DocumentError {
        self.file.error_at(&format!("seam.nozzle.body.{}.{key}", self.key), message, allowed)
    }

    fn made(&self, head: Result<Head, Error>) -> Result<Head, DocumentError> {
        let path = format!("seam.nozzle.body.{}", self.key);
        head.map_err(|e| self.file.error_at(&path, e.message(), Message::new("weld-allowed-schema")))
    }

    /// Inside radius of the flange, mm.
    fn inside(&self, diameter: Positive, thickness: Positive) -> Result<f64, DocumentError> {
        let inside = 0.5 * diameter.get() - thickness.get();
        if inside > 0.0 {
            return Ok(inside);
        }
        let allowed = by_key("weld-allowed-positive-less-than-half-key", "outer_diameter_mm", diameter.get());
        Err(self.error("thickness_mm", Message::new("weld-wall-leaves-no-room"), allowed))
    }

    /// Checks that a knuckle leaves space for a crown.
    fn knuckle(&self, inside: f64, knuckle: f64, key: &str) -> Result<(), DocumentError> {
        if knuckle < inside {
            return Ok(());
        }
        let message = Message::new("weld-knuckle-too-large").value("radius", knuckle, Unit::Mm);
        Err(self.error(key, message, Message::new("weld-allowed-knuckle").value("max", inside, Unit::Mm)))
    }
}

/// Half an ellipsoid.
pub(crate) fn ellipsoidal<T>(file: &Document<T>, h: &EllipsoidalHead, below: f64) -> Result<Head, DocumentError> {
    let radius = 0.5 * h.outer_diameter_mm.get();
    let depth = h.depth_mm.map_or(0.5 * radius, Positive::get);
    let flange = Flange { centre: h.centre_mm.get(), axis: h.axis.unit(), radius, length: h.flange_mm.get() };
    At { file, key: "ellipsoidal_head" }.made(Head::ellipsoidal(flange, depth, below))
}

/// Half a ball.
pub(crate) fn hemispherical<T>(file: &Document<T>, h: &HemisphericalHead, depth: f64) -> Result<Head, DocumentError> {
    let radius = 0.5 * h.outer_diameter_mm.get() - depth;
    let flange = Flange { centre: h.centre_mm.get(), axis: h.axis.unit(), radius, length: h.flange_mm.get() };
    At { file, key: "hemispherical_head" }.made(Head::hemispherical(flange))
}

/// A flat plate with a knuckle.
pub(crate) fn flat<T>(file: &Document<T>, h: &FlatHead, depth: f64) -> Result<Head, DocumentError> {
    let at = At { file, key: "flat_head" };
    at.knuckle(at.inside(h.outer_diameter_mm, h.thickness_mm)?, h.knuckle_radius_mm.get(), "knuckle_radius_mm")?;
    let knuckle = h.knuckle_radius_mm.get() + (h.thickness_mm.get() - depth);
    let radius = 0.5 * h.outer_diameter_mm.get() - depth;
    let flange = Flange { centre: h.centre_mm.get(), axis: h.axis.unit(), radius, length: h.flange_mm.get() };
    at.made(Head::flat(flange, knuckle))
}

/// A cone with a knuckle.
pub(crate) fn conical<T>(file: &Document<T>, h: &ConicalHead, depth: f64) -> Result<Head, DocumentError> {
    let at = At { file, key: "conical_head" };
    at.knuckle(at.inside(h.outer_diameter_mm, h.thickness_mm)?, h.knuckle_radius_mm.get(), "knuckle_radius_mm")?;
    let angle = h.half_angle_deg.get();
    if angle >= 90.0 {
        let message = Message::new("weld-cone-angle-too-large");
        return Err(at.error("half_angle_deg", message, strictly_between(0.0, 90.0, Unit::Deg)));
    }
    let knuckle = h.knuckle_radius_mm.get() + (h.thickness_mm.get() - depth);
    let radius = 0.5 * h.outer_diameter_mm.get() - depth;
    let flange = Flange { centre: h.centre_mm.get(), axis: h.axis.unit(), radius, length: h.flange_mm.get() };
    at.made(Head::conical(flange, angle.to_radians(), knuckle))
}

/// A spherical crown with a knuckle.
pub(crate) fn torispherical<T>(file: &Document<T>, h: &TorisphericalHead, depth: f64) -> Result<Head, DocumentError> {
    let at = At { file, key: "torispherical_head" };
    let (diameter, thickness) = (h.outer_diameter_mm, h.thickness_mm.get());
    let inside = at.inside(diameter, h.thickness_mm)?;
    let (Some(crown), Some(knuckle)) = h.radii() else {
        let message = Message::new("weld-head-radii-missing");
        let allowed = Message::new("weld-allowed-head-radii");
        return Err(file.error_at("seam.nozzle.body.torispherical_head", message, allowed));
    };
    at.knuckle(inside, knuckle, if h.knuckle_radius_mm.is_some() { "knuckle_radius_mm" } else { "thickness_mm" })?;
    if crown <= inside {
        let allowed = Message::new("weld-allowed-crown").value("min", inside, Unit::Mm);
        return Err(at.error("crown_radius_mm", Message::new("weld-crown-too-curved"), allowed));
    }
    let more = thickness - depth;
    let radius = 0.5 * diameter.get() - depth;
    let flange = Flange { centre: h.centre_mm.get(), axis: h.axis.unit(), radius, length: h.flange_mm.get() };
    at.made(Head::torispherical(flange, crown + more, knuckle + more))
}
