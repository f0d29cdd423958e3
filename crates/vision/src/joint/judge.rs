use super::bend;
use super::midline::Found;
use super::{CONFIDENT, End, Row, State};
use std::ops::Range;

// Each of these alone makes a row half confident.
/// Nats by which the path is likelier than any other.
const MARGIN: f32 = 10.0;
/// Nats by which a joint is likelier than none.
const STRENGTH: f32 = 5.0;
/// Standard error, pixels.
const ERROR: f32 = 0.56;
/// How unlike the rest of the joint.
const UNLIKE: f32 = 1.45;
/// Asymmetry of the valley, pixels.
const ASYMMETRY: f32 = 1.15;
/// How far a row is off the smooth line through others, beyond its standard error, pixels.
const BUMP: f32 = 1.5;

/// Rows that tell the way before and behind a gap ...
const HEADING: usize = 16;
/// ... and by how much it turns at most at its rims, rad, and for each pixel of it.
const KINK: f32 = 0.25;
const KINK_OVER: f32 = 0.006;
/// A narrow line that turns by so much in all at each of its gaps, in the mean, is scratches beside each other, rad.
const JUMPS: f32 = 0.2;
/// Stretches before and behind a gap are at least this part as deep as each other.
const AS_DEEP: f32 = 0.5;
/// A stretch is much longer than another one if it is longer than so many of it.
const MUCH_LONGER: usize = 3;
/// A scratch that meets another one turns so much more sharply than its own bend, rad.
const SHARP: f32 = 0.2;
/// Between sure rows a joint turns by more than this only in a bend without a corner sharper than that, rad.
const TURNED: f32 = 0.4;
const CORNER: f32 = 0.6;
/// A row that is narrower than this part of the sure ones' mean shows a part of the joint.
const NARROWED: f32 = 0.62;
/// Rows next to one across which the light steps: its edge may lie beside the joint there, or be taken for it.
const STEP: usize = 16;

/// How sure a row is by itself, `scale` pixels of the frame to one of its level.
pub(super) fn row(found: &Found, scale: f32, whole: bool) -> f32 {
    if !found.seen || !whole {
        return 0.0;
    }
    let doubts = [
        MARGIN / found.margin.max(1e-3),
        STRENGTH / found.strength.max(1e-3),
        found.error * scale / ERROR,
        found.unlike / UNLIKE,
        found.asymmetry * scale / ASYMMETRY,
        (found.bump - found.error).max(0.0) * scale / BUMP,
    ];
    // The greatest doubt counts most.
    1.0 / (1.0 + doubts.iter().map(|d| d.powi(3)).sum::<f32>())
}

/// Confidence of rows that are seen but not sure, at most.
const UNSURE: f32 = 0.4;
/// A line that ends and of which less than this is seen may be a scratch, pixels ...
const SHORT: f32 = 170.0;
/// ... and one that is narrow, if less than this is.
const SHORT_AND_NARROW: f32 = 210.0;
/// Of a joint at least this part is seen; scratches one after the other have longer gaps.
const MOSTLY_SEEN: f32 = 0.7;
/// Fewer than this part of the rows that are seen are chance.
const FEW: f32 = 0.33;
/// Fewer rows than this that are sure among others that are not are chance.
const LONE: usize = 9;
/// Scratches are narrower than this, pixels.
const NARROW: f32 = 3.5;

/// Rows next to a gap or a loss that are not sure: what is seen there is in part beyond it.
const RIM: usize = 13;
/// The same behind the start.
const START_RIM: usize = 6;
/// The same where the joint is seen to end.
const END_RIM: usize = 2;

/// Takes the confidence from rows from `solid` on, and from all if too few of them are seen.
pub(super) fn doubtful(rows: &mut [Row], solid: usize) {
    let seen = rows.iter().filter(|r| r.state == State::Seen).count();
    let from = if (seen as f32) < MOSTLY_SEEN * rows.len() as f32 { 0 } else { solid.min(rows.len()) };
    rows[from..].iter_mut().for_each(unsure);
}

