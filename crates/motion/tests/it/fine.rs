//! The coarse spline against a dense solver, smooth paths, and an evaluation of the B-spline in its own form.

use proptest::prelude::*;
use seamwright_machine::{Joints, MAX_AXES};
use seamwright_motion::fine::{CoarseSpline, Knot, LOOK_AHEAD, Segment};

/// All knots of a stream of set-points.
fn knots(points: &[Joints], period: f64) -> Vec<Knot> {
    let mut spline = CoarseSpline::new(period);
    let mut knots: Vec<Knot> = Vec::new();
    for (i, q) in points.iter().enumerate() {
        knots.extend(spline.push(q));
        assert_eq!(knots.len(), (i + 1).saturating_sub(LOOK_AHEAD));
    }
    knots.extend(std::iter::from_fn(|| spline.finish()));
    assert!(knots.len() == points.len() && spline.finish().is_none());
    knots
}

/// The piecewise polynomial of a whole motion by elimination with pivots on all coefficients of one axis at once: each
/// segment through its two points, speed and acceleration equal at joins and 0 at the ends. First and last segment
/// are of the fourth degree, the others cubic. Coefficients by powers of the part of a period.
fn dense(y: &[f64]) -> Vec<Vec<f64>> {
    let n = y.len() - 1;
    let degree = |s: usize| 3 + usize::from(s == 0) + usize::from(s == n - 1);
    let first: Vec<usize> = (0..=n).map(|s| (0..s).map(|s| degree(s) + 1).sum()).collect();
    let size = first[n];
    let mut rows: Vec<Vec<f64>> = Vec::new();
    // A condition: derivative `d` at the end (1) or start (0) of segment s, times a factor.
    let mut add = |terms: &[(usize, i32, f64, f64)], right: f64| {
        let mut row = vec![0.0; size + 1];
        for &(s, d, t, factor) in terms {
            for p in 0..=degree(s) as i32 {
                let derivative: f64 = (0..d).map(|k| f64::from(p - k)).product();
                let power = if p < d { 0.0 } else { t.powi(p - d) };
                row[first[s] + p as usize] += factor * derivative * power;
            }
        }
        row[size] = right;
        rows.push(row);
    };
    for s in 0..n {
        add(&[(s, 0, 0.0, 1.0)], y[s]);
        add(&[(s, 0, 1.0, 1.0)], y[s + 1]);
    }
    for d in 1..=2 {
        add(&[(0, d, 0.0, 1.0)], 0.0);
        add(&[(n - 1, d, 1.0, 1.0)], 0.0);
        (1..n).for_each(|s| add(&[(s - 1, d, 1.0, 1.0), (s, d, 0.0, -1.0)], 0.0));
    }
    assert_eq!(rows.len(), size);
    for c in 0..size {
        let pivot = (c..size).max_by(|a, b| rows[*a][c].abs().total_cmp(&rows[*b][c].abs())).unwrap();
        rows.swap(c, pivot);
        let top = rows[c].clone();
        for row in rows.iter_mut().skip(c + 1).filter(|r| r[c] != 0.0) {
            let factor = row[c] / top[c];
            row.iter_mut().zip(&top).skip(c).for_each(|(x, t)| *x -= factor * t);
        }
    }
    let mut x = vec![0.0; size];
    for c in (0..size).rev() {
        let known: f64 = (c + 1..size).map(|k| rows[c][k] * x[k]).sum();
        x[c] = (rows[c][size] - known) / rows[c][c];
    }
    (0..n).map(|s| x[first[s]..first[s + 1]].to_vec()).collect()
}

/// Equal to the last bit.
fn same(a: &Joints, b: &Joints) -> bool {
    a.map(f64::to_bits) == b.map(f64::to_bits)
}

