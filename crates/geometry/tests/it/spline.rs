//! Cubic splines against other constructions: the B-spline basis, the moments, polynomials, straight lines.

use glam::DVec3;
use nalgebra::{DMatrix, DVector};
use seamwright_geometry::{Curve, End, Ends, Error, Spline, chord_lengths, fit_spline};
use seamwright_testkit::{Random, cases};

/// Points along a curved path, about `step` apart.
fn way(random: &mut Random, count: usize) -> Vec<DVec3> {
    let (mut at, mut along) = (random.vector(500.0), random.direction());
    let step = random.within(0.5, 40.0);
    (0..count)
        .map(|_| {
            along = (along + 0.4 * random.vector(1.0)).normalize();
            at += random.within(0.3, 1.7) * step * along;
            at
        })
        .collect()
}

fn ends(random: &mut Random, kind: u32) -> Ends {
    let end = |random: &mut Random| match (random.within(0.0, 3.0)) as u32 {
        0 => End::Natural,
        1 => End::Slope(random.direction()),
        _ => End::Jet(random.direction(), 0.02 * random.vector(1.0)),
    };
    if kind == 0 { Ends::Closed } else { Ends::Open(end(random), end(random)) }
}

/// Point and three derivatives a hair before and behind every knot.
fn check_smooth(spline: &Spline, size: f64) {
    let (first, last) = spline.domain();
    for &u in spline.knots() {
        if (u - first) * (u - last) == 0.0 && !spline.closed() {
            continue;
        }
        // By the pieces themselves: a step of e changes a derivative by e times the next.
        let e = 1e-7 * (last - first) / spline.knots().len() as f64;
        let (a, b) = (spline.jet(u - e), spline.jet(u + e));
        let third = spline.third(u - e).length().max(spline.third(u + e).length());
        assert!((a.point - b.point).length() < 3.0 * e * a.d1.length() + 1e-12 * size);
        assert!((a.d1 - b.d1).length() < 3.0 * e * (a.d2.length() + e * third) + 1e-10);
        assert!((a.d2 - b.d2).length() < 3.0 * e * third + 1e-9 * a.d2.length() + 1e-12, "{} {}", a.d2, b.d2);
    }
}

#[test]
fn pass_through_their_points_smoothly_with_their_ends() {
    let mut random = Random::new(1);
    for case in 0..cases(4000) {
        let count = 3 + (random.within(0.0, 20.0)) as usize;
        let points = way(&mut random, count);
        let ends = ends(&mut random, case % 4);
        let spline = Spline::through(&points, ends).unwrap();
        let u = chord_lengths(&points, ends == Ends::Closed).unwrap();
        for (p, u) in points.iter().zip(&u) {
            assert!(spline.point(*u).distance(*p) < 1e-11, "{}", spline.point(*u).distance(*p));
        }
        check_smooth(&spline, 1000.0);
        let Ends::Open(start, end) = ends else {
            assert!(spline.point(u[count]).distance(points[0]) < 1e-11);
            continue;
        };
        for (end, u) in [(start, 0.0), (end, u[count - 1])] {
            let jet = spline.jet(u);
            match end {
                End::Natural => assert!(jet.d2.length() < 1e-9, "{}", jet.d2),
                End::Slope(m) => assert!((jet.d1 - m).length() < 1e-10),
                End::Jet(m, a) => {
                    assert!((jet.d1 - m).length() < 1e-10 && (jet.d2 - a).length() < 1e-9, "{} {a}", jet.d2);
                }
            }
        }
    }
}

/// The truncated powers `(u - k)^3` behind each inner knot and the four powers: another basis of the same splines.
fn by_truncated_powers(
    knots: &[f64],
    u: &[f64],
    points: &[DVec3],
    ends: (End<DVec3>, End<DVec3>),
) -> impl Fn(f64) -> DVec3 {
    let inner = knots[1..knots.len() - 1].to_vec();
    let scale = knots[knots.len() - 1];
    let row = move |x: f64, order: i32| -> Vec<f64> {
        let power = |y: f64, n: i32| {
            let factor: f64 = (0..order).map(|k| f64::from(n - k)).product();
            if order > n { 0.0 } else { factor * (y / scale).powi(n - order) / scale.powi(order) }
        };
        let powers = (0..4).map(|n| power(x, n));
        powers.chain(inner.iter().map(|k| if x > *k { power(x - k, 3) } else { 0.0 })).collect()
    };
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    for (x, p) in u.iter().zip(points) {
        rows.push(row(*x, 0));
        values.push(*p);
    }
    for (end, x) in [(ends.0, u[0]), (ends.1, scale)] {
        let mut wish = |order: i32, value: DVec3| {
            // Derivatives by the part of the whole, so that all rows are alike.
            rows.push(row(x, order).iter().map(|v| v * scale.powi(order)).collect());
            values.push(value * scale.powi(order));
        };
        match end {
            End::Natural => wish(2, DVec3::ZERO),
            End::Slope(m) => wish(1, m),
            End::Jet(m, a) => {
                wish(1, m);
                wish(2, a);
            }
        }
    }
    let n = rows.len();
    let matrix = DMatrix::from_fn(n, n, |i, j| rows[i][j]).lu();
    let solve = |axis: usize| matrix.solve(&DVector::from_iterator(n, values.iter().map(|v| v[axis]))).unwrap();
    let c = [solve(0), solve(1), solve(2)];
    move |x| {
        let row = row(x, 0);
        DVec3::from_array(std::array::from_fn(|axis| row.iter().zip(c[axis].iter()).map(|(r, c)| r * c).sum()))
    }
}

