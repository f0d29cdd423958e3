//! Splines with few knots near given points.

use crate::curve::Curve;
use crate::error::Error;
use crate::numeric::Envelope;
use crate::slopes::End;
use crate::spline::{Ends, Spline, chord_lengths};
use glam::DVec3;

/// Weight of the second differences of the coefficients: just enough to determine coefficients without points.
const STIFFNESS: f64 = 1e-9;

/// Minimum number of intervals of a closed spline, for which its coefficients are distinct.
const MIN_CLOSED_INTERVALS: usize = 4;

/// A cubic spline with every one of `points` within `tolerance` (mm) of it, by chord length, with the fewest knots
/// found; it starts at the first and ends at the last point. Tolerance 0: the spline through the points.
///
/// Knots are parameters of points. They are added in the middle of intervals with a point outside the tolerance of the
/// least-squares spline, until all points are within it. Then knots are removed again while the tolerance holds, the
/// one with the smallest jump of the third derivative first. So no single knot is superfluous; another set may still
/// have fewer. For an end with a jet only the first derivative counts.
///
/// # Errors
/// As [`Spline::through`].
pub fn fit_spline(points: &[DVec3], ends: Ends, tolerance: f64) -> Result<Spline, Error> {
    let fit = Fit { u: chord_lengths(points, ends == Ends::Closed)?, points, ends, tolerance };
    // False for NaN.
    if tolerance > 0.0 && points.len() > MIN_CLOSED_INTERVALS { fit.with_few_knots() } else { fit.through_all() }
}

struct Fit<'a> {
    /// Parameters of the points; for a closed spline also that of the return to the first.
    u: Vec<f64>,
    points: &'a [DVec3],
    ends: Ends,
    tolerance: f64,
}

impl Fit<'_> {
    fn through_all(&self) -> Result<Spline, Error> {
        Spline::new(self.u.clone(), self.points.to_vec(), self.ends)
    }

    fn closed(&self) -> bool {
        self.ends == Ends::Closed
    }

    fn with_few_knots(&self) -> Result<Spline, Error> {
        let last = self.u.len() - 1;
        let intervals = if self.closed() { MIN_CLOSED_INTERVALS } else { 1 };
        let mut knots: Vec<usize> = (0..=intervals).map(|i| i * last / intervals).collect();
        let mut best = loop {
            let spline = self.least_squares(&knots)?;
            let far: Vec<usize> = (0..self.points.len()).filter(|&i| self.is_far(&spline, i)).collect();
            if far.is_empty() {
                break spline;
            }
            match self.refined(&knots, &far) {
                Some(more) => knots = more,
                None => return self.through_all(),
            }
        };
        while let Some((fewer, spline)) = self.without_one(&knots, &best)? {
            (knots, best) = (fewer, spline);
        }
        Ok(best)
    }

    fn is_far(&self, spline: &Spline, i: usize) -> bool {
        let (p, u) = (self.points[i], self.u[i]);
        p.distance(spline.point(u)) > self.tolerance && p.distance(spline.point(spline.foot(p, u))) > self.tolerance
    }

    /// One knot more in every interval with one of the points `far`; none if no such interval has a point inside.
    fn refined(&self, knots: &[usize], far: &[usize]) -> Option<Vec<usize>> {
        let mut more = knots.to_vec();
        for pair in knots.windows(2).filter(|pair| far.iter().any(|i| (pair[0]..=pair[1]).contains(i))) {
            let middle = 0.5 * (self.u[pair[0]] + self.u[pair[1]]);
            let inside = pair[0] + 1..pair[1];
            more.extend(inside.min_by(|a, b| (self.u[*a] - middle).abs().total_cmp(&(self.u[*b] - middle).abs())));
        }
        more.sort_unstable();
        (more.len() > knots.len()).then_some(more)
    }

    /// The knots without the first one that can be removed, smallest jump tried first.
    fn without_one(&self, knots: &[usize], spline: &Spline) -> Result<Option<(Vec<usize>, Spline)>, Error> {
        if self.closed() && knots.len() <= MIN_CLOSED_INTERVALS + 1 {
            return Ok(None);
        }
        let jump = |i: usize| {
            let (before, after) = (self.u[knots[i - 1]], self.u[knots[i]]);
            (spline.third(after) - spline.third(before)).length()
        };
        let mut order: Vec<usize> = (1..knots.len() - 1).collect();
        order.sort_by(|a, b| jump(*a).total_cmp(&jump(*b)));
        for i in order {
            let mut fewer = knots.to_vec();
            fewer.remove(i);
            let spline = self.least_squares(&fewer)?;
            if !(0..self.points.len()).any(|i| self.is_far(&spline, i)) {
                return Ok(Some((fewer, spline)));
            }
        }
        Ok(None)
    }

    /// The spline with these knots and the least sum of squared distances at the points' parameters.
    fn least_squares(&self, knots: &[usize]) -> Result<Spline, Error> {
        let basis = Basis::new(knots.iter().map(|i| self.u[*i]).collect(), self.closed());
        let mut system = Normal::new(basis.count, self.closed());
        self.fix_ends(&basis, &mut system);
        for (point, u) in self.points.iter().zip(&self.u) {
            let (at, [value, _]) = basis.at(*u);
            system.add(&at, &value, *point, 1.0);
        }
        let turns = if self.closed() { basis.count } else { basis.count - 2 };
        for i in 0..turns {
            let at = [0, 1, 2].map(|k| (i + k) % basis.count);
            system.add(&at, &[1.0, -2.0, 1.0], DVec3::ZERO, STIFFNESS);
        }
        let c = system.solve();
        let sum = |(at, weights): (&[usize; 4], &[f64; 4])| -> DVec3 {
            at.iter().zip(weights).map(|(i, w)| *w * c[*i]).sum()
        };
        let ends = [0, basis.knots.len() - 1].map(|i| {
            let (at, [_, slope]) = basis.at(basis.knots[i]);
            End::Slope(sum((&at, &slope)))
        });
        let open = basis.knots.len() - usize::from(self.closed());
        let values = basis.knots[..open].iter().map(|u| {
            let (at, [value, _]) = basis.at(*u);
            sum((&at, &value))
        });
        // These knots, values and end slopes define the spline uniquely.
        let ends = if self.closed() { Ends::Closed } else { Ends::Open(ends[0], ends[1]) };
        Spline::new(basis.knots.clone(), values.collect(), ends)
    }

    /// The first and the last coefficient are the ends of an open spline; those beside them give its slopes there.
    fn fix_ends(&self, basis: &Basis, system: &mut Normal) {
        let Ends::Open(start, end) = self.ends else { return };
        let (n, k) = (basis.count, basis.knots.len());
        let (first, last) = (self.points[0], self.points[self.points.len() - 1]);
        system.fixed[0] = Some(first);
        system.fixed[n - 1] = Some(last);
        if let End::Slope(m) | End::Jet(m, _) = start {
            system.fixed[1] = Some(first + (basis.knots[1] - basis.knots[0]) / 3.0 * m);
        }
        if let End::Slope(m) | End::Jet(m, _) = end {
            system.fixed[n - 2] = Some(last - (basis.knots[k - 1] - basis.knots[k - 2]) / 3.0 * m);
        }
    }
}

