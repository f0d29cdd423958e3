//! Tubes that branch off a chord along x, from the keys of a job or program.

use crate::allowed::{between, by_key};
use crate::body::tube;
use glam::DVec3;
use seamwright_document::{Direction, Document, DocumentError, Finite, Positive};
use seamwright_geometry::{Edge, Error, Quadric, TrimmedIntersection, Tube, TubeIntersection};
use seamwright_message::{Message, Unit};
use seamwright_program::{Branch, OtherBranch};

/// The tubes of a T-, Y- or K-joint, in the seam's frame.
pub(crate) struct Joint {
    /// The branch's outside, and its inside if its wall is known.
    pub(crate) tube: Tube,
    pub(crate) bore: Option<Tube>,
    /// Radius of the chord, mm.
    pub(crate) chord: f64,
    pub(crate) other: Option<Leg>,
}

/// One branch: where its axis meets the plane z = 0, the axis' direction, the radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Leg {
    pub(crate) origin: DVec3,
    pub(crate) direction: DVec3,
    pub(crate) radius: f64,
}

/// Minimum and maximum angle between the axes, degrees.
const ANGLES_DEG: (f64, f64) = (10.0, 170.0);

impl Joint {
    /// The tubes of `branch`. Fails with the key's address: branches that are not within the chord, angles out of
    /// range, a wall without a bore, axes of two branches that do not part.
    pub(crate) fn new<T>(file: &Document<T>, branch: &Branch) -> Result<Self, DocumentError> {
        let chord = branch.chord_radius_mm.get();
        let keys = Keys { file, path: "seam.branch", chord };
        let angle = keys.angle(branch.angle_deg)?;
        let radius = keys.radius(branch.radius_mm)?;
        let sideways = keys.sideways(radius, branch.eccentricity_mm)?;
        let leg = Leg { origin: sideways * DVec3::Y, direction: DVec3::new(angle.cos(), 0.0, angle.sin()), radius };
        let outside = leg.tube(radius);
        let outside =
            outside.map_err(|e| file.error_at("seam.branch", e.message(), Message::new("weld-allowed-tube")))?;
        let bore = branch.wall_mm.map(Positive::get).map(|wall| {
            leg.tube(radius - wall).map_err(|_| {
                let allowed = by_key("weld-allowed-positive-less-than-key", "radius_mm", radius);
                file.error_at("seam.branch.wall_mm", Message::new("weld-wall-leaves-no-bore"), allowed)
            })
        });
        let other = branch.other.as_ref().map(|other| second(file, other, &leg, branch.angle_deg, chord));
        Ok(Self { tube: outside, bore: bore.transpose()?, chord, other: other.transpose()? })
    }

    /// The seam: where the branch's outside leaves the chord, or the other branch where that trims it. Fails with the
    /// key's address: tubes that do not meet in a closed curve.
    pub(crate) fn edge<T>(&self, file: &Document<T>) -> Result<Box<dyn Edge + Send + Sync>, DocumentError> {
        self.end(file, &self.tube)
    }

    /// The end of one of the branch's walls, outside or inside, as it is cut.
    pub(crate) fn end<T>(&self, file: &Document<T>, wall: &Tube) -> Result<Box<dyn Edge + Send + Sync>, DocumentError> {
        let unfit = |e: Error| {
            let at = match e {
                Error::Beside { .. } | Error::NeverLeaves => "seam.branch.other",
                _ => "seam.branch.radius_mm",
            };
            file.error_at(at, e.message(), Message::new("weld-allowed-tubes-meet"))
        };
        let cylinder = |origin, direction, radius| Quadric::cylinder(origin, direction, radius).map_err(unfit);
        let chord = cylinder(DVec3::ZERO, DVec3::X, self.chord)?;
        Ok(match self.other {
            Some(Leg { origin, direction, radius }) => {
                let other = cylinder(origin, direction, radius)?;
                Box::new(TrimmedIntersection::new(wall.clone(), chord, other).map_err(unfit)?)
            }
            None => Box::new(TubeIntersection::new(wall.clone(), chord).map_err(unfit)?),
        })
    }
}

impl Leg {
    /// A wall of this leg, its angle from the side of +x.
    fn tube(&self, radius: f64) -> Result<Tube, Error> {
        tube(self.origin, self.direction, Direction::new(DVec3::X), radius)
    }
}

