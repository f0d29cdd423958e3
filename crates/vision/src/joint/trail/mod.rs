mod detection;
mod leap;

use crate::joint::axis::{Axis, Station, length};
use crate::joint::lattice::{Lattice, column_about};
use crate::joint::levels::{DarkLine, Picture};
use crate::joint::make_room;
use crate::joint::parabola::Parabola;
use crate::joint::profile::{Around, Profile, about};
use crate::joint::strip::{GROUP, MID, SEEN_AROUND, Strip, box_columns};

/// Rows of a strip, ...
pub(super) const ROWS: usize = 48;
/// ... its first row, counted back from the last point, ...
const BACK: usize = 10;
/// ... the number of its points that are taken, ...
const TAKEN: usize = 20;
/// ... and the number on the finest level, which has the most points. It applies if the whole strip shows a joint this
/// many times as deep as the noise, ...
const TAKEN_CLEAR: usize = 36;
const CLEAR: f32 = 5.5;
/// ... while the joint is this near to the predicted axis, columns.
const NEAR: f32 = 2.0;
/// Maximum number of turns too sharp for a joint; more are chance detections in texture. The number doubles with each
/// coarser level: a burn hole has many corners for a joint a few pixels wide there.
const MAX_CORNERS: usize = 3;
/// Points that the continuation is fitted to.
const FITTED: usize = 44;
/// Maximum curvature of a joint, rad/px of its level.
const MAX_CURVATURE: f32 = 0.03;
/// Typical curvature of a joint at its start, rad/px.
const BENT: f32 = 0.004;
/// Length of gaps, pixels, above which the joint is searched as if it bent on unseen ...
const WIDER: usize = 12;
/// Part of the curvature that is kept after each strip of a gap.
const STRAIGHTER: f32 = 0.75;
/// Distance from the axis at which the continuation is predicted anew, columns.
const BESIDE: f32 = 2.5;
/// Maximum distance of a start from the joint, pixels of the frame.
const START_OFF: f32 = 2.0;
/// Maximum weight of a pixel (salt noise, sparks), in depths of the joint ...
const SPIKE: f32 = 1.25;
/// ... at a start, where the depth is still uncertain ...
const START_SPIKE: f32 = 2.0;
/// ... up to this level: on coarser ones it is averaged with many pixels.
const SPIKY: usize = 1;
/// Minimum part of the first rows that show the joint at a start.
const START_SEEN: f32 = 0.6;
/// Length of the chords, points ...
pub(super) const CHORD: usize = 14;

/// A point of the trail.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) at: [f32; 2],
    pub(super) seen: bool,
    /// The joint's depth there, grey values.
    pub(super) contrast: f32,
}

/// Reason why the trail ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stop {
    /// The border of the frame or zone, or the maximum length.
    Rim,
    /// The trail's own start.
    Closed,
    /// Longest gap without a visible joint.
    Gap,
}

/// The path of a joint, to a pixel or two: strip after strip along the predicted axis.
#[derive(Debug, Clone, Default)]
pub(super) struct Trail {
    pub(super) places: Vec<Place>,
    /// Number of points up to which the joint is certain: behind them more points are unseen than seen.
    pub(super) solid: usize,
    strip: Strip,
    lattice: Lattice,
    path: Vec<usize>,
    seen: Vec<bool>,
    /// Path and seen rows in the unchanged light.
    usual: (Vec<usize>, Vec<bool>),
    /// Maximum depth of each row of the strip, computed on demand.
    deepest: Vec<f32>,
    /// Points behind a corner.
    aside: Vec<Place>,
}

/// Appearance of a joint as it is followed, in pixels of its level.
#[derive(Debug, Clone, Copy)]
pub(super) struct Look {
    pub(super) level: usize,
    pub(super) width: f32,
    /// Depth, grey values.
    pub(super) contrast: f32,
    /// Grey value in its middle; `None` on a top-hat, which only has depths.
    pub(super) floor: Option<f32>,
    /// Standard deviation of a depth.
    pub(super) noise: f32,
    /// The noise was measured in the last strip that shows the joint; it is measured in every other one.
    pub(super) noise_was_learned: bool,
    pub(super) axis: Axis,
    /// Evidence for this width: depth times the root of the width in pixels of the frame.
    pub(super) strength: f32,
}

