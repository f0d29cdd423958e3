use glam::{DAffine3, DQuat, DVec3};
use rand_chacha::ChaCha20Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};

/// Seeded random numbers (ChaCha20): the same numbers for a seed on every machine.
#[derive(Debug, Clone)]
pub struct Random(ChaCha20Rng);

impl Random {
    /// Creates the numbers of a test.
    pub fn new(seed: u8) -> Self {
        Self(ChaCha20Rng::from_seed([seed; 32]))
    }

    /// Creates the numbers of a case, which are independent of those of other cases.
    pub fn of_case(case: u32) -> Self {
        let mut seed = [7; 32];
        seed[..4].copy_from_slice(&case.to_le_bytes());
        Self(ChaCha20Rng::from_seed(seed))
    }

    /// Returns 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// Returns a number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Returns a number in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Returns true with this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// Returns a number between `low` and `high` whose logarithm is uniform.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        self.within(low.ln(), high.ln()).exp()
    }

    /// Returns a normally distributed number of standard deviation 1 (Box-Muller).
    pub fn normal(&mut self) -> f64 {
        let (u, v) = (self.within(f64::MIN_POSITIVE, 1.0), self.within(0.0, std::f64::consts::TAU));
        (-2.0 * u.ln()).sqrt() * v.cos()
    }

    /// Returns a whole number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        self.0.next_u32() as usize % count
    }

    /// Returns true in half of the calls.
    pub fn yes(&mut self) -> bool {
        self.one_in(2)
    }

    /// Returns a number from `low` to `high`: with few digits, as people write them, or with all.
    pub fn number(&mut self, low: f64, high: f64) -> f64 {
        let value = self.within(low, high);
        match self.below(3) {
            0 => value.round().clamp(low.ceil(), high.floor()),
            1 => ((value * 100.0).round() / 100.0).clamp(low, high),
            _ => value,
        }
    }

    /// Returns true once in `count` times.
    pub fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    /// Returns one of `items`.
    pub fn one<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[self.below(items.len())]
    }

    /// Returns a vector whose coordinates are up to `size` in size.
    pub fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::new(self.within(-size, size), self.within(-size, size), self.within(-size, size))
    }

    /// Returns a direction, uniform over the sphere.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.vector(1.0);
            if (0.1..1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }

    /// Returns a rotation by up to `angle` rad about any axis and a translation by up to `shift` a coordinate.
    pub fn displacement(&mut self, angle: f64, shift: f64) -> DAffine3 {
        let turn = DQuat::from_axis_angle(self.direction(), self.within(-angle, angle));
        DAffine3::from_rotation_translation(turn, self.vector(shift))
    }
}
