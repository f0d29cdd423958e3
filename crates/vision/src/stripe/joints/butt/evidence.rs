//! What evidence along two lines, column by column, says of a seam between them.

use crate::stripe::edges::LEAST_HOLE;

/// Columns to each side of a step that tell how sharp it is.
const BESIDE_STEP: usize = 16;

/// The last column on the left line and the first one on the right line for which the evidence for both is best, with its
/// sum; `after` is scratch.
pub(super) fn best_seam(left: &[f64], right: &[f64], after: &mut Vec<f64>) -> Option<(f64, i32, i32)> {
    // Best sum of the right line from any later column on.
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
    // The best sum begins where it gets less to the right.
    let first = (last + 1..n).find(|i| after[*i] > after[*i + 1])?;
    Some((most, last as i32, first as i32))
}

/// Least part of the columns beside a step in which there is light on one line and not on the other.
pub(super) fn sharpness(left: &[f64], right: &[f64], a: usize, b: usize) -> f64 {
    let before = left[..=a].iter().zip(right).rev().take(BESIDE_STEP).map(|(l, r)| *l > 0.0 && *r <= 0.0);
    let after = right[b..].iter().zip(&left[b..]).take(BESIDE_STEP).map(|(r, l)| *r > 0.0 && *l <= 0.0);
    let part = |sharp: &mut dyn Iterator<Item = bool>| sharp.filter(|s| *s).count() as f64 / BESIDE_STEP as f64;
    part(&mut { before }).min(part(&mut { after }))
}

/// How many runs of dark columns at least as long as the one between two columns are to be expected by chance, if columns along the line
/// are dark as often, and one after the other, as those on both sides of it are.
pub(super) fn expected_runs(evidence: &[f64], (left, right): (i32, i32)) -> f64 {
    let (mut dark, mut pairs) = (0.0, 0.0);
    for side in [&evidence[..=left as usize], &evidence[right as usize..]] {
        dark += side.iter().filter(|e| **e < 0.0).count() as f64;
        pairs += side.windows(2).filter(|e| e[0] < 0.0 && e[1] < 0.0).count() as f64;
    }
    // So few of them tell it that it may well be more.
    let hole = ((pairs + pairs.sqrt() + LEAST_HOLE) / (dark + 1.0)).max(dark / evidence.len() as f64);
    // One lit column between two runs, wherever it may be, is likelier than both in one.
    let within = &evidence[left as usize + 1..right as usize];
    let lit = within.iter().filter(|e| **e > 0.0).count() as i32;
    (dark - pairs) * hole.powi((right - left - 2 - 3 * lit).max(0))
}

/// The longest run of columns that speak against the line.
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
    use rand_pcg::Pcg64Mcg;
    use rand_pcg::rand_core::{Rng, SeedableRng};

    /// Evidence of `count` columns, -2 to 2.
    fn chance(seed: u64, count: usize) -> Vec<f64> {
        let one = |i: u64| {
            let hash = (seed * 1000 + i + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            let hash = (hash ^ (hash >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            (hash >> 40) as f64 / f64::from(1 << 22) - 2.0
        };
        (0..count as u64).map(one).collect()
    }

    #[test]
    fn the_best_seam_is_that_of_brute_force() {
        for seed in 0..2000 {
            let count = 2 + seed as usize % 25;
            let (left, right) = (chance(2 * seed, count), chance(2 * seed + 1, count));
            let sum = |a: usize, b: usize| left[..=a].iter().sum::<f64>() + right[b..].iter().sum::<f64>();
            // Of the right line something must be left.
            let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
            let some = pairs.filter(|(_, b)| right[*b..].iter().sum::<f64>() > 0.0);
            let best = some.map(|(a, b)| sum(a, b)).fold(f64::NEG_INFINITY, f64::max);
            match best_seam(&left, &right, &mut Vec::new()) {
                None => assert!(best.is_infinite(), "seed {seed}"),
                Some((most, a, b)) => {
                    assert!((most - best).abs() < 1e-9 && (sum(a as usize, b as usize) - best).abs() < 1e-9, "{seed}");
                }
            }
        }
    }

    #[test]
    fn a_gap_in_one_line_is_the_seam() {
        for (from, to) in [(10, 12), (30, 60), (1, 98)] {
            let mut on = [1.0; 100];
            on[from..to].fill(-1.0);
            let (sum, left, right) = best_seam(&on, &on, &mut Vec::new()).unwrap();
            assert_eq!((left, right), (from as i32 - 1, to as i32));
            assert!((sum - (100 - (to - from)) as f64).abs() < 1e-12);
            assert_eq!(longest_dark(&on), (to - from) as i32);
        }
        assert_eq!(longest_dark(&[]), 0);
    }

    /// Runs as unlikely as one in a hundred or a thousand are no more often, whether holes come alone or in runs.
    #[test]
    fn chance_runs_are_no_more_often_than_told() {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        for (begins, goes_on) in [(0.05, 0.05), (0.2, 0.2), (0.03, 0.3), (0.02, 0.5)] {
            let mut unlikely = [0; 2];
            for _ in 0..5000 {
                let (mut on, mut is_dark) = (Vec::new(), false);
                for _ in 0..1000 {
                    let part = if is_dark { goes_on } else { begins };
                    is_dark = f64::from(random.next_u32()) < part * f64::from(u32::MAX);
                    on.push(if is_dark { -1.0 } else { 1.0 });
                }
                let longest = longest_dark(&on) as usize;
                let from = on.windows(longest).position(|run| run.iter().all(|e| *e < 0.0)).unwrap();
                let (left, right) = (from as i32 - 1, (from + longest) as i32);
                if left >= 0 && right < on.len() as i32 {
                    let told = expected_runs(&on, (left, right));
                    unlikely[0] += u32::from(told < 1e-2);
                    unlikely[1] += u32::from(told < 1e-3);
                }
            }
            assert!(unlikely[0] < 75 && unlikely[1] < 15, "{begins} {goes_on}: {unlikely:?}");
        }
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
            // The other way round the left line goes on.
            let (left, right) = (line(&|i| i < 50 || i % BESIDE_STEP < both), line(&|i| i >= 50));
            assert!((sharpness(&left, &right, 49, 50) - wanted).abs() < 1e-12, "{both}");
        }
    }
}