#[test]
fn are_those_of_another_basis() {
    let mut random = Random::new(2);
    for _ in 0..cases(2000) {
        let count = 3 + (random.within(0.0, 6.0)) as usize;
        let points = way(&mut random, count);
        let Ends::Open(start, end) = ends(&mut random, 1) else { unreachable!() };
        let spline = Spline::through(&points, Ends::Open(start, end)).unwrap();
        let u = chord_lengths(&points, false).unwrap();
        let other = by_truncated_powers(spline.knots(), &u, &points, (start, end));
        for i in 0..=40 {
            let x = u[count - 1] * f64::from(i) / 40.0;
            let off = spline.point(x).distance(other(x));
            assert!(off < 1e-7, "{off} {count} {start:?} {end:?}");
        }
    }
}

/// The closed spline by its moments (second derivatives at the knots), from the full cyclic system.
#[test]
fn closed_ones_are_those_by_moments() {
    let mut random = Random::new(3);
    for _ in 0..cases(1500) {
        let n = 3 + (random.within(0.0, 12.0)) as usize;
        let points = way(&mut random, n);
        let spline = Spline::through(&points, Ends::Closed).unwrap();
        let u = chord_lengths(&points, true).unwrap();
        let h: Vec<f64> = u.windows(2).map(|w| w[1] - w[0]).collect();
        let mut matrix = DMatrix::zeros(n, n);
        let mut right = DMatrix::zeros(n, 3);
        for i in 0..n {
            let (before, after) = ((i + n - 1) % n, (i + 1) % n);
            matrix[(i, before)] += h[before] / 6.0;
            matrix[(i, i)] += (h[before] + h[i]) / 3.0;
            matrix[(i, after)] += h[i] / 6.0;
            let value = (points[after] - points[i]) / h[i] - (points[i] - points[before]) / h[before];
            (0..3).for_each(|axis| right[(i, axis)] = value[axis]);
        }
        let moments = matrix.lu().solve(&right).unwrap();
        for i in 0..n {
            let exact = DVec3::new(moments[(i, 0)], moments[(i, 1)], moments[(i, 2)]);
            let found = spline.jet(u[i]).d2;
            assert!((found - exact).length() < 1e-9 * (1.0 + exact.length()), "{found} {exact}");
        }
    }
}

#[test]
fn cubics_and_straight_lines_are_reproduced() {
    let mut random = Random::new(4);
    for case in 0..cases(3000) {
        let c: [DVec3; 4] = std::array::from_fn(|_| random.vector(50.0));
        let at = |x: f64| c[0] + x * (c[1] + x * (c[2] + x * c[3]));
        let slope = |x: f64| c[1] + x * (2.0 * c[2] + 3.0 * x * c[3]);
        let bend = |x: f64| 2.0 * c[2] + 6.0 * x * c[3];
        let mut u = vec![random.within(-2.0, 0.0)];
        for _ in 0..2 + case % 6 {
            u.push(u[u.len() - 1] + random.within(0.05, 0.7));
        }
        let last = u[u.len() - 1];
        let end = |x: f64, jet: bool| if jet { End::Jet(slope(x), bend(x)) } else { End::Slope(slope(x)) };
        let ends = Ends::Open(end(u[0], case % 2 == 0), end(last, case % 3 == 0));
        let spline = Spline::new(u.clone(), u.iter().map(|x| at(*x)).collect(), ends).unwrap();
        for i in 0..=30 {
            let x = u[0] + (last - u[0]) * f64::from(i) / 30.0;
            let jet = spline.jet(x);
            assert!(
                jet.point.distance(at(x)) < 1e-9 && jet.d1.distance(slope(x)) < 1e-7 && jet.d2.distance(bend(x)) < 1e-5
            );
            assert!(spline.third(x).distance(6.0 * c[3]) < 1e-2);
        }
        // On a straight line the chord length is the arc length, at any spacing.
        let along = random.direction();
        let straight: Vec<DVec3> = u.iter().map(|x| c[0] + *x * along).collect();
        let tangents = Ends::Open(End::Slope(along), End::Jet(along, DVec3::ZERO));
        for ends in [tangents, Ends::Open(End::Natural, End::Natural)] {
            let line = Spline::through(&straight, ends).unwrap();
            let x = random.within(0.0, last - u[0]);
            assert!(line.point(x).distance(straight[0] + x * along) < 1e-10);
        }
    }
}

