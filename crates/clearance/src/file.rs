//! Solids in TOML files.

use crate::error::{ClearanceError, FARTHEST_MM};
use crate::mesh::Mesh;
use crate::shape::{Shape, Solid};
use crate::stl::read_stl;
use glam::{DAffine3, DQuat, DVec3};
use schemars::JsonSchema;
use seamwright_document::{Direction, Document, DocumentError, NonNegative, Positive, Transform};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A solid: `shape.box = { size_mm = [10, 10, 5] }`, and where it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolidFile {
    /// Name for reports; the kind of shape if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Exactly one shape.
    pub shape: ShapeFile,
    /// Pose of the shape's own frame; not displaced if missing.
    #[serde(default, skip_serializing_if = "Transform::is_identity")]
    pub at: Transform,
}

/// A shape in its own frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum ShapeFile {
    /// A box, centred on the origin.
    Box {
        /// Full size along x, y and z, mm.
        size_mm: [Positive; 3],
    },
    /// A sphere about the origin.
    Sphere {
        /// Radius, mm.
        radius_mm: Positive,
    },
    /// A cylinder about z that stands on the origin.
    Cylinder {
        /// Radius, mm.
        radius_mm: Positive,
        /// Length, from z = 0 upwards, mm.
        length_mm: Positive,
    },
    /// A cone about z that stands on the origin, pointed or truncated.
    Cone {
        /// Radius at z = 0, mm.
        radius_mm: NonNegative,
        /// Radius at the other end, mm; 0, a point, if missing.
        #[serde(default)]
        top_radius_mm: NonNegative,
        /// Length, from z = 0 upwards, mm.
        length_mm: Positive,
    },
    /// A cylinder about z with round ends that stands on the origin.
    Capsule {
        /// Radius, mm.
        radius_mm: Positive,
        /// Length over all, from z = 0 upwards, mm; at least twice the radius.
        length_mm: Positive,
    },
    /// An ellipsoid about the origin.
    Ellipsoid {
        /// Semi-axes along x, y and z, mm.
        semi_axes_mm: [Positive; 3],
    },
    /// Everything behind a plane through the origin, like a floor.
    HalfSpace {
        /// Outward normal of the plane, into the empty side; z if missing.
        #[serde(default = "Direction::z")]
        normal: Direction,
    },
    /// The body in an STL file.
    Stl {
        /// The file, ASCII or binary; its surface must be closed.
        file: String,
        /// Factor from the file's coordinates to mm; 1 if missing.
        #[serde(default = "one", skip_serializing_if = "is_one")]
        scale: Positive,
    },
}

fn one() -> Positive {
    // `Positive` has no constant for 1; the fallback is never used.
    Positive::new(1.0).unwrap_or(Positive::HALF)
}

fn is_one(v: &Positive) -> bool {
    *v == one()
}

impl SolidFile {
    /// The solid. `path` is this value's key in `document` (like `tool[2].solid[0]`), `load` reads the bytes of an STL
    /// file by its name.
    ///
    /// # Errors
    /// With the key's address: inconsistent sizes or sizes above 1e7 mm, and all errors of an STL file.
    pub fn build<T>(
        &self,
        document: &Document<T>,
        path: &str,
        load: &dyn Fn(&str) -> std::io::Result<Vec<u8>>,
    ) -> Result<Solid, DocumentError> {
        let mut pose = self.at.affine();
        let vector = |v: &[Positive; 3]| DVec3::from_array(v.map(Positive::get));
        let (kind, shape) = match &self.shape {
            ShapeFile::Box { size_mm } => ("box", Shape::Box { size: vector(size_mm) }),
            ShapeFile::Sphere { radius_mm } => ("sphere", Shape::Sphere { radius: radius_mm.get() }),
            ShapeFile::Cylinder { radius_mm: r, length_mm: l } => {
                ("cylinder", Shape::Cylinder { radius: r.get(), length: l.get() })
            }
            ShapeFile::Cone { radius_mm: r, top_radius_mm: t, length_mm: l } => {
                ("cone", Shape::Cone { radius: r.get(), top_radius: t.get(), length: l.get() })
            }
            ShapeFile::Capsule { radius_mm: r, length_mm: l } => {
                ("capsule", Shape::Capsule { radius: r.get(), length: l.get() })
            }
            ShapeFile::Ellipsoid { semi_axes_mm } => {
                ("ellipsoid", Shape::Ellipsoid { semi_axes: vector(semi_axes_mm) })
            }
            ShapeFile::HalfSpace { normal } => {
                pose *= DAffine3::from_quat(DQuat::from_rotation_arc(DVec3::Z, normal.unit()));
                ("half_space", Shape::HalfSpace)
            }
            ShapeFile::Stl { file, scale } => {
                let mesh = mesh(file, scale.get(), load);
                let at = format!("{path}.shape.stl.file");
                let mesh = mesh.map_err(|(message, allowed)| document.error_at(&at, message, allowed))?;
                ("stl", Shape::Mesh(Arc::new(mesh)))
            }
        };
        let name = self.name.clone().unwrap_or_else(|| match &self.shape {
            ShapeFile::Stl { file, .. } => file.clone(),
            _ => kind.replace('_', "-"),
        });
        Solid::new(name, shape, pose).map_err(|e| {
            let (key, allowed) = match (&e, kind) {
                (ClearanceError::ShortCapsule { .. }, _) => (".length_mm", "clearance-capsule-allowed"),
                (_, "cone") => ("", "clearance-cone-allowed"),
                _ => ("", "clearance-sizes-allowed"),
            };
            let allowed = Message::new(allowed).value("max", FARTHEST_MM, Unit::Mm);
            document.error_at(&format!("{path}.shape.{kind}{key}"), &e, allowed)
        })
    }
}

/// The mesh of an STL file, or the error and the allowed values.
fn mesh(file: &str, scale: f64, load: &dyn Fn(&str) -> std::io::Result<Vec<u8>>) -> Result<Mesh, (Message, Message)> {
    let bytes = load(file).map_err(|e| {
        let message = Message::new("clearance-file-unreadable").text("why", e.to_string());
        (message, Message::new("clearance-file-allowed"))
    })?;
    let mesh = read_stl(&bytes, scale).and_then(|triangles| Mesh::new(&triangles));
    mesh.map_err(|e| {
        let allowed = match e {
            ClearanceError::CutShort(_) => Message::new("clearance-stl-whole-allowed"),
            ClearanceError::Open { .. } => Message::new("clearance-stl-closed-allowed"),
            ClearanceError::TooLarge { .. } => {
                Message::new("clearance-stl-corners-allowed").value("max", FARTHEST_MM, Unit::Mm)
            }
            ClearanceError::NotFinite { .. } => Message::new("clearance-stl-finite-allowed"),
            ClearanceError::NoTriangles => Message::new("clearance-stl-triangles-allowed"),
            _ => Message::new("clearance-stl-allowed"),
        };
        (e.message(), allowed)
    })
}
