use super::File;
use crate::{Axis, AxisKind, StepFile};
use seamwright_document::{DocumentError, Finite, Positive, RESERVED_COLUMNS};

/// The axis of a step, or none if the step is fixed.
pub(super) fn axis(file: &File, path: &str, step: &StepFile) -> Result<Option<Axis>, DocumentError> {
    let at = |key: &str| format!("{path}.{key}");
    let Some(name) = &step.axis else {
        let has_axis_keys = StepFile { fixed: None, ..step.clone() } != StepFile::default();
        if step.fixed.is_none() || has_axis_keys {
            return Err(file.error_at(
                path,
                "the step is neither an axis nor fixed",
                "either `axis` with its keys, or `fixed` alone",
            ));
        }
        return Ok(None);
    };
    if step.fixed.is_some() {
        return Err(file.error_at(
            &at("fixed"),
            "a step with an axis cannot be fixed",
            "a step of its own for `fixed`",
        ));
    }
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    if name.is_empty() || !name.chars().all(plain) {
        return Err(file.error_at(&at("axis"), "the name cannot be a column", "lower-case letters, digits and _"));
    }
    if RESERVED_COLUMNS.contains(&name.as_str()) {
        return Err(file.error_at(&at("axis"), "another column has this name", "a name of its own"));
    }
    let kind = match (&step.turn, &step.direction) {
        (Some(_), None) => AxisKind::Rotary,
        (None, Some(_)) => AxisKind::Linear,
        _ => return Err(file.error_at(path, "an axis turns or moves", "exactly one of `turn` and `move`")),
    };
    if kind == AxisKind::Linear {
        for (key, given) in [("at_mm", step.at_mm.is_some()), ("continuous", step.continuous)] {
            if given {
                return Err(file.error_at(&at(key), "a linear axis has no such key", "only with `turn`"));
            }
        }
    }
    let range = range(file, path, step, kind)?;
    let home = unit_value(file, path, kind, ("home", ""), step.home_mm, step.home_deg)?.map_or(0.0, Finite::get);
    let limit = |what: &'static str, power: &'static str, mm, deg| -> Result<f64, DocumentError> {
        let value: Option<Positive> = unit_value(file, path, kind, (what, power), mm, deg)?;
        let key = format!("{what}_{}{power}", if kind == AxisKind::Linear { "mm" } else { "deg" });
        value.map(Positive::get).ok_or_else(|| {
            file.error_at(path, format!("axis `{name}` lacks `{key}`"), format!("{key} = a number greater than 0"))
        })
    };
    let max_speed = limit("max_speed", "_s", step.max_speed_mm_s, step.max_speed_deg_s)?;
    let max_acceleration = limit("max_acceleration", "_s2", step.max_acceleration_mm_s2, step.max_acceleration_deg_s2)?;
    let jerk = unit_value(file, path, kind, ("max_jerk", "_s3"), step.max_jerk_mm_s3, step.max_jerk_deg_s3)?;
    // `Axis::jerk` defines the jerk for motion.
    let max_jerk = jerk.map_or(f64::INFINITY, Positive::get);
    let mut axis = Axis {
        name: name.clone(),
        letter: None,
        kind,
        range: None,
        home,
        max_speed,
        max_acceleration,
        max_jerk,
        pitch_error: None,
        drive: None,
        stepper: None,
    };
    axis.letter = letter(file, &at("letter"), step)?;
    axis.range = range.map(|[low, high]| (axis.from_file(low), axis.from_file(high)));
    for value in [&mut axis.home, &mut axis.max_speed, &mut axis.max_acceleration, &mut axis.max_jerk] {
        if kind == AxisKind::Rotary {
            *value = value.to_radians();
        }
    }
    if let Some(limit) = axis.outside(axis.home) {
        let allowed = format!("within the range (limit {})", axis.to_file(limit));
        return Err(file.error_at(path, "the home position is outside the range", allowed));
    }
    Ok(Some(axis))
}

fn letter(file: &File, path: &str, step: &StepFile) -> Result<Option<char>, DocumentError> {
    let known = "ABCUVWXYZ";
    let single = |text: &str| -> Option<char> {
        let mut chars = text.chars();
        chars.next().filter(|c| known.contains(*c) && chars.next().is_none())
    };
    match &step.letter {
        Some(text) => {
            single(text).map(Some).ok_or_else(|| file.error_at(path, "not an axis letter", "A B C U V W X Y Z"))
        }
        None => Ok(step.axis.as_ref().and_then(|name| single(&name.to_uppercase()))),
    }
}

/// The one of two values that belongs to the axis' kind; the other must be missing.
fn unit_value<T: Copy>(
    file: &File,
    path: &str,
    kind: AxisKind,
    (what, power): (&str, &str),
    mm: Option<T>,
    deg: Option<T>,
) -> Result<Option<T>, DocumentError> {
    let (value, wrong, wrong_unit, unit) = match kind {
        AxisKind::Linear => (mm, deg, "deg", "mm"),
        AxisKind::Rotary => (deg, mm, "mm", "deg"),
    };
    if wrong.is_some() {
        let key = format!("{path}.{what}_{wrong_unit}{power}");
        let what_is_wrong =
            if kind == AxisKind::Linear { "a linear axis is in mm" } else { "a rotary axis is in degrees" };
        return Err(file.error_at(&key, what_is_wrong, format!("{what}_{unit}{power}")));
    }
    Ok(value)
}

fn range(file: &File, path: &str, step: &StepFile, kind: AxisKind) -> Result<Option<[f64; 2]>, DocumentError> {
    let range = unit_value(file, path, kind, ("range", ""), step.range_mm, step.range_deg)?;
    let key = if kind == AxisKind::Linear { "range_mm" } else { "range_deg" };
    match (range, step.continuous) {
        (Some(_), true) => Err(file.error_at(path, "a continuous axis has no range", "`continuous` or a range")),
        (None, true) => Ok(None),
        (None, false) => {
            let or = if kind == AxisKind::Rotary { ", or continuous = true" } else { "" };
            Err(file.error_at(path, "the axis has no range", format!("{key} = [lowest, highest]{or}")))
        }
        (Some([low, high]), false) if low.get() < high.get() => Ok(Some([low.get(), high.get()])),
        (Some(_), false) => Err(file.error_at(&format!("{path}.{key}"), "the range is empty", "[lowest, highest]")),
    }
}
