//! Second attempts at a lost joint, in other ways. Rows found so get no confidence.

use super::follow::{COARSE, Follower, Inside, NARROWER, known_width};
use super::levels::{DarkLine, Levels};
use super::trail::{Look, ROWS};
use super::{CONFIDENT, End, Row, Start, State, confidence};
use crate::frame::Frame;

/// A second attempt is accepted if the joint is this many times as long, ...
const LONGER: f32 = 1.25;
/// ... if this many times as many of the additional rows are seen as unseen, ...
const SEEN_ON: f32 = 1.5;
/// ... and, behind a reported end, if this much of them is seen without a gap, pixels.
pub(super) const STRETCH: f32 = 100.0;
/// Minimum distance of the last row from the border for a second attempt, pixels. If the joint left the image there,
/// the attempt must be seen for half of the remaining distance.
const UNSEEN: f32 = 16.0;
/// ... if the joint is this part as long: then the wider result was the joint's surroundings.
const AS_LONG: f32 = 0.9;
/// Minimum width of a joint on the top-hat of a level coarser than its own, pixels.
const NARROWEST: f32 = 2.5;
/// Levels and widths there at which a start is searched on top-hats.
const STARTS: [(usize, f32); 3] = [(1, 2.0), (1, 5.0), (2, 5.0)];
/// Confident rows are kept if the new path passes them within this distance: the larger of pixels and parts of the
/// width.
const SAME: (f32, f32) = (2.0, 0.25);
/// Rows over which the heading at a row is measured.
pub(super) const HEADING: usize = 12;

/// Lengths of the joint behind the start of a second attempt, pixels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lengths {
    /// Length before the attempt.
    pub(super) before: f32,
    /// Minimum length for the attempt to be accepted.
    pub(super) min: f32,
}

impl Follower {
    /// Makes second attempts if the joint may continue behind its end. `looks` are those at its start and at its last
    /// strip.
    pub(super) fn try_again(&mut self, frame: &Frame, start: &Start, inside: &Inside, looks: [Look; 2]) {
        let look = looks[0];
        // Salt noise fills the squares of fine levels; on coarse ones it is averaged over many pixels.
        let level = top_hat_level(&look);
        let coarser = look.width_in_frame() >= NARROWEST * (2 << level) as f32;
        let goes_on = self.try_on_top_hat(frame, start, inside, looks, level)
            || coarser && self.try_on_top_hat(frame, start, inside, looks, level + 1);
        if self.try_straight_on(frame, inside, &look) || goes_on {
            return;
        }
        if self.joint.end == End::Lost && look.level >= COARSE && known_width(start).is_none() {
            // The first result may be a dark strip that contains the joint.
            self.narrower = NARROWER * look.width_in_frame();
            let length = way(&self.joint.rows);
            self.follow_again(frame, start, inside, Lengths { before: length, min: AS_LONG * length });
            self.narrower = f32::INFINITY;
        }
    }

    /// Follows from a start without a visible joint, on top-hats without the edges of light: the joint may begin on
    /// such an edge.
    pub(super) fn try_start_on_top_hat(&mut self, frame: &Frame, start: &Start, inside: &Inside) {
        let coarsest = Levels::coarsest(frame);
        for (level, width) in STARTS.into_iter().filter(|(level, _)| *level <= coarsest) {
            self.levels.cover(frame, level, DarkLine { width, contrast: f32::INFINITY });
            let start = Start { width: Some(width * (1 << level) as f32), ..*start };
            let found = self.follow_again(frame, &start, inside, Lengths { before: 0.0, min: STRETCH });
            self.levels.uncover();
            if found {
                // The end is not reported, as no row is confident.
                self.joint.end = End::Lost;
                return;
            }
        }
    }

