//! The book's pages of all keys are made from the schemas, with an example for each key out of the supplied files.

use crate::common::{good, json, root};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use toml_edit::{DocumentMut, Item, TableLike};

/// File formats: name of the schema, title of the page, folder of files that show its keys.
const FORMATS: [(&str, &str, &str); 6] = [
    ("job", "All keys of job files", "examples"),
    ("machine", "All keys of machine files", "machines"),
    ("procedure", "All keys of procedure files", "examples/procedures"),
    ("program", "All keys of program files", "examples"),
    ("study", "All keys of study files", "examples/studies"),
    ("operation", "All edits of programs", ""),
];

/// Longer values are no examples that fit a table, characters.
const MAX_EXAMPLE: usize = 60;

/// The shortest value of each key of each type in the supplied files.
type Examples = BTreeMap<(String, String), String>;

fn property<'a>(schema: &'a Value, key: &str) -> Option<&'a Value> {
    schema.get("properties")?.get(key)
}

fn reference(schema: &Value) -> Option<&str> {
    schema.get("$ref")?.as_str()?.rsplit('/').next()
}

fn alternatives(schema: &Value) -> impl Iterator<Item = &Value> {
    ["oneOf", "anyOf", "allOf"].into_iter().filter_map(|k| schema.get(k)?.as_array()).flatten()
}

/// Collects the values of `item`, described by `schema` within type `owner`.
fn collect(root: &Value, schema: &Value, owner: &str, item: &Item, examples: &mut Examples) {
    if let Some(name) = reference(schema) {
        collect(root, &root["$defs"][name], name, item, examples);
    }
    for alternative in alternatives(schema) {
        collect(root, alternative, owner, item, examples);
    }
    if let Some(table) = item.as_table_like() {
        collect_table(root, schema, owner, table, examples);
    }
    let Some(items) = schema.get("items") else { return };
    if let Some(tables) = item.as_array_of_tables() {
        for table in tables {
            collect(root, items, owner, &Item::Table(table.clone()), examples);
        }
    }
    for value in item.as_array().into_iter().flatten() {
        collect(root, items, owner, &Item::Value(value.clone()), examples);
    }
}

fn collect_table(root: &Value, schema: &Value, owner: &str, table: &dyn TableLike, examples: &mut Examples) {
    for (key, item) in table.iter() {
        let Some(inner) = property(schema, key).or_else(|| schema.get("additionalProperties")) else { continue };
        if property(schema, key).is_some() && item.is_value() {
            let mut value = item.as_value().cloned().unwrap_or_else(|| false.into());
            value.decor_mut().clear();
            let text = value.to_string();
            let known = examples.entry((owner.to_owned(), key.to_owned())).or_insert_with(|| text.clone());
            if text.len() < known.len() {
                *known = text;
            }
        }
        collect(root, inner, owner, item, examples);
    }
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|e| e == "toml"));
    files.sort();
    files
}

/// Names the type of `schema`, with links to tables of this page.
fn kind(schema: &Value) -> String {
    if let Some(name) = reference(schema) {
        return format!("[{name}](#{})", name.to_lowercase());
    }
    if let Some(value) = schema.get("const") {
        return format!("`{value}`");
    }
    if let Some(values) = schema.get("enum").and_then(Value::as_array) {
        return values.iter().map(|v| format!("`{v}`")).collect::<Vec<_>>().join(", ");
    }
    if let Some(items) = schema.get("items") {
        return format!("list of {}", kind(items));
    }
    if let Some(inner) = schema.get("additionalProperties").filter(|inner| inner.is_object()) {
        return format!("table by name: {}", kind(inner));
    }
    let names: Vec<String> = alternatives(schema).map(kind).filter(|k| k != "null").collect();
    if !names.is_empty() {
        return names.join(" or ");
    }
    let named = match schema.get("type") {
        Some(Value::Array(types)) => {
            types.iter().filter_map(Value::as_str).filter(|t| *t != "null").collect::<Vec<_>>().join(" or ")
        }
        Some(Value::String(name)) => name.clone(),
        _ => return "any".to_owned(),
    };
    bounded(&named, schema)
}

fn bounded(named: &str, schema: &Value) -> String {
    let bound = |key: &str, sign: &str| schema.get(key).map(|value| format!(" {sign} {value}"));
    let bounds =
        [bound("exclusiveMinimum", ">"), bound("minimum", "≥"), bound("exclusiveMaximum", "<"), bound("maximum", "≤")];
    bounds.into_iter().flatten().fold(named.to_owned(), |text, bound| text + &bound)
}

fn cell(text: &str) -> String {
    text.replace('\n', " ").replace('|', "\\|")
}

fn description(schema: &Value) -> String {
    cell(schema.get("description").and_then(Value::as_str).unwrap_or(""))
}

