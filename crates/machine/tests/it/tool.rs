//! Finding a tool's tip by touching one point: a machine with a bent tool, and machines of any arrangement.

use crate::common::{random_chain, random_joints};
use glam::{DAffine3, DVec3};
use seamwright_geometry::fit::pivot;
use seamwright_machine::{Joints, Machine};
use seamwright_testkit::{Random, cases};

/// The frame of the tool as the machine file has it, its origin at the tip.
fn tool(machine: &Machine, q: &Joints) -> DAffine3 {
    machine.mount_frame(0, q) * DAffine3::from_translation(machine.heads[0].tip)
}

/// The frame's origin is the tip, also of an offset tool, and its directions are those of the torch.
#[test]
fn the_frame_of_the_tool_is_at_its_tip() {
    for seed in 0..cases(200) {
        let mut random = Random::of_case(seed);
        let text = random_chain(&mut random, 2 + seed % 9);
        let tip = random.vector(30.0).to_array();
        let machine = Machine::read("m.toml", &format!("{text}tip_mm = {tip:?}\n")).unwrap();
        let plain = Machine::read("m.toml", &text).unwrap();
        for _ in 0..10 {
            let q = random_joints(&machine, &mut random);
            let frame = tool(&machine, &q);
            assert!(frame.translation.distance(machine.forward(&q).point) < 1e-9, "{seed}");
            let moved = plain.mount_frame(0, &q).transform_point3(DVec3::from_array(tip));
            assert!(moved.distance(frame.translation) < 1e-9, "{seed}");
            assert!(machine.forward(&q).direction.distance(plain.forward(&q).direction) < 1e-12, "{seed}");
        }
    }
}

/// A tool is bent by a few mm, and the true machine brings its tip to one point in random attitudes. The nominal
/// machine then finds the bend.
#[test]
fn a_bent_tool_is_found_by_touching_one_point() {
    let text = seamwright_machine::shipped("torch-5axis").unwrap().text;
    let nominal = Machine::read("m.toml", text).unwrap();
    let mut found = 0;
    for seed in 0..cases(60) {
        let mut random = Random::of_case(seed);
        let bent = random.vector(5.0);
        let with = text.replacen("[torch]", &format!("[torch]\ntip_mm = {:?}", bent.to_array()), 1);
        let machine = Machine::read("m.toml", &with).unwrap();
        let begin = machine.forward(&machine.home());
        let mut frames = Vec::new();
        for _ in 0..40 {
            let direction = (begin.direction + random.vector(0.8)).normalize();
            let target = seamwright_geometry::Pose { point: begin.point, direction };
            let Ok(touch) = machine.inverse_near(target, &machine.home()) else { continue };
            assert!(machine.forward(&touch.joints).point.distance(begin.point) < 1e-6);
            frames.push(tool(&nominal, &touch.joints));
        }
        let fit = pivot(&frames).unwrap();
        if !fit.unseen.is_empty() {
            continue;
        }
        found += 1;
        assert!(fit.tip.distance(bent) < 1e-6 && fit.point.distance(begin.point) < 1e-6, "{seed}: {fit:?} {bent}");
    }
    assert!(found > 50, "{found}");
}
