//! Seven-axis arms in closed form: every branch against forward kinematics, arm angles, singular poses, plans of the elbow.

use crate::common::{random_joints, same, shipped_machine};
use glam::{DVec3, dvec3};
use seamwright_geometry::Pose;
use seamwright_machine::{Elbow, Joints, Machine, Shoulder, Target, Unreachable, WristSide};
use seamwright_testkit::{Random, cases};
use std::f64::consts::PI;

/// An arm whose shoulder and wrist are oblique, with an offset elbow.
const OBLIQUE: &str = "schema = 1\nname = \"oblique\"\ntitle = \"oblique\"\n
[[tool]]\naxis = \"j1\"\nturn = [0, 0.2, 1]\nat_mm = [0, 0, 300]\nLIMITS
[[tool]]\naxis = \"j2\"\nturn = [0, 1, 0.1]\nat_mm = [0, 0, 300]\nLIMITS
[[tool]]\naxis = \"j3\"\nturn = [0.3, 0, 1]\nat_mm = [0, 0, 300]\nLIMITS
[[tool]]\naxis = \"j4\"\nturn = [0.1, -1, 0]\nat_mm = [60, 15, 700]\nLIMITS
[[tool]]\naxis = \"j5\"\nturn = [0, 0, 1]\nat_mm = [0, 0, 1100]\nLIMITS
[[tool]]\naxis = \"j6\"\nturn = [0, 1, 0.2]\nat_mm = [0, 0, 1100]\nLIMITS
[[tool]]\naxis = \"j7\"\nturn = [0.2, 0, 1]\nat_mm = [0, 0, 1100]\nLIMITS
[[tool]]\nfixed = { move_mm = [80, 0, 1300], turn = [0, 1, 0], angle_deg = 35 }\n[torch]\ndirection = [0, 0, 1]\n
[[work]]\nfixed = { move_mm = [500, 20, 30], turn = [1, 2, 3], angle_deg = 40 }\n";

fn arms() -> [Machine; 2] {
    let limits = "range_deg = [-170, 170]\nmax_speed_deg_s = 90\nmax_acceleration_deg_s2 = 300";
    let oblique = Machine::read("oblique", &OBLIQUE.replace("LIMITS", limits)).unwrap();
    [shipped_machine("iiwa-14"), oblique]
}

fn framed(machine: &Machine, q: &Joints) -> Target {
    Target { across: Some(machine.across(q)), ..Target::from(machine.forward(q)) }
}

/// Errors of the tip (mm) and of the torch's frame at `q`.
fn error(machine: &Machine, q: &Joints, target: &Target) -> (f64, f64) {
    let pose = machine.forward(q);
    let turned =
        (machine.across(q) - target.across.unwrap()).length() + (pose.direction - target.first.direction).length();
    ((pose.point - target.first.point).length(), turned)
}

#[test]
fn every_branch_reaches_its_frame_with_the_third_axis_or_the_arm_angle_as_asked() {
    let mut random = Random::new(7);
    for machine in arms() {
        let mut counts = [0usize; 2];
        for _ in 0..cases(10_000) {
            let q = random_joints(&machine, &mut random);
            let margins = machine.arm_margins(&q).unwrap();
            let target = framed(&machine, &q);
            let held = machine.inverse(target, &q).unwrap();
            let angle = machine.arm_angle(&q).unwrap();
            let turned = machine.inverse(Target { arm_angle: Some(angle), ..target }, &machine.home()).unwrap();
            for (i, branches) in [&held, &turned].into_iter().enumerate() {
                counts[i] = counts[i].max(branches.len());
                for solution in branches.iter() {
                    let (off, angle) = error(&machine, &solution.joints, &target);
                    assert!(off < 1e-9 && angle < 1e-11, "{}: {off:e} {angle:e} at {q:?}", machine.name);
                }
                // The branches next to a singularity are known to fewer digits.
                if margins.min() > 0.01 {
                    let own = |s: &Joints| same(&machine, s, &q, 1e-7);
                    assert!(branches.iter().any(|s| own(&s.joints)), "{} {i}: {q:?} not in {branches:?}", machine.name);
                }
            }
            assert!(held.iter().all(|s| (s.joints[2] - q[2]).abs() < 1e-15));
            let swivel = |s: &Joints| {
                let by = machine.arm_angle(s).unwrap() - angle;
                (by - 2.0 * PI * (by / (2.0 * PI)).round()).abs()
            };
            assert!(margins.min() < 0.01 || turned.iter().all(|s| swivel(&s.joints) < 1e-6), "{q:?}");
        }
        assert_eq!(counts, [8, 8], "{}", machine.name);
    }
}

