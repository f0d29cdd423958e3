//! Grooves whose walls end in arcs: U and J grooves.

use super::completeness::Part;
use super::groove::{SHOULDERS, mismatch};
use super::{Edge, Support, View, between, ramp, turn};
use crate::stripe::features::{Feature, Features, NoFeatures, Quantity};
use crate::stripe::fit::{StripeArc, StripeLine, line};
use crate::stripe::light::Course;
use crate::stripe::profile::{Columns, Sample};
use crate::stripe::segments::Segment;
use arrayvec::ArrayVec;
use glam::DVec2;

/// Triples of points tried for an arc.
const TRIALS: u32 = 250;

/// Maximum radius as a part of the groove's width, and minimum radius in columns.
const WIDEST: f64 = 0.75;
const MIN_RADIUS: f64 = 15.0;

/// Minimum ratio of the points on an arc to those on a line, for full confidence.
const BETTER: f64 = 1.15;

/// Minimum part of a U groove's arc on its own side of the centre.
const OWN_SIDE: f64 = 0.7;

/// Part of an arc's radius beside its end along which light is measured.
const ARC_PART: f64 = 0.6;

/// Weight of the arcs' lowest points in an open U groove's roots; the ends of the light have the rest. Their errors in
/// the gap are 0.027 and 0.033 mm at 0.05 mm a column, with little correlation (0.2). The weight is below the optimum
/// for these, because the arcs' errors are mostly one way.
const ARC_TELLS: f64 = 0.25;

/// Difference between the gap from the roots' ends and that from the arcs, columns, for no and for full confidence.
const DISAGREE: [f64; 2] = [8.0, 4.0];

/// Part of an arc's radius to the side of its centre that must be lit; beyond it the arc is too steep.
const ARC_SEEN: f64 = 0.8;

/// Maximum apparent overlap of the sides of a closed J groove, columns.
const CLOSED: f64 = 4.0;

/// Part of a J groove's radius beside the root that may be in the shadow of the upright side.
const SHADOW: f64 = 0.35;

/// Distance of edges from the ends of the shoulders, columns or rows, for no and for full confidence.
const EDGE_OFF: [f64; 2] = [24.0, 12.0];

/// Distance beyond the end of a shoulder from which it must be dark, columns.
const AFTER_EDGE: i32 = 4;

/// A groove between two shoulders.
struct Groove {
    shoulders: [Segment; 2],
    /// Mean direction of the shoulders.
    along: DVec2,
    /// Columns between the ends of the shoulders.
    inside: Columns,
    /// Ends of the shoulders.
    ends: [DVec2; 2],
    /// True if another object is seen at one of them.
    hidden: bool,
}

/// A curved side: arc at the root, wall above it.
struct Side {
    arc: StripeArc,
    deviation: f64,
    /// Part of the side's points on the arc or wall, and the ratio of points on the arc to those on the best line.
    share: f64,
    better: f64,
    /// Part of the arc's points on this side of its centre.
    own_side: f64,
    /// The wall above the arc, if enough of it is visible.
    wall: Option<StripeLine>,
    /// Intersection of wall and shoulder.
    edge: DVec2,
}

/// Measurements of a groove with curved sides.
struct Measured {
    /// Left and right root, mm.
    roots: [DVec2; 2],
    /// Left and right edge, mm.
    edges: [DVec2; 2],
    /// Root gap, mm.
    gap: f64,
    /// Angle of the walls, rad; `None` if too little of them is visible.
    angle: Option<f64>,
    /// Radius of the arcs, mm.
    radius: f64,
    /// 0 to 1: distance from the limits of the joint type.
    margin: f64,
}

