use super::again::{COARSE, NARROWER};
use super::axis::Axis;
use super::end::{Cut, cut};
use super::levels::{Levels, Picture, from_level, to_level};
use super::midline::Midline;
use super::rims::{self, Rims};
use super::straight_on::{Hidden, is_passed};
use super::trail::{Limits, Look, ROWS, Trail};
use super::{CONFIDENT, End, Joint, Options, Row, Start, State, Zone, judge, make_room};
use crate::Frame;
use std::f32::consts::PI;

/// Widths tried at a start of unknown width: level and pixels of it.
const WIDTHS: [(usize, f32); 7] = [(0, 3.0), (0, 5.0), (1, 5.0), (2, 5.0), (3, 5.0), (4, 5.0), (5, 5.0)];
/// A joint is followed on the level on which it is narrower than this, pixels.
const WIDE: f32 = 7.0;
/// Part of the strength of the strongest width that the narrowest has at least.
const NOT_MUCH_LESS: f32 = 0.5;
/// What is this many standard deviations deep at the start ...
const CLEAR: f32 = 6.0;
/// ... and this part of the depth of the deepest width is sure to be a line.
const NEARLY_DEEPEST: f32 = 0.7;
/// What is this many times as deep as what is wider, and this many standard deviations, is a line in a dark strip.
const TWICE: f32 = 1.8;
const DEEP: f32 = 3.5;
/// Least and most width, pixels of the frame.
const WIDTH: (f32, f32) = (1.0, 400.0);
/// Part of the frame's shorter side that is coasted over if nothing else is said.
const GAP: f32 = 0.2;

/// Follows joints; keeps its buffers from frame to frame.
#[derive(Debug, Clone)]
pub struct Follower {
    options: Options,
    pub(super) levels: Levels,
    trail: Trail,
    pub(super) midline: Midline,
    rims: Rims,
    /// A start of unknown width is looked for with widths below this, pixels, and found narrower than this by a part.
    pub(super) narrower: f32,
    /// Where something may hide the joint.
    pub(super) hidden: Option<Hidden>,
    pub(super) joint: Joint,
    /// The joint as it was found before it was tried again.
    pub(super) before: Joint,
}

impl Follower {
    /// A follower with its buffers.
    #[must_use]
    pub fn new(options: Options) -> Self {
        let joint = Joint { rows: Vec::new(), end: End::Lost };
        let before = joint.clone();
        let (trail, midline, rims) = (Trail::default(), Midline::default(), Rims::default());
        Self {
            options,
            levels: Levels::new(),
            trail,
            midline,
            rims,
            narrower: f32::INFINITY,
            hidden: None,
            joint,
            before,
        }
    }

    /// The joint in `frame` from `start`. A start outside the frame or zone, or not finite, gives no rows and
    /// [`End::LeftImage`]; a start where no joint is to be seen ends as [`End::Lost`], without rows or with rows that are not confident.
    pub fn follow(&mut self, frame: &Frame, start: &Start) -> &Joint {
        let inside = Inside::new(frame, self.options.zone);
        let finite = start.x.is_finite() && start.y.is_finite() && start.direction.is_finite();
        if !finite || !inside.holds([start.x, start.y]) {
            self.joint.rows.clear();
            self.joint.end = End::LeftImage;
            return &self.joint;
        }
        // A single row or column shows no joint, and there is nothing between its pixels.
        if frame.width() < 2 || frame.height() < 2 {
            self.joint.rows.clear();
            self.joint.end = End::Lost;
            return &self.joint;
        }
        self.levels.begin_frame();
        self.make_room(frame);
        if let Some(looks) = self.follow_in(frame, start, &inside, 0.0) {
            self.try_again(frame, start, &inside, looks);
        } else if known_width(start).is_none() {
            self.try_start_on_top_hat(frame, start, &inside);
        }
        &self.joint
    }

