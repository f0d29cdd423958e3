//! Detection of the joint in a strip: in the present light and in another, straight on and aside.

use super::{Known, Look, ROWS, SPIKY, Trail};
use crate::joint::axis::{Axis, Station};
use crate::joint::levels::Picture;
use crate::joint::make_room;
use crate::joint::strip::{MID, box_columns};

/// Cost per pixel of distance from the expected column, beyond the free ones, nats.
const AWAY: f32 = 1.5;
/// Maximum additional curvature of an unseen joint behind a long gap, rad/px; it is searched ...
const BENT_UNSEEN: f32 = 0.006;
/// ... in strips this many pixels apart, at most this many to either side, ...
const APART: f32 = 18.0;
const MAX_SIDES: f32 = 3.0;
/// ... whose score must exceed that straight on by this, nats ...
const ASIDE: f32 = 6.0;
/// ... and which must show the joint in this many rows.
const FOUND: usize = 8;
/// Factors of the joint's depth tried after a step of the light.
const OTHER_LIGHT: [f32; 4] = [0.5, 2.0, MIN_LIGHT, 4.0];
const MIN_LIGHT: f32 = 0.25;
/// Maximum increase of the grey value in the middle of a joint whose depth changes, as a part of its depth.
const LIKE_FLOOR: f32 = 0.4;

/// Minimum rows of a strip that show a joint whose depth changes. A tack may hide the others, which is much of a strip
/// on coarse levels.
fn least(level: usize) -> usize {
    if level > SPIKY { ROWS / 2 } else { 3 * ROWS / 4 }
}

/// Rows per column of sideways movement, at least, of a joint detected anew behind a gap or in another light.
const STEADY: usize = 6;

/// Minimum number of rows that show the joint.
#[derive(Debug, Clone, Copy)]
pub(super) struct MinRows {
    pub(super) shown: usize,
    /// Number of the strip's first rows that count.
    pub(super) among: usize,
}

impl Trail {
    /// Detects the joint in the strip about a point of the trail; returns the score of its best path.
    pub(super) fn see(&mut self, picture: &Picture, axis: &Axis, from: f32, look: &mut Look, gap: usize) -> f32 {
        self.unroll(picture, axis, from, ROWS, look);
        self.see_unrolled(look, gap)
    }

    pub(super) fn unroll(&mut self, picture: &Picture, axis: &Axis, from: f32, rows: usize, look: &Look) {
        self.strip.unroll_nearest(picture, axis.stations(-from, rows));
        self.strip.measure(look.width, look.most(look.contrast));
        self.strip.noise = look.noise;
    }

    pub(super) fn see_unrolled(&mut self, look: &mut Look, gap: usize) -> f32 {
        let score = self.find(look.contrast, 1.5 + 0.15 * gap as f32);
        self.judge(look.contrast);
        if 2 * self.count() >= ROWS {
            look.noise_was_learned = !look.noise_was_learned;
            if look.noise_was_learned {
                let noise = self.strip.noise_beside(&self.path, look.line());
                look.noise += 0.5 * (noise.clamp(0.6 * look.noise, 1.5 * look.noise) - look.noise);
            }
            return score;
        }
        self.see_in_other_light(look, 1.5 + 0.15 * gap as f32, score)
    }

    /// Detects the joint at another depth, as its depth steps with the light: a line as dark as the joint but less deep
    /// is the joint too. `score` is that of the path in the unchanged light.
    fn see_in_other_light(&mut self, look: &mut Look, free: f32, score: f32) -> f32 {
        self.usual.0.clone_from(&self.path);
        self.usual.1.clone_from(&self.seen);
        self.find_deepest();
        for contrast in OTHER_LIGHT.map(|part| part * look.contrast) {
            if self.strip.shows_at_most(&self.deepest, contrast, ROWS) < least(look.level) {
                continue;
            }
            let score = self.find(contrast, free);
            self.judge(contrast);
            if self.count() >= least(look.level)
                && self.is_steady()
                && look.floor.is_none_or(|floor| self.floor(look.width) < floor + LIKE_FLOOR * look.contrast)
            {
                look.contrast = contrast;
                return score;
            }
        }
        self.path.clone_from(&self.usual.0);
        self.seen.clone_from(&self.usual.1);
        score
    }

