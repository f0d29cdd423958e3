//! Rigid fits: exact points recover the displacement; noise is averaged; undetermined motions are reported.

use glam::{DAffine3, DVec3};
use seamwright_geometry::fit::{Motion, Touch, best_fit, fit_pairs, outliers, plane_line_point, rms, run_out};
use seamwright_geometry::{Error, Quadric, QuadricDistance, SignedDistance, Tube};
use seamwright_testkit::{Random, cases};
use std::f64::consts::TAU;

/// Distance of two rigid motions: mm of the origin, rad.
fn apart(a: &DAffine3, b: &DAffine3) -> (f64, f64) {
    let between = a.matrix3.transpose() * b.matrix3;
    let sine = DVec3::new(
        between.y_axis.z - between.z_axis.y,
        between.z_axis.x - between.x_axis.z,
        between.x_axis.y - between.y_axis.x,
    );
    let trace = between.x_axis.x + between.y_axis.y + between.z_axis.z;
    ((a.translation - b.translation).length(), sine.length().atan2(trace - 1.0))
}

const MM: f64 = 1e-8;
const RAD: f64 = 1e-9;
const ANGLE: f64 = 30.0 / 360.0 * TAU;

fn same(found: &DAffine3, true_one: &DAffine3, what: &str) {
    let (mm, rad) = apart(found, true_one);
    assert!(mm < MM && rad < RAD, "{what}: {mm:e} mm, {rad:e} rad");
}

/// Surfaces of a nozzle on a body, and points on them round the seam (surface 0: the nozzle).
struct Part {
    surfaces: [Box<dyn SignedDistance>; 2],
    points: Vec<(DVec3, usize)>,
}

fn tube(radius: f64) -> Tube {
    Tube::new(DVec3::ZERO, DVec3::Z, DVec3::X, radius).unwrap()
}

/// Moves a point onto the surface: distances are tested on their own.
fn onto(surface: &dyn SignedDistance, p: DVec3) -> DVec3 {
    let foot = surface.foot(p);
    p - foot.distance * foot.normal
}

/// `n` points on the nozzle above the body and on the body around it, ends of the normals moved out by `outside`.
fn part(body: &Quadric, height: f64, radius: f64, n: usize, random: &mut Random) -> Part {
    let surfaces: [Box<dyn SignedDistance>; 2] = [Box::new(tube(radius)), Box::new(QuadricDistance::new(body))];
    let mut points = Vec::new();
    for i in 0..n {
        let phi = (i as f64 + random.within(-0.3, 0.3)) / n as f64 * TAU;
        let out = DVec3::new(phi.cos(), phi.sin(), 0.0);
        points.push((radius * out + random.within(0.1, 0.8) * radius * DVec3::Z + height * DVec3::Z, 0));
        let beside = random.within(1.2, 1.9) * radius * out + height * DVec3::Z;
        points.push((onto(surfaces[1].as_ref(), beside), 1));
    }
    Part { surfaces, points }
}

fn touches<'a>(part: &'a Part, move_by: impl Fn(DVec3, usize) -> DVec3) -> Vec<Touch<'a>> {
    let touch =
        |(p, k): &(DVec3, usize)| Touch { point: move_by(*p, *k), surface: part.surfaces[*k].as_ref(), outside: 0.0 };
    part.points.iter().map(touch).collect()
}

fn shell() -> Quadric {
    Quadric::cylinder(DVec3::ZERO, DVec3::X, 800.0).unwrap()
}

#[test]
fn pairs_bring_the_displacement_back() {
    let mut random = Random::new(11);
    for case in 0..cases(5000) {
        let there = random.displacement(ANGLE, 200.0);
        let n = 3 + case as usize % 6;
        let nominal: Vec<DVec3> = (0..n).map(|_| random.vector(500.0)).collect();
        let pairs: Vec<_> = nominal.iter().map(|p| (*p, there.transform_point3(*p))).collect();
        let width = (nominal[1] - nominal[0]).cross(nominal[2] - nominal[0]).length();
        if n == 3 && width < 0.05 * (nominal[1] - nominal[0]).length_squared() {
            continue; // nearly on a line
        }
        let fit = fit_pairs(&pairs).unwrap();
        same(&fit.transform, &there, "pairs");
        assert!(fit.residuals.iter().all(|r| r.length() < MM));
        assert_eq!(fit.sides.is_some(), n == 3);
    }
}

