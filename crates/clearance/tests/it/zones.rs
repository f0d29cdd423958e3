//! Margins in permitted zones against surface points.

use crate::common::{self, KINDS, pose, shape, solid};
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Group, Scene, Shape, Solid, Watch};
use seamwright_testkit::{Random, cases};

fn points(shape: &Shape, random: &mut Random) -> Vec<DVec3> {
    let round = |radius: f64, z: f64| {
        (0..400).map(move |i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 400.0).sin_cos();
            DVec3::new(radius * cos, radius * sin, z)
        })
    };
    let mut ball = |count: usize| -> Vec<DVec3> { (0..count).map(|_| random.direction()).collect() };
    match *shape {
        Shape::Box { size } => common::box_triangles(size).into_iter().flatten().collect(),
        Shape::Sphere { radius } => ball(3000).into_iter().map(|u| u * radius).collect(),
        Shape::Ellipsoid { semi_axes } => ball(3000).into_iter().map(|u| u * semi_axes).collect(),
        Shape::Cylinder { radius, length } => round(radius, 0.0).chain(round(radius, length)).collect(),
        Shape::Cone { radius, top_radius, length } => round(radius, 0.0).chain(round(top_radius, length)).collect(),
        Shape::Capsule { radius, length } => {
            let centres = [radius, length - radius];
            ball(3000).into_iter().flat_map(|u| centres.map(|z| u * radius + DVec3::Z * z)).collect()
        }
        Shape::Mesh(ref mesh) => mesh.triangles().iter().flatten().copied().collect(),
        Shape::HalfSpace => unreachable!(),
    }
}

/// Margin of a point in a zone, in the zone's frame.
fn room_of(zone: &Shape, p: DVec3) -> f64 {
    match *zone {
        Shape::Box { size } => (size / 2.0 - p.abs()).min_element(),
        Shape::Sphere { radius } => radius - p.length(),
        Shape::Cylinder { radius, length } => (radius - p.truncate().length()).min(p.z).min(length - p.z),
        Shape::HalfSpace => -p.z,
        _ => unreachable!(),
    }
}

#[test]
fn room_is_the_least_over_the_bodys_points() {
    let mut random = Random::new(21);
    let (mut inside, mut count) = (0, 0);
    for case in 0..cases(1500) {
        let body = shape([0, 1, 2, 3, 4, 5, 7][case % 7], &mut random);
        let zone = match case / 7 % 4 {
            0 => Shape::Box { size: DVec3::splat(150.0) + random.vector(60.0) },
            1 => Shape::Sphere { radius: 90.0 },
            2 => Shape::Cylinder { radius: 80.0, length: 170.0 },
            _ => shape(6 % KINDS, &mut random),
        };
        let (body_pose, zone_pose) = (pose(&mut random, 20.0), pose(&mut random, 20.0));
        let frames = [pose(&mut random, 100.0), pose(&mut random, 100.0)];
        let watch = Watch::Inside { group: 0, of: 1, zones: vec![solid(zone.clone(), zone_pose)], least_mm: 0.0 };
        let group = |solids: Vec<Solid>| Group { name: String::new(), solids };
        let scene = Scene::new(vec![group(vec![solid(body.clone(), body_pose)]), group(vec![])], vec![watch]).unwrap();
        let found = scene.evaluate(0, &frames, 1.0);
        let to_zone = (frames[1] * zone_pose).inverse() * frames[0] * body_pose;
        let other = points(&body, &mut random).into_iter().map(|p| room_of(&zone, to_zone.transform_point3(p)));
        let other = other.fold(f64::INFINITY, f64::min);
        // Points of a ball's surface, a hundredth of its size apart, are not the extreme ones.
        let more = match (&body, &zone) {
            (Shape::Ellipsoid { semi_axes }, Shape::Sphere { .. } | Shape::Cylinder { .. }) => {
                semi_axes.max_element() - semi_axes.min_element() + 0.3
            }
            (Shape::Ellipsoid { .. } | Shape::Sphere { .. } | Shape::Capsule { .. }, _) => 0.3,
            (Shape::Cylinder { .. } | Shape::Cone { .. }, _) => 0.05,
            _ => 1e-9,
        };
        assert!(found.distance <= other + 1e-9, "{body:?} in {zone:?}: {} over {other}", found.distance);
        assert!(found.distance >= other - more, "{body:?} in {zone:?}: {} for {other}", found.distance);
        // The distance of the points equals the reported one.
        let place = found.place.unwrap();
        assert!((place.on_a.distance(place.on_b) - found.distance.abs()).abs() < 1e-9);
        inside += usize::from(found.distance > 0.0);
        count += 1;
    }
    assert!(inside > count / 8 && inside < count * 7 / 8, "{inside} of {count}");
}

#[test]
fn one_zone_of_several_is_enough_but_for_the_whole_group() {
    let ball = |x: f64| solid(Shape::Sphere { radius: 1.0 }, DAffine3::from_translation(DVec3::X * x));
    let zone = |x: f64| solid(Shape::Box { size: DVec3::splat(10.0) }, DAffine3::from_translation(DVec3::X * x));
    let room = |solids: Vec<Solid>| {
        let watch = Watch::Inside { group: 0, of: 0, zones: vec![zone(0.0), zone(30.0)], least_mm: 0.0 };
        let scene = Scene::new(vec![Group { name: "torch".into(), solids }], vec![watch]).unwrap();
        scene.nearest(&[DAffine3::IDENTITY], 50.0).unwrap().1
    };
    assert!((room(vec![ball(31.0)]).distance - 3.0).abs() < 1e-9);
    assert_eq!(room(vec![ball(31.0)]).place.unwrap().solids, [0, 1]);
    assert!((room(vec![ball(0.0), ball(30.0)]).distance + 26.0).abs() < 1e-9);
}
