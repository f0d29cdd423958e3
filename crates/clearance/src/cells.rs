//! A region of tetrahedra that is cut away from solids, such as the groove of a joint.

use crate::boxes::{Bounds, Node, tree};
use glam::DVec3;

/// Points nearer than this to a face of a cell are on it, mm: far above rounding, far below what can be machined.
const ON_FACE_MM: f64 = 1e-9;
/// Cells with less volume are left out, mm^3.
const EMPTY_MM3: f64 = 1e-12;
/// Parts of a triangle with less area are left out, mm^2.
const SLIVER_MM2: f64 = 1e-12;
/// A triangle that meets more cells than this is halved first: the parts of small triangles are few.
const MAX_CELLS: usize = 24;
/// Triangles are not halved below this length of their longest side, mm.
const SHORTEST_MM: f64 = 0.5;

/// A region made of tetrahedra, mm.
#[derive(Debug, Clone)]
pub struct Cells {
    cells: Vec<Cell>,
    nodes: Vec<Node>,
}

#[derive(Debug, Clone, Copy)]
struct Cell {
    bounds: Bounds,
    /// Outward unit normals and offsets of the faces.
    faces: [(DVec3, f64); 4],
    corners: [DVec3; 4],
}

type Polygon = Vec<DVec3>;

impl Cells {
    /// The region that these tetrahedra cover, given by their corners in any order. Tetrahedra without volume are left
    /// out. `None` if none has a volume.
    pub fn new(corners: &[[DVec3; 4]]) -> Option<Self> {
        let all: Vec<Cell> = corners.iter().filter_map(Cell::new).collect();
        let boxes: Vec<Bounds> = all.iter().map(|c| c.bounds).collect();
        if all.is_empty() {
            return None;
        }
        let (nodes, order) = tree(&boxes);
        let cells = order.iter().map(|&i| all[i as usize]).collect();
        Some(Self { cells, nodes })
    }

    /// True if the point is inside, or on the surface.
    pub fn contains(&self, p: DVec3) -> bool {
        let mut found = false;
        self.meeting(&Bounds::EMPTY.with(p), &mut |cell| found = found || cell.contains(p));
        found
    }

    /// The parts of a triangle outside of the region, as triangles.
    pub(crate) fn outside(&self, triangle: [DVec3; 3]) -> Vec<[DVec3; 3]> {
        let mut parts = Vec::new();
        if !self.cut(triangle, &mut parts) {
            return vec![triangle];
        }
        parts
    }

    /// Adds the parts outside; false, and nothing useful added, if all of the triangle is outside.
    fn cut(&self, triangle: [DVec3; 3], out: &mut Vec<[DVec3; 3]>) -> bool {
        let bounds = triangle.iter().fold(Bounds::EMPTY, |b, p| b.with(*p));
        let mut cells: Vec<&Cell> = Vec::new();
        let [a, b, c] = triangle;
        let n = (b - a).cross(c - a).normalize_or_zero();
        self.meeting(&bounds, &mut |cell| {
            if cell.meets(&triangle, n) {
                cells.push(cell);
            }
        });
        if cells.is_empty() {
            return false;
        }
        let side = |i: usize| triangle[i].distance_squared(triangle[(i + 1) % 3]);
        let longest = (0..3).max_by(|a, b| side(*a).total_cmp(&side(*b))).unwrap_or(0);
        if cells.len() > MAX_CELLS && side(longest) > SHORTEST_MM * SHORTEST_MM {
            let [a, b, c] = [0, 1, 2].map(|i| triangle[(longest + i) % 3]);
            let middle = 0.5 * (a + b);
            let mut any = false;
            let from = out.len();
            for half in [[a, middle, c], [middle, b, c]] {
                if self.cut(half, out) {
                    any = true;
                } else {
                    out.push(half);
                }
            }
            if !any {
                out.truncate(from);
            }
            return any;
        }
        let (mut polygons, mut any) = (vec![triangle.to_vec()], false);
        for cell in cells {
            let mut left = Vec::with_capacity(polygons.len());
            for polygon in polygons {
                match cell.outside(&polygon) {
                    None => left.push(polygon),
                    Some(parts) => {
                        any = true;
                        left.extend(parts);
                    }
                }
            }
            polygons = left;
        }
        if any {
            let fan = |p: &Polygon| (1..p.len() - 1).map(|i| [p[0], p[i], p[i + 1]]).collect::<Vec<_>>();
            out.extend(polygons.iter().flat_map(fan));
        }
        any
    }