#[test]
fn three_points_with_errors_keep_the_first_the_line_and_the_plane() {
    let nominal = [DVec3::ZERO, DVec3::new(100.0, 0.0, 0.0), DVec3::new(0.0, 80.0, 0.0)];
    let measured = [DVec3::new(1.0, 2.0, 3.0), DVec3::new(101.5, 2.0, 3.0), DVec3::new(1.2, 82.0, 3.0)];
    let fit = fit_pairs(&std::array::from_fn::<_, 3, _>(|i| (nominal[i], measured[i]))).unwrap();
    assert!(apart(&fit.transform, &DAffine3::from_translation(measured[0])) < (1e-12, 1e-12));
    let expected = [DVec3::ZERO, DVec3::new(0.5, 0.0, 0.0), DVec3::new(0.2, 0.0, 0.0)];
    for (residual, expected) in fit.residuals.iter().zip(expected) {
        assert!((*residual - expected).length() < 1e-12, "{residual}");
    }
    let third = (0.2f64 * 0.2 + 80.0 * 80.0).sqrt() - 80.0;
    let second = (100.3f64 * 100.3 + 80.0 * 80.0).sqrt() - (100.0f64 * 100.0 + 80.0 * 80.0).sqrt();
    for (side, expected) in fit.sides.unwrap().into_iter().zip([0.5, second, third]) {
        assert!((side - expected).abs() < 1e-12);
    }
}

#[test]
fn pairs_with_noise_are_at_the_least_sum_and_their_errors_shrink() {
    let mut random = Random::new(12);
    let mut errors = [Vec::new(), Vec::new()];
    for _ in 0..cases(300) {
        for (which, n) in [8, 128].into_iter().enumerate() {
            let there = random.displacement(ANGLE, 200.0);
            let noisy = |random: &mut Random| {
                let p = random.vector(300.0);
                (p, there.transform_point3(p) + 0.1 * DVec3::new(random.normal(), random.normal(), random.normal()))
            };
            let pairs: Vec<_> = (0..n).map(|_| noisy(&mut random)).collect();
            let fit = fit_pairs(&pairs).unwrap();
            let sum = |t: &DAffine3| pairs.iter().map(|(a, b)| (*b - t.transform_point3(*a)).length_squared()).sum();
            at_the_bottom(&fit.transform, 300.0, sum);
            let deviation = fit.deviation.unwrap();
            let middle = there.inverse().transform_point3(deviation.at);
            let off = fit.transform.transform_point3(middle) - deviation.at;
            errors[which].push((off / deviation.shift).length());
            errors[which].push(off.length() / 0.1 * f64::from(n).sqrt());
        }
    }
    // The errors, both in units of their estimated deviations and of noise / sqrt(n), are three normal numbers.
    for errors in errors {
        for kind in 0..2 {
            let of_kind: Vec<f64> = errors.iter().skip(kind).step_by(2).copied().collect();
            let size = rms(&of_kind) / 3f64.sqrt();
            assert!((0.85..1.2).contains(&size), "{kind} {size}");
        }
    }
}

fn at_the_bottom(at: &DAffine3, reach: f64, sum: impl Fn(&DAffine3) -> f64) {
    let least = sum(at);
    let middle = at.translation;
    for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
        for turn in [false, true] {
            let moved = |h: f64| {
                let motion = if turn {
                    DAffine3::from_translation(middle)
                        * DAffine3::from_axis_angle(axis, h / reach)
                        * DAffine3::from_translation(-middle)
                } else {
                    DAffine3::from_translation(h * axis)
                };
                sum(&(motion * *at))
            };
            let (h, up, down) = (1e-3, moved(1e-3), moved(-1e-3));
            let (slope, bend) = ((up - down) / (2.0 * h), (up + down - 2.0 * least) / (h * h));
            // A Newton step from here would be zero; undetermined directions have zero slope and curvature.
            assert!(slope.abs() < 1e-6 * bend.abs() + 1e-7, "{axis} {turn}: {slope} {bend}");
        }
    }
}