/// Takes the confidence from a few rows that have it among others that do not: they look like the joint by chance.
pub(super) fn lone(rows: &mut [Row]) {
    let sure = |row: &Row| row.confidence >= CONFIDENT;
    let runs = rows.chunk_by_mut(|a, b| sure(a) == sure(b));
    runs.filter(|run| run.len() < LONE).for_each(|run| run.iter_mut().for_each(unsure));
}

/// Takes the confidence from all rows if few of those that are seen have it: of what is no joint some rows look like one by chance.
pub(super) fn few(rows: &mut [Row]) {
    let seen = rows.iter().filter(|r| r.state == State::Seen).count();
    let sure = rows.iter().filter(|r| r.confidence >= CONFIDENT).count();
    if (sure as f32) < FEW * seen as f32 {
        rows.iter_mut().for_each(unsure);
    }
}

/// Takes the confidence from rows next to gaps and ends.
pub(super) fn rims(rows: &mut [Row], end: End, on_joint: bool) {
    let count = rows.len();
    let sure_from = if on_joint || end == End::Closed { 0 } else { START_RIM };
    rows[..sure_from.min(count)].iter_mut().for_each(unsure);
    // What is found again may be something else: as many rows as were missed, in this gap and before, are not sure, unless it
    // goes on for longer.
    let (mut from, mut missed) = (0, 0);
    while let Some(gap) = (from..count).find(|i| rows[*i].state == State::Coasted) {
        let seen = (gap..count).find(|i| rows[*i].state == State::Seen).unwrap_or(count);
        from = (seen..count).find(|i| rows[*i].state == State::Coasted).unwrap_or(count);
        missed = RIM.max(missed) + seen - gap;
        let doubted = if from - seen >= missed { RIM } else { missed };
        missed = missed.saturating_sub(from - seen);
        rows[gap.saturating_sub(RIM)..gap].iter_mut().for_each(unsure);
        rows[seen..(seen + doubted).min(from)].iter_mut().for_each(unsure);
    }
    let rim = match end {
        End::JointEnd => END_RIM,
        End::Lost => RIM,
        End::LeftImage | End::Closed => 0,
    };
    if rim > 0 {
        rows[count.saturating_sub(rim)..].iter_mut().for_each(unsure);
    }
}

/// Takes the confidence from the stretches before and behind a gap at which the way turns more sharply than a joint may, or that
/// are not as deep as each other: one of them, the shorter if it is much shorter, is something else. And from all of a narrow line
/// that turns at each of its gaps.
pub(super) fn gaps(rows: &mut [Row], found: &[Found]) {
    let gap_from = |rows: &[Row], from: usize| {
        let missed = |i: &usize| rows[*i..].iter().take(RIM).all(|r| r.state == State::Coasted);
        (from..rows.len().saturating_sub(RIM)).find(missed).unwrap_or(rows.len())
    };
    let seen_from = |rows: &[Row], from: usize| (from..rows.len()).find(|i| rows[*i].state == State::Seen);
    let (mut turned, mut jumps) = (0.0, 0);
    let (mut before, mut gap) = (0, gap_from(rows, 0));
    while let Some(seen) = seen_from(rows, gap) {
        let until = gap_from(rows, seen);
        let (first, second) = (before..gap, seen..until);
        if !first.is_empty() {
            let turns = turns(rows, &first, &second);
            (turned, jumps) = (turned + turns[0] + turns[1], jumps + 1);
            if is_kinked(turns, rows[gap - 1], rows[seen]) || differ(found, (&first, &second)) {
                // What is much longer is the joint.
                let wrong = match (first.len(), second.len()) {
                    (a, b) if a > MUCH_LONGER * b => second,
                    (a, b) if b > MUCH_LONGER * a => first,
                    _ => before..until,
                };
                rows[wrong].iter_mut().for_each(unsure);
            }
        }
        (before, gap) = (seen, until);
    }
    if jumps > 1 && turned > JUMPS * jumps as f32 && is_narrow(rows) {
        rows.iter_mut().for_each(unsure);
    }
}

/// True if most of it is no wider than a scratch.
fn is_narrow(rows: &[Row]) -> bool {
    rows.iter().filter(|r| r.width < NARROW).count() > rows.len() / 2
}

