//! Permutations that need no memory.

use crate::random::{bits_at, mixed};

/// Rounds of the network; four are the minimum of Luby and Rackoff (1988).
const ROUNDS: u64 = 6;

/// A random permutation of `0..count`, evaluated at single numbers.
///
/// Method: a Feistel network over the next even number of bits, walked until the number is below `count` (Black, Rogaway,
/// "Ciphers with arbitrary finite domains", 2002).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Permutation {
    count: u64,
    half_bits: u32,
    seed: u64,
    purpose: u64,
}

impl Permutation {
    pub(crate) fn new(count: u64, seed: u64, purpose: u64) -> Self {
        let bits = u64::BITS - count.saturating_sub(1).leading_zeros();
        Self { count, half_bits: bits.div_ceil(2).max(1), seed, purpose }
    }

    /// The image of `i`, which must be below the count.
    pub(crate) fn at(&self, i: u64) -> u64 {
        let mut at = self.round_trip(i);
        while at >= self.count {
            at = self.round_trip(at);
        }
        at
    }

    fn round_trip(&self, i: u64) -> u64 {
        let mask = (1u64 << self.half_bits) - 1;
        let (mut left, mut right) = (i >> self.half_bits, i & mask);
        for round in 0..ROUNDS {
            let key = bits_at(self.seed, self.purpose, round);
            (left, right) = (right, left ^ (mixed(key ^ right) & mask));
        }
        left << self.half_bits | right
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_hit_once() {
        for count in [1, 2, 3, 7, 16, 17, 1000] {
            let permutation = Permutation::new(count, 5, 9);
            let mut hit = vec![false; count as usize];
            for i in 0..count {
                assert!(!std::mem::replace(&mut hit[permutation.at(i) as usize], true), "{i} of {count}");
            }
        }
    }
}