    /// A later frame of this size is not to allocate, whatever it shows.
    fn make_room(&mut self, frame: &Frame) {
        let rows = self.longest(frame) as usize + ROWS + (frame.width() + frame.height()) / 2;
        self.trail.make_room(rows);
        self.midline.make_room(rows);
        self.rims.make_room(rows >> rims::FINER);
        self.levels.make_room(frame, WIDE);
        // What is found again is put behind what was sure.
        make_room(&mut self.joint.rows, 2 * rows);
        make_room(&mut self.before.rows, 2 * rows);
    }

    /// The longest path, pixels.
    fn longest(&self, frame: &Frame) -> f32 {
        let sum = (frame.width() + frame.height()) as f32;
        self.options.length.unwrap_or(2.0 * sum).clamp(0.0, 16.0 * sum)
    }

    /// Follows; what the joint looks like at its start, if one is there, and where it is followed last. It ends as lost, without rows,
    /// if where it is seen last is less than `least` pixels away.
    pub(super) fn follow_in(&mut self, frame: &Frame, start: &Start, inside: &Inside, least: f32) -> Option<[Look; 2]> {
        self.joint.rows.clear();
        self.joint.end = End::Lost;
        let first = self.begin(frame, start).filter(|look| look.width_in_frame() < NARROWER * self.narrower)?;
        let mut last = first;
        self.joint.end = self.go_on(frame, &mut last, inside, least);
        Some([first, last])
    }

    /// Level, width, heading and depth at the start, if a joint is there: ahead or, as a tack may lie ahead, behind.
    fn begin(&mut self, frame: &Frame, start: &Start) -> Option<Look> {
        let coarsest = Levels::coarsest(frame);
        self.levels.prepare(frame, known_width(start).map_or(coarsest, |w| on_level(w, coarsest).0));
        if let Some(look) = self.look(frame, start, start.direction, false) {
            return Some(look);
        }
        let mut look = self.look(frame, start, start.direction + PI, true)?;
        look.axis.heading -= PI;
        Some(look)
    }

    /// What is seen from the start in a direction. `within`: only strips that stay in the frame count, others go on beyond
    /// its rim.
    fn look(&mut self, frame: &Frame, start: &Start, heading: f32, within: bool) -> Option<Look> {
        let coarsest = Levels::coarsest(frame);
        let level_of = |width: f32| match self.levels.covered() {
            Some(level) => (level, width / (1 << level) as f32),
            None => on_level(width, coarsest),
        };
        let known = known_width(start).map(|w| [level_of(w)]);
        let widths = known.as_ref().map_or(&WIDTHS[..], |w| &w[..]);
        let mut looks = [None; WIDTHS.len()];
        let (known, narrower) = (known.is_some(), self.narrower);
        let tried = |level: usize, width: f32| level <= coarsest && (known || width * ((1 << level) as f32) < narrower);
        for (&(level, width), look) in widths.iter().zip(&mut looks).filter(|((level, width), _)| tried(*level, *width))
        {
            let picture = self.levels.picture(frame, level);
            let at = [start.x, start.y].map(|v| to_level(v, level));
            let axis = Axis { at, heading, curvature: 0.0 };
            if !within || axis.stays_within(ROWS as f32, (picture.width, picture.height)) {
                *look = self.trail.look(&picture, axis, width, level);
            }
        }
        let best = narrowest(&looks)?;
        if known {
            return Some(best);
        }
        let scale = (1 << best.level) as f32;
        let picture = self.levels.picture(frame, best.level);
        let width = self.trail.measure_width(&picture, &best).unwrap_or(best.width) * scale;
        let (level, width) = on_level(width.clamp(WIDTH.0, WIDTH.1), coarsest);
        let picture = self.levels.picture(frame, level);
        let at = [start.x, start.y].map(|v| to_level(v, level));
        let axis = Axis { at, heading: best.axis.heading, curvature: 0.0 };
        // Next to the edge of a shadow a wide joint may not be seen with its width itself.
        self.trail.look(&picture, axis, width, level).or((level >= COARSE && level == best.level).then_some(best))
    }

