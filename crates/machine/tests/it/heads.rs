//! Two heads at once: both tips on both fillets of a curved T-joint (DUALBEAM-2013), and slides.

use crate::common::{random_joints, shipped_machine};
use glam::{DMat3, DQuat, DVec3};
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Target, Unreachable};
use seamwright_testkit::{Random, cases};

/// A web of thickness `t` on a skin curved both ways: the two fillets' points and beam directions at `u`. The frame
/// comes from a formula for the web's middle line, independent of the code under test.
fn fillets(u: f64, t: f64, above_skin: f64) -> [Pose; 2] {
    let line = |u: f64| DVec3::new(1500.0 * (u / 1500.0).sin(), 300.0 * (u / 900.0).sin(), 40.0 * (u / 700.0).cos());
    let h = 1e-4;
    let along = ((line(u + h) - line(u - h)) / (2.0 * h)).normalize();
    let across = DVec3::Z.cross(along).normalize();
    let up = along.cross(across);
    [1.0, -1.0].map(|side| Pose {
        point: line(u) + side * 0.5 * t * across,
        direction: -(side * above_skin.cos() * across + above_skin.sin() * up),
    })
}

#[test]
fn both_tips_lie_on_both_fillets_with_slides_centred() {
    let machine = shipped_machine("dual-laser-10axis");
    let mut near = machine.home();
    for k in -1000..=1000 {
        let poses = fillets(f64::from(k), 2.0, 30f64.to_radians());
        let target = Target::new(poses[0], Some(poses[1]));
        let solution = machine.inverse_near(target, &near).unwrap();
        near = solution.joints;
        assert!(machine.outside(&near).is_none(), "{k}");
        for (head, pose) in poses.iter().enumerate() {
            let tip = machine.forward_of(head, &near);
            assert!((tip.point - pose.point).length() <= 1e-9, "{k}: head {head}");
            assert!((tip.direction - pose.direction).length() <= 1e-9, "{k}: head {head}");
        }
        for slide in ["u1", "v1", "u2", "v2"] {
            assert!(near[machine.axis(slide).unwrap()].abs() < 1e-9);
        }
        assert!(solution.attitude_error < 1e-9);
    }
}

/// The slides reach a thicker web; two equal target poses, and a machine with one head, are refused.
#[test]
fn slides_take_another_thickness() {
    let machine = shipped_machine("dual-laser-10axis");
    let poses = fillets(120.0, 5.0, 30f64.to_radians());
    let target = Target::new(poses[0], Some(poses[1]));
    let near = machine.inverse_near(target, &machine.home()).unwrap().joints;
    for (head, pose) in poses.iter().enumerate() {
        assert!((machine.forward_of(head, &near).point - pose.point).length() < 1e-9);
    }
    let u = |name| near[machine.axis(name).unwrap()];
    assert!((u("u1") - 1.5).abs() < 1e-9 && (u("u2") + 1.5).abs() < 1e-9 && u("v1").abs() < 1e-9);
    let same = Target::new(poses[0], Some(poses[0]));
    assert!(matches!(machine.inverse(same, &near), Err(Unreachable::Pair(_))));
    let single = shipped_machine("torch-5axis");
    assert!(matches!(single.inverse(target, &single.home()), Err(Unreachable::Pair(_))));
}

/// A slide moves its own tip along its direction, turned with the carrier; the other tip stays.
#[test]
fn slide_moves_are_as_predicted() {
    let machine = shipped_machine("dual-laser-10axis");
    let mut random = Random::new(9);
    for _ in 0..cases(2000) {
        let q = random_joints(&machine, &mut random);
        let angle = |name| q[machine.axis(name).unwrap()];
        // Rz(C) Ry(B) Rx(A), as the paper has it.
        let turn = DMat3::from_quat(
            DQuat::from_rotation_z(angle("c"))
                * DQuat::from_rotation_y(angle("b"))
                * DQuat::from_rotation_x(angle("a")),
        );
        for (head, slides) in [["u1", "v1"], ["u2", "v2"]].iter().enumerate() {
            let (dy, dz) = (random.within(-5.0, 5.0), random.within(-5.0, 5.0));
            let mut moved: Joints = q;
            moved[machine.axis(slides[0]).unwrap()] += dy;
            moved[machine.axis(slides[1]).unwrap()] += dz;
            let (before, after) = (machine.forward_of(head, &q), machine.forward_of(head, &moved));
            let predicted = turn * DVec3::new(0.0, dy, dz);
            assert!((after.point - before.point - predicted).length() < 1e-9);
            let other = 1 - head;
            assert!((machine.forward_of(other, &moved).point - machine.forward_of(other, &q).point).length() < 1e-12);
        }
    }
}

#[test]
fn two_heads_come_back() {
    let machine = shipped_machine("dual-laser-10axis");
    let mut random = Random::new(21);
    let mut compared = 0;
    for _ in 0..cases(20_000) {
        let q = random_joints(&machine, &mut random);
        let poses = [0, 1].map(|head| machine.forward_of(head, &q));
        let target = Target::new(poses[0], Some(poses[1]));
        // Slides off centre turn the line between the tips against the carrier: the tips come back, by other positions.
        let Ok(branches) = machine.inverse(target, &q) else { continue };
        for b in branches.iter() {
            for (head, pose) in poses.iter().enumerate() {
                let tip = machine.forward_of(head, &b.joints);
                assert!((tip.point - pose.point).length() <= 1e-9, "{}", (tip.point - pose.point).length());
            }
        }
        compared += 1;
    }
    assert!(compared > 15_000, "{compared}");
}
