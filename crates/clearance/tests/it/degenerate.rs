//! Distances of bodies that are degenerate, tiny, huge, touching, concentric or closer than rounding: always a number,
//! at most the distance of their centres, and never a panic.

use glam::{DAffine3, DQuat, DVec3};
use seamwright_clearance::{Mesh, Shape, Solid, nearest};
use seamwright_testkit::{Random, cases};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

fn hard(random: &mut Random) -> f64 {
    let all = [0.0, -0.0, 5e-324, 1e-308, 1e-200, 1e-160, 1e-100, 1e-30, 1e-16, 1e-9, 1e-3, 1.0, 10.0, 800.0, 1e6, 9e6];
    let value = all[random.below(all.len())];
    match random.below(6) {
        0 => -value,
        1 => value * random.within(0.5, 1.5),
        2 => value + 1e-13 * random.within(-1.0, 1.0),
        _ => value,
    }
}

fn size(random: &mut Random) -> f64 {
    loop {
        let size = hard(random).abs();
        if size > 0.0 && size <= 1e7 {
            return size;
        }
    }
}

fn shape(random: &mut Random) -> Shape {
    match random.below(8) {
        0 => Shape::Box { size: DVec3::from_array([0; 3].map(|_| size(random))) },
        1 => Shape::Sphere { radius: size(random) },
        2 => Shape::Cylinder { radius: size(random), length: size(random) },
        3 => Shape::Cone { radius: size(random), top_radius: hard(random).abs().min(1e7), length: size(random) },
        4 => {
            let radius = size(random) / 4.0;
            Shape::Capsule { radius, length: (2.0 * radius + size(random)).min(1e7) }
        }
        5 => Shape::Ellipsoid { semi_axes: DVec3::from_array([0; 3].map(|_| size(random))) },
        6 => Shape::HalfSpace,
        _ => tetrahedron(random),
    }
}

fn tetrahedron(random: &mut Random) -> Shape {
    let p = [0; 4].map(|_| DVec3::from_array([0; 3].map(|_| hard(random).clamp(-1e6, 1e6))));
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|f| f.map(|i| p[i]));
    Mesh::new(&faces).map_or(Shape::Sphere { radius: 1.0 }, |mesh| Shape::Mesh(Arc::new(mesh)))
}

fn pose(random: &mut Random) -> DAffine3 {
    let turn = match random.below(5) {
        0 | 1 => DQuat::IDENTITY,
        2 => DQuat::from_axis_angle(DVec3::X, FRAC_PI_2 * random.below(4) as f64),
        3 => DQuat::from_axis_angle(DVec3::Y, hard(random).min(10.0)).normalize(),
        _ => DQuat::from_axis_angle(random.direction(), random.within(0.0, 6.0)),
    };
    let at = DVec3::from_array([0; 3].map(|_| hard(random).clamp(-1e6, 1e6)));
    DAffine3::from_rotation_translation(turn, at)
}

#[test]
fn any_two_bodies_have_a_distance() {
    let mut random = Random::new(41);
    let mut apart = 0;
    for case in 0..cases(100_000) {
        let solids = [0; 2].map(|_| Solid::new("body", shape(&mut random), pose(&mut random)));
        let [Ok(a), Ok(b)] = solids else { continue };
        let frames = [pose(&mut random), if case % 2 == 0 { DAffine3::IDENTITY } else { pose(&mut random) }];
        let limit = if case % 3 == 0 { size(&mut random) } else { f64::MAX };
        let Some(near) = nearest(&a, &frames[0], &b, &frames[1], limit) else { continue };
        let text = || format!("case {case}: {near:?}\n{a:?} in {}\n{b:?} in {}", frames[0], frames[1]);
        assert!(near.distance >= 0.0 && near.distance < limit, "{}", text());
        assert!(near.on_a.is_finite() && near.on_b.is_finite(), "{}", text());
        // Centres of all but meshes and half-spaces are inside; a sphere around each bounds the distance.
        let [(p, r), (q, s)] = [(&a, frames[0]), (&b, frames[1])].map(|(solid, frame)| {
            let (centre, reach) = solid.sphere();
            (frame.transform_point3(centre), reach)
        });
        let most = p.distance(q) + r + s;
        assert!(near.distance <= most * (1.0 + 1e-9), "{} {most}", text());
        apart += usize::from(near.distance > 0.0);
    }
    assert!(apart > cases(10_000), "only {apart} were apart");
}

#[test]
fn a_displacement_of_less_than_any_rounding_changes_nothing() {
    let cylinder = |move_mm: DVec3| {
        let turn = DQuat::from_axis_angle(DVec3::Y, FRAC_PI_2);
        Solid::new(
            "shell",
            Shape::Cylinder { radius: 800.0, length: 1000.0 },
            DAffine3::from_rotation_translation(turn, move_mm),
        )
    };
    let tool = Solid::new("torch", Shape::Cylinder { radius: 10.0, length: 100.0 }, DAffine3::IDENTITY).unwrap();
    let distance = |move_mm| {
        let shell = cylinder(move_mm).unwrap();
        nearest(&tool, &DAffine3::IDENTITY, &shell, &DAffine3::IDENTITY, f64::MAX).unwrap().distance
    };
    let usual = distance(DVec3::new(0.0, 0.0, -900.0));
    assert!((usual - 100.0).abs() < 1e-6, "{usual}");
    for tiny in [5e-324, 1e-308, -1e-308, 1e-300, 1e-160] {
        let found = distance(DVec3::new(0.0, tiny, -900.0));
        assert!((found - usual).abs() < 1e-9, "{tiny}: {found}");
    }
}
