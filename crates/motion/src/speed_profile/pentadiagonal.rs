/// A symmetric matrix with two diagonals beside its own: of a problem whose terms each touch three neighbouring
/// unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Pentadiagonal {
    /// The diagonal and the two beside it: `[i]` of the second holds (i, i + 1), of the third (i, i + 2).
    pub(crate) diagonals: [Vec<f64>; 3],
}

impl Pentadiagonal {
    /// The zero matrix of `count` rows.
    pub(crate) fn zero(count: usize) -> Self {
        Self { diagonals: [vec![0.0; count], vec![0.0; count], vec![0.0; count]] }
    }

    /// Sets every element to zero.
    pub(crate) fn clear(&mut self) {
        self.diagonals.iter_mut().flatten().for_each(|x| *x = 0.0);
    }

    /// Adds `factor u u^T` at rows `first` to `first + 2`.
    pub(crate) fn add(&mut self, first: usize, factor: f64, u: &[f64; 3]) {
        self.add_square(first, &u.map(|row| u.map(|column| factor * row * column)));
    }

    /// Adds a symmetric matrix, given by its upper triangle, at rows `first` to `first + 2`.
    pub(crate) fn add_square(&mut self, first: usize, m: &[[f64; 3]; 3]) {
        (0..3).for_each(|i| self.diagonals[0][first + i] += m[i][i]);
        (0..2).for_each(|i| self.diagonals[1][first + i] += m[i][i + 1]);
        self.diagonals[2][first] += m[0][2];
    }

    /// Makes this the factors `L` (unit lower triangle) and `D` of `a - part b`, with `a`'s own diagonal times
    /// `diagonal`; false if a pivot is not positive.
    pub(crate) fn factor(&mut self, a: &Self, diagonal: f64, b: &Self, part: f64) -> bool {
        let count = a.diagonals[0].len();
        let [pivot, one, two] = &mut self.diagonals;
        let at = |k: usize, i: usize| a.diagonals[k][i] - part * b.diagonals[k][i];
        for i in 0..count {
            let (mut d, mut e) = (diagonal * a.diagonals[0][i] - part * b.diagonals[0][i], at(1, i));
            if i > 0 {
                d -= one[i - 1] * one[i - 1] * pivot[i - 1];
                e -= two[i - 1] * one[i - 1] * pivot[i - 1];
            }
            if i > 1 {
                d -= two[i - 2] * two[i - 2] * pivot[i - 2];
            }
            if d.is_nan() || d <= 0.0 {
                return false;
            }
            (pivot[i], one[i], two[i]) = (d, e / d, at(2, i) / d);
        }
        true
    }

    /// Replaces the right side `x` by the solution, where this holds the factors.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        let [pivot, one, two] = &self.diagonals;
        let count = x.len();
        for i in 0..count {
            if i > 0 {
                x[i] -= one[i - 1] * x[i - 1];
            }
            if i > 1 {
                x[i] -= two[i - 2] * x[i - 2];
            }
        }
        for i in (0..count).rev() {
            x[i] /= pivot[i];
            if i + 1 < count {
                x[i] -= one[i] * x[i + 1];
            }
            if i + 2 < count {
                x[i] -= two[i] * x[i + 2];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_what_it_multiplies_to() {
        let mut numbers = seamwright_testkit::Random::new(1);
        let mut random = || numbers.within(-0.5, 0.5);
        for _ in 0..200 {
            let n = 11;
            let mut a = Pentadiagonal::zero(n);
            for first in (0..n - 2).flat_map(|f| [f; 4]) {
                let u = [random(), random(), random()];
                a.add(first, 1.0, &u);
            }
            let x: Vec<f64> = (0..n).map(|_| random()).collect();
            let dense = |i: usize, j: usize| {
                let (low, apart) = (i.min(j), i.abs_diff(j));
                if apart < 3 { a.diagonals[apart][low] } else { 0.0 }
            };
            let mut y: Vec<f64> = (0..n).map(|i| (0..n).map(|j| dense(i, j) * x[j]).sum()).collect();
            let mut factors = Pentadiagonal::zero(n);
            assert!(factors.factor(&a, 1.0, &Pentadiagonal::zero(n), 0.0));
            factors.solve(&mut y);
            assert!(y.iter().zip(&x).all(|(y, x)| (y - x).abs() < 1e-7), "{y:?} {x:?}");
            assert!(!factors.factor(&a, 1.0, &a, 1.0));
        }
    }
}
