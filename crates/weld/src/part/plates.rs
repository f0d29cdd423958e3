use super::{Impossible, Making, PLATE_MM};
use glam::{DAffine3, DMat3, DVec3};
use seamwright_clearance::{ClearanceError, Shape, Solid};
use seamwright_program::Line;

/// Faces whose normals differ by no more than this are a butt joint.
const BUTT: f64 = 1e-6;

impl Making<'_> {
    /// The plates behind the two faces of a straight seam, or the one plate of a butt joint.
    pub(super) fn line(&self, line: &Line) -> Result<Vec<Solid>, Impossible> {
        let (start, end) = (line.start_mm.get(), line.end_mm.get());
        let (n1, n2) = (line.first_normal.unit(), line.second_normal.unit());
        let width = self.body_mm.unwrap_or(2.0 * self.nozzle_mm);
        if (n1 - n2).length() <= BUTT {
            return Ok(vec![strip("plate", (start, end), (n1 + n2).normalize(), (-0.5 * width, 0.5 * width))?]);
        }
        // The first part stands on the second: its face goes up from the seam, the second's to both sides of it.
        let first = upright("first part", (start, end), n1, n2, self.nozzle_mm)?;
        Ok(vec![first, strip("second part", (start, end), n2, (-0.5 * width, 0.5 * width))?])
    }
}

/// A plate along a line with its outer face, of outward `normal`, through it; `across` is from where to where it goes
/// across the line.
pub(super) fn strip(
    name: &str,
    (start, end): (DVec3, DVec3),
    normal: DVec3,
    across: (f64, f64),
) -> Result<Solid, ClearanceError> {
    let along = (end - start).normalize();
    let sideways = normal.cross(along);
    let size = DVec3::new((end - start).length(), across.1 - across.0, PLATE_MM);
    let centre = 0.5 * (start + end) + 0.5 * (across.0 + across.1) * sideways - 0.5 * PLATE_MM * normal;
    let axes = DMat3::from_cols(along, sideways, normal);
    Solid::new(name, Shape::Box { size }, DAffine3::from_mat3_translation(axes, centre))
}

/// A plate whose face, of outward `normal`, goes from the line `height` up to where `out` points.
fn upright(
    name: &str,
    (start, end): (DVec3, DVec3),
    normal: DVec3,
    out: DVec3,
    height: f64,
) -> Result<Solid, ClearanceError> {
    let along = (end - start).normalize();
    let sideways = normal.cross(along);
    let across = if sideways.dot(out) > 0.0 { (0.0, height) } else { (-height, 0.0) };
    strip(name, (start, end), normal, across)
}
