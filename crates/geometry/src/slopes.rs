//! Slopes at the knots of cubic splines: the conditions that make them twice continuously differentiable.

use crate::numeric::{Row, Value, tridiagonal};

/// End condition of a cubic spline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End<V> {
    /// Without a second derivative.
    Natural,
    /// With this first derivative.
    Slope(V),
    /// With this first and second derivative: an extra knot in the middle of the interval adds the degree of freedom.
    Jet(V, V),
}

/// Value and first derivative of a spline at a knot.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Knot<V> {
    pub(crate) value: V,
    pub(crate) slope: V,
}

/// First and second derivative at an end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EndDerivatives<V> {
    pub(crate) slope: V,
    pub(crate) second: V,
}

impl<V: Value> EndDerivatives<V> {
    /// The same seen backwards: slopes change their sign; second derivatives do not.
    fn reversed(self) -> Self {
        Self { slope: self.slope * -1.0, ..self }
    }
}

/// Interval between two knots.
#[derive(Clone, Copy)]
struct Interval<V> {
    width: f64,
    /// Difference of the values at its ends.
    rise: V,
}

impl<V: Value> Interval<V> {
    /// The interval from knot `i` to the next.
    fn new(x: &[f64], y: &[V], i: usize) -> Self {
        Self { width: x[i + 1] - x[i], rise: y[i + 1] - y[i] }
    }

    /// The same seen backwards.
    fn reversed(self) -> Self {
        Self { rise: self.rise * -1.0, ..self }
    }
}

/// The condition that the second derivative is continuous at a knot, from the intervals beside it.
fn row<V: Value>(before: Interval<V>, after: Interval<V>) -> Row<V> {
    let Interval { width: h0, rise: rise0 } = before;
    let Interval { width: h1, rise: rise1 } = after;
    let right = (rise0 * (1.0 / (h0 * h0)) + rise1 * (1.0 / (h1 * h1))) * 3.0;
    Row::new([1.0 / h0, 2.0 / h0 + 2.0 / h1, 1.0 / h1], right)
}

/// Half the second derivative at the inner end of an end interval with a knot in its middle, as it follows from the
/// derivatives at the outer end: the factor of the slope at the inner end, and the rest. All derivatives are outward to
/// inward.
fn inner<V: Value>(interval: Interval<V>, outer: EndDerivatives<V>) -> (f64, V) {
    let Interval { width: h, rise } = interval;
    let EndDerivatives { slope: m, second: a } = outer;
    let left = rise - m * h - a * (0.5 * h * h);
    (3.0 / h, a * 0.5 - left * (6.0 / (h * h)) - (m + a * h) * (3.0 / h))
}

/// The same condition at a knot beside an end interval `jet` with the derivatives `outer` at its end, which two cubics
/// fill instead of one.
fn row_beside_jet<V: Value>(jet: Interval<V>, outer: EndDerivatives<V>, other: Interval<V>, last: bool) -> Row<V> {
    let Interval { width: h1, rise: rise1 } = other;
    // Half the second derivative on the other side: (3 rise / h^2 - (2 m1 + m2) / h), seen away from the knot.
    if last {
        let (factor, rest) = inner(jet.reversed(), outer.reversed());
        // -3 rise1/h1^2 + (m0 + 2 m1)/h1 = -factor m1 + rest
        Row::new([1.0 / h1, 2.0 / h1 + factor, 0.0], rest + rise1 * (3.0 / (h1 * h1)))
    } else {
        let (factor, rest) = inner(jet, outer);
        // factor m1 + rest = 3 rise1/h1^2 - (2 m1 + m2)/h1
        Row::new([0.0, 2.0 / h1 + factor, 1.0 / h1], rise1 * (3.0 / (h1 * h1)) - rest)
    }
}