impl Look {
    pub(super) fn width_in_frame(&self) -> f32 {
        self.width * (1 << self.level) as f32
    }

    /// Returns the width and depth.
    pub(super) fn line(&self) -> DarkLine {
        DarkLine { width: self.width, contrast: self.contrast }
    }

    /// Returns the clipping limit of a pixel for a joint of this depth, grey values.
    pub(super) fn most(&self, contrast: f32) -> f32 {
        if self.level > SPIKY { f32::INFINITY } else { SPIKE * contrast }
    }
}

/// Limits of a trail, pixels of its level.
pub(super) struct Limits<'a> {
    /// Returns true in the zone.
    pub(super) inside: &'a dyn Fn([f32; 2]) -> bool,
    /// Returns true on the path to be left at a known obstacle.
    pub(super) aside: &'a dyn Fn([f32; 2]) -> bool,
    pub(super) gap: f32,
    pub(super) length: f32,
    /// Number of points before a known obstacle.
    pub(super) hidden: Option<usize>,
}

impl Trail {
    /// Reserves capacity for this many points.
    pub(in crate::joint) fn make_room(&mut self, places: usize) {
        make_room(&mut self.places, places);
        make_room(&mut self.aside, TAKEN_CLEAR + 2 * CHORD);
        self.make_room_to_see();
    }

    /// Looks for a joint of `width` at `level` in a strip from the start.
    pub(super) fn look(&mut self, picture: &Picture, axis: Axis, width: f32, level: usize) -> Option<Look> {
        self.strip.unroll(picture, axis.stations(0.0, ROWS));
        self.strip.measure(width, f32::INFINITY);
        self.strip.noise = self.strip.noise_everywhere();
        let free = 2.0 + 0.25 * width;
        // On coarse levels a tack ahead may hide much of a whole strip.
        let rows = if level > SPIKY { ROWS / 2 } else { ROWS };
        let mut contrast = self.depth_at_start(free).max(3.5 * self.strip.noise);
        for round in 0..2 {
            if round > 0 && level <= SPIKY {
                self.strip.measure(width, START_SPIKE * contrast);
            }
            self.find(contrast, free);
            self.strip.noise = self.strip.noise_beside(&self.path, DarkLine { width, contrast });
            let depths = self.path[..rows].iter().zip(&self.strip.depth).map(|(j, row)| row[*j]);
            contrast = (depths.sum::<f32>() / rows as f32).max(2.0 * self.strip.noise);
        }
        self.find(contrast, free);
        self.judge(contrast);
        if (self.path[0].abs_diff(MID) as f32) > (START_OFF / (1 << level) as f32).max(0.5) + 0.5 * width {
            return None;
        }
        let part = self.seen[..rows].iter().filter(|s| **s).count() as f32 / rows as f32;
        let seen = self.path[..rows].iter().zip(&self.seen).enumerate().filter(|(_, (_, seen))| **seen);
        let across = seen.map(|(i, (j, _))| (i as f32, *j as f32 - MID as f32, 1.0));
        let [offset, slope, _] = Parabola::through(across, 1e9)?.terms;
        let strength = contrast * (box_columns(width) as f32 * (1 << level) as f32).sqrt() * part;
        let axis = Axis { at: axis.station(0.0).beside(offset), heading: axis.heading + slope.atan(), curvature: 0.0 };
        let (noise, floor) = (self.strip.noise, (!picture.is_top_hat).then(|| self.floor(width)));
        let look = Look { level, width, contrast, floor, noise, noise_was_learned: false, axis, strength };
        (part >= START_SEEN).then_some(look)
    }

    /// Returns the maximum mean depth of the first rows in columns near the axis.
    fn depth_at_start(&self, free: f32) -> f32 {
        const FIRST: usize = 12;
        let mean = |j: usize| self.strip.depth[..FIRST].iter().map(|row| row[j]).sum::<f32>() / FIRST as f32;
        (MID - free as usize..=MID + free as usize).map(mean).fold(0.0, f32::max)
    }

