//! The part as solids, made from its own seam: obstacles of the torch.

mod flat;
mod groove;
mod hollow;
mod metal;
mod plates;
mod swept;
mod tubes;
mod vessel_heads;

pub use metal::Metal;

use crate::joint::SeamJoint;
use crate::plane_seam;
use crate::seam::SeamCurve;
use crate::t_joint::Middle;
use crate::welding::Welding;
use glam::{DAffine3, DMat3, DVec3};
use groove::Groove;
use seamwright_clearance::{Clamped, ClearanceError, Shape, Solid, SolidFile};
use seamwright_document::{Document, DocumentError, Positive};
use seamwright_message::{Message, Unit};
use seamwright_program::{Part, Seam};

/// Default length of nozzle, tube or web, mm.
const NOZZLE_MM: f64 = 100.0;
/// Minimum thickness of plates, mm: their other side is never approached.
const PLATE_MM: f64 = 10.0;

/// Number of points along the seam that give its extent.
const PLACES: i32 = 360;

/// Reason why no part can be made.
#[allow(clippy::large_enum_variant, reason = "made once, when a job is refused")]
#[derive(Debug)]
enum Impossible {
    /// A solid has invalid sizes.
    Solid(ClearanceError),
    /// The body of the job's length ends within the seam; with the minimum length, mm.
    Short(f64),
    /// The body cannot be read.
    Document(DocumentError),
}

impl From<ClearanceError> for Impossible {
    fn from(error: ClearanceError) -> Self {
        Self::Solid(error)
    }
}

impl From<DocumentError> for Impossible {
    fn from(error: DocumentError) -> Self {
        Self::Document(error)
    }
}

/// Loads the bytes of an STL file.
type Load<'a> = &'a dyn Fn(&str) -> std::io::Result<Vec<u8>>;

/// Range of coordinates along a direction, mm.
#[derive(Debug, Clone, Copy)]
struct Extent {
    low: f64,
    high: f64,
}

/// Inputs of the solids.
struct Making<'a> {
    seam: &'a SeamCurve,
    nozzle_mm: f64,
    /// Length of the body, if the job gives one.
    body_mm: Option<f64>,
    joint: Option<&'a SeamJoint>,
}

impl Welding {
    /// Part and fixtures in the machine's work frame; `load` gets the bytes of the STL files that are named.
    ///
    /// The part, once at every copy of the seam, is made from the seam, together with the given solids. The job may
    /// declare that these replace it. It is made of exact cylinders, spheres, cones and boxes. Elliptic tubes and
    /// curved T-joints are meshes up to 0.02 mm outside the true surface, heads up to 0.1 mm. It is nowhere smaller
    /// than the true one, nor larger near the seam. The end of a slanting nozzle may stand out of the far side of its
    /// body. The groove of a joint is cut out of both parts, within 0.02 mm; ellipsoids stay whole. Tubes are solid,
    /// because the torch stays outside; only the surroundings of a root that is welded from inside are hollow.
    ///
    /// # Errors
    /// With the key's address: all faults of a solid or an STL file, a body that ends within the seam, a part that is
    /// replaced by no solid. For a part that is not watched no solid is made and no file read.
    pub fn clamped(&self, load: Load) -> Result<Clamped, DocumentError> {
        let program = &self.program.value;
        let fixtures = given(&self.program, "fixtures", &program.fixtures, load)?;
        let Part { solids, replace, watched, .. } = &program.part;
        if *replace && solids.is_empty() {
            let message = Message::new("weld-part-replaced-by-nothing");
            return Err(self.program.error_at("part.replace", message, Message::new("weld-allowed-part-solids")));
        }
        // The files of a part that is left out need not be there.
        let mut part = if *watched { given(&self.program, "part.solids", solids, load)? } else { Vec::new() };
        if *watched && !replace {
            part.extend(self.made()?);
        }
        self.clamped_as(&part, fixtures)
    }

    /// Weld metal of the passes, an obstacle of those after them; `None` without a joint, or if the part is not watched
    /// or not made from the seam.
    pub fn metal(&self) -> Option<Metal<'_>> {
        let program = &self.program.value;
        let is_made = program.part.watched && !program.part.replace;
        let (Some(seam), Some(joint)) = (&self.seam, self.joint.as_ref().filter(|_| is_made)) else { return None };
        Some(Metal::new(program, seam, joint, self.stretches()))
    }

    /// The solids that are made from the seam; empty in a program without one.
    fn made(&self) -> Result<Vec<Solid>, DocumentError> {
        let program = &self.program.value;
        let (Some(curve), Some(seam)) = (&self.seam, &program.seam) else { return Ok(Vec::new()) };
        let making = Making {
            seam: curve,
            nozzle_mm: program.part.nozzle_length_mm.map_or(NOZZLE_MM, Positive::get),
            body_mm: program.part.body_length_mm.map(Positive::get),
            joint: self.joint.as_ref(),
        };
        making.solids(&self.program, seam)
    }

    /// The `part` at every copy, and the fixtures.
    fn clamped_as(&self, part: &[Solid], fixtures: Vec<Solid>) -> Result<Clamped, DocumentError> {
        let program = &self.program.value;
        let mut parts = Vec::new();
        for copy in 0..program.copy_count() {
            let placement = program.copy_in_work(copy);
            for solid in part {
                let of = program.copy_name(copy).map_or(String::new(), |name| format!(" of {name}"));
                let name = format!("{}{of}", solid.name());
                let placed = Solid::new(&name, solid.shape().clone(), placement * *solid.pose());
                let allowed = || Message::new("weld-allowed-rigid-placement");
                parts.push(placed.map_err(|e| self.program.error_at("placement", e.message(), allowed()))?);
            }
        }
        Ok(Clamped { part: parts, fixtures, least_mm: program.clearance.least_mm.get() })
    }
}