/// Cubic B-splines on simple knots.
struct Basis {
    knots: Vec<f64>,
    closed: bool,
    /// Number of splines.
    count: usize,
}

impl Basis {
    fn new(knots: Vec<f64>, closed: bool) -> Self {
        let intervals = knots.len() - 1;
        Self { knots, closed, count: if closed { intervals } else { intervals + 3 } }
    }

    /// Knot `i`, from -3 on: the ends of an open spline are fourfold, a closed one repeats.
    fn knot(&self, i: isize) -> f64 {
        let last = self.knots.len() as isize - 1;
        if !self.closed {
            return self.knots[i.clamp(0, last) as usize];
        }
        let turn = self.knots[last as usize] - self.knots[0];
        self.knots[i.rem_euclid(last) as usize] + turn * i.div_euclid(last) as f64
    }

    /// The four that are not zero at `u`, their values and first derivatives (de Boor's recurrence).
    fn at(&self, u: f64) -> ([usize; 4], [[f64; 4]; 2]) {
        let i = self.knots.partition_point(|k| *k <= u).clamp(1, self.knots.len() - 1) as isize - 1;
        let mut b = [1.0, 0.0, 0.0, 0.0];
        let mut slope = [0.0; 4];
        for degree in 1..4usize {
            let before = b;
            b = [0.0; 4];
            for j in 0..degree {
                let low = self.knot(i + 1 + j as isize - degree as isize);
                let high = self.knot(i + 1 + j as isize);
                let part = before[j] / (high - low);
                b[j] += (high - u) * part;
                b[j + 1] += (u - low) * part;
                if degree == 3 {
                    slope[j] -= 3.0 * part;
                    slope[j + 1] += 3.0 * part;
                }
            }
        }
        let place = |k: usize| (i as usize + k) % self.count;
        (std::array::from_fn(place), [b, slope])
    }
}

/// Normal equations of linear least squares for coefficients in space, some of them fixed.
struct Normal {
    matrix: Envelope,
    right: Vec<DVec3>,
    fixed: Vec<Option<DVec3>>,
}

impl Normal {
    fn new(count: usize, closed: bool) -> Self {
        // In a closed spline the last splines overlap the first.
        let width = |i: usize| if closed && i + 3 >= count { i + 1 } else { i.min(3) + 1 };
        let matrix = Envelope::new((0..count).map(width));
        Self { matrix, right: vec![DVec3::ZERO; count], fixed: vec![None; count] }
    }

    /// Adds the equation: the sum of the coefficients `at` times `factors` is `value`.
    fn add(&mut self, at: &[usize], factors: &[f64], value: DVec3, weight: f64) {
        let known: DVec3 = at.iter().zip(factors).filter_map(|(i, f)| Some(*f * self.fixed[*i]?)).sum();
        let free = || at.iter().zip(factors).filter(|(i, _)| self.fixed[**i].is_none());
        let pairs: Vec<(usize, f64)> = free().map(|(i, f)| (*i, *f)).collect();
        for (i, f) in &pairs {
            self.right[*i] += weight * *f * (value - known);
            for (j, g) in pairs.iter().filter(|(j, _)| j <= i) {
                *self.matrix.at(*i, *j) += weight * f * g;
            }
        }
    }

    /// Returns the coefficients; not a number if the equations are singular.
    fn solve(mut self) -> Vec<DVec3> {
        for (i, value) in self.fixed.iter().enumerate().filter_map(|(i, fixed)| Some((i, (*fixed)?))) {
            *self.matrix.at(i, i) = 1.0;
            self.right[i] = value;
        }
        let count = self.right.len();
        self.matrix.solve(self.right).unwrap_or_else(|| vec![DVec3::NAN; count])
    }
}
