//! Stops against the library's own solution of the same problem, and against the guarantee.

use super::joints;
use crate::planning::shipped_machine;
use rsruckig::prelude::*;
use seamwright_machine::{AxisLimits, Joints};
use seamwright_motion::jog::{Command, Halt, Jog, JogError, JogSettings, Signals};
use seamwright_testkit::{Random, cases};

/// Guaranteed stopping distance, mm or rad: an upper bound of the fastest stop's distance from any state within the
/// limits with this speed (of either sign).
///
/// Closed form. The worst acceleration is the maximum from which the maximum speed is not exceeded: it is reduced to 0
/// at full jerk, and the resulting speed is then braked. An axis that is slow for its acceleration may travel farther
/// backwards; that is then the worst case.
fn stopping_distance(limits: &AxisLimits, speed: f64) -> f64 {
    let AxisLimits { speed: top, acceleration: most, jerk: j } = *limits;
    // Distance of the fastest stop from speed `v` and acceleration `a`, both forwards.
    let accelerating = |v: f64, a: f64| {
        let rise = a / j;
        let risen = v * rise + a * rise * rise / 3.0;
        let v = v + 0.5 * a * rise;
        let full = most / j;
        risen + if v >= most * full { 0.5 * v * (v / most + full) } else { v * (v / j).sqrt() }
    };
    let v = speed.abs().min(top);
    let onwards = accelerating(v, most.min((2.0 * j * (top - v)).sqrt()));
    // Against the motion: the remaining acceleration at the reversal of the axis.
    let back = (0.5 * most * most / j - v).clamp(0.0, top);
    onwards.max(accelerating(0.0, (2.0 * j * back).sqrt()))
}

/// Maximum distance from the start on the fastest stop, by the library, sampled.
fn farthest(limits: &AxisLimits, v: f64, a: f64) -> f64 {
    let mut ruckig = Ruckig::<1, ThrowErrorHandler>::new(None, 1e-3);
    let mut input = InputParameter::new(None);
    let mut found = Trajectory::new(None);
    input.control_interface = ControlInterface::Velocity;
    (input.current_velocity[0], input.current_acceleration[0]) = (v, a);
    (input.max_acceleration[0], input.max_jerk[0]) = (limits.acceleration, limits.jerk);
    ruckig.calculate(&input, &mut found).unwrap();
    let (duration, mut farthest, mut at) = (found.get_duration(), 0.0f64, DataArrayOrVec::new(None, 0.0));
    for i in 0..=200 {
        let t = duration * f64::from(i) / 200.0;
        found.at_time(t, &mut Some(&mut at), &mut None, &mut None, &mut None, &mut None);
        farthest = farthest.max(at[0].abs());
    }
    farthest
}

#[test]
fn no_stop_takes_longer_than_promised_and_some_take_as_long() {
    let mut random = Random::new(11);
    let mut tightest = 0.0f64;
    for _ in 0..cases(20_000) {
        let limits = AxisLimits {
            speed: 10f64.powf(random.within(-2.0, 3.0)),
            acceleration: 10f64.powf(random.within(-1.0, 3.5)),
            jerk: 10f64.powf(random.within(0.0, 5.0)),
        };
        // Any state that can be within the limits before and after: corners more often than not.
        let corner = |r: &mut Random, most: f64| if r.unit() < 0.3 { most } else { r.within(-most, most) };
        let v = corner(&mut random, limits.speed);
        let room = |v: f64| (2.0 * limits.jerk * (limits.speed - v)).max(0.0).sqrt().min(limits.acceleration);
        let a = if random.unit() < 0.3 { room(v) } else { random.within(-room(-v), room(v)) };
        let promised = stopping_distance(&limits, v);
        let truly = farthest(&limits, v, a);
        assert!(truly <= promised * (1.0 + 1e-9) + 1e-12, "{limits:?} {v} {a}: {truly} > {promised}");
        tightest = tightest.max(truly / promised);
    }
    assert!(tightest > 1.0 - 1e-9, "{tightest}");
}

/// Released switch or silent panel at thousands of states of a jog: the axes and the tip come to rest within the
/// guaranteed distance, and stay at rest until the acknowledgement.
#[test]
fn a_lost_signal_stops_within_the_promised_distance() {
    for name in ["torch-5axis", "ebw-7axis"] {
        let machine = shipped_machine(name);
        let mut random = Random::new(5);
        for case in 0..cases(150) {
            let settings = JogSettings { period_s: 4e-3, ..JogSettings::default() };
            let start = joints(&mut random, &machine);
            let mut jog = Jog::new(&machine, None, &start, settings).unwrap();
            let on = Signals { enabled: true, alive: true, hold: false };
            for _ in 0..1 + random.below(4) {
                let speeds = std::array::from_fn(|i| {
                    machine.axes.get(i).map_or(0.0, |a| random.within(-1.0, 1.0) * a.max_speed)
                });
                jog.command(&Command::Speeds(speeds)).unwrap();
                (0..random.below(120)).for_each(|_| _ = jog.step(&on));
            }
            let mut lost = jog.step(&on);
            let silent = case % 2 == 0;
            let signals = Signals { enabled: silent, alive: false, hold: false };
            // A silent panel is waited for.
            while silent && lost.halt.is_none() {
                let before = *jog.state();
                let next = jog.step(&signals);
                if next.halt.is_some() {
                    assert_eq!(next.halt, Some(Halt::Silent));
                    lost.state = before;
                }
                lost.halt = next.halt;
            }
            let from = lost.state;
            let promised: Vec<f64> =
                (0..machine.axes.len()).map(|i| stopping_distance(&machine.axes[i].limits(), from.speed[i])).collect();
            let mut by = Joints::default();
            by[..promised.len()].copy_from_slice(&promised);
            let tip = machine.tip_travel(&from.q, &by);
            let first = machine.forward(&from.q).point;
            let mut steps = 0;
            loop {
                let point = jog.step(&signals);
                for (i, promised) in promised.iter().enumerate() {
                    assert!((point.state.q[i] - from.q[i]).abs() <= promised * (1.0 + 1e-9) + 1e-12);
                }
                assert!(machine.forward(&point.state.q).point.distance(first) <= tip * (1.0 + 1e-9) + 1e-9);
                steps += 1;
                assert!(point.halt.is_some() && steps < 4000);
                if point.state.rests() {
                    break;
                }
            }
            let rest = jog.state().q;
            assert_eq!(jog.command(&Command::To(start)), Err(JogError::Halted));
            assert_eq!(jog.step(&on).state.q, rest);
            jog.command(&Command::Rest).unwrap();
            assert!(jog.halt().is_none() && jog.step(&on).state.q == rest);
            jog.command(&Command::To(start)).unwrap();
        }
    }
}