    /// Calls `each` with every cell whose box meets `bounds`.
    fn meeting<'a>(&'a self, bounds: &Bounds, each: &mut impl FnMut(&'a Cell)) {
        let mut open = vec![0];
        while let Some(i) = open.pop() {
            let node = &self.nodes[i];
            if node.bounds.distance_squared(bounds) > 0.0 {
                continue;
            }
            let first = node.first as usize;
            if node.count == 0 {
                open.extend([first, first + 1]);
            } else {
                let leaf = &self.cells[first..first + node.count as usize];
                leaf.iter().filter(|c| c.bounds.distance_squared(bounds) <= 0.0).for_each(&mut *each);
            }
        }
    }
}

impl Cell {
    fn new(corners: &[DVec3; 4]) -> Option<Self> {
        let [a, b, c, d] = *corners;
        let volume = (b - a).dot((c - a).cross(d - a)) / 6.0;
        if volume.is_nan() || volume.abs() < EMPTY_MM3 {
            return None;
        }
        let face = |i: usize| {
            let [p, q, r] = [1, 2, 3].map(|k| corners[(i + k) % 4]);
            let n = (q - p).cross(r - p).try_normalize()?;
            let n = if n.dot(corners[i] - p) > 0.0 { -n } else { n };
            Some((n, n.dot(p)))
        };
        let faces = [face(0)?, face(1)?, face(2)?, face(3)?];
        Some(Self { bounds: corners.iter().fold(Bounds::EMPTY, |b, p| b.with(*p)), faces, corners: *corners })
    }

    /// False if a plane of the cell or the plane of a triangle, with the unit normal `n`, separates them.
    fn meets(&self, triangle: &[DVec3; 3], n: DVec3) -> bool {
        let heights = self.corners.map(|corner| n.dot(corner - triangle[0]));
        let is_beside = heights.iter().all(|h| *h > ON_FACE_MM) || heights.iter().all(|h| *h < -ON_FACE_MM);
        // A triangle in the plane of a face meets the cell.
        let is_beyond = |(n, offset): &(DVec3, f64)| {
            let heights = triangle.map(|p| n.dot(p) - offset);
            heights.iter().all(|h| *h >= -ON_FACE_MM) && heights.iter().any(|h| *h > ON_FACE_MM)
        };
        !is_beside && !self.faces.iter().any(is_beyond)
    }

    fn contains(&self, p: DVec3) -> bool {
        self.faces.iter().all(|(n, offset)| n.dot(p) - offset <= ON_FACE_MM)
    }

    /// Convex parts of a convex polygon outside of the cell; `None` if they do not overlap.
    fn outside(&self, polygon: &Polygon) -> Option<Vec<Polygon>> {
        let mut parts = Vec::new();
        let mut rest = polygon.clone();
        for (n, offset) in &self.faces {
            let (beyond, within) = split(&rest, *n, *offset);
            if area(&within) < SLIVER_MM2 {
                return None;
            }
            if area(&beyond) >= SLIVER_MM2 {
                parts.push(beyond);
            }
            rest = within;
        }
        Some(parts)
    }
}

/// The parts of a convex polygon beyond a plane and on its other side.
fn split(polygon: &Polygon, n: DVec3, offset: f64) -> (Polygon, Polygon) {
    let height = |p: DVec3| {
        let h = n.dot(p) - offset;
        if h.abs() <= ON_FACE_MM { 0.0 } else { h }
    };
    let (mut beyond, mut within) = (Vec::new(), Vec::new());
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (h, k) = (height(p), height(q));
        if h >= 0.0 {
            beyond.push(p);
        }
        if h <= 0.0 {
            within.push(p);
        }
        if (h > 0.0 && k < 0.0) || (h < 0.0 && k > 0.0) {
            let at = p + (q - p) * (h / (h - k));
            beyond.push(at);
            within.push(at);
        }
    }
    // A polygon in the plane is within.
    if polygon.iter().all(|p| height(*p) <= 0.0) {
        beyond.clear();
    }
    (beyond, within)
}

