/// Smaller deviations never count as outliers, mm.
const FINEST_MM: f64 = 1e-3;

/// Factor from the median absolute deviation to the standard deviation of a normal distribution.
const MAD_TO_SIGMA: f64 = 1.482_602_218_505_602;

/// Root of the mean square; 0 for an empty list.
pub fn rms(values: &[f64]) -> f64 {
    let sum: f64 = values.iter().map(|v| v * v).sum();
    (sum / values.len().max(1) as f64).sqrt()
}

/// Flags the residuals `values` (mm) farther from their median than three standard deviations. The deviation is
/// estimated from the median of those distances, so that outliers do not hide each other.
pub fn outliers(values: &[f64]) -> Vec<bool> {
    let middle = median(values.to_vec());
    let spread = MAD_TO_SIGMA * median(values.iter().map(|v| (v - middle).abs()).collect());
    values.iter().map(|v| (v - middle).abs() > (3.0 * spread).max(FINEST_MM)).collect()
}

fn median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    if values.len() % 2 == 1 { values[half] } else { 0.5 * (values[half - 1] + values[half]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_wild_value_is_flagged_and_does_not_hide_another() {
        let mut values: Vec<f64> = (0..20).map(|i| 0.01 * f64::from(i % 5 - 2)).collect();
        assert!(outliers(&values).iter().all(|o| !o));
        values[3] = 0.5;
        values[11] = -5.0;
        let flagged: Vec<usize> = (0..20).filter(|i| outliers(&values)[*i]).collect();
        assert_eq!(flagged, [3, 11]);
        assert!(outliers(&[]).is_empty() && outliers(&[0.0, 1e-9, 0.0]).iter().all(|o| !o));
        assert!((rms(&[3.0, -4.0]) - 12.5f64.sqrt()).abs() < 1e-15);
    }
}
