use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Number of coefficients of a [`Series`].
pub const NODES: usize = 16;

struct Tables {
    nodes: [f64; NODES],
    /// `transform[k][j]`: weight of the value at node `j` in coefficient `k`.
    transform: [[f64; NODES]; NODES],
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let n = NODES as f64;
    let angle = |j: usize| PI * (j as f64 + 0.5) / n;
    Tables {
        nodes: std::array::from_fn(|j| angle(j).cos()),
        transform: std::array::from_fn(|k| {
            let scale = if k == 0 { 1.0 / n } else { 2.0 / n };
            std::array::from_fn(|j| scale * (k as f64 * angle(j)).cos())
        }),
    }
});

/// The points in (-1, 1) at which [`Series::fit`] wants its values (zeros of the Chebyshev polynomial), descending.
pub fn nodes() -> &'static [f64; NODES] {
    &TABLES.nodes
}

/// A truncated Chebyshev series on [-1, 1]: `sum c_k T_k(x)`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// Coefficients, lowest first.
    pub c: [f64; NODES],
}

impl Series {
    /// The polynomial of degree 15 through `values` at [`nodes`].
    pub fn fit(values: &[f64; NODES]) -> Self {
        Self { c: std::array::from_fn(|k| TABLES.transform[k].iter().zip(values).map(|(t, v)| t * v).sum()) }
    }

    /// The series' value at `x` in [-1, 1].
    ///
    /// Clenshaw's recurrence, once over the even and once over the odd degrees: both `T_2k(x)` and `T_2k+1(x)` follow
    /// the same three-term recurrence in `y = 2 x^2 - 1`, so that the two chains run side by side.
    pub fn at(&self, x: f64) -> f64 {
        let y = 2.0 * x * x - 1.0;
        let twice = 2.0 * y;
        let (mut even1, mut even2, mut odd1, mut odd2) = (0.0, 0.0, 0.0, 0.0);
        for k in (1..NODES / 2).rev() {
            (even1, even2) = (twice * even1 + (self.c[2 * k] - even2), even1);
            (odd1, odd2) = (twice * odd1 + (self.c[2 * k + 1] - odd2), odd1);
        }
        // T_0 = 1 and T_2 = y; T_1 = x and T_3 = x (2 y - 1).
        let even = y * even1 + (self.c[0] - even2);
        let odd = (twice - 1.0) * odd1 + (self.c[1] - odd2);
        even + x * odd
    }

    /// The series of a polynomial of lower degree, without its trailing coefficients of pure rounding, which would show
    /// in derivatives.
    pub fn without_rounding(self) -> Self {
        let rounding = 8.0 * f64::EPSILON * self.c.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
        self.without_tail(rounding)
    }

    /// The series without its trailing coefficients of size up to `least`.
    pub fn without_tail(mut self, least: f64) -> Self {
        let last = self.c.iter().rposition(|c| c.abs() > least).unwrap_or(0);
        self.c[last + 1..].fill(0.0);
        self
    }

    /// Size of the last three coefficients: an estimate of the truncation error.
    pub fn tail(&self) -> f64 {
        self.c[NODES - 3..].iter().map(|c| c.abs()).sum()
    }

    /// The integral from -1, truncated to the same number of coefficients.
    pub fn integral(&self) -> Self {
        let mut c = [0.0; NODES];
        c[1] = self.c[0] - 0.5 * self.c[2];
        for (k, slot) in c.iter_mut().enumerate().skip(2) {
            let above = if k + 1 < NODES { self.c[k + 1] } else { 0.0 };
            *slot = (self.c[k - 1] - above) / (2.0 * k as f64);
        }
        // T_k(-1) alternates in sign: choose c_0 so that the integral is zero at -1.
        c[0] = c.iter().enumerate().skip(1).map(|(k, v)| if k % 2 == 1 { *v } else { -*v }).sum();
        Self { c }
    }

    /// The derivative by `x`.
    pub fn derivative(&self) -> Self {
        let mut d = [0.0; NODES];
        for k in (1..NODES).rev() {
            let above = if k + 1 < NODES { d[k + 1] } else { 0.0 };
            d[k - 1] = above + 2.0 * k as f64 * self.c[k];
        }
        d[0] *= 0.5;
        Self { c: d }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fit(f: impl Fn(f64) -> f64) -> Series {
        Series::fit(&std::array::from_fn(|j| f(nodes()[j])))
    }

    #[test]
    fn reproduces_smooth_functions_their_integrals_and_derivatives() {
        let series = fit(|x| (1.3 * x + 0.2).exp());
        let (integral, derivative) = (series.integral(), series.derivative());
        for i in 0..=100 {
            let x = f64::from(i) / 50.0 - 1.0;
            let e = (1.3 * x + 0.2).exp();
            assert!((series.at(x) - e).abs() < 1e-14);
            assert!((integral.at(x) - (e - (0.2f64 - 1.3).exp()) / 1.3).abs() < 1e-14);
            assert!((derivative.at(x) - 1.3 * e).abs() < 1e-11);
        }
        assert!(series.tail() < 1e-11);
    }

    #[test]
    fn tail_shows_what_is_left_out() {
        assert!(fit(|x| (30.0 * x).cos()).tail() > 1e-2);
    }
}