/// True if the joint is much deeper in one stretch than in the other.
fn differ(found: &[Found], stretches: (&Range<usize>, &Range<usize>)) -> bool {
    let depth = |rows: &Range<usize>| {
        let seen = found[rows.clone()].iter().filter(|f| f.seen);
        let (sum, count) = seen.fold((0.0, 0.0), |(sum, count), f| (sum + f.own_depth, count + 1.0));
        sum / count
    };
    let (a, b) = (depth(stretches.0), depth(stretches.1));
    a.min(b) < AS_DEEP * a.max(b)
}

/// How much the way from one stretch over a gap into the next one turns at either, rad.
fn turns(rows: &[Row], first: &Range<usize>, second: &Range<usize>) -> [f32; 2] {
    let (last, next) = (rows[first.end - 1], rows[second.start]);
    let over = way(last, next);
    let into = way(rows[first.start.max(first.end.saturating_sub(HEADING))], last);
    let out = way(next, rows[(second.end - 1).min(second.start + HEADING)]);
    [bend::turn(into, over).abs(), bend::turn(over, out).abs()]
}

/// The way from one row to another.
fn way(from: Row, to: Row) -> [f32; 2] {
    [to.x - from.x, to.y - from.y]
}

/// True if either is too sharp for a joint, for a gap between these rows.
fn is_kinked(turns: [f32; 2], last: Row, next: Row) -> bool {
    let most = KINK + KINK_OVER * last.away(&next);
    turns.iter().any(|turn| *turn > most)
}

/// Takes the confidence from rows near a step of the light.
pub(super) fn steps(rows: &mut [Row], found: &[Found]) {
    for (i, _) in found.iter().enumerate().filter(|(_, f)| f.stepped) {
        let to = (i + STEP + 1).min(rows.len());
        rows[i.saturating_sub(STEP).min(to)..to].iter_mut().for_each(unsure);
    }
}

/// Takes the confidence from rows that are much narrower than sure ones are in the mean: an edge of light has cut off a part of the joint.
pub(super) fn narrowed(rows: &mut [Row]) {
    let sure = rows.iter().filter(|r| r.confidence >= CONFIDENT);
    let (sum, count) = sure.fold((0.0, 0.0), |(sum, count), row| (sum + row.width, count + 1.0));
    rows.iter_mut().filter(|r| r.width * count < NARROWED * sum).for_each(unsure);
}

fn unsure(row: &mut Row) {
    row.confidence = row.confidence.min(UNSURE);
}

/// Takes the confidence from what is behind a corner among rows that are not sure: where joints meet, another one was followed.
pub(super) fn corners(rows: &mut [Row]) {
    let is_sure = |row: &Row| row.confidence >= CONFIDENT;
    let mut from = 0;
    while let Some(unsure_from) = (from + 1..rows.len()).find(|i| is_sure(&rows[i - 1]) && !is_sure(&rows[*i])) {
        let Some(sure) = (unsure_from..rows.len()).find(|i| is_sure(&rows[*i])) else { return };
        let is_corner = |i| angle(rows, i) > CORNER;
        if turn_over(rows, unsure_from, sure) > TURNED && (unsure_from..sure).any(is_corner) {
            rows[sure..].iter_mut().for_each(unsure);
            return;
        }
        from = sure;
    }
}

/// Takes the confidence from a line of which no stretch without a long gap is longer than a scratch; true if the whole of it is
/// not.
pub(super) fn length(rows: &mut [Row], end: End) -> bool {
    if !matches!(end, End::JointEnd | End::Lost) {
        return false;
    }
    let narrow = is_narrow(rows);
    let (mut longest, mut whole, mut length, mut missed) = (0.0f32, 0.0, 0.0, 0);
    for i in 1..rows.len() {
        let pair = [rows[i - 1], rows[i]];
        if pair.iter().all(|r| r.state == State::Seen) {
            let ended = missed > RIM || narrow && is_angle(rows, i);
            let step = pair[0].away(&pair[1]);
            length = if ended { 0.0 } else { length } + step;
            (longest, whole, missed) = (longest.max(length), whole + step, 0);
        } else {
            missed += 1;
        }
    }
    let least = if narrow { SHORT_AND_NARROW } else { SHORT };
    // What does not begin at the start may be a scratch beside it, or several.
    let apart = rows.iter().take(RIM).all(|r| r.state == State::Coasted);
    let least = if apart { 2.0 * least } else { least };
    if longest < least {
        rows.iter_mut().for_each(unsure);
    }
    whole < least
}

