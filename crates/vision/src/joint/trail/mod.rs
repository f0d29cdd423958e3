mod leap;
mod see;

use crate::joint::axis::{Axis, Station, length};
use crate::joint::lattice::{Lattice, column_about};
use crate::joint::levels::Picture;
use crate::joint::make_room;
use crate::joint::parabola::Parabola;
use crate::joint::profile::{Around, Profile, about};
use crate::joint::strip::{GROUP, MID, SEEN_AROUND, Strip, box_columns};

/// Rows of a strip that is looked at ...
pub(super) const ROWS: usize = 48;
/// ... from this many before the last place ...
const BACK: usize = 10;
/// ... of which this many places are taken, ...
const TAKEN: usize = 20;
/// ... and up to so many on the finest level, where there are most of them, if all of it shows a joint so many times as deep as the
/// noise, ...
const TAKEN_CLEAR: usize = 36;
const CLEAR: f32 = 5.5;
/// ... as long as it is this near to where it is predicted, columns.
const NEAR: f32 = 2.0;
/// What turns more often than this like none of a joint is chance finds of texture; twice as often may be on each coarser level: a
/// burn hole has many corners to a joint that is a few pixels wide there.
const MOST_CORNERS: usize = 3;
/// Places that the way on is fitted to.
const FITTED: usize = 44;
/// Joints bend no more sharply than this, rad/px of their level.
const MOST_BENT: f32 = 0.03;
/// A joint that has just begun to be followed bends about this much, rad/px.
const BENT: f32 = 0.004;
/// Gaps longer than this, pixels, are looked beyond as if the joint bent on unseen ...
const WIDER: usize = 12;
/// Part of the curvature that is left after each strip of a gap.
const STRAIGHTER: f32 = 0.75;
/// Columns from the axis at which the way on is predicted anew.
const BESIDE: f32 = 2.5;
/// A start is this near to the joint or on it, pixels of the frame.
const START_OFF: f32 = 2.0;
/// A pixel counts for at most this many times the joint's depth (salt, sparks) ...
const SPIKE: f32 = 1.25;
/// ... at a start, where the depth is not sure yet, this many times ...
const START_SPIKE: f32 = 2.0;
/// ... up to this level: on coarser ones it is one of many.
const SPIKY: usize = 1;
/// Part of the first rows that show a joint if there is one.
const START_SEEN: f32 = 0.6;

/// A place on the way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) at: [f32; 2],
    pub(super) seen: bool,
    /// The joint's depth there, grey values.
    pub(super) contrast: f32,
}

/// Why the trail ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stop {
    /// At the rim of the frame or zone, or at the longest length.
    Rim,
    /// At its begin.
    Closed,
    /// Nothing was seen for as long as the longest gap.
    Gap,
}

/// Where a joint goes, to a pixel or two: strip after strip along the way that is predicted.
#[derive(Debug, Clone, Default)]
pub(super) struct Trail {
    pub(super) places: Vec<Place>,
    /// Places up to which the joint is sure to go: from there on less is seen than not.
    pub(super) solid: usize,
    strip: Strip,
    lattice: Lattice,
    path: Vec<usize>,
    seen: Vec<bool>,
    /// Path and rows seen in the light as it was.
    usual: (Vec<usize>, Vec<bool>),
    /// The greatest depth of each row of the strip, once it is asked for.
    deepest: Vec<f32>,
    /// Places behind a corner.
    aside: Vec<Place>,
}

/// What is known of a joint as it is followed, in pixels of its level.
#[derive(Debug, Clone, Copy)]
pub(super) struct Look {
    pub(super) level: usize,
    pub(super) width: f32,
    /// Depth, grey values.
    pub(super) contrast: f32,
    /// Grey value in its middle; none on a top-hat, where it tells the depth alone.
    pub(super) floor: Option<f32>,
    /// Standard deviation of a depth.
    pub(super) noise: f32,
    /// It is learned from every other strip that shows the joint: not from the last one.
    pub(super) noise_was_learned: bool,
    pub(super) axis: Axis,
    /// How much speaks for this width: depth by the root of the width in pixels of the frame.
    pub(super) strength: f32,
}

impl Look {
    /// Its width, pixels of the frame.
    pub(super) fn width_in_frame(&self) -> f32 {
        self.width * (1 << self.level) as f32
    }

    /// What a pixel counts at most where the joint has this depth, grey values.
    pub(super) fn most(&self, contrast: f32) -> f32 {
        if self.level > SPIKY { f32::INFINITY } else { SPIKE * contrast }
    }
}

/// How far a trail may go, pixels of its level.
pub(super) struct Limits<'a> {
    /// True in the zone.
    pub(super) inside: &'a dyn Fn([f32; 2]) -> bool,
    /// True on the way that is to be left where something hides the joint.
    pub(super) aside: &'a dyn Fn([f32; 2]) -> bool,
    pub(super) gap: f32,
    pub(super) length: f32,
    /// Place at which something is known to hide the joint.
    pub(super) hidden: Option<usize>,
}

impl Trail {
    /// Room for so many places.
    pub(in crate::joint) fn make_room(&mut self, places: usize) {
        make_room(&mut self.places, places);
        make_room(&mut self.aside, TAKEN_CLEAR + 2 * leap::CHORD);
        self.make_room_to_see();
    }

