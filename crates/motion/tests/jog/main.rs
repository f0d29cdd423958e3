//! Jogging: within every limit and clear under every command, stops within the guaranteed distance, ends met.

#![allow(clippy::float_cmp, reason = "what rests does not move at all")]

mod point_to_point;
mod shield;
mod stopping;
mod tip;

use seamwright_machine::{Joints, Machine, shipped};
use seamwright_motion::jog::{Signals, State};

/// Splitmix64: random numbers from a seed.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n - 1)
    }

    /// Positions within the ranges, continuous axes within a turn.
    pub(crate) fn joints(&mut self, machine: &Machine) -> Joints {
        let mut q = Joints::default();
        for (q, axis) in q.iter_mut().zip(&machine.axes) {
            let (low, high) = axis.range.unwrap_or((-3.0, 3.0));
            *q = self.within(low, high);
        }
        q
    }
}

/// Cases of a test; many more with `make soak`.
pub(crate) fn cases(n: u64) -> u64 {
    n * std::env::var("SEAMWRIGHT_SOAK").ok().and_then(|s| s.parse::<u64>().ok()).unwrap_or(1)
}

pub(crate) const ON: Signals = Signals { enabled: true, alive: true, hold: false };

pub(crate) fn read(name: &str) -> Machine {
    Machine::read(name, shipped(name).unwrap().text).unwrap()
}

/// The last states of a motion, a period apart: limits by differences of positions alone.
pub(crate) struct Follower<'a> {
    machine: &'a Machine,
    period: f64,
    last: Vec<Joints>,
}

impl<'a> Follower<'a> {
    pub(crate) fn new(machine: &'a Machine, period: f64, start: &State) -> Self {
        Self { machine, period, last: vec![start.q; 3] }
    }

    /// Maximum use of a limit by this set-point, as a fraction.
    pub(crate) fn next(&mut self, state: &State) -> f64 {
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
