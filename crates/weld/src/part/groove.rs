//! The groove as a region in space: it is cut out of the solids of both parts.
//!
//! **Region.** Cross-sections at stations along the seam are outlines with the same number of corners. Between two
//! stations the outline is divided into triangles, and each triangle's prism into three tetrahedra. Above the toes the
//! outline goes on outwards, so that it cuts surfaces that curve.
//!
//! **Accuracy.** Stations are so close, and corners of arcs so many, that the region is within [`WITHIN_MM`] of the swept
//! cross-section, unless that changes so fast that [`HALVINGS`] of the distance of stations do not suffice. If an outline cannot be divided alike at both stations, less is cut away, never more.

use super::vessel_heads::turned;
use crate::joint::{SeamJoint, Section};
use crate::seam::{SeamCurve, SeamPoint};
use glam::{DAffine3, DVec2, DVec3};
use seamwright_clearance::{Cells, ClearanceError, Mesh, Shape, Solid};
use seamwright_program::{PathRange, Preparation};
use std::f64::consts::PI;
use std::sync::Arc;

/// Maximum distance of the region from the swept cross-section, mm.
pub(crate) const WITHIN_MM: f64 = 0.02;
/// Minimum number of stations along a seam.
pub(super) const STATIONS: u32 = 72;
/// Stations are halved so often at most.
const HALVINGS: u32 = 6;
/// Height of the region over the toes: a length, mm, and a part of the distance of the toes.
const OVER: (f64, f64) = (1.0, 0.1);
/// An open seam's region goes on beyond its ends by this many times the distance of the toes.
const BEYOND: f64 = 2.0;
/// A flat triangle has less area, mm^2.
const FLAT_MM2: f64 = 1e-9;

/// The groove at one position of the seam.
pub(crate) struct Station {
    pub(crate) p: SeamPoint,
    pub(crate) section: Section,
}

impl Station {
    fn at(seam: &SeamCurve, joint: &SeamJoint, s: f64) -> Option<Self> {
        let p = seam.at(s);
        joint.section(&p).map(|section| Self { p, section })
    }

    /// A point of the cross-section in the seam's frame.
    pub(crate) fn point(&self, at: DVec2) -> DVec3 {
        self.p.point + at.x * self.p.towards_first + at.y * self.p.bisector
    }

    /// The farthest distance of this station's edges from the middle of two others.
    fn off(&self, a: &Self, b: &Self) -> f64 {
        let edges = |s: &Self| [s.section.first.clone(), s.section.second.clone()];
        let (own, first, last) = (edges(self), edges(a), edges(b));
        let side = |i: usize| {
            // Edges are alike from the toe on.
            let from_toe = |station: &Self, edge: &[DVec2], k: usize| station.point(edge[edge.len() - 1 - k]);
            let count = own[i].len().min(first[i].len()).min(last[i].len());
            (0..count)
                .map(|k| {
                    let middle = from_toe(a, &first[i], k).midpoint(from_toe(b, &last[i], k));
                    from_toe(self, &own[i], k).distance(middle)
                })
                .fold(0.0, f64::max)
        };
        side(0).max(side(1))
    }
}

/// Stations along the weld, close enough for [`WITHIN_MM`]. On a seam welded all round the first one follows the last.
/// Empty if a station has no groove.
pub(crate) fn stations(seam: &SeamCurve, joint: &SeamJoint) -> Vec<Station> {
    let length = if seam.all_round() { seam.length() } else { seam.weld_length() };
    let mut places: Vec<f64> = (0..=STATIONS).map(|i| length * f64::from(i) / f64::from(STATIONS)).collect();
    places.extend(seam.knots_within(PathRange::up_to(length)));
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| *a - *b < 1e-6 * length);
    let found: Option<Vec<Station>> = places.iter().map(|s| Station::at(seam, joint, *s)).collect();
    let Some(found) = found else { return Vec::new() };
    let mut all = Vec::new();
    let mut ends = found.into_iter().peekable();
    while let Some(station) = ends.next() {
        let between = ends.peek().map_or(Vec::new(), |next| refined(seam, joint, [&station, next], HALVINGS));
        all.push(station);
        all.extend(between);
    }
    if seam.all_round() {
        all.pop();
    }
    all
}

/// Stations between two, none if these are close enough.
fn refined(seam: &SeamCurve, joint: &SeamJoint, [a, b]: [&Station; 2], halvings: u32) -> Vec<Station> {
    let Some(middle) = Station::at(seam, joint, 0.5 * (a.p.s + b.p.s)) else { return Vec::new() };
    if halvings == 0 || middle.off(a, b) <= WITHIN_MM {
        return Vec::new();
    }
    let mut all = refined(seam, joint, [a, &middle], halvings - 1);
    let after = refined(seam, joint, [&middle, b], halvings - 1);
    all.push(middle);
    all.extend(after);
    all
}

