//! A step of a jog costs no allocation.

use crate::allocations;
use glam::DVec3;
use seamwright_machine::{Clamped, Machine, Surroundings, shipped};
use seamwright_motion::jog::{Command, Jog, JogSettings, Signals, TipFrame};
use std::hint::black_box;

/// Jogging: every kind of command, new ones in every period, next to obstacles, and stops.
#[test]
fn jog_steps_do_not_allocate() {
    let machine = Machine::read("m", shipped("dual-laser-10axis").unwrap().text).unwrap();
    let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
    let home = machine.home();
    let mut jog = Jog::new(&machine, Some(&around), &home, JogSettings::default()).unwrap();
    let mut halts = 0;
    let allocated = allocations(|| {
        for i in 0..20_000u32 {
            let signals = Signals { enabled: i % 1900 != 0, alive: true, hold: i % 977 < 40 };
            let part = f64::from(i % 300) / 300.0 - 0.4;
            let command = match i / 2000 % 5 {
                0 => Command::Speeds(std::array::from_fn(|k| machine.axes.get(k).map_or(0.0, |a| part * a.max_speed))),
                1 => Command::To(std::array::from_fn(|k| home[k] + if k < 10 { 0.3 * part } else { 0.0 })),
                2 => Command::Step { axis: 1, by: 0.01 * part },
                3 => Command::Tip { frame: TipFrame::Torch, velocity: DVec3::new(5.0, part, 10.0 * part) },
                _ => Command::Rest,
            };
            if jog.command(&command).is_err() {
                halts += 1;
                jog.command(&Command::Rest).ok();
            }
            black_box(jog.step(&signals));
        }
    });
    assert_eq!(allocated, 0);
    assert!(halts > 5);
}