#[test]
fn too_few_and_gathered_points_are_refused() {
    let p = |x: f64| DVec3::new(x, 2.0 * x, -x);
    let on_a_line: Vec<_> = (0..5).map(|i| (p(f64::from(i)), p(f64::from(i)))).collect();
    assert_eq!(
        fit_pairs(&on_a_line[..2]),
        Err(Error::TooFewPoints { what: "geometry-points-frame", given: 2, min: 3 })
    );
    for n in [3, 5] {
        assert!(matches!(fit_pairs(&on_a_line[..n]), Err(Error::OneLine { .. })));
    }
    let plane = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let same = |plane: &[DVec3], line: &[DVec3], point: &[DVec3]| {
        plane_line_point(plane, line, point, 0.0, &DAffine3::IDENTITY).unwrap_err()
    };
    assert!(matches!(same(&plane[..2], &plane, &plane), Error::TooFewPoints { what: "geometry-points-plane", .. }));
    assert!(matches!(same(&plane, &plane[..1], &plane), Error::TooFewPoints { what: "geometry-points-line", .. }));
    assert!(matches!(same(&plane, &plane, &[]), Error::TooFewPoints { what: "geometry-points-point", .. }));
    assert!(matches!(same(&[p(0.0), p(1.0), p(2.0)], &plane, &plane), Error::OneLine { .. }));
    assert!(matches!(same(&plane, &[DVec3::X, DVec3::X], &plane), Error::OnePosition { .. }));
    assert!(best_fit(&[], &DAffine3::IDENTITY, false).is_err());
    assert!(run_out(&[DVec3::X, DVec3::Y], 0.0, &tube(1.0), DVec3::ZERO).is_err());
    let not_finite = [(DVec3::ZERO, DVec3::NAN), (DVec3::X, DVec3::X), (DVec3::Y, DVec3::Y)];
    assert_eq!(fit_pairs(&not_finite), Err(Error::NoFit));
    let surface = tube(1.0);
    let nan = Touch { point: DVec3::NAN, surface: &surface, outside: 0.0 };
    assert_eq!(best_fit(&[nan], &DAffine3::IDENTITY, false), Err(Error::NoFit));
}

#[test]
fn three_faces_bring_the_displacement_back() {
    let mut random = Random::new(13);
    for case in 0..cases(5000) {
        let there = random.displacement(ANGLE, 200.0);
        let radius = random.within(0.0, 5.0);
        let mut put = |n: u32, x: (f64, f64), y: (f64, f64), z: (f64, f64)| -> Vec<DVec3> {
            let mut one = |i: u32| {
                // Spread round the face, so that no case is nearly on a line.
                let phi = (f64::from(i) + random.within(0.0, 0.4)) / f64::from(n) * TAU;
                let between = |(l, h): (f64, f64), part: f64| l + (h - l) * (0.5 + 0.5 * part);
                let p = DVec3::new(between(x, phi.cos()), between(y, phi.sin()), between(z, phi.sin()));
                there.transform_point3(p)
            };
            (0..n).map(&mut one).collect()
        };
        let plane = put(3 + case % 4, (0.0, 400.0), (0.0, 300.0), (radius, radius));
        let line = put(2 + case % 3, (10.0, 390.0), (-radius, -radius), (-30.0, 0.0));
        let point = put(1 + case % 2, (-radius, -radius), (50.0, 60.0), (-10.0, -5.0));
        let fit = plane_line_point(&plane, &line, &point, radius, &DAffine3::IDENTITY).unwrap();
        same(&fit.transform, &there, "three faces");
        assert!(fit.plane.iter().chain(&fit.line).chain(&fit.point).all(|r| r.abs() < MM));
    }
}