/// The region of a groove, and the parts' surfaces in it.
pub(super) struct Groove {
    cells: Arc<Cells>,
    /// Surface of the first and of the second part. The bottom of the groove belongs to both.
    walls: [Vec<[DVec3; 3]>; 2],
}

/// A cross-section as a closed outline, in its plane and in space: the first part's edge from its root to its toe, over
/// both toes, and the second part's edge back to its root.
struct Ring {
    flat: Vec<DVec2>,
    points: Vec<DVec3>,
}

impl Groove {
    /// The groove of `joint` along `seam`; `None` for fillets and laps, which have nothing cut away, or without
    /// cross-sections.
    pub(super) fn new(seam: &SeamCurve, joint: &SeamJoint) -> Option<Self> {
        if matches!(joint.joint().preparation, Preparation::Fillet(_) | Preparation::Lap(_)) {
            return None;
        }
        let stations = stations(seam, joint);
        let kept = [0, 1].map(|i| kept_corners(&stations, i));
        let mut rings: Vec<Ring> = stations.iter().map(|station| Ring::new(station, &kept)).collect();
        if seam.all_round() {
            rings.push(Ring::new(stations.first()?, &kept));
        } else {
            let (first, last) = (stations.first()?, stations.last()?);
            let beyond = |station: &Station, sense: f64| {
                let by = sense * BEYOND * (OVER.0 + station.section.chord()) * station.p.tangent;
                let mut ring = Ring::new(station, &kept);
                ring.points.iter_mut().for_each(|p| *p += by);
                ring
            };
            rings.insert(0, beyond(first, -1.0));
            rings.push(beyond(last, 1.0));
        }
        let first = kept[0].len();
        let last = rings.first()?.points.len() - 1;
        let (mut tetrahedra, mut walls) = (Vec::new(), [Vec::new(), Vec::new()]);
        let mut triangles = Vec::new();
        for pair in rings.windows(2) {
            let both = [&pair[0].flat, &pair[1].flat];
            if !both.iter().all(|flat| is_division(&triangles, flat)) {
                let candidates = both.map(|flat| divided(flat));
                let good = candidates.iter().find(|all| both.iter().all(|flat| is_division(all, flat)));
                // Without a division of both outlines, triangles that are turned over in one of them are left out.
                triangles = good.unwrap_or(&candidates[0]).clone();
                triangles.retain(|t| both.iter().all(|flat| area(*t, flat) > -FLAT_MM2));
            }
            let [a, b] = [&pair[0].points, &pair[1].points];
            for [i, j, k] in &triangles {
                tetrahedra.extend([
                    [a[*i], a[*j], a[*k], b[*k]],
                    [a[*i], a[*j], b[*j], b[*k]],
                    [a[*i], b[*i], b[*j], b[*k]],
                ]);
            }
            // The same diagonals as those of the tetrahedra.
            let strip = |u: usize, v: usize| [[a[u], a[v], b[v]], [a[u], b[v], b[u]]];
            let bottom = strip(0, last);
            walls[0].extend((1..first).flat_map(|v| strip(v - 1, v)).chain(bottom));
            walls[1].extend((first + 3..=last).flat_map(|v| strip(v - 1, v)).chain(bottom));
        }
        Some(Self { cells: Arc::new(Cells::new(&tetrahedra)?), walls })
    }

    /// `solids` without the groove. `parts` are the indices of the first and the second part, equal if one solid is both.
    pub(super) fn cut(&self, solids: Vec<Solid>, parts: [usize; 2]) -> Result<Vec<Solid>, ClearanceError> {
        let one = |(i, solid): (usize, Solid)| {
            let walls: Vec<[DVec3; 3]> =
                (0..2).filter(|k| parts[*k] == i).flat_map(|k| self.walls[k].iter().copied()).collect();
            let Some(mesh) = mesh(&solid)? else { return Ok(solid) };
            let cut = Arc::new(mesh).without(&self.cells, &walls);
            Solid::new(solid.name(), Shape::Mesh(Arc::new(cut)), DAffine3::IDENTITY)
        };
        solids.into_iter().enumerate().map(one).collect()
    }
}