    /// Follows on the top-hat of a level, without the edges of light and tacks; returns true if the joint continues
    /// there.
    fn try_on_top_hat(
        &mut self,
        frame: &Frame,
        start: &Start,
        inside: &Inside,
        [look, last]: [Look; 2],
        level: usize,
    ) -> bool {
        let length = way(&self.joint.rows);
        let unseen = to_rim(&self.joint.rows, inside);
        let least = match self.joint.end {
            End::Closed => return false,
            End::JointEnd if self.is_sure_end(&last) => return false,
            _ if unseen < rim(&look) => return false,
            End::Lost | End::JointEnd => (LONGER * length).min(length + 0.5 * unseen),
            End::LeftImage => length + 0.5 * unseen,
        };
        // Starts at the last confident row, less the length of a strip.
        let rows = &self.joint.rows;
        let from = last_sure(rows).map_or(0, |last| last.saturating_sub(ROWS << (level - look.level)));
        let before = rows.get(..=from).map_or(0.0, way);
        let start = start_at(rows, from).unwrap_or(*start);
        let lengths = Lengths { before: length - before, min: least - before };
        self.follow_on_top_hat(frame, &start, inside, &look, level, lengths) && self.keep_sure(usize::MAX)
    }

    /// Follows as [`Self::follow_again`] does, on the top-hat of a level.
    pub(super) fn follow_on_top_hat(
        &mut self,
        frame: &Frame,
        start: &Start,
        inside: &Inside,
        look: &Look,
        level: usize,
        lengths: Lengths,
    ) -> bool {
        if level > Levels::coarsest(frame) {
            return false;
        }
        let width = look.width_in_frame();
        self.levels.cover(frame, level, DarkLine { width: width / (1 << level) as f32, contrast: look.contrast });
        let found = self.follow_again(frame, &Start { width: Some(width), ..*start }, inside, lengths);
        self.levels.uncover();
        found
    }

    /// Returns true if a row near the end is confident and uniform metal follows; `last` is the look there.
    fn is_sure_end(&self, last: &Look) -> bool {
        let rows = &self.joint.rows;
        let is_sure = last_sure(rows).is_some_and(|last| last + HEADING >= rows.len());
        is_sure && self.midline.is_plain_behind(rows.len(), last.contrast)
    }

    /// Follows again from a start. The previous result is restored unless the joint is seen for the minimum length and
    /// enough of the additional rows are seen.
    fn follow_again(&mut self, frame: &Frame, start: &Start, inside: &Inside, lengths: Lengths) -> bool {
        std::mem::swap(&mut self.joint, &mut self.before);
        let look = self.follow_in(frame, start, inside, lengths.min);
        let Lengths { before, min } = lengths;
        let stretch = if self.before.end == End::JointEnd { STRETCH.min(min - before) } else { 0.0 };
        if look.is_none() || way(&self.joint.rows) < min || !is_seen_beyond(&self.joint.rows, before, stretch) {
            std::mem::swap(&mut self.joint, &mut self.before);
            return false;
        }
        confidence::doubtful(&mut self.joint.rows, 0);
        if self.joint.end == End::LeftImage && self.before.end != End::LeftImage {
            // An exit from the frame is not reported, as no row is confident.
            self.joint.end = End::Lost;
        }
        true
    }

    /// Prepends the first `count` rows of the previous result, up to the last confident one that the new rows pass.
    /// Restores the previous result and returns false if it has confident rows but the new rows pass none of them.
    pub(super) fn keep_sure(&mut self, count: usize) -> bool {
        let (before, now) = (&mut self.before.rows, &mut self.joint.rows);
        let passed = |sure: &Row| {
            let nearest = now.iter().map(|row| sure.away(row)).enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
            nearest.filter(|(_, off)| *off < same_within(sure)).map(|(nearest, _)| nearest)
        };
        let first = &before[..count.min(before.len())];
        if last_sure(first).is_none() {
            return true;
        }
        let sure = first.iter().enumerate().rev().filter(|(_, row)| row.confidence >= CONFIDENT);
        let found = sure.take(HEADING).find_map(|(last, row)| Some((last, passed(row)?)));
        std::mem::swap(before, now);
        let Some((last, nearest)) = found else {
            self.joint.end = self.before.end;
            return false;
        };
        now.truncate(last + 1);
        now.extend_from_slice(&before[nearest + 1..]);
        true
    }
}

