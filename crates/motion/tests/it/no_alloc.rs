//! A period of set-points, pulses, the feed override and jogging does not allocate.

use super::override_profile::Case;
use crate::planning::{plan, read, shipped_machine};
use glam::DVec3;
use seamwright_machine::{Clamped, MAX_AXES, Surroundings};
use seamwright_motion::feed_override::{self, FeedOverride};
use seamwright_motion::fine::{CoarseSpline, Segment};
use seamwright_motion::jog::{Command, Jog, JogSettings, Signals, TipFrame};
use seamwright_motion::pulses::{Lines, Timing};
use seamwright_testkit::{Random, no_alloc};
use std::hint::black_box;

#[test]
fn set_points_do_not_allocate() {
    let welding = read(include_str!("../../../../examples/saddle.toml"));
    let machine = shipped_machine("saddle-4axis");
    let motion = plan(&machine, &welding).unwrap();
    no_alloc(|| {
        for p in motion.set_points(1e-3) {
            black_box((p.rates(&motion), machine.forward(&p.q), machine.outside(&p.q)));
            black_box(machine.inverse_near(machine.forward(&p.q), &p.q)).ok();
        }
    });
}

#[test]
fn pulses_and_fine_set_points_do_not_allocate() {
    let timing = Timing { period: 10_000, width: 25, spacing: 50, setup: 50, hold: 50 };
    let mut lines = Lines::new(&[(timing, 0.0), (timing, 7.5)]).unwrap();
    let mut spline = CoarseSpline::new(0.01);
    let mut before = None;
    let mut events = 0u32;
    no_alloc(|| {
        for k in 0..1000 {
            let position = 2000.0 * (0.05 * f64::from(k)).sin();
            lines.advance([position, 0.3 * position]).unwrap_or_default();
            while let Some(event) = lines.event() {
                black_box(event);
                events += 1;
            }
            if let Some(knot) = spline.push(&[position; MAX_AXES])
                && let Some(before) = before.replace(knot)
            {
                black_box(Segment::new(&before, &knot, 0.01).at(0.3));
            }
        }
    });
    assert!(events > 100_000);
}

#[test]
fn periods_do_not_allocate() {
    let random = &mut Random::of_case(3);
    let case = Case::random(random);
    let mut runner =
        FeedOverride::new(&case.limits(), 1e-3, &case.base).unwrap().with_faster(&case.faster, 1.5).unwrap();
    let commands = [
        feed_override::Command::Resume,
        feed_override::Command::Override(1.4),
        feed_override::Command::Hold,
        feed_override::Command::StopAt(0.5 * case.base.length),
    ];
    no_alloc(|| {
        for command in commands.into_iter().cycle().take(40) {
            runner.command(command).ok();
            for _ in 0..25 {
                black_box(runner.step());
            }
        }
    });
}

/// Jogging: every kind of command, new ones in every period, next to obstacles, and stops.
#[test]
fn jog_steps_do_not_allocate() {
    let machine = shipped_machine("dual-laser-10axis");
    let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
    let home = machine.home();
    let mut jog = Jog::new(&machine, Some(&around), &home, JogSettings::default()).unwrap();
    let mut halts = 0;
    no_alloc(|| {
        for i in 0..20_000u32 {
            let signals = Signals { enabled: i % 1900 != 0, alive: true, hold: i % 977 < 40 };
            let part = f64::from(i % 300) / 300.0 - 0.4;
            let command = match i / 2000 % 6 {
                0 => Command::Speeds(std::array::from_fn(|k| machine.axes.get(k).map_or(0.0, |a| part * a.max_speed))),
                1 => Command::To(std::array::from_fn(|k| home[k] + if k < 10 { 0.3 * part } else { 0.0 })),
                2 => Command::Step { axis: 1, by: 0.01 * part },
                3 => Command::Tip { frame: TipFrame::Torch, velocity: DVec3::new(5.0, part, 10.0 * part) },
                4 => Command::Turn { frame: TipFrame::Work, velocity: DVec3::new(part, 0.2, 0.0) },
                _ => Command::Rest,
            };
            if jog.command(&command).is_err() {
                halts += 1;
                jog.command(&Command::Rest).ok();
            }
            black_box(jog.step(&signals));
        }
    });
    assert!(halts > 5);
}
