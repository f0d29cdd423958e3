use crate::body::tube;
use crate::branch::Joint;
use crate::nozzle::OnBody;
use crate::t_joint;
use glam::DVec3;
use seamwright_document::{Direction, Document, DocumentError};
use seamwright_geometry::{Error, Quadric, QuadricDistance, SignedDistance, Tube};
use seamwright_message::Message;
use seamwright_program::Seam;

/// The surfaces beside a seam that can be touched to find where the part stands, in the seam's frame.
pub struct SeamSurfaces {
    /// The first part: the nozzle's or branch's outside, the wall over an ellipse, the first face of a straight seam.
    pub first: Box<dyn SignedDistance>,
    /// The second part: the body's or chord's outside, the plate, the second face.
    pub second: Box<dyn SignedDistance>,
    /// The nozzle, if the seam is that of one.
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
        let wrong =
            |path: &'static str| move |e: Error| file.error_at(path, e.message(), Message::new("weld-allowed-schema"));
        let plane = |point: DVec3, normal: DVec3, path: &'static str| {
            Quadric::plane(point, normal).map_err(wrong(path)).map(|q| boxed(&q))
        };
        match seam {
            Seam::Nozzle(nozzle) => {
                let OnBody { tube, body, .. } = OnBody::new(file, nozzle)?;
                Ok(Self { first: Box::new(tube.clone()), second: body, nozzle: Some(tube) })
            }
            Seam::Branch(branch) => {
                let Joint { tube, chord, .. } = Joint::new(file, branch)?;
                let chord = Quadric::cylinder(DVec3::ZERO, DVec3::X, chord).map_err(wrong("seam.branch"))?;
                Ok(Self { first: Box::new(tube.clone()), second: boxed(&chord), nozzle: Some(tube) })
            }
            Seam::Ellipse(e) => {
                let (centre, normal) = (e.centre_mm.get(), e.normal.unit());
                let wall = Quadric::elliptic_cylinder(centre, normal, e.a_direction.unit(), e.a_mm.get(), e.b_mm.get());
                let wall = wall.map_err(wrong("seam.ellipse"))?;
                Ok(Self { first: boxed(&wall), second: plane(centre, normal, "seam.ellipse.normal")?, nozzle: None })
            }
            Seam::Circle(c) => {
                let (centre, normal) = (c.centre_mm.get(), c.normal.unit());
                let tube = tube(centre, normal, c.zero_direction, c.radius_mm.get())
                    .map_err(wrong("seam.circle.zero_direction"))?;
                let second = plane(centre, normal, "seam.circle.normal")?;
                Ok(Self { first: Box::new(tube.clone()), second, nozzle: Some(tube) })
            }
            Seam::Girth(g) if g.inside => Err(none(file, "seam.girth.inside", "weld-seam-inside-girth")),
            Seam::Girth(g) => {
                let (centre, direction) = (g.origin_mm.get(), g.direction.unit());
                let tube = tube(centre, direction, g.zero_direction, g.radius_mm.get())
                    .map_err(wrong("seam.girth.zero_direction"))?;
                let cut = g.cut_normal.map_or(direction, Direction::unit);
                let cut = plane(centre, if cut.dot(direction) < 0.0 { -cut } else { cut }, "seam.girth.cut_normal")?;
                Ok(Self { first: Box::new(tube.clone()), second: cut, nozzle: Some(tube) })
            }
            Seam::TJoint(joint) if joint.via_mm.is_none() => {
                let edge = t_joint::edge(file, joint)?.edge(0.0);
                Ok(Self {
                    first: plane(edge.point, edge.n1, "seam.t_joint.skin_normal")?,
                    second: plane(edge.point, edge.n2, "seam.t_joint.skin_normal")?,
                    nozzle: None,
                })
            }
            Seam::TJoint(_) => Err(none(file, "seam.t_joint.via_mm", "weld-seam-curved-t-joint")),
            Seam::Arc(_) => Err(none(file, "seam.arc", "weld-seam-arc")),
            Seam::RoundedRectangle(_) => Err(none(file, "seam.rounded_rectangle", "weld-seam-rectangle")),
            Seam::Helix(_) => Err(none(file, "seam.helix", "weld-seam-helix")),
            Seam::Spline(_) => Err(none(file, "seam.spline", "weld-seam-spline")),
            Seam::Polyline(_) => Err(none(file, "seam.polyline", "weld-seam-polyline")),
            Seam::Line(line) => {
                let face = |normal: Direction, path| plane(line.start_mm.get(), normal.unit(), path);
                Ok(Self {
                    first: face(line.first_normal, "seam.line.first_normal")?,
                    second: face(line.second_normal, "seam.line.second_normal")?,
                    nozzle: None,
                })
            }
        }
    }
}

/// Error of a seam without surfaces to be touched.
fn none<T>(file: &Document<T>, path: &str, seam: &'static str) -> DocumentError {
    let message = Message::new("weld-seam-without-surfaces").message("seam", Message::new(seam));
    file.error_at(path, message, Message::new("weld-allowed-fit-methods"))
}

fn boxed(body: &Quadric) -> Box<dyn SignedDistance> {
    Box::new(QuadricDistance::new(body))
}