/// Returns the level for a top-hat; on the frame itself it would be slow.
pub(super) fn top_hat_level(look: &Look) -> usize {
    look.level.max(1)
}

/// Returns the distance from the border within which a row counts as at the border, pixels.
pub(super) fn rim(look: &Look) -> f32 {
    UNSEEN.max(look.width_in_frame())
}

/// Returns the last row's distance from the border, pixels.
pub(super) fn to_rim(rows: &[Row], inside: &Inside) -> f32 {
    rows.last().map_or(f32::INFINITY, |row| inside.to_rim([row.x, row.y]))
}

/// Returns the distance within which a path passes through a row of the same joint, pixels.
pub(super) fn same_within(row: &Row) -> f32 {
    SAME.0.max(SAME.1 * row.width)
}

pub(super) fn last_sure(rows: &[Row]) -> Option<usize> {
    rows.iter().rposition(|row| row.confidence >= CONFIDENT)
}

/// Returns row `from` as a start; `None` for the first [`HEADING`] rows, whose heading is unknown.
pub(super) fn start_at(rows: &[Row], from: usize) -> Option<Start> {
    let (row, before) = (rows.get(from)?, rows.get(from.checked_sub(HEADING)?)?);
    Some(Start { x: row.x, y: row.y, direction: (row.y - before.y).atan2(row.x - before.x), width: None })
}

/// Returns true if enough of the rows beyond `length` are seen, and a `stretch` of them without a gap, pixels.
fn is_seen_beyond(rows: &[Row], length: f32, stretch: f32) -> bool {
    let (mut at, mut seen, mut unseen, mut run, mut longest) = (0.0, 0, 0, 0.0, 0.0f32);
    for pair in rows.windows(2) {
        let step = pair[0].away(&pair[1]);
        at += step;
        if at <= length {
            continue;
        }
        if pair[1].state == State::Seen {
            seen += 1;
            run += step;
            longest = longest.max(run);
        } else {
            unseen += 1;
            run = 0.0;
        }
    }
    seen as f32 >= SEEN_ON * unseen as f32 && longest >= stretch
}

/// Returns the length of the path up to its last seen row, pixels.
pub(super) fn way(rows: &[Row]) -> f32 {
    let seen = rows.iter().rposition(|row| row.state == State::Seen).map_or(0, |last| last + 1);
    rows[..seen].windows(2).map(|pair| pair[0].away(&pair[1])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::testing::along;

    /// Rows a pixel apart along a straight path of legs that are seen or not.
    fn straight(legs: &[(usize, bool)]) -> Vec<Row> {
        along(&legs.iter().map(|(count, seen)| (*count, 0.0, seen.then_some(false))).collect::<Vec<_>>(), 4.0)
    }

    #[test]
    fn what_goes_on_is_mostly_seen_and_behind_an_end_without_a_gap() {
        for (legs, goes_on, behind_an_end) in [
            (&[(100, true), (60, false), (120, true)][..], true, true),
            (&[(100, true), (60, false), (80, true)], false, false),
            (&[(100, true), (40, false), (70, true), (5, false), (70, true)], true, false),
            (&[(100, true), (110, true)], true, true),
            (&[(100, true)], true, false),
        ] {
            let rows = straight(legs);
            assert_eq!(is_seen_beyond(&rows, 99.0, 0.0), goes_on, "{legs:?}");
            assert_eq!(is_seen_beyond(&rows, 99.0, STRETCH), behind_an_end, "{legs:?}");
        }
        assert!((way(&straight(&[(100, true), (60, false), (120, true), (30, false)])) - 279.0).abs() < 1e-3);
    }
}