    /// What a strip from the start shows, for a joint of `width` at `level`.
    pub(super) fn look(&mut self, picture: &Picture, axis: Axis, width: f32, level: usize) -> Option<Look> {
        self.strip.unroll(picture, axis.stations(0.0, ROWS));
        self.strip.measure(width, f32::INFINITY);
        self.strip.noise = self.strip.noise_everywhere();
        let free = 2.0 + 0.25 * width;
        // On coarse levels a tack that lies ahead may hide much of a whole strip.
        let rows = if level > SPIKY { ROWS / 2 } else { ROWS };
        let mut contrast = self.depth_at_start(free).max(3.5 * self.strip.noise);
        for round in 0..2 {
            if round > 0 && level <= SPIKY {
                self.strip.measure(width, START_SPIKE * contrast);
            }
            self.find(contrast, free);
            self.strip.noise = self.strip.noise_beside(&self.path, (width, contrast));
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

    /// The greatest mean depth of the first rows in columns near the axis.
    fn depth_at_start(&self, free: f32) -> f32 {
        const FIRST: usize = 12;
        let mean = |j: usize| self.strip.depth[..FIRST].iter().map(|row| row[j]).sum::<f32>() / FIRST as f32;
        (MID - free as usize..=MID + free as usize).map(mean).fold(0.0, f32::max)
    }

    /// Full width at half depth of what a look was at, pixels of its level.
    pub(super) fn measure_width(&mut self, picture: &Picture, look: &Look) -> Option<f32> {
        self.strip.unroll(picture, look.axis.stations(0.0, ROWS));
        self.strip.measure(look.width, look.most(look.contrast));
        self.strip.noise = self.strip.noise_everywhere();
        self.find(look.contrast, 1.5);
        let profile = Profile::new(1.5 * look.width);
        let mut sum = Around::default();
        for (i, row) in self.strip.grey.iter().enumerate() {
            let around = about(row, column_about(&self.path, i, 4));
            sum.iter_mut().zip(&around).for_each(|(s, a)| *s += a);
        }
        profile.rims(&sum).map(|[left, right]| right - left)
    }

    /// Follows from where a look was.
    pub(super) fn follow(&mut self, picture: &Picture, look: &mut Look, limits: &Limits) -> Stop {
        self.places.clear();
        self.solid = 0;
        let (mut axis, mut gap, mut back, mut checked, mut corners) = (look.axis, 0usize, 0usize, 0usize, 0usize);
        // Rows at the rims of a gap are not seen to be the joint's. On coarse levels those that groups blur are much of a gap.
        let rims = SEEN_AROUND + if look.level > SPIKY { GROUP } else { 0 };
        // Places that are not seen less those that are seen again: chance finds of texture add up to a gap.
        let mut unseen = 0usize;
        let (mut known, mut known_to) = (axis, 0);
        loop {
            let from = back as f32;
            if gap > WIDER {
                let gone = (self.places.len() - known_to) as f32;
                axis = self.see_across(picture, (&known, gone), from, look, gap);
            } else {
                if unseen <= WIDER || 4 * self.count() >= 3 * ROWS {
                    // What is seen for a short while within a gap is chance.
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
                // The way that it was to leave is nothing new.
                self.places.clear();
                return Stop::Gap;
            }
            let told = limits.hidden.filter(|hidden| checked < *hidden && *hidden < self.places.len());
            if let Some(corner) = told.or_else(|| self.corner(checked)) {
                checked = self.places.len();
                // A joint does not turn so sharply: it may go on straight, and what was followed is something else.
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
                if corners > MOST_CORNERS << look.level {
                    return Stop::Gap;
                }
                self.see(picture, &axis, from, look, gap);
            }
            self.learn(look);
            axis = self.way_on(&axis, taken as f32, if taken < TAKEN { FITTED / 2 } else { FITTED });
            back = BACK;
        }
    }

    /// True if the trail goes on aside well behind where something hides the joint.
    fn goes_aside(&self, hidden: usize, limits: &Limits) -> bool {
        let behind = self.places.get(hidden + ROWS..).unwrap_or_default();
        behind.len() >= TAKEN && behind[behind.len() - TAKEN..].iter().step_by(TAKEN - 1).all(|p| (limits.aside)(p.at))
    }

    /// True if the strip shows a narrow joint so well that more of its places than usual are sure.
    fn is_clear(&self, look: &Look) -> bool {
        look.level == 0 && look.contrast > CLEAR * look.noise && self.seen.iter().all(|seen| *seen)
    }

    /// The joint's depth follows what is seen.
    fn learn(&self, look: &mut Look) {
        let seen = (BACK..ROWS - BACK).filter(|i| self.seen[*i]);
        let count = seen.clone().count();
        if count > ROWS / 3 {
            let mean = seen.map(|i| self.strip.depth[i][self.path[i]]).sum::<f32>() / count as f32;
            look.floor = look.floor.map(|floor| floor + 0.5 * (self.floor(look.width) - floor));
            look.contrast += 0.5 * (mean.clamp(0.5 * look.contrast, 2.0 * look.contrast) - look.contrast);
        }
    }

    /// The axis from the last place on: a parabola through the last places that were seen.
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
        let curvature = (axis.curvature + 2.0 * bend).clamp(-MOST_BENT, MOST_BENT);
        Axis { at: there.station(0.0).beside(offset), heading: heading + slope.atan(), curvature }
    }

    /// How far it is to place `last`, pixels of its level.
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
