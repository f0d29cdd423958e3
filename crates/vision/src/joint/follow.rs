use super::axis::{Axis, length};
use super::end::{Cut, cut};
use super::levels::{Levels, Picture, from_level, to_level};
use super::midline::Midline;
use super::rims::{self, Rims};
use super::second_attempt::same_within;
use super::trail::{Limits, Look, ROWS, Trail};
use super::{CONFIDENT, End, Joint, Options, Row, Start, State, Zone, confidence, make_room};
use crate::frame::Frame;
use std::f32::consts::PI;

/// Widths tried at a start of unknown width: level, and pixels of that level.
const WIDTHS: [(usize, f32); 7] = [(0, 3.0), (0, 5.0), (1, 5.0), (2, 5.0), (3, 5.0), (4, 5.0), (5, 5.0)];
/// Upper limit of the width on the level on which a joint is followed, pixels.
const WIDE: f32 = 7.0;
/// Minimum strength of the narrowest width, as a part of that of the strongest.
const NOT_MUCH_LESS: f32 = 0.5;
/// A width is clearly a line if its depth is this many standard deviations at the start ...
const CLEAR: f32 = 6.0;
/// ... and this part of the depth of the deepest width.
const NEARLY_DEEPEST: f32 = 0.7;
/// A line in a dark strip is this many times as deep as the wider strip, and this many standard deviations.
const TWICE: f32 = 1.8;
const DEEP: f32 = 3.5;
/// Minimum and maximum width, pixels of the frame.
const WIDTH: (f32, f32) = (1.0, 400.0);
/// Default gap that is coasted over, as a part of the frame's shorter side.
const GAP: f32 = 0.2;
/// An attempt with narrower widths tries widths up to this part of the previous one and accepts results below this part
/// of those ...
pub(super) const NARROWER: f32 = 0.7;
/// A joint is wide if it is followed on this level or a coarser one.
pub(super) const COARSE: usize = 2;

/// Follows joints; reuses its buffers from frame to frame.
#[derive(Debug, Clone)]
pub struct Follower {
    options: Options,
    pub(super) levels: Levels,
    trail: Trail,
    pub(super) midline: Midline,
    rims: Rims,
    /// Upper limit of the widths tried at a start of unknown width, pixels; the result is below [`NARROWER`] times it.
    pub(super) narrower: f32,
    /// Place at which an object may hide the joint.
    pub(super) hidden: Option<Hidden>,
    pub(super) joint: Joint,
    /// The joint as found before the second attempt.
    pub(super) before: Joint,
}

impl Follower {
    /// Creates a follower.
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

