use super::bend;
use super::midline::Found;
use super::{CONFIDENT, End, Row, State};
use std::ops::Range;

// At the limit, each of these alone halves a row's confidence.
/// Log likelihood ratio of the path to the best path elsewhere, nats.
const MARGIN: f32 = 10.0;
/// Log likelihood ratio of a joint to no joint, nats.
const STRENGTH: f32 = 5.0;
/// Standard error, pixels.
const ERROR: f32 = 0.56;
/// Difference from the rest of the joint.
const UNLIKE: f32 = 1.45;
/// Asymmetry of the valley, pixels.
const ASYMMETRY: f32 = 1.15;
/// Offset of a row from the smooth line through others, beyond its standard error, pixels.
const BUMP: f32 = 1.5;

/// Rows over which the heading before and behind a gap is measured ...
const HEADING: usize = 16;
/// ... and the maximum turn at its rims, rad, and per pixel of it.
const KINK: f32 = 0.25;
const KINK_OVER: f32 = 0.006;
/// Mean turn per gap above which a narrow line is a row of scratches, rad.
const JUMPS: f32 = 0.2;
/// Minimum ratio of the depths of the stretches before and behind a gap.
const AS_DEEP: f32 = 0.5;
/// A stretch is much longer than another one above this ratio.
const MUCH_LONGER: usize = 3;
/// Turn beyond its own bend at which a scratch meets another one, rad.
const SHARP: f32 = 0.2;
/// Turn between confident rows above which a corner is searched, and the angle of such a corner, rad.
const TURNED: f32 = 0.4;
const CORNER: f32 = 0.6;
/// A row narrower than this part of the confident rows' mean width shows only a part of the joint.
const NARROWED: f32 = 0.62;
/// Rows next to a light step that lose confidence: its edge may lie beside the joint or be mistaken for it.
const STEP: usize = 16;

/// Returns the confidence of a single row. `scale`: pixels of the frame per pixel of the level.
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
    // The cubes make the largest doubt dominate.
    1.0 / (1.0 + doubts.iter().map(|d| d.powi(3)).sum::<f32>())
}

/// Maximum confidence of rows that are seen but doubtful.
const UNSURE: f32 = 0.4;
/// A line that ends may be a scratch if it is seen for less than this, pixels ...
const SHORT: f32 = 170.0;
/// ... or, if it is narrow, for less than this.
const SHORT_AND_NARROW: f32 = 210.0;
/// Minimum part of a joint that is seen; rows of scratches have longer gaps.
const MOSTLY_SEEN: f32 = 0.7;
/// Minimum part of confident rows among the seen ones; fewer are random.
const FEW: f32 = 0.33;
/// Minimum run of confident rows among others; shorter runs are random.
const LONE: usize = 9;
/// Maximum width of a scratch, pixels.
const NARROW: f32 = 3.5;

/// Rows next to a gap or a loss that lose confidence, as they partly show what lies beyond.
const RIM: usize = 13;
/// Rows behind the start that lose confidence.
const START_RIM: usize = 6;
/// Rows before a detected end that lose confidence.
const END_RIM: usize = 2;

/// Lowers the confidence of rows from `solid` on, and of all rows if too few of them are seen.
pub(super) fn doubtful(rows: &mut [Row], solid: usize) {
    let seen = rows.iter().filter(|r| r.state == State::Seen).count();
    let from = if (seen as f32) < MOSTLY_SEEN * rows.len() as f32 { 0 } else { solid.min(rows.len()) };
    rows[from..].iter_mut().for_each(unsure);
}

/// Lowers the confidence of short confident runs among other rows, which look like the joint by chance.
pub(super) fn lone(rows: &mut [Row]) {
    let sure = |row: &Row| row.confidence >= CONFIDENT;
    let runs = rows.chunk_by_mut(|a, b| sure(a) == sure(b));
    runs.filter(|run| run.len() < LONE).for_each(|run| run.iter_mut().for_each(unsure));
}

/// Lowers the confidence of all rows if few of the seen ones are confident: some rows of any texture look like a joint.
pub(super) fn few(rows: &mut [Row]) {
    let seen = rows.iter().filter(|r| r.state == State::Seen).count();
    let sure = rows.iter().filter(|r| r.confidence >= CONFIDENT).count();
    if (sure as f32) < FEW * seen as f32 {
        rows.iter_mut().for_each(unsure);
    }
}

