use crate::permutation::Permutation;
use crate::random::{bits_at, unit_at};
use crate::sobol::sobol_point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How values are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sampling {
    /// Independent draws.
    Random,
    /// Each quantity has one draw in each of as many equally probable strata as there are draws: means need fewer draws.
    #[default]
    LatinHypercube,
    /// The Sobol sequence with a random digital shift: evenly spread in all quantities together. Best with a power of two
    /// as the number of draws.
    Sobol,
}

/// Purposes of random numbers: each quantity has its own under each of these.
const POINT: u64 = 1 << 32;
const STRATUM: u64 = 2 << 32;
const SHIFT: u64 = 3 << 32;

/// The draws of a study as numbers in (0, 1).
#[derive(Debug, Clone, Copy)]
pub struct Sampler {
    sampling: Sampling,
    seed: u64,
    draws: u64,
}

impl Sampler {
    /// Creates the plan of `draws` draws.
    pub fn new(sampling: Sampling, seed: u64, draws: u64) -> Self {
        Self { sampling, seed, draws: draws.max(1) }
    }

    /// The number in (0, 1) of draw `i`, counted from 0, for quantity `dimension`. It depends on nothing but the plan and
    /// these two.
    ///
    /// # Panics
    /// With a Sobol sequence, if `dimension` is [`DIMENSIONS`](crate::DIMENSIONS) or more.
    pub fn unit(&self, i: u64, dimension: usize) -> f64 {
        let purpose = |kind: u64| kind + dimension as u64;
        match self.sampling {
            Sampling::Random => unit_at(self.seed, purpose(POINT), i),
            Sampling::LatinHypercube => {
                let stratum = Permutation::new(self.draws, self.seed, purpose(STRATUM)).at(i % self.draws);
                (stratum as f64 + unit_at(self.seed, purpose(POINT), i)) / self.draws as f64
            }
            Sampling::Sobol => {
                let shift = bits_at(self.seed, purpose(SHIFT), 0) as u32;
                let bits = sobol_point(i as u32, dimension) ^ shift;
                (f64::from(bits) + 0.5) / 2f64.powi(32)
            }
        }
        .clamp(f64::EPSILON, 1.0 - f64::EPSILON)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::moments::Moments;

    const ALL: [Sampling; 3] = [Sampling::Random, Sampling::LatinHypercube, Sampling::Sobol];

    #[test]
    fn a_latin_hypercube_has_one_point_in_each_stratum() {
        let sampler = Sampler::new(Sampling::LatinHypercube, 3, 250);
        for dimension in 0..8 {
            let mut strata: Vec<u64> = (0..250).map(|i| (sampler.unit(i, dimension) * 250.0) as u64).collect();
            strata.sort_unstable();
            assert_eq!(strata, (0..250).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_draw_depends_on_seed_and_number_only() {
        for sampling in ALL {
            let [one, same, other] = [7, 7, 8].map(|seed| Sampler::new(sampling, seed, 100));
            let of = |sampler: &Sampler| (0..100).rev().map(|i| sampler.unit(i, 2)).collect::<Vec<_>>();
            assert_eq!(of(&one), of(&same));
            assert_ne!(of(&one), of(&other), "{sampling:?}");
        }
    }

    #[test]
    fn dimensions_are_uncorrelated_and_uniform() {
        let n = 4096;
        for sampling in ALL {
            let sampler = Sampler::new(sampling, 11, n);
            for (a, b) in [(0, 1), (1, 2), (0, 7), (30, 31)] {
                let product: Moments =
                    (0..n).map(|i| (sampler.unit(i, a) - 0.5) * (sampler.unit(i, b) - 0.5)).collect();
                assert!(product.mean().abs() < 3.5 * (1.0 / 12.0) / (n as f64).sqrt(), "{sampling:?} {a} {b}");
                let values: Moments = (0..n).map(|i| sampler.unit(i, a)).collect();
                assert!((values.mean() - 0.5).abs() < 3.5 * (1.0f64 / 12.0).sqrt() / (n as f64).sqrt());
                assert!((values.variance() - 1.0 / 12.0).abs() < 0.004, "{sampling:?} {}", values.variance());
            }
        }
    }
}
