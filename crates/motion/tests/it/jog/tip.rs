//! The tip along straight lines.

use super::{Follower, ON};
use crate::planning::shipped_machine;
use glam::DVec3;
use seamwright_machine::Joints;
use seamwright_motion::jog::{Command, Jog, JogSettings, TipFrame};

#[test]
fn the_tip_keeps_to_its_line_and_its_direction() {
    for (name, rotary) in [("torch-5axis", "b"), ("table-tilting-xyzac", "a"), ("ebw-7axis", "v")] {
        let machine = shipped_machine(name);
        let mut start: Joints = machine.home();
        // Turned, so that the axes have to work together.
        start[machine.axis(rotary).unwrap()] += 0.3;
        let settings = JogSettings { period_s: 2e-3, ..JogSettings::default() };
        let directions = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(1.0, -2.0, 0.5)];
        for (i, direction) in directions.into_iter().enumerate() {
            let frame = if i % 2 == 0 { TipFrame::Torch } else { TipFrame::Work };
            let mut jog = Jog::new(&machine, None, &start, settings).unwrap();
            let mut follower = Follower::new(&machine, settings.period_s, jog.state());
            let first = machine.forward(&start);
            let along = frame.to_work(&first, direction).normalize();
            assert!((along.length() - 1.0).abs() < 1e-12);
            let mut fastest = 0.0f64;
            for (velocity, periods) in [(30.0, 400), (10.0, 300), (0.0, 1000)] {
                jog.command(&Command::Tip { frame, velocity: velocity * direction.normalize() }).unwrap();
                for _ in 0..periods {
                    let before = machine.forward(&jog.state().q).point;
                    assert!(follower.next(&jog.step(&ON).state) <= 1.0 + 1e-5, "{name}");
                    let pose = machine.forward(&jog.state().q);
                    let off = pose.point - first.point;
                    let stops = velocity == 0.0;
                    // During a stop every axis decelerates independently.
                    let allowed = if stops { 1.0 } else { 1e-9 };
                    assert!(off.reject_from(along).length() < allowed, "{name} {off}");
                    assert!(stops || pose.direction.distance(first.direction) < 1e-9);
                    fastest = fastest.max((pose.point - before).length() / settings.period_s);
                }
            }
            assert!(jog.halt().is_none() && jog.state().rests(), "{name}: {:?}", jog.halt());
            assert!((fastest - 30.0).abs() < 1e-6, "{name}: {fastest}");
            let far = (machine.forward(&jog.state().q).point - first.point).dot(along);
            assert!(far > 20.0, "{name}: {far}");
        }
    }
}
