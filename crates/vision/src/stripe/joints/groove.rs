use super::completeness::Part;
use super::{Edge, Support, View, between, ramp, turn, twice_area};
use crate::stripe::features::{Feature, Features, NoFeatures, Quantity};
use crate::stripe::light::Course;
use crate::stripe::profile::{Columns, Sample, median};
use crate::stripe::segments::Segment;
use glam::DVec2;
use std::f64::consts::PI;

/// Included angles of a V groove, degrees.
const INCLUDED_DEG: [f64; 2] = [30.0, 130.0];

/// Maximum angle between the shoulders, rad.
pub(super) const SHOULDERS: f64 = 0.3;

/// Minimum strength of a lit column between two roots, as a part of the usual strength.
const LIT: f64 = 0.4;

/// Maximum lit part of the columns between two roots, for a closed root and for an open one. Then the minimum slope of
/// the faces below them.
const LIT_ROOT: [f64; 2] = [0.5, 0.25];
const FACE: f64 = 4.0;

/// Maximum distance of a closed root from a wall's line, columns or rows: the stripe's width rounds it.
const ROUNDED: f64 = 6.0;

/// Maximum distance of the walls' ends from a closed root, columns or rows.
const CLOSED: f64 = 16.0;

/// The four segments of a V groove.
struct V {
    shoulders: [Segment; 2],
    walls: [Segment; 2],
}

impl V {
    /// Returns true if the walls fall from parallel shoulders and rise again.
    fn is_one(&self) -> bool {
        let [left, right] = &self.shoulders;
        let [down, up] = &self.walls;
        let corners = [left.line.meets(&down.line), down.line.meets(&up.line), up.line.meets(&right.line)];
        let [Some(a), Some(b), Some(c)] = corners else { return false };
        let falls = turn(&left.line, &down.line) < -0.2;
        let rises = turn(&up.line, &right.line) < -0.2;
        a.x < b.x
            && b.x < c.x
            && falls
            && rises
            && turn(&down.line, &up.line) > 0.6
            && turn(&left.line, &right.line).abs() < SHOULDERS
    }
}