    /// Returns true if no path of the strip can show the joint, in any light, in enough rows to go aside for.
    fn is_empty(&mut self, look: &Look) -> bool {
        !self.may_show(look, MinRows { shown: least(look.level), among: ROWS })
            && self.strip.shows_at_most(&self.deepest, look.contrast, ROWS) < FOUND
    }

    /// Returns false if no path of the strip shows the joint in enough rows, in any light.
    pub(super) fn may_show(&mut self, look: &Look, min: MinRows) -> bool {
        self.find_deepest();
        // Rows that show a deep joint also show a less deep one.
        self.strip.shows_at_most(&self.deepest, MIN_LIGHT * look.contrast, min.among) >= min.shown
    }

    fn find_deepest(&mut self) {
        self.strip.find_deepest(&mut self.deepest);
    }

    /// Reserves capacity, so that later frames do not allocate.
    pub(super) fn make_room_to_see(&mut self) {
        make_room(&mut self.usual.0, ROWS);
        make_room(&mut self.usual.1, ROWS);
        make_room(&mut self.deepest, ROWS);
    }

    /// Returns the mean grey value along the path where the joint is seen.
    pub(super) fn floor(&self, width: f32) -> f32 {
        let (columns, half) = (box_columns(width) as f32, box_columns(width) / 2);
        let seen = self.path.iter().zip(&self.strip.grey).zip(&self.seen).filter(|(_, seen)| **seen);
        let (sum, count) = seen.fold((0.0, 0.0), |(sum, count), ((j, row), _)| {
            (sum + row[j - half..=j + half].iter().sum::<f32>() / columns, count + 1.0)
        });
        sum / count
    }

    /// Returns true if the path moves sideways no more than a joint does.
    pub(super) fn is_steady(&self) -> bool {
        STEADY * self.path.windows(2).map(|p| p[0].abs_diff(p[1])).sum::<usize>() <= ROWS
    }

    /// Detects the joint after a gap on the most likely of several axes: it may have bent unseen since it was last
    /// known. Returns that axis.
    pub(super) fn see_across(
        &mut self,
        picture: &Picture,
        last: Known,
        from: f32,
        look: &mut Look,
        gap: usize,
    ) -> Axis {
        let Known { axis: known, gone } = last;
        let most = known.curvature.abs() + BENT_UNSEEN;
        let sides = (0.5 * most * gone * gone / APART).ceil().min(MAX_SIDES);
        let bent = |number: f32| {
            let curvature = if sides > 0.0 { most * number / sides } else { 0.0 };
            let Station { at, tangent } = Axis { curvature, ..known }.station(gone);
            Axis { at, heading: tangent[1].atan2(tangent[0]), curvature: 0.0 }
        };
        let mut best = (f32::MIN, known);
        for side in 1..=2 * sides as usize {
            // Order from the middle outwards.
            let axis = bent((side as f32 / 2.0).ceil() * if side % 2 == 0 { 1.0 } else { -1.0 });
            self.unroll(picture, &axis, from, ROWS, look);
            if self.is_empty(look) {
                continue;
            }
            let score = self.see_unrolled(&mut look.clone(), gap) - ASIDE;
            if self.count() >= FOUND && score > best.0 {
                best = (score, axis);
            }
        }
        let (straight, before) = (bent(0.0), *look);
        if self.see(picture, &straight, from, look, gap) >= best.0 {
            return straight;
        }
        *look = before;
        self.see(picture, &best.1, from, look, gap);
        best.1
    }

    /// Returns the number of rows of the strip that show the joint.
    pub(super) fn count(&self) -> usize {
        self.seen.iter().filter(|s| **s).count()
    }

    pub(super) fn find(&mut self, contrast: f32, free: f32) -> f32 {
        let cost = |j: usize| AWAY * (j.abs_diff(MID) as f32 - free).max(0.0);
        self.lattice.best(&self.strip, |_| contrast, cost, &mut self.path)
    }

    /// Determines which rows of the strip show the joint.
    pub(super) fn judge(&mut self, contrast: f32) {
        self.strip.shows(&self.path, |_| contrast, &mut self.seen);
    }
}