#[test]
fn branches_have_different_configurations() {
    let machine = shipped_machine("iiwa-14");
    let home = machine.home();
    let named = machine.arm_configuration(&home).unwrap();
    assert_eq!((named.shoulder, named.elbow, named.wrist), (Shoulder::Front, Elbow::Up, WristSide::NoFlip));
    let all = machine.inverse(framed(&machine, &home), &home).unwrap();
    let mut numbers: Vec<u8> = all.iter().map(|s| machine.arm_configuration(&s.joints).unwrap().branch()).collect();
    numbers.sort_unstable();
    assert_eq!(numbers, [0, 1, 2, 3, 4, 5, 6, 7]);
}

#[test]
fn the_elbow_swivels_and_the_torch_stays() {
    let machine = shipped_machine("iiwa-14");
    let home = machine.home();
    let target = framed(&machine, &home);
    assert!(machine.arm_angle(&home).unwrap().abs() < 1e-12, "the elbow is above the line");
    let mut near = home;
    for k in 0..=72 {
        let angle = f64::from(k) * PI / 36.0;
        let solution = machine.inverse_near(Target { arm_angle: Some(angle), ..target }, &near).unwrap();
        let (off, turned) = error(&machine, &solution.joints, &target);
        assert!(off < 1e-9 && turned < 1e-11);
        let step = solution.joints.iter().zip(&near).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(step < 0.6, "{k}: {step}");
        near = solution.joints;
    }
    assert!(same(&machine, &near, &home, 1e-9), "once around is home again");
}

#[test]
fn stretched_arms_and_poses_out_of_reach_end_well() {
    let machine = shipped_machine("iiwa-14");
    let mut q = Joints::default();
    for (q2, q6) in [(0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5)] {
        (q[1], q[5]) = (q2, q6);
        let target = framed(&machine, &q);
        for angle in [None, Some(0.0), Some(1.0)] {
            let branches = machine.inverse(Target { arm_angle: angle, ..target }, &q).unwrap();
            for solution in branches.iter() {
                let (off, turned) = error(&machine, &solution.joints, &target);
                assert!(off < 1e-5 && turned < 1e-6, "{off:e} {turned:e}: {solution:?}");
                assert!(solution.singular && solution.joints.iter().all(|v| v.is_finite()));
            }
        }
    }
    let far = Target::from(Pose { point: dvec3(5000.0, 0.0, 0.0), direction: DVec3::NEG_Z });
    assert!(matches!(machine.inverse(far, &machine.home()), Err(Unreachable::Point { by }) if by > 3000.0));
    assert!(shipped_machine("ur10e").arm_angle(&Joints::default()).is_none());
}

#[test]
fn other_elbows_are_tried_for_a_pose_out_of_range() {
    let machine = shipped_machine("iiwa-14");
    let home = machine.home();
    assert!(machine.has_free_roll() && machine.free().iter().eq([2]));
    let mut random = Random::new(9);
    for _ in 0..cases(100) {
        let q = random_joints(&machine, &mut random);
        let found = machine.reach(machine.forward(&q), &home);
        assert!(found.is_ok_and(|all| all.iter().all(|s| machine.outside(&s.joints).is_none())), "{q:?}");
    }
}
