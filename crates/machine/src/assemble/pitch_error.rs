use crate::axis::{Axis, AxisKind};
use crate::file::{File, PitchErrorFile};
use crate::pitch_error::{PitchError, STEEPEST};
use seamwright_document::{DocumentError, Finite};
use seamwright_geometry::CubicSpline;
use seamwright_message::{Message, Unit};
use std::f64::consts::TAU;

pub(super) fn pitch_error(file: &File, axis: &Axis, table: &PitchErrorFile) -> Result<PitchError, DocumentError> {
    let key = |k: &str| format!("pitch_error.{}.{k}", axis.name);
    let (at, error, unit, other) = match axis.kind {
        AxisKind::Linear => (&table.at_mm, &table.error_mm, "mm", table.at_deg.is_some() || table.error_deg.is_some()),
        AxisKind::Rotary => (&table.at_deg, &table.error_deg, "deg", table.at_mm.is_some() || table.error_mm.is_some()),
    };
    let error_key = key(&format!("error_{unit}"));
    let (Some(at), Some(error), false) = (at, error, other) else {
        let message = Message::new(match axis.kind {
            AxisKind::Linear => "machine-pitch-in-mm",
            AxisKind::Rotary => "machine-pitch-in-degrees",
        });
        let allowed = Message::new("machine-pitch-keys")
            .key("positions", format!("at_{unit}"))
            .key("errors", format!("error_{unit}"));
        let path = format!("pitch_error.{}", axis.name);
        return Err(file.error_at(&path, message.axis("axis", &axis.name), allowed));
    };
    if at.len() != error.len() || at.len() < 2 {
        let message = Message::new("machine-pitch-lengths").count("positions", at.len()).count("errors", error.len());
        return Err(file.error_at(&error_key, message, Message::new("machine-pitch-equal-lengths")));
    }
    let scale = |v: &Finite| axis.from_file(v.get());
    let points: Vec<(f64, f64)> = at.iter().map(scale).zip(error.iter().map(scale)).collect();
    let spline = match axis.range {
        Some(_) => CubicSpline::level(&points),
        // An axis without end stops is periodic, and so is its error.
        None => CubicSpline::periodic(&points, TAU),
    };
    let spline = spline.map_err(|_| {
        let allowed = Message::new(match axis.range {
            Some(_) => "machine-increasing-positions",
            None => "machine-increasing-within-a-turn",
        });
        file.error_at(&key(&format!("at_{unit}")), Message::new("machine-pitch-positions"), allowed)
    })?;
    let steepest = spline.steepest();
    if steepest > STEEPEST {
        let message = Message::new("machine-pitch-steep").number("slope", steepest, 3);
        let allowed = Message::new("document-at-most").value("max", STEEPEST, Unit::One);
        return Err(file.error_at(&error_key, message, allowed));
    }
    Ok(PitchError::new(spline))
}
