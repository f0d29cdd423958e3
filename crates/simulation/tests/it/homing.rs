//! Axes that move home once their references are found.

use crate::common::{Script, Seen, When, down, in_mode, up};
use seamwright_executive::devices::DeviceSet;
use seamwright_executive::{Alarm, Ask, Executive, Missing, Mode, Note, Work};
use seamwright_machine::{Clamped, Joints, Machine, Surroundings, shipped};
use seamwright_simulation::devices::{SimulatedDrives, SimulatedInputs, SimulatedSource};

fn machine(order: &str) -> Machine {
    let text = shipped("torch-5axis").unwrap().text.replacen("title =", &format!("{order}\ntitle ="), 1);
    Machine::read("m.toml", &text).unwrap()
}

/// Axis positions before: y, z, a, b, x beside home.
fn beside(machine: &Machine) -> Joints {
    let mut q = machine.home();
    for (q, by) in q.iter_mut().zip([60.0, -9.0, 0.1, -0.1, 7.0]) {
        *q += by;
    }
    q
}

/// Plays a homing with `more` in it, and the end.
fn play(machine: &Machine, more: Vec<(When<'static>, Ask)>) -> Script<'static> {
    let around = Surroundings::new(machine, &Clamped::default()).unwrap();
    let work = Work::none(machine, &around);
    let mut devices = DeviceSet {
        drives: SimulatedDrives::new(machine, 1).unwrap().standing_at(&beside(machine)),
        source: SimulatedSource::new(1, machine.servo_period_s),
        inputs: SimulatedInputs::all_met(machine),
    };
    let mut script = Script::new(up().into_iter().chain(more).chain(down()).collect());
    Executive::new(machine, &mut devices, &mut script).serve(Some(&work));
    script
}

/// Axes move one after another in the order of the file, within the limits; unnamed axes stay.
#[test]
fn axes_go_home_in_order() {
    let machine = machine("home_order = [\"z\", \"x\", \"a\"]");
    let script = play(&machine, Vec::new());
    assert_eq!(script.modes(), [Mode::Idle, Mode::Homing, Mode::Ready, Mode::Off]);
    let (home, from, period) = (machine.home(), beside(&machine), machine.servo_period_s);
    let ready = script.cycles.iter().position(|c| c.mode == Mode::Ready).unwrap();
    let q = script.cycles[ready].q;
    let goes = |i: usize| matches!(machine.axes[i].name.as_str(), "z" | "x" | "a");
    for i in 0..5 {
        let wanted = if goes(i) { home[i] } else { from[i] };
        assert!((q[i] - wanted).abs() < 0.01, "{i}: {} {wanted}", q[i]);
    }
    // When references are found, positions change their meaning: the simulated drives are off by 0.37 before.
    let jumps = |pair: &[Seen]| (pair[1].q[1] - pair[0].q[1]).abs() > 0.3;
    let known = script.cycles.windows(2).rposition(jumps).unwrap() + 1;
    let mut moved = Vec::new();
    for pair in script.cycles[known..=ready].windows(2) {
        let goers: Vec<usize> = (0..5).filter(|i| (pair[1].q[*i] - pair[0].q[*i]).abs() > 1e-9).collect();
        assert!(goers.len() <= 1, "{goers:?} {pair:?}");
        for i in goers {
            assert!((pair[1].q[i] - pair[0].q[i]).abs() <= machine.axes[i].max_speed * period * 1.001);
            moved.push(i);
        }
    }
    moved.dedup();
    let names: Vec<&str> = moved.iter().map(|i| machine.axes[*i].name.as_str()).collect();
    assert_eq!(names, ["z", "x", "a"]);
}

/// After a hold on the way it is ready in place; without an order nothing moves.
#[test]
fn it_stands_where_it_is_held() {
    let machine = machine("home_order = [\"y\"]");
    let (home, from) = (machine.home()[0], beside(&machine)[0]);
    let middle = 0.5 * (home + from);
    let hold: When<'static> = Box::new(move |c| c.mode == Mode::Homing && (c.q[0] - middle).abs() < 0.2);
    let script = play(&machine, vec![(hold, Ask::Hold)]);
    assert_eq!(script.modes(), [Mode::Idle, Mode::Homing, Mode::Idle, Mode::Ready, Mode::Off]);
    let ready = script.cycles.iter().find(|c| c.mode == Mode::Ready).unwrap();
    // From 100 mm/s at 500 mm/s^2 and 5000 mm/s^3: 15 mm.
    assert!((13.0..17.0).contains(&(ready.q[0] - middle).abs()), "{}", ready.q[0]);
    assert!(!script.notes.iter().any(|n| matches!(n, Note::Alarm(a) if a.alarm != Alarm::JogStopped)));

    let machine = self::machine("");
    let script = play(&machine, Vec::new());
    let ready = script.cycles.iter().find(|c| c.mode == Mode::Ready).unwrap();
    assert!(ready.q.iter().zip(beside(&machine)).all(|(q, from)| (q - from).abs() < 0.01));
}

#[test]
fn orders_that_cannot_be() {
    for (order, said) in [("home_order = [\"q\"]", "q"), ("home_order = [\"z\", \"z\"]", "each axis once")] {
        let text = shipped("torch-5axis").unwrap().text.replacen("title =", &format!("{order}\ntitle ="), 1);
        let error = Machine::read("m.toml", &text).unwrap_err().to_string();
        assert!(error.contains("home_order") && error.contains(said), "{error}");
    }
}

/// With known references one axis moves home alone, and the others stay.
#[test]
fn one_axis_goes_home_alone() {
    let machine = machine("home_order = [\"z\", \"x\"]");
    let script = play(&machine, vec![(in_mode(Mode::Ready), Ask::HomeAxis(0))]);
    assert_eq!(script.modes(), [Mode::Idle, Mode::Homing, Mode::Ready, Mode::Homing, Mode::Ready, Mode::Off]);
    let (home, from) = (machine.home(), beside(&machine));
    let first = script.cycles.iter().position(|c| c.mode == Mode::Ready).unwrap();
    let last = script.cycles.iter().rposition(|c| c.mode == Mode::Ready).unwrap();
    let alone = &script.cycles[first..=last];
    assert!((alone[0].q[0] - from[0]).abs() < 0.01 && (alone[alone.len() - 1].q[0] - home[0]).abs() < 0.01);
    for i in 1..5 {
        assert!(alone.iter().all(|c| (c.q[i] - alone[0].q[i]).abs() < 1e-9), "{i}");
    }
}

/// An axis is refused before one that precedes it in the file, and so are unknown axes.
#[test]
fn one_axis_keeps_to_the_order_of_the_file() {
    let machine = machine("home_order = [\"y\", \"x\"]");
    let (home, from) = (machine.home()[0], beside(&machine)[0]);
    let middle = 0.5 * (home + from);
    let hold: When<'static> = Box::new(move |c| c.mode == Mode::Homing && (c.q[0] - middle).abs() < 0.2);
    let asked = [4, 99, 0, 4];
    let mut more = vec![(hold, Ask::Hold)];
    more.extend(asked.map(|axis| (in_mode(Mode::Ready), Ask::HomeAxis(axis))));
    let script = play(&machine, more);
    let refused: Vec<Missing> = script
        .notes
        .iter()
        .filter_map(|note| if let Note::Refused(_, missing) = note { Some(*missing) } else { None })
        .collect();
    assert_eq!(refused, [Missing::HomesFirst(0), Missing::Value]);
    let last = script.cycles.iter().rfind(|c| c.mode == Mode::Ready).unwrap();
    assert!([0, 4].iter().all(|i| (last.q[*i] - machine.home()[*i]).abs() < 0.01));
}
