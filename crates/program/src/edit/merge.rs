//! Changed values into a document, the rest left as it is written.

use super::format::{all_comments, comments, lines};
use toml::Value as New;
use toml_edit::{Array, InlineTable, Item, Table, TableLike, Value};

/// Puts what is different in `after` from `before` into `table`; keys that are the same keep layout, comments and
/// expressions.
pub(super) fn merge_table(table: &mut dyn TableLike, before: &toml::Table, after: &toml::Table) {
    for (key, new) in after {
        let old = before.get(key);
        if old == Some(new) {
            continue;
        }
        match table.get_mut(key) {
            Some(item) => merge_item(item, old, new),
            None => drop(table.insert(key, Item::Value(value(new)))),
        }
    }
    for key in before.keys().filter(|key| !after.contains_key(*key)) {
        let mut said = table.key(key).map(|key| comments(key.leaf_decor())).unwrap_or_default();
        said.extend(table.remove(key).map(|item| all_comments(&item)).unwrap_or_default());
        if !said.is_empty() {
            keep(table, &said);
        }
    }
}

/// Comments of a key that is gone above the first one that is there.
fn keep(table: &mut dyn TableLike, said: &[String]) {
    let first = table.iter().find(|(_, item)| item.is_value()).map(|(key, _)| key.to_owned());
    let Some(mut key) = first.as_deref().and_then(|key| table.key_mut(key)) else { return };
    let decor = key.leaf_decor_mut();
    let there = decor.prefix().and_then(|raw| raw.as_str()).unwrap_or_default().to_owned();
    decor.set_prefix(format!("{}{there}", lines(said, "")));
}

fn merge_item(item: &mut Item, old: Option<&New>, new: &New) {
    if let (Some(table), New::Table(new)) = (item.as_table_like_mut(), new) {
        let none = toml::Table::new();
        return merge_table(table, old.and_then(New::as_table).unwrap_or(&none), new);
    }
    match item {
        Item::Value(there) => merge_value(there, old, new),
        other => *other = Item::Value(value(new)),
    }
}

fn merge_value(there: &mut Value, old: Option<&New>, new: &New) {
    if old == Some(new) {
        return;
    }
    if let (Value::Array(items), Some(New::Array(old)), New::Array(new)) = (&mut *there, old, new)
        && items.len() == new.len()
        && old.len() == new.len()
    {
        items.iter_mut().zip(old.iter().zip(new)).for_each(|(item, (old, new))| merge_value(item, Some(old), new));
        return;
    }
    replace(there, value(new));
}

/// Another value in the same place.
pub(super) fn replace(there: &mut Value, mut new: Value) {
    *new.decor_mut() = there.decor().clone();
    *there = new;
}

/// A number as a person would write it.
pub(super) fn number(number: f64) -> Value {
    if number.fract() == 0.0 && number.abs() < 1e15 { Value::from(number as i64) } else { Value::from(number) }
}

fn value(new: &New) -> Value {
    match new {
        New::String(text) => Value::from(text.as_str()),
        New::Integer(i) => Value::from(*i),
        New::Float(v) => number(*v),
        New::Boolean(b) => Value::from(*b),
        New::Datetime(at) => Value::from(at.to_string()),
        New::Array(items) => Value::from(items.iter().map(value).collect::<Array>()),
        New::Table(table) => {
            Value::from(table.iter().map(|(key, new)| (key.as_str(), value(new))).collect::<InlineTable>())
        }
    }
}

/// A type's keys and values; empty for what is no table.
pub(super) fn table_of<T: serde::Serialize>(value: &T) -> toml::Table {
    toml::Table::try_from(value).unwrap_or_default()
}

/// The tables at `key` of `table` as an array of tables, whatever way they are written; an empty one if there are none.
pub(super) fn tables<'a>(table: &'a mut Table, key: &str) -> Option<&'a mut toml_edit::ArrayOfTables> {
    let item = table.entry(key).or_insert(Item::None);
    if !item.is_array_of_tables() {
        let taken = std::mem::take(item).into_array_of_tables();
        *item = Item::ArrayOfTables(taken.unwrap_or_default());
    }
    item.as_array_of_tables_mut()
}

/// The tables in a new order: each is a copy of the one at the place it came from, or a new one.
pub(super) fn rebuild(list: &mut toml_edit::ArrayOfTables, from: &[Option<usize>]) {
    if from.len() == list.len() && from.iter().enumerate().all(|(i, from)| *from == Some(i)) {
        return;
    }
    let old: Vec<Table> = list.iter().cloned().collect();
    let mut used = vec![false; old.len()];
    list.clear();
    for from in from {
        let mut table = from.and_then(|i| old.get(i)).cloned().unwrap_or_default();
        if let Some(i) = from
            && std::mem::replace(&mut used[*i], true)
        {
            // A second copy does not say the same once more.
            table.decor_mut().clear();
        }
        forget_positions(&mut table);
        list.push(table);
    }
}

/// Printed where it stands in its parent, not where it stood in the text.
pub(super) fn forget_positions(table: &mut Table) {
    table.set_position(None);
    for (_, item) in table.iter_mut() {
        match item {
            Item::Table(table) => forget_positions(table),
            Item::ArrayOfTables(list) => list.iter_mut().for_each(forget_positions),
            _ => {}
        }
    }
}
