use glam::DVec2;
use nalgebra::{Matrix3, Vector3};

/// Residuals beyond this many standard deviations count less (Huber); 1.345 costs 5 % efficiency without outliers.
const HUBER: f64 = 1.345;
/// Number of passes: the first unweighted, the others weighted by the previous residuals.
const PASSES: usize = 3;
/// Prior standard deviation of the slope, which stabilises a fit with too few measurements.
const SLOPE: f64 = 0.3;

/// Deviation measured at one position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Seen {
    /// Path length, mm.
    pub(super) s: f64,
    /// Deviation, lateral and height, mm.
    pub(super) value: DVec2,
    /// Inverse variance of the deviation, 1/mm^2.
    pub(super) weight: f64,
}

/// Local parabola at one position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fit {
    pub(super) value: DVec2,
    pub(super) slope: DVec2,
    /// Variance of the value, mm^2.
    pub(super) variance: f64,
}

/// Fits a parabola around `s`, weighted by nearness within `reach` mm and by Huber's function of the residual. `bend`
/// (1/mm) is the prior standard deviation of its second derivative; a small one gives a line. Returns `None` without
/// measurements.
pub(super) fn parabola<'a>(
    s: f64,
    reach: f64,
    bend: f64,
    seen: &(impl Iterator<Item = &'a Seen> + Clone),
) -> Option<Fit> {
    let prior = |inverse: f64| (inverse * inverse).recip();
    let (steep, bent) = (prior(SLOPE * reach), prior(0.5 * bend * reach * reach));
    let mut found: Option<([Vector3<f64>; 2], f64)> = None;
    for _ in 0..PASSES {
        // Moments of weights and values: the sums of the normal equations.
        let mut moments = [0.0; 5];
        let mut values = [DVec2::ZERO; 3];
        for p in seen.clone() {
            let u = (p.s - s) / reach;
            let square = u * u;
            // Nearness weights are at most 1, because they compete with the prior's absolute weight.
            let near = (1.0 - square).max(0.05);
            let weight = p.weight * near * found.as_ref().map_or(1.0, |(c, _)| huber(c, u, p));
            for (moment, power) in moments.iter_mut().zip([1.0, u, square, u * square, square * square]) {
                *moment += weight * power;
            }
            for (value, power) in values.iter_mut().zip([1.0, u, square]) {
                *value += weight * power * p.value;
            }
        }
        let [m0, m1, m2, m3, m4] = moments;
        let normal = Matrix3::new(m0, m1, m2, m1, m2 + steep, m3, m2, m3, m4 + bent);
        let inverse = normal.cholesky()?.inverse();
        let right = [values.map(|value| value.x), values.map(|value| value.y)];
        found = Some((right.map(|r| inverse * Vector3::from(r)), inverse[(0, 0)]));
    }
    let ([x, y], variance) = found?;
    let fit = Fit { value: DVec2::new(x[0], y[0]), slope: DVec2::new(x[1], y[1]) / reach, variance };
    (fit.value.is_finite() && fit.slope.is_finite()).then_some(fit)
}

/// Returns Huber's weight of a measurement relative to the previous parabola.
fn huber([x, y]: &[Vector3<f64>; 2], u: f64, p: &Seen) -> f64 {
    let at = |c: &Vector3<f64>| c.x + u * (c.y + u * c.z);
    // Most residuals are small: comparing squares saves the root.
    let square = (p.value - DVec2::new(at(x), at(y))).length_squared() * p.weight;
    if square > HUBER * HUBER { HUBER / square.sqrt() } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// The fit reproduces exact parabolas, except for the small pull of the prior.
    #[test]
    fn parabolas_are_met() {
        let mut random = Random::new(1);
        for _ in 0..2000 {
            let [a, b, c, d] = std::array::from_fn(|_| random.within(-1.0, 1.0));
            let truth = |s: f64| DVec2::new(a + 0.1 * b * s + 0.02 * c * s * s, d - 0.1 * a * s + 0.02 * b * s * s);
            let seen: Vec<Seen> = (0..20)
                .map(|_| {
                    let s = 5.0 * random.within(-1.0, 1.0);
                    Seen { s, value: truth(s), weight: 1e6 }
                })
                .collect();
            let fit = parabola(0.0, 5.0, 0.1, &seen.iter()).unwrap();
            assert!(fit.value.distance(truth(0.0)) < 1e-4, "{} {}", fit.value, truth(0.0));
            assert!((fit.slope.x - 0.1 * b).abs() < 1e-4);
        }
    }

    /// With errors of the stated size the reported variance is right, and 10 % outliers shift the fit little.
    #[test]
    fn variance_and_outliers() {
        let mut random = Random::new(2);
        let (mut squares, mut told, mut worst) = (0.0, 0.0, 0.0f64);
        let n = 2000;
        for _ in 0..n {
            // The sum of three is nearly normal, of variance 1.
            let mut point = |i: usize, wild: bool| {
                let error = DVec2::from_array(std::array::from_fn(|_| (0..3).map(|_| random.within(-1.0, 1.0)).sum()));
                let value = if wild { DVec2::new(1.0, -1.0) } else { 0.02 * error };
                Seen { s: 0.5 * (i as f64 - 9.5), value, weight: 2500.0 }
            };
            let clean: Vec<Seen> = (0..20).map(|i| point(i, false)).collect();
            let dirty: Vec<Seen> = (0..20).map(|i| point(i, i == 4 || i == 13)).collect();
            let fit = parabola(0.0, 5.0, 0.1, &clean.iter()).unwrap();
            squares += fit.value.x.powi(2);
            told += fit.variance;
            worst = worst.max(parabola(0.0, 5.0, 0.1, &dirty.iter()).unwrap().value.x.abs());
        }
        let ratio = squares / told;
        assert!((0.5..1.5).contains(&ratio), "{ratio}");
        assert!(worst < 0.06, "{worst}");
    }

    /// Fits to one measurement and to an empty set.
    #[test]
    fn too_few_places() {
        let one = [Seen { s: 1.0, value: DVec2::new(0.5, -0.5), weight: 2500.0 }];
        let fit = parabola(0.0, 5.0, 0.1, &one.iter()).unwrap();
        assert!(fit.value.distance(one[0].value) < 0.05 && fit.slope.length() < 0.1);
        assert!(fit.variance > 0.05, "half a slope's worth of doubt: {}", fit.variance);
        assert!(parabola(0.0, 5.0, 0.1, &[].iter()).is_none());
    }
}
