//! Turns too sharp for a joint, at the rim of a tack or at a junction, are left again: the joint may continue straight
//! behind the object that hides it.

use super::follow::{Follower, Hidden, Inside};
use super::second_attempt::{HEADING, Lengths, STRETCH, last_sure, rim, start_at, to_rim, top_hat_level, way};
use super::trail::{Look, ROWS};
use super::{End, Row, State, bend};
use crate::frame::Frame;

/// Maximum turn of a joint beyond its own bend, rad.
const CORNER: f32 = 0.45;
/// Rows before and after a corner among which it is the sharpest: next to it only a part of an arm lies behind it.
const NEAR: usize = 15;
/// Corners tried, and corners tried if the joint ends within the frame.
const CORNERS: usize = 1;
const CORNERS_WITHIN: usize = 4;
/// Rows before a corner in which the path already turns aside.
const BEFORE: usize = 8;
/// Maximum part of unseen rows straight on, without the stretch behind the corner.
const MAX_UNSEEN: f32 = 0.05;

impl Follower {
    /// Follows straight on, on a top-hat without the edges of light, from a turn too sharp for a joint. Tries
    /// unconfident rows, or all rows if the joint ends within the frame. Returns true if the joint continues there.
    pub(super) fn try_straight_on(&mut self, frame: &Frame, inside: &Inside, look: &Look) -> bool {
        let rows = &self.joint.rows;
        let (corners, from) = match self.joint.end {
            End::Closed => return false,
            End::Lost | End::JointEnd if to_rim(rows, inside) >= rim(look) => (CORNERS_WITHIN, 0),
            _ => (CORNERS, last_sure(rows).unwrap_or(0)),
        };
        let mut from = from.max(bend::REACH);
        for _ in 0..corners {
            let Some(corner) = next_corner(&self.joint.rows, from) else { return false };
            if self.go_straight_on(frame, inside, look, corner.saturating_sub(BEFORE)) {
                return true;
            }
            from = corner + 1;
        }
        false
    }

    /// Follows straight on from row `corner`; returns true if the joint continues there, to another place than before.
    fn go_straight_on(&mut self, frame: &Frame, inside: &Inside, look: &Look, corner: usize) -> bool {
        let (rows, level) = (&self.joint.rows, top_hat_level(look));
        let from = corner.saturating_sub(ROWS << (level - look.level)).max(HEADING);
        let Some(start) = start_at(rows, from).filter(|_| from < corner) else { return false };
        let length = way(&rows[from..=corner]);
        let place = (length / (1 << level) as f32) as usize;
        // A joint that ends within the frame may continue behind its end.
        let aside = if to_rim(rows, inside) < rim(look) { corner } else { rows.len() };
        self.hidden = Some(Hidden { place, aside });
        let lengths = Lengths { before: length, min: length + STRETCH };
        let found = self.follow_on_top_hat(frame, &start, inside, look, level, lengths);
        self.hidden = None;
        if !found {
            return false;
        }
        // Accepted if it reaches the border or the previous length, ends elsewhere, and is almost all seen.
        let (rows, before) = (&self.joint.rows, &self.before.rows);
        let is_as_far = to_rim(rows, inside) < rim(look) || way(rows) >= way(&before[from..]);
        let apart = rows.last().zip(before.last()).map_or(0.0, |(a, b)| a.away(b));
        let is_seen = unseen_elsewhere(rows) as f32 <= MAX_UNSEEN * rows.len() as f32;
        if !(is_as_far && is_seen && apart >= rim(look)) {
            std::mem::swap(&mut self.joint, &mut self.before);
            return false;
        }
        // Confident rows behind the corner belonged to another line.
        self.keep_sure(corner + 1)
    }
}

/// Returns the first row from `from` on ([`bend::REACH`] at least) with a turn too sharp for a joint that is the
/// sharpest near it.
fn next_corner(rows: &[Row], from: usize) -> Option<usize> {
    let sharpness = |i: usize| bend::sharpness(|k| [rows[k].x, rows[k].y], i);
    let to = rows.len().saturating_sub(bend::REACH);
    (from..to).find(|i| {
        let sharp = sharpness(*i);
        let mut near = i.saturating_sub(NEAR).max(bend::REACH)..to.min(i + NEAR);
        sharp > CORNER && near.all(|other| sharpness(other) <= sharp)
    })
}

/// Returns the number of unseen rows, except for the longest stretch, where the joint is hidden.
fn unseen_elsewhere(rows: &[Row]) -> usize {
    let unseen =
        rows.chunk_by(|a, b| a.state == b.state).filter(|run| run[0].state == State::Coasted).map(<[Row]>::len);
    let (all, longest) = unseen.fold((0, 0), |(all, longest), run| (all + run, longest.max(run)));
    all - longest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::testing::along;

    #[test]
    fn a_corner_is_where_it_turns_most() {
        for (turn, corner) in [(0.0, None), (0.3, None), (0.7, Some(90)), (-1.2, Some(90))] {
            let rows = along(&[(90, 0.0, Some(true)), (80, turn, Some(false))], 4.0);
            let found = next_corner(&rows, bend::REACH);
            assert_eq!(found.is_some(), corner.is_some(), "{turn}: {found:?}");
            assert!(found.zip(corner).is_none_or(|(a, b)| a.abs_diff(b) <= 6), "{turn}: {found:?}");
        }
    }

    #[test]
    fn what_hides_the_joint_is_not_counted_as_unseen() {
        for (legs, unseen) in [
            (&[(50, true), (30, false), (60, true)][..], 0),
            (&[(50, true), (30, false), (60, true), (7, false), (20, true), (4, false)], 11),
            (&[(50, true)], 0),
        ] {
            let legs: Vec<_> = legs.iter().map(|(count, seen)| (*count, 0.0, seen.then_some(false))).collect();
            assert_eq!(unseen_elsewhere(&along(&legs, 4.0)), unseen, "{legs:?}");
        }
    }
}
