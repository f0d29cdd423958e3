use seamwright_geometry::numeric::Envelope;

/// Normal equations of a least-squares problem whose rows each touch few neighbouring unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Banded {
    matrix: Envelope,
    gradient: Vec<f64>,
}

impl Banded {
    /// Creates an empty system for `count` unknowns; a row may span at most `width` of them.
    pub(crate) fn new(count: usize, width: usize) -> Self {
        Self { matrix: Envelope::new((1..=count).map(|i| width.min(i))), gradient: vec![0.0; count] }
    }

    /// Adds the square of a residual `r` with its derivatives by the unknowns from `first` on.
    pub(crate) fn add(&mut self, first: usize, derivatives: &[f64], r: f64) {
        for (i, a) in derivatives.iter().enumerate().filter(|(_, a)| **a != 0.0) {
            self.gradient[first + i] += a * r;
            for (j, b) in derivatives[..=i].iter().enumerate() {
                *self.matrix.at(first + i, first + j) += a * b;
            }
        }
    }

    /// The step to the minimum sum of squares, with the diagonal raised by the fraction `damping` (Marquardt); none if
    /// the equations are singular.
    pub(crate) fn step(&self, damping: f64) -> Option<Vec<f64>> {
        let mut matrix = self.matrix.clone();
        let n = self.gradient.len();
        let largest = (0..n).map(|i| *matrix.at(i, i)).fold(0.0, f64::max);
        (0..n).for_each(|i| *matrix.at(i, i) += damping * *matrix.at(i, i) + 1e-14 * largest);
        let step = matrix.solve(self.gradient.iter().map(|g| -g).collect())?;
        step.iter().all(|v| v.is_finite()).then_some(step)
    }
}
