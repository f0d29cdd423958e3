use crate::curve::{Curve, Jet};
use crate::error::Error;
use crate::slopes::{End, EndDerivatives, Knot, middle, periodic_slopes, slopes};
use glam::DVec3;

/// A cubic B-spline in space through given points, twice continuously differentiable; its third derivative jumps at the
/// knots, which are its [`breaks`](Curve::breaks) (de Boor, A Practical Guide to Splines, chapter IV).
///
/// Kept as points and slopes at the knots, from which each piece follows. Also used for vectors along a curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    knots: Vec<f64>,
    points: Vec<DVec3>,
    slopes: Vec<DVec3>,
    closed: bool,
}

/// End conditions of a spline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ends {
    /// Open, with these ends.
    Open(End<DVec3>, End<DVec3>),
    /// Closed, as smooth at the joint as elsewhere.
    Closed,
}

/// Parameters of `points` by the lengths of the chords from point to point, from 0; if `closed` with the length once
/// around at the end.
///
/// # Errors
/// [`Error::Knots`] at a point equal to the one before, or not finite; [`Error::TooFewPoints`] for fewer than two, or
/// three of a closed curve.
pub fn chord_lengths(points: &[DVec3], closed: bool) -> Result<Vec<f64>, Error> {
    let least = if closed { 3 } else { 2 };
    if points.len() < least {
        return Err(Error::TooFewPoints { what: "geometry-points-spline", given: points.len(), min: least });
    }
    let mut lengths = vec![0.0];
    let around = points.iter().chain(points.first().filter(|_| closed));
    for (i, (p, before)) in around.skip(1).zip(points).enumerate() {
        let length = lengths[i] + p.distance(*before);
        // Not greater, or not a number.
        if !length.is_finite() || length <= lengths[i] {
            return Err(Error::Knots { index: i + 1 });
        }
        lengths.push(length);
    }
    Ok(lengths)
}

impl Spline {
    /// The spline through `points` by chord length: in mm, and near to the arc length.
    ///
    /// # Errors
    /// As [`chord_lengths`] and [`Spline::new`].
    pub fn through(points: &[DVec3], ends: Ends) -> Result<Self, Error> {
        Self::new(chord_lengths(points, ends == Ends::Closed)?, points.to_vec(), ends)
    }

    /// The spline through `points` at these parameters; a closed one has one parameter more, for the return to the
    /// first point.
    ///
    /// # Errors
    /// [`Error::Knots`] if the parameters do not increase strictly, [`Error::TooFewPoints`] for fewer than two
    /// parameters, or three with an end that is a jet.
    pub fn new(knots: Vec<f64>, mut points: Vec<DVec3>, ends: Ends) -> Result<Self, Error> {
        let closed = ends == Ends::Closed;
        if closed {
            points.extend(points.first().copied());
        }
        let jets = matches!(ends, Ends::Open(End::Jet(..), _) | Ends::Open(_, End::Jet(..)));
        let (given, least) = (points.len().min(knots.len()), if jets { 3 } else { 2 });
        if given < least || points.len() != knots.len() {
            return Err(Error::TooFewPoints { what: "geometry-points-spline", given, min: least });
        }
        // Also not if not a number.
        if let Some(i) = (1..knots.len()).find(|&i| !knots[i].is_finite() || knots[i] <= knots[i - 1]) {
            return Err(Error::Knots { index: i });
        }
        Ok(match ends {
            Ends::Closed => Self { slopes: periodic_slopes(&knots, &points), knots, points, closed },
            Ends::Open(start, end) => {
                let slopes = slopes(&knots, &points, &start, &end);
                Self { knots, points, slopes, closed }.with_middles(&start, &end)
            }
        })
    }

