use super::End;
use super::midline::Found;
use super::trail::Stop;

/// Rows before and after the last seen row in which the end is searched.
const ABOUT: usize = 40;
/// Maximum contribution of a row's depth, parts of the joint's, either way.
const MAX_CONTRIBUTION: f32 = 1.0;
/// Rows to either side of an end that place it between rows, at level 0; one row at least. They cover the blur.
const NEAR: usize = 3;
/// Minimum rows for a mean depth.
const SEVERAL: usize = 5;
/// Rows before and after an end over which the depth is averaged.
const LEVEL: usize = 14;
/// Rows before an end that must be mostly seen.
const BEFORE: usize = 24;

/// The depth behind an end is below this part of the joint's.
const CLEAR: f32 = 0.5;
/// Minimum rows before the border to distinguish an end from a tack, as a part of the longest gap.
const TOLD: f32 = 0.5;

/// Rows that belong to the joint, and the reason why it ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cut {
    pub(super) rows: usize,
    pub(super) end: End,
    /// Position of the end from half a row after the last row on, rows.
    pub(super) beyond: f32,
}

/// Cuts off the last coasted rows and distinguishes an end of the joint from its loss; `None` if no row is seen.
/// `solid`: rows up to which the joint is certain; `gap`: rows of the longest gap.
pub(super) fn cut(
    rows: &[Found],
    solid: usize,
    stop: Stop,
    gap: f32,
    level: usize,
    is_whole: impl Fn(usize) -> bool,
) -> Option<Cut> {
    let seen = match stop {
        Stop::Gap => rows[..solid.min(rows.len())].iter().rposition(|r| r.seen)? + 1,
        Stop::Rim | Stop::Closed => last_whole(rows, is_whole)?,
    };
    let left = Cut { rows: seen, end: End::LeftImage, beyond: 0.0 };
    match stop {
        Stop::Closed => return Some(Cut { rows: rows.len(), end: End::Closed, beyond: 0.0 }),
        // The metal before the border is too short to distinguish an end from a tack.
        Stop::Rim if ((rows.len() - seen) as f32) < TOLD * gap => return Some(left),
        Stop::Rim | Stop::Gap => {}
    }
    // The end is where depths fall to zero: most are above half of the joint's before it, and below after it.
    let depth = rows[seen.saturating_sub(ABOUT)].depth.max(1e-3);
    let (from, to) = (seen.saturating_sub(ABOUT), (seen + ABOUT).min(rows.len()));
    let (mut sum, mut greatest, mut at) = (0.0, 0.0, from);
    for (i, row) in rows[from..to].iter().enumerate() {
        sum += (row.own_depth / depth - 0.5).clamp(-MAX_CONTRIBUTION, MAX_CONTRIBUTION);
        if sum > greatest {
            (greatest, at) = (sum, from + i + 1);
        }
    }
    let beyond = between(rows, at, depth, (NEAR >> level).max(1));
    let sure = rows[at.saturating_sub(BEFORE)..at].iter().filter(|r| r.seen).count();
    let after = &rows[at..];
    let count = after.len().max(1) as f32;
    let mean = after.iter().map(|r| r.own_depth).sum::<f32>() / count;
    let scatter = after.iter().map(|r| (r.own_depth - mean).powi(2)).sum::<f32>() / count;
    let clear = mean.abs() + 3.0 * (scatter / count).sqrt() < CLEAR * depth;
    let told = clear && 4 * sure >= 3 * BEFORE;
    Some(match stop {
        _ if told => Cut { rows: at, end: End::JointEnd, beyond },
        Stop::Gap => Cut { rows: at, end: End::Lost, beyond },
        Stop::Rim | Stop::Closed => left,
    })
}

/// Returns the row behind the last seen stretch with both sides of the joint in the picture. Other stretches are
/// artefacts at the border.
fn last_whole(rows: &[Found], is_whole: impl Fn(usize) -> bool) -> Option<usize> {
    let mut to = rows.iter().rposition(|r| r.seen)? + 1;
    loop {
        let from = rows[..to].iter().rposition(|r| !r.seen).map_or(0, |unseen| unseen + 1);
        match rows[..from].iter().rposition(|r| r.seen) {
            Some(last) if !(from..to).any(&is_whole) => to = last + 1,
            _ => return Some(to),
        }
    }
}

/// Returns the end's distance behind the start of row `at`, rows, by the sum of the depths within `reach` rows to
/// either side. Depths are scaled to the means before and after the end.
fn between(rows: &[Found], at: usize, depth: f32, reach: usize) -> f32 {
    let mean = |from: usize, to: usize| {
        let near = &rows[from.min(to)..to];
        (near.len() >= SEVERAL).then(|| near.iter().map(|r| r.own_depth).sum::<f32>() / near.len() as f32)
    };
    let before = mean(at.saturating_sub(LEVEL), at.saturating_sub(2)).unwrap_or(depth).max(0.5 * depth);
    let after = mean((at + 2).min(rows.len()), (at + LEVEL).min(rows.len())).unwrap_or(0.0).min(0.4 * depth);
    let (first, last) = (at.saturating_sub(reach), (at + reach).min(rows.len()));
    let part = |r: &Found| ((r.own_depth - after) / (before - after)).clamp(-0.5, 1.5);
    let whole: f32 = rows[first..last].iter().map(part).sum();
    (first as f32 + whole - at as f32).clamp(-1.5, 1.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of a joint 30 grey values deep that are seen or not.
    fn rows(stretches: &[(usize, bool)]) -> Vec<Found> {
        let row = |seen| Found { seen, depth: 30.0, own_depth: if seen { 30.0 } else { 0.0 }, ..Found::default() };
        stretches.iter().flat_map(|(count, seen)| std::iter::repeat_n(row(*seen), *count)).collect()
    }

    #[test]
    fn what_is_seen_at_the_rim_alone_is_no_joint() {
        let rows = rows(&[(60, true), (40, false), (4, true), (3, false), (5, true)]);
        let at_rim = cut(&rows, 60, Stop::Rim, 50.0, 0, |i| i < 95).unwrap();
        assert_eq!((at_rim.rows, at_rim.end), (60, End::JointEnd));
        // A single row with metal on both sides shows that the joint continues there.
        let whole = cut(&rows, 60, Stop::Rim, 50.0, 0, |i| i < 109).unwrap();
        assert_eq!((whole.rows, whole.end), (rows.len(), End::LeftImage));
    }

    #[test]
    fn an_end_is_placed_between_rows() {
        for level in [0, 1, 3] {
            for part in [0.1, 0.4, 0.5, 0.8] {
                let mut rows = rows(&[(60, true), (60, false)]);
                rows[60].own_depth = 30.0 * part;
                let found = cut(&rows, 60, Stop::Gap, 50.0, level, |_| true).unwrap();
                assert_eq!(found.end, End::JointEnd);
                assert!((found.rows as f32 + found.beyond - 60.0 - part).abs() < 0.01, "{level} {part}");
            }
        }
    }
}