/// Every point is within the tolerance of the densely sampled curve, both ends are kept, and knots are few.
#[test]
fn fits_keep_the_tolerance_with_few_knots() {
    let mut random = Random::new(5);
    let (mut points_in, mut knots_out) = (0, 0);
    for case in 0..cases(300) {
        let count = 6 + (random.within(0.0, 60.0)) as usize;
        let (r, h, noise) = (random.within(20.0, 200.0), random.within(0.0, 50.0), random.within(0.0, 0.02));
        let closed = case % 3 == 0;
        let turns = if closed { std::f64::consts::TAU } else { random.within(0.5, 5.0) };
        let points: Vec<DVec3> = (0..count)
            .map(|i| {
                let x = turns * i as f64 / if closed { count } else { count - 1 } as f64;
                DVec3::new(r * x.cos(), r * x.sin(), h * (2.0 * x).cos()) + noise * random.vector(1.0)
            })
            .collect();
        let tolerance = random.within(0.02, 0.5);
        let along = (points[1] - points[0]).normalize();
        let ends = [Ends::Closed, Ends::Open(End::Natural, End::Natural), Ends::Open(End::Slope(along), End::Natural)];
        let spline = fit_spline(&points, ends[case as usize % 3], tolerance).unwrap();
        check_smooth(&spline, 1000.0);
        let (first, last) = spline.domain();
        let dense: Vec<DVec3> =
            (0..=20_000).map(|i| spline.point(first + (last - first) * f64::from(i) / 2e4)).collect();
        for p in &points {
            let away = dense.iter().map(|q| q.distance(*p)).fold(f64::INFINITY, f64::min);
            // Half a step beside the foot of the perpendicular.
            let step = 0.6 * (last - first) / 2e4;
            assert!(away <= tolerance.hypot(step) + 1e-9, "{away} {tolerance}");
        }
        if !closed {
            assert!(spline.point(first).distance(points[0]) < 1e-11);
            assert!(spline.point(last).distance(points[count - 1]) < 1e-10);
        }
        if case % 3 == 2 {
            assert!((spline.jet(first).d1 - along).length() < 1e-9);
        }
        points_in += count;
        knots_out += spline.knots().len();
        // Tolerance 0: through the points.
        let through = fit_spline(&points, ends[case as usize % 3], 0.0).unwrap();
        assert_eq!(through, Spline::through(&points, ends[case as usize % 3]).unwrap());
    }
    assert!(3 * knots_out < points_in, "{points_in} {knots_out}");
}

/// A cubic needs no inner knot at all; a straight row of many points neither.
#[test]
fn no_knot_is_superfluous() {
    let straight: Vec<DVec3> = (0..200).map(|i| DVec3::new(f64::from(i), 0.0, 0.0)).collect();
    let spline = fit_spline(&straight, Ends::Open(End::Natural, End::Natural), 1e-6).unwrap();
    assert_eq!(spline.knots().len(), 2);
    let bent: Vec<DVec3> = (0..100).map(|i| DVec3::new(f64::from(i), 2e-5 * f64::from(i * i), 0.0)).collect();
    let spline = fit_spline(&bent, Ends::Open(End::Natural, End::Natural), 1e-3).unwrap();
    assert_eq!(spline.knots().len(), 2);
}

#[test]
fn bad_points_are_refused() {
    let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
    let natural = Ends::Open(End::Natural, End::Natural);
    assert_eq!(Spline::through(&[o, x, x, y], natural), Err(Error::Knots { index: 2 }));
    assert_eq!(Spline::through(&[o, x, y, o], Ends::Closed), Err(Error::Knots { index: 4 }));
    assert!(matches!(Spline::through(&[o], natural), Err(Error::TooFewPoints { .. })));
    assert!(matches!(Spline::through(&[o, x], Ends::Closed), Err(Error::TooFewPoints { .. })));
    assert!(matches!(
        Spline::through(&[o, x], Ends::Open(End::Jet(x, o), End::Natural)),
        Err(Error::TooFewPoints { .. })
    ));
    assert_eq!(Spline::through(&[o, DVec3::NAN, y], natural), Err(Error::Knots { index: 1 }));
    assert_eq!(Spline::new(vec![0.0, 1.0, 1.0], vec![o, x, y], natural), Err(Error::Knots { index: 2 }));
    assert!(fit_spline(&[o, x, x], natural, 0.1).is_err());
}
