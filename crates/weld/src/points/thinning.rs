//! Recorded points without redundant ones.

use super::Row;
use seamwright_geometry::CubicSpline;

/// Indices of points kept of a recorded run, its first and last among them. The spline through those kept has the
/// parameters `at`. It is within `tolerance` (a value for each column) of every point left out, at the same parameter.
pub(super) fn keep_points(at: &[f64], rows: &[Row], tolerance: &Row) -> Vec<usize> {
    let mut kept = vec![0, rows.len() - 1];
    loop {
        let splines = splines(at, rows, &kept);
        let away = |i: usize| {
            let off = |(k, spline): (usize, &CubicSpline)| (spline.at(at[i]).0 - rows[i][k]).abs() / tolerance[k];
            splines.iter().enumerate().map(off).fold(0.0, f64::max)
        };
        // The worst point of every gap comes back, all at once.
        let worst = |gap: &[usize]| {
            let inside = (gap[0] + 1..gap[1]).map(|i| (away(i), i)).filter(|(off, _)| *off > 1.0);
            inside.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
        };
        let back: Vec<usize> = kept.windows(2).filter_map(worst).collect();
        if back.is_empty() {
            return kept;
        }
        kept.extend(back);
        kept.sort_unstable();
    }
}

/// The natural spline of each column through the points `kept`.
fn splines(at: &[f64], rows: &[Row], kept: &[usize]) -> Vec<CubicSpline> {
    let column = |k: usize| CubicSpline::natural(&kept.iter().map(|&i| (at[i], rows[i][k])).collect::<Vec<_>>());
    // Parameters increase: times are above zero.
    (0..Row::default().len()).filter_map(|k| column(k).ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_is_near_the_spline() {
        for seed in 0..200 {
            let noise = |i: usize, k: usize| 0.004 * ((i * 7919 + k * 104_729 + seed * 31) as f64).sin();
            let at: Vec<f64> = (0..200).map(|i| 0.5 * i as f64 + 0.1 * noise(i, 9)).collect();
            let row = |(i, t): (usize, &f64)| -> Row {
                let mut row = Row::default();
                row[0] = 40.0 * (0.05 * t).sin() + noise(i, 0);
                row[1] = 30.0 * (0.08 * t + seed as f64).cos() + noise(i, 1);
                row
            };
            let rows: Vec<Row> = at.iter().enumerate().map(row).collect();
            let tolerance = [0.02; 12];
            let kept = keep_points(&at, &rows, &tolerance);
            assert!(kept.len() < 60, "{}", kept.len());
            let splines = splines(&at, &rows, &kept);
            for (t, row) in at.iter().zip(&rows) {
                for (k, spline) in splines.iter().enumerate() {
                    assert!((spline.at(*t).0 - row[k]).abs() <= tolerance[k] * (1.0 + 1e-12));
                }
            }
        }
    }
}
