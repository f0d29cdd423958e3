use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// Seeded numbers for pictures: the only random source of all camera simulators. The same seed paints the same
/// picture.
#[derive(Debug, Clone)]
pub struct Random(Pcg64Mcg);

impl Random {
    /// Creates numbers that depend on `seed` alone.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        random.next_u64();
        Self(random)
    }

    /// Returns a number in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// Returns true with this probability.
    pub fn chance(&mut self, part: f64) -> bool {
        self.within(0.0, 1.0) < part
    }

    /// Returns a whole number from `low` to below `high`; `low` for an empty range.
    pub fn whole(&mut self, low: usize, high: usize) -> usize {
        low + (self.0.next_u64() % high.saturating_sub(low).max(1) as u64) as usize
    }

    /// Returns a nearly normally distributed number of standard deviation 1: the sum of four uniform ones.
    pub fn normal(&mut self) -> f64 {
        let bits = self.0.next_u64();
        let sum: u64 = (0..4).map(|k| (bits >> (16 * k)) & 0xffff).sum();
        (sum as f64 / 65535.0 - 2.0) * 3f64.sqrt()
    }
}
