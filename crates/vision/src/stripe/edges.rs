//! Detection of the ends of the light along a course.

use super::profile::median;
use nalgebra::{SMatrix, SVector};

/// Minimum light of a lit column, as a part of the usual light.
pub(super) const LIT: f64 = 0.2;

/// Minimum and maximum part of lit columns on a course, and the part of lit columns off it. Reflections, spatter and
/// faces seen from the side light the latter.
const LIT_ON: [f64; 2] = [0.6, 0.95];
const LIT_OFF: f64 = 0.05;

/// Logarithm of the likelihood of holes below which dark columns are a gap, and the minimum columns of a gap.
const GAP_ODDS: f64 = -5.0;
const MIN_GAP: f64 = 2.0;

/// Part of the holes that are assumed to continue if a course has no holes.
const PRIOR_HOLE: f64 = 0.1;

/// Part of a column's light that the lens spreads into each neighbour. It locates an end far better than the position
/// of half the light: grains vary by half between columns, but the light spread into a dark column comes from its
/// neighbour alone.
const SPREAD: f64 = 0.25;

/// Standard deviation of columns after the spread, for independent columns before it.
const AFTER_SPREAD: f64 = 0.612;

/// Standard deviations of the light off the course and of the noise, as parts of the usual light.
const STRAY: f64 = 0.07;
const NOISE: f64 = 0.03;

/// Columns before an end searched for another object, and the maximum number with one: corners have some.
const BEFORE: usize = 12;
const HIDING: usize = 4;

/// Columns in the window about an end.
const WINDOW: usize = 8;

/// Reach and step of the search for an end about the lit columns' end, columns.
const REACH: f64 = 2.5;
const STEP: f64 = 0.2;

/// Usual light along a course.
#[derive(Debug, Clone, Copy)]
pub(super) struct Usual {
    /// Light of a lit column.
    pub(super) light: f64,
    /// Mean and standard deviation of all columns, in parts of `light`.
    mean: f64,
    deviation: f64,
    /// Part of the columns that are lit.
    pub(super) lit: f64,
    /// Part of the dark columns that are followed by a dark one.
    hole: f64,
}

impl Usual {
    /// Measures columns that are assumed to be on the course.
    pub(super) fn of(strip: &[f64], scratch: &mut Vec<f64>) -> Option<Self> {
        scratch.clear();
        scratch.extend(strip.iter().filter(|v| v.is_finite()));
        let middle = median(scratch)?;
        // Holes may be frequent too.
        scratch.retain(|v| *v > 0.5 * middle);
        let light = median(scratch)?;
        let seen = || strip.iter().filter(|v| v.is_finite()).map(|v| (v / light).clamp(0.0, 3.0));
        let count = seen().count() as f64;
        let mean = seen().sum::<f64>() / count;
        let deviation = (seen().map(|v| (v - mean).powi(2)).sum::<f64>() / count).sqrt();
        let lit = seen().filter(|v| *v > LIT).count() as f64 / count;
        let dark = |v: &f64| *v <= LIT * light;
        let pairs = strip.windows(2).filter(|w| dark(&w[0]) && dark(&w[1])).count() as f64;
        let hole = (pairs + PRIOR_HOLE) / (count * (1.0 - lit) + 1.0);
        (light > 0.0 && mean > 0.0).then_some(Self { light, mean, deviation, lit, hole })
    }

    /// Returns true if a column is known to be dark.
    pub(super) fn is_dark(&self, light: f64) -> bool {
        light.is_finite() && light <= LIT * self.light
    }

    /// Returns the minimum number of consecutive dark columns that are more likely a gap than holes.
    pub(super) fn least_gap(&self) -> f64 {
        (GAP_ODDS / self.hole.min(0.5).ln()).max(MIN_GAP)
    }

    /// Returns the log likelihood ratio that this light is the stripe's; 0 outside the image or under another object.
    pub(super) fn evidence(&self, light: f64) -> f64 {
        let on = self.lit.clamp(LIT_ON[0], LIT_ON[1]);
        if !light.is_finite() {
            0.0
        } else if light > LIT * self.light {
            (on / LIT_OFF).ln()
        } else {
            // Holes come in runs.
            ((1.0 - on).max(self.hole.min(0.5)) / (1.0 - LIT_OFF)).ln()
        }
    }
}

