//! Required shape and measurements of each joint type. Only the task's joint type is searched; another shape gives no
//! features.

mod butt;
mod completeness;
mod fillet;
mod groove;
mod lap;
mod round_groove;

use super::edges::{Usual, is_hidden, lit_columns, sub_column};
use super::features::{Doubt, Feature, Features, JointKind, NoFeatures, Quantity, StripeTask};
use super::fit::StripeLine;
use super::light::{Course, Light};
use super::profile::{Columns, Profile, Sample};
use super::segments::{MAX_SEGMENTS, Segment};
use arrayvec::ArrayVec;
use glam::DVec2;

/// A profile, cut into segments, and the task for it.
pub(super) struct View<'a> {
    pub(super) profile: &'a Profile,
    pub(super) segments: &'a [Segment],
    pub(super) task: &'a StripeTask,
    /// The image, if the profile comes from one.
    pub(super) light: Option<Light<'a>>,
    /// Light along a course, column by column.
    pub(super) strip: &'a mut Vec<f64>,
    /// Evidence of every column's light for each of two lines.
    pub(super) evidence: &'a mut [Vec<f64>; 2],
    pub(super) scratch: &'a mut Vec<f64>,
}

/// Minimum strength of a rival blob, as a part of the stripe's strength.
const RIVAL: f64 = 0.4;

/// Reach beyond an edge in which an object may hide it: columns, and rows from the line.
const HIDING_COLUMNS: i32 = 8;
const HIDING_ROWS: f64 = 8.0;

/// Minimum slope of the face below an edge.
const STEEP: f64 = 2.0;

/// Rows between two courses at which one's light is outside the other's strip, and the maximum columns for it.
const APART: f64 = 7.0;
const MAX_BESIDE: f64 = 100.0;

/// Maximum distance of a point on a course from it, columns or rows.
const ON_COURSE: f64 = 2.0;

/// Columns of an end at the image's border.
const AT_RIM: usize = 3;

/// The end of a course.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Edge {
    /// Column, sub-pixel.
    column: f64,
    /// Position on the course.
    at: DVec2,
    /// Dark columns beyond it, within the inspected columns.
    dark: f64,
    /// Minimum dark columns of a gap.
    least_gap: f64,
    /// True if another object is there, so that the position is uncertain.
    hidden: bool,
}

/// Support of a detected joint, from which its confidence follows.
struct Support<'a> {
    /// Part of the points that lie on the joint's lines.
    share: f64,
    segments: &'a [Segment],
    /// 0 to 1: distance from the limits of the joint type.
    margin: f64,
    /// 0 to 1: confidence that the light on its parts begins and ends where they do.
    cover: f64,
    /// True if the light on all of it was checked, which is better evidence than the chain.
    covered: bool,
}

