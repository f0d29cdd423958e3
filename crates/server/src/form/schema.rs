use crate::wire::{AddableView, RangeView};
use seamwright_document::{Bound, Step, path_of};
use serde_json::{Map, Value};
use std::sync::LazyLock;

/// Values to begin with, where the least value or the default of the format makes no sense: by path.
static STARTS: LazyLock<Map<String, Value>> =
    LazyLock::new(|| serde_json::from_str(include_str!("starts.json")).unwrap_or_default());

/// Maximum depth of tables in a value to begin with.
const MAX_DEPTH: usize = 4;

/// JSON Schema of a format.
pub(super) struct Schema(Value);

/// Rules of the format for a place in a text.
#[derive(Clone, Default)]
pub(super) struct Place<'s> {
    /// The property, with its own description and default.
    property: Option<&'s Value>,
    /// Kinds of value that can be there, references and alternatives resolved.
    kinds: Vec<&'s Value>,
}

impl Schema {
    pub(super) fn new(root: Value) -> Self {
        Self(root)
    }

    pub(super) fn root(&self) -> Place<'_> {
        self.place(&self.0)
    }

    pub(super) fn at(&self, steps: &[Step]) -> Place<'_> {
        steps.iter().fold(self.root(), |place, step| self.below(&place, step))
    }

    /// The place of a key or an element.
    pub(super) fn below<'s>(&'s self, place: &Place<'s>, step: &Step) -> Place<'s> {
        let property = |kind: &&'s Value| match step {
            Step::Nth(_) => kind.get("items"),
            Step::Key(key) => {
                property(kind, key).or_else(|| kind.get("additionalProperties").filter(|of| of.is_object()))
            }
        };
        let properties: Vec<&Value> = place.kinds.iter().filter_map(property).collect();
        let mut kinds = Vec::new();
        properties.iter().for_each(|of| self.collect(of, &mut kinds));
        Place { property: properties.first().copied(), kinds }
    }

    fn place<'s>(&'s self, property: &'s Value) -> Place<'s> {
        let mut kinds = Vec::new();
        self.collect(property, &mut kinds);
        Place { property: Some(property), kinds }
    }

    /// Collects the kinds of a node. A missing value is not a kind.
    fn collect<'s>(&'s self, node: &'s Value, kinds: &mut Vec<&'s Value>) {
        if let Some(name) = node.get("$ref").and_then(Value::as_str) {
            let of = name.strip_prefix("#/$defs/").and_then(|name| self.0.get("$defs")?.get(name));
            of.into_iter().for_each(|of| self.collect(of, kinds));
        } else if let Some(of) = ["anyOf", "oneOf"].iter().find_map(|key| node.get(*key)?.as_array()) {
            of.iter().for_each(|of| self.collect(of, kinds));
        } else if node.get("type").and_then(Value::as_str) != Some("null") {
            kinds.push(node);
        }
    }

    /// Keys that a table can still be given; `present`: those that it has.
    pub(super) fn addable(&self, place: &Place<'_>, steps: &[Step], present: &[&str]) -> Vec<AddableView> {
        let has_all = |kind: &&&Value| {
            kind.get("properties").is_some() && present.iter().all(|key| property(kind, key).is_some())
        };
        let tables: Vec<&Value> = place.kinds.iter().filter(has_all).copied().collect();
        // Without any key the kind of the table is unknown.
        let Some(table) = tables.first().filter(|_| tables.len() == 1 || !present.is_empty()) else {
            return Vec::new();
        };
        let properties = table["properties"].as_object().into_iter().flatten();
        let missing = properties.filter(|(key, _)| !present.contains(&key.as_str()));
        let addable = missing.filter_map(|(key, property)| {
            let steps = [steps, &[Step::Key(key.clone())]].concat();
            let start = self.start(property, &steps, 0)?;
            let help = self.place(property).help();
            Some(AddableView { key: key.clone(), path: path_of(&steps), help, is_table: start.is_object() })
        });
        addable.collect()
    }

    /// The value that is added at a path; `None` for what can only be written as text.
    pub(super) fn start_at(&self, steps: &[Step]) -> Option<Value> {
        self.start(self.at(steps).property?, steps, 0)
    }

    fn start(&self, property: &Value, steps: &[Step], depth: usize) -> Option<Value> {
        let place = self.place(property);
        if depth > MAX_DEPTH {
            return None;
        }
        if let Some(start) = start_of(steps).filter(|start| place.kinds.iter().any(|kind| is_of(kind, start))) {
            return Some(start.clone());
        }
        let default = property.get("default").filter(|of| !of.is_null() && !of.is_object() && !of.is_array());
        default.cloned().or_else(|| place.kinds.iter().find_map(|kind| self.simplest(kind, steps, depth)))
    }

    fn simplest(&self, kind: &Value, steps: &[Step], depth: usize) -> Option<Value> {
        if let Some(only) = kind.get("const").or_else(|| kind.get("enum")?.get(0)) {
            return Some(only.clone());
        }
        match type_of(kind)? {
            "boolean" => Some(false.into()),
            "number" | "integer" => {
                let above = kind.get("exclusiveMinimum").and_then(Value::as_f64).map(|min| min + 1.0);
                let number = above.or_else(|| kind.get("minimum")?.as_f64()).unwrap_or(0.0);
                Some(if number.fract() == 0.0 { (number as i64).into() } else { number.into() })
            }
            "string" => Some("".into()),
            "array" => {
                let items = self.place(kind.get("items")?);
                let is_direction = kind.get("minItems").and_then(Value::as_u64) == Some(3);
                let of_numbers = items.kinds.iter().all(|kind| type_of(kind) == Some("number"));
                (is_direction && of_numbers).then(|| vec![0, 0, 1].into())
            }
            "object" => {
                let required = kind.get("required").and_then(Value::as_array).into_iter().flatten();
                let entry = |key: &Value| {
                    let key = key.as_str()?;
                    let steps = [steps, &[Step::Key(key.to_owned())]].concat();
                    Some((key.to_owned(), self.start(property(kind, key)?, &steps, depth + 1)?))
                };
                required.map(entry).collect::<Option<Map<_, _>>>().map(Value::Object)
            }
            _ => None,
        }
    }

    /// The kinds of the table at a path, if all of them have values to begin with.
    pub(super) fn kinds(&self, steps: &[Step]) -> Vec<String> {
        let Some((Step::Key(own), above)) = steps.split_last() else { return Vec::new() };
        let only = |kind: &&Value| {
            let properties = kind.get("properties")?.as_object()?;
            (properties.len() == 1).then(|| properties.keys().next().cloned())?
        };
        let names: Option<Vec<String>> = self.at(above).kinds.iter().map(only).collect();
        let names = names.filter(|names| names.len() > 1 && names.contains(own)).unwrap_or_default();
        let has_start = |name: &String| start_of(&[above, &[Step::Key(name.clone())]].concat()).is_some();
        if names.iter().all(has_start) { names } else { Vec::new() }
    }

    /// True if the format allows to remove the table or list at a path.
    pub(super) fn is_removable(&self, steps: &[Step]) -> bool {
        let Some((last, above)) = steps.split_last() else { return false };
        let Step::Key(key) = last else { return self.is_removable(above) };
        let above = self.at(above);
        let required = |kind: &&Value| {
            kind.get("required").and_then(Value::as_array).is_some_and(|of| of.iter().any(|of| of == key))
        };
        !self.below(&above, last).kinds.is_empty() && !above.kinds.iter().any(required)
    }
}

