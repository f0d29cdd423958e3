//! Under every command limits hold, ends are met, and clearances are kept.

use super::{Follower, ON, joints};
use crate::planning::shipped_machine;
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Shape, Solid};
use seamwright_machine::{Clamped, Joints, Machine, Surroundings};
use seamwright_motion::jog::{Command, Halt, Jog, JogError, JogSettings, Signals, TipFrame};
use seamwright_testkit::{Random, cases};
use std::collections::BTreeMap;

/// A block to run into, its middle at a point of the work frame.
fn block(at: DVec3) -> Clamped {
    let shape = Shape::Box { size: DVec3::new(120.0, 80.0, 60.0) };
    let part = vec![Solid::new("block", shape, DAffine3::from_translation(at)).unwrap()];
    Clamped { part, least_mm: 3.0, ..Clamped::default() }
}

/// Position of the tip with all axes in the middle of their ranges.
fn middle(machine: &Machine) -> DVec3 {
    let mut q = Joints::default();
    for (q, axis) in q.iter_mut().zip(&machine.axes) {
        *q = axis.range.map_or(0.0, |(low, high)| 0.5 * (low + high));
    }
    machine.forward(&q).point
}

fn any_command(random: &mut Random, machine: &Machine, around: &Surroundings) -> Command {
    match random.below(8) {
        0 => Command::Rest,
        1 => Command::To(joints(random, machine)),
        2 => Command::Step { axis: random.below(machine.axes.len()), by: random.within(-1.0, 1.0) },
        3 => {
            let frame = if random.unit() < 0.5 { TipFrame::Work } else { TipFrame::Torch };
            let velocity = DVec3::from_array(std::array::from_fn(|_| random.within(-60.0, 60.0)));
            if random.unit() < 0.3 {
                return Command::Turn { frame, velocity: 0.01 * velocity };
            }
            Command::Tip { frame, velocity }
        }
        4 | 5 => {
            // Into the obstacle, if the machine can reach it.
            let mut there = std::iter::repeat_with(|| joints(random, machine)).take(200);
            there.find(|q| !around.is_clear(q)).map_or(Command::Rest, Command::To)
        }
        _ => {
            let mut speeds = Joints::default();
            for (i, axis) in machine.axes.iter().enumerate() {
                let share = if random.unit() < 0.5 { 0.0 } else { random.within(-1.5, 1.5) };
                speeds[i] = share * axis.max_speed;
            }
            Command::Speeds(speeds)
        }
    }
}

