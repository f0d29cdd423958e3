//! Random numbers by address: each number depends on seed, purpose and index only.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng as _;

/// The finaliser of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014): a bijection in which every bit depends on all bits.
pub(crate) fn mixed(bits: u64) -> u64 {
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// Increment of SplitMix64: the golden ratio, odd.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// 64 random bits for an address.
pub(crate) fn bits_at(seed: u64, purpose: u64, index: u64) -> u64 {
    [purpose, index].into_iter().fold(mixed(seed.wrapping_add(STEP)), |bits, part| {
        mixed(bits.wrapping_add(STEP) ^ mixed(part.wrapping_add(STEP)))
    })
}

/// A number in (0, 1) from 64 random bits: the middle of one of 2^53 cells.
pub(crate) fn unit(bits: u64) -> f64 {
    ((bits >> 11) as f64 + 0.5) / (1u64 << 53) as f64
}

/// A number in (0, 1) for an address; PCG (O'Neill 2014) from a state that depends on it.
pub(crate) fn unit_at(seed: u64, purpose: u64, index: u64) -> f64 {
    let [low, high] = [0, 1].map(|half| u128::from(bits_at(seed, 2 * purpose + half, index)));
    unit(Pcg64Mcg::new(low | high << 64).next_u64())
}
