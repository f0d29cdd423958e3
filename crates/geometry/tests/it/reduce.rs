//! Polylines to lines and arcs: the drawn shapes are recovered; every promise is checked on the printed spans, in small
//! steps along them.

use glam::{DQuat, DVec3};
use seamwright_geometry::Error;
use seamwright_geometry::reduce::{Method, Reduction, Shape, Span, Tolerances, reduce};
use seamwright_testkit::{Random, cases};
use std::f64::consts::TAU;

const BOTH: [Method; 2] = [Method::Greedy, Method::Fewest];

fn run(points: &[DVec3], tolerance: f64, method: Method) -> Reduction {
    reduce(points, &[], Tolerances { path_mm: tolerance, columns: tolerance }, method).unwrap()
}

fn count(points: &[DVec3], tolerance: f64, method: Method) -> usize {
    run(points, tolerance, method).spans.len()
}

/// Draws a span independently of the library: the point at a fraction of its length.
fn drawn(points: &[DVec3], span: &Span) -> Box<dyn Fn(f64) -> DVec3> {
    let (a, b) = (points[span.first], points[span.last]);
    match span.shape {
        Shape::Line => Box::new(move |part| a + part * (b - a)),
        Shape::Arc { centre, normal, .. } => {
            let (from, to) = (a - centre, b - centre);
            let sweep = normal.dot(from.cross(to)).atan2(from.dot(to)).rem_euclid(TAU);
            Box::new(move |part| centre + DQuat::from_axis_angle(normal, part * sweep) * from)
        }
    }
}

/// Distance of `p` from the span and the fraction of its length there: by steps, then by bisection.
fn nearest(at: &dyn Fn(f64) -> DVec3, p: DVec3, steps: u32) -> (f64, f64) {
    let away = |part: f64| at(part).distance(p);
    let part = |i: u32| f64::from(i) / f64::from(steps);
    let best = (0..=steps).min_by(|i, j| away(part(*i)).total_cmp(&away(part(*j)))).unwrap();
    let (mut low, mut high) = (part(best.saturating_sub(1)), part((best + 1).min(steps)));
    for _ in 0..90 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if away(a) < away(b) { high = b } else { low = a }
    }
    let ends = [(away(0.0), 0.0), (away(1.0), 1.0), (away(low), low)];
    ends.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
}

fn from_chord(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let part = ((p - a).dot(b - a) / (b - a).length_squared().max(1e-300)).clamp(0.0, 1.0);
    p.distance(a + part * (b - a))
}

/// Every promise of a reduction. Rounding is that of printed centres: a few units in the last place of their size.
fn promises(points: &[DVec3], tolerance: f64, spans: &[Span]) {
    let mut at = 0;
    for span in spans {
        assert_eq!(span.first, at);
        assert!(span.last > at && span.max_error <= tolerance * (1.0 + 1e-12));
        at = span.last;
        let mut rounding = 1e-9 * tolerance;
        if let Shape::Arc { centre, radius, normal } = span.shape {
            rounding += 1e-15 * (centre.abs().max_element() + radius);
            assert!((normal.length() - 1.0).abs() < 1e-12);
            for end in [span.first, span.last] {
                let out = points[end] - centre;
                assert!((out.length() - radius).abs() < rounding + 1e-15 * radius);
                assert!(out.dot(normal).abs() < rounding + 2e-15 * radius);
            }
        }
        let curve = drawn(points, span);
        let (mut greatest, mut furthest, mut before) = (0.0f64, 0.0f64, 0.0);
        let length = (0..400).map(|i| curve(f64::from(i) / 400.0).distance(curve(f64::from(i + 1) / 400.0)));
        let length: f64 = length.sum();
        for k in span.first + 1..=span.last {
            let (away, part) = if k == span.last { (0.0, 1.0) } else { nearest(&*curve, points[k], 60) };
            greatest = greatest.max(away);
            assert!(part * length >= furthest - tolerance * (1.0 + 1e-6), "turns back at {k}");
            furthest = furthest.max(part * length);
            // Not far from the polyline in between.
            for i in 1..8 {
                let p = curve(before + (part - before) * f64::from(i) / 8.0);
                assert!(from_chord(p, points[k - 1], points[k]) <= tolerance * (1.0 + 1e-6) + rounding);
            }
            before = part;
        }
        assert!((greatest - span.max_error).abs() <= 1e-6 * tolerance + rounding, "{greatest} {span:?}");
    }
    assert_eq!(at, points.len() - 1);
}

