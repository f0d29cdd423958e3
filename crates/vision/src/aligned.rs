//! Numbers that are loaded and stored several at a time.

use crate::simd::LANES;
use pulp::Simd;
use std::ops::{Deref, DerefMut};

pub(crate) const CACHE_LINE: usize = 64;

/// Numbers aligned to a cache line. Without alignment every other load of [`LANES`] numbers crosses a cache line.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Aligned<const N: usize>([f32; N]);

impl<const N: usize> Aligned<N> {
    /// Creates the array from `value(index)`. (`std::array::from_fn` is not inlined for long arrays.)
    #[inline(always)]
    pub(crate) fn from_fn(mut value: impl FnMut(usize) -> f32) -> Self {
        let mut numbers = Self::default();
        for (j, number) in numbers.iter_mut().enumerate() {
            *number = value(j);
        }
        numbers
    }

    /// Applies `of` to each number.
    #[inline(always)]
    pub(crate) fn map(&self, of: impl Fn(f32) -> f32) -> Self {
        Self::from_fn(|j| of(self[j]))
    }

    /// Dot product with another array. Each of [`LANES`] lanes is summed first, then the lanes, so the result is the
    /// same in any arithmetic. (Compilers turn loops over one lane after the other into shuffles.)
    #[inline(always)]
    pub(crate) fn dot<S: Simd>(&self, simd: S, other: &Self) -> f32 {
        const { assert!(N.is_multiple_of(LANES) && LANES.is_multiple_of(S::F32_LANES), "whole lanes") };
        let mut sums = [simd.splat_f32s(0.0); LANES];
        let products = S::as_simd_f32s(&self.0).0.iter().zip(S::as_simd_f32s(&other.0).0);
        for (k, (a, b)) in products.enumerate() {
            let sum = &mut sums[k % const { LANES / S::F32_LANES }];
            *sum = simd.add_f32s(*sum, simd.mul_f32s(*a, *b));
        }
        let mut eight = [0.0; LANES];
        for (eight, sum) in S::as_mut_simd_f32s(&mut eight).0.iter_mut().zip(sums) {
            *eight = sum;
        }
        let four: [f32; 4] = std::array::from_fn(|k| eight[k] + eight[k + 4]);
        (four[0] + four[2]) + (four[1] + four[3])
    }
}

impl<const N: usize> Default for Aligned<N> {
    #[inline(always)]
    fn default() -> Self {
        Self([0.0; N])
    }
}

impl<const N: usize> Deref for Aligned<N> {
    type Target = [f32; N];
    #[inline(always)]
    fn deref(&self) -> &[f32; N] {
        &self.0
    }
}

impl<const N: usize> DerefMut for Aligned<N> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [f32; N] {
        &mut self.0
    }
}

impl<'a, const N: usize> IntoIterator for &'a Aligned<N> {
    type Item = &'a f32;
    type IntoIter = std::slice::Iter<'a, f32>;
    #[inline(always)]
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

impl<'a, const N: usize> IntoIterator for &'a mut Aligned<N> {
    type Item = &'a mut f32;
    type IntoIter = std::slice::IterMut<'a, f32>;
    #[inline(always)]
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter_mut()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{Work, wide};
    use pulp::Scalar;
    use seamwright_testkit::Random;

    struct Dot<'a> {
        a: &'a Aligned<32>,
        b: &'a Aligned<32>,
        dot: &'a mut f32,
    }

    impl Work for Dot<'_> {
        #[inline(always)]
        fn run(self, simd: impl Simd) {
            *self.dot = self.a.dot(simd, self.b);
        }
    }

    #[test]
    fn a_sum_of_products_is_the_same_in_any_arithmetic() {
        let mut random = Random::new(7);
        for _ in 0..3000 {
            let [a, b] = [(); 2].map(|()| Aligned::<32>::from_fn(|_| random.within(-0.5, 0.5) as f32));
            let mut widest = 0.0;
            wide(Dot { a: &a, b: &b, dot: &mut widest });
            assert_eq!(widest.to_bits(), a.dot(Scalar::new(), &b).to_bits());
            let exact: f64 = a.iter().zip(&b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum();
            assert!((f64::from(widest) - exact).abs() < 1e-5, "{widest} {exact}");
        }
    }

    #[test]
    fn they_begin_where_a_line_of_the_cache_does() {
        for numbers in &vec![Aligned::<48>::default(); 5] {
            assert!(numbers.as_ptr().addr().is_multiple_of(CACHE_LINE));
        }
    }
}