#[test]
fn residuals_of_faces_count_outwards() {
    let plane =
        [DVec3::new(0.0, 0.0, 0.3), DVec3::new(9.0, 0.0, -0.3), DVec3::new(9.0, 9.0, 0.3), DVec3::new(0.0, 9.0, -0.3)];
    let line = [DVec3::new(0.0, -0.1, 0.0), DVec3::new(5.0, 0.2, 0.0), DVec3::new(10.0, -0.1, 0.0)];
    let point = [DVec3::new(-0.2, 1.0, 0.0), DVec3::new(0.2, 2.0, 0.0)];
    let fit = plane_line_point(&plane, &line, &point, 0.0, &DAffine3::IDENTITY).unwrap();
    for (found, expected) in
        [(&fit.plane, vec![0.3, -0.3, 0.3, -0.3]), (&fit.line, vec![0.1, -0.2, 0.1]), (&fit.point, vec![0.2, -0.2])]
    {
        assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?} {expected:?}");
    }
    same(&fit.transform, &DAffine3::IDENTITY, "three rough faces");
}

#[test]
fn surfaces_bring_the_displacement_back() {
    let mut random = Random::new(14);
    for case in 0..cases(2000) {
        let there = random.displacement(ANGLE, 200.0);
        let part = match case % 3 {
            0 => part(&shell(), 800.0, 250.0, 12, &mut random),
            1 => {
                let oval = DVec3::new(1000.0, 900.0, 500.0);
                let head = Quadric::ellipsoid(DVec3::ZERO, DVec3::Z, DVec3::X, oval).unwrap();
                let oblique = DVec3::new(0.0, 300.0, 0.0);
                let mut part = part(&head, 500.0, 150.0, 12, &mut random);
                let head = Quadric::ellipsoid(oblique, DVec3::Z, DVec3::X, oval).unwrap();
                part.surfaces[1] = Box::new(QuadricDistance::new(&head));
                for (p, _) in part.points.iter_mut().filter(|p| p.1 == 1) {
                    *p = onto(part.surfaces[1].as_ref(), *p);
                }
                part
            }
            _ => {
                let cone = Quadric::cone(DVec3::new(-500.0, 0.0, 0.0), DVec3::X, 0.6).unwrap();
                part(&cone, 400.0, 120.0, 12, &mut random)
            }
        };
        let radius = random.within(0.0, 4.0);
        let mut list = touches(&part, |p, k| there.transform_point3(p + radius * part.surfaces[k].foot(p).normal));
        for touch in &mut list {
            touch.outside = radius;
        }
        let fit = best_fit(&list, &DAffine3::IDENTITY, false).unwrap();
        assert!(fit.free.is_empty(), "{:?}", fit.free);
        assert!(rms(&fit.residuals) < 1e-9, "case {case}: {}", rms(&fit.residuals));
        same(&fit.transform, &there, "surfaces");
    }
}

#[test]
fn surfaces_with_noise_are_at_the_least_sum_and_their_errors_shrink() {
    let mut random = Random::new(15);
    let mut sizes = Vec::new();
    for n in [10, 160] {
        let (mut inside, mut shifts) = (Vec::new(), Vec::new());
        for _ in 0..cases(150) {
            let there = random.displacement(0.1, 20.0);
            let part = part(&shell(), 800.0, 250.0, n, &mut random);
            let noise: Vec<f64> = part.points.iter().map(|_| 0.05 * random.normal()).collect();
            let mut list = touches(&part, |p, _| there.transform_point3(p));
            for (touch, noise) in list.iter_mut().zip(&noise) {
                let normal = touch.surface.foot(there.inverse().transform_point3(touch.point)).normal;
                touch.point += *noise * there.transform_vector3(normal);
            }
            let fit = best_fit(&list, &DAffine3::IDENTITY, false).unwrap();
            let distance =
                |t: &DAffine3, touch: &Touch| touch.surface.foot(t.inverse().transform_point3(touch.point)).distance;
            at_the_bottom(&fit.transform, 500.0, |t| list.iter().map(|touch| distance(t, touch).powi(2)).sum());
            for (residual, touch) in fit.residuals.iter().zip(&list) {
                assert!((residual - distance(&fit.transform, touch)).abs() < 1e-12);
            }
            let deviation = fit.deviation.unwrap();
            let middle = there.inverse().transform_point3(deviation.at);
            let off = fit.transform.transform_point3(middle) - deviation.at;
            inside.extend((off / deviation.shift).to_array());
            shifts.push(off.length());
        }
        assert!((0.85..1.25).contains(&rms(&inside)), "{}", rms(&inside));
        sizes.push(rms(&shifts));
    }
    let ratio = sizes[0] / sizes[1];
    assert!((3.4..4.6).contains(&ratio), "16 times the points, a quarter of the error: {ratio}");
}