/// Writes the keys of `schema`, type `owner`, as a table, or its alternatives as a list.
fn section(schema: &Value, owner: &str, examples: &Examples, text: &mut String) {
    if let Some(properties) = schema.get("properties").and_then(Value::as_object) {
        text.push_str("\n| key | type | default | meaning | example |\n|---|---|---|---|---|\n");
        let required = schema.get("required").and_then(Value::as_array);
        for (key, inner) in properties {
            let is_required = required.is_some_and(|keys| keys.iter().any(|k| k == key));
            let default = match inner.get("default") {
                Some(value) if value.to_string().len() <= MAX_EXAMPLE => format!("`{}`", cell(&value.to_string())),
                _ => if is_required { "required" } else { "" }.to_owned(),
            };
            let example = examples.get(&(owner.to_owned(), key.clone()));
            let example = example.filter(|value| value.len() <= MAX_EXAMPLE && !value.contains('\n'));
            let example = example.map_or(String::new(), |value| format!("`{key} = {}`", cell(value)));
            let _ = writeln!(text, "| `{key}` | {} | {default} | {} | {example} |", kind(inner), description(inner));
        }
    }
    if alternatives(schema).next().is_some() {
        text.push_str("\nOne of:\n\n");
        for alternative in alternatives(schema) {
            let keys = alternative.get("properties").and_then(Value::as_object);
            let of = keys.map_or_else(
                || kind(alternative),
                |keys| keys.iter().map(|(k, v)| format!("`{k}`: {}", kind(v))).collect::<Vec<_>>().join("; "),
            );
            let _ = writeln!(text, "- {of} – {}", description(alternative));
        }
    }
}

fn page(name: &str, title: &str, folder: &str) -> String {
    let schema: Value = serde_json::from_str(&good(&["schema", name])).unwrap();
    let mut examples = Examples::new();
    if !folder.is_empty() {
        for file in files(&root().join(folder)) {
            let document: DocumentMut = std::fs::read_to_string(&file).unwrap().parse().unwrap();
            collect(&schema, &schema, "", document.as_item(), &mut examples);
        }
    }
    let mut text = format!("# {title}\n\n{}\n\n", description(&schema));
    let _ = writeln!(
        text,
        "Made from the schema that `seamwright schema {name}` prints; examples are out of the supplied files."
    );
    section(&schema, "", &examples, &mut text);
    types(&schema["$defs"], &examples, &mut text);
    text
}

fn types(types: &Value, examples: &Examples, text: &mut String) {
    for (name, of) in types.as_object().into_iter().flatten() {
        let _ = write!(text, "\n## {name}\n");
        let described = description(of);
        if !described.is_empty() {
            let _ = write!(text, "\n{described}\n");
        }
        let before = text.len();
        section(of, name, examples, text);
        if text.len() == before {
            let _ = write!(text, "\nType: {}.\n", kind(of));
        }
    }
}

/// Names the content of a request's body or of an answer.
fn content(of: &Value) -> String {
    let Some((media, content)) = of["content"].as_object().and_then(|media| media.iter().next()) else {
        return "–".to_owned();
    };
    if media == "application/json" { kind(&content["schema"]) } else { format!("`{media}`") }
}

fn rest_page() -> String {
    let interface = json(&["schema", "rest"]);
    let mut text = "# Routes and types of the REST interface\n\nMade from the OpenAPI description that `seamwright schema rest` prints. Conventions, errors and the WebSocket:\n[REST and WebSocket](../rest-api.md).\n\n| route | permission | does | body | answer |\n|---|---|---|---|---|\n".to_owned();
    for (path, methods) in interface["paths"].as_object().unwrap() {
        for (method, operation) in methods.as_object().unwrap() {
            let (body, answer) = (content(&operation["requestBody"]), content(&operation["responses"]["2XX"]));
            let (method, action) = (method.to_uppercase(), operation["x-permission"].as_str().unwrap_or("–"));
            let about = cell(operation["summary"].as_str().unwrap());
            let _ = writeln!(text, "| `{method} {path}` | {action} | {about} | {body} | {answer} |");
        }
    }
    types(&interface["components"]["schemas"], &Examples::new(), &mut text);
    text
}

/// The pages of keys are those of the schemas; `SEAMWRIGHT_BLESS=1` writes them.
#[test]
fn the_reference_of_keys_is_current() {
    let folder = root().join("docs/reference/keys");
    let pages = FORMATS.map(|(name, title, examples)| (name, page(name, title, examples)));
    for (name, page) in pages.into_iter().chain([("rest", rest_page())]) {
        let path = folder.join(format!("{name}.md"));
        if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(&path, &page).unwrap();
        }
        let current = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(current == page, "docs/reference/keys/{name}.md: run this test with SEAMWRIGHT_BLESS=1");
    }
}
