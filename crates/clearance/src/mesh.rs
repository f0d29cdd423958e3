//! Closed surfaces of triangles.

mod surface;

use crate::boxes::{Bounds, Node, tree};
use crate::cells::Cells;
use crate::convex::{Convex, Gap, nearest};
use crate::error::ClearanceError;
use glam::{DAffine3, DVec3};
use std::sync::Arc;

/// A closed surface of triangles, mm, with a tree of boxes over them. The inside is solid.
///
/// A point is inside if the surface winds around it, so bodies may overlap and may have cavities. The overlap of two
/// bodies of opposite orientation counts as outside. A region may be cut away: [`Mesh::without`].
#[derive(Debug, Clone)]
pub struct Mesh {
    /// In the order of the tree's leaves.
    triangles: Vec<[DVec3; 3]>,
    nodes: Vec<Node>,
    /// One corner of each piece of the surface.
    pieces: Vec<DVec3>,
    centre: DVec3,
    reach: f64,
    /// The whole body of a mesh with a region cut away, and that region.
    cut: Option<(Arc<Mesh>, Arc<Cells>)>,
}

/// Index of the last nearest triangle, the initial guess of the next search.
pub(crate) type Last = usize;

impl Mesh {
    /// A mesh from the corners of its triangles, mm. Triangles without area are dropped if the rest is closed without
    /// them; triangles of the wrong orientation are reversed.
    ///
    /// # Errors
    /// Corners that are not finite or beyond 1e7 mm, no triangles, edges that do not belong to exactly two triangles.
    pub fn new(triangles: &[[DVec3; 3]]) -> Result<Self, ClearanceError> {
        let (triangles, pieces) = surface::closed(triangles)?;
        Ok(Self::of(&triangles, pieces, None))
    }

    /// The body of this mesh without the region `away`: the parts of its surface outside of the region, and `walls`, the
    /// region's own surface within the body.
    ///
    /// `walls` may have parts outside of the body; they count as thin sheets.
    #[must_use]
    pub fn without(self: &Arc<Self>, away: &Arc<Cells>, walls: &[[DVec3; 3]]) -> Self {
        let outside = self.triangles.iter().flat_map(|t| away.outside(*t));
        let triangles: Vec<[DVec3; 3]> = outside.chain(walls.iter().copied()).collect();
        if triangles.is_empty() {
            return (**self).clone();
        }
        let first = |part: &[[DVec3; 3]]| part.first().map(|t| t[0]);
        let pieces = [first(&triangles), first(walls)].into_iter().flatten().collect();
        Self::of(&triangles, pieces, Some((Arc::clone(self), Arc::clone(away))))
    }

    fn of(triangles: &[[DVec3; 3]], pieces: Vec<DVec3>, cut: Option<(Arc<Self>, Arc<Cells>)>) -> Self {
        let boxes: Vec<Bounds> = triangles.iter().map(bounds).collect();
        let (nodes, order) = tree(&boxes);
        let triangles: Vec<_> = order.iter().map(|&i| triangles[i as usize]).collect();
        let centre = nodes[0].bounds.centre();
        let reach = triangles.iter().flatten().map(|p| p.distance_squared(centre)).fold(0.0, f64::max).sqrt();
        Self { triangles, nodes, pieces, centre, reach, cut }
    }

    /// The corners of all triangles.
    pub fn triangles(&self) -> &[[DVec3; 3]] {
        &self.triangles
    }