    /// Measures the full width at half depth of the joint of a look, pixels of its level.
    pub(super) fn measure_width(&mut self, picture: &Picture, look: &Look) -> Option<f32> {
        self.strip.unroll(picture, look.axis.stations(0.0, ROWS));
        self.strip.measure(look.width, look.most(look.contrast));
        self.strip.noise = self.strip.noise_everywhere();
        self.find(look.contrast, 1.5);
        let profile = Profile::new(1.5 * look.width);
        let mut sum = Around::default();
        for (i, row) in self.strip.grey.iter().enumerate() {
            sum.iter_mut().zip(&about(row, column_about(&self.path, i, 4))).for_each(|(s, a)| *s += a);
        }
        profile.rims(&sum).map(|[left, right]| right - left)
    }

    /// Follows a joint from its look at the start.
    pub(super) fn follow(&mut self, picture: &Picture, look: &mut Look, limits: &Limits) -> Stop {
        self.places.clear();
        self.solid = 0;
        let (mut axis, mut gap, mut back, mut checked, mut corners) = (look.axis, 0usize, 0usize, 0usize, 0usize);
        // Rows at the rims of a gap are not seen as joint. On coarse levels the rows blurred by groups are much of a
        // gap.
        let rims = SEEN_AROUND + if look.level > SPIKY { GROUP } else { 0 };
        // Unseen points less seen-again ones, so that gaps with chance detections in texture add up.
        let mut unseen = 0usize;
        let (mut known, mut known_to) = (axis, 0);
        loop {
            let from = back as f32;
            if gap > WIDER {
                let gone = (self.places.len() - known_to) as f32;
                axis = self.see_across(picture, Known { axis: known, gone }, from, look, gap);
            } else {
                if unseen <= WIDER || 4 * self.count() >= 3 * ROWS {
                    // A short visible stretch within a gap is a chance detection.
                    (known, known_to) = (axis, self.places.len());
                }
                self.see(picture, &axis, from, look, gap);
            }
            let mut taken = 0;
            let most = if self.is_clear(look) { TAKEN_CLEAR } else { TAKEN };
            for i in back..back + most {
                let across = column_about(&self.path, i, 3) - MID as f32;
                let beside = if taken < TAKEN { BESIDE } else { NEAR };
                if taken >= TAKEN / 2 && across.abs() > beside && self.seen[i] {
                    break;
                }
                taken += 1;
                let at = axis.station(i as f32 - from).beside(across);
                if !(limits.inside)(at) || self.places.len() as f32 > limits.length {
                    return Stop::Rim;
                }
                self.places.push(Place { at, seen: self.seen[i], contrast: look.contrast });
                (gap, unseen) = if self.seen[i] { (0, unseen.saturating_sub(1)) } else { (gap + 1, unseen + 1) };
                if unseen == 0 {
                    self.solid = self.places.len();
                }
                if self.seen[i] && self.is_closed() {
                    return Stop::Closed;
                }
                if unseen as f32 > limits.gap + rims as f32 {
                    return Stop::Gap;
                }
            }
            if limits.hidden.is_some_and(|hidden| self.goes_aside(hidden, limits)) {
                // The path to be left is no new result.
                self.places.clear();
                return Stop::Gap;
            }
            let told = limits.hidden.filter(|hidden| checked < *hidden && *hidden < self.places.len());
            if let Some(corner) = told.or_else(|| self.corner(checked)) {
                checked = self.places.len();
                // A joint does not turn so sharply: it may continue straight, and the path aside is another line.
                self.aside.clear();
                self.aside.extend_from_slice(&self.places[corner..]);
                self.places.truncate(corner);
                if let Some(beyond) = self.leap(picture, look, limits) {
                    self.solid = self.solid.min(corner);
                    (axis, gap, back) = (beyond, 0, BACK);
                    continue;
                }
                self.places.truncate(corner);
                self.places.extend_from_slice(&self.aside);
                corners += 1;
                if corners > MAX_CORNERS << look.level {
                    return Stop::Gap;
                }
                self.see(picture, &axis, from, look, gap);
            }
            self.learn(look);
            axis = self.way_on(&axis, taken as f32, if taken < TAKEN { FITTED / 2 } else { FITTED });
            back = BACK;
        }
    }

