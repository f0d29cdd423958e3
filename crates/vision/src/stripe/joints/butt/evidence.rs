//! Detection of a seam from the evidence along two lines, column by column.

/// Maximum magnitude of unknown evidence.
pub(super) const UNKNOWN: f64 = 1e-9;
/// Minimum runs of dark columns along a line to judge how long random ones are.
const FEW: f64 = 5.0;
/// Maximum probability that a random dark run continues; a higher one has another cause.
const GOES_ON: f64 = 0.5;
/// Columns by which a lit column within a dark run shortens it: the lit column may be at any position.
const LIT_WITHIN: usize = 3;

/// Columns to each side of a step used for its sharpness.
const BESIDE_STEP: usize = 16;

/// Gap between two lines, or a step from one to the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Gap {
    /// Last column on the left line.
    pub(super) left: i32,
    /// First column on the right line.
    pub(super) right: i32,
}

/// Returns the gap with the maximum evidence for both lines beside it, and the sum of that. `after` is a buffer.
pub(super) fn best_seam(left: &[f64], right: &[f64], after: &mut Vec<f64>) -> Option<(f64, Gap)> {
    // Maximum sum of the right line from any later column on.
    let n = left.len().min(right.len());
    after.clear();
    after.resize(n + 1, 0.0);
    let mut sum = 0.0;
    for i in (0..n).rev() {
        sum += right[i];
        after[i] = after[i + 1].max(sum);
    }
    let (mut sum, mut best) = (0.0, None::<(f64, usize)>);
    for i in 0..n {
        sum += left[i];
        if after[i + 1] > 0.0 && best.is_none_or(|(most, _)| sum + after[i + 1] > most) {
            best = Some((sum + after[i + 1], i));
        }
    }
    let (most, last) = best?;
    // The maximum sum starts where `after` falls to the right.
    let first = (last + 1..n).find(|i| after[*i] > after[*i + 1])?;
    Some((most, Gap { left: last as i32, right: first as i32 }))
}

/// Returns the minimum part of the columns beside a step, on either side, with light on one line only.
pub(super) fn sharpness(left: &[f64], right: &[f64], a: usize, b: usize) -> f64 {
    let before = left[..=a].iter().zip(right).rev().take(BESIDE_STEP).map(|(l, r)| *l > 0.0 && *r <= 0.0);
    let after = right[b..].iter().zip(&left[b..]).take(BESIDE_STEP).map(|(r, l)| *r > 0.0 && *l <= 0.0);
    let part = |sharp: &mut dyn Iterator<Item = bool>| sharp.filter(|s| *s).count() as f64 / BESIDE_STEP as f64;
    part(&mut { before }).min(part(&mut { after }))
}

/// Returns the expected number of random dark runs at least as long as the one in the gap. Dark columns and their
/// continuations are counted on both sides of it; unknown columns do not count. Returns 0 if the runs are too few.
pub(super) fn expected_runs(evidence: &[f64], gap: Gap) -> f64 {
    let Gap { left, right } = gap;
    let known = |e: &&f64| e.abs() > UNKNOWN;
    let (mut columns, mut dark, mut pairs) = (0.0, 0.0, 0.0);
    for side in [&evidence[..=left as usize], &evidence[right as usize..]] {
        let mut before = false;
        for is_dark in side.iter().filter(known).map(|e| *e < 0.0) {
            columns += 1.0;
            dark += f64::from(u8::from(is_dark));
            pairs += f64::from(u8::from(is_dark && before));
            before = is_dark;
        }
    }
    let runs = dark - pairs;
    if runs < FEW {
        return 0.0;
    }
    // Adds the standard error of the count, as few pairs may underestimate it.
    let goes_on = ((pairs + f64::sqrt(pairs)) / dark).max(dark / columns).min(GOES_ON);
    let within = evidence[left as usize + 1..right as usize].iter().filter(known);
    let lit = within.clone().filter(|e| **e > 0.0).count();
    let length = within.count().saturating_sub(lit + LIT_WITHIN * lit);
    runs * goes_on.powi(length.max(1) as i32 - 1)
}