/// Returns the most likely number of lit columns at the start of `strip`, which runs from inside to outside.
pub(super) fn lit_columns(strip: &[f64], usual: &Usual) -> usize {
    let (mut sum, mut most, mut end) = (0.0, 0.0, 0);
    for (i, &light) in strip.iter().enumerate() {
        sum += usual.evidence(light);
        if sum >= most {
            (most, end) = (sum, i + 1);
        }
    }
    end
}

/// Returns true if another object hides the end of the light: in several columns before it, or up to the first dark
/// one.
pub(super) fn is_hidden(strip: &[f64], usual: &Usual, end: usize) -> bool {
    let after = strip[end..].iter().take_while(|v| !usual.is_dark(**v));
    strip[end.saturating_sub(BEFORE)..end].iter().chain(after).filter(|v| v.is_infinite()).count() > HIDING
}

/// Locates the end to a fraction of a column: the mean over all positions of the end, weighted by the likelihood of the
/// light about it.
///
/// Each column on the course has normally distributed light, each column off it some stray light, and the lens spreads
/// both. The observed light is therefore normally distributed for every position of the end.
pub(super) fn sub_column(strip: &[f64], usual: &Usual, coarse: usize) -> f64 {
    let first = coarse as i64 - (WINDOW / 2) as i64;
    let lit = LitColumn { mean: usual.mean, deviation: (usual.deviation / AFTER_SPREAD).clamp(0.1, 0.9) };
    let mut seen = SVector::<f64, WINDOW>::zeros();
    let mut noise = SVector::<f64, WINDOW>::zeros();
    for i in 0..WINDOW {
        let at = usize::try_from(first + i as i64).ok().and_then(|i| strip.get(i)).copied().unwrap_or(f64::NAN);
        // The light of the neighbour before the window is unknown.
        let known = at.is_finite() && i > 0;
        seen[i] = if known { at / usual.light } else { 0.0 };
        noise[i] = if known { NOISE * NOISE } else { 1e4 };
    }
    let (mut weights, mut moment, mut most) = (0.0, 0.0, f64::NEG_INFINITY);
    let steps = (2.0 * REACH / STEP) as i32;
    for k in 0..=steps {
        let end = (WINDOW / 2) as f64 - REACH + STEP * f64::from(k);
        let Some(score) = likelihood(&seen, &noise, end, lit) else { continue };
        // Weights relative to the maximum likelihood so far.
        if score > most {
            let down = (most - score).exp();
            (weights, moment, most) = (weights * down, moment * down, score);
        }
        let weight = (score - most).exp();
        weights += weight;
        moment += weight * end;
    }
    if weights > 0.0 { first as f64 + moment / weights } else { coarse as f64 }
}

/// Distribution of a lit column's light before the spread, in parts of the usual light.
#[derive(Debug, Clone, Copy)]
struct LitColumn {
    mean: f64,
    deviation: f64,
}

