//! The executive on simulated devices: welds, holds.

use crate::common::{Script, Seen, When, at, down, held, in_mode, play, short, up, weld};
use seamwright_executive::{Alarm, Ask, End, Event, Executive, Missing, Mode, Note, Start, Work};
use seamwright_machine::{Clamped, Joints, Surroundings};
use seamwright_motion::feed_override::RunPhase;
use seamwright_motion::jog;
use seamwright_simulation::devices::simulated_devices;

/// A weld without disturbance follows the plan. Gas, arc, travel and crater are timed from arc ignition on, the
/// set-points are those of the path. All of it is welded, and the cell is home again.
#[test]
fn a_weld_is_the_planned_one() {
    let planned = short();
    let mut lines = up();
    lines.extend(weld());
    lines.push((Box::new(|c| c.mode == Mode::Ready && c.t > 20.0), Ask::Override(1.0)));
    lines.extend(down());
    let (script, left) = play(&planned, Start::at_home(&planned.motion), lines);
    assert_eq!(left, None);
    assert_eq!(script.modes(), [Mode::Idle, Mode::Homing, Mode::Ready, Mode::Weld, Mode::Ready, Mode::Off]);
    let (motion, period) = (&planned.motion.passes[0], planned.machine.servo_period_s);
    let time = |is: &dyn Fn(&Seen) -> bool| script.cycles.iter().filter(|c| is(c)).count() as f64 * period;
    let sequence = &motion.sequence;
    assert!((time(&|c| c.phase == Some(RunPhase::Preflow)) - sequence.preflow_s.get()).abs() < 3.0 * period);
    let delay = time(&|c| c.phase == Some(RunPhase::TravelDelay) && c.burning);
    assert!((delay - sequence.travel_delay_s.get()).abs() < 5.0 * period, "{delay}");
    assert!((time(&|c| c.phase == Some(RunPhase::Crater)) - sequence.crater_s.get()).abs() < 3.0 * period);
    // The feed override rises from standstill in some twenty periods.
    let travel = time(&|c| c.phase == Some(RunPhase::Travel));
    assert!((travel - motion.profile.duration()).abs() < 0.03, "{travel} {}", motion.profile.duration());
    assert!(time(&|c| c.gas) > time(&|c| c.on) + sequence.postflow_s.get() + sequence.preflow_s.get() - 0.01);
    for c in script.cycles.iter().filter(|c| c.phase.is_some()) {
        let q = motion.path.at(c.place.s_mm);
        assert!(c.q.iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-9), "{c:?}");
        assert!(!c.on || (c.current - 240.0).abs() < 1e-9);
    }
    let last = script.cycles.iter().rfind(|c| c.mode == Mode::Ready).unwrap();
    assert!(last.q.iter().zip(planned.machine.home()).all(|(a, b)| (a - b).abs() < 1e-6));
    assert!(
        script.notes.iter().any(|n| matches!(n, Note::PassEnds(p) if (p.s_mm - motion.path.length()).abs() < 1e-9))
    );
}

/// A hold stops on the path with the crater filled. Resuming needs arming, and overlaps; reverse goes back without
/// process.
#[test]
fn held_welds_go_on_with_overlap() {
    let planned = short();
    let mut lines = up();
    lines.push((in_mode(Mode::Ready), Ask::StartWeld));
    lines.extend(weld());
    lines.push((at(15.0), Ask::Hold));
    lines.push((held(), Ask::Resume));
    lines.push((held(), Ask::Reverse));
    lines.push((Box::new(|c| c.mode == Mode::Hold && c.place.s_mm < 10.0), Ask::Hold));
    lines.push((held(), Ask::Arm));
    lines.push((held(), Ask::Resume));
    lines.push((Box::new(|c| c.mode == Mode::Ready && c.t > 20.0), Ask::Override(1.0)));
    lines.extend(down());
    let (script, left) = play(&planned, Start::at_home(&planned.motion), lines);
    assert_eq!(left, None);
    assert_eq!(script.refused(), [Missing::Arming, Missing::Arming]);
    let overlap = planned.motion.passes[0].sequence.overlap_mm.get();
    let stopped = script.cycles.iter().find(|c| c.mode == Mode::Hold && c.phase == Some(RunPhase::Held)).unwrap();
    assert!(stopped.welded > 15.0 && stopped.welded < 17.0);
    // Going back stops where the hold is requested.
    let back =
        script.cycles.iter().filter(|c| c.mode == Mode::Hold).map(|c| c.place.s_mm).fold(f64::INFINITY, f64::min);
    assert!(back > 8.0 && back < 10.0, "{back}");
    let again = script.cycles.iter().filter(|c| c.t > stopped.t).find(|c| c.on).unwrap();
    assert!((again.place.s_mm - (stopped.welded - overlap)).abs() < 1e-6, "{again:?} {stopped:?}");
    // The beam or arc is on at rest in a hold only while the crater is filled.
    for c in script.cycles.iter().filter(|c| c.mode == Mode::Hold && c.on) {
        assert!(matches!(c.phase, Some(RunPhase::Travel | RunPhase::Crater)), "{c:?}");
    }
}

