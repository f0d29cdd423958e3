//! A pass in time against differences of its own positions, and both sides of its borders.

use super::welds::{self, Weld};
use seamwright_motion::feed_override::{CHANNELS, PassTimed, Rates, Timed};
use seamwright_testkit::{Random, cases};

/// Rates at `t` against differences over `h` and half of it, the error of which falls with the fourth power of `h`,
/// as parts of the axes' limits: speeds, accelerations, jerks.
fn off(weld: &Weld, timed: &PassTimed, t: f64, h: f64) -> f64 {
    let near = [-h, -0.5 * h, 0.5 * h, h].map(|dt| timed.at(t + dt, false));
    let at = timed.at(t, false);
    let slope = |f: &dyn Fn(&Rates) -> f64| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| f(&near[k]));
        (8.0 * (c - b) - (d - a)) / (6.0 * h)
    };
    let mut worst = 0.0f64;
    for (i, axis) in weld.machine.axes.iter().enumerate() {
        worst = worst.max((slope(&|r| r.q[i]) - at.v[i]).abs() / axis.max_speed);
        worst = worst.max((slope(&|r| r.v[i]) - at.a[i]).abs() / axis.max_acceleration);
        worst = worst.max((slope(&|r| r.a[i]) - at.j[i]).abs() / axis.jerk());
    }
    let slopes = [slope(&|r| r.tip.s), slope(&|r| r.tip.v), slope(&|r| r.tip.a)];
    let own = [at.tip.v, at.tip.a, at.tip.j];
    slopes.iter().zip(own).fold(worst, |w, (slope, own)| w.max((slope - own).abs() / (1.0 + own.abs())))
}

#[test]
fn rates_are_the_derivatives_of_positions() {
    let random = &mut Random::of_case(1);
    for weld in welds::all() {
        let (timed, profile) = (weld.base(), weld.profile());
        let mut worst = 0.0f64;
        for _ in 0..cases(500) {
            let cell = random.below(profile.cells());
            let (from, to) = profile.cell_times(cell);
            let t = from + (to - from) * random.within(0.1, 0.9);
            worst = worst.max(off(weld, &timed, t, 0.01 * (to - from)));
        }
        assert!(worst < 1e-4, "{}: {worst:e}", weld.name);
    }
}

#[test]
fn at_borders_both_sides_are_what_is_near_them() {
    for weld in welds::all() {
        let timed = weld.base();
        let (mut t, mut borders, mut jumps) = (0.0, 0, 0);
        loop {
            let next = timed.next_border(t, true);
            if next.is_infinite() {
                break;
            }
            assert!(next > t && timed.next_border(next, false) == t, "{}: {t} {next}", weld.name);
            let eps = 1e-7 * (next - t);
            let [near, before, after] = [timed.at(next - eps, false), timed.at(next, true), timed.at(next, false)];
            for (i, axis) in weld.machine.axes.iter().enumerate() {
                // Positions, speeds and accelerations go on over the border, jerks come up to it from its own side.
                assert!((before.q[i] - after.q[i]).abs() < 1e-9, "{} axis {i} at {next}", weld.name);
                assert!((before.v[i] - after.v[i]).abs() < 1e-6 * axis.max_speed, "{} axis {i} at {next}", weld.name);
                let step = (before.a[i] - after.a[i]).abs() / axis.max_acceleration;
                assert!(step < 1.1e-3, "{} axis {i} at {next}: {step}", weld.name);
                let near = (before.j[i] - near.j[i]).abs() / axis.jerk();
                assert!(near < 1e-4, "{} axis {i} at {next}: {near}", weld.name);
                jumps += u32::from((before.j[i] - after.j[i]).abs() > 0.01 * axis.jerk());
            }
            borders += 1;
            t = next;
        }
        assert!(borders == weld.profile().cells() && jumps > 10, "{}: {borders} {jumps}", weld.name);
        assert_eq!(t, timed.duration());
        for (t, before, s) in
            [(-1.0, false, 0.0), (0.0, true, 0.0), (t, false, weld.length()), (t + 1.0, true, weld.length())]
        {
            let r = timed.at(t, before);
            assert!(r.v == [0.0; CHANNELS] && r.a == r.v && r.j == r.v && r.tip.s == s, "{}: {r:?}", weld.name);
            assert!(r.q.iter().zip(weld.position(s)).all(|(a, b)| (a - b).abs() < 1e-11), "{}: {r:?}", weld.name);
        }
    }
}

#[test]
fn times_of_places_lead_back_to_them() {
    let random = &mut Random::of_case(2);
    for weld in welds::all() {
        let timed = weld.base();
        for _ in 0..cases(500) {
            let s = random.within(0.0, weld.length());
            let there = timed.at(timed.time_of(s), false).tip.s;
            assert!((there - s).abs() < 1e-9, "{}: {s} {there}", weld.name);
        }
    }
}