    /// With the extra knots of ends that are jets.
    fn with_middles(mut self, start: &End<DVec3>, end: &End<DVec3>) -> Self {
        // The last first: it does not move the others.
        let n = self.points.len();
        if let End::Jet(slope, second) = *end {
            self.add_middle(n - 1, n - 2, EndDerivatives { slope, second });
        }
        if let End::Jet(slope, second) = *start {
            self.add_middle(0, 1, EndDerivatives { slope, second });
        }
        self
    }

    /// Adds the knot in the middle of an end interval, from its `outer` and `inner` knot.
    fn add_middle(&mut self, outer: usize, inner: usize, derivatives: EndDerivatives<DVec3>) {
        let h = self.knots[inner] - self.knots[outer];
        let from = Knot { value: self.points[outer], slope: derivatives.slope };
        let to = Knot { value: self.points[inner], slope: self.slopes[inner] };
        let added = middle(h, from, derivatives.second, to);
        let place = outer.max(inner);
        self.knots.insert(place, self.knots[outer] + 0.5 * h);
        self.points.insert(place, added.value);
        self.slopes.insert(place, added.slope);
    }

    /// Parameters of the knots, with both ends.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The piece that holds parameter `u`, counted from 1, and `u` within the domain of a closed curve.
    fn piece(&self, u: f64) -> (usize, f64) {
        let (first, last) = self.domain();
        let outside = !(first..=last).contains(&u);
        let u = if outside && self.closed { first + (u - first).rem_euclid(last - first) } else { u };
        (self.knots.partition_point(|k| *k <= u).clamp(1, self.knots.len() - 1), u)
    }

    /// Second and third coefficient of a piece by the part of it, and its width.
    fn bend(&self, i: usize) -> (DVec3, DVec3, f64) {
        let h = self.knots[i] - self.knots[i - 1];
        let rise = self.points[i] - self.points[i - 1];
        let (m0, m1) = (h * self.slopes[i - 1], h * self.slopes[i]);
        (3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise, h)
    }

    /// Third derivative at parameter `u`; behind the knot at one.
    pub fn third(&self, u: f64) -> DVec3 {
        let (_, c3, h) = self.bend(self.piece(u).0);
        6.0 * c3 / (h * h * h)
    }

    /// The parameter near `guess` of the curve's point nearest to `point`, by damped Newton steps; never farther away
    /// than the guess.
    pub(crate) fn foot(&self, point: DVec3, guess: f64) -> f64 {
        let (first, last) = self.domain();
        let clamp = |u: f64| if self.closed { u } else { u.clamp(first, last) };
        let (mut best, mut away) = (guess, self.point(guess).distance(point));
        for _ in 0..8 {
            let jet = self.jet(best);
            let off = jet.point - point;
            // Gauss-Newton, where Newton's method would search the farthest point.
            let curved = jet.d1.length_squared() + off.dot(jet.d2);
            let step = off.dot(jet.d1) / curved.max(0.25 * jet.d1.length_squared());
            let next = clamp(best - step);
            let distance = self.point(next).distance(point);
            if distance >= away {
                break;
            }
            (best, away) = (next, distance);
        }
        best
    }
}

impl Curve for Spline {
    fn domain(&self) -> (f64, f64) {
        (self.knots[0], self.knots[self.knots.len() - 1])
    }

    fn closed(&self) -> bool {
        self.closed
    }

    fn jet(&self, u: f64) -> Jet {
        let (i, u) = self.piece(u);
        let (c2, c3, h) = self.bend(i);
        let (t, m0) = ((u - self.knots[i - 1]) / h, self.slopes[i - 1]);
        Jet {
            point: self.points[i - 1] + t * (h * m0 + t * (c2 + t * c3)),
            d1: m0 + t * (2.0 * c2 + 3.0 * t * c3) / h,
            d2: (2.0 * c2 + 6.0 * t * c3) / (h * h),
        }
    }

    fn breaks(&self) -> Vec<f64> {
        // The closing point is also a knot.
        self.knots[usize::from(!self.closed)..self.knots.len() - 1].to_vec()
    }
}
