use super::midline::Found;
use super::{End, Row, State};

// Each of these alone makes a row half confident.
/// Nats by which the path is likelier than any other.
const MARGIN: f32 = 12.0;
/// Nats by which a joint is likelier than none.
const STRENGTH: f32 = 5.0;
/// Standard error, pixels.
const ERROR: f32 = 0.52;
/// How unlike the rest of the joint.
const UNLIKE: f32 = 1.45;
/// Asymmetry of the valley, pixels.
const ASYMMETRY: f32 = 1.25;
/// How far a row is off the smooth line through others, beyond its standard error, pixels.
const BUMP: f32 = 1.5;

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
const SHORT: f32 = 130.0;
/// ... and one that is narrow, if less than this is.
const SHORT_AND_NARROW: f32 = 210.0;
/// Of a joint at least this part is seen; scratches one after the other have longer gaps.
const MOSTLY_SEEN: f32 = 0.7;
/// Scratches are narrower than this, pixels.
const NARROW: f32 = 3.5;

/// Rows next to a gap or a loss that are not sure: what is seen there is in part beyond it.
const RIM: usize = 10;
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

/// Takes the confidence from rows near a step of the light.
pub(super) fn steps(rows: &mut [Row], found: &[Found]) {
    for (i, _) in found.iter().enumerate().filter(|(_, f)| f.stepped) {
        let to = (i + STEP + 1).min(rows.len());
        rows[i.saturating_sub(STEP).min(to)..to].iter_mut().for_each(unsure);
    }
}

fn unsure(row: &mut Row) {
    row.confidence = row.confidence.min(UNSURE);
}

/// Takes the confidence from a line of which no stretch without a long gap is longer than a scratch.
pub(super) fn length(rows: &mut [Row], end: End) {
    let (mut longest, mut length, mut missed) = (0.0f32, 0.0, 0);
    for pair in rows.windows(2) {
        if pair.iter().all(|r| r.state == State::Seen) {
            length = if missed > RIM { 0.0 } else { length } + (pair[1].x - pair[0].x).hypot(pair[1].y - pair[0].y);
            (longest, missed) = (longest.max(length), 0);
        } else {
            missed += 1;
        }
    }
    let narrow = rows.iter().filter(|r| r.width < NARROW).count() > rows.len() / 2;
    let least = if narrow { SHORT_AND_NARROW } else { SHORT };
    if matches!(end, End::JointEnd | End::Lost) && longest < least {
        rows.iter_mut().for_each(unsure);
    }
}
