use crate::axis::{Axis, AxisKind};
use crate::file::{File, StepFile};
use seamwright_document::{DocumentError, Finite, Positive, RESERVED_COLUMNS};
use seamwright_message::Message;

pub(super) fn axis(file: &File, path: &str, step: &StepFile) -> Result<Option<Axis>, DocumentError> {
    let at = |key: &str| format!("{path}.{key}");
    let Some(name) = &step.axis else {
        let has_axis_keys = StepFile { fixed: None, ..step.clone() } != StepFile::default();
        if step.fixed.is_none() || has_axis_keys {
            return Err(file.fault_at(path, "machine-step-neither", "machine-step-kinds"));
        }
        return Ok(None);
    };
    if step.fixed.is_some() {
        return Err(file.fault_at(&at("fixed"), "machine-step-fixed-axis", "machine-step-fixed-apart"));
    }
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    if name.is_empty() || !name.chars().all(plain) {
        return Err(file.fault_at(&at("axis"), "machine-axis-name-invalid", "machine-plain-letters"));
    }
    if RESERVED_COLUMNS.contains(&name.as_str()) {
        return Err(file.fault_at(&at("axis"), "machine-axis-name-reserved", "document-own-name"));
    }
    let kind = match (&step.turn, &step.direction) {
        (Some(_), None) => AxisKind::Rotary,
        (None, Some(_)) => AxisKind::Linear,
        _ => {
            return Err(file.fault_at(path, "machine-axis-turn-or-move", "machine-turn-or-move"));
        }
    };
    if kind == AxisKind::Linear {
        for (key, given) in [("at_mm", step.at_mm.is_some()), ("continuous", step.continuous)] {
            if given {
                return Err(file.fault_at(&at(key), "machine-axis-key-of-rotary", "machine-only-with-turn"));
            }
        }
    }
    let range = range(file, path, step, kind)?;
    let key = Key { what: "home", power: "" };
    let home = unit_value(file, path, kind, key, step.home_mm, step.home_deg)?.map_or(0.0, Finite::get);
    let limit = |what: &'static str, power: &'static str, mm, deg| -> Result<f64, DocumentError> {
        let key = Key { what, power };
        let value: Option<Positive> = unit_value(file, path, kind, key, mm, deg)?;
        let key = key.of(kind);
        value.map(Positive::get).ok_or_else(|| {
            let message = Message::new("machine-axis-lacks-key").axis("axis", name).key("key", &key);
            file.error_at(path, message, Message::new("machine-key-positive").key("key", key))
        })
    };
    let max_speed = limit("max_speed", "_s", step.max_speed_mm_s, step.max_speed_deg_s)?;
    let max_acceleration = limit("max_acceleration", "_s2", step.max_acceleration_mm_s2, step.max_acceleration_deg_s2)?;
    let key = Key { what: "max_jerk", power: "_s3" };
    let jerk = unit_value(file, path, kind, key, step.max_jerk_mm_s3, step.max_jerk_deg_s3)?;
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
    if let (Some([low, high]), Some(_)) = (range, axis.outside(axis.home)) {
        let (message, unit) = (Message::new("machine-home-outside-range"), axis.position_unit());
        let allowed = Message::new("document-between").value("min", low, unit).value("max", high, unit);
        return Err(file.error_at(path, message, allowed));
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
            let wrong = || file.error_at(path, Message::new("machine-letter-invalid"), "A B C U V W X Y Z");
            single(text).map(Some).ok_or_else(wrong)
        }
        None => Ok(step.axis.as_ref().and_then(|name| single(&name.to_uppercase()))),
    }
}

/// The fault of a key in the unit of the other kind of axis.
pub(super) fn of_another_kind(kind: AxisKind) -> Message {
    Message::new(match kind {
        AxisKind::Linear => "machine-linear-axis-in-mm",
        AxisKind::Rotary => "machine-rotary-axis-in-degrees",
    })
}

/// A key without its unit: `max_speed` and `_s` are `max_speed_mm_s` and `max_speed_deg_s`.
#[derive(Clone, Copy)]
struct Key<'a> {
    what: &'a str,
    /// The part after the unit of position.
    power: &'a str,
}

impl Key<'_> {
    fn of(self, kind: AxisKind) -> String {
        let Self { what, power } = self;
        format!("{what}_{}{power}", if kind == AxisKind::Linear { "mm" } else { "deg" })
    }
}

/// The one of two values that belongs to the axis' kind; the other must be missing.
fn unit_value<T: Copy>(
    file: &File,
    path: &str,
    kind: AxisKind,
    key: Key,
    mm: Option<T>,
    deg: Option<T>,
) -> Result<Option<T>, DocumentError> {
    let (value, wrong, other_kind) = match kind {
        AxisKind::Linear => (mm, deg, AxisKind::Rotary),
        AxisKind::Rotary => (deg, mm, AxisKind::Linear),
    };
    if wrong.is_some() {
        let given = format!("{path}.{}", key.of(other_kind));
        return Err(file.error_at(&given, of_another_kind(kind), Message::verbatim(key.of(kind))));
    }
    Ok(value)
}

fn range(file: &File, path: &str, step: &StepFile, kind: AxisKind) -> Result<Option<[f64; 2]>, DocumentError> {
    let range = unit_value(file, path, kind, Key { what: "range", power: "" }, step.range_mm, step.range_deg)?;
    let key = if kind == AxisKind::Linear { "range_mm" } else { "range_deg" };
    match (range, step.continuous) {
        (Some(_), true) => Err(file.fault_at(path, "machine-range-of-continuous", "machine-continuous-or-range")),
        (None, true) => Ok(None),
        (None, false) => {
            let allowed = Message::new(match kind {
                AxisKind::Linear => "machine-range-form",
                AxisKind::Rotary => "machine-range-form-or-continuous",
            });
            Err(file.error_at(path, Message::new("machine-range-missing"), allowed.key("key", key)))
        }
        (Some([low, high]), false) if low.get() < high.get() => Ok(Some([low.get(), high.get()])),
        (Some(_), false) => {
            let allowed = Message::new("machine-range-form").key("key", key);
            Err(file.error_at(&format!("{path}.{key}"), Message::new("machine-range-empty"), allowed))
        }
    }
}