fn area(polygon: &Polygon) -> f64 {
    let Some(&p) = polygon.first() else { return 0.0 };
    let twice: DVec3 = polygon.windows(2).skip(1).map(|w| (w[0] - p).cross(w[1] - p)).sum();
    0.5 * twice.length()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use seamwright_testkit::{Random, cases};
    use std::sync::Arc;

    fn area_of(triangles: &[[DVec3; 3]]) -> f64 {
        triangles.iter().map(|t| area(&t.to_vec())).sum()
    }

    /// A random convex cell, as barycentric coordinates are easy to compute for.
    fn tetrahedron(random: &mut Random) -> [DVec3; 4] {
        [0; 4].map(|_| random.direction() * random.within(0.0, 3.0))
    }

    /// True if a point is inside, by volumes: independent of planes.
    fn inside(t: &[DVec3; 4], p: DVec3) -> bool {
        let volume = |t: [DVec3; 4]| (t[1] - t[0]).dot((t[2] - t[0]).cross(t[3] - t[0]));
        let whole = volume(*t);
        (0..4).all(|i| {
            let mut other = *t;
            other[i] = p;
            volume(other) / whole >= 0.0
        })
    }

    /// The parts of a triangle outside of the region have the area that its random points give.
    #[test]
    fn parts_outside_have_the_area_that_random_points_find() {
        let mut random = Random::new(5);
        for _ in 0..cases(300) {
            let corners: Vec<[DVec3; 4]> = (0..6).map(|_| tetrahedron(&mut random)).collect();
            let Some(cells) = Cells::new(&corners) else { continue };
            let triangle = [0; 3].map(|_| random.direction() * random.within(0.0, 4.0));
            let [a, b, c] = triangle;
            let parts = cells.outside(triangle);
            let points = 4000;
            let mut out = 0;
            for _ in 0..points {
                let (mut u, mut v) = (random.within(0.0, 1.0), random.within(0.0, 1.0));
                if u + v > 1.0 {
                    (u, v) = (1.0 - u, 1.0 - v);
                }
                let p = a + u * (b - a) + v * (c - a);
                let is_out = !corners.iter().any(|t| inside(t, p));
                assert!(is_out != cells.contains(p) || corners.iter().any(|t| inside(t, p)));
                out += i32::from(is_out);
            }
            let (whole, found) = (area_of(&[triangle]), area_of(&parts));
            let expected = whole * f64::from(out) / f64::from(points);
            assert!((found - expected).abs() < 0.05 * whole, "{found} for {expected} of {whole}");
        }
    }

    /// A slot cut into a cube: the floor and walls of the slot are its surface there, and its inside is air.
    #[test]
    fn a_slot_in_a_cube_is_air() {
        let corner = |i: usize| DVec3::new((i & 1) as f64, ((i >> 1) & 1) as f64, ((i >> 2) & 1) as f64);
        let faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
        let quads = |low: DVec3, size: DVec3| {
            let at = move |i: usize| low + size * corner(i);
            faces.into_iter().flat_map(move |f| [[at(f[0]), at(f[1]), at(f[2])], [at(f[0]), at(f[2]), at(f[3])]])
        };
        let cube: Vec<_> = quads(DVec3::splat(-10.0), DVec3::splat(20.0)).collect();
        let (low, size) = (DVec3::new(-2.0, -11.0, 4.0), DVec3::new(4.0, 22.0, 8.0));
        let c = |i: usize| low + size * corner(i);
        let tets = [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]];
        let cells = Arc::new(Cells::new(&tets.map(|t| t.map(c))).unwrap());
        let walls: Vec<_> = quads(low, size).collect();
        let cut = Mesh::new(&cube).map(Arc::new).unwrap().without(&cells, &walls);
        for (at, solid) in [
            (DVec3::new(0.0, 0.0, 6.0), false),
            (DVec3::new(0.0, 0.0, 3.9), true),
            (DVec3::new(2.1, 5.0, 9.0), true),
            (DVec3::new(-1.9, -9.0, 9.0), false),
            (DVec3::new(0.0, 0.0, 10.1), false),
        ] {
            assert_eq!(cut.contains(at), solid, "{at}");
        }
        // Of the cube's surface the slot's mouth is gone: on top 4 x 20, on two sides 4 x 6.
        let top = |t: &&[DVec3; 3]| t.iter().all(|p| (p.z - 10.0).abs() < 1e-9);
        let left: Vec<_> = cut.triangles().iter().filter(top).copied().collect();
        assert!((area_of(&left) - 320.0).abs() < 1e-9, "{}", area_of(&left));
    }
}
