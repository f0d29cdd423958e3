//! The usual order and layout, with the comments and expressions of the document.

use super::merge::replace;
use crate::program::Program;
use crate::variables::is_expression;
use seamwright_document::{Document, DocumentError};
use toml_edit::{Array, Decor, DocumentMut, Item, Table, TableLike, TomlError, Value};

/// The program as `to_toml` writes it, with the comments and expressions of `text`.
pub(super) fn formatted(text: &str, program: &Document<Program>) -> Result<String, DocumentError> {
    let unwritable = |e: TomlError| program.error_at("", e.message().to_owned(), "");
    let usual = program.value.to_toml().unwrap_or_default();
    let mut old: DocumentMut = text.parse().map_err(unwritable)?;
    let mut new: DocumentMut = usual.parse().map_err(unwritable)?;
    // The head of the file stays there, even if another key comes first now.
    let mut head = take_top(&mut old);
    if head.is_empty() {
        head.extend(usual.lines().next().map(str::to_owned));
    }
    let first = new.iter().next().map(|(key, _)| key.to_owned()).unwrap_or_default();
    if let Some(mut key) = new.key_mut(&first) {
        key.leaf_decor_mut().clear();
    }
    let left = dress(new.as_table_mut(), old.as_table());
    if let Some(mut key) = new.key_mut(&first) {
        head.extend(comments(key.leaf_decor()));
        head.extend(left);
        key.leaf_decor_mut().set_prefix(lines(&head, ""));
    }
    let end = text_comments(old.trailing().as_str().unwrap_or_default());
    new.set_trailing(if end.is_empty() { String::new() } else { format!("\n{}", lines(&end, "")) });
    Ok(new.to_string())
}

/// Takes the comments from above the first key or header.
fn take_top(old: &mut DocumentMut) -> Vec<String> {
    let Some(first) = old.iter().next().map(|(key, _)| key.to_owned()) else { return Vec::new() };
    let mut taken = Vec::new();
    let mut take = |decor: &mut Decor| {
        taken.extend(comments(decor));
        decor.set_prefix("");
    };
    match old.get_mut(&first) {
        Some(Item::Table(table)) => take(table.decor_mut()),
        Some(Item::ArrayOfTables(list)) => drop(list.get_mut(0).map(|table| take(table.decor_mut()))),
        _ => drop(old.key_mut(&first).map(|mut key| take(key.leaf_decor_mut()))),
    }
    taken
}

/// Copies comments and expressions of `old` into `new`; returns the comments that have no key in `new`.
fn dress(new: &mut Table, old: &dyn TableLike) -> Vec<String> {
    let mut left = Vec::new();
    for (key, item) in old.iter() {
        if !new.contains_key(key) {
            left.extend(old.key(key).map(|key| comments(key.leaf_decor())).unwrap_or_default());
            left.extend(all_comments(item));
        }
    }
    let keys: Vec<String> = new.iter().map(|(key, _)| key.to_owned()).collect();
    for key in keys {
        let Some(there) = old.get(&key) else { continue };
        let mut above = old.key(&key).map(|key| comments(key.leaf_decor())).unwrap_or_default();
        match new.get_mut(&key) {
            Some(Item::Table(table)) => match there.as_table_like() {
                Some(like) => {
                    above.extend(decor_of(there).map(comments).unwrap_or_default());
                    let behind = decor_of(there).map(behind).unwrap_or_default();
                    above.extend(dress(table, like));
                    set_above(table.decor_mut(), &above);
                    table.decor_mut().set_suffix(behind);
                }
                None => left.extend(all_comments(there)),
            },
            Some(Item::ArrayOfTables(list)) => dress_list(list, there, above),
            Some(Item::Value(value)) => {
                above.extend(dress_value(value, there));
                if let Some(mut key) = new.key_mut(&key) {
                    key.leaf_decor_mut().set_prefix(lines(&above, ""));
                }
            }
            _ => {}
        }
    }
    left
}

fn dress_list(list: &mut toml_edit::ArrayOfTables, there: &Item, mut above: Vec<String>) {
    if there.is_value() {
        above.extend(all_comments(there));
    }
    let Ok(old) = there.clone().into_array_of_tables() else { return };
    for (table, old) in list.iter_mut().zip(old.iter()) {
        if !there.is_value() {
            above.extend(comments(old.decor()));
            table.decor_mut().set_suffix(behind(old.decor()));
        }
        above.extend(dress(table, old));
        set_above(table.decor_mut(), &above);
        above.clear();
    }
}

/// The same for a value; returns the comments that go above its key.
fn dress_value(new: &mut Value, there: &Item) -> Vec<String> {
    let Some(old) = there.as_value() else { return all_comments(there) };
    new.decor_mut().set_suffix(behind(old.decor()));
    match (&mut *new, old) {
        (Value::Array(new), Value::Array(old)) if is_table_of_points(new) => dress_rows(new, old),
        (Value::Array(new), Value::Array(old)) => {
            new.iter_mut().zip(old.iter()).for_each(|(new, old)| express(new, old));
            let mut inside = Vec::new();
            old.iter().for_each(|value| value_comments(value, &mut inside));
            inside.extend(text_comments(old.trailing().as_str().unwrap_or_default()));
            inside
        }
        (new, old) => {
            express(new, old);
            Vec::new()
        }
    }
}

