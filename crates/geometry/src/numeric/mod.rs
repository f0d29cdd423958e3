//! Bisection, and direct solvers for matrices with few diagonals, in time proportional to the number of unknowns. All
//! other linear algebra is nalgebra's.
//!
//! | matrix | solver |
//! |---|---|
//! | tridiagonal, as for the slopes of splines | [`tridiagonal()`] |
//! | symmetric with two diagonals beside its own, factorised many times without allocation | [`Pentadiagonal`] |
//! | symmetric and positive, each row from its own first column | [`Envelope`] |

mod envelope;
mod pentadiagonal;
mod tridiagonal;

pub use envelope::Envelope;
pub use pentadiagonal::Pentadiagonal;
pub use tridiagonal::{Row, tridiagonal};

use std::ops::{Add, Mul, Sub};

/// Unknown of a system: a number or a vector.
pub trait Value: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> {}
impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>> Value for T {}

/// Halves the interval from `good`, where `is_good` holds, to `bad`, where it does not, so many times. Returns its ends.
pub fn bisect(mut good: f64, mut bad: f64, halvings: u32, is_good: impl Fn(f64) -> bool) -> (f64, f64) {
    for _ in 0..halvings {
        let middle = 0.5 * (good + bad);
        if is_good(middle) { good = middle } else { bad = middle }
    }
    (good, bad)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};
    use proptest::prelude::*;

    fn assert_solved(matrix: DMatrix<f64>, right: &[f64], x: &[f64]) {
        let expected = matrix.lu().solve(&DVector::from_column_slice(right)).unwrap();
        let off = (DVector::from_column_slice(x) - &expected).amax();
        assert!(off < 1e-9 * expected.amax().max(1.0), "{x:?} {expected}");
    }

    proptest! {
        #[test]
        fn tridiagonal_systems_are_solved_as_by_nalgebra(
            rows in prop::collection::vec((-1.0..1.0f64, 2.5..4.0f64, -1.0..1.0f64, -9.0..9.0f64), 1..30),
        ) {
            let n = rows.len();
            let x = tridiagonal(rows.iter().map(|&(below, own, above, right)| Row::new([below, own, above], right)));
            let matrix = DMatrix::from_fn(n, n, |i, j| match (j + 1).checked_sub(i) {
                Some(0) => rows[i].0,
                Some(1) => rows[i].1,
                Some(2) => rows[i].2,
                _ => 0.0,
            });
            let right: Vec<f64> = rows.iter().map(|row| row.3).collect();
            assert_solved(matrix, &right, &x);
        }

        /// Sums of squares over neighbours, with two rows over all columns as at the end of a closed spline.
        #[test]
        fn symmetric_systems_are_solved_as_by_nalgebra(
            squares in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 4..30),
        ) {
            let n = squares.len();
            let mut envelope = Envelope::new((0..n).map(|i| if i + 2 < n { i.min(2) + 1 } else { i + 1 }));
            let mut five = Pentadiagonal::zero(n);
            let (mut cyclic, mut banded) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
            for (first, square) in squares.iter().enumerate() {
                let at = |k: usize| (first + k) % n;
                for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                    let product = square[i] * square[j] + if i == j { 0.1 } else { 0.0 };
                    cyclic[(at(i), at(j))] += product;
                    if at(j) <= at(i) {
                        *envelope.at(at(i), at(j)) += product;
                    }
                    if first + 2 < n {
                        banded[(at(i), at(j))] += product;
                    }
                }
                if first + 2 < n {
                    five.add(first, 1.0, square);
                    five.add_square(first, &[[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]);
                }
            }
            let right: Vec<f64> = squares.iter().map(|square| square[0]).collect();
            assert_solved(cyclic, &right, &envelope.clone().solve(right.clone()).unwrap());
            *envelope.at(n - 1, n - 1) -= 100.0;
            prop_assert!(envelope.solve(right.clone()).is_none());

            let mut x = right.clone();
            let mut factors = Pentadiagonal::zero(n);
            prop_assert!(factors.factor(&five, 1.0, &Pentadiagonal::zero(n), 0.0));
            factors.solve(&mut x);
            assert_solved(banded, &right, &x);
            prop_assert!(!factors.factor(&five, 1.0, &five, 1.0));
        }
    }
}
