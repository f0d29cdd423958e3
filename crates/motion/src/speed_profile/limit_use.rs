//! Use of the limits by a speed profile, also between the points at which rows are imposed.

use super::cells::{Cells, PARTS};
use super::lanes::larger;

/// Sample points of a cell in which the profile changes much.
const CLOSE: usize = 9;
/// Minimum ratio of squared speeds in a cell that changes much.
const MUCH: f64 = 1.5;

/// Maximum use of a limit in cell `i`: of a speed (squared, also the requested one), an acceleration or a jerk. Between
/// samples a parabola through three neighbours is used, plus an error bound from third differences.
pub(crate) fn peak(cells: &Cells, c: &[f64], i: usize) -> f64 {
    let of_channels = used(cells, c, i);
    if cells.is_steady(i) {
        return of_channels;
    }
    let (profile, asked) = (PARTS.map(|part| cells.profile(c, i, part)), cells.asked(i));
    larger(of_channels, greatest(&std::array::from_fn::<_, { PARTS.len() }, _>(|part| profile[part][0] / asked[part])))
}

/// Maximum use of a limit without the requested speed.
pub(crate) fn used(cells: &Cells, c: &[f64], i: usize) -> f64 {
    let profile = PARTS.map(|part| cells.profile(c, i, part));
    let (least, most) = profile.iter().fold((f64::INFINITY, 0.0), |(l, m), [b, ..]| (b.min(l), larger(*b, m)));
    if most > MUCH * least {
        let profile = std::array::from_fn(|k| cells.profile(c, i, k as f64 / (CLOSE - 1) as f64));
        of_channels::<CLOSE>(cells, i, &profile, closer)
    } else {
        of_channels(cells, i, &profile, |q| *q)
    }
}

/// Maximum use of a channel's limit, from the profile at `N` points; `at` interpolates a derivative from the [`PARTS`]
/// to these points.
fn of_channels<const N: usize>(
    cells: &Cells,
    i: usize,
    profile: &[[f64; 3]; N],
    at: impl Fn(&[f64; PARTS.len()]) -> [f64; N],
) -> f64 {
    let roots = profile.map(|[b, ..]| b.max(0.0).sqrt());
    let mut most: f64 = 0.0;
    for (channel, limits) in cells.limits.iter().enumerate() {
        let by = [1.0 / (limits.speed * limits.speed), 1.0 / limits.acceleration, 1.0 / limits.jerk];
        let q: [[f64; N]; 3] =
            std::array::from_fn(|k| at(&std::array::from_fn(|part| cells.derivatives(i, part)[channel][k])));
        let mut used = [[0.0; N]; 3];
        for (place, [b, d, e]) in profile.iter().enumerate() {
            let [q1, q2, q3] = q.map(|q| q[place]);
            used[0][place] = q1 * q1 * b * by[0];
            used[1][place] = (q2 * b + 0.5 * q1 * d) * by[1];
            used[2][place] = roots[place] * (q3 * b + 1.5 * q2 * d + 0.5 * q1 * e) * by[2];
        }
        most = used.iter().map(greatest).fold(most, larger);
    }
    most
}

/// Values of a function at five evenly spaced points, and of the quartic through them halfway between these.
fn closer(f: &[f64; PARTS.len()]) -> [f64; CLOSE] {
    const BETWEEN: [[f64; PARTS.len()]; 2] = [[35.0, 140.0, -70.0, 28.0, -5.0], [-5.0, 60.0, 90.0, -20.0, 3.0]];
    let between = |w: &[f64; 5], k: [usize; 5]| (0..5).map(|j| w[j] * f[k[j]]).sum::<f64>() / 128.0;
    let (ahead, back) = ([0, 1, 2, 3, 4], [4, 3, 2, 1, 0]);
    let [outer, inner] = &BETWEEN;
    [
        f[0],
        between(outer, ahead),
        f[1],
        between(inner, ahead),
        f[2],
        between(inner, back),
        f[3],
        between(outer, back),
        f[4],
    ]
}

/// Maximum absolute value of a smooth function sampled at evenly spaced points, also between them.
fn greatest<const N: usize>(f: &[f64; N]) -> f64 {
    let mut most = f.iter().map(|v| v.abs()).fold(0.0, larger);
    for w in f.windows(3) {
        let (slope, second) = (0.5 * (w[2] - w[0]), w[2] - 2.0 * w[1] + w[0]);
        if slope.abs() < second.abs() {
            most = larger(most, (w[1] - 0.5 * slope * slope / second).abs());
        }
    }
    let third = |w: &[f64]| w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0];
    // A cubic deviates from its parabola by 0.065 of the third difference, which changes by the fourth.
    let open = |w: &[f64]| larger(third(w).abs(), third(&w[1..]).abs()) + (third(&w[1..]) - third(w)).abs();
    most + 0.07 * f.windows(5).map(open).fold(0.0, larger)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quartic_is_known_between_its_places() {
        let quartic = |x: f64| 1.0 - 2.0 * x + 3.0 * x * x - 7.0 * x.powi(3) + 5.0 * x.powi(4);
        let found = closer(&PARTS.map(quartic));
        assert!((0..CLOSE).all(|k| (found[k] - quartic(k as f64 / 8.0)).abs() < 1e-14), "{found:?}");
    }

    #[test]
    fn waves_are_not_higher_than_the_greatest() {
        for (frequency, phase) in (0..2000).map(|i| (f64::from(i % 40) * 0.1, f64::from(i) * 0.37)) {
            let wave = |x: f64| (frequency * x + phase).sin();
            let top = (0..=1000).map(|i| wave(f64::from(i) * 1e-3).abs()).fold(0.0, f64::max);
            let found = [greatest(&PARTS.map(wave)), greatest::<CLOSE>(&std::array::from_fn(|k| wave(k as f64 / 8.0)))];
            assert!(found.iter().all(|f| *f >= top - 1e-6 && *f < top + 0.1), "{frequency} {phase}: {found:?} {top}");
        }
    }
}
