use super::{Edge, Support, View, between, ramp, turn, twice_area};
use crate::stripe::profile::{Sample, median};
use crate::stripe::{Feature, Features, NoFeatures, Quantity, Segment};
use glam::DVec2;
use std::f64::consts::PI;

/// Included angles of a V groove, degrees.
const INCLUDED_DEG: [f64; 2] = [30.0, 130.0];

/// Most angle between the shoulders, rad.
pub(super) const SHOULDERS: f64 = 0.3;

/// Part of the usual strength from which on a column between two roots counts as lit.
const LIT: f64 = 0.4;

/// How far from a wall's line a closed root may be: the stripe's width rounds it, columns.
const ROUNDED: f64 = 6.0;

/// How far the ends of the walls may be from a closed root, columns.
const CLOSED: f64 = 16.0;

/// Part of a groove's columns with other light for no, and for full confidence.
pub(super) const CROWD: [f64; 2] = [0.9, 0.7];

/// How far a shoulder's last place may be from its edge for no, and for full confidence, columns.
const EDGE_OFF: [f64; 2] = [25.0, 12.0];

/// The four segments of a V groove.
struct V {
    shoulders: [Segment; 2],
    walls: [Segment; 2],
}

impl V {
    /// Whether the walls fall from parallel shoulders and rise again.
    fn is_one(&self) -> bool {
        let [left, right] = &self.shoulders;
        let [down, up] = &self.walls;
        let falls = turn(&left.line, &down.line) < -0.2;
        let rises = turn(&up.line, &right.line) < -0.2;
        falls && rises && turn(&down.line, &up.line) > 0.6 && turn(&left.line, &right.line).abs() < SHOULDERS
    }
}

impl View<'_> {
    /// Shoulder, wall, wall, shoulder; between the walls a gap, a short root or nothing.
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
        let walls = self.profile.between(down.columns.0, up.columns.1);
        let on_walls = self.share(walls, &v.walls);
        let degrees = included.to_degrees();
        let inside = (degrees - INCLUDED_DEG[0]).min(INCLUDED_DEG[1] - degrees);
        if inside < 0.0 || depth < 10.0 * self.grain() || on_walls < 0.5 || gap > 0.6 * width {
            return Err(NoFeatures::NoGroove);
        }
        let off = left.ends[1].distance(edge_left).max(right.ends[0].distance(edge_right)) / self.grain();
        let margin = if hidden { 0.0 } else { ramp(off, EDGE_OFF[0], EDGE_OFF[1]) };
        let crowd = self.crowd((left.columns.1, right.columns.0));
        let margin = margin * ramp(crowd, CROWD[0], CROWD[1]) * ramp(inside, 0.0, 5.0) * ramp(on_walls, 0.65, 0.85);
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
        Ok(self.features(&points, &values, &Support { share, segments: &all, margin }))
    }

    fn find_v(&self) -> Option<V> {
        let s = self.segments;
        let mut best: Option<(f64, V)> = None;
        // A wall may be cut in two, and there may be a short root between the walls.
        for i in 0..s.len() {
            for j in i + 3..s.len().min(i + 5) {
                for (a, b) in [(i + 1, j - 1), (i + 2, j - 1), (i + 1, j - 2)].into_iter().filter(|(a, b)| a < b) {
                    let v = V { shoulders: [s[i], s[j]], walls: [s[a], s[b]] };
                    let length = v.walls[0].length() + v.walls[1].length();
                    if v.is_one() && best.as_ref().is_none_or(|(most, _)| length > *most) {
                        best = Some((length, v));
                    }
                }
            }
        }
        best.map(|(_, v)| v)
    }

    /// Both roots: the ends of the walls if nothing is lit between them, else where the walls meet. And whether
    /// something hides them.
    fn roots(&mut self, v: &V, closed: DVec2, along: DVec2) -> ([DVec2; 2], bool) {
        let [down, up] = v.walls;
        // A wall's line goes on to the other wall: that one's places are no end of it.
        let middle = self.profile.column_at(closed.x).round() as i32;
        let ends = (self.edge(&down, middle), self.edge(&up, middle));
        let (Some(a), Some(b)) = ends else { return ([closed; 2], true) };
        // A closed root is where the walls end.
        let far = CLOSED * self.grain();
        let ends_there = a.at.distance(closed).max(b.at.distance(closed)) < far;
        if b.column - a.column < a.least_gap.max(b.least_gap) || (b.at - a.at).dot(along) <= 0.0 {
            return ([closed; 2], !ends_there);
        }
        let (on, elsewhere) = self.lit(&v.walls, closed, a, b);
        if on + elsewhere > 0.5 {
            return ([closed; 2], elsewhere > 0.3 || !ends_there);
        }
        let all = [v.shoulders[0], down, up, v.shoulders[1]];
        let hidden = self.hidden(&a, &down.line, 1, &all) || self.hidden(&b, &up.line, -1, &all);
        ([a.at, b.at], hidden)
    }

    /// Parts of the columns between two edges in which the stripe is seen on the walls, and off them but not far below.
    fn lit(&mut self, walls: &[Segment; 2], closed: DVec2, a: Edge, b: Edge) -> (f64, f64) {
        let (from, to, grain) = (a.column.ceil() as i32, b.column.floor() as i32, self.grain());
        let far = (12.0 + b.column - a.column) * grain;
        self.scratch.clear();
        let beside = walls.iter().flat_map(|w| self.profile.between(w.columns.0, w.columns.1));
        self.scratch.extend(beside.filter_map(|s| s.strength));
        let usual = median(self.scratch).unwrap_or(0.0);
        let bright = |s: &&Sample| s.strength.is_none_or(|v| v > LIT * usual) && s.at.distance(closed) < far;
        let on_wall = |s: &Sample| walls.iter().any(|w| w.line.off(s.at).abs() < ROUNDED * grain);
        let (mut on, mut off) = (0.0, 0.0);
        for s in self.profile.between(from, to).iter().filter(bright) {
            *(if on_wall(s) { &mut on } else { &mut off }) += 1.0;
        }
        let columns = f64::from((to - from + 1).max(1));
        (on / columns, off / columns)
    }
}

/// Height of the right shoulder's line over the left one's at `at`, square to `along`.
pub(super) fn mismatch(left: &Segment, right: &Segment, at: DVec2, along: DVec2) -> f64 {
    let height = |s: &Segment| {
        let to = s.line.at - at;
        // From `at` along the normal to the line.
        to.perp_dot(s.line.along) / along.perp().perp_dot(s.line.along)
    };
    height(right) - height(left)
}