    /// Corners of the box around it: lowest and highest coordinates.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        (self.nodes[0].bounds.low, self.nodes[0].bounds.high)
    }

    pub(crate) fn sphere(&self) -> (DVec3, f64) {
        (self.centre, self.reach)
    }

    pub(crate) fn pieces(&self) -> &[DVec3] {
        &self.pieces
    }

    /// True if the surface winds around the point.
    ///
    /// Counts crossings of the ray along +z. The point counts as moved by an infinitesimal step in x and a smaller one
    /// in y. So rays never meet an edge or a corner, and exactly one of two neighbours is crossed.
    pub fn contains(&self, p: DVec3) -> bool {
        if let Some((whole, away)) = &self.cut {
            return whole.contains(p) && !away.contains(p);
        }
        let mut winding = 0;
        let mut open = vec![0];
        while let Some(i) = open.pop() {
            let node = &self.nodes[i];
            let b = &node.bounds;
            if p.x < b.low.x || p.x > b.high.x || p.y < b.low.y || p.y > b.high.y || p.z > b.high.z {
                continue;
            }
            winding += self.leaf(node).iter().map(|t| crossing(t, p)).sum::<i32>();
            self.children(node, &mut open, |_| 0.0);
        }
        winding != 0
    }

    pub(crate) fn extreme(&self, direction: DVec3) -> DVec3 {
        self.greatest(|b| b.reach(direction), |p| p.dot(direction))
    }

    /// The corner with the maximum `value`; `most` is an upper bound of the value in a box.
    pub(crate) fn greatest(&self, most: impl Fn(&Bounds) -> f64, value: impl Fn(DVec3) -> f64) -> DVec3 {
        let mut best = (f64::NEG_INFINITY, self.triangles[0][0]);
        let mut open = vec![0];
        while let Some(i) = open.pop() {
            let node = &self.nodes[i];
            if most(&node.bounds) < best.0 {
                continue;
            }
            for &p in self.leaf(node).iter().flatten() {
                let v = value(p);
                if v > best.0 {
                    best = (v, p);
                }
            }
            self.children(node, &mut open, |b| -most(b));
        }
        best.1
    }

    /// The triangles of a leaf; empty for a fork.
    fn leaf(&self, node: &Node) -> &[[DVec3; 3]] {
        let first = if node.count == 0 { 0 } else { node.first as usize };
        &self.triangles[first..first + node.count as usize]
    }

    /// Puts a fork's two nodes on the stack, the one with the smaller key on top.
    fn children(&self, node: &Node, open: &mut Vec<usize>, key: impl Fn(&Bounds) -> f64) {
        if node.count == 0 {
            let first = node.first as usize;
            let swap = key(&self.nodes[first].bounds) < key(&self.nodes[first + 1].bounds);
            open.extend(if swap { [first + 1, first] } else { [first, first + 1] });
        }
    }

    /// Distance of a convex body (in the mesh's frame, within `around`) to the surface, or none if it is `limit` or
    /// more; `a` is the body. It does not check if the body is inside.
    pub(crate) fn nearest_to(&self, body: &impl Convex, around: &Bounds, limit: f64, last: &mut Last) -> Option<Gap> {
        let mut search = Search { body, limit, best: None, towards: DVec3::ZERO, body_reach: f64::INFINITY };
        if let Some(triangle) = self.triangles.get(*last) {
            search.look_at(triangle);
        }
        let mut open = vec![0];
        while let Some(i) = open.pop() {
            let node = &self.nodes[i];
            if search.is_beyond(around, &node.bounds) {
                continue;
            }
            let first = node.first as usize;
            for (k, triangle) in self.leaf(node).iter().enumerate() {
                if first + k != *last && !search.is_triangle_beyond(triangle) && search.look_at(triangle) {
                    *last = first + k;
                }
            }
            if search.limit <= 0.0 {
                break;
            }
            self.children(node, &mut open, |b| around.distance_squared(b));
        }
        search.best
    }

    /// Distance of two surfaces, `pose` mapping the other's frame to this one's, or none if it is `limit` or more;
    /// `a` is this mesh.
    pub(crate) fn nearest_surface(&self, other: &Self, pose: &DAffine3, limit: f64) -> Option<Gap> {
        let turned = |b: &Bounds| {
            let (centre, half) = (pose.transform_point3(b.centre()), b.half());
            let m = pose.matrix3;
            let half = m.x_axis.abs() * half.x + m.y_axis.abs() * half.y + m.z_axis.abs() * half.z;
            Bounds { low: centre - half, high: centre + half }
        };
        let (mut limit, mut best) = (limit, None);
        let mut open = vec![(0, 0)];
        while let Some((i, j)) = open.pop() {
            let (a, b) = (&self.nodes[i], &other.nodes[j]);
            let (around_a, around_b) = (a.bounds, turned(&b.bounds));
            if limit <= 0.0 || around_a.distance_squared(&around_b) >= limit * limit {
                continue;
            }
            for t in other.leaf(b).iter().filter(|_| a.count > 0) {
                let t = t.map(|p| pose.transform_point3(p));
                for u in self.leaf(a) {
                    let towards = t[0] - u[0];
                    if let Some(gap) = nearest(u, &t, towards, limit) {
                        (limit, best) = (gap.distance, Some(gap));
                    }
                }
            }
            // Descend into the larger node unless it is a leaf.
            let open_a = b.count > 0 || (a.count == 0 && a.bounds.half().length() > b.bounds.half().length());
            let mut pairs = Vec::with_capacity(2);
            match (open_a, a.count, b.count) {
                (true, 0, _) => pairs.extend([(a.first as usize, j), (a.first as usize + 1, j)]),
                (false, _, 0) => pairs.extend([(i, b.first as usize), (i, b.first as usize + 1)]),
                _ => {}
            }
            let key = |&(i, j): &(usize, usize)| self.nodes[i].bounds.distance_squared(&turned(&other.nodes[j].bounds));
            pairs.sort_by(|x, y| key(y).total_cmp(&key(x)));
            open.extend(pairs);
        }
        best
    }
}

