use crate::curve::{Curve, Jet};
use crate::edge::{Edge, EdgePoint};
use crate::error::Error;
use crate::slopes::End;
use crate::spline::{Ends, Spline, chord_lengths};
use glam::DVec3;

/// Tangents of [`Along`] per interval of a spline: more would turn a frame more sharply at the knots, fewer would
/// deviate more from the tangent.
const PARTS: u32 = 4;

/// The direction along a spline as a frame of faces needs it: twice continuously differentiable.
///
/// The tangent of a cubic spline is differentiable only once, since the third derivative jumps at the knots: a face
/// square to it would turn with a jump in its acceleration. This is the cubic spline through the tangents at the knots
/// and at three places between them, made unit: equal to the tangent there, and near it elsewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct Along(Spline);

impl Along {
    /// The direction along `curve` with the end conditions `ends` (by the curve's parameter), which a closed curve
    /// ignores.
    ///
    /// # Errors
    /// [`Error::Turn`] if the curve turns by 90 degrees or more from one knot to the next.
    pub fn of(curve: &Spline, ends: (End<DVec3>, End<DVec3>)) -> Result<Self, Error> {
        let knots = curve.knots();
        let places = knots
            .windows(2)
            .flat_map(|k| (0..PARTS).map(move |i| k[0] + (k[1] - k[0]) * f64::from(i) / f64::from(PARTS)));
        let places: Vec<f64> = places.chain([curve.domain().1]).collect();
        let mut tangents: Vec<DVec3> = places.iter().map(|u| curve.jet(*u).d1.normalize_or_zero()).collect();
        let turns_back = |a: &DVec3, b: &DVec3| a.dot(*b) <= 0.0;
        let beside = tangents.windows(2).any(|t| turns_back(&t[0], &t[1]));
        let mut at_knots =
            tangents.iter().step_by(PARTS as usize).zip(tangents.iter().skip(PARTS as usize).step_by(PARTS as usize));
        if beside || at_knots.any(|(a, b)| turns_back(a, b)) {
            return Err(Error::Turn { what: "geometry-curve-through-points" });
        }
        let ends = if curve.closed() { Ends::Closed } else { Ends::Open(ends.0, ends.1) };
        tangents.truncate(places.len() - usize::from(curve.closed()));
        Ok(Self(Spline::new(places, tangents, ends)?))
    }

    /// Parameters at which the third derivative may jump; all knots of the curve among them.
    pub fn breaks(&self) -> Vec<f64> {
        self.0.breaks()
    }

    /// The unit direction at parameter `u`.
    pub fn at(&self, u: f64) -> DVec3 {
        self.0.point(u).normalize()
    }
}

/// The faces along a [`SplineEdge`].
#[derive(Debug, Clone, PartialEq)]
pub enum SplineFaces {
    /// A wall on a plate with normals as given (by the curve's parameter, or everywhere the same): first face the wall.
    Wall {
        /// The plate's normals; a spline of one value is constant.
        plate: Normals,
        /// The wall faces to the left of the curve with the plate below, not to the right.
        left: bool,
    },
    /// Both faces have these normals (a butt joint).
    Flat(Normals),
    /// Each face has its own normals.
    Both(Normals, Normals),
}

/// Normals along a curve, before they are made square to it.
#[derive(Debug, Clone, PartialEq)]
pub enum Normals {
    /// The same everywhere.
    Same(DVec3),
    /// Through those at given points.
    Through(Spline),
}

impl Normals {
    /// Smooth interpolation of `normals` (unit) at the parameters of `points` by chord length.
    ///
    /// # Errors
    /// As [`chord_lengths`]; [`Error::Turn`] if a normal turns by 90 degrees or more from one point to the next.
    pub fn through(points: &[DVec3], normals: &[DVec3], closed: bool) -> Result<Self, Error> {
        let next = normals.iter().skip(1).chain(normals.first().filter(|_| closed));
        if normals.iter().zip(next).any(|(a, b)| a.dot(*b) <= 0.0) {
            return Err(Error::Turn { what: "geometry-normal" });
        }
        let ends = if closed { Ends::Closed } else { Ends::Open(End::Natural, End::Natural) };
        Ok(Self::Through(Spline::new(chord_lengths(points, closed)?, normals.to_vec(), ends)?))
    }

