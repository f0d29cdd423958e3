use crate::error::Error;
use glam::DVec3;
use seamwright_geometry::{ByLength, Curve, Ellipse, Jet, TubeIntersection};

#[derive(Debug, Clone)]
#[allow(clippy::large_enum_variant, reason = "there is one a path")]
pub(crate) enum Base {
    /// An ellipse with its semi-axes, mm.
    Ellipse { curve: Ellipse, a: f64, b: f64 },
    /// A saddle with its two radii, mm.
    Saddle { curve: TubeIntersection, nozzle: f64, shell: f64 },
}

/// A piece of an ellipse or a saddle, in the direction of travel: the true curve that every method is compared with.
///
/// The angle `u` (rad) is the eccentric angle of the ellipse or the angle about the nozzle's axis; it is not wrapped:
/// it runs evenly from [`Path::start_rad`] to [`Path::end_rad`], up or down. As a [`Curve`] the parameter is the
/// angle travelled since the start, from 0 to [`Path::span_rad`].
#[derive(Debug, Clone)]
pub struct Path {
    pub(crate) base: Base,
    start: f64,
    direction: f64,
    span: f64,
}

impl Path {
    pub(crate) fn new(base: Base, start: f64, direction: f64, span: f64) -> Self {
        Self { base, start, direction, span }
    }

    /// Angle at the start, rad.
    pub fn start_rad(&self) -> f64 {
        self.start
    }

    /// Angle at the end, rad.
    pub fn end_rad(&self) -> f64 {
        self.angle(self.span)
    }

    /// Angle travelled from start to end, rad, greater than 0.
    pub fn span_rad(&self) -> f64 {
        self.span
    }

    /// +1 if the angle increases along the path, -1 if it decreases.
    pub fn direction(&self) -> f64 {
        self.direction
    }

    /// The point at angle `u_rad`, mm; also beyond the ends.
    pub fn point(&self, u_rad: f64) -> DVec3 {
        self.curve().point(u_rad)
    }

    /// Length of the whole path, mm, within 1e-12 mm or the rounding of the length itself.
    ///
    /// # Errors
    /// A curve without a finite length.
    pub fn length_mm(&self) -> Result<f64, Error> {
        Ok(self.by_length(seamwright_geometry::DEFAULT_ACCURACY_MM)?.length())
    }

    pub(crate) fn by_length(&self, accuracy_mm: f64) -> Result<ByLength<Self>, Error> {
        Ok(ByLength::new(self.clone(), accuracy_mm)?)
    }

    pub(crate) fn angle(&self, travelled: f64) -> f64 {
        self.start + self.direction * travelled
    }

    /// Point and derivatives by the angle at angle `u`.
    pub(crate) fn jet_at(&self, u: f64) -> Jet {
        self.curve().jet(u)
    }

    /// Semi-axes of the path seen along z, mm.
    pub(crate) fn plan_axes(&self) -> (f64, f64) {
        match self.base {
            Base::Ellipse { a, b, .. } => (a, b),
            Base::Saddle { nozzle, .. } => (nozzle, nozzle),
        }
    }

    /// Maximum coordinate of the path, mm.
    pub(crate) fn size(&self) -> f64 {
        match self.base {
            Base::Ellipse { a, b, .. } => a.max(b),
            Base::Saddle { shell, .. } => shell,
        }
    }

    fn curve(&self) -> &dyn Curve {
        match &self.base {
            Base::Ellipse { curve, .. } => curve,
            Base::Saddle { curve, .. } => curve,
        }
    }
}

impl Curve for Path {
    fn domain(&self) -> (f64, f64) {
        (0.0, self.span)
    }
    fn jet(&self, travelled: f64) -> Jet {
        let jet = self.jet_at(self.angle(travelled));
        Jet { d1: self.direction * jet.d1, ..jet }
    }
}
