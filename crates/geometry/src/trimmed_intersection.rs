use crate::curve::{Curve, Jet};
use crate::edge::{Edge, EdgePoint};
use crate::error::Error;
use crate::pieces::{AT_BORDER_MM, Pieces};
use crate::quadric::{Quadric, Surface};
use crate::tube::Tube;
use crate::tube_intersection::TubeIntersection;
use glam::DVec3;

/// The curve where a tube's wall leaves two overlapping quadric bodies, parametrised by the angle about the tube's axis
/// (rad): the end of a tube that stands on one body and is trimmed by the other.
///
/// At each angle it lies on the body that the wall's line leaves last, and there equals the [`TubeIntersection`]. At
/// the [`breaks`](Curve::breaks) between the two bodies the three surfaces meet and the curve has a corner: its tangent
/// and the second face's normal jump, its point is continuous.
#[derive(Debug, Clone, PartialEq)]
pub struct TrimmedIntersection {
    /// On the body, and on the other one.
    on: [TubeIntersection; 2],
    pieces: Pieces,
}

/// Maximum height difference of both parts at a corner, as a fraction of the tube's radius.
const SAME: f64 = 1e-6;

impl TrimmedIntersection {
    /// The closed curve where `tube`, which stands on `body` all round, leaves `body` and `other`.
    ///
    /// # Errors
    /// Those of [`TubeIntersection::new`] for `body` alone; [`Error::Beside`] where the wall passes beside `other`
    /// above `body`, so that the curve would jump; [`Error::NeverLeaves`] where it never leaves `other`.
    pub fn new(tube: Tube, body: Quadric, other: Quadric) -> Result<Self, Error> {
        let first = TubeIntersection::new(tube.clone(), body)?;
        let on = [first, TubeIntersection::unchecked(tube, other)];
        let heights = |phi: f64| [on[0].height(phi), on[1].height(phi)];
        // Corners are crossings of the curve on the body with the other's surface. At the first line that misses the
        // other body, the curve must not lie on it.
        let [body_curve, other_curve] = &on;
        let within = |phi: f64| other_curve.body().value(body_curve.point(phi));
        let beyond = |phi: f64| vec![within(phi), other_curve.discriminant(phi)];
        let zone = |phi: f64| {
            let [first, second] = heights(phi);
            usize::from(second > first)
        };
        let pieces = Pieces::new(2, &beyond, &zone);
        if pieces.middles().into_iter().any(|phi| pieces.zone(phi) == 0 && within(phi) < -AT_BORDER_MM) {
            return Err(Error::NeverLeaves);
        }
        let radius = on[0].tube().radius;
        let apart = |phi: f64| {
            let [first, second] = heights(phi);
            (first - second).abs()
        };
        match pieces.breaks().into_iter().find(|&phi| apart(phi).is_nan() || apart(phi) > SAME * radius) {
            Some(at) => Err(Error::Beside { at }),
            None => Ok(Self { on, pieces }),
        }
    }

    /// True if the curve at `phi` (rad) lies on the other body, which trims the tube.
    pub fn on_other(&self, phi: f64) -> bool {
        self.pieces.zone(phi) == 1
    }

    fn at(&self, phi: f64) -> &TubeIntersection {
        &self.on[self.pieces.zone(phi)]
    }
}

impl Curve for TrimmedIntersection {
    fn domain(&self) -> (f64, f64) {
        self.on[0].domain()
    }
    fn closed(&self) -> bool {
        true
    }
    fn breaks(&self) -> Vec<f64> {
        self.pieces.breaks()
    }
    fn jet(&self, phi: f64) -> Jet {
        self.at(phi).jet(phi)
    }
    fn point(&self, phi: f64) -> DVec3 {
        self.at(phi).point(phi)
    }
    fn speed(&self, phi: f64) -> f64 {
        self.at(phi).speed(phi)
    }
}

impl Edge for TrimmedIntersection {
    fn edge(&self, phi: f64) -> EdgePoint {
        self.at(phi).edge(phi)
    }
}
