//! Intersection curves against independent values: `tests/data/intersections.json` (40-digit root finding on the
//! implicit surfaces), the papers' closed forms, and the ellipse's length by the arithmetic-geometric mean.

use glam::DVec3;
use proptest::prelude::*;
use seamwright_geometry::{
    ByLength, Curve, DEFAULT_ACCURACY_MM, Edge, Ellipse, Quadric, Surface, Tube, TubeIntersection,
};
use seamwright_testkit::cases;
use serde_json::Value;
use std::f64::consts::{PI, TAU};

fn vector(v: &Value) -> DVec3 {
    let a: Vec<f64> = v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    DVec3::new(a[0], a[1], a[2])
}

fn axis(v: &Value) -> DVec3 {
    match v.as_str().unwrap() {
        "x" => DVec3::X,
        "y" => DVec3::Y,
        "z" => DVec3::Z,
        other => panic!("unknown axis {other}"),
    }
}

fn body(v: &Value) -> Quadric {
    match v["kind"].as_str().unwrap() {
        "cylinder" => Quadric::cylinder(DVec3::ZERO, axis(&v["axis"]), v["radius"].as_f64().unwrap()),
        "sphere" => Quadric::sphere(DVec3::ZERO, v["radius"].as_f64().unwrap()),
        "ellipsoid" => Quadric::ellipsoid(DVec3::ZERO, DVec3::Z, DVec3::X, vector(&v["semi"])),
        "plane" => Quadric::plane(vector(&v["point"]), vector(&v["normal"])),
        other => panic!("unknown body {other}"),
    }
    .unwrap()
}

#[test]
fn intersections_agree_with_forty_digit_root_finding() {
    let text = include_str!("../../../../tests/data/intersections.json");
    let data: Value = serde_json::from_str(text).unwrap();
    for case in data["cases"].as_array().unwrap() {
        let name = case["name"].as_str().unwrap();
        let n = &case["spec"]["nozzle"];
        let tube = Tube::new(
            vector(&n["origin_mm"]),
            vector(&n["direction"]),
            vector(&n["phi_zero_direction"]),
            n["radius_mm"].as_f64().unwrap(),
        )
        .unwrap();
        let curve = TubeIntersection::new(tube, body(&case["spec"]["body"])).unwrap();
        for row in case["rows"].as_array().unwrap() {
            let phi = row["phi_deg"].as_f64().unwrap().to_radians();
            let e = curve.edge(phi);
            let close = |what: &str, found: DVec3, key: &str, tolerance: f64| {
                let off = (found - vector(&row[key])).length();
                assert!(off <= tolerance, "{name} phi {phi}: {what} off by {off:e}");
            };
            close("point", e.point, "point_mm", 1e-9);
            close("tangent", e.d1.normalize(), "tangent", 1e-9);
            close("nozzle normal", e.n1, "nozzle_normal", 1e-9);
            close("body normal", e.n2, "body_normal", 1e-9);
        }
        let length = ByLength::new(&curve, DEFAULT_ACCURACY_MM).unwrap().length();
        let off = (length - case["length_mm"].as_f64().unwrap()).abs();
        assert!(off <= 1e-8, "{name}: length off by {off:e}");
    }
}

/// Quarter of an ellipse's circumference from the arithmetic-geometric mean (Gauss 1818), an independent closed form.
fn quarter_ellipse(a: f64, b: f64) -> f64 {
    let (mut x, mut y) = (a.max(b), a.min(b));
    let mut sum = 0.5 * (x * x - y * y);
    let e = x * x;
    let mut power = 1.0;
    while (x - y) > 1e-15 * x && power < 1e6 {
        let c = 0.5 * (x - y);
        (x, y) = (0.5 * (x + y), (x * y).sqrt());
        sum += power * c * c;
        power *= 2.0;
    }
    // E/K = 1 - sum / a^2, K = pi / (2 agm) for unit a.
    (e - sum) * PI / (2.0 * x)
}

#[test]
fn the_papers_ellipse_has_its_quarter_length() {
    assert!((quarter_ellipse(20.0, 16.0) - 28.361_667_888_974_5).abs() < 1e-12);
}

