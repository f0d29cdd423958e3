//! Converts polylines to lines and arcs in space, whose ends are points of the polyline; or to a cubic spline through
//! few of them ([`reduce_to_spline`]).
//!
//! A span stands for a run of points if
//!
//! - every point of the run is within the tolerance T of the span itself: the segment, or the arc with its extent;
//! - between two points next to each other the span is within T of the straight line between them;
//! - it passes the points in order; turning back by up to T counts as noise;
//! - every further column is within its own tolerance of the linear course from first to last point, by path length
//!   along span and points.
//!
//! Two neighbouring points always have their line. An arc sweeps less than a full turn, since equal ends do not define
//! a centre: a circle takes two. Its ends are further apart than T; its radius is at most 10 km. A run that ends at its start is a line of length zero, if all its points are within T of
//! that position.
//!
//! [`Method::Greedy`] is the method of EBW-2004 (Paton and others): the longest run from the first point for which a
//! line or an arc is found, and again from its last point. *Longest* is exact: all ends are tried from the last one
//! down, except those proven to have no span. [`Method::Fewest`] never has more spans.
//!
//! `run.rs` describes the search for a span, `feasible.rs` its acceleration: three points that exclude every arc mostly
//! exclude the next run too, and many at once.

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

/// Maximum absolute coordinate, mm.
pub const MAX_COORDINATE_MM: f64 = 1e9;

/// A line or an arc between two points of a polyline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Index of its first point.
    pub first: usize,
    /// Index of its last point; the next span starts there.
    pub last: usize,
    /// Shape of the span.
    pub shape: Shape,
    /// Maximum distance of the run's points from it, mm; at most the tolerance.
    pub max_error: f64,
}

/// Shape of a span.
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

/// Method of cutting a polyline into runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// From the start the longest run that has a span, then the next.
    Greedy,
    /// The minimum number of spans.
    Fewest,
}

/// A polyline as spans.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// From the first point to the last; none for fewer than two points.
    pub spans: Vec<Span>,
    /// A proven bound: no reduction within the tolerance has fewer spans than this. [`Method::Fewest`] ends with as
    /// many spans, unless the proof would take too long: on paths of very many points whose noise is near the
    /// tolerance. With [`Method::Greedy`] 1, or 0 without spans.
    pub at_least: usize,
}

/// Maximum deviations of a reduction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerances {
    /// Maximum distance of a point from its curve, mm.
    pub path_mm: f64,
    /// Maximum deviation of a further column, in its own unit.
    pub columns: f64,
}

/// Reduces a polyline to lines and arcs within the tolerances, with further columns (each as long as `points`, in any
/// unit) carried along linearly. In any one frame.
///
/// # Errors
/// [`Error::Size`] if a tolerance is not finite and positive; [`Error::Column`] if a column is not as long as the
/// points; [`Error::Place`] for the first value that is not finite, or a coordinate beyond [`MAX_COORDINATE_MM`].
pub fn reduce(points: &[DVec3], axes: &[Vec<f64>], tolerances: Tolerances, method: Method) -> Result<Reduction, Error> {
    check(points, axes, tolerances)?;
    if points.len() < 2 {
        return Ok(Reduction { spans: Vec::new(), at_least: 0 });
    }
    let track = Track::new(points, axes, tolerances);
    if method == Method::Greedy {
        return Ok(Reduction { spans: track.greedy(), at_least: 1 });
    }
    let points: Vec<DVec3> = points.iter().rev().copied().collect();
    let axes: Vec<Vec<f64>> = axes.iter().map(|column| column.iter().rev().copied().collect()).collect();
    let found = fewest::fewest(&track, &Track::new(&points, &axes, tolerances));
    Ok(Reduction { spans: found.spans, at_least: found.at_least })
}

/// Checks that the tolerances and all values are valid.
fn check(points: &[DVec3], axes: &[Vec<f64>], tolerances: Tolerances) -> Result<(), Error> {
    let in_range = |p: DVec3| p.is_finite() && p.abs().max_element() <= MAX_COORDINATE_MM;
    positive("geometry-tolerance", tolerances.path_mm)?;
    positive("geometry-column-tolerance", tolerances.columns)?;
    if let Some(index) = points.iter().position(|p| !in_range(*p)) {
        return Err(Error::Place { index });
    }
    for column in axes {
        if column.len() != points.len() {
            return Err(Error::Column { values: column.len(), points: points.len() });
        }
        if let Some(index) = column.iter().position(|v| !v.is_finite()) {
            return Err(Error::Place { index });
        }
    }
    Ok(())
}
