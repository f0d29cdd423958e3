//! Cost of one step of a jog of ten axes, two heads and all their shapes: with the same command, with a new one in
//! every period, and point to point with a new target in every period. A period is 1 ms.

use crate::measure::time;
use seamwright_machine::{Clamped, Joints, MAX_AXES, Machine, Surroundings, shipped};
use seamwright_motion::jog::{Command, Jog, JogSettings, PointToPoint, Signals, State};
use std::hint::black_box;

pub(crate) fn benches() {
    let machine = Machine::read("m", shipped("dual-laser-10axis").unwrap().text).unwrap();
    let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
    let home = machine.home();
    let on = Signals { enabled: true, alive: true, hold: false };
    let speeds =
        |share: f64| -> Joints { std::array::from_fn(|i| machine.axes.get(i).map_or(0.0, |a| share * a.max_speed)) };
    for (what, watched) in [("nothing watched", None), ("all shapes watched", Some(&around))] {
        let jog = || Jog::new(&machine, watched, &home, JogSettings::default()).unwrap();
        let mut there = jog();
        let mut i = 0u32;
        // To and fro, so that it keeps moving.
        time(&format!("jog step, 10 axes, {what}"), || {
            let way = if (i / 300).is_multiple_of(2) { 0.1 } else { -0.1 };
            i += 1;
            there.command(&Command::Speeds(speeds(way))).ok();
            black_box(there.step(&on))
        });
        assert!(there.halt().is_none());
        let mut there = jog();
        time(&format!("jog step with a new command, 10 axes, {what}"), || {
            let way = if (i / 300).is_multiple_of(2) { 0.1 } else { -0.1 } + 1e-6 * f64::from(i % 100);
            i += 1;
            there.command(&Command::Speeds(speeds(way))).ok();
            black_box(there.step(&on))
        });
        assert!(there.halt().is_none());
    }
    let mut plan = PointToPoint::new(&machine);
    let mut state = State::at_rest(&home);
    let mut i = 0u32;
    time("point to point, new target, 10 axes", || {
        i += 1;
        let by = if (i / 500).is_multiple_of(2) { 1.0 } else { -1.0 } + 1e-4 * f64::from(i % 100);
        let mut target = home;
        (0..machine.axes.len().min(MAX_AXES)).for_each(|k| target[k] += 0.05 * by);
        plan.plan(&state, &target, 1.0).ok();
        state = plan.at(1e-3);
        black_box(state)
    });
}