#[test]
fn a_turned_tube_s_axis_comes_back() {
    let mut random = Random::new(16);
    for _ in 0..cases(3000) {
        let (direction, origin) = (random.direction(), random.vector(300.0));
        let nominal = Tube::new(origin, direction, direction.any_orthonormal_vector(), 100.0).unwrap();
        let (e1, e2) = (direction.any_orthonormal_vector(), direction.cross(direction.any_orthonormal_vector()));
        let at = origin + random.within(-50.0, 150.0) * direction;
        let eccentricity = random.within(-5.0, 5.0) * e1 + random.within(-5.0, 5.0) * e2;
        let lean = (random.within(-0.05, 0.05) * e1 + random.within(-0.05, 0.05) * e2) + direction;
        let (axis, growth, radius) = (lean.normalize(), random.within(-0.5, 0.5), random.within(0.0, 3.0));
        let (a, b) = (axis.any_orthonormal_vector(), axis.cross(axis.any_orthonormal_vector()));
        let mut points = Vec::new();
        for height in [0.0, 80.0] {
            for i in 0..4 {
                let (sin, cos) = (f64::from(i) * TAU / 4.0 + random.within(-0.5, 0.5)).sin_cos();
                points.push(at + eccentricity + height * axis + (100.0 + growth + radius) * (cos * a + sin * b));
            }
        }
        let found = run_out(&points, radius, &nominal, at).unwrap();
        assert!((found.eccentricity - eccentricity).length() < MM, "{}", (found.eccentricity - eccentricity).length());
        let tilt = axis.cross(direction).length().atan2(axis.dot(direction));
        assert!((found.tilt - tilt).abs() < RAD);
        assert!((found.leans_to - (lean - direction).normalize()).length() < 1e-6 || tilt < 1e-4);
        assert!((found.growth.unwrap() - growth).abs() < MM && found.free.is_empty(), "{:?}", found.free);
        assert!(found.residuals.iter().all(|r| r.abs() < MM));
        // The correction maps the nominal axis to the true one, without a turn about it.
        assert!((found.correction.transform_point3(at) - at - eccentricity).length() < MM);
        assert!((found.correction.transform_vector3(direction) - axis).length() < RAD);
        let turned = found.correction.transform_vector3(direction.cross(axis));
        assert!((turned - direction.cross(axis)).length() < RAD);
    }
}

fn words(free: &[Motion]) -> Vec<String> {
    let mut words: Vec<String> = free.iter().map(ToString::to_string).collect();
    words.sort();
    words
}

