//! The map of a plane from one picture of a known grid of dots.

mod dots;
mod fit;
mod order;

use super::{MapError, PlaneMap};
use crate::Frame;
use glam::DVec2;
use thiserror::Error;

/// Fewest dots that are believed.
pub(crate) const FEWEST_DOTS: usize = 25;

/// A grid of dark dots on a lighter plate, square to the optical axis: rows and columns at right angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Distance of two dots next to each other, mm.
    pub pitch_mm: f64,
    /// The pixel where the optical axis meets the plate; the frame's middle if not given.
    pub centre_px: Option<DVec2>,
    /// Greatest RMS distance of the dots from where the map has them, pixels: above it the picture is none of the grid.
    pub limit_px: f64,
}

/// A map, and how well the picture fits it.
#[derive(Debug, Clone, PartialEq)]
pub struct Identified {
    /// The map.
    pub map: PlaneMap,
    /// The dots that were found.
    pub dots: Vec<Dot>,
    /// RMS distance of the dots from where the map has them, pixels.
    pub rms_px: f64,
    /// The greatest such distance, pixels.
    pub max_px: f64,
}

/// A dot of the grid in the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dot {
    /// Where it is seen.
    pub px: DVec2,
    /// Where the map has it, from there, pixels.
    pub off_px: DVec2,
}

/// Why a picture gives no map.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum GridError {
    /// Not a pitch.
    #[error("a pitch of {0} mm: a finite number greater than 0")]
    Pitch(f64),
    /// Hardly any difference between dark and light.
    #[error("no dark dots: the picture is nearly plain (the darkest places are {0:.1} % darker than those about them)")]
    Plain(f64),
    /// Too few dots that hang together.
    #[error("{found} dots of a grid: at least {FEWEST_DOTS} are needed, all over the picture")]
    Few {
        /// How many.
        found: usize,
    },
    /// Two ways around the grid lead to different places.
    #[error("the dots are not the crossings of one grid: near ({x:.0}, {y:.0}) rows and columns do not meet")]
    Tangled {
        /// Pixels to the right.
        x: f64,
        /// Pixels down.
        y: f64,
    },
    /// The dots cover only a part of the frame.
    #[error("the dots cover {0:.0} % of the picture's width or height: at least half is needed")]
    Corner(f64),
    /// The dots fit no map.
    #[error(
        "the dots are {rms:.2} px RMS from any map, at most {max:.2}: the picture is not of this grid, or not sharp"
    )]
    Residual {
        /// RMS, pixels.
        rms: f64,
        /// Greatest, pixels.
        max: f64,
    },
    /// What was found is no map.
    #[error("what fits the dots is no map: {0}")]
    Map(#[from] MapError),
}

/// Finds the map of a plane from one picture of a grid of dots on it.
///
/// Dots are found as dark spots against the mean about them, to a fraction of a pixel by their centroids; they are put in
/// order from the middle outwards; then scale, rotation, shear, offset and barrel follow by Gauss and Newton's method from
/// the squared distances in pixels. A grid does not tell quarter turns: the rotation is taken within 45 degrees of
/// upright, and the picture as not mirrored.
///
/// # Errors
/// A picture that does not show such a grid well, and why.
pub fn identify(frame: &Frame, grid: &Grid) -> Result<Identified, GridError> {
    if !grid.pitch_mm.is_finite() || grid.pitch_mm <= 0.0 {
        return Err(GridError::Pitch(grid.pitch_mm));
    }
    let dots = dots::find(frame)?;
    let ordered = order::ordered(&dots, (frame.width(), frame.height()))?;
    fit::fit(&ordered, (frame.width(), frame.height()), grid)
}