/// Lines and arcs with `steps` points each, that meet at angles, and their number. Noise up to `noise` mm.
fn known(random: &mut Random, noise: f64) -> (Vec<DVec3>, usize) {
    let pieces = 1 + random.within(0.0, 6.0) as usize;
    let mut at = random.vector(300.0);
    let mut points = vec![at];
    for _ in 0..pieces {
        let tangent = random.direction();
        let inward = tangent.cross(random.direction()).normalize();
        let steps = 12 + random.within(0.0, 20.0) as u32;
        let (length, radius) = (random.within(30.0, 200.0), random.within(20.0, 500.0));
        let sweep = (length / radius).min(5.5);
        let line = random.within(0.0, 1.0) < 0.4;
        let from = at;
        for i in 1..=steps {
            let part = f64::from(i) / f64::from(steps);
            let half = 0.5 * part * sweep;
            at = if line {
                from + part * length * tangent
            } else {
                from + 2.0 * radius * half.sin() * (half.cos() * tangent + half.sin() * inward)
            };
            points.push(at);
        }
    }
    let noisy = points.into_iter().map(|p| p + noise * random.within(0.0, 1.0) * random.direction());
    (noisy.collect(), pieces)
}

#[test]
fn known_lines_and_arcs_come_back() {
    let mut random = Random::new(1);
    for _ in 0..cases(1000) {
        // The sagitta between neighbours can be up to some mm: the tolerance must be above it for any reduction.
        let (points, pieces) = known(&mut random, 0.05);
        let widest = points.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
        let tolerance = 0.3 + widest * widest / 160.0;
        let (greedy, fewest) = BOTH.map(|m| run(&points, tolerance, m)).into();
        promises(&points, tolerance, &greedy.spans);
        promises(&points, tolerance, &fewest.spans);
        assert!(fewest.spans.len() <= greedy.spans.len().min(pieces), "{} of {pieces}", fewest.spans.len());
        assert_eq!(fewest.at_least, fewest.spans.len());
    }
}

#[test]
fn random_walks_hold_every_promise() {
    let mut random = Random::new(2);
    for _ in 0..cases(1000) {
        let (step, turn) = (random.within(0.1, 4.0), random.within(0.0, 0.6));
        let (mut at, mut way) = (DVec3::ZERO, DVec3::X);
        let mut walk = Vec::new();
        for _ in 0..40 {
            way = DQuat::from_axis_angle(random.direction(), turn * random.normal()) * way;
            at += step * way;
            walk.push(at);
        }
        let tolerance = 0.5;
        let (greedy, fewest) = BOTH.map(|m| run(&walk, tolerance, m)).into();
        promises(&walk, tolerance, &greedy.spans);
        promises(&walk, tolerance, &fewest.spans);
        assert!(fewest.spans.len() <= greedy.spans.len());
        let back: Vec<DVec3> = walk.iter().rev().copied().collect();
        assert_eq!(count(&back, tolerance, Method::Fewest), fewest.spans.len());
    }
}

#[test]
fn size_and_attitude_do_not_matter() {
    let mut random = Random::new(3);
    for _ in 0..cases(500) {
        let (points, _) = known(&mut random, 0.05);
        let tolerance = 3.0;
        let least = count(&points, tolerance, Method::Fewest);
        let scale = 10f64.powf(random.within(-3.0, 3.0));
        let place = random.displacement(TAU, 500.0);
        let moved: Vec<DVec3> = points.iter().map(|p| scale * place.transform_point3(*p)).collect();
        assert_eq!(count(&moved, scale * tolerance, Method::Fewest), least);
    }
}

