//! From pixels to mm and back, for a camera and for the raster of a beam.
//!
//! The camera's frame has x to the right in the picture, y down, and z away from the camera along its optical axis. A
//! *height* is the z of a plane square to that axis, counted from the frame's origin, which is put where it is
//! convenient: on the work, for a beam. On one such plane pixels and mm are joined by a [`PlaneMap`]; how that changes
//! with height is a [`HeightTable`]; [`identify`] finds a map from one picture of a grid of dots.

mod grid;

pub use grid::{Dot, Grid, GridError, Identified, identify};
pub use seamwright_geometry::{HeightError, HeightTable, MapError, MapParameters, PlaneMap};
