//! Free seams: splines through or near points.

use glam::DVec3;
use seamwright_document::{Direction, Document, DocumentError};
use seamwright_geometry::{self as geometry, End, Ends, Error, Normals, SplineEdge, SplineFaces, fit_spline};
use seamwright_program::{FilletOrButt, Spline, WallFaces};

/// Points nearer to each other than this are one, mm.
const APART_MM: f64 = 1e-3;
/// Maximum number of points of a seam.
const MAX_POINTS: usize = 20_000;

/// The edge of a seam along a spline.
///
/// # Errors
/// With the key's address: too few points, coincident points, a curve that turns back, normals along it.
pub(crate) fn edge<T>(file: &Document<T>, s: &Spline) -> Result<SplineEdge, DocumentError> {
    let points: Vec<DVec3> = s.points_mm.iter().map(|p| p.get()).collect();
    let at = At { file, from_file: s.file.is_some() };
    at.check(s, &points)?;
    let end = |t: Option<Direction>| t.map_or(End::Natural, |t| End::Slope(t.unit()));
    let ends = if s.closed { Ends::Closed } else { Ends::Open(end(s.start_tangent), end(s.end_tangent)) };
    let whole = |e: Error| at.wrong("points_mm", e.to_string(), "points with less of a turn from one to the next");
    let curve: geometry::Spline = fit_spline(&points, ends, s.tolerance_mm.get()).map_err(whole)?;
    let units = |normals: &[Direction]| normals.iter().map(|n| n.unit()).collect::<Vec<_>>();
    let through = |key: &str, normals: &[Direction]| {
        let allowed = "normals that turn by less than 90 degrees from one point to the next";
        Normals::through(&points, &units(normals), s.closed).map_err(|e| at.wrong(key, e.to_string(), allowed))
    };
    let plate = || match s.first_normals.as_slice() {
        [] => Ok(Normals::Same(s.normal.unwrap_or_else(Direction::z).unit())),
        normals => through("first_normals", normals),
    };
    let faces = match (s.second_normals.as_slice(), s.joint) {
        ([], FilletOrButt::Fillet) => SplineFaces::Wall { plate: plate()?, left: s.wall_faces == WallFaces::Left },
        ([], FilletOrButt::Butt) => SplineFaces::Flat(plate()?),
        (second, _) => SplineFaces::Both(plate()?, through("second_normals", second)?),
    };
    SplineEdge::new(curve, faces).map_err(|e| match e {
        Error::Parallel { .. } => {
            let key = if s.first_normals.is_empty() { "normal" } else { "first_normals" };
            at.wrong(key, "a face's normal lies along the seam somewhere".to_owned(), "normals across the seam")
        }
        e => whole(e),
    })
}

struct At<'a, T> {
    file: &'a Document<T>,
    /// The points and normals are in a file of their own.
    from_file: bool,
}

impl<T> At<'_, T> {
    fn wrong(&self, key: &str, message: String, allowed: &str) -> DocumentError {
        let own = ["normal", "start_tangent", "end_tangent"].contains(&key);
        let key = if self.from_file && !own { "file" } else { key };
        self.file.error_at(&format!("seam.spline.{key}"), message, allowed)
    }

    /// At point `i`.
    fn at_point(&self, i: usize, message: &str, allowed: &str) -> DocumentError {
        self.wrong(&format!("points_mm[{i}]"), format!("point {}: {message}", i + 1), allowed)
    }

    fn check(&self, s: &Spline, points: &[DVec3]) -> Result<(), DocumentError> {
        let least = if s.closed { 3 } else { 2 };
        if !(least..=MAX_POINTS).contains(&points.len()) {
            let message = format!("a seam of {} points", points.len());
            return Err(self.wrong("points_mm", message, &format!("{least} to {MAX_POINTS}, here or in a `file`")));
        }
        if let Some(i) = (1..points.len()).find(|&i| points[i].distance(points[i - 1]) < APART_MM) {
            let allowed = format!("points at least {APART_MM} mm apart");
            return Err(self.at_point(i, "it is where the one before is", &allowed));
        }
        let last = points.len() - 1;
        if s.closed && points[last].distance(points[0]) < APART_MM {
            let message = "the last point is where the first is, and the seam is closed anyway";
            return Err(self.at_point(last, message, "leave this point out"));
        }
        let tangents = [("start_tangent", s.start_tangent), ("end_tangent", s.end_tangent)];
        if let Some((key, _)) = tangents.iter().find(|(_, t)| s.closed && t.is_some()) {
            return Err(self.wrong(key, "a closed seam has no ends".to_owned(), "no such key with `closed = true`"));
        }
        let chords = [(0, 1, "start_tangent", s.start_tangent), (last - 1, last, "end_tangent", s.end_tangent)];
        for (a, b, key, tangent) in chords {
            if tangent.is_some_and(|t| t.unit().dot(points[b] - points[a]) <= 0.0) {
                let message = "it points back from the next point of the seam".to_owned();
                return Err(self.wrong(key, message, "a direction in the sense of welding"));
            }
        }
        for (key, normals) in [("first_normals", &s.first_normals), ("second_normals", &s.second_normals)] {
            if !normals.is_empty() && normals.len() != points.len() {
                let message = format!("{} normals of {} points", normals.len(), points.len());
                return Err(self.wrong(key, message, "one for each point"));
            }
        }
        if s.first_normals.is_empty() && !s.second_normals.is_empty() {
            return Err(self.wrong("second_normals", "without `first_normals`".to_owned(), "`first_normals` too"));
        }
        if !s.first_normals.is_empty() && s.normal.is_some() {
            return Err(self.wrong("normal", "every point has its own normal".to_owned(), "either one or all"));
        }
        let opposite = |(a, b): (&Direction, &Direction)| (a.unit() + b.unit()).length() < 1e-6;
        if let Some(i) = s.first_normals.iter().zip(&s.second_normals).position(opposite) {
            return Err(self.at_point(i, "the faces look at each other: there is no joint to reach", "other normals"));
        }
        Ok(())
    }
}
