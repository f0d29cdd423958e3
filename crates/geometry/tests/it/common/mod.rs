//! Seeded random numbers and placements.

#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

use glam::{DAffine3, DQuat, DVec3};
use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// Seeded numbers from proptest's own generator.
pub struct Random(TestRng);

impl Random {
    pub fn new(seed: u8) -> Self {
        Self(TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]))
    }

    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Normal distribution with standard deviation 1 (Box-Muller).
    pub fn normal(&mut self) -> f64 {
        let (u, v) = (self.within(f64::MIN_POSITIVE, 1.0), self.within(0.0, std::f64::consts::TAU));
        (-2.0 * u.ln()).sqrt() * v.cos()
    }

    pub fn in_box(&mut self, half: f64) -> DVec3 {
        DVec3::new(self.within(-half, half), self.within(-half, half), self.within(-half, half))
    }

    pub fn direction(&mut self) -> DVec3 {
        DVec3::new(self.normal(), self.normal(), self.normal()).normalize()
    }

    /// A displacement by up to `angle` rad about any axis and `shift` mm a coordinate.
    pub fn displacement(&mut self, angle: f64, shift: f64) -> DAffine3 {
        let turn = DQuat::from_axis_angle(self.direction(), self.within(-angle, angle));
        DAffine3::from_rotation_translation(turn, self.in_box(shift))
    }
}

/// Distance of two rigid motions: mm of the origin, rad.
pub fn apart(a: &DAffine3, b: &DAffine3) -> (f64, f64) {
    let between = a.matrix3.transpose() * b.matrix3;
    let sine = DVec3::new(
        between.y_axis.z - between.z_axis.y,
        between.z_axis.x - between.x_axis.z,
        between.x_axis.y - between.y_axis.x,
    );
    let trace = between.x_axis.x + between.y_axis.y + between.z_axis.z;
    ((a.translation - b.translation).length(), sine.length().atan2(trace - 1.0))
}

/// So many cases, or more in a soak test.
pub fn cases(usual: u32) -> u32 {
    usual * std::env::var("SEAMWRIGHT_SOAK").ok().and_then(|v| v.parse().ok()).unwrap_or(1)
}
