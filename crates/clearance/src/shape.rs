use crate::error::{ClearanceError, FARTHEST_MM};
use crate::mesh::Mesh;
use glam::{DAffine3, DMat3, DVec3};
use std::sync::Arc;

/// A body in its own frame, mm. Everything inside its surface is solid.
#[derive(Debug, Clone)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum Shape {
    /// A box of this full size, centred on the origin, edges along the axes.
    Box { size: DVec3 },
    /// A sphere about the origin.
    Sphere { radius: f64 },
    /// A cylinder about z that stands on the origin: from z = 0 to z = `length`.
    Cylinder { radius: f64, length: f64 },
    /// A truncated cone about z that stands on the origin: from z = 0 to z = `length`, where its radius is `top_radius`
    /// (0 for a pointed cone).
    Cone { radius: f64, top_radius: f64, length: f64 },
    /// A cylinder about z with half spheres as its ends; with them it goes from z = 0 to z = `length`, at least twice
    /// the radius.
    Capsule { radius: f64, length: f64 },
    /// An ellipsoid about the origin, its axes along x, y and z.
    Ellipsoid { semi_axes: DVec3 },
    /// Everything with z <= 0.
    HalfSpace,
    /// The inside of a closed surface of triangles.
    Mesh(Arc<Mesh>),
}

impl Shape {
    /// Checks the sizes: finite, positive (a cone's smaller end may be a point), not over 1e7 mm.
    pub(crate) fn check(&self) -> Result<(), ClearanceError> {
        let size = |what, value: f64| {
            let max = FARTHEST_MM;
            if value > 0.0 && value <= max { Ok(()) } else { Err(ClearanceError::Size { what, value, max }) }
        };
        match *self {
            Self::Box { size: v } => v.to_array().into_iter().try_for_each(|v| size("clearance-box-side", v)),
            Self::Sphere { radius } => size("clearance-radius", radius),
            Self::Cylinder { radius, length } => size("clearance-radius", radius).and(size("clearance-length", length)),
            Self::Cone { radius, top_radius, length } => {
                if let Some(value) = [radius, top_radius].into_iter().find(|r| r.is_nan() || *r < 0.0) {
                    return Err(ClearanceError::Size { what: "clearance-radius", value, max: FARTHEST_MM });
                }
                size("clearance-radius", radius.max(top_radius)).and(size("clearance-length", length))
            }
            Self::Capsule { radius, length } => {
                size("clearance-radius", radius).and(size("clearance-length", length))?;
                if length < 2.0 * radius {
                    return Err(ClearanceError::ShortCapsule { length, radius });
                }
                Ok(())
            }
            Self::Ellipsoid { semi_axes: v } => {
                v.to_array().into_iter().try_for_each(|v| size("clearance-semi-axis", v))
            }
            Self::HalfSpace | Self::Mesh(_) => Ok(()),
        }
    }

    /// Centre and radius of a sphere around the shape; the radius of a half-space is infinite.
    pub(crate) fn sphere(&self) -> (DVec3, f64) {
        match *self {
            Self::Box { size } => (DVec3::ZERO, size.length() / 2.0),
            Self::Sphere { radius } => (DVec3::ZERO, radius),
            Self::Cylinder { radius, length } => (DVec3::Z * (length / 2.0), radius.hypot(length / 2.0)),
            Self::Cone { radius, top_radius, length } => {
                (DVec3::Z * (length / 2.0), radius.max(top_radius).hypot(length / 2.0))
            }
            Self::Capsule { length, .. } => (DVec3::Z * (length / 2.0), length / 2.0),
            Self::Ellipsoid { semi_axes } => (DVec3::ZERO, semi_axes.max_element()),
            Self::HalfSpace => (DVec3::ZERO, f64::INFINITY),
            Self::Mesh(ref mesh) => mesh.sphere(),
        }
    }
}

/// A shape in a pose, with a name for reports.
#[derive(Debug, Clone)]
pub struct Solid {
    name: String,
    shape: Shape,
    pose: DAffine3,
    /// Sphere around it, in the frame that `pose` maps to.
    pub(crate) centre: DVec3,
    pub(crate) reach: f64,
}

impl Solid {
    /// A solid; `pose` maps the shape's frame to the solid's frame (its group's).
    ///
    /// # Errors
    /// Sizes that are not finite or not positive, a capsule shorter than its ends, a pose that is not rigid or
    /// displaces by more than 1e7 mm.
    pub fn new(name: impl Into<String>, shape: Shape, pose: DAffine3) -> Result<Self, ClearanceError> {
        shape.check()?;
        check_rigid(&pose)?;
        let (centre, reach) = shape.sphere();
        // The sphere is slightly enlarged, so that rounding never culls touching solids.
        let (centre, reach) = (pose.transform_point3(centre), reach * (1.0 + 1e-12) + 1e-9);
        Ok(Self { name: name.into(), shape, pose, centre, reach })
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Centre and radius (mm) of a sphere around it, in the frame it is given in; infinite for a half-space.
    pub fn sphere(&self) -> (DVec3, f64) {
        (self.centre, self.reach)
    }

    /// True if its shape may be a permitted zone: box, sphere, cylinder, half-space.
    pub fn is_zone(&self) -> bool {
        matches!(self.shape, Shape::Box { .. } | Shape::Sphere { .. } | Shape::Cylinder { .. } | Shape::HalfSpace)
    }

    /// Its shape.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Maps the shape's frame to the group's.
    pub fn pose(&self) -> &DAffine3 {
        &self.pose
    }

    /// True unless it is a half-space.
    pub(crate) fn ends(&self) -> bool {
        !matches!(self.shape, Shape::HalfSpace)
    }
}

/// Refuses poses that are not a rotation and a translation, to 1e-9.
fn check_rigid(pose: &DAffine3) -> Result<(), ClearanceError> {
    let m: DMat3 = pose.matrix3;
    let skew = m.transpose() * m - DMat3::IDENTITY;
    let off = skew.to_cols_array().into_iter().fold(0.0, |worst: f64, v| worst.max(v.abs()));
    if !pose.is_finite() || off > 1e-9 || m.determinant() <= 0.0 {
        return Err(ClearanceError::NotRigid);
    }
    let far = pose.translation.abs().max_element();
    if far > FARTHEST_MM { Err(ClearanceError::TooFar { value: far, max: FARTHEST_MM }) } else { Ok(()) }
}
