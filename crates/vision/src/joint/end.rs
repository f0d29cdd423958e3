use super::End;
use super::midline::Found;
use super::trail::Stop;

/// Rows about the last one seen among which the end is looked for.
const ABOUT: usize = 40;
/// A row's depth tells at most this much of the joint's, either way.
const MOST: f32 = 1.0;
/// Pixels to either side of an end that it is placed between rows by, one row at least: as far as it is out of focus.
const NEAR: usize = 3;
/// Rows that tell a depth.
const SEVERAL: usize = 5;
/// Rows before and after an end that tell the depth there.
const LEVEL: usize = 14;
/// Rows before an end that are seen.
const BEFORE: usize = 24;

/// What is behind an end is less than this part as deep.
const CLEAR: f32 = 0.5;
/// Part of the longest gap that tells an end from a tack before the rim.
const TOLD: f32 = 0.5;

/// How much of the way is the joint's, and how it ends.
pub(super) struct Cut {
    pub(super) rows: usize,
    pub(super) end: End,
    /// The end from half a row after the last one on, rows.
    pub(super) beyond: f32,
}

/// Takes off what was coasted over last, and tells an end of the joint from its loss; none if nothing is seen. `gap`: rows of
/// the longest gap.
pub(super) fn cut(
    rows: &[Found],
    (solid, stop): (usize, Stop),
    (gap, level): (f32, usize),
    is_whole: impl Fn(usize) -> bool,
) -> Option<Cut> {
    let seen = match stop {
        Stop::Gap => rows[..solid.min(rows.len())].iter().rposition(|r| r.seen)? + 1,
        Stop::Rim | Stop::Closed => last_whole(rows, is_whole)?,
    };
    let left = Cut { rows: seen, end: End::LeftImage, beyond: 0.0 };
    match stop {
        Stop::Closed => return Some(Cut { rows: rows.len(), end: End::Closed, beyond: 0.0 }),
        // Too little metal before the rim to tell an end from a tack.
        Stop::Rim if ((rows.len() - seen) as f32) < TOLD * gap => return Some(left),
        Stop::Rim | Stop::Gap => {}
    }
    // Where depths fall from the joint's to none: most above half of it before and most below it after.
    let depth = rows[seen.saturating_sub(ABOUT)].depth.max(1e-3);
    let (from, to) = (seen.saturating_sub(ABOUT), (seen + ABOUT).min(rows.len()));
    let (mut sum, mut greatest, mut at) = (0.0, 0.0, from);
    for (i, row) in rows[from..to].iter().enumerate() {
        sum += (row.own_depth / depth - 0.5).clamp(-MOST, MOST);
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

/// Behind the last row seen of a stretch of which both sides are somewhere in the picture: others are something at its rim.
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

/// How far beyond the begin of row `at` the joint reaches, rows: as far as all depth near the end together does, of what is
/// there before the end and after it; `reach`: rows to either side that are in part the joint's.
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
        let at_rim = cut(&rows, (60, Stop::Rim), (50.0, 0), |i| i < 95).unwrap();
        assert_eq!((at_rim.rows, at_rim.end), (60, End::JointEnd));
        // One row of it with metal on both sides: the joint goes on there.
        let whole = cut(&rows, (60, Stop::Rim), (50.0, 0), |i| i < 109).unwrap();
        assert_eq!((whole.rows, whole.end), (rows.len(), End::LeftImage));
    }

    #[test]
    fn an_end_is_placed_between_rows() {
        for level in [0, 1, 3] {
            for part in [0.1, 0.4, 0.5, 0.8] {
                let mut rows = rows(&[(60, true), (60, false)]);
                rows[60].own_depth = 30.0 * part;
                let found = cut(&rows, (60, Stop::Gap), (50.0, level), |_| true).unwrap();
                assert_eq!(found.end, End::JointEnd);
                assert!((found.rows as f32 + found.beyond - 60.0 - part).abs() < 0.01, "{level} {part}");
            }
        }
    }
}
