use crate::span_value::SpanValue;
use seamwright_document::{Document, DocumentError, Finite};
use seamwright_message::{Message, Unit};
use std::collections::BTreeMap;

/// Process values by name; the name ends in the unit, like `current_a`, `voltage_v`, `wire_feed_m_min`.
pub type ProcessValues = BTreeMap<String, ProcessValue>;

/// A process value over a span.
pub type ProcessValue = SpanValue<Finite>;

/// Checks a name of a process value, at `path` of a file: it becomes a column and ends in a unit.
///
/// # Errors
/// With the key's address.
pub fn check_process_name<T>(file: &Document<T>, path: &str, name: &str) -> Result<(), DocumentError> {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    if !name.chars().all(plain) || !name.contains('_') {
        let message = Message::new("program-process-name-invalid");
        return Err(file.error_at(path, message, Message::new("program-process-names")));
    }
    if seamwright_document::RESERVED_COLUMNS.contains(&name) {
        return Err(file.error_at(path, Message::new("program-column-name-taken"), Message::new("document-own-name")));
    }
    Ok(())
}

/// Units at the end of process values' names, longest first: dimension, and the maximum value of welding machines. A
/// gun with 300 kV and a laser with 200 kW exist; more is a mistaken digit.
const UNITS: [(&str, &str, f64); 17] = [
    ("cm_min", "speed", 1e4),
    ("in_min", "speed", 4e3),
    ("mm_min", "speed", 1e5),
    ("m_min", "speed", 1e2),
    ("mm_s", "speed", 2e3),
    ("l_min", "flow", 1e3),
    ("l_h", "flow", 6e4),
    ("m_s", "speed", 2.0),
    ("ka", "current", 5.0),
    ("ma", "current", 5e6),
    ("a", "current", 5e3),
    ("kv", "voltage", 3e2),
    ("mv", "voltage", 3e8),
    ("v", "voltage", 3e5),
    ("kw", "power", 2e2),
    ("mw", "power", 2e8),
    ("w", "power", 2e5),
];

/// Maximum values of an arc, by their usual names, if the arc has a current in `current_a`: far above those of
/// submerged arc welding, the strongest.
const ARC: [(&str, f64); 2] = [("current_a", 3000.0), ("voltage_v", 100.0)];

/// A process value's name without its unit, the unit's dimension and its maximum value; `None` for other units.
fn quantity(name: &str) -> Option<(&str, &'static str, f64)> {
    UNITS.iter().find_map(|(unit, dimension, greatest)| {
        Some((name.strip_suffix(unit)?.strip_suffix('_')?, *dimension, *greatest))
    })
}

/// The maximum value of a process value called `name`, among others of these `names`.
fn greatest<'a>(name: &str, mut names: impl Iterator<Item = &'a String>) -> f64 {
    let of_arc = ARC.iter().find(|(known, _)| *known == name).map(|(_, greatest)| *greatest);
    let of_arc = of_arc.filter(|_| names.any(|other| other == ARC[0].0));
    of_arc.or(quantity(name).map(|(_, _, greatest)| greatest)).unwrap_or(f64::INFINITY)
}

/// Checks that a process value called `name`, at `key` of a file, is possible for a welding machine; `names` are those
/// of all process values there.
///
/// # Errors
/// With the key's address: a negative value, one that is far too large.
pub fn check_process_value<'a, T>(
    file: &Document<T>,
    key: &str,
    name: &str,
    value: f64,
    names: impl Iterator<Item = &'a String>,
) -> Result<(), DocumentError> {
    if value < 0.0 {
        let message = Message::new("program-process-value-negative");
        return Err(file.error_at(key, message, Message::new("document-non-negative-number")));
    }
    let greatest = greatest(name, names);
    if value > greatest {
        let message =
            Message::new("program-process-value-too-large").key("name", name).value("value", value, Unit::One);
        let allowed = Message::new("document-between").number("min", 0.0, 0).value("max", greatest, Unit::One);
        return Err(file.error_at(key, message, allowed));
    }
    Ok(())
}

/// Checks that no quantity is given twice in two units: `wire_feed_m_min` and `wire_feed_mm_s`. Names are sorted. Fails
/// with the address of the second.
pub(crate) fn check_process_units<'a, T>(
    file: &Document<T>,
    path: &str,
    names: &(impl Iterator<Item = &'a String> + Clone),
) -> Result<(), DocumentError> {
    for (i, name) in names.clone().enumerate() {
        let Some((stem, dimension, _)) = quantity(name) else { continue };
        let twice = |other: &&String| quantity(other).is_some_and(|(s, d, _)| (s, d) == (stem, dimension));
        if let Some(other) = names.clone().take(i).find(twice) {
            let message = Message::new("program-same-quantity").key("other", other);
            let allowed = Message::new("program-either").key("first", other).key("second", name);
            return Err(file.error_at(&format!("{path}.{name}"), message, allowed));
        }
    }
    Ok(())
}

/// Checks the process values at `path` of a file: their names, that each is possible for a welding machine, and that
/// each is given once.
///
/// # Errors
/// With the key's address.
pub fn check_process<T>(file: &Document<T>, path: &str, values: &ProcessValues) -> Result<(), DocumentError> {
    for (name, value) in values {
        let key = format!("{path}.{name}");
        check_process_name(file, &key, name)?;
        let (from, to) = value.ends();
        for (end, found) in [("from", from), ("to", to)] {
            let key = if value.is_ramp() { format!("{key}.{end}") } else { key.clone() };
            check_process_value(file, &key, name, found, values.keys())?;
        }
    }
    check_process_units(file, path, &values.keys())
}
