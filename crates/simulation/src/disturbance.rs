use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use std::f64::consts::TAU;

/// Amplitudes of the cogging force, which repeats over each pole pitch, and of the noise, relative to the peak force.
const COGGING: f64 = 0.01;
const NOISE: f64 = 0.005;

/// Disturbing forces of one simulated drive: cogging that repeats with position, and noise. Seeded.
#[derive(Debug, Clone)]
pub(crate) struct Disturbance {
    random: Pcg64Mcg,
    peak: f64,
    pitch: f64,
    phase: f64,
}

impl Disturbance {
    /// Creates the forces of a drive of `peak` force (N or N m); cogging repeats every `pitch` (mm or rad).
    pub(crate) fn new(seed: u64, axis: usize, peak: f64, pitch: f64) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(seed.wrapping_mul(64).wrapping_add(axis as u64));
        let phase = TAU * uniform(&mut random);
        Self { random, peak, pitch, phase }
    }

    /// Returns the force at `position` in the next period.
    pub(crate) fn next(&mut self, position: f64) -> f64 {
        let cogging = COGGING * (TAU * position / self.pitch + self.phase).sin();
        self.peak * (cogging + NOISE * (2.0 * uniform(&mut self.random) - 1.0))
    }
}

/// Returns a uniform random number in [0, 1).
pub(crate) fn uniform(random: &mut Pcg64Mcg) -> f64 {
    (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}