    /// Returns true if the trail follows the path aside well behind the obstacle.
    fn goes_aside(&self, hidden: usize, limits: &Limits) -> bool {
        let behind = self.places.get(hidden + ROWS..).unwrap_or_default();
        behind.len() >= TAKEN && behind[behind.len() - TAKEN..].iter().step_by(TAKEN - 1).all(|p| (limits.aside)(p.at))
    }

    /// Returns true if the strip shows a narrow joint so clearly that more points than usual can be taken.
    fn is_clear(&self, look: &Look) -> bool {
        look.level == 0 && look.contrast > CLEAR * look.noise && self.seen.iter().all(|seen| *seen)
    }

    /// Adapts the joint's depth to the strip.
    fn learn(&self, look: &mut Look) {
        let seen = (BACK..ROWS - BACK).filter(|i| self.seen[*i]);
        let count = seen.clone().count();
        if count > ROWS / 3 {
            let mean = seen.map(|i| self.strip.depth[i][self.path[i]]).sum::<f32>() / count as f32;
            look.floor = look.floor.map(|floor| floor + 0.5 * (self.floor(look.width) - floor));
            look.contrast += 0.5 * (mean.clamp(0.5 * look.contrast, 2.0 * look.contrast) - look.contrast);
        }
    }

    /// Predicts the axis from the last point on by a parabola through the last seen points.
    fn way_on(&self, axis: &Axis, gone: f32, fitted: usize) -> Axis {
        let last = &self.places[self.places.len().saturating_sub(fitted)..];
        let count = last.iter().filter(|p| p.seen).count();
        let Station { at, .. } = axis.station(gone);
        let heading = axis.heading + gone * axis.curvature;
        let straight = Axis { at, heading, curvature: STRAIGHTER * axis.curvature };
        if count < fitted / 4 {
            return straight;
        }
        let there = Axis { at, heading, ..*axis };
        let place = there.along_and_across();
        let local = last.iter().filter(|p| p.seen).map(|p| {
            let (along, across) = place(p.at);
            (along, across, 1.0)
        });
        let Some(found) = Parabola::through(local, 1.0 / (0.5 * BENT).powi(2)) else { return straight };
        let [offset, slope, bend] = found.terms;
        let curvature = (axis.curvature + 2.0 * bend).clamp(-MAX_CURVATURE, MAX_CURVATURE);
        Axis { at: there.station(0.0).beside(offset), heading: heading + slope.atan(), curvature }
    }

    /// Returns the length of the trail to point `last`, pixels of its level.
    pub(in crate::joint) fn way(&self, last: usize) -> f32 {
        let step = |pair: &[Place]| length([0, 1].map(|k| pair[1].at[k] - pair[0].at[k]));
        self.places[..=last].windows(2).map(step).sum()
    }

    fn is_closed(&self) -> bool {
        const REACH: usize = 8;
        const NEAR_BEGIN: f32 = 3.5;
        let places = &self.places;
        let count = places.len();
        if count < 40 {
            return false;
        }
        let (first, last) = (places[0].at, places[count - 1].at);
        if (last[0] - first[0]).powi(2) + (last[1] - first[1]).powi(2) > NEAR_BEGIN * NEAR_BEGIN {
            return false;
        }
        let heading = |a: [f32; 2], b: [f32; 2]| (b[1] - a[1]).atan2(b[0] - a[0]);
        let turn = heading(first, places[REACH].at) - heading(places[count - 1 - REACH].at, last);
        turn.cos() > 0.8
    }
}

/// Last known course of the joint.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known {
    pub(super) axis: Axis,
    /// Distance from its start, pixels.
    pub(super) gone: f32,
}