/// Set-points of several axes, wandering.
fn points() -> impl Strategy<Value = Vec<Joints>> {
    prop::collection::vec(prop::array::uniform3(-5.0f64..5.0), 2..60).prop_map(|steps| {
        let mut q = [0.0; MAX_AXES];
        q[0] = 700.0;
        let mut add = |s: &[f64; 3]| {
            (0..3).for_each(|i| q[i] += s[i]);
            q
        };
        steps.iter().map(&mut add).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn the_dense_solver_agrees(points in points(), period in 0.002f64..0.02) {
        let knots = knots(&points, period);
        for axis in 0..4 {
            let y: Vec<f64> = points.iter().map(|q| q[axis]).collect();
            let dense = dense(&y);
            for (s, coefficients) in dense.iter().enumerate() {
                let segment = Segment::new(&knots[s], &knots[s + 1], period);
                for part in [0.0, 0.21, 0.5, 0.77, 0.999] {
                    let value = coefficients.iter().rev().fold(0.0, |sum, c| sum * part + c);
                    let got = segment.at(part).q[axis];
                    prop_assert!((got - value).abs() < 1e-9, "{s} {part}: {got} {value}");
                }
            }
        }
    }

    #[test]
    fn exact_and_without_jumps(points in points(), period in 0.002f64..0.02) {
        let knots = knots(&points, period);
        let segments: Vec<Segment> = knots.windows(2).map(|k| Segment::new(&k[0], &k[1], period)).collect();
        let ends = [knots[0], knots[knots.len() - 1]];
        prop_assert!(ends.iter().all(|k| same(&k.v, &[0.0; MAX_AXES]) && same(&k.a, &[0.0; MAX_AXES])));
        for (s, segment) in segments.iter().enumerate() {
            // To the last bit.
            prop_assert!(same(&segment.at(0.0).q, &points[s]) && same(&segment.at(1.0).q, &points[s + 1]));
            // And the polynomial itself comes to its end, up to the rounding of its sum.
            let (near, end) = (segment.at(1.0 - f64::EPSILON), segment.at(1.0));
            for i in 0..3 {
                prop_assert!((near.q[i] - end.q[i]).abs() < 1e-12 * (1.0 + end.q[i].abs()));
                let speed = 10.0 / period;
                prop_assert!((near.v[i] - end.v[i]).abs() < 1e-10 * speed);
                prop_assert!((near.a[i] - end.a[i]).abs() < 1e-9 * speed / period);
            }
            // Inner segments are cubic: the fourth difference of five equally spaced values is 0.
            if s > 0 && s + 1 < segments.len() {
                let v: Vec<f64> = (0..5).map(|k| segment.at(0.2 * f64::from(k)).q[1]).collect();
                prop_assert!((v[0] - 4.0 * v[1] + 6.0 * v[2] - 4.0 * v[3] + v[4]).abs() < 1e-10);
            }
        }
    }

    /// A control that is given the control points, and sums the four basis functions, comes through every set-point.
    #[test]
    fn control_points_make_the_same_curve(points in points(), period in 0.002f64..0.02) {
        // At rest before and after, as exported.
        let rest = 24;
        let mut padded = vec![points[0]; rest];
        padded.extend(&points);
        padded.extend(vec![points[points.len() - 1]; rest]);
        let knots = knots(&padded, period);
        let control: Vec<Joints> = knots.iter().map(|k| k.control_point(period)).collect();
        for (s, c) in control.windows(4).enumerate() {
            let segment = Segment::new(&knots[s + 1], &knots[s + 2], period);
            for u in [0.0f64, 0.3, 0.8] {
                let basis = [
                    (1.0 - u).powi(3),
                    3.0 * u.powi(3) - 6.0 * u * u + 4.0,
                    -3.0 * u.powi(3) + 3.0 * u * u + 3.0 * u + 1.0,
                    u.powi(3),
                ];
                for i in 0..3 {
                    let value: f64 = (0..4).map(|k| basis[k] * c[k][i] / 6.0).sum();
                    // The outermost segments are of the fourth degree; at rest nothing is left of them.
                    prop_assert!((value - segment.at(u).q[i]).abs() < 1e-9, "{s} {u}");
                    if u == 0.0 {
                        prop_assert!((value - padded[s + 1][i]).abs() < 1e-9);
                    }
                }
            }
        }
        for i in 0..3 {
            prop_assert!((control[0][i] - points[0][i]).abs() < 1e-9 * 5.0);
        }
    }
}

/// A move whose first three derivatives are 0 at its ends: the error falls with the fourth power of the period.
#[test]
fn error_of_the_fourth_order() {
    let path = |t: f64| 80.0 * (std::f64::consts::PI * t).sin().powi(4);
    let error = |n: u32| {
        let h = 1.0 / f64::from(n);
        let points: Vec<Joints> = (0..=n)
            .map(|k| {
                let mut q = [0.0; MAX_AXES];
                q[0] = path(f64::from(k) * h);
                q
            })
            .collect();
        let knots = knots(&points, h);
        let mut worst = 0.0f64;
        for (s, k) in knots.windows(2).enumerate() {
            let segment = Segment::new(&k[0], &k[1], h);
            for part in [0.1, 0.35, 0.5, 0.8] {
                worst = worst.max((segment.at(part).q[0] - path((s as f64 + part) * h)).abs());
            }
        }
        worst
    };
    let (coarse, fine, finest) = (error(50), error(100), error(200));
    assert!((14.0..18.0).contains(&(coarse / fine)) && (14.0..18.0).contains(&(fine / finest)));
}

#[test]
fn one_point_and_two() {
    let q = [3.0; MAX_AXES];
    assert_eq!(knots(&[q], 0.01), [Knot { q, ..Knot::default() }]);
    let k = knots(&[q, [4.0; MAX_AXES]], 0.01);
    let middle = Segment::new(&k[0], &k[1], 0.01).at(0.5);
    assert!((middle.q[0] - 3.5).abs() < 1e-14 && (middle.v[0] - 187.5).abs() < 1e-9 && middle.a[0].abs() < 1e-7);
    assert!(knots(&[], 0.01).is_empty());
}