    /// The unit normal at `u`, square to the unit vector `along`.
    fn at(&self, u: f64, along: DVec3) -> DVec3 {
        let n = match self {
            Self::Same(n) => *n,
            Self::Through(spline) => spline.point(u),
        };
        square(n, along)
    }

    fn breaks(&self) -> Vec<f64> {
        match self {
            Self::Same(_) => Vec::new(),
            Self::Through(spline) => spline.breaks(),
        }
    }
}

/// The unit vector nearest to `n` that is square to the unit vector `along`.
pub(crate) fn square(n: DVec3, along: DVec3) -> DVec3 {
    (n - n.dot(along) * along).normalize()
}

/// A spline along which two faces meet. Their normals are square to [`Along`].
#[derive(Debug, Clone, PartialEq)]
pub struct SplineEdge {
    curve: Spline,
    along: Along,
    faces: SplineFaces,
}

/// Minimum sine of the angle between a normal and the curve (6 degrees).
const MIN_SINE: f64 = 0.1;

impl SplineEdge {
    /// The edge along `curve` with these faces.
    ///
    /// # Errors
    /// As [`Along::of`]; [`Error::Parallel`] if a normal lies along the curve somewhere.
    pub fn new(curve: Spline, faces: SplineFaces) -> Result<Self, Error> {
        let (first, last) = curve.domain();
        let turn = |u: f64| {
            let jet = curve.jet(u);
            let along = jet.d1.normalize_or_zero();
            End::Slope((jet.d2 - jet.d2.dot(along) * along) / jet.d1.length())
        };
        let along = Along::of(&curve, (turn(first), turn(last)))?;
        let edge = Self { curve, along, faces };
        let places =
            edge.curve.knots().windows(2).flat_map(|k| (0..8).map(move |i| k[0] + (k[1] - k[0]) * f64::from(i) / 8.0));
        let sine = |u: f64, normals: &Normals| match normals {
            Normals::Same(n) => n.cross(edge.along.at(u)).length(),
            Normals::Through(spline) => spline.point(u).cross(edge.along.at(u)).length(),
        };
        let lies = |u: f64| match &edge.faces {
            SplineFaces::Wall { plate: n, .. } | SplineFaces::Flat(n) => sine(u, n) < MIN_SINE,
            SplineFaces::Both(a, b) => sine(u, a).min(sine(u, b)) < MIN_SINE,
        };
        if places.chain([edge.curve.domain().1]).any(lies) {
            return Err(Error::Parallel { first: "geometry-face-normal", second: "geometry-curve" });
        }
        Ok(edge)
    }
}

impl Curve for SplineEdge {
    fn domain(&self) -> (f64, f64) {
        self.curve.domain()
    }
    fn closed(&self) -> bool {
        self.curve.closed()
    }
    fn jet(&self, u: f64) -> Jet {
        self.curve.jet(u)
    }
    fn breaks(&self) -> Vec<f64> {
        let mut breaks = self.along.breaks();
        match &self.faces {
            SplineFaces::Wall { plate: n, .. } | SplineFaces::Flat(n) => breaks.extend(n.breaks()),
            SplineFaces::Both(a, b) => breaks.extend(a.breaks().into_iter().chain(b.breaks())),
        }
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }
}

impl Edge for SplineEdge {
    fn edge(&self, u: f64) -> EdgePoint {
        let jet = self.curve.jet(u);
        let along = self.along.at(u);
        let (n1, n2) = match &self.faces {
            SplineFaces::Wall { plate, left } => {
                let below = plate.at(u, along);
                let right = along.cross(below);
                (if *left { -right } else { right }, below)
            }
            SplineFaces::Flat(normals) => {
                let n = normals.at(u, along);
                (n, n)
            }
            SplineFaces::Both(first, second) => (first.at(u, along), second.at(u, along)),
        };
        EdgePoint { point: jet.point, d1: jet.d1, n1, n2 }
    }

    fn along(&self, u: f64, _at: &EdgePoint) -> DVec3 {
        self.along.at(u)
    }
}