#[test]
fn what_the_points_do_not_see_is_told_and_left_alone() {
    let z = "turning about the axis along (0, 0, 1) through (0, 0, 0) mm";
    let about = |axis: &str, at: &str| format!("turning about the axis along {axis} through {at} mm");
    let ball = Quadric::sphere(DVec3::ZERO, 400.0).unwrap();
    let plate = Quadric::plane(DVec3::new(0.0, 0.0, 50.0), DVec3::Z).unwrap();
    let mut random = Random::new(17);
    for (name, body, height, only, expected) in [
        ("nozzle alone", &ball, 300.0, Some(0), vec!["moving along (0, 0, 1)".to_owned(), z.to_owned()]),
        ("nozzle on a ball", &ball, 380.0, None, vec![z.to_owned()]),
        ("nozzle on a plate", &plate, 50.0, None, vec![z.to_owned()]),
        (
            "ball alone",
            &ball,
            380.0,
            Some(1),
            vec![about("(0, 0, 1)", "(0, 0, 0)"), about("(0, 1, 0)", "(0, 0, 0)"), about("(1, 0, 0)", "(0, 0, 0)")],
        ),
    ] {
        let mut part = part(body, height, 100.0, 10, &mut random);
        part.points.retain(|p| only.is_none_or(|k| k == p.1));
        let fit = best_fit(&touches(&part, |p, _| p), &DAffine3::IDENTITY, false).unwrap();
        let found: Vec<String> = fit.free.iter().map(|m| near_axis(*m).to_string()).collect();
        let mut found = found;
        found.sort();
        assert_eq!(found, expected, "{name}");
        same(&fit.transform, &DAffine3::IDENTITY, name);
    }
    // A plane alone: two moves in it, and a turn about its normal.
    let mut part = part(&plate, 50.0, 100.0, 10, &mut random);
    part.points.retain(|p| p.1 == 1);
    let lifted = best_fit(&touches(&part, |p, _| p + 3.0 * DVec3::Z), &DAffine3::IDENTITY, false).unwrap();
    let free = words(&lifted.free);
    assert_eq!(&free[..2], ["moving along (0, 1, 0)", "moving along (1, 0, 0)"]);
    assert!(free.len() == 3 && free[2].starts_with("turning about the axis along (0, 0, 1)"), "{free:?}");
    same(&lifted.transform, &DAffine3::from_translation(3.0 * DVec3::Z), "a lifted plate");
}

fn near_axis(motion: Motion) -> Motion {
    match motion {
        Motion::About { point, direction, pitch } => {
            Motion::About { point: point - point.dot(direction) * direction, direction, pitch }
        }
        along @ Motion::Along(_) => along,
    }
}

#[test]
fn one_ring_tells_no_tilt_and_half_a_ring_still_the_radius() {
    let nominal = tube(100.0);
    let ring = |angles: &[f64], r: f64| -> Vec<DVec3> {
        angles.iter().map(|a| DVec3::new(2.0 + r * a.cos(), r * a.sin(), 40.0)).collect()
    };
    let found = run_out(&ring(&[0.0, 1.5, 3.0, 4.5, 5.5], 100.25), 0.0, &nominal, DVec3::ZERO).unwrap();
    assert!((found.eccentricity - 2.0 * DVec3::X).length() < MM && found.tilt < RAD);
    assert!((found.growth.unwrap() - 0.25).abs() < MM);
    let free = words(&found.free);
    assert_eq!(free.len(), 2, "{free:?}");
    assert!(free.iter().all(|w| w.starts_with("turning") && w.contains("40) mm")), "{free:?}");
    let three = run_out(&ring(&[0.0, 1.5, 3.0], 100.0), 0.0, &nominal, DVec3::ZERO).unwrap();
    assert!((three.eccentricity - 2.0 * DVec3::X).length() < MM);
    let flat = run_out(&ring(&[0.0, 0.0, 0.0], 100.0), 0.0, &nominal, DVec3::ZERO).unwrap();
    assert!(flat.growth.is_none() && (flat.eccentricity - 2.0 * DVec3::X).length() < MM);
}

#[test]
fn a_wild_point_is_flagged_but_kept() {
    let mut random = Random::new(18);
    let part = part(&shell(), 800.0, 250.0, 15, &mut random);
    let noise: Vec<f64> = part.points.iter().map(|_| 0.02 * random.normal()).collect();
    let mut list = touches(&part, |p, _| p);
    for (i, touch) in list.iter_mut().enumerate() {
        let normal = touch.surface.foot(touch.point).normal;
        touch.point += (noise[i] + if i == 7 { 2.0 } else { 0.0 }) * normal;
    }
    let fit = best_fit(&list, &DAffine3::IDENTITY, false).unwrap();
    assert_eq!(fit.residuals.len(), list.len());
    let wild = fit.residuals.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap().0;
    assert!(wild == 7 && outliers(&fit.residuals)[7], "{:?}", fit.residuals);
}