/// The other branch of a K-joint, placed beside the first, whose angle in the file is `first_angle`.
fn second<T>(
    file: &Document<T>,
    b: &OtherBranch,
    first: &Leg,
    first_angle: Option<Positive>,
    chord: f64,
) -> Result<Leg, DocumentError> {
    let keys = Keys { file, path: "seam.branch.other", chord };
    let angle = keys.angle(b.angle_deg)?;
    let radius = keys.radius(b.radius_mm)?;
    let sideways = keys.sideways(radius, b.eccentricity_mm)?;
    let direction = DVec3::new(-angle.cos(), 0.0, angle.sin());
    if first.direction.cross(direction).y >= -1e-9 {
        let message = Message::new("weld-branches-do-not-part");
        let first = first_angle.map_or(90.0, Positive::get);
        let allowed = Message::new("weld-allowed-other-branch-angle").value("max", 180.0 - first, Unit::Deg);
        return Err(file.error_at("seam.branch.other.angle_deg", message, allowed.value("first", first, Unit::Deg)));
    }
    let one = || Message::new("weld-allowed-gap-or-offset");
    let x = match (b.gap_mm, b.offset_mm) {
        (None, Some(offset)) => -offset.get(),
        // A toe is where the branch's outside meets the chord in the plane of both its axis and the chord's direction.
        (Some(gap), None) => {
            let toe = |direction: DVec3, sideways: f64, radius: f64, sense: f64| {
                let up = ((chord - sideways) * (chord + sideways)).sqrt();
                (up * direction.x + sense * radius) / direction.z
            };
            let first_toe = toe(first.direction, first.origin.y, first.radius, -1.0);
            first_toe - gap.get() - toe(direction, sideways, radius, 1.0)
        }
        (None, None) => {
            return Err(file.error_at("seam.branch.other", Message::new("weld-branch-position-missing"), one()));
        }
        (Some(_), Some(_)) => {
            let message = Message::new("weld-branch-position-twice");
            return Err(file.error_at("seam.branch.other.offset_mm", message, one()));
        }
    };
    let leg = Leg { origin: DVec3::new(x, sideways, 0.0), direction, radius };
    let on_chord =
        Quadric::cylinder(DVec3::ZERO, DVec3::X, chord).and_then(|c| TubeIntersection::new(leg.tube(radius)?, c));
    let allowed = || Message::new("weld-allowed-branch-within-chord");
    on_chord.map(|_| leg).map_err(|e| file.error_at("seam.branch.other", e.message(), allowed()))
}

/// A table of one branch.
struct Keys<'a, T> {
    file: &'a Document<T>,
    path: &'static str,
    chord: f64,
}

impl<T> Keys<'_, T> {
    fn error(&self, key: &str, code: &'static str, allowed: Message) -> DocumentError {
        self.file.error_at(&format!("{}.{key}", self.path), Message::new(code), allowed)
    }

    /// Between the axes, rad.
    fn angle(&self, degrees: Option<Positive>) -> Result<f64, DocumentError> {
        let degrees = degrees.map_or(90.0, Positive::get);
        if (ANGLES_DEG.0..=ANGLES_DEG.1).contains(&degrees) {
            return Ok(degrees.to_radians());
        }
        Err(self.error("angle_deg", "weld-branch-along-chord", between(ANGLES_DEG.0, ANGLES_DEG.1, Unit::Deg)))
    }

    fn radius(&self, radius: Positive) -> Result<f64, DocumentError> {
        if radius.get() < self.chord {
            return Ok(radius.get());
        }
        let allowed = by_key("weld-allowed-positive-less-than-key", "chord_radius_mm", self.chord);
        Err(self.error("radius_mm", "weld-branch-wider-than-chord", allowed))
    }

    fn sideways(&self, radius: f64, eccentricity: Finite) -> Result<f64, DocumentError> {
        let (room, sideways) = (self.chord - radius, eccentricity.get());
        if sideways.abs() < room {
            return Ok(sideways);
        }
        let allowed = Message::new("weld-allowed-eccentricity").value("min", -room, Unit::Mm);
        Err(self.error("eccentricity_mm", "weld-branch-past-chord", allowed.value("max", room, Unit::Mm)))
    }
}