impl View<'_> {
    /// Detects two curved sides.
    pub(super) fn u_groove(&mut self) -> Result<Features, NoFeatures> {
        let groove = self.groove().ok_or(NoFeatures::NoGroove)?;
        let Columns { from: first, to: last } = groove.inside;
        let middle = (first + last) / 2;
        let left = self.side(&groove, Columns { from: first, to: middle }, 0).ok_or(NoFeatures::NoGroove)?;
        let right = self.side(&groove, Columns { from: middle + 1, to: last }, 1).ok_or(NoFeatures::NoGroove)?;
        let up = groove.along.perp();
        let lowest = [left.arc.centre - left.arc.radius * up, right.arc.centre - right.arc.radius * up];
        let unequal = (left.arc.radius - right.arc.radius).abs() / (left.arc.radius + right.arc.radius);
        let apart = (lowest[1] - lowest[0]).dot(groove.along);
        // It is dark between open roots; a closed root is in the middle of the arcs' lowest points.
        let middle = (lowest[0] + lowest[1]) / 2.0;
        let to = self.profile.column_at(middle.x).round() as i32;
        let ends = (self.arc_end(&left.arc, first, to), self.arc_end(&right.arc, last, to));
        let (Some(a), Some(b)) = ends else { return Err(NoFeatures::NoGroove) };
        let open = a.dark + b.dark >= a.least_gap.max(b.least_gap) && b.column > a.column;
        let ends = if open { [a.at, b.at] } else { [middle; 2] };
        let dark = (ends[1] - ends[0]).dot(groove.along).max(0.0);
        // The gap from the arcs must not differ much from the dark gap.
        let agree = ramp((dark - apart).abs() / self.pitch(), DISAGREE[0], DISAGREE[1]);
        // The ends of the light are known to a column; the lowest points of the arcs have independent errors.
        let roots = if open { [0, 1].map(|i| ends[i].lerp(lowest[i], ARC_TELLS)) } else { ends };
        let gap = (roots[1] - roots[0]).dot(groove.along).max(0.0);
        if unequal > 0.25 || apart < -8.0 * self.pitch() || left.own_side.min(right.own_side) < OWN_SIDE {
            return Err(NoFeatures::NoGroove);
        }
        let margin = if a.hidden || b.hidden { 0.0 } else { agree };
        let margin = margin * ramp(unequal, 0.25, 0.1);
        let angle = match (left.wall, right.wall) {
            (Some(a), Some(b)) => Some(std::f64::consts::PI - turn(&a, &b)),
            _ => None,
        };
        let radius = (left.arc.radius + right.arc.radius) / 2.0;
        let edges = [left.edge, right.edge];
        Ok(self.round_features(&groove, &[left, right], &Measured { roots, edges, gap, angle, radius, margin }))
    }

    /// Returns the end of an arc on the way from column `shoulder` to column `to`.
    fn arc_end(&mut self, arc: &StripeArc, shoulder: i32, to: i32) -> Option<Edge> {
        // The upper parts of an arc are steep, and the side may leave the arc there.
        let beside = ARC_PART * arc.radius / self.pitch();
        let from = if to >= shoulder {
            shoulder.max(to - beside.round() as i32)
        } else {
            shoulder.min(to + beside.round() as i32)
        };
        self.end(&Course::Arc(*arc), Columns { from, to }, from.abs_diff(to) as i32 / 2)
    }

    /// Detects one curved and one upright side; the upright one is invisible between shoulder and root.
    pub(super) fn j_groove(&mut self) -> Result<Features, NoFeatures> {
        let groove = self.groove().ok_or(NoFeatures::NoGroove)?;
        let inside = self.profile.between(groove.inside);
        let (_, arc) = self.best_arc(&groove, inside).ok_or(NoFeatures::NoGroove)?;
        let within = 2.0 * self.grain();
        let on = |s: &&Sample| arc.off(s.at).abs() < within;
        let right_of = |s: &&Sample| (s.at - arc.centre).dot(groove.along) > 0.0;
        let count = inside.iter().filter(on).count() as f64;
        let right = inside.iter().filter(on).filter(right_of).count() as f64 / count;
        let curved = usize::from(right > 0.5);
        let one_sided = right.max(1.0 - right);
        let side = self.side(&groove, groove.inside, curved).ok_or(NoFeatures::NoGroove)?;
        let root = side.arc.centre - side.arc.radius * groove.along.perp();
        // The upright side stands below the end of its shoulder.
        let upright = groove.ends[1 - curved];
        let across = (root - upright).dot(groove.along);
        let foot = root - across * groove.along;
        let apart = if curved == 1 { across } else { -across };
        let gap = if apart > 3.0 * self.pitch() { apart } else { 0.0 };
        let width = (groove.ends[1] - groove.ends[0]).dot(groove.along);
        if one_sided < 0.75 || apart > 0.5 * width || apart < -CLOSED * self.pitch() {
            return Err(NoFeatures::NoGroove);
        }
        // A root gap is dark.
        let column = |p: DVec2| inside.iter().position(|s| (s.at - p).dot(groove.along) >= 0.0).unwrap_or(inside.len());
        let lit = column(upright).abs_diff(column(root)) as f64;
        let dark = if gap > 0.0 { ramp(lit * self.pitch() / gap, 0.8, 0.5) } else { 1.0 };
        let margin = if groove.hidden { 0.0 } else { dark * ramp(one_sided, 0.75, 0.9) };
        let angle = side.wall.map(|w| w.along.dot(groove.along).clamp(-1.0, 1.0).asin());
        let (radius, edge) = (side.arc.radius, side.edge);
        let (roots, edges) =
            if curved == 1 { ([foot, root], [upright, edge]) } else { ([root, foot], [edge, upright]) };
        Ok(self.round_features(&groove, &[side], &Measured { roots, edges, gap, angle, radius, margin }))
    }

    fn round_features(&mut self, groove: &Groove, sides: &[Side], measured: &Measured) -> Features {
        let Measured { roots, edges, gap, angle, radius, margin } = *measured;
        let joint = (roots[0] + roots[1]) / 2.0;
        let roots = if gap > 0.0 { roots } else { [joint; 2] };
        let [left, right] = groove.shoulders;
        let depth = -groove.along.perp_dot(joint - (edges[0] + edges[1]) / 2.0);
        let better = sides.iter().map(|s| s.better).fold(f64::INFINITY, f64::min);
        let share = sides.iter().map(|s| s.share).fold(f64::INFINITY, f64::min);
        let worst = sides.iter().map(|s| s.deviation).fold(0.0, f64::max) / self.grain();
        let margin = margin * ramp(better, 1.0, BETTER) * ramp(share, 0.6, 0.8) * ramp(worst, 1.2, 0.8);
        let seen = self.profile.between(groove.inside).len() as f64;
        let columns = f64::from(groove.inside.to - groove.inside.from + 1) - gap / self.pitch();
        let margin = margin * ramp(seen / columns.max(1.0), 0.4, 0.6);
        // Walls and shoulders meet at the ends of the shoulders' light.
        let off = [0, 1].map(|i| edges[i].distance(groove.ends[i]) / self.grain());
        let margin = margin * ramp(off[0].max(off[1]), EDGE_OFF[0], EDGE_OFF[1]);
        let cover = self.cover(&self.round_parts(groove, sides, roots));
        let shoulders = self.share(self.samples(), &groove.shoulders);
        let inside = self.profile.between(groove.inside).len() as f64 / self.samples().len() as f64;
        let share = shoulders + share * inside;
        let support = Support { share, segments: &groove.shoulders, margin, cover, covered: true };
        let points = [
            (Feature::Joint, joint),
            (Feature::LeftEdge, edges[0]),
            (Feature::RightEdge, edges[1]),
            (Feature::LeftRoot, roots[0]),
            (Feature::RightRoot, roots[1]),
        ];
        let values = [
            (Quantity::Gap, gap),
            (Quantity::Mismatch, mismatch(&left, &right, joint, groove.along)),
            (Quantity::Area, self.area(groove, edges, roots)),
            (Quantity::Bend, turn(&left.line, &right.line)),
            (Quantity::Width, edges[0].distance(edges[1])),
            (Quantity::Depth, depth),
            (Quantity::Radius, radius),
            (Quantity::Angle, angle.unwrap_or(0.0)),
        ];
        let known = if angle.is_some() { 8 } else { 7 };
        self.features(&points, &values[..known], &support)
    }

    /// Returns the shoulders, and the arcs except for their steep parts.
    fn round_parts(&self, groove: &Groove, sides: &[Side], roots: [DVec2; 2]) -> ArrayVec<Part, 4> {
        let column = |p: DVec2| self.profile.column_at(p.x).round() as i32;
        let last = self.profile.columns() as i32 - 1;
        let mut parts = ArrayVec::new();
        for (i, shoulder) in groove.shoulders.iter().enumerate() {
            let end = column(groove.ends[i]);
            let (columns, dark_after) = if i == 0 {
                (Columns { from: 0, to: end - 1 }, [None, Some(AFTER_EDGE)])
            } else {
                (Columns { from: end + 1, to: last }, [Some(AFTER_EDGE), None])
            };
            parts.push(Part { course: Course::Line(shoulder.line), columns, dark_after });
        }
        for side in sides {
            let outward = (side.edge - side.arc.centre).dot(groove.along).signum();
            let root = if outward > 0.0 { roots[1] } else { roots[0] };
            let (root, upper) =
                (column(root), column(side.arc.centre + outward * ARC_SEEN * side.arc.radius * DVec2::X));
            // The upright side of a J groove may cast its shadow on the root.
            let root = if sides.len() == 1 {
                column(side.arc.centre + outward * SHADOW * side.arc.radius * DVec2::X)
            } else {
                root
            };
            let columns = if outward > 0.0 {
                Columns { from: root + 1, to: upper }
            } else {
                Columns { from: upper, to: root - 1 }
            };
            parts.push(Part { course: Course::Arc(side.arc), columns, dark_after: [None; 2] });
        }
        parts
    }

    /// Returns two parallel shoulders and the range between them, whose points are mostly below both.
    fn groove(&mut self) -> Option<Groove> {
        let (left, right) = self.shoulders()?;
        let a = self.edge(&left, right.columns.from)?;
        let b = self.edge(&right, left.columns.to)?;
        let inside = Columns { from: a.column.ceil() as i32, to: b.column.floor() as i32 };
        let along = between(&left.line, &right.line);
        let samples = self.profile.between(inside);
        let below = |s: &&Sample| left.line.off(s.at).max(right.line.off(s.at)) < 0.0;
        let deep = samples.iter().filter(below).count();
        let enough = samples.len() >= 40 && 4 * deep > 3 * samples.len();
        enough.then_some(Groove {
            shoulders: [left, right],
            along,
            inside,
            ends: [a.at, b.at],
            hidden: a.hidden || b.hidden,
        })
    }

    /// Returns the longest parallel lines with segments below both between them.
    fn shoulders(&self) -> Option<(Segment, Segment)> {
        let (s, lengths) = (self.segments, self.lengths());
        let deep = 10.0 * self.grain();
        let mut best: Option<(f64, (Segment, Segment))> = None;
        for (i, j) in (0..s.len()).flat_map(|i| (i + 2..s.len()).map(move |j| (i, j))) {
            let (left, right) = (&s[i], &s[j]);
            let below = |k: &Segment| {
                let middle = (k.ends[0] + k.ends[1]) / 2.0;
                left.line.off(middle).max(right.line.off(middle)) < -deep
            };
            let between: f64 = s[i + 1..j].iter().filter(|k| below(k)).map(Segment::length).sum();
            let score = lengths[i] + lengths[j] + between;
            let parallel = turn(&left.line, &right.line).abs() <= SHOULDERS;
            if parallel && between > 0.0 && best.as_ref().is_none_or(|(most, _)| score > *most) {
                best = Some((score, (*left, *right)));
            }
        }
        best.map(|(_, pair)| pair)
    }

    /// Returns the arc with the highest score for `samples`, and the score, from a fixed set of triples.
    fn best_arc(&self, groove: &Groove, samples: &[Sample]) -> Option<(f64, StripeArc)> {
        let width = groove.ends[0].distance(groove.ends[1]);
        let within = 2.0 * self.grain();
        let n = samples.len();
        let mut best: Option<(f64, StripeArc)> = None;
        let mut state = 0x2545_f491u32;
        let mut draw = || {
            // Marsaglia's xorshift: the same triples every time.
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            state as usize % n
        };
        for _ in 0..if n < 12 { 0 } else { TRIALS } {
            let [a, b, c] = [draw(), draw(), draw()].map(|i| samples[i]);
            if (a.column - b.column).abs().min((b.column - c.column).abs()).min((a.column - c.column).abs()) < 6 {
                continue;
            }
            let Some(arc) = StripeArc::through(a.at, b.at, c.at) else { continue };
            let hollow = (arc.centre - (a.at + b.at + c.at) / 3.0).dot(groove.along.perp()) > 0.0;
            if !hollow || arc.radius > WIDEST * width || arc.radius < MIN_RADIUS * self.pitch() {
                continue;
            }
            // Near points count more, since arcs of another radius are within the limit too.
            let near = |s: &Sample| (1.0 - (arc.off(s.at) / within).powi(2)).max(0.0);
            let score = samples.iter().step_by(2).map(near).sum();
            if best.is_none_or(|(most, _)| score > most) {
                best = Some((score, arc));
            }
        }
        best
    }

    /// Measures the curved side in `columns`: its arc, and the wall between it and shoulder `end`.
    fn side(&mut self, groove: &Groove, columns: Columns, end: usize) -> Option<Side> {
        let (floor, within) = (0.3 * self.grain(), 2.0 * self.grain());
        let samples = self.profile.between(columns);
        let (_, start) = self.best_arc(groove, samples)?;
        let (arc, deviation) = start.refined(samples, floor, self.scratch)?;
        let on_arc = |s: &Sample| arc.off(s.at).abs() < within.max(3.0 * deviation);
        let count = samples.iter().filter(|s| on_arc(s)).count();
        let outward = if end == 1 { groove.along } else { -groove.along };
        let own = samples.iter().filter(|s| on_arc(s) && (s.at - arc.centre).dot(outward) > 0.0).count();
        let own_side = own as f64 / count.max(1) as f64;
        let (straight, _) = line(samples, None, floor, self.scratch)?;
        let on_line = samples.iter().filter(|s| straight.off(s.at).abs() < within).count();
        let shoulder = groove.shoulders[end];
        let flank = samples.iter().position(|s| !on_arc(s) && (s.at - arc.centre).dot(outward) > 0.5 * arc.radius);
        let wall = flank.and_then(|_| self.wall(groove, &arc, columns, end));
        let edge = wall.and_then(|w| w.meets(&shoulder.line)).unwrap_or(groove.ends[end]);
        let on = |s: &&Sample| on_arc(s) || wall.is_some_and(|w| w.off(s.at).abs() < 2.0 * within);
        let share = samples.iter().filter(on).count() as f64 / samples.len() as f64;
        let better = count as f64 / on_line.max(1) as f64;
        Some(Side { arc, deviation, share, better, own_side, wall, edge })
    }

    /// Fits the straight wall between the arc and shoulder `end`. It is steep, so it has few columns.
    fn wall(&mut self, groove: &Groove, arc: &StripeArc, columns: Columns, end: usize) -> Option<StripeLine> {
        let grain = self.grain();
        let samples = self.profile.between(columns);
        let outward = if end == 1 { groove.along } else { -groove.along };
        let beyond = |s: &Sample| (s.at - arc.centre).dot(outward) > 0.6 * arc.radius && arc.off(s.at) > 2.0 * grain;
        let below = |s: &Sample| groove.shoulders[end].line.off(s.at) < -4.0 * grain;
        let fits = |s: &Sample| beyond(s) && below(s);
        let first = samples.iter().position(fits)?;
        let last = samples.iter().rposition(fits)?;
        if last < first + 5 {
            return None;
        }
        line(&samples[first..=last], None, 0.3 * grain, self.scratch).map(|(line, _)| line)
    }

    /// Returns the area between the line through both edges and the points inside.
    fn area(&self, groove: &Groove, edges: [DVec2; 2], roots: [DVec2; 2]) -> f64 {
        let [from, to] = edges;
        let along = (to - from).normalize_or(groove.along);
        let length = (to - from).length();
        let down = |p: DVec2| ((p - from).dot(along), -along.perp_dot(p - from));
        let inside = self.profile.between(groove.inside).iter().map(|s| down(s.at));
        let (first, end) = (down(roots[0]), down(roots[1]));
        // The roots of upright sides count, as no points are beyond them. Points close to the edges are left out: they
        // are the ends of the shoulders.
        let beside = 2.0 * self.grain();
        let seen = move |t: f64| t > beside && t < length - beside;
        let path = [first].into_iter().filter(|r| r.0 < 0.05 * length).chain(inside.filter(move |(t, _)| seen(*t)));
        let path = path.chain([end].into_iter().filter(|r| r.0 > 0.95 * length)).chain([(length, 0.0)]);
        let (mut area, mut last) = (0.0, (0.0f64, 0.0f64));
        for (t, d) in path {
            area += (t - last.0) * (d + last.1) / 2.0;
            last = (t, d);
        }
        area
    }
}
