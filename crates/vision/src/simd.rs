//! Loops compiled for the widest SIMD instructions of this computer.

use pulp::{Arch, Simd, WithSimd};

/// 32-bit numbers that SIMD loops process at a time.
pub(crate) const LANES: usize = 8;

/// Work whose loops gain from SIMD. Mark `run` and all it uses `#[inline(always)]`: a function that is not inlined is
/// compiled for the baseline target. (Closures may stay calls, so write `for` instead of `for_each`. The same holds for
/// `std::array::from_fn` and for `map` of long arrays.)
pub(crate) trait Work {
    /// Runs the work with the arithmetic of `simd`.
    fn run(self, simd: impl Simd);
}

/// Runs `work` with this computer's widest arithmetic. Results are the same on every computer, because multiplication
/// and addition are rounded separately.
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
    use pulp::Scalar;

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
        // A fused multiply-add, with one rounding instead of two, would change some results.
        assert!(x.iter().zip(&widest).any(|(x, y)| (0.3f32.mul_add(*x, 0.7) * x - 1.1 / x).to_bits() != y.to_bits()));
    }
}