    /// Follows the joint in `frame` from `start`.
    ///
    /// A start outside the frame or zone, or not finite, gives no rows and [`End::LeftImage`]. A start without a
    /// visible joint gives [`End::Lost`], with no rows or only unconfident ones.
    pub fn follow(&mut self, frame: &Frame, start: &Start) -> &Joint {
        let inside = Inside::new(frame, self.options.zone);
        let finite = start.x.is_finite() && start.y.is_finite() && start.direction.is_finite();
        if !finite || !inside.holds([start.x, start.y]) {
            self.joint.rows.clear();
            self.joint.end = End::LeftImage;
            return &self.joint;
        }
        // A single row or column shows no joint and has no points between pixels.
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

    /// Reserves capacity, so that later frames of this size do not allocate.
    fn make_room(&mut self, frame: &Frame) {
        let rows = self.longest(frame) as usize + ROWS + (frame.width() + frame.height()) / 2;
        self.trail.make_room(rows);
        self.midline.make_room(rows);
        self.rims.make_room(rows >> rims::FINER);
        self.levels.make_room(frame, WIDE);
        // Rows of a second attempt are appended to the confident ones.
        make_room(&mut self.joint.rows, 2 * rows);
        make_room(&mut self.before.rows, 2 * rows);
    }

    /// Returns the maximum path length, pixels.
    fn longest(&self, frame: &Frame) -> f32 {
        let sum = (frame.width() + frame.height()) as f32;
        self.options.length.unwrap_or(2.0 * sum).clamp(0.0, 16.0 * sum)
    }

    /// Follows the joint and returns its look at the start and at the last strip; `None` if there is no joint at the
    /// start. The result is [`End::Lost`] without rows if the last seen row is less than `least` pixels away.
    pub(super) fn follow_in(&mut self, frame: &Frame, start: &Start, inside: &Inside, least: f32) -> Option<[Look; 2]> {
        self.joint.rows.clear();
        self.joint.end = End::Lost;
        let first = self.begin(frame, start).filter(|look| look.width_in_frame() < NARROWER * self.narrower)?;
        let mut last = first;
        self.joint.end = self.go_on(frame, &mut last, inside, least);
        Some([first, last])
    }

    /// Measures the joint at the start: ahead or, as a tack may lie ahead, behind.
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

    /// Looks from the start in a direction. `within`: only strips inside the frame count; otherwise they may cross its
    /// border.
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
            if !within || axis.stays_within(ROWS as f32, picture.size()) {
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
        // Next to the edge of a shadow a wide joint may be invisible at its measured width.
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
        let cut = cut(&self.midline.rows, self.trail.solid, stop, gap, level, |i| self.midline.is_whole(i, &picture));
        let Some(cut) = cut else { return End::Lost };
        if cut.end == End::JointEnd {
            self.midline.end_before(cut.rows, look.width);
        }
        let end =
            tell(&self.midline, &picture, level, cut, self.trail.solid, self.options.on_joint, &mut self.joint.rows);
        if level >= rims::FINER {
            self.rims.place(&self.levels, frame, level, &mut self.joint.rows);
        }
        end
    }
}

/// Converts rows of the level to rows of the frame. `solid`: rows up to which the joint is certain.
fn tell(
    midline: &Midline,
    picture: &Picture,
    level: usize,
    cut: Cut,
    solid: usize,
    on_joint: bool,
    out: &mut Vec<Row>,
) -> End {
    let Cut { rows, end, beyond } = cut;
    let scale = (1 << level) as f32;
    // A joint with a reported end is seen up to it, although groups of rows there show less of it.
    let to_end =
        midline.rows[..rows].iter().rposition(|found| found.seen).filter(|_| end == End::JointEnd).unwrap_or(rows);
    for (i, found) in midline.rows[..rows].iter().enumerate() {
        let confidence = confidence::row(found, scale, midline.is_whole(i, picture));
        let [x, y] = found.at.map(|v| from_level(v, level));
        let state = if found.seen || i > to_end { State::Seen } else { State::Coasted };
        out.push(Row { x, y, confidence, width: found.width * scale, state });
    }
    bridge(out);
    confidence::steps(out, &midline.rows[..rows]);
    confidence::narrowed(out);
    confidence::gaps(out, &midline.rows[..rows]);
    if end == End::JointEnd {
        place_end(out, rows as f32 - 0.5 + beyond);
    }
    confidence::rims(out, end, on_joint);
    confidence::doubtful(out, solid);
    let is_short = !on_joint && confidence::length(out, end);
    if !on_joint {
        confidence::few(out);
    }
    confidence::corners(out);
    confidence::lone(out);
    match end {
        // An exit from the frame is not reported, as no row is confident.
        End::LeftImage if out.iter().all(|r| r.confidence < CONFIDENT) => End::Lost,
        End::JointEnd if is_short => End::Lost,
        end => end,
    }
}

/// Interpolates coasted rows between the seen ones before and after; the best path there is random.
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

/// Places the last row at the end of the joint, `at` rows after the first one.
fn place_end(rows: &mut Vec<Row>, at: f32) {
    rows.truncate((at.max(1.0) as usize + 1).max(2));
    let beyond = at - (rows.len() - 1) as f32;
    if let [.., before, last] = rows[..] {
        let (x, y) = (last.x + beyond * (last.x - before.x), last.y + beyond * (last.y - before.y));
        rows.push(Row { x, y, ..last });
    }
}

/// Selects the narrowest width that is stronger than its neighbours and not much weaker than the strongest. Wider ones
/// are the joint's surroundings. A width that is clearly above the noise and deeper than the next wider one is taken at
/// once.
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
    // A line in a dark strip: a narrower width that is about twice as deep is the joint.
    let deep = |look: &&Look| look.contrast > DEEP * look.noise && look.contrast > TWICE * depth(&looks[found]);
    looks[..found].iter().flatten().find(deep).copied().or(looks[found])
}

/// Returns the given width of a start, pixels of the frame.
pub(super) fn known_width(start: &Start) -> Option<f32> {
    start.width.filter(|w| w.is_finite() && *w > 0.0).map(|w| w.clamp(WIDTH.0, WIDTH.1))
}

/// Returns the level on which a width is narrow, and the width there.
fn on_level(width: f32, coarsest: usize) -> (usize, f32) {
    let level = (0..=coarsest).find(|l| width / ((1 << l) as f32) < WIDE).unwrap_or(coarsest);
    (level, (width / (1 << level) as f32).min(WIDE))
}

/// The part of the frame inside the zone.
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

    /// Returns the distance of an inside point from the nearest border, pixels.
    pub(super) fn to_rim(&self, [x, y]: [f32; 2]) -> f32 {
        let Zone { left, top, right, bottom } = self.zone;
        (x - left).min(right - x).min(y - top).min(bottom - y)
    }

    fn holds(&self, [x, y]: [f32; 2]) -> bool {
        let Zone { left, top, right, bottom } = self.zone;
        x >= left && x <= right && y >= top && y <= bottom
    }
}

/// Place where an object may hide a joint that was followed aside there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hidden {
    /// Number of points behind the start.
    pub(super) place: usize,
    /// First row of the path aside, which leads to the border; the number of rows if the joint ended within the frame.
    pub(super) aside: usize,
}

/// Returns true if one of the rows is near a point of the frame.
pub(super) fn is_passed(rows: &[Row], at: [f32; 2]) -> bool {
    rows.iter().any(|row| length([row.x - at[0], row.y - at[1]]) < same_within(row))
}