fn exact_inverse(curve: &dyn Curve, steps: u32) {
    let by = ByLength::new(curve, DEFAULT_ACCURACY_MM).unwrap();
    for i in 0..=steps {
        let s = by.length() * f64::from(i) / f64::from(steps);
        let back = by.length_at(by.parameter(s));
        assert!((back - s).abs() <= 1e-10, "at {s}: {:e}", back - s);
    }
}

/// Arc length between two parameters by Gauss-Legendre with five points on many pieces: independent of `ByLength`.
fn arc(curve: &dyn Curve, a: f64, b: f64, pieces: u32) -> f64 {
    let x = [0.0, 0.538_469_310_105_683_1, 0.906_179_845_938_664];
    let w = [0.568_888_888_888_888_9, 0.478_628_670_499_366_47, 0.236_926_885_056_189_08];
    let h = (b - a) / f64::from(pieces) / 2.0;
    (0..pieces)
        .map(|i| {
            let m = a + (2.0 * f64::from(i) + 1.0) * h;
            let pair = |k: usize| curve.speed(m - h * x[k]) + curve.speed(m + h * x[k]);
            h * (w[0] * curve.speed(m) + w[1] * pair(1) + w[2] * pair(2))
        })
        .sum()
}

fn random_nozzle() -> impl Strategy<Value = TubeIntersection> {
    let direction = (-0.6..0.6, -0.6..0.6).prop_map(|(x, y)| DVec3::new(x, y, 1.0));
    let kind = 0..5;
    (kind, direction, 0.05..0.55, -0.3..0.3, -0.3..0.3, 100.0..3000.0, (0.4..1.0, 0.4..1.0)).prop_filter_map(
        "nozzle must meet the body all round",
        |(kind, direction, ratio, dx, dy, size, (f, g))| {
            let body = match kind {
                0 => Quadric::cylinder(DVec3::ZERO, DVec3::X, size),
                1 => Quadric::sphere(DVec3::ZERO, size),
                2 => Quadric::ellipsoid(DVec3::ZERO, DVec3::Z, DVec3::X, size * DVec3::new(1.0, f, g)),
                3 => Quadric::plane(DVec3::new(1.0, 2.0, 3.0), DVec3::new(dx, dy, 1.0)),
                _ => Quadric::cone(DVec3::new(-2.0 * size, 0.0, 0.0), DVec3::X, 0.3 + 0.5 * f),
            }
            .unwrap();
            let origin = size * DVec3::new(dx, dy, 0.0);
            let tube = Tube::new(origin, direction, DVec3::X, 0.5 * ratio * size).unwrap();
            TubeIntersection::new(tube, body).ok()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(2000), max_global_rejects: 10_000_000, failure_persistence: None, ..ProptestConfig::default() })]

    /// SADDLE-2020: x = r cos, y = r sin, z = sqrt(R^2 - r^2 sin^2).
    #[test]
    fn saddle_is_the_papers_closed_form(shell in 50.0..5000.0, ratio in 0.01..0.99, phi in 0.0..TAU) {
        let r = ratio * shell;
        let tube = Tube::new(DVec3::ZERO, DVec3::Z, DVec3::X, r).unwrap();
        let curve = TubeIntersection::new(tube, Quadric::cylinder(DVec3::ZERO, DVec3::X, shell).unwrap()).unwrap();
        let (sin, cos) = phi.sin_cos();
        let expected = DVec3::new(r * cos, r * sin, ((shell - r * sin) * (shell + r * sin)).sqrt());
        prop_assert!((curve.point(phi) - expected).length() < 1e-9);
    }

    /// INTERSECT-2006: nozzle tilted by theta about x through a point of an ellipsoidal head.
    #[test]
    fn tilted_nozzle_on_a_head_is_the_papers_closed_form(
        rxy in 300.0..3000.0f64, flat in 0.3..1.0, at in -0.6..0.6f64, theta in -0.6..0.6f64, ratio in 0.02..0.25, phi in 0.0..TAU,
    ) {
        let (rz, r): (f64, f64) = (flat * rxy, ratio * flat * rxy);
        let (a, b): (f64, f64) = (0.0, at * rxy);
        let c = rz * (1.0 - (b / rxy).powi(2)).sqrt();
        let (sin, cos) = f64::sin_cos(theta);
        let tube = Tube::new(DVec3::new(a, b, c), DVec3::new(0.0, sin, cos), DVec3::X, r).unwrap();
        let body = Quadric::ellipsoid(DVec3::ZERO, DVec3::Z, DVec3::X, DVec3::new(rxy, rxy, rz)).unwrap();
        let curve = TubeIntersection::new(tube, body);
        prop_assume!(curve.is_ok());
        let l1 = r * phi.sin() + b * cos - c * sin;
        let l2 = 1.0 - ((r * phi.cos() + a) / rxy).powi(2);
        let p = (rxy * cos).powi(2) + (rz * sin).powi(2);
        let root = (p * l2 - l1 * l1).sqrt();
        let expected = DVec3::new(
            r * phi.cos() + a,
            (rxy * rxy * cos * l1 + rxy * rz * sin * root) / p,
            (-rz * rz * sin * l1 + rxy * rz * cos * root) / p,
        );
        prop_assert!((curve.unwrap().point(phi) - expected).length() < 1e-9);
    }

    #[test]
    fn any_nozzle_lies_on_both_surfaces_with_true_derivatives(curve in random_nozzle(), phi in 0.0..TAU) {
        let e = curve.edge(phi);
        let size = e.d1.length();
        prop_assert!(curve.body().value(e.point).abs() < 1e-9 * curve.body().gradient(e.point).length());
        prop_assert!(e.n2.dot(curve.tube().direction()) > 0.0, "the nozzle leaves the body here");
        prop_assert!(e.n1.dot(e.d1).abs() < 1e-9 * size && e.n2.dot(e.d1).abs() < 1e-9 * size);
        let h = 1e-5;
        let (l, r) = (curve.jet(phi - h), curve.jet(phi + h));
        let d2 = curve.jet(phi).d2;
        let bend = d2.length() + size;
        prop_assert!(((r.point - l.point) / (2.0 * h) - e.d1).length() < 1e-5 * bend);
        prop_assert!(((r.d1 - l.d1) / (2.0 * h) - d2).length() < 1e-2 * bend);
        // Further out on the same wall line there is no point of the body.
        for k in 1..40 {
            let p = e.point + curve.tube().direction() * size * 0.2 * f64::from(k);
            prop_assert!(curve.body().value(p) > 0.0 || curve.body().beyond_apex(p) < 0.0);
        }
    }

    #[test]
    fn ellipse_length_is_the_closed_form(a in 0.5..3000.0, ratio in 0.05..1.0) {
        let b = ratio * a;
        let curve = Ellipse::new(DVec3::ZERO, DVec3::Z, DVec3::X, a, b).unwrap();
        let length = ByLength::new(&curve, DEFAULT_ACCURACY_MM).unwrap().length();
        let off = (length - 4.0 * quarter_ellipse(a, b)).abs();
        prop_assert!(off < 1e-14 * length.max(100.0), "{} off by {:e}", length, off);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(200), max_global_rejects: 10_000_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn arc_length_and_its_inverse_agree_with_quadrature(curve in random_nozzle(), s in 0.0..1.0f64, step in 1e-5..1e-2f64) {
        let by = ByLength::new(&curve, DEFAULT_ACCURACY_MM).unwrap();
        let (from, step) = (s * by.length(), step * by.length());
        let (a, b) = (by.parameter(from), by.parameter(from + step));
        let measured = arc(&curve, a, b, 40);
        prop_assert!((measured - step).abs() < 1e-9 * step + 2e-12, "{:e}", measured - step);
        exact_inverse(&curve, 500);
    }
}

#[test]
fn closed_curves_repeat_beyond_their_ends() {
    let curve = Ellipse::new(DVec3::ZERO, DVec3::Z, DVec3::X, 20.0, 16.0).unwrap();
    let by = ByLength::new(&curve, DEFAULT_ACCURACY_MM).unwrap();
    for s in [-30.0, 0.0, 5.0, 113.0, 200.0] {
        assert!((by.parameter(s + by.length()) - by.parameter(s) - TAU).abs() < 1e-13);
        assert!((by.length_at(by.parameter(s)) - s).abs() < 1e-11);
    }
}
