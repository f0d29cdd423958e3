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
mod reduction;
mod run;
mod spline;
#[cfg(test)]
mod tests;
mod track;

pub use reduction::{Method, Reduction, Shape, Span, Tolerances};
pub use spline::{SplineReduction, reduce_to_spline};

use crate::error::{Error, positive};
use glam::DVec3;
use track::Track;

/// Maximum absolute coordinate, mm.
pub const MAX_COORDINATE_MM: f64 = 1e9;

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
