//! Identification of the map of a plane from one picture of a known grid of dots.

mod crossings;
mod dots;
mod fit;
mod identified;

use crate::frame::Frame;
pub use identified::{Dot, Grid, GridError, Identified};

/// Identifies the map of a plane from one picture of a grid of dots on it.
///
/// Dots are dark spots against the mean of their surroundings; their centroids locate them to a fraction of a pixel.
/// They are ordered from the middle outwards. Scale, rotation, shear, offset and barrel distortion follow by the
/// Gauss-Newton method from the squared distances in pixels. A grid is the same after quarter turns: the rotation is
/// taken within 45 degrees of upright, and the picture as not mirrored.
///
/// # Errors
/// A [`GridError`] if the picture does not show such a grid well.
pub fn identify(frame: &Frame, grid: &Grid) -> Result<Identified, GridError> {
    if !grid.pitch_mm.is_finite() || grid.pitch_mm <= 0.0 {
        return Err(GridError::Pitch(grid.pitch_mm));
    }
    fit::fit(&crossings::ordered(&dots::find(frame)?, frame.size())?, frame.size(), grid)
}