impl Ring {
    fn new(station: &Station, kept: &[Vec<usize>; 2]) -> Self {
        let section = &station.section;
        let over = (OVER.0 + OVER.1 * section.chord()) * section.up;
        let [first, second] = section.toes();
        let edge = |i: usize| {
            let corners = if i == 0 { &section.first } else { &section.second };
            kept[i].iter().map(|k| corners[corners.len() - 1 - *k.min(&(corners.len() - 1))]).collect::<Vec<_>>()
        };
        let mut flat = edge(0);
        flat.reverse();
        flat.extend([first + over, second + over]);
        flat.extend(edge(1));
        let points = flat.iter().map(|p| station.point(*p)).collect();
        Self { flat, points }
    }
}

/// Corners of one part's edge that are needed for [`WITHIN_MM`] at all stations, counted from the toe.
fn kept_corners(stations: &[Station], part: usize) -> Vec<usize> {
    let edges: Vec<Vec<DVec2>> = stations
        .iter()
        .map(|s| (if part == 0 { &s.section.first } else { &s.section.second }).iter().rev().copied().collect())
        .collect();
    let count = edges.iter().map(Vec::len).max().unwrap_or(0);
    let is_straight = |from: usize, to: usize| {
        edges.iter().all(|edge| {
            let at = |k: usize| edge[k.min(edge.len() - 1)];
            (from + 1..to).all(|k| from_segment(at(k), at(from), at(to)) <= 0.5 * WITHIN_MM)
        })
    };
    let mut kept = vec![0];
    while let Some(&from) = kept.last().filter(|from| **from + 1 < count) {
        let mut to = from + 1;
        while to + 1 < count && is_straight(from, to + 1) {
            to += 1;
        }
        kept.push(to);
    }
    kept
}

fn from_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let part = if along.length_squared() > 0.0 { (p - a).dot(along) / along.length_squared() } else { 0.0 };
    p.distance(a + part.clamp(0.0, 1.0) * along)
}

fn area([i, j, k]: [usize; 3], ring: &[DVec2]) -> f64 {
    0.5 * (ring[j] - ring[i]).perp_dot(ring[k] - ring[i])
}

/// True if these triangles divide all of the outline: none is turned over.
fn is_division(triangles: &[[usize; 3]], ring: &[DVec2]) -> bool {
    triangles.len() + 2 == ring.len() && triangles.iter().all(|t| area(*t, ring) > -FLAT_MM2)
}

/// Triangles that divide an outline (counter-clockwise), each with its corners in increasing order: ears are cut off
/// one after the other.
fn divided(ring: &[DVec2]) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..ring.len()).collect();
    let mut triangles = Vec::new();
    while left.len() > 2 {
        let n = left.len();
        let ear = |i: usize| [left[(i + n - 1) % n], left[i], left[(i + 1) % n]];
        let is_ear = |i: &usize| {
            let t = ear(*i);
            let inside = |k: &usize| {
                let [a, b, c] = t.map(|j| ring[j]);
                let p = ring[*k];
                [(a, b), (b, c), (c, a)].iter().all(|(u, v)| (*v - *u).perp_dot(p - *u) > FLAT_MM2)
            };
            area(t, ring) > 0.0 && !left.iter().filter(|k| !t.contains(k)).any(inside)
        };
        // The roundest ear first; a corner on a line between its neighbours is left out.
        let best = (0..n).filter(is_ear).max_by(|a, b| roundness(ear(*a), ring).total_cmp(&roundness(ear(*b), ring)));
        let i = match best {
            Some(i) => i,
            None => match (0..n).find(|i| area(ear(*i), ring).abs() <= FLAT_MM2) {
                Some(flat) => flat,
                None => break,
            },
        };
        let mut corners = ear(i);
        corners.sort_unstable();
        triangles.push(corners);
        left.remove(i);
    }
    triangles
}

/// Area of a triangle as a part of the square of its longest side.
fn roundness(t: [usize; 3], ring: &[DVec2]) -> f64 {
    let [a, b, c] = t.map(|i| ring[i]);
    let longest = a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a));
    area(t, ring) / longest.max(f64::MIN_POSITIVE)
}

/// The closed surface of a solid in the frame that it is given in, nowhere inside of it and up to [`WITHIN_MM`] outside;
/// `None` for ellipsoids, which stay whole.
fn mesh(solid: &Solid) -> Result<Option<Mesh>, ClearanceError> {
    let shape = match *solid.shape() {
        Shape::Mesh(ref mesh) => Shape::Mesh(Arc::clone(mesh)),
        Shape::Cylinder { radius, length } => cone(radius, radius, length)?,
        Shape::Cone { radius, top_radius, length } => cone(radius, top_radius, length)?,
        Shape::Sphere { radius } => sphere(radius)?,
        Shape::Box { size } => boxed(size)?,
        Shape::Capsule { .. } | Shape::Ellipsoid { .. } | Shape::HalfSpace => return Ok(None),
    };
    let Shape::Mesh(mesh) = shape else { return Ok(None) };
    let placed: Vec<_> = mesh.triangles().iter().map(|t| t.map(|p| solid.pose().transform_point3(p))).collect();
    Mesh::new(&placed).map(Some)
}

