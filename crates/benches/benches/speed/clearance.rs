//! 1,000 stations of a torch along a saddle of 1.6 m: 20 fixtures and a part of 50,000 triangles. Aim: 500 ms.

use crate::measure::time;
use glam::{DAffine3, DMat3, DVec3};
use seamwright_clearance::{Group, Limits, Mesh, Motion, Scene, Shape, Solid, Watch, nearest};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::sync::Arc;

const RADIUS: f64 = 254.6;

/// The torch's tip on a saddle-like circle, the torch leaning outwards.
struct Saddle;

impl Motion for Saddle {
    fn range(&self) -> (f64, f64) {
        (0.0, TAU * RADIUS)
    }
    fn frames(&self, s: f64, frames: &mut [DAffine3]) {
        let (sin, cos) = (s / RADIUS).sin_cos();
        let z = 30.0 * (2.0 * s / RADIUS).cos();
        let up = (DVec3::new(cos, sin, 0.0) * 0.7 + DVec3::Z).normalize();
        let side = up.cross(DVec3::new(-sin, cos, 0.0)).normalize();
        frames[0] = DAffine3::from_mat3_translation(
            DMat3::from_cols(side, up.cross(side), up),
            DVec3::new(RADIUS * cos, RADIUS * sin, z) + up * 8.0,
        );
        frames[1] = DAffine3::IDENTITY;
    }
    fn greatest_speed(&self, _: usize, _: usize, _: f64, _: f64) -> f64 {
        // The tip: 1 along the circle and 60 / radius up and down; turning at 1 / radius with 450 mm of arm.
        (1f64 + (60.0 / RADIUS).powi(2)).sqrt() + 450.0 / RADIUS
    }
}

fn solid(shape: Shape, x: f64, y: f64, z: f64) -> Solid {
    Solid::new("", shape, DAffine3::from_translation(DVec3::new(x, y, z))).unwrap()
}

/// A bumpy torus under the seam: 250 by 100 quads.
fn part() -> Mesh {
    let (n, m) = (250, 100);
    let point = |i: usize, j: usize| {
        let (u, v) = (TAU * (i % n) as f64 / n as f64, TAU * (j % m) as f64 / m as f64);
        let r = 80.0 + 3.0 * (17.0 * u + 5.0 * v).sin();
        let w = RADIUS + r * v.cos();
        DVec3::new(w * u.cos(), w * u.sin(), r * v.sin() - 85.0 + 30.0 * (2.0 * u).cos())
    };
    let quads = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
    let triangles: Vec<_> = quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    Mesh::new(&triangles).unwrap()
}

fn scene() -> Scene {
    let torch = vec![
        solid(Shape::Cone { radius: 4.0, top_radius: 11.0, length: 40.0 }, 0.0, 0.0, 0.0),
        solid(Shape::Capsule { radius: 14.0, length: 180.0 }, 0.0, 0.0, 36.0),
        solid(Shape::Box { size: DVec3::new(60.0, 60.0, 200.0) }, 0.0, 0.0, 300.0),
    ];
    let mut world = vec![solid(Shape::Mesh(Arc::new(part())), 0.0, 0.0, 0.0)];
    for i in 0..20 {
        let (sin, cos) = (TAU * f64::from(i) / 20.0).sin_cos();
        let r = if i % 2 == 0 { 150.0 } else { 420.0 };
        let shape = match i % 5 {
            0 => Shape::Box { size: DVec3::new(30.0, 20.0, 60.0) },
            1 => Shape::Cylinder { radius: 12.0, length: 90.0 },
            2 => Shape::Sphere { radius: 20.0 },
            3 => Shape::Ellipsoid { semi_axes: DVec3::new(20.0, 30.0, 10.0) },
            _ => Shape::Cone { radius: 20.0, top_radius: 5.0, length: 70.0 },
        };
        world.push(solid(shape, r * cos, r * sin, 20.0));
    }
    let groups = [("torch", torch), ("world", world)];
    let groups = groups.into_iter().map(|(name, solids)| Group { name: name.to_owned(), solids }).collect();
    Scene::new(groups, vec![Watch::Apart { a: 0, b: 1, least_mm: 1.0 }]).unwrap()
}

pub(crate) fn clearance() {
    let scene = scene();
    let limits = Limits { cutoff_mm: 100.0, precision_mm: 0.1, smallest: 0.05 };
    // The torch passes close by without contact: every cell needs the full proof.
    let profile = scene.along(&Saddle, 1000, &limits).unwrap();
    let least = profile.traces[0].nearest.1.distance;
    assert!(profile.stretches.is_empty() && least < 10.0, "{least} mm, {:?}", profile.stretches.first());
    time("clearance/1,000 stations, 20 fixtures, 50,000 triangles", || {
        black_box(scene.along(&Saddle, 1000, &limits)).unwrap()
    });
    // Two such parts, 20 mm apart and crosswise: the most expensive single distance.
    let body = Shape::Mesh(Arc::new(part()));
    let turned = DAffine3::from_rotation_x(1.5) * DAffine3::from_translation(DVec3::new(720.0, 0.0, 85.0));
    let (a, b) = (solid(body.clone(), 0.0, 0.0, 0.0), Solid::new("", body, turned).unwrap());
    let apart = nearest(&a, &DAffine3::IDENTITY, &b, &DAffine3::IDENTITY, 100.0).unwrap().distance;
    assert!(apart > 5.0, "{apart} mm");
    time("clearance/mesh with mesh, 50,000 triangles each", || {
        black_box(nearest(&a, &DAffine3::IDENTITY, &b, &DAffine3::IDENTITY, 100.0)).unwrap()
    });
    time("clearance/tree over 50,000 triangles", || black_box(part()));
}
