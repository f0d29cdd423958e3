use crate::chain::MAX_AXES;
use arrayvec::ArrayVec;

/// Rows of the matrices here: three of a point, three of a direction, three of another direction.
pub(super) const ROWS: usize = 9;

/// Columns of a matrix, one an axis.
pub(super) type Columns = ArrayVec<[f64; ROWS], MAX_AXES>;

/// Singular values of a matrix with its right and left vectors, in descending order.
#[derive(Debug, Clone)]
pub(super) struct Svd {
    pub(super) values: ArrayVec<f64, MAX_AXES>,
    /// Unit vectors over the columns.
    pub(super) right: ArrayVec<[f64; MAX_AXES], MAX_AXES>,
    /// Vectors over the rows, each as long as its singular value.
    pub(super) left: Columns,
}

fn dot(a: &[f64; ROWS], b: &[f64; ROWS]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn turn<const N: usize>(a: &mut [f64; N], b: &mut [f64; N], cos: f64, sin: f64) {
    for (x, y) in a.iter_mut().zip(b) {
        (*x, *y) = (cos * *x - sin * *y, sin * *x + cos * *y);
    }
}

/// One-sided Jacobi rotations (Hestenes 1958): small singular values are as accurate as large ones.
pub(super) fn svd(columns: &Columns) -> Svd {
    let mut left = columns.clone();
    let n = left.len();
    let mut right: ArrayVec<[f64; MAX_AXES], MAX_AXES> =
        (0..n).map(|i| std::array::from_fn(|k| if i == k { 1.0 } else { 0.0 })).collect();
    for _ in 0..40 {
        let mut turned = false;
        for i in 0..n {
            for k in i + 1..n {
                let (ii, kk, ik) = (dot(&left[i], &left[i]), dot(&left[k], &left[k]), dot(&left[i], &left[k]));
                if ik.abs() <= 1e-15 * (ii * kk).sqrt() {
                    continue;
                }
                turned = true;
                let zeta = (kk - ii) / (2.0 * ik);
                let tangent = zeta.signum() / (zeta.abs() + zeta.hypot(1.0));
                let cos = 1.0 / tangent.hypot(1.0);
                let (before, after) = left.split_at_mut(k);
                turn(&mut before[i], &mut after[0], cos, cos * tangent);
                let (before, after) = right.split_at_mut(k);
                turn(&mut before[i], &mut after[0], cos, cos * tangent);
            }
        }
        if !turned {
            break;
        }
    }
    let mut order: ArrayVec<usize, MAX_AXES> = (0..n).collect();
    let length: ArrayVec<f64, MAX_AXES> = left.iter().map(|c| dot(c, c).sqrt()).collect();
    order.sort_by(|&a, &b| length[b].total_cmp(&length[a]));
    Svd {
        values: order.iter().map(|&i| length[i]).collect(),
        right: order.iter().map(|&i| right[i]).collect(),
        left: order.iter().map(|&i| left[i]).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::random::Random;

    /// The product of the factors is the matrix, the vectors are orthogonal, and a known rank is found.
    #[test]
    fn parts_make_the_whole() {
        let mut random = Random::new(1, 0);
        for case in 0..2000 {
            let n = 1 + case % 7;
            let mut columns: Columns =
                (0..n).map(|_| std::array::from_fn(|r| if r < 8 { random.unit() - 0.5 } else { 0.0 })).collect();
            if n > 2 {
                let (a, b) = (columns[0], columns[1]);
                columns[n - 1] = std::array::from_fn(|r| 2.0 * a[r] - 3.0 * b[r]);
            }
            let found = svd(&columns);
            for (k, column) in columns.iter().enumerate() {
                for (r, value) in column.iter().enumerate() {
                    let whole: f64 = (0..n).map(|i| found.left[i][r] * found.right[i][k]).sum();
                    assert!((whole - value).abs() < 1e-13);
                }
            }
            for i in 0..n {
                for k in 0..i {
                    assert!(dot(&found.left[i], &found.left[k]).abs() < 1e-13);
                }
            }
            assert!(found.values.windows(2).all(|w| w[0] >= w[1]));
            assert!(n < 3 || (found.values[n - 1] < 1e-14 && found.values[n - 2] > 1e-6));
        }
    }
}
