use crate::error::{Error, positive, unit};
use glam::{DAffine3, DVec3};

/// A circular cylinder with a direction and a zero for its angle: the wall point at angle `phi` and height `h` is
/// `origin + r cos(phi) e1 + r sin(phi) e2 + h e3` (INTERSECT-2006).
#[derive(Debug, Clone, PartialEq)]
pub struct Tube {
    pub(crate) origin: DVec3,
    pub(crate) e1: DVec3,
    pub(crate) e2: DVec3,
    pub(crate) e3: DVec3,
    pub(crate) radius: f64,
}

impl Tube {
    /// A tube of `radius` about the axis through `origin` along `direction`; `zero_direction`, made perpendicular
    /// to the axis, is where `phi = 0`. Angles count counter-clockwise seen from the tip of `direction`.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`] or [`Error::Parallel`].
    pub fn new(origin: DVec3, direction: DVec3, zero_direction: DVec3, radius: f64) -> Result<Self, Error> {
        let radius = positive("geometry-tube-radius", radius)?;
        let e3 = unit("geometry-tube-direction", direction)?;
        let zero = unit("geometry-tube-zero-direction", zero_direction)?;
        let across = zero - zero.dot(e3) * e3;
        if across.length() < 1e-9 {
            return Err(Error::Parallel { first: "geometry-tube-direction", second: "geometry-zero-direction" });
        }
        if !origin.is_finite() {
            return Err(Error::Direction { what: "geometry-tube-origin" });
        }
        let e1 = across.normalize();
        Ok(Self { origin, e1, e2: e3.cross(e1), e3, radius })
    }

    /// The point of the axis at height 0, mm.
    pub fn origin(&self) -> DVec3 {
        self.origin
    }

    /// Unit direction of the axis.
    pub fn direction(&self) -> DVec3 {
        self.e3
    }

    /// The point of the axis nearest to `p`.
    pub fn on_axis(&self, p: DVec3) -> DVec3 {
        self.origin + (p - self.origin).dot(self.e3) * self.e3
    }

    /// The tube moved by the rigid motion `by`.
    pub fn moved(&self, by: &DAffine3) -> Self {
        let [e1, e2, e3] = [self.e1, self.e2, self.e3].map(|e| by.transform_vector3(e));
        Self { origin: by.transform_point3(self.origin), e1, e2, e3, radius: self.radius }
    }

    /// Radius, mm.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The wall's point at height zero, its outward normal and its direction of increasing angle.
    pub(crate) fn wall(&self, phi: f64) -> (DVec3, DVec3, DVec3) {
        let (sin, cos) = phi.sin_cos();
        let normal = cos * self.e1 + sin * self.e2;
        (self.origin + self.radius * normal, normal, cos * self.e2 - sin * self.e1)
    }
}
