//! Words of formats, from their JSON Schemas.

use schemars::JsonSchema;
use serde_json::Value;
use std::collections::BTreeSet;

/// Keys and names of a TOML format, as they are written in a file, and some values.
pub(crate) fn toml<T: JsonSchema>() -> Vec<String> {
    let mut names = BTreeSet::new();
    collect(&schemars::schema_for!(T).to_value(), &mut names);
    let keys = names.iter().flat_map(|name| [format!("{name} = "), format!("\"{name}\"")]);
    let values =
        ["true", "false", "[", "]", "{ ", " }", "[[", "]]", "\"\"\"", "schema = 1\n", "nan", "inf", "1e6", "-0.0"];
    keys.chain(values.map(str::to_owned)).collect()
}

/// Names of a JSON Schema in quotes, and some values.
pub(crate) fn json(schema: &Value) -> Vec<String> {
    let mut names = BTreeSet::new();
    collect(schema, &mut names);
    let values = ["null", "true", "false", "[", "]", "{", "}", "1e308", "-1", "4294967295", "\\u0000", "\":", "\","];
    names.iter().map(|name| format!("\"{name}\"")).chain(values.map(str::to_owned)).collect()
}

/// Adds the names of properties, constants and choices.
fn collect(schema: &Value, names: &mut BTreeSet<String>) {
    match schema {
        Value::Object(entries) => {
            for (key, value) in entries {
                match (key.as_str(), value) {
                    ("properties", Value::Object(properties)) => names.extend(properties.keys().cloned()),
                    ("const", Value::String(name)) => drop(names.insert(name.clone())),
                    ("enum", Value::Array(all)) => {
                        names.extend(all.iter().filter_map(Value::as_str).map(str::to_owned));
                    }
                    _ => {}
                }
                collect(value, names);
            }
        }
        Value::Array(items) => items.iter().for_each(|item| collect(item, names)),
        _ => {}
    }
}