/// Lowers the confidence of rows next to gaps and ends.
pub(super) fn rims(rows: &mut [Row], end: End, on_joint: bool) {
    let count = rows.len();
    let sure_from = if on_joint || end == End::Closed { 0 } else { START_RIM };
    rows[..sure_from.min(count)].iter_mut().for_each(unsure);
    // Rows behind a gap may belong to another line. As many of them as were missed so far lose confidence, unless the
    // stretch is longer than that.
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

/// Lowers the confidence of the stretches at a gap where the path turns too sharply or the depths differ too much. Only
/// the shorter one is affected if it is much shorter. A narrow line that turns at each of its gaps loses all
/// confidence.
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
            if is_kinked(turns, rows[gap - 1], rows[seen]) || differ(found, &first, &second) {
                // A much longer stretch is the joint.
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

/// Returns true if most rows are no wider than a scratch.
fn is_narrow(rows: &[Row]) -> bool {
    rows.iter().filter(|r| r.width < NARROW).count() > rows.len() / 2
}

/// Returns true if the joint is much deeper in one stretch than in the other.
fn differ(found: &[Found], first: &Range<usize>, second: &Range<usize>) -> bool {
    let depth = |rows: &Range<usize>| {
        let seen = found[rows.clone()].iter().filter(|f| f.seen);
        let (sum, count) = seen.fold((0.0, 0.0), |(sum, count), f| (sum + f.own_depth, count + 1.0));
        sum / count
    };
    let (a, b) = (depth(first), depth(second));
    a.min(b) < AS_DEEP * a.max(b)
}

/// Returns the turns at both rims of the gap between two stretches, rad.
fn turns(rows: &[Row], first: &Range<usize>, second: &Range<usize>) -> [f32; 2] {
    let (last, next) = (rows[first.end - 1], rows[second.start]);
    let over = way(last, next);
    let into = way(rows[first.start.max(first.end.saturating_sub(HEADING))], last);
    let out = way(next, rows[(second.end - 1).min(second.start + HEADING)]);
    [bend::turn(into, over).abs(), bend::turn(over, out).abs()]
}

fn way(from: Row, to: Row) -> [f32; 2] {
    [to.x - from.x, to.y - from.y]
}

/// Returns true if a turn is too sharp for a joint with a gap between these rows.
fn is_kinked(turns: [f32; 2], last: Row, next: Row) -> bool {
    let most = KINK + KINK_OVER * last.away(&next);
    turns.iter().any(|turn| *turn > most)
}

/// Lowers the confidence of rows near a light step.
pub(super) fn steps(rows: &mut [Row], found: &[Found]) {
    for (i, _) in found.iter().enumerate().filter(|(_, f)| f.stepped) {
        let to = (i + STEP + 1).min(rows.len());
        rows[i.saturating_sub(STEP).min(to)..to].iter_mut().for_each(unsure);
    }
}

/// Lowers the confidence of rows much narrower than the confident rows' mean: an edge of light has cut off a part of
/// the joint.
pub(super) fn narrowed(rows: &mut [Row]) {
    let sure = rows.iter().filter(|r| r.confidence >= CONFIDENT);
    let (sum, count) = sure.fold((0.0, 0.0), |(sum, count), row| (sum + row.width, count + 1.0));
    rows.iter_mut().filter(|r| r.width * count < NARROWED * sum).for_each(unsure);
}

fn unsure(row: &mut Row) {
    row.confidence = row.confidence.min(UNSURE);
}

/// Lowers the confidence behind a corner among unconfident rows: at a junction another joint was followed.
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

/// Lowers the confidence of a line without a stretch longer than a scratch. Returns true if the whole line is shorter
/// than a scratch too.
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
    // A line that begins behind the start may be a scratch beside it, or several.
    let apart = rows.iter().take(RIM).all(|r| r.state == State::Coasted);
    let least = if apart { 2.0 * least } else { least };
    if longest < least {
        rows.iter_mut().for_each(unsure);
    }
    whole < least
}

/// Returns true if the path turns at row `i` more sharply than by its own bend.
fn is_angle(rows: &[Row], i: usize) -> bool {
    angle(rows, i) > SHARP
}

/// Returns the angle between the path before row `before` and the path from row `from` on, rad.
fn turn_over(rows: &[Row], before: usize, from: usize) -> f32 {
    let last = rows.len() - 1;
    let into = way(rows[before.saturating_sub(1 + HEADING)], rows[before - 1]);
    bend::turn(into, way(rows[from], rows[(from + HEADING).min(last)])).abs()
}

/// Returns the turn of the path at row `i` beyond its bend before and behind, rad.
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
        // A bend of the same turn, and a path that returns to its direction.
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
