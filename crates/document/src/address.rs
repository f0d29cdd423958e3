//! From byte spans to key paths and back.

use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The path of the innermost key whose key or value covers the byte range `span`, like `tool[2].range_mm`.
pub(crate) fn path_at(text: &str, span: &Range<usize>) -> String {
    let mut path = String::new();
    if let Ok(table) = DeTable::parse(text) {
        descend_table(table.get_ref(), span, &mut path);
    }
    path
}

fn covers(outer: &Range<usize>, inner: &Range<usize>) -> bool {
    outer.start <= inner.start && inner.end <= outer.end
}

fn descend_table(table: &DeTable, span: &Range<usize>, path: &mut String) -> bool {
    for (key, value) in table {
        let before = path.len();
        if !path.is_empty() {
            path.push('.');
        }
        path.push_str(key.get_ref());
        if descend_value(value, span, path) || covers(&key.span(), span) {
            return true;
        }
        path.truncate(before);
    }
    false
}

fn descend_value(value: &Spanned<DeValue>, span: &Range<usize>, path: &mut String) -> bool {
    // A table given by several headers has the span of one of them only: look inside in any case.
    match value.get_ref() {
        DeValue::Table(table) => descend_table(table, span, path) || covers(&value.span(), span),
        DeValue::Array(items) => {
            let before = path.len();
            for (i, item) in items.iter().enumerate() {
                path.push_str(&format!("[{i}]"));
                if descend_value(item, span, path) {
                    return true;
                }
                path.truncate(before);
            }
            covers(&value.span(), span)
        }
        _ => covers(&value.span(), span),
    }
}

/// The byte range of the value at `path`, or of the nearest table above it that exists.
pub(crate) fn span_of(text: &str, path: &str) -> Range<usize> {
    nearest(text, path).0
}

/// True if there is a value at `path`.
pub(crate) fn contains(text: &str, path: &str) -> bool {
    nearest(text, path).1
}

/// The byte range of the value at `path` or of the nearest one above it, and whether it is the one at `path`.
fn nearest(text: &str, path: &str) -> (Range<usize>, bool) {
    let Ok(table) = DeTable::parse(text) else { return (0..0, false) };
    let mut here = Node::Table(table.get_ref());
    let mut span = 0..0;
    for part in path.split('.') {
        let (name, indices) = part.split_once('[').map_or((part, ""), |(n, i)| (n, i));
        let Node::Table(map) = here else { return (span, false) };
        let Some((_, value)) = map.iter().find(|(k, _)| k.get_ref() == name) else { return (span, false) };
        span = value.span();
        let mut value = value;
        for index in indices.split('[').filter_map(|i| i.trim_end_matches(']').parse::<usize>().ok()) {
            let DeValue::Array(items) = value.get_ref() else { return (span, false) };
            let Some(item) = items.get(index) else { return (span, false) };
            value = item;
            span = value.span();
        }
        here = match value.get_ref() {
            DeValue::Table(t) => Node::Table(t),
            _ => Node::Leaf,
        };
    }
    (span, true)
}

enum Node<'a> {
    Table(&'a DeTable<'a>),
    Leaf,
}
