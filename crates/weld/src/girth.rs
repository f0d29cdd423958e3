use crate::allowed::not_along;
use crate::body::tube;
use seamwright_document::{Direction, Document, DocumentError};
use seamwright_geometry::{Curve, Edge, EdgePoint, Jet, Quadric, TubeIntersection};
use seamwright_message::{Message, Unit};
use seamwright_program::Girth;

/// Largest angle between the cut's normal and the tube's axis, degrees.
const MAX_CUT_DEG: f64 = 85.0;

/// The edge of a butt joint around a tube: where its wall meets the cut's plane, both faces being the wall.
#[derive(Debug)]
pub(crate) struct GirthEdge {
    curve: TubeIntersection,
    inside: bool,
}

impl Curve for GirthEdge {
    fn domain(&self) -> (f64, f64) {
        self.curve.domain()
    }
    fn closed(&self) -> bool {
        true
    }
    fn jet(&self, phi: f64) -> Jet {
        self.curve.jet(phi)
    }
}

impl Edge for GirthEdge {
    fn edge(&self, phi: f64) -> EdgePoint {
        let edge = self.curve.edge(phi);
        let out = if self.inside { -edge.n1 } else { edge.n1 };
        EdgePoint { n1: out, n2: out, ..edge }
    }
}

/// The seam of a job or program file. Fails with the key's address: a cut along the tube, a zero direction along the
/// axis.
pub(crate) fn edge<T>(file: &Document<T>, g: &Girth) -> Result<GirthEdge, DocumentError> {
    let direction = g.direction.unit();
    let tube = tube(g.origin_mm.get(), direction, g.zero_direction, g.radius_mm.get())
        .map_err(|e| file.error_at("seam.girth.zero_direction", e.message(), not_along("direction")))?;
    let normal = g.cut_normal.map_or(direction, Direction::unit);
    // A plane has two normals; the one out of the second part is on the tube's side.
    let normal = if normal.dot(direction) < 0.0 { -normal } else { normal };
    if normal.dot(direction) < MAX_CUT_DEG.to_radians().cos() {
        let angle = normal.dot(direction).acos().to_degrees();
        let message = Message::new("weld-cut-along-tube").quantity("angle", angle, Unit::Deg, 1);
        let allowed = Message::new("weld-allowed-cut-angle").value("max", MAX_CUT_DEG, Unit::Deg);
        return Err(file.error_at("seam.girth.cut_normal", message, allowed));
    }
    let wrong = |e: seamwright_geometry::Error| {
        file.error_at("seam.girth.cut_normal", e.message(), Message::new("weld-allowed-other-plane"))
    };
    let plane = Quadric::plane(g.origin_mm.get(), normal).map_err(wrong)?;
    let curve = TubeIntersection::new(tube, plane).map_err(wrong)?;
    Ok(GirthEdge { curve, inside: g.inside })
}