/// Returns the longest run of columns with evidence against the line.
pub(super) fn longest_dark(evidence: &[f64]) -> i32 {
    let (mut run, mut longest) = (0, 0);
    for e in evidence {
        run = if *e < 0.0 { run + 1 } else { 0 };
        longest = longest.max(run);
    }
    longest
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    #[test]
    fn the_best_seam_is_that_of_brute_force() {
        for seed in 0..2000 {
            let mut random = Random::of_case(seed);
            let count = 2 + seed as usize % 25;
            // Evidence of a column is from -2 to 2.
            let [left, right] = [0; 2].map(|_| Vec::from_iter((0..count).map(|_| random.within(-2.0, 2.0))));
            let sum = |a: usize, b: usize| left[..=a].iter().sum::<f64>() + right[b..].iter().sum::<f64>();
            // The right line must keep some evidence.
            let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
            let some = pairs.filter(|(_, b)| right[*b..].iter().sum::<f64>() > 0.0);
            let best = some.map(|(a, b)| sum(a, b)).fold(f64::NEG_INFINITY, f64::max);
            match best_seam(&left, &right, &mut Vec::new()) {
                None => assert!(best.is_infinite(), "seed {seed}"),
                Some((most, gap)) => {
                    let found = sum(gap.left as usize, gap.right as usize);
                    assert!((most - best).abs() < 1e-9 && (found - best).abs() < 1e-9, "{seed}");
                }
            }
        }
    }

    #[test]
    fn a_gap_in_one_line_is_the_seam() {
        for (from, to) in [(10, 12), (30, 60), (1, 98)] {
            let mut on = [1.0; 100];
            on[from..to].fill(-1.0);
            let (sum, gap) = best_seam(&on, &on, &mut Vec::new()).unwrap();
            assert_eq!(gap, Gap { left: from as i32 - 1, right: to as i32 });
            assert!((sum - (100 - (to - from)) as f64).abs() < 1e-12);
            assert_eq!(longest_dark(&on), (to - from) as i32);
        }
        assert_eq!(longest_dark(&[]), 0);
    }

    /// Random runs are as rare as expected: no more frequent, and not much rarer, for single holes and for runs.
    #[test]
    fn chance_runs_are_as_often_as_expected() {
        let mut random = Random::new(5);
        for (begins, goes_on) in [(0.05, 0.05), (0.2, 0.2), (0.03, 0.3), (0.04, 0.45)] {
            let mut unlikely = [0; 3];
            for _ in 0..5000 {
                let (mut on, mut is_dark) = (Vec::new(), false);
                for _ in 0..1000 {
                    let part = if is_dark { goes_on } else { begins };
                    is_dark = random.chance(part);
                    on.push(if is_dark { -1.0 } else { 1.0 });
                }
                let longest = longest_dark(&on) as usize;
                let from = on.windows(longest).position(|run| run.iter().all(|e| *e < 0.0)).unwrap();
                let gap = Gap { left: from as i32 - 1, right: (from + longest) as i32 };
                if gap.left >= 0 && gap.right < on.len() as i32 {
                    let told = expected_runs(&on, gap);
                    for (count, most) in unlikely.iter_mut().zip([1.0, 1e-2, 1e-3]) {
                        *count += u32::from(told < most);
                    }
                }
            }
            assert!(unlikely[0] > 500 && unlikely[1] < 75 && unlikely[2] < 15, "{begins} {goes_on}: {unlikely:?}");
        }
    }

    /// Expected runs for a gap with `other` in its middle, in 400 columns with these dark runs.
    fn runs_of_columns(runs: &[(usize, usize)], gap: std::ops::Range<usize>, other: f64) -> f64 {
        let mut on = [1.0; 400];
        runs.iter().for_each(|(from, count)| on[*from..from + count].fill(-1.0));
        let between = Gap { left: gap.start as i32 - 1, right: gap.end as i32 };
        let middle = (gap.start + gap.end) / 2;
        on[gap].fill(-1.0);
        on[middle] = other;
        expected_runs(&on, between)
    }

    #[test]
    fn a_gap_is_told_from_holes() {
        let holes: Vec<(usize, usize)> = (0..30).map(|i| (5 + 13 * i, 1 + i % 2)).collect();
        // No holes, or too few, of any length.
        for few in [&[][..], &[(20, 1)], &[(20, 3)], &[(20, 30), (90, 5), (150, 5)]] {
            assert!(runs_of_columns(few, 200..206, -1.0) <= 0.0, "{few:?}");
        }
        // 15 of 45 dark columns follow another: the ratio with its error is 0.42.
        let expected = |length: i32| 30.0 * ((15.0 + 15f64.sqrt()) / 45.0).powi(length - 1);
        assert!((runs_of_columns(&holes, 204..208, -1.0) / expected(4) - 1.0).abs() < 1e-9);
        assert!((runs_of_columns(&holes, 204..208, 0.0) / expected(3) - 1.0).abs() < 1e-9);
        assert!(
            (runs_of_columns(&holes[..16], 214..234, 1.0) / runs_of_columns(&holes[..16], 214..230, -1.0) - 1.0).abs()
                < 1e-9
        );
        // A very long gap is not random; at the borders one column is left on each side.
        assert!(runs_of_columns(&holes[..16], 214..300, -1.0) < 1e-20);
        assert!(runs_of_columns(&[], 1..399, -1.0) <= 0.0);
    }

    #[test]
    fn a_step_is_as_sharp_as_its_duller_side() {
        // Lit on the left line up to column 49 and on the right line from column 50 on; on both in some columns.
        let line = |on: &dyn Fn(usize) -> bool| (0..100).map(|i| if on(i) { 1.0 } else { -1.0 }).collect::<Vec<f64>>();
        for both in 0..=BESIDE_STEP {
            let left = line(&|i| i < 50);
            let right = line(&|i| i >= 50 || i % BESIDE_STEP < both);
            let wanted = 1.0 - both as f64 / BESIDE_STEP as f64;
            assert!((sharpness(&left, &right, 49, 50) - wanted).abs() < 1e-12, "{both}");
            // The other way round the left line continues.
            let (left, right) = (line(&|i| i < 50 || i % BESIDE_STEP < both), line(&|i| i >= 50));
            assert!((sharpness(&left, &right, 49, 50) - wanted).abs() < 1e-12, "{both}");
        }
    }
}
