use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// Seeded numbers for pictures: the one source of chance of all simulated eyes. The same seed paints the same picture.
#[derive(Debug, Clone)]
pub struct Random(Pcg64Mcg);

impl Random {
    /// Numbers that depend on `seed` alone.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        random.next_u64();
        Self(random)
    }

    /// A number in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// True in this part of all cases.
    pub fn chance(&mut self, part: f64) -> bool {
        self.within(0.0, 1.0) < part
    }

    /// A whole number from `low` to below `high`; `low` if there is none between.
    pub fn whole(&mut self, low: usize, high: usize) -> usize {
        low + (self.0.next_u64() % high.saturating_sub(low).max(1) as u64) as usize
    }

    /// A number near to normally distributed, of standard deviation 1: the sum of four even ones.
    pub fn normal(&mut self) -> f64 {
        let bits = self.0.next_u64();
        let sum: u64 = (0..4).map(|k| (bits >> (16 * k)) & 0xffff).sum();
        (sum as f64 / 65535.0 - 2.0) * 3f64.sqrt()
    }
}
