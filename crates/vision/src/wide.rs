//! Loops over as many numbers at a time as this computer can.

use pulp::{Arch, WithSimd};
pub(crate) use pulp::{Scalar, Simd};

/// Numbers of 32 bits that are done at a time, where a loop is written for it.
pub(crate) const LANES: usize = 8;

/// Work whose loops are worth it. What is to gain by it has to be inlined into `run`, and that itself (`#[inline(always)]`): what is
/// called is compiled for any computer. (Closures may be called, so `for` rather than `for_each`; so may `std::array::from_fn` and `map`
/// of long arrays.)
pub(crate) trait Work {
    /// `simd`: the arithmetic that it is compiled for.
    fn run(self, simd: impl Simd);
}

/// Does `work` with the widest arithmetic that this computer has. The numbers are the same on every computer, as a product and a
/// sum stay two roundings.
pub(crate) fn wide(work: impl Work) {
    Arch::new().dispatch(Compiled(work));
}

struct Compiled<W>(W);

impl<W: Work> WithSimd for Compiled<W> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        self.0.run(simd);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Polynomial<'a> {
        x: &'a [f32],
        y: &'a mut [f32],
    }

    impl Work for Polynomial<'_> {
        #[inline(always)]
        fn run(self, _: impl Simd) {
            for (x, y) in self.x.iter().zip(self.y) {
                *y = (0.3 * x + 0.7) * x - 1.1 / x;
            }
        }
    }

    #[test]
    fn numbers_are_the_same_in_any_arithmetic() {
        let x: Vec<f32> = (1..10_000).map(|i| 0.123 * i as f32).collect();
        let [mut widest, mut single] = [(); 2].map(|()| vec![0.0; x.len()]);
        wide(Polynomial { x: &x, y: &mut widest });
        Scalar::new().vectorize(Compiled(Polynomial { x: &x, y: &mut single }));
        assert_eq!(widest, single);
        // One rounding instead of two would tell otherwise.
        assert!(x.iter().zip(&widest).any(|(x, y)| (0.3f32.mul_add(*x, 0.7) * x - 1.1 / x).to_bits() != y.to_bits()));
    }
}
