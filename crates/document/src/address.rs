//! From byte spans to key paths and back.

use crate::key_path::{Step, steps, with_key};
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
        *path = with_key(path, key.get_ref());
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

pub(crate) fn contains(text: &str, path: &str) -> bool {
    nearest(text, path).1
}

/// The byte range of the value at `path` or of the nearest one above it, and whether it is the one at `path`.
fn nearest(text: &str, path: &str) -> (Range<usize>, bool) {
    let mut span = 0..0;
    let (Ok(root), Some(steps)) = (DeTable::parse(text), steps(path)) else { return (span, false) };
    let mut here: Option<&Spanned<DeValue>> = None;
    for step in &steps {
        let next = match (here.map(Spanned::get_ref), step) {
            (None, Step::Key(key)) => root.get_ref().get(key.as_str()),
            (Some(DeValue::Table(table)), Step::Key(key)) => table.get(key.as_str()),
            (Some(DeValue::Array(items)), Step::Nth(nth)) => items.get(*nth),
            _ => None,
        };
        let Some(value) = next else { return (span, false) };
        span = value.span();
        here = next;
    }
    (span, true)
}