    fn go_on(&mut self, frame: &Frame, look: &mut Look, inside: &Inside, least: f32) -> End {
        let side = frame.width().min(frame.height()) as f32;
        let scale = (1 << look.level) as f32;
        let gap = self.options.gap.unwrap_or(GAP * side) / scale;
        let length = self.longest(frame) / scale;
        let level = look.level;
        let aside = self.hidden.and_then(|hidden| self.before.rows.get(hidden.aside..)).unwrap_or_default();
        let limits = Limits {
            inside: &|at| inside.holds(at.map(|v| from_level(v, level))),
            aside: &|at| is_passed(aside, at.map(|v| from_level(v, level))),
            gap,
            length,
            hidden: self.hidden.map(|hidden| hidden.place),
        };
        let picture = self.levels.picture(frame, level);
        let stop = self.trail.follow(&picture, look, &limits);
        let seen = self.trail.places.iter().rposition(|p| p.seen);
        if seen.is_none_or(|last| least > 0.0 && self.trail.way(last) * scale < least) {
            return End::Lost;
        }
        self.midline.find(&picture, &self.trail, look);
        let cut =
            cut(&self.midline.rows, (self.trail.solid, stop), (gap, level), |i| self.midline.is_whole(i, &picture));
        let Some(cut) = cut else { return End::Lost };
        if cut.end == End::JointEnd {
            self.midline.end_before(cut.rows, look.width);
        }
        let end =
            tell(&self.midline, &picture, (level, self.trail.solid, cut), self.options.on_joint, &mut self.joint.rows);
        if level >= rims::FINER {
            self.rims.place(&self.levels, frame, level, &mut self.joint.rows);
        }
        end
    }
}

/// Rows of the frame from those of the level.
fn tell(
    midline: &Midline,
    picture: &Picture,
    (level, solid, Cut { rows, end, beyond }): (usize, usize, Cut),
    on_joint: bool,
    out: &mut Vec<Row>,
) -> End {
    let scale = (1 << level) as f32;
    // What is told to end is there up to its end, though groups of rows there show less of it.
    let to_end =
        midline.rows[..rows].iter().rposition(|found| found.seen).filter(|_| end == End::JointEnd).unwrap_or(rows);
    for (i, found) in midline.rows[..rows].iter().enumerate() {
        let confidence = judge::row(found, scale, midline.is_whole(i, picture));
        let [x, y] = found.at.map(|v| from_level(v, level));
        let state = if found.seen || i > to_end { State::Seen } else { State::Coasted };
        out.push(Row { x, y, confidence, width: found.width * scale, state });
    }
    bridge(out);
    judge::steps(out, &midline.rows[..rows]);
    judge::narrowed(out);
    judge::gaps(out, &midline.rows[..rows]);
    if end == End::JointEnd {
        place_end(out, rows as f32 - 0.5 + beyond);
    }
    judge::rims(out, end, on_joint);
    judge::doubtful(out, solid);
    let is_short = !on_joint && judge::length(out, end);
    if !on_joint {
        judge::few(out);
    }
    judge::corners(out);
    judge::lone(out);
    match end {
        // What is nowhere sure is not known to lead out of the frame.
        End::LeftImage if out.iter().all(|r| r.confidence < CONFIDENT) => End::Lost,
        End::JointEnd if is_short => End::Lost,
        end => end,
    }
}

/// Puts coasted rows on the straight line between the seen ones before and after: what the best path does there is chance.
fn bridge(rows: &mut [Row]) {
    let mut before = None;
    for i in 0..rows.len() {
        if rows[i].state == State::Coasted {
            continue;
        }
        if let Some(from) = before.replace(i).filter(|from| i - from > 1) {
            let (a, b) = (rows[from], rows[i]);
            for (k, row) in rows[from + 1..i].iter_mut().enumerate() {
                let part = (k + 1) as f32 / (i - from) as f32;
                (row.x, row.y) = (a.x + part * (b.x - a.x), a.y + part * (b.y - a.y));
            }
        }
    }
}