#[test]
fn far_from_the_origin_with_a_fine_tolerance() {
    let mut random = Random::new(4);
    for _ in 0..cases(300) {
        let (centre, tolerance) = (random.vector(1e5), 1e-4);
        let radius = 10f64.powf(random.within(0.0, 6.0));
        let (x, y) = random.direction().any_orthonormal_pair();
        // Neighbours less than the tolerance from their arc.
        let step = (4.0 * tolerance * radius).sqrt().min(5e3 / 60.0);
        let angle = |i: u32| f64::from(i) * step / radius;
        let points: Vec<DVec3> = (0..60).map(|i| centre + radius * (angle(i).cos() * x + angle(i).sin() * y)).collect();
        for method in BOTH {
            let found = run(&points, tolerance, method);
            let turns = (angle(59) / TAU).ceil() as usize;
            assert!(found.spans.len() <= turns, "{} {radius}", found.spans.len());
            promises(&points, tolerance, &found.spans);
            if let (1, Shape::Arc { radius: r, centre: c, .. }) = (found.spans.len(), found.spans[0].shape) {
                // The accuracy that the points allow: their rounding over the sagitta.
                let told = 1e-3 + 1e-9 / (1.0 - (0.5 * angle(59)).cos()).abs().max(1e-12);
                let sagitta = radius * (1.0 - (0.5 * angle(59)).cos());
                if sagitta > 100.0 * tolerance {
                    assert!((r - radius).abs() < told * radius && c.distance(centre) < told * radius, "{r} {radius}");
                }
            }
        }
    }
}

#[test]
fn circles_take_two_arcs() {
    let angle = |i: u32| TAU * f64::from(i) / 720.0;
    let circle: Vec<DVec3> = (0..=720).map(|i| 100.0 * DVec3::new(angle(i).cos(), angle(i).sin(), 0.0)).collect();
    for method in BOTH {
        let found = run(&circle, 0.01, method);
        assert_eq!(found.spans.len(), 2);
        promises(&circle, 0.01, &found.spans);
        for span in &found.spans {
            let Shape::Arc { centre, radius, normal } = span.shape else { continue };
            assert!(centre.length() < 1e-6 && (radius - 100.0).abs() < 1e-6 && normal.z > 1.0 - 1e-9, "{span:?}");
        }
    }
}

#[test]
fn a_coarse_polygon_is_not_rounded() {
    // Its corners lie on a circle exactly; an arc through them would leave its sides by 13 mm.
    let corner = |i: u32| 100.0 * DVec3::new((TAU * f64::from(i) / 6.0).cos(), (TAU * f64::from(i) / 6.0).sin(), 0.0);
    let hexagon: Vec<DVec3> = (0..=6).map(corner).collect();
    assert_eq!(BOTH.map(|m| count(&hexagon, 1.0, m)), [6, 6]);
    assert_eq!(count(&hexagon, 14.0, Method::Fewest), 2);
}

#[test]
fn ways_that_turn_back_are_not_skipped() {
    let at = |x: &f64| DVec3::new(*x, 0.0, 0.0);
    let zigzag: Vec<DVec3> = [0.0, 20.0, 40.0, 60.0, 50.0, 40.0, 60.0, 80.0, 100.0].iter().map(at).collect();
    for method in BOTH {
        let ends: Vec<usize> = run(&zigzag, 1.0, method).spans.iter().map(|s| s.last).collect();
        assert_eq!(ends, [3, 5, 8]);
    }
    let noise: Vec<DVec3> = [0.0, 20.0, 40.0, 39.2, 60.0].iter().map(at).collect();
    assert_eq!(count(&noise, 1.0, Method::Fewest), 1);
    assert_eq!(count(&noise, 0.5, Method::Fewest), 3);
}

