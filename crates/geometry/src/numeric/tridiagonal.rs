use super::Value;

/// Equation of a tridiagonal system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row<V> {
    /// Factors of the unknown before its own, its own, and the one after.
    pub factors: [f64; 3],
    /// Right side.
    pub right: V,
}

impl<V> Row<V> {
    /// Creates the equation.
    pub fn new(factors: [f64; 3], right: V) -> Self {
        Self { factors, right }
    }
}

/// Solves a diagonally dominant tridiagonal system (Thomas' algorithm).
pub fn tridiagonal<V: Value>(rows: impl IntoIterator<Item = Row<V>>) -> Vec<V> {
    let (mut above, mut x): (Vec<f64>, Vec<V>) = (Vec::new(), Vec::new());
    for Row { factors: [a, b, c], right } in rows {
        let (pivot, rest) = match (above.last(), x.last()) {
            (Some(above), Some(before)) => (b - a * above, right - *before * a),
            _ => (b, right),
        };
        above.push(c / pivot);
        x.push(rest * (1.0 / pivot));
    }
    for i in (0..x.len().saturating_sub(1)).rev() {
        x[i] = x[i] - x[i + 1] * above[i];
    }
    x
}