impl View<'_> {
    /// Detects shoulder, wall, wall, shoulder, with a gap, a short root or nothing between the walls.
    pub(super) fn v_groove(&mut self) -> Result<Features, NoFeatures> {
        let v = self.find_v().ok_or(NoFeatures::NoGroove)?;
        let [left, right] = v.shoulders;
        let [down, up] = v.walls;
        let all = [left, down, up, right];
        let edge_left = left.line.meets(&down.line).ok_or(NoFeatures::NoGroove)?;
        let edge_right = up.line.meets(&right.line).ok_or(NoFeatures::NoGroove)?;
        let closed = down.line.meets(&up.line).ok_or(NoFeatures::NoGroove)?;
        let along = between(&left.line, &right.line);
        let ([a, b], hidden) = self.roots(&v, closed, along);
        let joint = (a + b) / 2.0;
        let gap = (b - a).dot(along).max(0.0);
        let included = PI - turn(&down.line, &up.line);
        let depth = -along.perp_dot(joint - (edge_left + edge_right) / 2.0);
        let width = edge_right.distance(edge_left);
        let area = twice_area(&[edge_left, a, b, edge_right]).max(0.0) / 2.0;
        let share = self.share(self.samples(), &all);
        let degrees = included.to_degrees();
        let inside = (degrees - INCLUDED_DEG[0]).min(INCLUDED_DEG[1] - degrees);
        if inside < 0.0 || depth < 10.0 * self.grain() || gap > 0.6 * width {
            return Err(NoFeatures::NoGroove);
        }
        let cover = if hidden { 0.0 } else { self.cover(&self.v_parts(&v, [edge_left, a, b, edge_right])) };
        let margin = ramp(inside, 0.0, 5.0);
        let values = [
            (Quantity::Gap, gap),
            (Quantity::Mismatch, mismatch(&left, &right, joint, along)),
            (Quantity::Area, area),
            (Quantity::Angle, included),
            (Quantity::Bend, turn(&left.line, &right.line)),
            (Quantity::Width, width),
            (Quantity::Depth, depth),
        ];
        let points = [
            (Feature::Joint, joint),
            (Feature::LeftEdge, edge_left),
            (Feature::RightEdge, edge_right),
            (Feature::LeftRoot, a),
            (Feature::RightRoot, b),
        ];
        Ok(self.features(&points, &values, &Support { share, segments: &all, margin, cover, covered: true }))
    }

    /// Returns the shoulder, wall, wall and shoulder on the longest lines that make a groove.
    fn find_v(&self) -> Option<V> {
        let (s, lengths) = (self.segments, self.lengths());
        let mut best: Option<(f64, V)> = None;
        // A line may be cut into several segments, with a short root or reflections between them.
        for i in 0..s.len() {
            for j in i + 3..s.len() {
                for (a, b) in (i + 1..j).flat_map(|a| (a + 1..j).map(move |b| (a, b))) {
                    let v = V { shoulders: [s[i], s[j]], walls: [s[a], s[b]] };
                    let length = lengths[i] + lengths[a] + lengths[b] + lengths[j];
                    if best.as_ref().is_none_or(|(most, _)| length > *most) && v.is_one() {
                        best = Some((length, v));
                    }
                }
            }
        }
        best.map(|(_, v)| v)
    }

    /// Returns the parts of the groove between its edges and roots.
    fn v_parts(&self, v: &V, corners: [DVec2; 4]) -> [Part; 4] {
        let [left, right] = v.shoulders.map(|s| s.line);
        let [down, up] = v.walls.map(|s| s.line);
        let [edge_left, a, b, edge_right] = corners.map(|p| self.profile.column_at(p.x));
        let part = |line, from: f64, to: f64, dark_after| Part {
            course: Course::Line(line),
            columns: Columns { from: from.ceil() as i32 + 1, to: to.floor() as i32 - 1 },
            dark_after,
        };
        let [at_left, at_root, at_right] =
            [self.clear_of(&left, &down), self.clear_of(&down, &up), self.clear_of(&up, &right)].map(Some);
        let last = f64::from(self.profile.columns() as u32);
        [
            part(left, -1.0, edge_left, [None, at_left]),
            part(down, edge_left, a, [at_left, at_root]),
            part(up, b, edge_right, [at_root, at_right]),
            part(right, edge_right, last, [at_right, None]),
        ]
    }

    /// Returns both roots: the walls' ends if no light is between them, else the intersection of the walls. Also
    /// returns true if another object hides them.
    fn roots(&mut self, v: &V, closed: DVec2, along: DVec2) -> ([DVec2; 2], bool) {
        let [down, up] = v.walls;
        // A wall's line continues to the other wall, whose points do not extend it.
        let middle = self.profile.column_at(closed.x).round() as i32;
        let ends = (self.edge(&down, middle), self.edge(&up, middle));
        let (Some(a), Some(b)) = ends else { return ([closed; 2], true) };
        // The walls end at a closed root.
        let (far, hidden) = (CLOSED * self.grain(), a.hidden || b.hidden);
        let ends_there = a.at.distance(closed).max(b.at.distance(closed)) < far;
        if a.dark + b.dark < a.least_gap.max(b.least_gap) || (b.at - a.at).dot(along) <= 0.0 {
            return ([closed; 2], hidden || !ends_there);
        }
        let (on, elsewhere) = self.lit(&v.walls, closed, a, b);
        if on + elsewhere > LIT_ROOT[0] {
            return ([closed; 2], hidden || elsewhere > 0.1 || !ends_there);
        }
        ([a.at, b.at], hidden || on + elsewhere > LIT_ROOT[1])
    }

    /// Returns the parts of the columns between two edges with the stripe on the walls, and off them but not far below.
    fn lit(&mut self, walls: &[Segment; 2], closed: DVec2, a: Edge, b: Edge) -> (f64, f64) {
        let (from, to, grain) = (a.column.ceil() as i32, b.column.floor() as i32, self.grain());
        let far = (12.0 + b.column - a.column) * grain;
        self.scratch.clear();
        self.scratch.extend(walls.iter().flat_map(|w| self.profile.between(w.columns)).filter_map(|s| s.strength));
        let usual = median(self.scratch).unwrap_or(0.0);
        let bright = |s: &&Sample| s.strength.is_none_or(|v| v > LIT * usual) && s.at.distance(closed) < far;
        let on_wall = |s: &Sample| walls.iter().any(|w| w.line.off(s.at).abs() < ROUNDED * grain);
        let (mut on, mut off) = (0.0, 0.0);
        // The face below a root is seen steeply.
        let face = |s: &&Sample| [a, b].iter().any(|e| e.at.y - s.at.y > FACE * (s.at.x - e.at.x).abs());
        for s in self.profile.between(Columns { from, to }).iter().filter(bright).filter(|s| !face(s)) {
            *(if on_wall(s) { &mut on } else { &mut off }) += 1.0;
        }
        let columns = f64::from((to - from + 1).max(1));
        (on / columns, off / columns)
    }
}

/// Returns the height of the right shoulder's line above the left one's at `at`, perpendicular to `along`.
pub(super) fn mismatch(left: &Segment, right: &Segment, at: DVec2, along: DVec2) -> f64 {
    let height = |s: &Segment| {
        let to = s.line.at - at;
        // Distance from `at` along the normal to the line.
        to.perp_dot(s.line.along) / along.perp().perp_dot(s.line.along)
    };
    height(right) - height(left)
}