/// Puts the last row where the joint ends, so many rows after the first one.
fn place_end(rows: &mut Vec<Row>, at: f32) {
    rows.truncate((at.max(1.0) as usize + 1).max(2));
    let beyond = at - (rows.len() - 1) as f32;
    if let [.., before, last] = rows[..] {
        let (x, y) = (last.x + beyond * (last.x - before.x), last.y + beyond * (last.y - before.y));
        rows.push(Row { x, y, ..last });
    }
}

/// The narrowest of the widths for which more speaks than for its neighbours, and not much less than for any: what is wider
/// still is the joint's surroundings. What stands out far from the noise and is deeper than all that is wider needs no more.
fn narrowest(looks: &[Option<Look>]) -> Option<Look> {
    let depth = |look: &Option<Look>| look.map_or(0.0, |l| l.contrast);
    let deepest = looks.iter().map(depth).fold(0.0, f32::max);
    let clear = looks.iter().enumerate().find_map(|(k, look)| {
        let look = (*look)?;
        let stands_out = look.contrast > CLEAR * look.noise && look.contrast > NEARLY_DEEPEST * deepest;
        (stands_out && depth(looks.get(k + 1).unwrap_or(&None)) < look.contrast).then_some(look)
    });
    if clear.is_some() {
        return clear;
    }
    let strength = |k: usize| looks.get(k).copied().flatten().map_or(0.0, |l| l.strength);
    let most = (0..looks.len()).map(strength).fold(0.0, f32::max);
    let found = (0..looks.len()).find(|k| strength(*k) > strength(k + 1) && strength(*k) >= NOT_MUCH_LESS * most)?;
    // A line in a dark strip: what is twice as deep and narrower is it.
    let deep = |look: &&Look| look.contrast > DEEP * look.noise && look.contrast > TWICE * depth(&looks[found]);
    looks[..found].iter().flatten().find(deep).copied().or(looks[found])
}

/// The width that a start tells, pixels of the frame.
pub(super) fn known_width(start: &Start) -> Option<f32> {
    start.width.filter(|w| w.is_finite() && *w > 0.0).map(|w| w.clamp(WIDTH.0, WIDTH.1))
}

/// The level on which a width is narrow, and the width there.
fn on_level(width: f32, coarsest: usize) -> (usize, f32) {
    let level = (0..=coarsest).find(|l| width / ((1 << l) as f32) < WIDE).unwrap_or(coarsest);
    (level, (width / (1 << level) as f32).min(WIDE))
}

/// Frame and zone.
pub(super) struct Inside {
    zone: Zone,
}

impl Inside {
    fn new(frame: &Frame, zone: Option<Zone>) -> Self {
        let (right, bottom) = ((frame.width() - 1) as f32, (frame.height() - 1) as f32);
        let zone = zone.unwrap_or(Zone { left: 0.0, top: 0.0, right, bottom });
        let Zone { left, top, .. } = zone;
        let zone = Zone {
            left: left.max(0.0),
            top: top.max(0.0),
            right: zone.right.min(right),
            bottom: zone.bottom.min(bottom),
        };
        Self { zone }
    }

    /// How far a place in it is from its nearest rim, pixels.
    pub(super) fn to_rim(&self, [x, y]: [f32; 2]) -> f32 {
        let Zone { left, top, right, bottom } = self.zone;
        (x - left).min(right - x).min(y - top).min(bottom - y)
    }

    fn holds(&self, [x, y]: [f32; 2]) -> bool {
        let Zone { left, top, right, bottom } = self.zone;
        x >= left && x <= right && y >= top && y <= bottom
    }
}
