//! Allowed values as messages.

use seamwright_message::{Message, Unit};

/// A computed length as errors show it: rounded to the resolution of positions on a seam, mm.
pub(crate) fn rounded(mm: f64) -> f64 {
    (mm * 1e6).round() / 1e6
}

pub(crate) fn at_least(min: f64, unit: Unit) -> Message {
    Message::new("document-at-least").value("min", min, unit)
}

pub(crate) fn at_most(max: f64, unit: Unit) -> Message {
    Message::new("document-at-most").value("max", max, unit)
}

pub(crate) fn more_than(min: f64, unit: Unit) -> Message {
    Message::new("document-more-than").value("min", min, unit)
}

pub(crate) fn less_than(max: f64, unit: Unit) -> Message {
    Message::new("document-less-than").value("max", max, unit)
}

/// From `min` to `max`, both allowed.
pub(crate) fn between(min: f64, max: f64, unit: Unit) -> Message {
    Message::new("document-between").value("min", min, unit).value("max", max, unit)
}

/// Between `min` and `max`, neither allowed.
pub(crate) fn strictly_between(min: f64, max: f64, unit: Unit) -> Message {
    Message::new("document-strictly-between").value("min", min, unit).value("max", max, unit)
}

/// Positions on a weld that ends at `end` mm. On a closed seam the end is the start.
pub(crate) fn on_weld(end: f64, all_round: bool) -> Message {
    match all_round {
        true => {
            let from = Message::new("weld-allowed-from-less-than").value("min", 0.0, Unit::Mm);
            from.value("max", rounded(end), Unit::Mm)
        }
        false => between(0.0, rounded(end), Unit::Mm),
    }
}

/// Allowed values against those of another key: `code` has the arguments `$key` and `$value`, as in the file.
pub(crate) fn by_key(code: &'static str, key: &'static str, value: f64) -> Message {
    Message::new(code).key("key", key).text("value", value.to_string())
}

pub(crate) fn not_along(key: &'static str) -> Message {
    Message::new("weld-allowed-not-along").key("key", key)
}

pub(crate) fn other_point(key: &'static str) -> Message {
    Message::new("weld-allowed-other-point").key("key", key)
}