/// True where the way before row `i` and the way behind it are straighter than the turn between them.
fn is_angle(rows: &[Row], i: usize) -> bool {
    angle(rows, i) > SHARP
}

/// The angle between the way before row `before` and that from row `from` on, rad.
fn turn_over(rows: &[Row], before: usize, from: usize) -> f32 {
    let last = rows.len() - 1;
    let into = way(rows[before.saturating_sub(1 + HEADING)], rows[before - 1]);
    bend::turn(into, way(rows[from], rows[(from + HEADING).min(last)])).abs()
}

/// By how much the way turns at row `i` beyond its bend before and behind it, rad.
fn angle(rows: &[Row], i: usize) -> f32 {
    if i < bend::REACH || i + bend::REACH >= rows.len() {
        return 0.0;
    }
    bend::sharpness(|k| [rows[k].x, rows[k].y], i)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::testing::along;

    fn sure(rows: &[Row]) -> usize {
        rows.iter().filter(|r| r.confidence >= CONFIDENT).count()
    }

    #[test]
    fn what_is_cut_off_by_an_edge_is_not_sure() {
        for (part, sure) in [(0.5, 80), (0.75, 90), (1.5, 90)] {
            let mut rows = along(&[(90, 0.0, Some(true))], 6.0);
            rows[30..40].iter_mut().for_each(|row| row.width *= part);
            narrowed(&mut rows);
            assert_eq!(rows.iter().filter(|row| row.confidence >= CONFIDENT).count(), sure, "{part}");
        }
    }

    #[test]
    fn a_few_sure_rows_among_others_are_chance() {
        let (yes, no) = (Some(true), Some(false));
        for (alone, left) in [(LONE - 1, 60), (LONE, 60 + LONE)] {
            for other in [no, None] {
                let mut rows = along(&[(30, 0.0, other), (alone, 0.0, yes), (20, 0.0, other), (60, 0.0, yes)], 6.0);
                lone(&mut rows);
                assert_eq!(sure(&rows), left, "{alone}");
            }
        }
    }

    #[test]
    fn behind_an_unsure_corner_nothing_is_sure() {
        let (yes, no) = (Some(true), Some(false));
        for (turn, left) in [(0.0, 120), (0.3, 120), (0.8, 60), (-0.8, 60)] {
            let mut rows = along(&[(60, 0.0, yes), (40, 0.0, no), (40, turn, no), (60, turn, yes)], 6.0);
            corners(&mut rows);
            assert_eq!(sure(&rows), left, "{turn}");
        }
        // A bend of the same turn, and a way that comes back to where it went.
        let bend: Vec<_> = (0..80).map(|i| (1, 0.01 * i as f32, no)).collect();
        let mut rows = along(&[&[(60, 0.0, yes)], &bend[..], &[(60, 0.8, yes)]].concat(), 6.0);
        corners(&mut rows);
        assert_eq!(sure(&rows), 120);
        let mut rows = along(&[(60, 0.0, yes), (40, 0.0, no), (40, 0.8, no), (40, -0.8, no), (60, 0.0, yes)], 6.0);
        corners(&mut rows);
        assert_eq!(sure(&rows), 120);
    }

    #[test]
    fn a_narrow_line_that_jumps_at_each_gap_is_scratches() {
        let (yes, found) = (Some(true), Found { seen: true, own_depth: 20.0, ..Found::default() });
        for (width, jump, left) in [(2.0, 0.0, 210), (2.0, 0.2, 0), (8.0, 0.2, 210)] {
            let gap = (30, jump, None);
            let mut rows = along(&[(70, 0.0, yes), gap, (70, 0.0, yes), gap, (70, 0.0, yes)], width);
            let all = vec![found; rows.len()];
            gaps(&mut rows, &all);
            assert_eq!(sure(&rows), left, "{width} {jump}");
        }
    }
}