impl Place<'_> {
    pub(super) fn help(&self) -> String {
        let described = self.property.into_iter().chain(self.kinds.iter().copied());
        let help = described.filter_map(|of| of.get("description")?.as_str()).next();
        help.unwrap_or_default().replace('\n', " ")
    }

    /// Allowed texts; empty if any text is allowed.
    pub(super) fn choices(&self) -> Vec<String> {
        let mut choices = Vec::new();
        for kind in &self.kinds {
            let named = kind.get("enum").and_then(Value::as_array).into_iter().flatten().chain(kind.get("const"));
            let before = choices.len();
            choices.extend(named.filter_map(Value::as_str).map(str::to_owned));
            if choices.len() == before && type_of(kind) == Some("string") {
                return Vec::new();
            }
        }
        choices
    }

    /// Allowed numbers at a key.
    pub(super) fn range(&self, key: &str) -> Option<RangeView> {
        let kind = self.kinds.iter().find(|kind| matches!(type_of(kind), Some("number" | "integer")))?;
        let number = |key: &str| kind.get(key).and_then(Value::as_f64);
        let max = number("maximum").or_else(|| Bound::of(key).map(|bound| bound.max));
        let (min, above) = (number("minimum"), number("exclusiveMinimum"));
        let range = RangeView { min: min.or(above), open: min.is_none() && above.is_some(), max };
        (range.min.is_some() || range.max.is_some()).then_some(range)
    }
}

fn property<'s>(kind: &'s Value, key: &str) -> Option<&'s Value> {
    kind.get("properties")?.get(key)
}

/// The type of a kind, apart from null.
fn type_of(kind: &Value) -> Option<&str> {
    match kind.get("type")? {
        Value::Array(types) => types.iter().filter_map(Value::as_str).find(|of| *of != "null"),
        other => other.as_str(),
    }
}

fn is_of(kind: &Value, value: &Value) -> bool {
    match value {
        Value::Object(_) => type_of(kind) == Some("object"),
        Value::String(_) => type_of(kind) == Some("string"),
        Value::Number(_) => matches!(type_of(kind), Some("number" | "integer")),
        _ => true,
    }
}

/// The value to begin with at a path, elements of lists left out: of the whole path, or of its last two keys or more.
fn start_of(steps: &[Step]) -> Option<&'static Value> {
    let keys: Vec<Step> = steps.iter().filter(|step| matches!(step, Step::Key(_))).cloned().collect();
    let ends = (0..keys.len()).filter(|from| *from == 0 || keys.len() - from > 1);
    ends.map(|from| path_of(&keys[from..])).find_map(|path| STARTS.get(&path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_to_begin_with_are_those_of_the_formats() {
        assert!(STARTS.len() > 15);
        let job = Schema::new(schemars::schema_for!(seamwright_weld::Job).to_value());
        for (path, start) in STARTS.iter() {
            let from = if path.starts_with("shape.") { "fixtures[0]." } else { "" };
            let from = if path.starts_with("preparation.") { "joint." } else { from };
            let steps = seamwright_document::steps(&format!("{from}{path}")).unwrap();
            assert_eq!(job.start_at(&steps).as_ref(), Some(start), "{path}");
            let place = job.at(&steps);
            let unknown = |key: &&String| job.below(&place, &Step::Key((*key).clone())).kinds.is_empty();
            assert_eq!(start.as_object().into_iter().flat_map(Map::keys).find(unknown), None, "{path}");
        }
        // Every kind of joint has one.
        assert_eq!(job.kinds(&seamwright_document::steps("joint.preparation.u").unwrap()).len(), 16);
    }
}
