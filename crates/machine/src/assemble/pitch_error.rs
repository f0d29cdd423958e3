use super::File;
use crate::pitch_error::STEEPEST;
use crate::{Axis, AxisKind, PitchError, PitchErrorFile};
use seamwright_document::{DocumentError, Finite};
use seamwright_geometry::CubicSpline;
use std::f64::consts::TAU;

/// The table of `axis`.
pub(super) fn pitch_error(file: &File, axis: &Axis, table: &PitchErrorFile) -> Result<PitchError, DocumentError> {
    let key = |k: &str| format!("pitch_error.{}.{k}", axis.name);
    let (at, error, unit, other) = match axis.kind {
        AxisKind::Linear => (&table.at_mm, &table.error_mm, "mm", table.at_deg.is_some() || table.error_deg.is_some()),
        AxisKind::Rotary => (&table.at_deg, &table.error_deg, "deg", table.at_mm.is_some() || table.error_mm.is_some()),
    };
    let keys = format!("at_{unit} and error_{unit}, lists of equal length");
    let (Some(at), Some(error), false) = (at, error, other) else {
        let path = format!("pitch_error.{}", axis.name);
        return Err(file.error_at(&path, format!("the table of axis `{}` is in {unit}", axis.name), keys));
    };
    if at.len() != error.len() || at.len() < 2 {
        let message = format!("{} places and {} errors", at.len(), error.len());
        return Err(file.error_at(&key(&format!("error_{unit}")), message, "as many errors as places, at least 2"));
    }
    let scale = |v: &Finite| axis.from_file(v.get());
    let points: Vec<(f64, f64)> = at.iter().map(scale).zip(error.iter().map(scale)).collect();
    let spline = match axis.range {
        Some(_) => CubicSpline::level(&points),
        // An axis without end stops is periodic, and so is its error.
        None => CubicSpline::periodic(&points, TAU),
    };
    let spline = spline.map_err(|_| {
        let allowed = if axis.range.is_some() { "increasing places" } else { "increasing places within one turn" };
        file.error_at(&key(&format!("at_{unit}")), "the places do not fit", allowed)
    })?;
    let steepest = spline.steepest();
    if steepest > STEEPEST {
        let message = format!("the error changes by {steepest:.3} {unit} per {unit}: that is no pitch error");
        return Err(file.error_at(&key(&format!("error_{unit}")), message, format!("up to {STEEPEST} per {unit}")));
    }
    Ok(PitchError::new(spline))
}
