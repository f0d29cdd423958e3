//! Curves, implicit surfaces, their intersections, and arc length.
//!
//! This crate knows no welding, files or time.
//!
//! # Where to start
//!
//! | task | item |
//! |---|---|
//! | a curve with exact derivatives | [`Curve`] |
//! | simple curves | [`Line`], [`Arc`], [`Chain`]s of both, [`RoundedRectangle`], [`Ellipse`], [`Helix`], [`Spline`] |
//! | the curve in which a tube meets a body | [`TubeIntersection`], [`TrimmedIntersection`], [`TorusIntersection`], [`HeadIntersection`] |
//! | arc length, and the parameter at an arc length | [`ByLength`] |
//! | a curve where two faces meet, with their outward normals | [`Edge`] |
//! | a spline with few knots near given points | [`fit_spline`] |
//! | lines and arcs near a polyline | [`reduce`] |
//! | an implicit surface with gradient and Hessian; the distance from it | [`Quadric`], [`QuadricDistance`] |
//! | the head of a vessel: quadrics and a [`Torus`] without a corner | [`Head`] |
//! | the rigid motion that brings nominal geometry to measured points | [`fit`] |
//! | bisection, systems of linear equations with few diagonals | [`numeric`] |
//! | pixels of a camera to mm on a plane, or in space | [`PlaneMap`], [`HeightTable`] |
//!
//! # Units and frames
//!
//! Lengths are in mm, angles in rad. All points and directions are in one fixed frame that the caller chooses.
//!
//! # Errors
//!
//! Constructors check their arguments and return [`Error`]; those of camera maps return [`MapError`] or [`HeightError`].
//! Evaluation of a constructed curve or surface does not fail.
//!
//! # Examples
//!
//! The seam of a nozzle on a cylindrical shell, by arc length:
//!
//! ```
//! use glam::DVec3;
//! use seamwright_geometry::{ByLength, Curve, DEFAULT_ACCURACY_MM, Quadric, Tube, TubeIntersection};
//!
//! let nozzle = Tube::new(DVec3::ZERO, DVec3::Z, DVec3::X, 250.0)?;
//! let shell = Quadric::cylinder(DVec3::ZERO, DVec3::X, 800.0)?;
//! let seam = ByLength::new(TubeIntersection::new(nozzle, shell)?, DEFAULT_ACCURACY_MM)?;
//! // By symmetry a quarter of the length is a quarter of a turn about the nozzle.
//! let point = seam.curve().point(seam.parameter(0.25 * seam.length()));
//! let height = (800.0f64.powi(2) - 250.0f64.powi(2)).sqrt();
//! assert!((point - DVec3::new(0.0, 250.0, height)).length() < 1e-9);
//! # Ok::<(), seamwright_geometry::Error>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod arc;
mod arc_length;
mod chebyshev;
mod cubic_spline;
mod curve;
mod curve_chain;
mod edge;
mod ellipse;
mod error;
pub mod fit;
mod head_intersection;
mod height_table;
mod helix;
mod homography;
mod knots;
mod line;
mod monotone;
pub mod numeric;
mod parallel_surface;
mod pieces;
mod plane_map;
mod pose;
mod quadric;
pub mod reduce;
mod rounded_rectangle;
mod signed_distance;
mod slices;
mod slopes;
mod spline;
mod spline_edge;
mod spline_fit;
mod torus;
mod torus_intersection;
mod trimmed_intersection;
mod tube;
mod tube_intersection;
mod vessel_head;

pub use arc::Arc;
pub use arc_length::{ByLength, DEFAULT_ACCURACY_MM};
pub use chebyshev::{NODES, Series, nodes};
pub use cubic_spline::CubicSpline;
pub use curve::{Curve, Jet};
pub use curve_chain::{Chain, Piece};
pub use edge::{CurvedEdge, Edge, EdgePoint, FaceRule};
pub use ellipse::Ellipse;
pub use error::Error;
pub use head_intersection::HeadIntersection;
pub use height_table::{HeightError, HeightTable};
pub use helix::Helix;
pub use homography::Homography;
pub use line::Line;
pub use monotone::MonotoneCurve;
pub use parallel_surface::{ParallelIntersection, ParallelSurface};
pub use plane_map::{MapError, MapParameters, PlaneMap};
pub use pose::{Pose, angle_between};
pub use quadric::{Quadric, Surface};
pub use rounded_rectangle::RoundedRectangle;
pub use signed_distance::{Foot, QuadricDistance, SignedDistance};
pub use slices::Slices;
pub use slopes::End;
pub use spline::{Ends, Spline, chord_lengths};
pub use spline_edge::{Along, Normals, SplineEdge, SplineFaces};
pub use spline_fit::fit_spline;
pub use torus::Torus;
pub use torus_intersection::TorusIntersection;
pub use trimmed_intersection::TrimmedIntersection;
pub use tube::Tube;
pub use tube_intersection::TubeIntersection;
pub use vessel_head::{Flange, Head};
