//! Conversion between pixels and mm, for a camera and for the raster of a beam.
//!
//! The camera frame has x to the right in the picture, y down, and z away from the camera along its optical axis. A
//! *height* is the z of a plane perpendicular to that axis, measured from the frame's origin. The origin is placed
//! where it is convenient, for a beam on the work. A [`PlaneMap`] relates pixels and mm on one such plane; a
//! [`HeightTable`] gives its change with height. [`identify`] finds a map from one picture of a grid of dots.

mod grid;

pub use grid::{Dot, Grid, GridError, Identified, identify};
pub use seamwright_geometry::{HeightError, HeightTable, MapError, MapParameters, PlaneMap};
