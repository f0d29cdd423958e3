use crate::body::Shell;
use crate::branch::Joint;
use crate::nozzle::{bore, outside};
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::{Edge, Tube};
use seamwright_program::{Mount, Seam};
use std::f64::consts::TAU;

/// The end of a tube as it is cut to stand on its body, unrolled.
#[derive(Debug, Clone, PartialEq)]
pub struct Cut {
    /// The tube's outside.
    pub outside: Unrolled,
    /// Its inside, if its wall is known. A wall cut along both curves has its local bevel.
    pub inside: Option<Unrolled>,
}

/// The end of one wall of a tube, unrolled: every degree and at its corners.
#[derive(Debug, Clone, PartialEq)]
pub struct Unrolled {
    /// Radius of the wall, mm.
    pub radius: f64,
    /// From phi = 0 to a full turn, increasing.
    pub points: Vec<CutPoint>,
}

/// A point of a tube's end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutPoint {
    /// Angle about the tube's axis, rad.
    pub phi: f64,
    /// Arc length around the wall from phi = 0, mm.
    pub around: f64,
    /// Along the tube's axis from its origin (of a branch: from the plane z = 0), away from the body, mm.
    pub height: f64,
    /// Angle between the tube's outside and the body seen from outside, across the curve, rad. At a corner that of the
    /// part behind it.
    pub dihedral: f64,
}

impl Cut {
    /// The end of a branch, or of a set-on nozzle whose wall is known; `None` for other seams.
    ///
    /// # Errors
    /// As [`SeamCurve::new`](crate::SeamCurve::new), and an inside that does not close.
    pub fn new<T>(file: &Document<T>, seam: &Seam) -> Result<Option<Self>, DocumentError> {
        match seam {
            Seam::Branch(branch) => {
                let joint = Joint::new(file, branch)?;
                let unrolled = |wall: &Tube| joint.end(file, wall).map(|edge| Unrolled::new(wall, edge.as_ref()));
                let inside = joint.bore.as_ref().map(unrolled).transpose()?;
                Ok(Some(Self { outside: unrolled(&joint.tube)?, inside }))
            }
            Seam::Nozzle(nozzle) if nozzle.mount == Mount::SetOn => {
                let Some(bore) = bore(file, nozzle)? else { return Ok(None) };
                let body = Shell::outside(file, &nozzle.body)?;
                let unrolled = |wall: &Tube| body.edge(file, wall).map(|edge| Unrolled::new(wall, edge.as_ref()));
                Ok(Some(Self { outside: unrolled(&outside(file, nozzle)?)?, inside: Some(unrolled(&bore)?) }))
            }
            _ => Ok(None),
        }
    }
}

/// Number of points around a wall, besides its corners.
const PLACES: u32 = 360;

impl Unrolled {
    fn new(wall: &Tube, edge: &dyn Edge) -> Self {
        let mut angles: Vec<f64> = (0..=PLACES).map(|i| TAU * f64::from(i) / f64::from(PLACES)).collect();
        angles.extend(edge.breaks());
        angles.sort_by(f64::total_cmp);
        angles.dedup_by(|b, a| *b - *a < 1e-12);
        let point = |phi: f64| {
            let e = edge.edge(phi);
            CutPoint {
                phi,
                around: wall.radius() * phi,
                height: (e.point - wall.origin()).dot(wall.direction()),
                dihedral: 2.0 * (e.n1 + e.n2).length().atan2((e.n1 - e.n2).length()),
            }
        };
        Self { radius: wall.radius(), points: angles.into_iter().map(point).collect() }
    }
}
