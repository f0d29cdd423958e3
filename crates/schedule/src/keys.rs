//! Names of keys, for paths that tables and studies give.

use schemars::Schema;
use seamwright_document::closest;
use serde_json::Value;
use std::collections::HashSet;

/// Names of the keys of a format.
#[derive(Debug, Clone)]
pub(crate) struct Keys {
    top: Vec<String>,
    all: HashSet<String>,
}

impl Keys {
    /// Those of a format with this schema.
    pub(crate) fn of(schema: &Schema) -> Self {
        let schema = schema.as_value();
        let mut all = HashSet::new();
        collect(schema, &mut all);
        let top = schema.get("properties").and_then(Value::as_object);
        Self { top: top.map_or(Vec::new(), |keys| keys.keys().cloned().collect()), all }
    }

    /// True if every step of the path is a key of the format. Names under `process` and `offsets` are the file's own.
    pub(crate) fn knows(&self, path: &str) -> bool {
        let mut steps = path.split('.').map(|step| step.split('[').next().unwrap_or(step));
        let Some(first) = steps.next() else { return false };
        let mut own = first == "offsets";
        self.top.iter().any(|key| key == first)
            && steps.all(|step| {
                let known = own || self.all.contains(step);
                own = step == "process";
                known
            })
    }

    /// The path with the step that is unknown replaced by the key that was probably meant.
    pub(crate) fn closest_path(&self, path: &str) -> Option<String> {
        let mut steps: Vec<String> = path.split('.').map(str::to_owned).collect();
        let top: Vec<&str> = self.top.iter().map(String::as_str).collect();
        let all: Vec<&str> = self.all.iter().map(String::as_str).collect();
        for (i, step) in steps.iter_mut().enumerate() {
            let known = if i == 0 { &top } else { &all };
            if !known.contains(&step.as_str()) {
                *step = closest(step, known)?.to_owned();
            }
        }
        Some(steps.join(".")).filter(|meant| meant != path && self.knows(meant))
    }
}

/// Adds the names of all properties of a schema.
fn collect(schema: &Value, names: &mut HashSet<String>) {
    match schema {
        Value::Object(object) => {
            if let Some(Value::Object(properties)) = object.get("properties") {
                names.extend(properties.keys().cloned());
            }
            object.values().for_each(|value| collect(value, names));
        }
        Value::Array(list) => list.iter().for_each(|value| collect(value, names)),
        _ => {}
    }
}
