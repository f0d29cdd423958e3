use super::{Extent, Impossible, Making};
use glam::{DAffine3, DMat3, DVec3};
use seamwright_clearance::{ClearanceError, Shape, Solid};
use seamwright_program::Line;

/// Faces whose normals differ by no more than this are a butt joint.
const BUTT: f64 = 1e-6;

impl Making<'_> {
    /// The plates behind the two faces of a straight seam, or the one plate of a butt joint.
    pub(super) fn line(&self, line: &Line) -> Result<Vec<Solid>, Impossible> {
        let edge = Segment { start: line.start_mm.get(), end: line.end_mm.get(), thick: self.plate_mm() };
        let (n1, n2) = (line.first_normal.unit(), line.second_normal.unit());
        let width = self.body_mm.unwrap_or(2.0 * self.nozzle_mm);
        let across = Extent { low: -0.5 * width, high: 0.5 * width };
        if (n1 - n2).length() <= BUTT {
            return Ok(vec![edge.strip("plate", (n1 + n2).normalize(), across)?]);
        }
        // The first part stands on the second: its face goes up from the seam, the second's to both sides of it.
        let first = edge.upright("first part", n1, n2, self.nozzle_mm)?;
        Ok(vec![first, edge.strip("second part", n2, across)?])
    }
}

/// Straight edge of a plate.
struct Segment {
    start: DVec3,
    end: DVec3,
    /// Thickness of its plates, mm.
    thick: f64,
}

impl Segment {
    /// A plate along the edge with its outer face, of outward `normal`, through it; `across` is its extent across the
    /// edge.
    fn strip(&self, name: &str, normal: DVec3, across: Extent) -> Result<Solid, ClearanceError> {
        let Self { start, end, thick } = *self;
        let along = (end - start).normalize();
        let sideways = normal.cross(along);
        let size = DVec3::new((end - start).length(), across.high - across.low, thick);
        let centre = 0.5 * (start + end) + 0.5 * (across.low + across.high) * sideways - 0.5 * thick * normal;
        let axes = DMat3::from_cols(along, sideways, normal);
        Solid::new(name, Shape::Box { size }, DAffine3::from_mat3_translation(axes, centre))
    }

    /// A plate whose face, of outward `normal`, goes from the edge `height` up to where `out` points.
    fn upright(&self, name: &str, normal: DVec3, out: DVec3, height: f64) -> Result<Solid, ClearanceError> {
        let along = (self.end - self.start).normalize();
        let sideways = normal.cross(along);
        let across = if sideways.dot(out) > 0.0 {
            Extent { low: 0.0, high: height }
        } else {
            Extent { low: -height, high: 0.0 }
        };
        self.strip(name, normal, across)
    }
}