/// Slopes at the knots `x` (at least two, or three if an end is a jet) of the spline with values `y`.
pub(crate) fn slopes<V: Value>(x: &[f64], y: &[V], start: &End<V>, end: &End<V>) -> Vec<V> {
    let n = x.len();
    let zero = y[0] * 0.0;
    if n < 2 {
        return vec![zero; n];
    }
    let piece = |i: usize| Interval::new(x, y, i);
    let fixed = |m: V| Row::new([0.0, 1.0, 0.0], m);
    let equation = |i: usize| match (i, start, end) {
        (0, End::Slope(m) | End::Jet(m, _), _) => fixed(*m),
        (0, End::Natural, _) => Row::new([0.0, 2.0, 1.0], piece(0).rise * (3.0 / piece(0).width)),
        (i, _, End::Slope(m) | End::Jet(m, _)) if i == n - 1 => fixed(*m),
        (i, _, End::Natural) if i == n - 1 => Row::new([1.0, 2.0, 0.0], piece(n - 2).rise * (3.0 / piece(n - 2).width)),
        (1, &End::Jet(slope, second), &End::Jet(end_slope, end_second)) if n == 3 => {
            let (f0, r0) = inner(piece(0), EndDerivatives { slope, second });
            let outer = EndDerivatives { slope: end_slope, second: end_second };
            let (f1, r1) = inner(piece(1).reversed(), outer.reversed());
            Row::new([0.0, f0 + f1, 0.0], r1 - r0)
        }
        (1, &End::Jet(slope, second), _) => row_beside_jet(piece(0), EndDerivatives { slope, second }, piece(1), false),
        (i, _, &End::Jet(slope, second)) if i == n - 2 => {
            row_beside_jet(piece(i), EndDerivatives { slope, second }, piece(i - 1), true)
        }
        _ => row(piece(i - 1), piece(i)),
    };
    tridiagonal((0..n).map(equation))
}

/// The knot in the middle of an end interval of width `h` (negative backwards) from the knot `outer`, with the second
/// derivative `a` there, to the knot `inner`.
pub(crate) fn middle<V: Value>(h: f64, outer: Knot<V>, a: V, inner: Knot<V>) -> Knot<V> {
    let Knot { value: y, slope: m } = outer;
    let Knot { value: y1, slope: m1 } = inner;
    let left = y1 - y - m * h - a * (0.5 * h * h);
    let turn = m1 - m - a * h;
    let jerk = left * (12.0 / (h * h * h)) - turn * (2.0 / (h * h));
    let x = 0.5 * h;
    Knot { value: y + m * x + a * (0.5 * x * x) + jerk * (x * x * x / 6.0), slope: m + a * x + jerk * (0.5 * x * x) }
}

/// Slopes of the closed spline through `y`, whose last value is the first: the cyclic system is the tridiagonal one
/// with a correction of rank one (Sherman and Morrison).
pub(crate) fn periodic_slopes<V: Value>(x: &[f64], y: &[V]) -> Vec<V> {
    let n = x.len() - 1;
    if n < 3 {
        // One value, or two: solve the full cyclic system of at most two unknowns by symmetry.
        return closed_by_symmetry(x, y, n);
    }
    let piece = |i: usize| Interval::new(x, y, i);
    let mut rows: Vec<_> = (0..n).map(|i| row(piece((i + n - 1) % n), piece(i))).collect();
    let corner = 1.0 / piece(n - 1).width;
    let shift = -rows[0].factors[1];
    rows[0].factors[1] -= shift;
    rows[n - 1].factors[1] -= corner * corner / shift;
    let plain = tridiagonal(rows.iter().copied());
    let right = |i: usize| if i == 0 { shift } else { corner * f64::from(u8::from(i == n - 1)) };
    let corrector = tridiagonal(rows.iter().enumerate().map(|(i, row)| Row::new(row.factors, right(i))));
    let factor =
        (plain[0] + plain[n - 1] * (corner / shift)) * (1.0 / (1.0 + corrector[0] + corner / shift * corrector[n - 1]));
    let mut slopes: Vec<V> = plain.iter().zip(&corrector).map(|(p, c)| *p - factor * *c).collect();
    slopes.push(slopes[0]);
    slopes
}

fn closed_by_symmetry<V: Value>(x: &[f64], y: &[V], n: usize) -> Vec<V> {
    if n < 2 {
        return vec![y[0] * 0.0; n + 1];
    }
    // Two knots a period: both conditions have the same coefficients and opposite right sides.
    let (h0, h1) = (x[1] - x[0], x[2] - x[1]);
    let right = (y[1] - y[0]) * (3.0 * (1.0 / (h0 * h0) - 1.0 / (h1 * h1)));
    let slope = right * (1.0 / (1.0 / h0 + 1.0 / h1) / 3.0);
    vec![slope, slope, slope]
}
