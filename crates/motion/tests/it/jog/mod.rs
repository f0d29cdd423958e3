//! Jogging: within every limit and clear under every command, stops within the guaranteed distance, ends met.

#![allow(clippy::float_cmp, reason = "what rests does not move at all")]

mod point_to_point;
mod shield;
mod stopping;
mod tip;

use seamwright_machine::{Joints, Machine};
use seamwright_motion::jog::{Signals, State};
use seamwright_testkit::Random;

/// Positions within the ranges, continuous axes within a turn.
fn joints(random: &mut Random, machine: &Machine) -> Joints {
    let mut q = Joints::default();
    for (q, axis) in q.iter_mut().zip(&machine.axes) {
        let (low, high) = axis.range.unwrap_or((-3.0, 3.0));
        *q = random.within(low, high);
    }
    q
}

const ON: Signals = Signals { enabled: true, alive: true, hold: false };

/// The last states of a motion, a period apart: limits by differences of positions alone.
struct Follower<'a> {
    machine: &'a Machine,
    period: f64,
    last: Vec<Joints>,
}

impl<'a> Follower<'a> {
    fn new(machine: &'a Machine, period: f64, start: &State) -> Self {
        Self { machine, period, last: vec![start.q; 3] }
    }

    /// Maximum use of a limit by this set-point, as a fraction.
    fn next(&mut self, state: &State) -> f64 {
        let h = self.period;
        self.last.push(state.q);
        let [a, b, c, d] = self.last[..] else { unreachable!() };
        let mut most = 0.0f64;
        for (i, axis) in self.machine.axes.iter().enumerate() {
            let rounding = 4e-15 * (1.0 + d[i].abs()) + 2e-9 * axis.jerk() * h.powi(3);
            let shares = [
                ((d[i] - c[i]).abs() - rounding) / h / axis.max_speed,
                ((d[i] - 2.0 * c[i] + b[i]).abs() - 2.0 * rounding) / h.powi(2) / axis.max_acceleration,
                ((d[i] - 3.0 * c[i] + 3.0 * b[i] - a[i]).abs() - 4.0 * rounding) / h.powi(3) / axis.jerk(),
            ];
            most = shares.into_iter().fold(most, f64::max);
            assert!(axis.outside(state.q[i]).is_none(), "{} at {}", axis.name, state.q[i]);
        }
        self.last.remove(0);
        most
    }
}