#[test]
fn further_columns_are_carried_along() {
    let line: Vec<DVec3> = (0..=10).map(|i| DVec3::new(10.0 * f64::from(i), 0.0, 0.0)).collect();
    let bend: Vec<f64> = (0..=10).map(|i: i32| f64::from((i - 6).max(0))).collect();
    let even: Vec<f64> = (0..=10).map(|i| 3.0 * f64::from(i)).collect();
    let ends = |axes: &[Vec<f64>], near: f64, method| {
        let found = reduce(&line, axes, Tolerances { path_mm: 0.1, columns: near }, method).unwrap();
        found.spans.iter().map(|s| s.last).collect::<Vec<usize>>()
    };
    for method in BOTH {
        assert_eq!(ends(std::slice::from_ref(&even), 0.1, method), [10]);
        assert_eq!(ends(&[even.clone(), bend.clone()], 0.01, method), [6, 10]);
        assert_eq!(ends(&[even.clone(), bend.clone()], 3.0, method), [10]);
    }
    assert_eq!(ends(std::slice::from_ref(&bend), 0.9, Method::Greedy), [7, 10]);
    // By path length: twice as far in one step is twice as much.
    let uneven: Vec<DVec3> = [0.0, 1.0, 3.0, 4.0, 8.0].iter().map(|x| DVec3::new(*x, 0.0, 0.0)).collect();
    let turned = vec![0.0, 10.0, 30.0, 40.0, 80.0];
    let tolerances = Tolerances { path_mm: 0.1, columns: 1e-6 };
    assert_eq!(reduce(&uneven, &[turned], tolerances, Method::Fewest).unwrap().spans.len(), 1);
}

#[test]
fn degenerate_paths() {
    let p = DVec3::new(1.0, 2.0, 3.0);
    for method in BOTH {
        assert_eq!(run(&[], 1.0, method), Reduction { spans: vec![], at_least: 0 });
        assert_eq!(run(&[p], 1.0, method), Reduction { spans: vec![], at_least: 0 });
        let line = |last| vec![Span { first: 0, last, shape: Shape::Line, max_error: 0.0 }];
        assert_eq!(run(&[p, DVec3::ZERO], 1.0, method).spans, line(1));
        assert_eq!(run(&[p, p], 1.0, method).spans, line(1));
        assert_eq!(run(&[p; 50], 1.0, method).spans, line(49));
        let collinear: Vec<DVec3> = (0..30).map(|i| p * f64::from(i)).collect();
        let found = run(&collinear, 1e-6, method);
        assert!(found.spans.len() == 1 && found.spans[0].shape == Shape::Line && found.spans[0].max_error < 1e-12);
        // Every point twice.
        let twice: Vec<DVec3> = (0..60).map(|i| p * f64::from(i / 2)).collect();
        assert_eq!(run(&twice, 1e-6, method).spans.len(), 1);
        // There and back to the same place.
        assert_eq!(run(&[p, DVec3::ZERO, p], 0.1, method).spans.len(), 2);
        let huge: Vec<DVec3> = (0..20).map(|i| 4e7 * DVec3::new(f64::from(i), f64::from(i * i % 3), 0.0)).collect();
        promises(&huge, 1.0, &run(&huge, 1.0, method).spans);
        assert_eq!(run(&huge, 1e9, method).spans.len(), 1);
        let bad =
            |points: &[DVec3], path_mm| reduce(points, &[], Tolerances { path_mm, columns: 1.0 }, method).unwrap_err();
        assert_eq!(bad(&[p, DVec3::NAN], 1.0), Error::Place { index: 1 });
        assert_eq!(bad(&[p, p, DVec3::INFINITY], 1.0), Error::Place { index: 2 });
        assert_eq!(bad(&[p, 1e12 * p], 1.0), Error::Place { index: 1 });
        for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(bad(&[p, p], tolerance), Error::Size { .. }));
        }
        let tolerances = Tolerances { path_mm: 1.0, columns: 1.0 };
        let column = |values: &[f64]| reduce(&[p, DVec3::ZERO], &[values.to_vec()], tolerances, method);
        assert_eq!(column(&[0.0, f64::NAN]).unwrap_err(), Error::Place { index: 1 });
        assert!(matches!(column(&[0.0]).unwrap_err(), Error::Column { .. }));
    }
}
