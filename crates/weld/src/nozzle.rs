use crate::allowed::{by_key, not_along};
use crate::body::{Shell, tube};
use glam::DVec3;
use seamwright_document::{Document, DocumentError, Positive};
use seamwright_geometry::{Curve, Edge, EdgePoint, Jet, SignedDistance, Tube};
use seamwright_message::Message;
use seamwright_program::{Mount, Nozzle, NozzleCurve};

/// A curve where two faces meet.
type BoxedEdge = Box<dyn Edge + Send + Sync>;

/// The two curves of a nozzle with a wall, both by the angle phi (rad) about the nozzle's axis, in the seam's frame: the
/// root at phi belongs to the toe at phi. First face the nozzle's, second the body's; normals point out of the
/// material, into the air that the torch comes through.
pub struct NozzleEdges {
    /// The nozzle's outside on the body's outside, welded from outside.
    pub outer_toe: BoxedEdge,
    /// The root, welded from inside.
    ///
    /// Set on: the bore on the body's outer surface. The air is in the bore: the bore's normal points to the nozzle's
    /// axis. The second face is the skin at the bore's foot, with its normal out of the body, up the bore. The bisector
    /// leads up the bore and towards its axis, for a whole skin and for one with a hole no wider than the bore.
    ///
    /// Set in: the nozzle's outside on the body's inner surface. The air is in the body, around the nozzle's end: the
    /// nozzle's normal points away from its axis as outside, the body's into the body. The nozzle is assumed to stand
    /// out of the wall inside, far enough for a fillet.
    pub inner_root: BoxedEdge,
}

impl std::fmt::Debug for NozzleEdges {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_struct("NozzleEdges").finish_non_exhaustive()
    }
}

impl NozzleEdges {
    /// Both curves of a job's or program's nozzle, for a weld of either.
    ///
    /// # Errors
    /// With the key's address: a wall or thickness that is missing or too thick, a body whose inside is unknown. Also a
    /// nozzle that is not all round on the surfaces that it needs.
    pub fn new<T>(file: &Document<T>, nozzle: &Nozzle) -> Result<Self, DocumentError> {
        let outside = outside(file, nozzle)?;
        let outer_toe = Shell::outside(file, &nozzle.body)?.edge(file, &outside)?;
        let inner_root = match nozzle.mount {
            Mount::SetOn => {
                let bore = bore(file, nozzle)?.ok_or_else(|| {
                    let message = Message::new("weld-set-on-root-wall-missing");
                    file.error_at("seam.nozzle.wall_mm", message, thinner(nozzle))
                })?;
                let edge = Shell::outside(file, &nozzle.body)?.edge(file, &bore)?;
                Turned { edge, first: -1.0, second: 1.0 }
            }
            Mount::SetIn => {
                let edge = Shell::inside(file, &nozzle.body)?.edge(file, &outside)?;
                Turned { edge, first: 1.0, second: -1.0 }
            }
        };
        Ok(Self { outer_toe, inner_root: Box::new(inner_root) })
    }
}

/// A nozzle where it stands on its body.
pub(crate) struct OnBody {
    /// The seam.
    pub(crate) edge: BoxedEdge,
    /// The nozzle's outside.
    pub(crate) tube: Tube,
    /// The body's outside.
    pub(crate) body: Box<dyn SignedDistance>,
}

impl OnBody {
    /// The nozzle of a job or program file. Fails with the key's address: sizes that contradict each other, a nozzle
    /// whose wall is not on the body all round.
    pub(crate) fn new<T>(file: &Document<T>, n: &Nozzle) -> Result<Self, DocumentError> {
        let tube = outside(file, n)?;
        bore(file, n)?;
        let body = Shell::outside(file, &n.body)?;
        let edge = match (n.mount, n.curve) {
            (Mount::SetOn, NozzleCurve::OuterToe) => body.edge(file, &tube)?,
            (Mount::SetIn, NozzleCurve::OuterToe) => NozzleEdges::new(file, n)?.outer_toe,
            (_, NozzleCurve::InnerRoot) => NozzleEdges::new(file, n)?.inner_root,
        };
        Ok(Self { edge, tube, body: body.distance() })
    }
}

pub(crate) fn outside<T>(file: &Document<T>, n: &Nozzle) -> Result<Tube, DocumentError> {
    tube(n.origin_mm.get(), n.direction.unit(), n.zero_direction, n.radius_mm.get())
        .map_err(|e| file.error_at("seam.nozzle.zero_direction", e.message(), not_along("direction")))
}

/// The nozzle's bore as a tube, if its wall is known.
pub(crate) fn bore<T>(file: &Document<T>, n: &Nozzle) -> Result<Option<Tube>, DocumentError> {
    let Some(wall) = n.wall_mm.map(Positive::get) else { return Ok(None) };
    let inside = n.radius_mm.get() - wall;
    tube(n.origin_mm.get(), n.direction.unit(), n.zero_direction, inside)
        .map(Some)
        .map_err(|_| file.error_at("seam.nozzle.wall_mm", Message::new("weld-wall-leaves-no-bore"), thinner(n)))
}

fn thinner(n: &Nozzle) -> Message {
    by_key("weld-allowed-positive-less-than-key", "radius_mm", n.radius_mm.get())
}

/// An edge with its faces' normals turned over (-1) or not (1).
struct Turned {
    edge: BoxedEdge,
    first: f64,
    second: f64,
}

impl Curve for Turned {
    fn domain(&self) -> (f64, f64) {
        self.edge.domain()
    }
    fn closed(&self) -> bool {
        self.edge.closed()
    }
    fn jet(&self, u: f64) -> Jet {
        self.edge.jet(u)
    }
    fn breaks(&self) -> Vec<f64> {
        self.edge.breaks()
    }
    fn point(&self, u: f64) -> DVec3 {
        self.edge.point(u)
    }
    fn speed(&self, u: f64) -> f64 {
        self.edge.speed(u)
    }
}

impl Edge for Turned {
    fn edge(&self, u: f64) -> EdgePoint {
        let e = self.edge.edge(u);
        EdgePoint { n1: self.first * e.n1, n2: self.second * e.n2, ..e }
    }
}
