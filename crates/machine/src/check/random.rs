use crate::axis::AxisKind;
use crate::chain::Joints;
use crate::machine::Machine;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use std::f64::consts::PI;

/// Seeded random positions within a machine's ranges.
#[derive(Debug, Clone)]
pub(super) struct Random(Pcg64Mcg);

impl Random {
    /// An independent stream of numbers for each seed and `stream`, so that tests do not affect each other.
    pub(super) fn new(seed: u64, stream: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(stream)))
    }

    pub(super) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(super) fn joints(&mut self, machine: &Machine) -> Joints {
        let mut q = Joints::default();
        for (value, (low, high)) in q.iter_mut().zip(ranges(machine)) {
            *value = low + (high - low) * self.unit();
        }
        q
    }
}

/// Lowest and highest position of each axis; one turn of a rotary axis without end stops.
pub(super) fn ranges(machine: &Machine) -> Vec<(f64, f64)> {
    let whole = |kind| if kind == AxisKind::Rotary { (-PI, PI) } else { (0.0, 0.0) };
    machine.axes.iter().map(|a| a.range.unwrap_or(whole(a.kind))).collect()
}
