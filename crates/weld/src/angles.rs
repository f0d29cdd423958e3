use crate::plane_seam;
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::RoundedRectangle;
use seamwright_program::Seam;

/// Source of the angles along the curve.
pub(crate) enum Angles {
    None,
    /// The curve's parameter is the angle.
    Parameter,
    /// About the middle of a rectangle.
    Rectangle(Box<RoundedRectangle>),
}

impl Angles {
    /// The angles of a seam; `closed` ones have them by the curve's parameter, as a rule. Errors: those of the seam.
    pub(crate) fn new<T>(file: &Document<T>, seam: &Seam, closed: bool) -> Result<Self, DocumentError> {
        Ok(match seam {
            Seam::RoundedRectangle(r) => Self::Rectangle(Box::new(plane_seam::rectangle(file, r)?.curve)),
            Seam::Polyline(_) | Seam::Spline(_) => Self::None,
            Seam::Helix(_) => Self::Parameter,
            _ if closed => Self::Parameter,
            _ => Self::None,
        })
    }

    /// The angle (rad) at parameter `u` of the curve.
    pub(crate) fn at(&self, u: f64) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Parameter => Some(u),
            Self::Rectangle(rectangle) => Some(rectangle.angle(u)),
        }
    }

    /// The curve's parameter at an angle (rad).
    pub(crate) fn parameter(&self, phi: f64) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Parameter => Some(phi),
            Self::Rectangle(rectangle) => Some(rectangle.at_angle(phi)),
        }
    }
}
