//! Signed distances against a search of the parametrised surface.

use glam::{DMat3, DVec3};
use seamwright_geometry::{Quadric, QuadricDistance, SignedDistance, Surface, Tube};
use seamwright_testkit::{Random, cases};
use std::f64::consts::{PI, TAU};

/// A body as a distance, with a parametrisation in (u, v) over a rectangle and its inside.
struct Body {
    name: &'static str,
    distance: Box<dyn SignedDistance>,
    inside: Box<dyn Fn(DVec3) -> bool>,
    point: Box<dyn Fn(f64, f64) -> DVec3>,
    low: (f64, f64),
    high: (f64, f64),
}

fn of(name: &'static str, body: Quadric, point: impl Fn(f64, f64) -> DVec3 + 'static, v: (f64, f64)) -> Body {
    let distance = Box::new(QuadricDistance::new(&body));
    Body {
        name,
        distance,
        inside: Box::new(move |p| body.value(p) < 0.0 && body.beyond_apex(p) > 0.0),
        point: Box::new(point),
        low: (0.0, v.0),
        high: (TAU, v.1),
    }
}

fn bodies(random: &mut Random) -> Vec<Body> {
    let o = random.vector(100.0);
    let z = random.direction();
    let x = z.any_orthonormal_vector();
    let f = DMat3::from_cols(x, z.cross(x), z);
    let r = random.within(20.0, 200.0);
    let half_angle = random.within(0.1, 1.4);
    let (a, b, c) = (random.within(20.0, 200.0), random.within(20.0, 200.0), random.within(20.0, 200.0));
    let ball =
        |semi: DVec3| move |u: f64, v: f64| o + f * (semi * DVec3::new(u.cos() * v.sin(), u.sin() * v.sin(), v.cos()));
    let round = |a: f64, b: f64| move |u: f64, v: f64| o + f * DVec3::new(a * u.cos(), b * u.sin(), v);
    let mut plane =
        of("plane", Quadric::plane(o, z).unwrap(), move |u, v| o + f * DVec3::new(u, v, 0.0), (-1000.0, 1000.0));
    (plane.low.0, plane.high.0) = (-1000.0, 1000.0);
    let tube = Tube::new(o, z, x, r).unwrap();
    let as_tube = Body {
        name: "tube",
        distance: Box::new(tube),
        ..of("", Quadric::cylinder(o, z, r).unwrap(), round(r, r), (-1000.0, 1000.0))
    };
    vec![
        plane,
        as_tube,
        of("sphere", Quadric::sphere(o, r).unwrap(), ball(DVec3::splat(r)), (0.0, PI)),
        of("cylinder", Quadric::cylinder(o, z, r).unwrap(), round(r, r), (-1000.0, 1000.0)),
        of("oval", Quadric::elliptic_cylinder(o, z, x, a, b).unwrap(), round(a, b), (-1000.0, 1000.0)),
        of(
            "ellipsoid",
            Quadric::ellipsoid(o, z, x, DVec3::new(a, b, c)).unwrap(),
            ball(DVec3::new(a, b, c)),
            (0.0, PI),
        ),
        of(
            "cone",
            Quadric::cone(o, z, half_angle).unwrap(),
            move |u, v| {
                o + v * (f * DVec3::new(half_angle.sin() * u.cos(), half_angle.sin() * u.sin(), half_angle.cos()))
            },
            (0.0, 1000.0),
        ),
    ]
}

fn searched(body: &Body, p: DVec3) -> f64 {
    let n = 40;
    let mut starts = Vec::new();
    let (du, dv) = ((body.high.0 - body.low.0) / f64::from(n), (body.high.1 - body.low.1) / f64::from(n));
    for i in 0..n {
        for j in 0..n {
            let (u, v) = (body.low.0 + du * (f64::from(i) + 0.5), body.low.1 + dv * (f64::from(j) + 0.5));
            starts.push((((body.point)(u, v) - p).length(), u, v));
        }
    }
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let zoomed = starts[..8].iter().map(|&(first, u, v)| {
        let (mut best, mut width) = ((first, u, v), 1.0);
        while width > 1e-7 {
            let (_, u, v) = best;
            let here = best.0;
            for i in -2..=2 {
                for j in -2..=2 {
                    let at = (u + 0.5 * width * du * f64::from(i), v + 0.5 * width * dv * f64::from(j));
                    let v = at.1.clamp(body.low.1, body.high.1);
                    let d = ((body.point)(at.0, v) - p).length();
                    if d < best.0 {
                        best = (d, at.0, v);
                    }
                }
            }
            if best.0 >= here {
                width *= 0.5;
            }
        }
        best.0
    });
    zoomed.fold(f64::INFINITY, f64::min)
}

