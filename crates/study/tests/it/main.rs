//! Statistics against closed forms, within three standard errors.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use seamwright_study::{Moments, Resolved, Sampler, Sampling, first_order, normal_cdf, quantile, wilson};
use std::f64::consts::PI;

const N: u64 = 4096;
const ALL: [Sampling; 3] = [Sampling::Random, Sampling::LatinHypercube, Sampling::Sobol];

fn normal(mean: f64, deviation: f64) -> Resolved {
    Resolved::Normal { mean, deviation, min: f64::NEG_INFINITY, max: f64::INFINITY }
}

/// Values of each quantity, and the results of `of`.
fn drawn(
    sampling: Sampling,
    seed: u64,
    quantities: &[Resolved],
    of: impl Fn(&[f64]) -> f64,
) -> (Vec<Vec<f64>>, Vec<f64>) {
    let sampler = Sampler::new(sampling, seed, N);
    let row = |i| quantities.iter().enumerate().map(|(d, q)| q.quantile(sampler.unit(i, d))).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> = (0..N).map(row).collect();
    let y = rows.iter().map(|row| of(row)).collect();
    ((0..quantities.len()).map(|d| rows.iter().map(|row| row[d]).collect()).collect(), y)
}

/// A stack of tolerances: y = x1 + 2 x2 + 3 x3 is normal, and an index is the part of the variance.
#[test]
fn a_sum_of_normal_numbers_has_its_moments_quantiles_and_indices() {
    let quantities = [normal(1.0, 1.0), normal(2.0, 0.5), normal(0.0, 1.0 / 3.0)];
    let variance: f64 = 3.0;
    for sampling in ALL {
        let (x, y) = drawn(sampling, 5, &quantities, |x| x[0] + 2.0 * x[1] + 3.0 * x[2]);
        let moments: Moments = y.iter().copied().collect();
        let error = (variance / N as f64).sqrt();
        assert!((moments.mean() - 5.0).abs() < 3.0 * error, "{sampling:?}");
        // Variance of the variance of normal numbers: 2 s^4 / (n - 1).
        assert!((moments.variance() - variance).abs() < 3.0 * variance * (2.0 / (N - 1) as f64).sqrt(), "{sampling:?}");
        let mut sorted = y.clone();
        sorted.sort_by(f64::total_cmp);
        // Standard error of a quantile: sqrt(p (1 - p) / n) / density.
        let (p, at) = (0.95f64, 5.0 + 1.644_853_626_951_472_7 * variance.sqrt());
        let density = (-0.5 * 1.644_853_626_951_472_7f64.powi(2)).exp() / (2.0 * PI * variance).sqrt();
        assert!((quantile(&sorted, p) - at).abs() < 3.0 * (p * (1.0 - p) / N as f64).sqrt() / density, "{sampling:?}");
        for x in &x {
            let index = first_order(sampling, x, &y).unwrap();
            assert!((index.estimate - 1.0 / 3.0).abs() < 3.0 * standard_error(index), "{sampling:?} {index:?}");
            assert!(standard_error(index) < 0.05, "{sampling:?} {index:?}");
        }
    }
}

fn standard_error(index: seamwright_study::Index) -> f64 {
    0.5 * (index.high - index.low) / 2.131_449_545_559_323
}

/// Ishigami and Homma (1990) with a = 7, b = 0.1: indices of Saltelli et al., "Global Sensitivity Analysis" (2008), 4.6.
#[test]
fn the_ishigami_function_has_its_indices() {
    let quantities = [(); 3].map(|()| Resolved::Uniform { min: -PI, max: PI });
    let (a, b) = (7.0, 0.1);
    let first = 0.5 * (1.0 + b * PI.powi(4) / 5.0f64).powi(2);
    let second = a * a / 8.0;
    let variance = first + second + b * b * PI.powi(8) * (1.0 / 18.0 - 1.0 / 50.0);
    for sampling in ALL {
        let of = |x: &[f64]| x[0].sin() + a * x[1].sin().powi(2) + b * x[2].powi(4) * x[0].sin();
        let (x, y) = drawn(sampling, 6, &quantities, of);
        let moments: Moments = y.iter().copied().collect();
        assert!((moments.mean() - 0.5 * a).abs() < 3.0 * (variance / N as f64).sqrt());
        for (x, expected) in x.iter().zip([first / variance, second / variance, 0.0]) {
            let index = first_order(sampling, x, &y).unwrap();
            assert!(
                (index.estimate - expected).abs() < 3.0 * standard_error(index),
                "{sampling:?} {expected} {index:?}"
            );
            assert!(standard_error(index) < 0.05);
        }
    }
}

/// The probability that a normal number is beyond two deviations, and the coverage of its interval.
#[test]
fn a_tail_of_the_normal_distribution_has_its_probability() {
    let p = normal_cdf(-2.0);
    let mut covered = 0;
    for seed in 0..200 {
        let (_, y) = drawn(Sampling::Random, seed, &[normal(0.0, 1.0)], |x| x[0]);
        let found = wilson(y.iter().filter(|y| **y > 2.0).count() as u64, N);
        let error = (p * (1.0 - p) / N as f64).sqrt();
        assert!((found.estimate - p).abs() < 4.5 * error);
        if seed == 1 {
            assert!((found.estimate - p).abs() < 3.0 * error);
        }
        covered += u32::from((found.low..=found.high).contains(&p));
    }
    // 95 % of 200, within three standard errors.
    assert!((181..=199).contains(&covered), "{covered}");
}

#[test]
fn an_index_needs_draws_and_a_result_that_varies() {
    let x: Vec<f64> = (0..100).map(f64::from).collect();
    let of = |x: &[f64], y: &[f64]| first_order(Sampling::Random, x, y);
    assert!(of(&x[..20], &x[..20]).is_none());
    assert!(of(&x, &vec![1.0; 100]).is_none());
    assert!(of(&x, &x).unwrap().estimate > 0.999_999);
    // Without an effect, few draws do not show one.
    let shuffled: Vec<f64> = (0..100).map(|i| f64::from(i * 37 % 100)).collect();
    assert!(of(&x[..40], &shuffled[..40]).unwrap().estimate < 0.2);
    // A sweep of three values: each has a class.
    let sweep: Vec<f64> = (0..300).map(|i| f64::from(i % 3)).collect();
    let curve: Vec<f64> = sweep.iter().map(|x| (x - 1.0).abs()).collect();
    assert!(of(&sweep, &curve).unwrap().estimate > 0.999_999);
}