/// A stop leaves the program at its position. It resumes from there, with overlap, by a planned approach.
#[test]
fn a_stopped_weld_is_gone_on_with() {
    let planned = short();
    let mut lines = up();
    lines.extend(weld());
    lines.push((at(20.0), Ask::Stop));
    // Refused until it has come to rest and the gas is off.
    lines.extend((0..9000).map(|k| -> (When<'_>, Ask) { (Box::new(|_| true), [Ask::SwitchOff, Ask::Quit][k % 2]) }));
    let (script, left) = play(&planned, Start::at_home(&planned.motion), lines);
    let left = left.unwrap();
    assert!(left.pass == 1 && left.s_mm > 20.0 && left.s_mm < 21.0, "{left:?}");
    let stop = script.cycles.iter().position(|c| c.mode == Mode::Ready && c.place.s_mm > 20.0).unwrap();
    assert!(script.cycles[stop + 1..].iter().all(|c| !c.on));
    // On another day: from home to there.
    let around = Surroundings::new(&planned.machine, &Clamped::default()).unwrap();
    let start = Start::at_place(&planned.machine, &around, &planned.motion, &planned.machine.home(), left).unwrap();
    let mut lines = up();
    lines.extend(weld());
    lines.push((Box::new(|c| c.mode == Mode::Ready && c.t > 10.0), Ask::Override(1.0)));
    lines.extend(down());
    let (script, left_again) = play(&planned, start, lines);
    assert_eq!(left_again, None);
    let first = script.cycles.iter().find(|c| c.on).unwrap();
    assert!((first.place.s_mm - (left.s_mm - 6.0)).abs() < 1e-6, "{first:?}");
}

/// The override slows a weld; a jog ends by itself without requests; invalid requests are refused.
#[test]
fn hands_on_the_keys() {
    let planned = short();
    let mut speeds = Joints::default();
    speeds[1] = 10.0;
    let mut lines = up();
    lines.push((in_mode(Mode::Ready), Ask::Override(1.5)));
    lines.push((in_mode(Mode::Ready), Ask::Jog(jog::Command::Speeds(speeds))));
    lines.push((in_mode(Mode::Ready), Ask::StartJog));
    for _ in 0..600 {
        lines.push((in_mode(Mode::Jog), Ask::Jog(jog::Command::Speeds(speeds))));
    }
    // No requests for half a second: at rest, and an alarm.
    lines.push((Box::new(|c| c.t > 3.0), Ask::StartWeld));
    lines.push((in_mode(Mode::Jog), Ask::Hold));
    lines.push((in_mode(Mode::Ready), Ask::Arm));
    lines.extend(down());
    let (script, _) = play(&planned, Start::at_home(&planned.motion), lines);
    let refused = script.refused();
    assert!(
        matches!(refused[..], [Missing::Value, Missing::Mode(_), Missing::Mode(_), Missing::NotAtStart(1)]),
        "{refused:?}"
    );
    let moved = script.cycles.last().unwrap().q[1] - planned.machine.home()[1];
    assert!(moved > 5.0 && moved < 12.0, "{moved}");
    assert!(script.notes.iter().any(|n| matches!(n, Note::Alarm(r) if r.alarm == Alarm::PanelSilent)));
}

/// The operator sends the axes to a position: they arrive there and stand. Without requests, or on a hold, they stop
/// on the way.
#[test]
fn a_hand_sends_the_axes_to_a_place() {
    let planned = short();
    let home = planned.machine.home();
    for (told, ends) in [(4000, "arrived"), (150, "silent"), (150, "held")] {
        let mut to = home;
        to[1] += 40.0;
        let mut lines = up();
        lines.push((in_mode(Mode::Ready), Ask::Jog(jog::Command::To(to))));
        lines.push((in_mode(Mode::Ready), Ask::StartTeach));
        lines.extend((0..told).map(|_| (in_mode(Mode::Teach), Ask::Jog(jog::Command::To(to)))));
        if ends == "silent" {
            lines.push((Box::new(|c| c.t > 4.0), Ask::StartJog));
        }
        lines.push((in_mode(Mode::Teach), Ask::Hold));
        // Power can be switched off only at rest.
        lines.push((Box::new(|c| c.mode == Mode::Ready && c.t > 6.0), Ask::Override(1.0)));
        lines.extend(down());
        let (script, _) = play(&planned, Start::at_home(&planned.motion), lines);
        let moved = script.cycles.last().unwrap().q[1] - home[1];
        let silent = script.notes.iter().any(|n| matches!(n, Note::Alarm(r) if r.alarm == Alarm::PanelSilent));
        assert_eq!(silent, ends == "silent", "{ends}");
        match ends {
            "arrived" => assert!((moved - 40.0).abs() < 1e-6, "{moved}"),
            _ => assert!(moved > 0.1 && moved < 39.0, "{ends}: {moved}"),
        }
        assert!(script.refused().iter().all(|m| matches!(m, Missing::Mode(_))), "{:?}", script.refused());
    }
}

/// Another program is loaded at rest with the power on and the references kept; never during a run. All conditions
/// that prevent a start are reported.
#[test]
fn a_program_is_changed_at_rest() {
    let planned = short();
    let machine = &planned.machine;
    let mut devices = simulated_devices(machine, 1).unwrap();
    let around = Surroundings::new(machine, &Clamped::default()).unwrap();
    let (nothing, weld_work) = (Work::none(machine, &around), planned.work(Start::at_home(&planned.motion)));
    let mut lines = up();
    lines.push((in_mode(Mode::Ready), Ask::Why(Event::Weld)));
    lines.push((in_mode(Mode::Ready), Ask::Load));
    lines.extend(weld());
    lines.push((at(10.0), Ask::Load));
    lines.push((at(12.0), Ask::Stop));
    lines.push((Box::new(|c| c.mode == Mode::Ready && !c.gas), Ask::Load));
    lines.extend(down());
    let mut script = Script::new(lines);
    let mut executive = Executive::new(machine, &mut devices, &mut script);
    assert_eq!(executive.serve(Some(&nothing)), End::Load);
    let before = executive.now();
    assert_eq!(executive.serve(Some(&weld_work)), End::Load);
    assert!(executive.now() > before && executive.left().is_none());
    assert_eq!(executive.serve(Some(&weld_work)), End::Quit);
    let lacks = script.notes.iter().filter_map(|n| if let Note::Lacks(_, m) = n { Some(*m) } else { None });
    assert_eq!(lacks.collect::<Vec<_>>(), [Missing::Work, Missing::Arming]);
    assert_eq!(script.refused()[0], Missing::Moving);
    let modes = [Mode::Idle, Mode::Homing, Mode::Ready, Mode::Weld, Mode::Ready, Mode::Off];
    assert_eq!(script.modes(), modes);
}

/// Random commands at random times. The process is on only in a weld or a hold, power and motion come only on
/// request, and set-points keep every limit.
#[test]
fn no_command_does_harm() {
    let planned = short();
    let period = planned.machine.servo_period_s;
    for seed in 0..12u64 {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let mut random = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as u32
        };
        let mut t = 0.0;
        let mut lines: Vec<(When<'_>, Ask)> = Vec::new();
        for _ in 0..400 {
            t += 0.001 * f64::from(random() % 200);
            let ask = match random() % 16 {
                0 => Ask::SwitchOn,
                1 => Ask::Home,
                2 => Ask::StartJog,
                3 => Ask::StartDryRun,
                4 | 5 => Ask::StartWeld,
                6 | 7 => Ask::Arm,
                8 => Ask::Hold,
                9 | 10 => Ask::Resume,
                11 => Ask::Reverse,
                12 => Ask::Override(f64::from(random() % 11) / 10.0),
                13 => Ask::Acknowledge,
                14 if random() % 4 == 0 => Ask::Stop,
                15 if random() % 8 == 0 => Ask::SwitchOff,
                _ => Ask::Reset,
            };
            lines.push((Box::new(move |c| c.t >= t), ask));
        }
        // A stop, and the end: requested again while the axes come to rest.
        lines.push((Box::new(move |c| c.t >= t), Ask::Stop));
        lines.extend(
            (0..9000)
                .map(|k| -> (When<'_>, Ask) { (Box::new(|_| true), [Ask::Stop, Ask::SwitchOff, Ask::Quit][k % 3]) }),
        );
        let (script, _) = play(&planned, Start::at_home(&planned.motion), lines);
        for w in script.cycles.windows(3) {
            let [a, b, c] = w else { unreachable!() };
            assert!(!c.on || matches!(b.mode, Mode::Weld | Mode::Hold), "seed {seed}: {c:?}");
            // During homing, set-points do not count.
            if w.iter().any(|c| !c.powered || c.mode == Mode::Homing) || a.mode == Mode::Homing {
                continue;
            }
            for (i, axis) in planned.machine.axes.iter().enumerate() {
                let v = (c.q[i] - b.q[i]) / period;
                let dv = (c.q[i] - 2.0 * b.q[i] + a.q[i]) / (period * period);
                assert!(v.abs() < axis.max_speed * 1.001, "seed {seed}");
                assert!(dv.abs() < axis.max_acceleration * 1.01 + 1e-6, "seed {seed} axis {i}: {dv} at {c:?}");
            }
        }
        let taken = script.notes.iter().filter(|n| matches!(n, Note::Taken(_))).count();
        assert!(taken > 20, "seed {seed}: {taken}");
    }
}