/// Returns the log likelihood of the light if columns before `end` are lit, up to a constant.
fn likelihood(seen: &SVector<f64, WINDOW>, noise: &SVector<f64, WINDOW>, end: f64, lit: LitColumn) -> Option<f64> {
    let part = |i: usize| (end - i as f64).clamp(0.0, 1.0);
    let variance = |i: usize| (lit.deviation * part(i)).powi(2) + (STRAY * (1.0 - part(i))).powi(2);
    let brings = |to: usize, from: usize| match to.abs_diff(from) {
        0 => 1.0 - 2.0 * SPREAD,
        1 => SPREAD,
        _ => 0.0,
    };
    let mut covariance = SMatrix::<f64, WINDOW, WINDOW>::from_diagonal(noise);
    let mut off = *seen;
    for i in 0..WINDOW {
        for k in i.saturating_sub(1)..(i + 2).min(WINDOW) {
            off[i] -= brings(i, k) * lit.mean * part(k);
        }
        for j in 0..=i {
            let shared = i.saturating_sub(1)..(j + 2).min(WINDOW);
            let sum: f64 = shared.map(|k| brings(i, k) * brings(j, k) * variance(k)).sum();
            covariance[(i, j)] += sum;
            covariance[(j, i)] = covariance[(i, j)];
        }
    }
    let cholesky = covariance.cholesky()?;
    let squares = off.dot(&cholesky.solve(&off));
    let spread: f64 = cholesky.l_dirty().diagonal().iter().map(|d| d.ln()).sum();
    Some(-0.5 * squares - spread)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIGHT: f64 = 700.0;

    /// Returns a pseudorandom number from 0 to 1 for a seed.
    fn chance(seed: u64) -> f64 {
        let hash = seed.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let hash = (hash ^ (hash >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        (hash >> 11) as f64 / (1u64 << 53) as f64
    }

    #[test]
    fn the_usual_is_that_of_lit_columns_and_their_holes() {
        for (count, run) in [(100, 0), (100, 1), (120, 4), (200, 30)] {
            let mut strip = vec![LIGHT; count];
            strip[50..50 + run].fill(0.0);
            // Unknown columns do not matter.
            strip.push(f64::NAN);
            let usual = Usual::of(&strip, &mut Vec::new()).unwrap();
            let lit = 1.0 - run as f64 / count as f64;
            assert!((usual.light - LIGHT).abs() < 1e-9 && (usual.lit - lit).abs() < 1e-12);
            assert!((usual.mean - lit).abs() < 1e-12);
            assert!((usual.deviation - (lit * (1.0 - lit)).sqrt()).abs() < 1e-12);
            let hole = (run.saturating_sub(1) as f64 + PRIOR_HOLE) / (run as f64 + 1.0);
            assert!((usual.hole - hole).abs() < 1e-9);
            // The likelihood of that many dark columns is the limit.
            let gap = usual.least_gap();
            assert!(gap >= MIN_GAP && (gap <= MIN_GAP || (hole.min(0.5).ln() * gap - GAP_ODDS).abs() < 1e-9));
            assert!(usual.is_dark(0.1 * LIGHT) && !usual.is_dark(0.3 * LIGHT) && !usual.is_dark(f64::INFINITY));
        }
        assert!(Usual::of(&[f64::NAN; 9], &mut Vec::new()).is_none());
    }

    #[test]
    fn lit_columns_are_the_best_of_all_prefixes() {
        for seed in 0..2000u64 {
            let count = 5 + (chance(seed) * 60.0) as usize;
            let end = (chance(seed + 10_000) * count as f64) as usize;
            let light = |i: usize| {
                let c = chance(seed * 100 + i as u64);
                if (c < 0.85) == (i < end) {
                    LIGHT
                } else if c > 0.97 {
                    f64::INFINITY
                } else {
                    0.0
                }
            };
            let strip: Vec<f64> = (0..count).map(light).collect();
            let mut on = strip.clone();
            on.resize(count + 20, LIGHT);
            let usual = Usual::of(&on, &mut Vec::new()).unwrap();
            let sum = |n: usize| strip[..n].iter().map(|v| usual.evidence(*v)).sum::<f64>();
            let best = (0..=count).map(sum).fold(f64::MIN, f64::max);
            assert!((sum(lit_columns(&strip, &usual)) - best).abs() < 1e-9, "seed {seed}");
        }
    }

    #[test]
    fn ends_are_found_between_columns() {
        let usual = Usual::of(&[LIGHT; 60], &mut Vec::new()).unwrap();
        for k in 0..200 {
            let end = 20.0 + 0.05 * f64::from(k);
            let lit = |i: i64| (end - i as f64).clamp(0.0, 1.0);
            // The lens spreads the light of each column.
            let seen = |i: i64| (1.0 - 2.0 * SPREAD) * lit(i) + SPREAD * (lit(i - 1) + lit(i + 1));
            let strip: Vec<f64> = (0..60).map(|i| LIGHT * seen(i)).collect();
            let coarse = lit_columns(&strip, &usual);
            assert!((coarse as f64 - end).abs() < 1.5, "{end}: {coarse}");
            let found = sub_column(&strip, &usual, coarse);
            assert!((found - end).abs() < 0.1, "{end}: {found}");
        }
    }

    #[test]
    fn ends_under_something_else_are_hidden() {
        let usual = Usual::of(&[LIGHT; 60], &mut Vec::new()).unwrap();
        for many in 0..12 {
            for from in [22, 29, 30] {
                let mut strip = [LIGHT; 60];
                strip[30..].fill(0.0);
                strip[from..from + many].fill(f64::INFINITY);
                // Columns before the end count, and those after it up to the first dark one.
                let near = if from > 30 { 0 } else { many };
                assert_eq!(is_hidden(&strip, &usual, 30), near > HIDING, "{many} from {from}");
            }
        }
    }
}
