use super::Value;

/// Lower triangle of a symmetric positive matrix: each row from a first column of its own to the diagonal. Cholesky's
/// factor fills nothing outside.
#[derive(Debug, Clone)]
pub struct Envelope {
    /// Rows, one after the other.
    elements: Vec<f64>,
    /// Position in `elements` of column 0 of each row, as if it were stored.
    origin: Vec<usize>,
}

impl Envelope {
    /// Creates the zero matrix. `widths` are the numbers of stored elements of the rows, at least 1 and at most the
    /// row's number counted from 1.
    pub fn new(widths: impl IntoIterator<Item = usize>) -> Self {
        let mut count = 0;
        let origins = widths.into_iter().enumerate().map(|(i, width)| {
            count += width;
            count - 1 - i
        });
        let origin = origins.collect();
        Self { elements: vec![0.0; count], origin }
    }

    /// Returns the element of row `i` and column `j`, which is at most `i` and inside the envelope.
    pub fn at(&mut self, i: usize, j: usize) -> &mut f64 {
        &mut self.elements[self.origin[i] + j]
    }

    /// First stored column of row `i`.
    fn first(&self, i: usize) -> usize {
        let end_of_last = if i == 0 { 0 } else { self.origin[i - 1] + i };
        end_of_last - self.origin[i]
    }

    /// Solves the system for the right side `x` by Cholesky's method; `None` if the matrix is not positive.
    pub fn solve<V: Value>(mut self, mut x: Vec<V>) -> Option<Vec<V>> {
        let n = self.origin.len();
        for i in 0..n {
            let first = self.first(i);
            let row = self.origin[i];
            for j in first..=i {
                let (from, other) = (first.max(self.first(j)), self.origin[j]);
                let pairs = self.elements[row + from..row + j].iter().zip(&self.elements[other + from..other + j]);
                let rest = self.elements[row + j] - pairs.map(|(a, b)| a * b).sum::<f64>();
                if i == j && (rest.is_nan() || rest <= 0.0) {
                    return None;
                }
                self.elements[row + j] = if i == j { rest.sqrt() } else { rest / self.elements[other + j] };
            }
            for k in first..i {
                x[i] = x[i] - x[k] * self.elements[row + k];
            }
            x[i] = x[i] * (1.0 / self.elements[row + i]);
        }
        for i in (0..n).rev() {
            let row = self.origin[i];
            x[i] = x[i] * (1.0 / self.elements[row + i]);
            for k in self.first(i)..i {
                x[k] = x[k] - x[i] * self.elements[row + k];
            }
        }
        Some(x)
    }
}