fn cone(radius: f64, top_radius: f64, length: f64) -> Result<Shape, ClearanceError> {
    turned(&[(radius, 0.0), (top_radius, length)], &[(0.0, length), (0.0, 0.0)], WITHIN_MM)
}

fn sphere(radius: f64) -> Result<Shape, ClearanceError> {
    // Half of the error along the meridian, half around.
    let within = 0.5 * WITHIN_MM.max(2e-5 * radius);
    let count = (0.5 * PI * (radius / (2.0 * within)).sqrt()).ceil().max(12.0);
    let outside = radius / (0.5 * PI / count).cos();
    let point = |i: usize| {
        let (sin, cos) = (PI * (i as f64 / count - 0.5)).sin_cos();
        (if i == 0 || i as f64 >= count { 0.0 } else { outside * cos }, outside * sin)
    };
    turned(&(0..=count as usize).map(point).collect::<Vec<_>>(), &[], within)
}

fn boxed(size: DVec3) -> Result<Shape, ClearanceError> {
    const FACES: [[usize; 4]; 6] = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let at = |i: usize| {
        let side = |bit: usize| if i >> bit & 1 == 1 { 0.5 } else { -0.5 };
        size * DVec3::new(side(0), side(1), side(2))
    };
    let halves = |f: [usize; 4]| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]].map(|t| t.map(at));
    Mesh::new(&FACES.into_iter().flat_map(halves).collect::<Vec<_>>()).map(|mesh| Shape::Mesh(Arc::new(mesh)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::Place;
    use seamwright_document::{NonNegative, Positive};
    use seamwright_program::{Joint, Member, TBevel, TJ, WeldedSide};
    use seamwright_testkit::{Random, cases};

    /// The triangles of random outlines cover the polygon's area.
    #[test]
    fn outlines_are_divided_whole() {
        let mut random = Random::new(3);
        let mut made = 0;
        for _ in 0..cases(3000) {
            let positive = |v: f64| Positive::new(v).unwrap();
            let some = |v: f64| NonNegative::new(v).unwrap();
            let prepared = if random.yes() { Member::First } else { Member::Second };
            let (thickness_mm, leg_mm) = (positive(random.within(6.0, 60.0)), some(random.within(0.0, 8.0)));
            let (root_gap_mm, root_face_mm) = (some(random.within(0.0, 3.0)), some(random.within(0.5, 2.0)));
            let angle = random.within(3.0, 50.0);
            let preparation = if random.yes() {
                let (angle_deg, radius_mm) = (some(0.4 * angle), positive(random.within(3.0, 5.0)));
                let land_mm = some(0.0);
                Preparation::TJ(TJ {
                    prepared,
                    thickness_mm,
                    angle_deg,
                    radius_mm,
                    land_mm,
                    root_gap_mm,
                    root_face_mm,
                    leg_mm,
                })
            } else {
                let (angle_deg, cut_deg) = (Some(positive(angle)), None);
                Preparation::TBevel(TBevel {
                    prepared,
                    thickness_mm,
                    angle_deg,
                    cut_deg,
                    root_gap_mm,
                    root_face_mm,
                    leg_mm,
                })
            };
            let dihedral = random.within(40.0, 150.0f64).to_radians();
            let place = Place { dihedral, gap: root_gap_mm.get(), mismatch: 0.0 };
            let joint = Joint {
                preparation,
                side: WeldedSide::Face,
                gouge: None,
                backing: None,
                insert: None,
                at_dihedral: Vec::new(),
                standard: None,
                cap_mm: some(1.0),
                fit_up: Vec::new(),
            };
            let Ok(section) = Section::new(&joint, place) else { continue };
            made += 1;
            let ring: Vec<DVec2> = section.first.iter().chain(section.second.iter().rev()).copied().collect();
            let found: f64 = divided(&ring).iter().map(|t| area(*t, &ring)).sum();
            assert!((found - section.area()).abs() < 1e-6 * section.area(), "{found} of {}: {ring:?}", section.area());
        }
        assert!(made > 1000, "{made}");
    }
}
