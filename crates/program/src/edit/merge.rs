//! Changed values into a document, the rest left as it is written.

use super::format::{all_comments, comments, lines};
use toml::Value as New;
use toml_edit::{Array, ArrayOfTables, InlineTable, Item, Table, TableLike, Value};

/// Writes the differences of `after` from `before` into `table`; unchanged keys keep layout, comments and expressions.
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
    before.keys().filter(|key| !after.contains_key(*key)).for_each(|key| take_out(table, key));
}

/// Removes a key if it is there; its comments stay.
pub(super) fn take_out(table: &mut dyn TableLike, key: &str) {
    let mut said = table.key(key).map(|key| comments(key.leaf_decor())).unwrap_or_default();
    said.extend(table.remove(key).map(|item| all_comments(&item)).unwrap_or_default());
    if !said.is_empty() {
        keep(table, &said);
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
        return merge_table(table, old.and_then(New::as_table).unwrap_or(&toml::Table::new()), new);
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
    if let (Value::InlineTable(table), Some(New::Table(old)), New::Table(new)) = (&mut *there, old, new) {
        return merge_table(table, old, new);
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

/// A type's keys and values; empty for types that are no table.
pub(super) fn table_of<T: serde::Serialize>(value: &T) -> toml::Table {
    seamwright_document::to_table(value).unwrap_or_default()
}

/// The tables at `key` of `table` as an array of tables, in any notation; empty if the key is missing.
pub(super) fn tables<'a>(table: &'a mut Table, key: &str) -> Option<&'a mut ArrayOfTables> {
    if !table.get(key).is_some_and(Item::is_array_of_tables) {
        let mut said = table.key(key).map(|key| comments(key.leaf_decor())).unwrap_or_default();
        let item = table.entry(key).or_insert(Item::None);
        let old = std::mem::take(item);
        said.extend(all_comments(&old));
        *item = Item::ArrayOfTables(old.into_array_of_tables().unwrap_or_default());
        if let Some(mut key) = table.key_mut(key) {
            key.leaf_decor_mut().clear();
        }
        if !said.is_empty() {
            keep(table, &said);
        }
    }
    table.get_mut(key).and_then(Item::as_array_of_tables_mut)
}

/// Passes each of the tables at `key` of `table` to `edit` with its index, in the order `from`: each is the one of that
/// original index, or a new one. Tables on one line stay so if their order does.
pub(super) fn each_table(
    table: &mut Table,
    key: &str,
    from: &[Option<usize>],
    mut edit: impl FnMut(usize, &mut dyn TableLike),
) {
    let in_order = from.iter().enumerate().all(|(i, from)| *from == Some(i));
    if let Some(array) = table.get_mut(key).and_then(Item::as_array_mut).filter(|a| in_order && a.len() == from.len()) {
        let inline = array.iter_mut().filter_map(Value::as_inline_table_mut);
        return inline.enumerate().for_each(|(i, table)| edit(i, table));
    }
    let Some(list) = tables(table, key) else { return };
    rebuild(list, from);
    list.iter_mut().enumerate().for_each(|(i, table)| edit(i, table));
}

/// The tables in a new order: each is a copy of the one of its original index, or a new one.
pub(super) fn rebuild(list: &mut ArrayOfTables, from: &[Option<usize>]) {
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
            // A second copy does not repeat the comments.
            table.decor_mut().clear();
        }
        forget_positions(&mut table);
        list.push(table);
    }
}

/// Printed at its position in the parent, not at that in the old text.
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
