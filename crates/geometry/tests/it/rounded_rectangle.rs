//! Rounded rectangles against their distance function and a brute-force length; angles against the points.

use glam::{DVec2, DVec3};
use seamwright_geometry::{ByLength, Curve, DEFAULT_ACCURACY_MM, RoundedRectangle};
use seamwright_testkit::{Random, cases};
use std::f64::consts::{FRAC_PI_2, TAU};

struct Case {
    rectangle: RoundedRectangle,
    centre: DVec3,
    /// Width's direction, height's direction, normal.
    axes: [DVec3; 3],
    half: DVec2,
    corner: f64,
}

/// Sharp corners, corners of half the smaller side, squares and anything between.
fn case(random: &mut Random, i: u32) -> Case {
    let mut size = DVec2::new(random.within(1.0, 400.0), random.within(1.0, 400.0));
    if i.is_multiple_of(7) {
        size.y = size.x;
    }
    let corner = 0.5 * size.min_element() * [0.0, 1.0, random.within(0.0, 1.0), 1e-3][i as usize % 4];
    let (centre, normal, direction) = (random.vector(500.0), random.direction(), random.direction());
    let e1 = (direction - direction.dot(normal) * normal).normalize();
    let rectangle = RoundedRectangle::new(centre, 3.0 * normal, 0.2 * direction, size, corner).unwrap();
    Case { rectangle, centre, axes: [e1, normal.cross(e1), normal], half: 0.5 * size, corner }
}

#[test]
fn points_directions_and_lengths() {
    let mut random = Random::new(31);
    for i in 0..cases(3000) {
        let Case { rectangle, centre, axes, half, corner } = case(&mut random, i);
        let length = rectangle.domain().1;
        let size = half.max_element();
        assert!((length - (4.0 * (half.x + half.y) - 8.0 * corner + TAU * corner)).abs() < 1e-12 * size);
        let by_length = ByLength::new(&rectangle, DEFAULT_ACCURACY_MM).unwrap();
        assert!((by_length.length() - length).abs() < 1e-12 * size);
        let mut last = 0.0;
        for k in 0..40 {
            let u = length * (f64::from(k) + 0.5) / 40.0;
            let jet = rectangle.jet(u);
            let d = jet.point - centre;
            assert!(d.dot(axes[2]).abs() < 1e-12 * (size + 1000.0));
            let p = DVec2::new(d.dot(axes[0]), d.dot(axes[1]));
            // Distance from the rounded rectangle, and its gradient.
            let q = p.abs() - (half - corner);
            let outside = q.max(DVec2::ZERO);
            let distance = outside.length() + q.max_element().min(0.0) - corner;
            assert!(distance.abs() < 1e-11 * (size + 100.0), "{distance} at {u}");
            // Not on a sharp corner, where there is no gradient.
            if corner > 0.0 || (q.x - q.y).abs() > 1e-9 {
                let gradient = if outside.min_element() > 0.0 {
                    outside.normalize()
                } else if q.x > q.y {
                    DVec2::X
                } else {
                    DVec2::Y
                };
                let out = gradient * p.signum();
                let along = -out.y * axes[0] + out.x * axes[1];
                assert!((jet.d1 - along).length() < 1e-7, "{} {along} at {u}", jet.d1);
            }
            assert!((jet.d1.length() - 1.0).abs() < 1e-12 && jet.d1.dot(jet.d2).abs() < 1e-12);
            let angle = rectangle.angle(u);
            assert!(angle > last && (DVec2::from_angle(angle).perp_dot(p)).abs() < 1e-10 * (size + 100.0));
            last = angle;
            assert!((rectangle.at_angle(angle) - u).abs() < 1e-9 * (size + 10.0), "{} {u}", rectangle.at_angle(angle));
            let turns = f64::from(k % 5) - 2.0;
            assert!((rectangle.angle(u + turns * length) - angle - turns * TAU).abs() < 1e-9);
            assert!((rectangle.at_angle(angle + turns * TAU) - u - turns * length).abs() < 1e-8 * (size + 10.0));
        }
    }
}

/// Between any two parameters the curve is as long as a polygon of many points on it.
#[test]
fn a_polygon_on_it_is_as_long() {
    let mut random = Random::new(32);
    for i in 0..cases(200) {
        let Case { rectangle, corner, .. } = case(&mut random, i);
        let length = rectangle.domain().1;
        let (a, b) = (random.within(0.0, length), random.within(0.0, length));
        // Corners themselves are points of the polygon.
        let mut places: Vec<f64> = (0..=2000).map(|k| a + (b - a) * f64::from(k) / 2000.0).collect();
        places.extend(rectangle.breaks().iter().filter(|u| (**u - a) * (**u - b) < 0.0));
        places.sort_by(f64::total_cmp);
        let polygon: f64 = places.windows(2).map(|w| rectangle.point(w[0]).distance(rectangle.point(w[1]))).sum();
        // A chord of an arc of length h is h^3 / (24 r^2) shorter.
        let step = (b - a).abs() / 2000.0;
        let shorter = if corner > 0.0 { step.powi(3) / (24.0 * corner * corner) * TAU * corner / step } else { 0.0 };
        let off = (b - a).abs() - polygon;
        assert!(off < 1.5 * shorter + 1e-9 && off > -1e-9 || step > corner, "{off} {shorter}");
    }
}

#[test]
fn angles_at_the_sides_middles_and_refusals() {
    let new = |size: DVec2, corner| RoundedRectangle::new(DVec3::ZERO, DVec3::Z, DVec3::X, size, corner);
    let rectangle = new(DVec2::new(60.0, 40.0), 8.0).unwrap();
    let quarter = 0.25 * rectangle.domain().1;
    for (k, point) in [DVec3::X * 30.0, DVec3::Y * 20.0, DVec3::X * -30.0, DVec3::Y * -20.0].into_iter().enumerate() {
        let u = rectangle.at_angle(FRAC_PI_2 * k as f64);
        assert!((u - quarter * k as f64).abs() < 1e-12 && (rectangle.point(u) - point).length() < 1e-12);
    }
    assert_eq!(rectangle.breaks().len(), 8);
    assert_eq!(new(DVec2::new(60.0, 40.0), 0.0).unwrap().breaks().len(), 4);
    assert_eq!(new(DVec2::new(60.0, 40.0), 20.0).unwrap().breaks().len(), 6);
    for (size, corner) in [((0.0, 1.0), 0.0), ((1.0, -1.0), 0.0), ((4.0, 2.0), 1.001), ((4.0, 2.0), -0.1)] {
        assert!(new(size.into(), corner).is_err());
    }
    assert!(new(DVec2::ONE, f64::NAN).is_err());
    assert!(RoundedRectangle::new(DVec3::ZERO, DVec3::Z, DVec3::Z, DVec2::ONE, 0.1).is_err());
}