fn given<T>(file: &Document<T>, path: &str, solids: &[SolidFile], load: Load) -> Result<Vec<Solid>, DocumentError> {
    solids.iter().enumerate().map(|(i, s)| s.build(file, &format!("{path}[{i}]"), load)).collect()
}

impl Making<'_> {
    fn solids<T>(&self, file: &Document<T>, seam: &Seam) -> Result<Vec<Solid>, DocumentError> {
        let made = match seam {
            Seam::Nozzle(nozzle) => self.nozzle(file, nozzle),
            Seam::Branch(branch) => self.branch(file, branch),
            Seam::Girth(girth) => self.girth(girth),
            Seam::Ellipse(ellipse) => self.ellipse(ellipse),
            Seam::Circle(circle) => self.circle(circle),
            Seam::Arc(arc) => self.arc(arc, &plane_seam::arc(file, arc)?.curve),
            Seam::RoundedRectangle(r) => self.rectangle(r),
            Seam::Polyline(p) => self.plate_below(p.points_mm[0].get(), p.normal.unit()).map(|plate| vec![plate]),
            Seam::Helix(helix) => self.helix(helix),
            Seam::Spline(s) => self.spline(s),
            Seam::Line(line) => self.line(line),
            Seam::TJoint(joint) => self.t_joint(joint, &Middle::new(file, joint)?),
        };
        let made = made.and_then(|parts| {
            let mut solids = self.grooved(seam, parts)?;
            if let Seam::Branch(branch) = seam
                && let Some(other) = self.other_branch(file, branch)?
            {
                solids.insert(1, other);
            }
            Ok(solids)
        });
        made.map_err(|e| match e {
            Impossible::Short(least) => {
                let allowed = Message::new("document-more-than").quantity("min", least, Unit::Mm, 3);
                file.error_at("part.body_length_mm", Message::new("weld-body-too-short"), allowed)
            }
            Impossible::Document(e) => e,
            Impossible::Solid(e) => {
                let message = Message::new("weld-part-from-seam").message("why", e.message());
                file.error_at("seam", message, Message::new("weld-allowed-part-sizes").value("max", 1e7, Unit::Mm))
            }
        })
    }

    /// The parts without the groove of the joint, if there is one.
    fn grooved(&self, seam: &Seam, solids: Vec<Solid>) -> Result<Vec<Solid>, Impossible> {
        let Some(groove) = self.joint.and_then(|joint| Groove::new(self.seam, joint)) else { return Ok(solids) };
        let last = solids.len().saturating_sub(1);
        // A part that stands on a plate or skin is made after it.
        let parts = match seam {
            Seam::Nozzle(_) | Seam::Branch(_) | Seam::Line(_) => [0, last],
            _ => [last, 0],
        };
        Ok(groove.cut(solids, parts)?)
    }

    /// Thickness of plates, mm: at least that of the joint.
    fn plate_mm(&self) -> f64 {
        self.joint.and_then(|joint| joint.joint().preparation.thickness_mm()).unwrap_or(0.0).max(PLATE_MM)
    }

    /// Minimum of `f` over the seam: the minimum at many stations, then at ever nearer ones around it.
    fn least(&self, f: impl Fn(DVec3) -> f64) -> f64 {
        let length = self.seam.length();
        let (mut step, mut best) = (length / f64::from(PLACES), (f64::INFINITY, 0.5 * length));
        for half in [PLACES / 2, 10, 10, 10, 10] {
            let places = (-half..=half).map(|i| (best.1 + f64::from(i) * step).clamp(0.0, length));
            best = places.map(|s| (f(self.seam.at(s).point), s)).fold(best, |b, v| if v.0 < b.0 { v } else { b });
            step *= 0.1;
        }
        best.0
    }

    /// Minimum and maximum height of the seam along a direction.
    fn heights(&self, from: DVec3, along: DVec3) -> Extent {
        let low = self.least(|p| (p - from).dot(along));
        Extent { low, high: -self.least(|p| -(p - from).dot(along)) }
    }

    /// The middle of the seam's extent.
    fn middle(&self) -> DVec3 {
        let middle = |extent: Extent| 0.5 * (extent.low + extent.high);
        DVec3::from_array(DVec3::AXES.map(|n| middle(self.heights(DVec3::ZERO, n))))
    }

    /// The body's length: as given by the job, or the usual one, but at least a nozzle's length beyond the seam
    /// (`least`).
    fn body(&self, usual: f64, least: f64) -> Result<f64, Impossible> {
        match self.body_mm {
            Some(length) if length <= least => Err(Impossible::Short(least)),
            Some(length) => Ok(length),
            None => Ok(usual.max(least + 2.0 * self.nozzle_mm)),
        }
    }

    /// A plate whose outer face, with outward `normal`, is a square about `centre`.
    fn plate(&self, name: &str, centre: DVec3, normal: DVec3, side: f64) -> Result<Solid, ClearanceError> {
        let x = normal.any_orthonormal_vector();
        let axes = DMat3::from_cols(x, normal.cross(x), normal);
        let thick = self.plate_mm();
        let shape = Shape::Box { size: DVec3::new(side, side, thick) };
        Solid::new(name, shape, DAffine3::from_mat3_translation(axes, centre - 0.5 * thick * normal))
    }
}

/// The frame at `origin` with its z along a unit vector.
fn standing(origin: DVec3, along: DVec3) -> DAffine3 {
    let x = along.any_orthonormal_vector();
    DAffine3::from_mat3_translation(DMat3::from_cols(x, along.cross(x), along), origin)
}
