use seamwright_document::Finite;
use seamwright_document::{Document, DocumentError};
use std::collections::BTreeMap;

/// Process values by name; the name ends in the unit, like `current_a`, `voltage_v`, `wire_feed_m_min`.
pub type ProcessValues = BTreeMap<String, Finite>;

/// Checks the process values at `path` of a file: a name becomes a column and ends in a unit, a value is not negative.
///
/// # Errors
/// With the key's address.
pub fn check_process<T>(file: &Document<T>, path: &str, values: &ProcessValues) -> Result<(), DocumentError> {
    for (name, value) in values {
        let key = format!("{path}.{name}");
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        if !name.chars().all(plain) || !name.contains('_') {
            let allowed = "lower-case letters, digits and _, ending in the unit, like current_a";
            return Err(file.error_at(&key, "this is no name of a process value", allowed));
        }
        if seamwright_document::RESERVED_COLUMNS.contains(&name.as_str()) {
            return Err(file.error_at(&key, "another column has this name", "a name of its own"));
        }
        if value.get() < 0.0 {
            return Err(file.error_at(&key, "a process value is not negative", "0 or greater"));
        }
    }
    Ok(())
}
