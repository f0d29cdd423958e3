//! The tip along straight lines.

use super::{Follower, ON};
use crate::planning::shipped_machine;
use glam::DVec3;
use seamwright_machine::Joints;
use seamwright_motion::jog::{Command, Halt, Jog, JogSettings, TipFrame};

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
            let along = frame.to_work(&machine, &start, direction).normalize();
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

/// The torch turns about its tip: the tip rests, the direction turns about the axis of the turn, and on an arm the
/// rotation about the torch too.
#[test]
fn the_torch_turns_about_its_tip() {
    for (name, turned, full) in
        [("torch-5axis", "b", false), ("ur10e", "j5", true), ("irb-2600", "j5", true), ("ur10e-positioner", "j5", true)]
    {
        let machine = shipped_machine(name);
        let mut start: Joints = machine.home();
        start[machine.axis(turned).unwrap()] += 0.3;
        let settings = JogSettings { period_s: 2e-3, ..JogSettings::default() };
        let axes = [DVec3::X, DVec3::Y, if full { DVec3::Z } else { DVec3::new(0.6, 0.8, 0.0) }];
        for (i, axis) in axes.into_iter().enumerate() {
            let frame = if full && i == 0 { TipFrame::Work } else { TipFrame::Torch };
            let mut jog = Jog::new(&machine, None, &start, settings).unwrap();
            let mut follower = Follower::new(&machine, settings.period_s, jog.state());
            let (first, across) = (machine.forward(&start), machine.across(&start));
            let about = frame.to_work(&machine, &start, axis).normalize();
            jog.command(&Command::Turn { frame, velocity: 0.2 * axis }).unwrap();
            for _ in 0..500 {
                assert!(follower.next(&jog.step(&ON).state) <= 1.0 + 1e-5, "{name} {axis}");
                assert_eq!(jog.halt(), None, "{name} {axis}");
                let pose = machine.forward(&jog.state().q);
                assert!(pose.point.distance(first.point) < 1e-6, "{name} {axis}: {}", pose.point - first.point);
                // A rotation about an axis keeps the component along it.
                assert!((pose.direction - first.direction).dot(about).abs() < 1e-8, "{name} {axis}");
                let roll = (machine.across(&jog.state().q) - across).dot(about);
                assert!(!full || roll.abs() < 1e-8, "{name} {axis}: {roll}");
            }
            let (now, moved) = (machine.forward(&jog.state().q), machine.across(&jog.state().q));
            let (from, to) = if axis == DVec3::Z { (across, moved) } else { (first.direction, now.direction) };
            let angle = from.reject_from(about).angle_between(to.reject_from(about));
            assert!(angle > 0.1 && angle < 0.2, "{name} {axis}: {angle}");
        }
    }
}

/// A turn about the torch of a machine without that axis, and any turn of a machine that cannot tilt, halt.
#[test]
fn a_turn_without_axes_for_it_halts() {
    for (name, axis) in [("torch-5axis", DVec3::Z), ("ellipse-xy", DVec3::X)] {
        let machine = shipped_machine(name);
        let settings = JogSettings { period_s: 2e-3, ..JogSettings::default() };
        let mut jog = Jog::new(&machine, None, &machine.home(), settings).unwrap();
        jog.command(&Command::Turn { frame: TipFrame::Torch, velocity: 0.2 * axis }).unwrap();
        for _ in 0..20 {
            jog.step(&ON);
        }
        assert_eq!((jog.halt(), jog.state().q), (Some(Halt::NoMotion), machine.home()), "{name}");
    }
}
