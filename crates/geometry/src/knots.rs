use crate::error::Error;

/// Positions and values of `points`, positions increasing; with a period the first point once more at its end.
pub(crate) fn knots(points: &[(f64, f64)], period: Option<f64>) -> Result<(Vec<f64>, Vec<f64>), Error> {
    if let Some(index) = (1..points.len()).find(|&i| points[i].0 <= points[i - 1].0 || !points[i].0.is_finite()) {
        return Err(Error::Knots { index });
    }
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return Err(Error::Knots { index: 0 });
    };
    let (mut x, mut y): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
    if let Some(period) = period {
        if last.0 - first.0 >= period {
            return Err(Error::Knots { index: points.len() - 1 });
        }
        x.push(first.0 + period);
        y.push(first.1);
    }
    Ok((x, y))
}
