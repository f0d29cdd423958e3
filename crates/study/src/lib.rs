//! Studies of tolerances: what is uncertain, which values are drawn, and what the results say.
//!
//! Everything here is pure: no files, no clock, no threads. The value of draw `i` depends on the study file and `i` only,
//! so that draws can be computed in any order and by any number of threads.
//!
//! | task | start at |
//! |---|---|
//! | read a study file | [`StudyFile::read`] |
//! | quantiles of a distribution | [`Distribution::resolved`], [`Resolved::quantile`] |
//! | sampling plans: random, Latin hypercube, Sobol sequence | [`Sampler`] |
//! | mean, standard deviation, quantiles | [`Moments`], [`quantile`] |
//! | confidence interval of a probability | [`wilson`] |
//! | first-order Sobol indices from given data | [`first_order`] |
//!
//! # Examples
//!
//! The mean of a drawn quantity:
//!
//! ```
//! use seamwright_study::{Moments, Sampler, Sampling};
//!
//! let sampler = Sampler::new(Sampling::LatinHypercube, 1, 1000);
//! let moments: Moments = (0..1000).map(|i| sampler.unit(i, 0)).collect();
//! assert!((moments.mean() - 0.5).abs() < 1e-3);
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod distribution;
mod file;
mod moments;
mod normal;
mod permutation;
mod proportion;
mod quantile;
mod random;
mod sampling;
mod sensitivity;
mod sobol;

pub use distribution::{Distribution, Fault, Normal, Resolved, Triangular, Uniform};
pub use file::{MAX_DRAWS, MAX_QUANTITIES, QuantityFile, StudyFile, Target, WorkError};
pub use moments::Moments;
pub use normal::{normal_cdf, normal_quantile};
pub use proportion::{Interval, wilson};
pub use quantile::quantile;
pub use sampling::{Sampler, Sampling};
pub use sensitivity::{Index, first_order};
pub use sobol::{DIMENSIONS, sobol_point};