struct Search<'a, C> {
    body: &'a C,
    limit: f64,
    best: Option<Gap>,
    /// Unit direction from the body to the nearest triangle so far, and the body's extent along it, mm.
    towards: DVec3,
    body_reach: f64,
}

impl<C: Convex> Search<'_, C> {
    /// True if the whole box is at least as far as the best distance so far.
    fn is_beyond(&self, around: &Bounds, part: &Bounds) -> bool {
        around.distance_squared(part) >= self.limit * self.limit
            || -part.reach(-self.towards) - self.body_reach >= self.limit
            || self.body.at_least(part.centre()) - self.body.radius() - part.half().length() >= self.limit
    }

    /// True if a triangle is at least as far as the best distance so far.
    fn is_triangle_beyond(&self, triangle: &[DVec3; 3]) -> bool {
        let nearest = triangle.iter().map(|p| p.dot(self.towards)).fold(f64::INFINITY, f64::min);
        if nearest - self.body_reach >= self.limit {
            return true;
        }
        let middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
        let reach = triangle.iter().map(|p| p.distance_squared(middle)).fold(0.0, f64::max).sqrt();
        self.body.at_least(middle) - self.body.radius() - reach >= self.limit
    }

    /// Checks one triangle; true if it is nearer than all before.
    fn look_at(&mut self, triangle: &[DVec3; 3]) -> bool {
        let middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
        let towards = if self.towards == DVec3::ZERO { middle - self.body.support(DVec3::X) } else { self.towards };
        let Some(gap) = nearest(self.body, triangle, towards, self.limit) else { return false };
        self.limit = gap.distance;
        self.best = Some(gap);
        if let Some(n) = (gap.on_b - gap.on_a).try_normalize() {
            self.towards = n;
            self.body_reach = self.body.support(n).dot(n) + self.body.radius();
        }
        true
    }
}

fn bounds(triangle: &[DVec3; 3]) -> Bounds {
    triangle.iter().fold(Bounds::EMPTY, |b, &p| b.with(p))
}

/// +1 or -1 if the ray from `p` along +z crosses the triangle upwards or downwards, else 0.
fn crossing(triangle: &[DVec3; 3], p: DVec3) -> i32 {
    let [a, b, c] = triangle.map(|v| v - p);
    // Twice the areas of the point with each edge, seen along z; equal for both triangles of an edge.
    let area = |u: DVec3, v: DVec3| u.x * v.y - u.y * v.x;
    let areas = [area(b, c), area(c, a), area(a, b)];
    // On an edge, the sign after the infinitesimal step.
    let sign = |area: f64, u: DVec3, v: DVec3| {
        let steps = [area, u.y - v.y, v.x - u.x];
        steps.into_iter().find(|s| *s != 0.0).map_or(0, |s| if s > 0.0 { 1 } else { -1 })
    };
    let signs = [sign(areas[0], b, c), sign(areas[1], c, a), sign(areas[2], a, b)];
    if signs[0] != signs[1] || signs[1] != signs[2] || signs[0] == 0 {
        return 0;
    }
    let total: f64 = areas.iter().sum();
    let above = if total == 0.0 { a.z.max(b.z).max(c.z) } else { areas[0] * a.z + areas[1] * b.z + areas[2] * c.z };
    if (above > 0.0) == (total >= 0.0) { signs[0] } else { 0 }
}
