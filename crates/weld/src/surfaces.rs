use crate::seam::intersection;
use glam::DVec3;
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::{Error, Quadric, QuadricDistance, SignedDistance, Tube};
use seamwright_program::Seam;

/// The surfaces beside a seam that can be touched to find where the part stands, in the seam's frame.
pub struct SeamSurfaces {
    /// The first part: the nozzle's outside, the wall over an ellipse, the first face of a straight seam.
    pub first: Box<dyn SignedDistance>,
    /// The second part: the body's outside, the plate, the second face.
    pub second: Box<dyn SignedDistance>,
    /// The nozzle, if the seam is one.
    pub nozzle: Option<Tube>,
}

impl std::fmt::Debug for SeamSurfaces {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_struct("SeamSurfaces").field("nozzle", &self.nozzle).finish_non_exhaustive()
    }
}

impl SeamSurfaces {
    /// The surfaces of a job's or program's seam.
    ///
    /// # Errors
    /// As [`SeamCurve::new`](crate::SeamCurve::new): shapes that do not meet.
    pub fn new<T>(file: &Document<T>, seam: &Seam) -> Result<Self, DocumentError> {
        let wrong = |path: &'static str| move |e: Error| file.error_at(path, e.to_string(), "see the job's schema");
        let plane = |point: DVec3, normal: DVec3, path: &'static str| {
            Quadric::plane(point, normal).map_err(wrong(path)).map(|q| boxed(&q))
        };
        match seam {
            Seam::Nozzle(nozzle) => {
                let both = intersection(file, nozzle)?;
                let tube = both.tube().clone();
                Ok(Self { first: Box::new(tube.clone()), second: boxed(both.body()), nozzle: Some(tube) })
            }
            Seam::Ellipse(e) => {
                let (centre, normal) = (e.centre_mm.get(), e.normal.unit());
                let wall = Quadric::elliptic_cylinder(centre, normal, e.a_direction.unit(), e.a_mm.get(), e.b_mm.get());
                let wall = wall.map_err(wrong("seam.ellipse"))?;
                Ok(Self { first: boxed(&wall), second: plane(centre, normal, "seam.ellipse.normal")?, nozzle: None })
            }
            Seam::Line(line) => {
                let face =
                    |normal: seamwright_document::Direction, path| plane(line.start_mm.get(), normal.unit(), path);
                Ok(Self {
                    first: face(line.first_normal, "seam.line.first_normal")?,
                    second: face(line.second_normal, "seam.line.second_normal")?,
                    nozzle: None,
                })
            }
        }
    }
}

fn boxed(body: &Quadric) -> Box<dyn SignedDistance> {
    Box::new(QuadricDistance::new(body))
}
