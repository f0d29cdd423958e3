//! Writes values as TOML. They become JSON values first, so that the code of each type is made for one format only.
//! Numbers must be finite: JSON has no others, and their keys would be left out.

use serde::Serialize;
use serde::ser::Error as _;
use serde_json::Value;
use toml::Table;
use toml::ser::Error;

/// Writes keys and values as a text.
///
/// # Errors
/// If the value is no table.
pub fn to_toml<T: Serialize>(value: &T) -> Result<String, Error> {
    text(serde_json::to_value(value))
}

/// Writes keys and values as a table.
///
/// # Errors
/// If the value is no table.
pub fn to_table<T: Serialize>(value: &T) -> Result<Table, Error> {
    table(serde_json::to_value(value))
}

fn text(value: serde_json::Result<Value>) -> Result<String, Error> {
    toml::to_string(&present(value)?)
}

fn table(value: serde_json::Result<Value>) -> Result<Table, Error> {
    Table::try_from(present(value)?)
}

/// The value without the keys that have none.
fn present(value: serde_json::Result<Value>) -> Result<Value, Error> {
    let mut value = value.map_err(Error::custom)?;
    drop_missing(&mut value);
    Ok(value)
}

fn drop_missing(value: &mut Value) {
    match value {
        Value::Object(entries) => {
            entries.retain(|_, value| !value.is_null());
            entries.values_mut().for_each(drop_missing);
        }
        Value::Array(items) => items.iter_mut().for_each(drop_missing),
        _ => {}
    }
}