/// Replaces numbers in `new` by their expressions in `old`.
fn express(new: &mut Value, old: &Value) {
    match (&mut *new, old) {
        (Value::Array(new), Value::Array(old)) => {
            new.iter_mut().zip(old.iter()).for_each(|(new, old)| express(new, old));
        }
        (Value::InlineTable(new), Value::InlineTable(old)) => {
            for (key, value) in new.iter_mut() {
                if let Some(old) = old.get(key.get()) {
                    express(value, old);
                }
            }
        }
        (Value::Integer(_) | Value::Float(_), Value::String(text)) if is_expression(text.value()) => {
            replace(new, Value::from(text.value().as_str()));
        }
        _ => {}
    }
}

fn is_table_of_points(array: &Array) -> bool {
    array.iter().next().is_some_and(Value::is_array)
}

/// A line a point, comments above and behind; returns the comments before the first line, which go above the key.
fn dress_rows(new: &mut Array, old: &Array) -> Vec<String> {
    let split = |text: &str| {
        let (first, rest) = text.split_once('\n').unwrap_or(("", text));
        (text_comments(first), text_comments(rest))
    };
    let raw = |decor: Option<&toml_edit::RawString>| decor.and_then(|raw| raw.as_str()).unwrap_or_default().to_owned();
    let before: Vec<String> = old.iter().map(|value| raw(value.decor().prefix())).collect();
    let after: Vec<String> = old.iter().map(|value| raw(value.decor().suffix())).collect();
    let last = after.last().filter(|_| !old.trailing_comma()).map_or("", String::as_str);
    let end = format!("{last}{}", old.trailing().as_str().unwrap_or_default());
    let mut tail = Vec::new();
    let opening = before.first().map(|text| split(text).0).unwrap_or_default();
    for (i, (value, old)) in new.iter_mut().zip(old.iter()).enumerate() {
        express(value, old);
        let mut above = split(&before[i]).1;
        if i + 1 < before.len() {
            above.extend(text_comments(&after[i]));
        }
        value.decor_mut().set_prefix(format!("{}\n{}    ", behind_text(&tail), lines(&above, "    ")));
        value.decor_mut().set_suffix("");
        tail = split(before.get(i + 1).unwrap_or(&end)).0;
    }
    new.set_trailing(format!("{}\n{}", behind_text(&tail), lines(&split(&end).1, "    ")));
    opening
}

fn behind_text(comments: &[String]) -> String {
    if comments.is_empty() { String::new() } else { format!(" {}", comments.join(" ")) }
}

/// Comments of a text between values, each from its `#` on.
fn text_comments(text: &str) -> Vec<String> {
    text.lines().filter_map(|line| line.find('#').map(|i| line[i..].trim_end().to_owned())).collect()
}

/// Comments above a key or header.
pub(super) fn comments(decor: &Decor) -> Vec<String> {
    text_comments(decor.prefix().and_then(|raw| raw.as_str()).unwrap_or_default())
}

/// The comment behind a value or header, as it is to be written.
fn behind(decor: &Decor) -> String {
    behind_text(&text_comments(decor.suffix().and_then(|raw| raw.as_str()).unwrap_or_default()))
}

fn decor_of(item: &Item) -> Option<&Decor> {
    match item {
        Item::Table(table) => Some(table.decor()),
        Item::Value(value) => Some(value.decor()),
        _ => None,
    }
}

fn set_above(decor: &mut Decor, above: &[String]) {
    let blank = decor.prefix().and_then(|raw| raw.as_str()).is_none_or(|text| text.starts_with('\n'));
    decor.set_prefix(format!("{}{}", if blank { "\n" } else { "" }, lines(above, "")));
}

/// A line each.
pub(super) fn lines(comments: &[String], indent: &str) -> String {
    comments.iter().map(|comment| format!("{indent}{comment}\n")).collect()
}

pub(super) fn all_comments(item: &Item) -> Vec<String> {
    let mut out = Vec::new();
    match item {
        Item::Value(value) => value_comments(value, &mut out),
        Item::Table(table) => table_comments(table, &mut out),
        Item::ArrayOfTables(list) => list.iter().for_each(|table| table_comments(table, &mut out)),
        Item::None => {}
    }
    out
}

fn table_comments(table: &Table, out: &mut Vec<String>) {
    out.extend(comments(table.decor()));
    out.extend(text_comments(&behind(table.decor())));
    for (key, item) in table {
        out.extend(table.key(key).map(|key| comments(key.leaf_decor())).unwrap_or_default());
        out.extend(all_comments(item));
    }
}

fn value_comments(value: &Value, out: &mut Vec<String>) {
    out.extend(comments(value.decor()));
    match value {
        Value::Array(array) => {
            array.iter().for_each(|value| value_comments(value, out));
            out.extend(text_comments(array.trailing().as_str().unwrap_or_default()));
        }
        Value::InlineTable(table) => {
            for (key, value) in table {
                out.extend(table.key(key).map(|key| comments(key.leaf_decor())).unwrap_or_default());
                value_comments(value, out);
            }
        }
        _ => {}
    }
    out.extend(text_comments(&behind(value.decor())));
}
