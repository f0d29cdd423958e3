use super::{Support, View, between, ramp, turn, twice_area};
use crate::stripe::edges::Edge;
use crate::stripe::{Feature, Features, NoFeatures, Quantity, Segment};
use glam::DVec2;
use std::f64::consts::PI;

/// Included angles of a V groove, degrees.
const INCLUDED_DEG: [f64; 2] = [30.0, 130.0];

/// Most angle between the shoulders, rad.
pub(super) const SHOULDERS: f64 = 0.3;

/// Part of the usual strength from which on a column between two roots counts as lit.
const LIT: f64 = 0.4;

/// The four segments of a V groove.
struct V {
    shoulders: [Segment; 2],
    walls: [Segment; 2],
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
        let roots = self.roots(&v, closed, along);
        let [a, b] = roots;
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
        if inside < 0.0 || depth < 10.0 * self.pitch() || on_walls < 0.5 || gap > 0.6 * width {
            return Err(NoFeatures::NoGroove);
        }
        let margin = ramp(inside, 0.0, 5.0) * ramp(on_walls, 0.5, 0.75);
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
        let fits = |i: usize, j: usize| {
            let [left, down, up, right] = [s[i], s[i + 1], s[j - 1], s[j]];
            let falls = turn(&left.line, &down.line) < -0.2;
            let rises = turn(&up.line, &right.line) < -0.2;
            falls && rises && turn(&down.line, &up.line) > 0.6 && turn(&left.line, &right.line).abs() < SHOULDERS
        };
        let pairs = (0..s.len()).flat_map(|i| (i + 3..s.len().min(i + 5)).map(move |j| (i, j)));
        let (i, j) = pairs.filter(|&(i, j)| fits(i, j)).max_by(|a, b| {
            let walls = |&(i, j): &(usize, usize)| s[i + 1].length() + s[j - 1].length();
            walls(a).total_cmp(&walls(b))
        })?;
        Some(V { shoulders: [s[i], s[j]], walls: [s[i + 1], s[j - 1]] })
    }

    /// Both roots: the ends of the walls if nothing is lit between them, else where the walls meet.
    fn roots(&mut self, v: &V, closed: DVec2, along: DVec2) -> [DVec2; 2] {
        let [down, up] = v.walls;
        let ends = (self.edge(&down, up.columns.0), self.edge(&up, down.columns.1));
        let (Some(a), Some(b)) = ends else { return [closed; 2] };
        if b.column - a.column < 1.5 || (b.at - a.at).dot(along) <= 0.0 || self.lit(&v.walls, closed, a, b) > 0.5 {
            return [closed; 2];
        }
        [a.at, b.at]
    }

    /// Part of the columns between two edges in which the stripe is seen, and not far below.
    fn lit(&mut self, walls: &[Segment; 2], closed: DVec2, a: Edge, b: Edge) -> f64 {
        let (from, to) = (a.column.ceil() as i32, b.column.floor() as i32);
        let far = 12.0 * self.pitch() + (b.column - a.column) * self.pitch();
        self.scratch.clear();
        let beside = walls.iter().flat_map(|w| self.profile.between(w.columns.0, w.columns.1));
        self.scratch.extend(beside.filter_map(|s| s.strength));
        let usual = crate::stripe::profile::median(self.scratch).unwrap_or(0.0);
        let is_lit = |s: &&crate::stripe::profile::Sample| {
            s.strength.is_none_or(|strength| strength > LIT * usual) && s.at.distance(closed) < far
        };
        let lit = self.profile.between(from, to).iter().filter(is_lit).count();
        lit as f64 / f64::from((to - from + 1).max(1))
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
