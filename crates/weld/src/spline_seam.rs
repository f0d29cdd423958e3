//! Free seams: splines through or near points.

use glam::DVec3;
use seamwright_document::{Direction, Document, DocumentError};
use seamwright_geometry::{self as geometry, End, Ends, Error, Normals, SplineEdge, SplineFaces, fit_spline};
use seamwright_message::{Message, Unit};
use seamwright_program::{FilletOrButt, Spline, WallFaces};

/// Points nearer to each other than this are one, mm.
const APART_MM: f64 = 1e-3;
/// Maximum number of points of a seam.
const MAX_POINTS: usize = 20_000;

/// The edge of a seam along a spline. Fails with the key's address: too few points, coincident points, a curve that
/// turns back, normals along it.
pub(crate) fn edge<T>(file: &Document<T>, s: &Spline) -> Result<SplineEdge, DocumentError> {
    let points: Vec<DVec3> = s.points_mm.iter().map(|p| p.get()).collect();
    let at = At { file, from_file: s.file.is_some() };
    at.check(s, &points)?;
    let end = |t: Option<Direction>| t.map_or(End::Natural, |t| End::Slope(t.unit()));
    let ends = if s.closed { Ends::Closed } else { Ends::Open(end(s.start_tangent), end(s.end_tangent)) };
    let whole = |e: Error| at.wrong("points_mm", e.message(), "weld-allowed-less-turn");
    let curve: geometry::Spline = fit_spline(&points, ends, s.tolerance_mm.get()).map_err(whole)?;
    let units = |normals: &[Direction]| normals.iter().map(|n| n.unit()).collect::<Vec<_>>();
    let through = |key: &str, normals: &[Direction]| {
        let allowed = "weld-allowed-normals-less-turn";
        Normals::through(&points, &units(normals), s.closed).map_err(|e| at.wrong(key, e.message(), allowed))
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
            at.wrong(key, Message::new("weld-normal-along-seam"), "weld-allowed-normals-across")
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
    fn wrong(&self, key: &str, message: Message, allowed: &'static str) -> DocumentError {
        self.fault(key, message, Message::new(allowed))
    }

    fn fault(&self, key: &str, message: Message, allowed: Message) -> DocumentError {
        let own = ["normal", "start_tangent", "end_tangent"].contains(&key);
        let key = if self.from_file && !own { "file" } else { key };
        self.file.error_at(&format!("seam.spline.{key}"), message, allowed)
    }

    fn at_point(&self, i: usize, code: &'static str, allowed: Message) -> DocumentError {
        self.fault(&format!("points_mm[{i}]"), Message::new(code).text("point", (i + 1).to_string()), allowed)
    }

    fn check(&self, s: &Spline, points: &[DVec3]) -> Result<(), DocumentError> {
        let least = if s.closed { 3 } else { 2 };
        if !(least..=MAX_POINTS).contains(&points.len()) {
            let message = Message::new("weld-point-count").count("count", points.len());
            let allowed = Message::new("weld-allowed-point-count").count("min", least).count("max", MAX_POINTS);
            return Err(self.fault("points_mm", message, allowed));
        }
        if let Some(i) = (1..points.len()).find(|&i| points[i].distance(points[i - 1]) < APART_MM) {
            let allowed = Message::new("weld-allowed-points-apart-by").value("min", APART_MM, Unit::Mm);
            return Err(self.at_point(i, "weld-spline-point-repeated", allowed));
        }
        let last = points.len() - 1;
        if s.closed && points[last].distance(points[0]) < APART_MM {
            let allowed = Message::new("weld-allowed-leave-point-out");
            return Err(self.at_point(last, "weld-spline-last-point-repeated", allowed));
        }
        let tangents = [("start_tangent", s.start_tangent), ("end_tangent", s.end_tangent)];
        if let Some((key, _)) = tangents.iter().find(|(_, t)| s.closed && t.is_some()) {
            return Err(self.wrong(key, Message::new("weld-closed-seam-has-no-ends"), "weld-allowed-no-key-closed"));
        }
        let chords = [(0, 1, "start_tangent", s.start_tangent), (last - 1, last, "end_tangent", s.end_tangent)];
        for (a, b, key, tangent) in chords {
            if tangent.is_some_and(|t| t.unit().dot(points[b] - points[a]) <= 0.0) {
                return Err(self.wrong(key, Message::new("weld-tangent-backwards"), "weld-allowed-welding-direction"));
            }
        }
        for (key, normals) in [("first_normals", &s.first_normals), ("second_normals", &s.second_normals)] {
            if !normals.is_empty() && normals.len() != points.len() {
                let message = Message::new("weld-normal-count").count("normals", normals.len());
                return Err(self.wrong(key, message.count("points", points.len()), "weld-allowed-one-per-point"));
            }
        }
        if s.first_normals.is_empty() && !s.second_normals.is_empty() {
            let message = Message::new("weld-second-normals-alone");
            return Err(self.wrong("second_normals", message, "weld-allowed-first-normals-too"));
        }
        if !s.first_normals.is_empty() && s.normal.is_some() {
            return Err(self.wrong("normal", Message::new("weld-normal-twice"), "weld-allowed-one-or-all-normals"));
        }
        let opposite = |(a, b): (&Direction, &Direction)| (a.unit() + b.unit()).length() < 1e-6;
        if let Some(i) = s.first_normals.iter().zip(&s.second_normals).position(opposite) {
            return Err(self.at_point(i, "weld-spline-faces-opposed", Message::new("weld-allowed-other-normals")));
        }
        Ok(())
    }
}
