//! Helpers shared by the tests of all crates. A development dependency, never part of the program.

#[cfg(feature = "allocations")]
mod allocations;
mod random;

#[cfg(feature = "allocations")]
pub use allocations::no_alloc;
pub use random::Random;

use std::ops::Mul;

/// Returns the number of cases of a random test: the usual number times SEAMWRIGHT_SOAK, which `make soak` sets.
///
/// # Panics
/// If SEAMWRIGHT_SOAK is not a number.
pub fn cases<N: Mul<Output = N> + From<u16>>(usual: N) -> N {
    usual * N::from(soak().unwrap_or(1))
}

/// Returns SEAMWRIGHT_SOAK, if it is set.
///
/// # Panics
/// If it is not a number.
pub fn soak() -> Option<u16> {
    let times = std::env::var("SEAMWRIGHT_SOAK").ok()?;
    Some(times.parse().unwrap_or_else(|_| panic!("SEAMWRIGHT_SOAK={times}: not a number up to 65535")))
}