#[test]
fn distances_are_the_least_over_the_surface() {
    let mut random = Random::new(3);
    for _ in 0..cases(600) {
        for body in bodies(&mut random) {
            let p = random.vector(300.0);
            let foot = body.distance.foot(p);
            let least = searched(&body, p);
            assert!((foot.distance.abs() - least).abs() < 1e-9, "{} {p}: {} {least}", body.name, foot.distance);
            assert_eq!(foot.distance < 0.0, (body.inside)(p), "{} {p}", body.name);
        }
    }
}

#[test]
fn the_foot_lies_on_the_surface_and_the_normal_is_the_gradient() {
    let mut random = Random::new(4);
    for _ in 0..cases(2000) {
        for body in bodies(&mut random) {
            let p = random.vector(300.0);
            let foot = body.distance.foot(p);
            assert!((foot.normal.length() - 1.0).abs() < 1e-12);
            let on = body.distance.foot(p - foot.distance * foot.normal);
            assert!(on.distance.abs() < 1e-9, "{} {p}: {foot:?} {on:?}", body.name);
            // Away from points with two feet the distance has a gradient.
            let along = random.direction();
            let (l, r) = (body.distance.foot(p - 1e-4 * along), body.distance.foot(p + 1e-4 * along));
            if (l.normal - r.normal).length() < 1e-3 {
                let slope = (r.distance - l.distance) / 2e-4;
                assert!((slope - foot.normal.dot(along)).abs() < 1e-5, "{} {p}", body.name);
            }
        }
    }
}

#[test]
fn centres_axes_and_apexes_have_a_distance() {
    let at = |body: &Quadric, p: DVec3| QuadricDistance::new(body).foot(p);
    let o = DVec3::new(5.0, -3.0, 2.0);
    for (body, expected) in [
        (Quadric::sphere(o, 30.0).unwrap(), -30.0),
        (Quadric::cylinder(o, DVec3::X, 7.0).unwrap(), -7.0),
        (Quadric::ellipsoid(o, DVec3::Z, DVec3::X, DVec3::new(20.0, 40.0, 30.0)).unwrap(), -20.0),
        (Quadric::elliptic_cylinder(o, DVec3::Z, DVec3::X, 20.0, 40.0).unwrap(), -20.0),
        (Quadric::cone(o, DVec3::Z, 0.5).unwrap(), 0.0),
        (Quadric::plane(o, DVec3::Z).unwrap(), 0.0),
    ] {
        let foot = at(&body, o);
        assert!((foot.distance - expected).abs() < 1e-9 && (foot.normal.length() - 1.0).abs() < 1e-12, "{foot:?}");
    }
    // On an ellipsoid's long axis, inside the centre of curvature, the nearest points lie to the sides.
    let long = Quadric::ellipsoid(o, DVec3::Z, DVec3::X, DVec3::new(100.0, 20.0, 20.0)).unwrap();
    let exact = -20.0 * (1.0 - 30.0f64.powi(2) / (100.0f64.powi(2) - 20.0f64.powi(2))).sqrt();
    assert!((at(&long, o + 30.0 * DVec3::X).distance - exact).abs() < 1e-9);
    let cone = Quadric::cone(o, DVec3::Z, 0.5).unwrap();
    assert!((at(&cone, o - 10.0 * DVec3::Z).distance - 10.0).abs() < 1e-12);
    assert!((at(&cone, o + 10.0 * DVec3::Z).distance + 10.0 * 0.5f64.sin()).abs() < 1e-12);
}