#[test]
fn nothing_comes_nearer_than_allowed_and_every_limit_holds() {
    let names = ["saddle-4axis", "torch-5axis", "table-tilting-xyzac", "ellipse-xy", "ebw-7axis", "dual-laser-10axis"];
    let mut watched = 0;
    for (k, name) in names.into_iter().enumerate() {
        let machine = shipped_machine(name);
        // A coarse period also reveals violations between set-points.
        let settings = JogSettings { period_s: 4e-3, ..JogSettings::default() };
        for (clamped, seed) in [(Clamped::default(), 1), (block(middle(&machine)), 2)] {
            let around = Surroundings::new(&machine, &clamped).unwrap();
            let mut random = Random::of_case(seed + 100 * k as u32);
            let (mut halts, mut moved, mut nearest) = (BTreeMap::new(), 0.0f64, f64::INFINITY);
            let mut most = 0.0f64;
            for _ in 0..cases(8) {
                let start =
                    std::iter::repeat_with(|| joints(&mut random, &machine)).find(|q| around.is_clear(q)).unwrap();
                let mut jog = Jog::new(&machine, Some(&around), &start, settings).unwrap();
                let mut follower = Follower::new(&machine, settings.period_s, jog.state());
                let mut last = start;
                for _ in 0..25 {
                    let command = any_command(&mut random, &machine, &around);
                    match jog.command(&command) {
                        Err(JogError::Halted) => jog.command(&Command::Rest).unwrap(),
                        other => _ = other,
                    }
                    if random.unit() < 0.2 {
                        jog.set_override(random.within(0.05, 1.0)).unwrap();
                    }
                    let (lost, hold) = (random.unit() < 0.1, random.unit() < 0.1);
                    // Far enough to get there.
                    let periods = if matches!(command, Command::To(q) if !around.is_clear(&q)) { 1500 } else { 250 };
                    for i in 0..random.below(periods) {
                        let signals = Signals { enabled: !(lost && i > 20), hold: hold && i < 60, ..ON };
                        let point = jog.step(&signals);
                        most = most.max(follower.next(&point.state));
                        let q = point.state.q;
                        moved += (0..machine.axes.len()).map(|i| (q[i] - last[i]).abs()).sum::<f64>();
                        for part in [0.5, 1.0] {
                            let between = std::array::from_fn(|i| last[i] + part * (q[i] - last[i]));
                            if let Some((watch, found)) = around.nearest(&between, 50.0) {
                                let room = found.distance - around.scene().watches()[watch].least_mm();
                                assert!(room >= 0.0, "{name}: {:?} {room}", around.bodies(watch));
                                nearest = nearest.min(room);
                            }
                        }
                        last = q;
                    }
                    if let Some(halt) = jog.halt() {
                        // Only the tip's line runs into ends and out of reach.
                        let tip = matches!(command, Command::Tip { .. } | Command::Turn { .. });
                        assert!(
                            tip || !matches!(halt, Halt::Limit(_) | Halt::NoMotion),
                            "{name}: {halt:?} {command:?}"
                        );
                        let kind = format!("{halt:?}");
                        *halts.entry(kind.split('(').next().unwrap().to_owned()).or_insert(0) += 1;
                    }
                }
            }
            assert!(moved > 100.0 && most <= 1.0 + 1e-5, "{name}: {most}");
            watched += u32::from(nearest < 0.5);
        }
    }
    assert!(watched >= 8, "only {watched} of 12 came near anything");
}

#[test]
fn axes_slow_down_in_time_and_stop_at_their_ends() {
    for name in ["torch-5axis", "dual-laser-10axis"] {
        let machine = shipped_machine(name);
        let mut random = Random::new(8);
        for _ in 0..cases(5) {
            let start = joints(&mut random, &machine);
            let settings = JogSettings { period_s: 4e-3, ..JogSettings::default() };
            let mut jog = Jog::new(&machine, None, &start, settings).unwrap();
            let mut follower = Follower::new(&machine, settings.period_s, jog.state());
            let way: Joints = std::array::from_fn(|_| if random.unit() < 0.5 { 1.0 } else { -1.0 });
            let speeds =
                |share: f64| std::array::from_fn(|i| machine.axes.get(i).map_or(0.0, |a| share * way[i] * a.max_speed));
            // Reversed once in between.
            jog.command(&Command::Speeds(speeds(-0.7))).unwrap();
            for i in 0..40_000 {
                if i == 100 {
                    jog.command(&Command::Speeds(speeds(1.0))).unwrap();
                }
                assert!(follower.next(&jog.step(&ON).state) <= 1.0 + 1e-5);
            }
            assert!(jog.halt().is_none());
            for (i, axis) in machine.axes.iter().enumerate() {
                match axis.range {
                    Some((low, high)) => {
                        let end = if way[i] > 0.0 { high } else { low };
                        assert!((jog.state().q[i] - end).abs() < 3e-7, "{}", axis.name);
                    }
                    None => assert!((jog.state().speed[i] - way[i] * axis.max_speed).abs() < 1e-9),
                }
            }
            // And back from there.
            jog.command(&Command::Speeds(speeds(-0.1))).unwrap();
            (0..200).for_each(|_| assert!(follower.next(&jog.step(&ON).state) <= 1.0 + 1e-5));
            assert!(jog.halt().is_none() && (0..machine.axes.len()).all(|i| jog.state().speed[i] * way[i] < 0.0));
        }
    }
}

