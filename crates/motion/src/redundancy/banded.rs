/// Normal equations of a least-squares problem whose rows each touch few neighbouring unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Banded {
    /// Elements of a row: from `width - 1` columns left of the diagonal to the diagonal.
    width: usize,
    lower: Vec<f64>,
    pub(crate) gradient: Vec<f64>,
}

impl Banded {
    /// Creates an empty system for `count` unknowns; a row may span at most `width` of them.
    pub(crate) fn new(count: usize, width: usize) -> Self {
        Self { width, lower: vec![0.0; count * width], gradient: vec![0.0; count] }
    }

    /// Adds the square of a residual `r` with its derivatives by the unknowns from `first` on.
    pub(crate) fn add(&mut self, first: usize, derivatives: &[f64], r: f64) {
        for (i, a) in derivatives.iter().enumerate().filter(|(_, a)| **a != 0.0) {
            self.gradient[first + i] += a * r;
            let row = (first + i) * self.width + self.width - 1 - i;
            self.lower[row..].iter_mut().zip(&derivatives[..=i]).for_each(|(n, b)| *n += a * b);
        }
    }

    /// The step to the minimum sum of squares, with the diagonal raised by the fraction `damping` (Marquardt); none if
    /// the equations are singular.
    pub(crate) fn step(&self, damping: f64) -> Option<Vec<f64>> {
        let (w, n) = (self.width, self.gradient.len());
        let mut l = self.lower.clone();
        let largest = (0..n).map(|i| l[i * w + w - 1]).fold(0.0, f64::max);
        let mut x: Vec<f64> = self.gradient.iter().map(|g| -g).collect();
        for i in 0..n {
            let from = (i + 1).saturating_sub(w);
            // Elements (i, j) and (j, k) of the band.
            let at = |i: usize, j: usize| i * w + w - 1 + j - i;
            l[at(i, i)] += damping * l[at(i, i)] + 1e-14 * largest;
            for j in from..=i {
                let start = from.max((j + 1).saturating_sub(w));
                let sum: f64 = (start..j).map(|k| l[at(i, k)] * l[at(j, k)]).sum();
                let rest = l[at(i, j)] - sum;
                l[at(i, j)] =
                    if i == j { if rest > 0.0 { rest.sqrt() } else { return None } } else { rest / l[at(j, j)] };
            }
            let known: f64 = (from..i).map(|k| l[at(i, k)] * x[k]).sum();
            x[i] = (x[i] - known) / l[at(i, i)];
        }
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n.min(i + w)).map(|k| l[k * w + w - 1 + i - k] * x[k]).sum();
            x[i] = (x[i] - known) / l[i * w + w - 1];
        }
        x.iter().all(|v| v.is_finite()).then_some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_what_a_dense_elimination_solves() {
        let (n, w) = (12, 4);
        let mut numbers = seamwright_testkit::Random::new(1);
        let mut random = || numbers.within(-0.5, 0.5);
        for _ in 0..200 {
            let mut banded = Banded::new(n, w);
            let (mut dense, mut right) = (vec![vec![0.0; n]; n], vec![0.0; n]);
            for first in (0..=n - w).flat_map(|f| [f; 3]) {
                let row: Vec<f64> = (0..w).map(|_| random()).collect();
                let r = random();
                banded.add(first, &row, r);
                for i in 0..w {
                    right[first + i] -= row[i] * r;
                    (0..w).for_each(|j| dense[first + i][first + j] += row[i] * row[j]);
                }
            }
            let x = banded.step(0.0).unwrap();
            for i in 0..n {
                let sum: f64 = (0..n).map(|j| dense[i][j] * x[j]).sum();
                assert!((sum - right[i]).abs() < 1e-9, "{sum} {}", right[i]);
            }
        }
        assert!(Banded::new(3, 2).step(0.0).is_none());
    }
}
