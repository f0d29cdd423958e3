//! Polylines to lines and arcs in space, whose ends are points of the polyline; or to a cubic spline through few of them
//! ([`reduce_to_spline`]).
//!
//! A span stands for a run of points if
//!
//! - every point of the run is within the tolerance T of the span itself: the segment, or the arc with its extent;
//! - between two points next to each other the span is within T of the straight line between them;
//! - it passes the points in order, but for turning back by up to T, which counts as noise;
//! - every further column is within its own tolerance of what goes linearly from the run's first point to its last, by
//!   path length along the span and by path length along the points.
//!
//! Two points next to each other always have their line. An arc sweeps less than a full turn, since equal ends tell no
//! centre: a circle takes two. Its ends are further apart than T; its radius is at most 10 km
//! ([`GREATEST_RADIUS_MM`]). A run that ends where it starts is a line without length, if all its points are within T
//! of that place.
//!
//! [`Method::Greedy`] is the one of EBW-2004 (Paton and others): the longest run from the first point for which a line
//! or an arc is found, and again from its last point. *Longest* is meant literally: all ends are tried from the last
//! one down, except those for which it is proven that there is no span. [`Method::Fewest`] never has more spans.
//!
//! How a span is found is told in `run.rs`; what makes it quick, in `feasible.rs`: three points that no arc comes near
//! mostly exclude the next run too, and many at once.

mod discs;
mod feasible;
mod fewest;
mod measure;
mod run;
mod spline;
#[cfg(test)]
mod tests;
mod track;

pub use spline::{SplineReduction, reduce_to_spline};

use crate::Error;
use crate::error::positive;
use glam::DVec3;
use track::Track;

/// Greatest radius of an arc, mm: beyond it a printed centre no longer tells the arc.
pub const GREATEST_RADIUS_MM: f64 = measure::GREATEST_RADIUS_MM;

/// Greatest coordinate, mm.
pub const GREATEST_COORDINATE_MM: f64 = 1e9;

/// A line or an arc between two points of a polyline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Index of the point where it starts.
    pub first: usize,
    /// Index of the point where it ends; the next span starts there.
    pub last: usize,
    /// What it is.
    pub shape: Shape,
    /// Greatest distance of the run's points from it, mm; never above the tolerance.
    pub max_error: f64,
}

/// What a span is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// The straight line between its ends.
    Line,
    /// The arc between its ends that goes counter-clockwise about `normal`.
    Arc {
        /// Centre, mm.
        centre: DVec3,
        /// Radius, mm.
        radius: f64,
        /// Unit normal of its plane.
        normal: DVec3,
    },
}

/// How a polyline is cut into runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// From the start the longest run that has a span, then the next.
    Greedy,
    /// As few spans as can be.
    Fewest,
}

/// A polyline as spans.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// From the first point to the last; none for fewer than two points.
    pub spans: Vec<Span>,
    /// A proven bound: no reduction within the tolerance has fewer spans than this. [`Method::Fewest`] ends with as
    /// many spans, unless the proof would take too long: on paths of very many points whose noise is near the
    /// tolerance.
    /// [`Method::Greedy`] proves nothing: 1, or 0 without spans.
    pub at_least: usize,
}

/// Reduces a polyline to lines and arcs within `tolerance` (mm), with further columns (each as long as `points`, in any
/// unit) carried along linearly within `axis_tolerance`. In any one frame.
///
/// # Errors
/// [`Error::Size`] if a tolerance is not finite and positive, or a column is not as long as the points;
/// [`Error::Place`] for the first value that is not finite, or a coordinate beyond [`GREATEST_COORDINATE_MM`].
pub fn reduce(
    points: &[DVec3],
    axes: &[Vec<f64>],
    (tolerance, axis_tolerance): (f64, f64),
    method: Method,
) -> Result<Reduction, Error> {
    check(points, axes, (tolerance, axis_tolerance))?;
    if points.len() < 2 {
        return Ok(Reduction { spans: Vec::new(), at_least: 0 });
    }
    let track = Track::new(points, axes, tolerance, axis_tolerance);
    if method == Method::Greedy {
        return Ok(Reduction { spans: track.greedy(), at_least: 1 });
    }
    let points: Vec<DVec3> = points.iter().rev().copied().collect();
    let axes: Vec<Vec<f64>> = axes.iter().map(|column| column.iter().rev().copied().collect()).collect();
    let found = fewest::fewest(&track, &Track::new(&points, &axes, tolerance, axis_tolerance));
    Ok(Reduction { spans: found.spans, at_least: found.at_least })
}

/// Tolerances, and values that are some.
fn check(points: &[DVec3], axes: &[Vec<f64>], (tolerance, axis_tolerance): (f64, f64)) -> Result<(), Error> {
    let in_range = |p: DVec3| p.is_finite() && p.abs().max_element() <= GREATEST_COORDINATE_MM;
    positive("the tolerance", tolerance)?;
    positive("the tolerance of further columns", axis_tolerance)?;
    if let Some(index) = points.iter().position(|p| !in_range(*p)) {
        return Err(Error::Place { index });
    }
    for column in axes {
        if column.len() != points.len() {
            return Err(Error::Size { what: "the length of a column", value: column.len() as f64 });
        }
        if let Some(index) = column.iter().position(|v| !v.is_finite()) {
            return Err(Error::Place { index });
        }
    }
    Ok(())
}