/// Down onto a block: the jog halts before it, names the watch, and moves up again after the acknowledgement.
#[test]
fn halts_before_what_is_in_the_way_and_goes_back() {
    let machine = shipped_machine("torch-5axis");
    let clamped = block(DVec3::new(0.0, 0.0, 30.0));
    let around = Surroundings::new(&machine, &clamped).unwrap();
    let z = machine.axis("z").unwrap();
    let mut start = machine.home();
    start[z] = 150.0;
    let mut jog = Jog::new(&machine, Some(&around), &start, JogSettings::default()).unwrap();
    let mut speeds = Joints::default();
    speeds[z] = -machine.axes[z].max_speed;
    jog.command(&Command::Speeds(speeds)).unwrap();
    (0..8000).for_each(|_| _ = jog.step(&ON));
    let Some(Halt::TooNear(watch)) = jog.halt() else { panic!("{:?} {:?}", jog.halt(), jog.state().q) };
    assert!(format!("{:?}", around.bodies(watch)).contains("part"));
    assert!(jog.state().rests());
    let room = around.nearest(&jog.state().q, 100.0).unwrap().1.distance - 3.0;
    // Less than a period's travel at full speed.
    assert!((0.0..0.2).contains(&room), "{room}");
    jog.command(&Command::Rest).unwrap();
    speeds[z] = 20.0;
    jog.command(&Command::Speeds(speeds)).unwrap();
    (0..1000).for_each(|_| _ = jog.step(&ON));
    assert!(jog.halt().is_none() && jog.state().q[z] > 60.0);
    // A start that is too near is refused.
    let mut low = start;
    low[z] = 40.0;
    let refused = Jog::new(&machine, Some(&around), &low, JogSettings::default()).map(|_| ());
    assert!(matches!(refused, Err(JogError::NotClear { distance_mm: 0.0, .. })), "{refused:?}");
}

#[test]
fn steps_overrides_holds_and_mistakes() {
    let machine = shipped_machine("torch-5axis");
    let mut jog = Jog::new(&machine, None, &machine.home(), JogSettings::default()).unwrap();
    let x = machine.axis("x").unwrap();
    for by in [0.01, 0.1, 1.0, 0.01, -0.1] {
        jog.command(&Command::Step { axis: x, by }).unwrap();
        (0..3).for_each(|_| _ = jog.step(&ON));
    }
    for i in 0..3000 {
        let hold = (20..400).contains(&i);
        jog.step(&Signals { hold, ..ON });
        assert!(i != 399 || jog.state().rests());
    }
    assert!((jog.state().q[x] - machine.home()[x] - 1.02).abs() < 1e-7, "{}", jog.state().q[x]);
    // Half the speed.
    let mut speeds = Joints::default();
    speeds[x] = 40.0;
    jog.set_override(0.5).unwrap();
    jog.command(&Command::Speeds(speeds)).unwrap();
    (0..2000).for_each(|_| _ = jog.step(&ON));
    assert!((jog.state().speed[x] - 20.0).abs() < 1e-9);
    for share in [0.0, -1.0, 1.1, f64::NAN] {
        assert!(matches!(jog.set_override(share), Err(JogError::Setting { .. })));
    }
    let mut far = machine.home();
    far[x] = 1e4;
    let told = jog.command(&Command::To(far)).unwrap_err().to_string();
    assert!(told.starts_with("axis x cannot go to 10000 mm: its range is "), "{told}");
    far[x] = f64::NAN;
    assert!(
        jog.command(&Command::To(far)).unwrap_err().to_string().contains("position of axis x is not a finite number")
    );
    let step = Command::Step { axis: 9, by: 0.1 };
    assert_eq!(jog.command(&step), Err(JogError::NoSuchAxis { axis: 9, axes: 5 }));
    assert!(jog.halt().is_none() && jog.state().speed[x] > 19.0);
}
