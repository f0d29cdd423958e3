//! Seeded random numbers.

#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

use glam::{DQuat, DVec3};
use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// Seeded uniform numbers from proptest's own generator.
pub struct Uniform(TestRng);

impl Uniform {
    pub fn new(seed: u32) -> Self {
        let mut bytes = [7; 32];
        bytes[..4].copy_from_slice(&seed.to_le_bytes());
        Self(TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
    }

    pub fn in_range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A direction, evenly over the sphere.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(self.in_range(-1.0, 1.0), self.in_range(-1.0, 1.0), self.in_range(-1.0, 1.0));
            if (0.01..1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }

    pub fn turn(&mut self) -> DQuat {
        DQuat::from_axis_angle(self.direction(), self.in_range(-7.0, 7.0))
    }
}

/// Cases of a random test, times SEAMWRIGHT_SOAK.
pub fn cases(usual: usize) -> usize {
    usual * std::env::var("SEAMWRIGHT_SOAK").ok().and_then(|v| v.parse().ok()).unwrap_or(1)
}