impl View<'_> {
    pub(super) fn joint(&mut self) -> Result<Features, NoFeatures> {
        match self.task.joint {
            JointKind::Fillet => self.fillet(),
            JointKind::V => self.v_groove(),
            JointKind::U => self.u_groove(),
            JointKind::J => self.j_groove(),
            JointKind::Lap => self.lap(),
            JointKind::Butt => self.butt(),
        }
    }

    fn pitch(&self) -> f64 {
        self.profile.pitch
    }

    fn grain(&self) -> f64 {
        self.profile.grain
    }

    fn samples(&self) -> &[Sample] {
        &self.profile.samples
    }

    /// Returns the end of a segment towards column `to`, not beyond it.
    fn edge(&mut self, segment: &Segment, to: i32) -> Option<Edge> {
        let Columns { from, to: last } = segment.columns;
        let middle = (from + last) / 2;
        let sure = if to >= middle { (last - middle).min(to - middle) } else { (middle - from).min(middle - to) };
        self.end(&Course::Line(segment.line), Columns { from: middle, to }, sure)
    }

    /// Returns the end of the light on a course in the columns, the first of which is lit. The first `sure` columns are
    /// assumed to be lit except for holes.
    fn end(&mut self, course: &Course, columns: Columns, sure: i32) -> Option<Edge> {
        self.look_along(course, columns);
        let sure = &self.strip[..(sure.max(0) as usize + 1).min(self.strip.len())];
        let usual = Usual::of(sure, self.scratch)?;
        let coarse = lit_columns(self.strip, &usual);
        // The end is unknown if the course leaves the image before it.
        let leaves = self.strip.iter().position(|v| v.is_nan()).is_some_and(|out| coarse + AT_RIM > out);
        if leaves {
            return None;
        }
        self.end_of(course, columns, &usual, coarse)
    }

    /// Returns the end of a segment whose last lit column is `last`; light beyond column `to` is ignored.
    fn end_at(&mut self, segment: &Segment, last: i32, to: i32) -> Option<Edge> {
        let course = Course::Line(segment.line);
        let from = (segment.columns.from + segment.columns.to) / 2;
        let to = if last > from { to.max(last) } else { to.min(last) };
        let columns = Columns { from, to };
        self.look_along(&course, columns);
        let lit = last.abs_diff(from) as usize + 1;
        let usual = Usual::of(&self.strip[..lit.min(self.strip.len())], self.scratch)?;
        self.end_of(&course, columns, &usual, lit)
    }

    /// Returns the sub-column end of the light in the strip.
    fn end_of(&self, course: &Course, columns: Columns, usual: &Usual, coarse: usize) -> Option<Edge> {
        let Columns { from, to } = columns;
        let lit = if self.light.is_some() {
            sub_column(self.strip, usual, coarse)
        } else {
            // As many columns may be missing as there are consecutive holes.
            coarse as f64 + (1.0 - usual.lit).min(0.5) / usual.lit.max(0.5)
        };
        let dark = self.strip.get(coarse..).unwrap_or_default().iter().filter(|v| usual.is_dark(**v)).count() as f64;
        let hidden = is_hidden(self.strip, usual, coarse.min(self.strip.len()));
        let column = f64::from(from) + (lit - 0.5) * if to >= from { 1.0 } else { -1.0 };
        Some(Edge { column, at: self.place(course, column)?, dark, least_gap: usual.least_gap(), hidden })
    }

    /// Fills the strip with the light along a course; without an image, with 1 for each point on it.
    fn look_along(&mut self, course: &Course, columns: Columns) {
        if let Some(light) = &self.light {
            light.along(self.profile, course, columns, self.strip);
            return;
        }
        let Columns { from, to } = columns;
        self.strip.clear();
        self.strip.resize(from.abs_diff(to) as usize + 1, 0.0);
        let within = ON_COURSE * self.grain();
        for s in self.profile.between(Columns { from: from.min(to), to: from.max(to) }) {
            if course.off(s.at).abs() <= within {
                self.strip[s.column.abs_diff(from) as usize] = 1.0;
            }
        }
    }

    fn place(&self, course: &Course, column: f64) -> Option<DVec2> {
        let y = self.profile.y_at(column);
        match &self.light {
            Some(light) => light.place(self.profile, course, column, y).map(|p| p.0),
            None => course.at(y),
        }
    }

    /// Returns the length of all segments on each one's line, mm: reflections cut the lines of a joint into several.
    fn lengths(&self) -> ArrayVec<f64, MAX_SEGMENTS> {
        let grain = self.grain();
        let on = |s: &Segment, line: &Segment| s.ends.iter().all(|e| line.line.off(*e).abs() < line.within(grain));
        let all = |line: &Segment| self.segments.iter().filter(|s| on(s, line)).map(Segment::length).sum();
        self.segments.iter().map(all).collect()
    }

    /// Returns the columns from the intersection of two lines to where one's light is outside the other's strip.
    fn clear_of(&self, a: &StripeLine, b: &StripeLine) -> i32 {
        let slope = |s: &StripeLine| s.along.y / s.along.x.max(1e-6);
        let apart = (slope(a) - slope(b)).abs() * self.pitch();
        (APART * self.profile.row / apart.max(1e-9)).ceil().min(MAX_BESIDE) as i32
    }

    /// Returns the part of `samples` on one of `segments`.
    fn share(&self, samples: &[Sample], segments: &[Segment]) -> f64 {
        let grain = self.grain();
        let on = |s: &&Sample| segments.iter().any(|g| g.line.off(s.at).abs() <= g.within(grain));
        samples.iter().filter(on).count() as f64 / samples.len().max(1) as f64
    }

    /// Returns the longest reflection beside the chain as a part of the columns. A reflection is as bright as the
    /// chain, off the chain and the joint's lines, and longer than spatter. If it is as long as a segment, the chain
    /// itself could be the reflection.
    fn rivals(&self, columns: Columns, segments: &[Segment]) -> f64 {
        let grain = self.grain();
        let on = |s: &Sample| segments.iter().any(|g| g.line.off(s.at).abs() <= g.within(grain).max(s.covers));
        // Last point and length of the reflections being followed, up to two per column.
        let mut followed: [(Option<Sample>, i32); 2] = [(None, 0); 2];
        let mut longest = 0;
        for s in self.profile.all_between(columns) {
            let own = self.profile.between(Columns { from: s.column, to: s.column }).first();
            let bright = |own: &Sample| s.strength > own.strength.map(|v| RIVAL * v) && s.at != own.at;
            if on(s) || !own.is_some_and(bright) {
                continue;
            }
            let near = |last: &Sample| s.column - last.column <= 3 && last.at.distance(s.at) < 8.0 * grain;
            let i = followed.iter().position(|f| f.0.as_ref().is_some_and(near)).unwrap_or_else(|| {
                let older = usize::from(followed[0].0.map(|l| l.column) > followed[1].0.map(|l| l.column));
                followed[older] = (None, 0);
                older
            });
            followed[i] = (Some(*s), followed[i].1 + 1);
            longest = longest.max(followed[i].1);
        }
        f64::from(longest) / f64::from((columns.to - columns.from + 1).max(1))
    }

    /// Returns true if an object off the joint's lines hides the end of a line, so that the end is unknown. Checks the
    /// columns beyond the edge towards `step` (1 right, -1 left).
    fn hidden(&self, edge: &Edge, line: &StripeLine, step: i32, segments: &[Segment]) -> bool {
        let grain = self.grain();
        let column = edge.column.round() as i32;
        let (a, b) = (column + step, column + step * HIDING_COLUMNS);
        let on = |s: &Sample| segments.iter().any(|g| g.line.off(s.at).abs() <= g.within(grain));
        // The face of a plate's end falls steeply from it.
        let face = |s: &Sample| -line.off(s.at) > STEEP * (s.at.x - edge.at.x).abs();
        let near = |s: &&Sample| line.off(s.at).abs() < s.covers + HIDING_ROWS * grain && !on(s) && !face(s);
        self.profile.all_between(Columns { from: a.min(b), to: a.max(b) }).iter().filter(near).count() >= 3
    }

    /// Returns the part of a segment's columns with a point on its line.
    fn density(&self, segment: &Segment) -> f64 {
        let within = segment.within(self.grain());
        let samples = self.profile.between(segment.columns);
        let on = samples.iter().filter(|s| segment.line.off(s.at).abs() <= within).count();
        on as f64 / f64::from((segment.columns.to - segment.columns.from + 1).max(1))
    }

    /// Returns the part of the columns with other light than the chain's.
    fn crowd(&self, columns: Columns) -> f64 {
        let own = self.profile.between(columns).len();
        let (mut seen, mut crowded, mut last) = (0, 0, (i32::MIN, 0));
        for s in self.profile.all_between(columns) {
            last = if last.0 == s.column { (s.column, last.1 + 1) } else { (s.column, 1) };
            seen += 1;
            crowded += u32::from(last.1 == 2);
        }
        // A column without a chain point has other light alone.
        let alone = f64::from(seen) - f64::from(crowded) - own as f64;
        (f64::from(crowded) + alone.max(0.0)) / f64::from((columns.to - columns.from + 1).max(1))
    }

    /// Returns how well the chain follows the joint, 0 to 1.
    fn followed(&self, support: &Support) -> f64 {
        let rival = |s: &Segment| self.rivals(s.columns, support.segments);
        let rivals = support.segments.iter().map(rival).fold(0.0, f64::max);
        let density = support.segments.iter().map(|s| self.density(s)).fold(f64::INFINITY, f64::min);
        ramp(support.share, 0.55, 0.85) * ramp(density, 0.3, 0.5) * ramp(rivals, 0.6, 0.35)
    }

    /// Builds the features; the confidence is the product of visibility, length, residual, margin and innovation.
    fn features(&self, points: &[(Feature, DVec2)], values: &[(Quantity, f64)], support: &Support) -> Features {
        let pitch = self.pitch();
        let shortest = support.segments.iter().map(Segment::length).fold(f64::INFINITY, f64::min);
        let columns = if shortest.is_finite() { shortest / pitch } else { 0.0 };
        let worst = support.segments.iter().map(|s| s.deviation).fold(0.0, f64::max) / self.grain();
        let innovation = match (&self.task.expected, points.first()) {
            (Some(expected), Some((_, at))) => {
                let off = at.distance(expected.at) / expected.within.max(1e-9);
                1.0 / (1.0 + (off / 3.0).powi(4))
            }
            _ => 1.0,
        };
        let chain = if support.covered { 1.0 } else { self.followed(support) };
        let finite = points.iter().all(|p| p.1.is_finite()) && values.iter().all(|v| v.1.is_finite());
        let factors = [
            (Doubt::Clutter, chain),
            (Doubt::Short, ramp(columns, 8.0, 30.0)),
            (Doubt::Uneven, ramp(worst, 6.0, 2.0)),
            (Doubt::Light, support.cover),
            (Doubt::Shape, support.margin.clamp(0.0, 1.0)),
            (Doubt::Moved, innovation),
            (Doubt::Unknown, if finite { 1.0 } else { 0.0 }),
        ];
        let confidence: f64 = factors.iter().map(|(_, factor)| factor).product();
        let weakest = factors.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)).map(|(doubt, _)| doubt);
        Features {
            kind: self.task.joint,
            points: points.iter().copied().collect::<ArrayVec<_, 6>>(),
            values: values.iter().copied().collect::<ArrayVec<_, 8>>(),
            confidence: if finite { confidence.abs() } else { 0.0 },
            doubt: weakest.filter(|_| !finite || confidence < Features::CONFIDENT),
        }
    }
}

/// Returns 0 at `none` and beyond, 1 at `full` and beyond.
fn ramp(value: f64, none: f64, full: f64) -> f64 {
    ((value - none) / (full - none)).clamp(0.0, 1.0)
}

/// Returns the turn from line `a` to line `b`, rad, positive to the left: a valley.
fn turn(a: &StripeLine, b: &StripeLine) -> f64 {
    a.along.perp_dot(b.along).atan2(a.along.dot(b.along))
}

/// Returns the unit direction halfway between two lines.
fn between(a: &StripeLine, b: &StripeLine) -> DVec2 {
    (a.along + b.along).normalize_or(DVec2::X)
}

/// Returns twice the area of a polygon, positive counter-clockwise.
fn twice_area(corners: &[DVec2]) -> f64 {
    corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum()
}
