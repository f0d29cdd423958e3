use super::End;
use super::midline::Found;
use super::trail::Stop;

/// Rows about the last one seen among which the end is looked for.
const ABOUT: usize = 28;
/// A row's depth tells at most this much of the joint's, either way.
const MOST: f32 = 1.0;
/// Rows to either side of an end that it is placed between rows by.
const NEAR: usize = 5;
/// Rows before an end that are seen.
const BEFORE: usize = 24;

/// How much of the way is the joint's, and how it ends.
pub(super) struct Cut {
    pub(super) rows: usize,
    pub(super) end: End,
    /// The end from half a row after the last one on, rows.
    pub(super) beyond: f32,
}

/// Takes off what was coasted over last, and tells an end of the joint from its loss; none if nothing is seen.
pub(super) fn cut(rows: &[Found], solid: usize, stop: Stop) -> Option<Cut> {
    let within = if stop == Stop::Gap { solid } else { rows.len() };
    let seen = rows.get(..within)?.iter().rposition(|r| r.seen)? + 1;
    match stop {
        Stop::Closed => return Some(Cut { rows: rows.len(), end: End::Closed, beyond: 0.0 }),
        Stop::Rim => return Some(Cut { rows: seen, end: End::LeftImage, beyond: 0.0 }),
        Stop::Gap => {}
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
    // Between rows: as far as all depth near the end together reaches.
    let (first, last) = (at.saturating_sub(NEAR), (at + NEAR).min(rows.len()));
    let whole: f32 = rows[first..last].iter().map(|r| (r.own_depth / depth).clamp(-0.5, 1.5)).sum();
    let beyond = (first as f32 + whole - at as f32).clamp(-1.5, 1.5);
    let sure = rows[at.saturating_sub(BEFORE)..at].iter().filter(|r| r.seen).count();
    let after = &rows[at..];
    let count = after.len().max(1) as f32;
    let mean = after.iter().map(|r| r.own_depth).sum::<f32>() / count;
    let scatter = after.iter().map(|r| (r.own_depth - mean).powi(2)).sum::<f32>() / count;
    let clear = mean.abs() + 3.0 * (scatter / count).sqrt() < 0.4 * depth;
    let end = if clear && 4 * sure >= 3 * BEFORE { End::JointEnd } else { End::Lost };
    Some(Cut { rows: at, end, beyond })
}
