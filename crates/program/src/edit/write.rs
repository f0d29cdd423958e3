//! A draft into the text of its document.

use super::draft::{Body, Draft, EventDraft, PassDraft, PointsDraft, SeamSpan};
use super::merge::{each_table, forget_positions, merge_table, rebuild, table_of, tables};
use super::rows::Written;
use super::speeds::{WrittenSpeeds, row_runs};
use crate::pass::Pass;
use crate::points::Points;
use crate::program::Program;
use seamwright_document::DocumentError;
use toml_edit::{Array, DocumentMut, Item, Table, TomlError, Value};

pub(super) fn write(text: &str, draft: &Draft) -> Result<String, DocumentError> {
    let unwritable = |e: TomlError| draft.file.error_at("", e.message().to_owned(), "");
    let mut document: DocumentMut = text.parse().map_err(unwritable)?;
    let before = &draft.file.value;
    let head = Program { passes: Vec::new(), ..before.clone() };
    let has_variables = document.contains_key("variables");
    merge_table(document.as_table_mut(), &table_of(&head), &table_of(&draft.head));
    if !has_variables {
        variables_first(&mut document);
    }
    if let Some(list) = tables(document.as_table_mut(), "passes") {
        let from: Vec<Option<usize>> = draft.passes.iter().map(|pass| pass.from).collect();
        rebuild(list, &from);
        for (table, pass) in list.iter_mut().zip(&draft.passes) {
            match pass.from {
                Some(i) => write_pass(table, &before.passes[i], pass),
                None => *table = new_pass(draft, pass).map_err(unwritable)?,
            }
        }
    }
    Ok(document.to_string())
}

/// Puts a new table of variables before the other tables.
fn variables_first(document: &mut DocumentMut) {
    let Some(item) = document.get_mut("variables") else { return };
    if let Ok(mut table) = std::mem::take(item).into_table() {
        table.set_position(Some(0));
        *item = Item::Table(table);
    }
}

/// A pass as a new program would have it.
fn new_pass(draft: &Draft, pass: &PassDraft) -> Result<Table, TomlError> {
    let program = Program { passes: pass.pass().into_iter().collect(), ..draft.head.clone() };
    let mut document: DocumentMut = program.to_toml().unwrap_or_default().parse()?;
    let mut table = tables(document.as_table_mut(), "passes").and_then(|list| list.get(0).cloned()).unwrap_or_default();
    forget_positions(&mut table);
    Ok(table)
}

/// Without points and spans.
fn bare(pass: &Pass) -> toml::Table {
    table_of(&Pass { points: None, spans: Vec::new(), ..pass.clone() })
}

fn write_pass(table: &mut Table, before: &Pass, after: &PassDraft) {
    merge_table(table, &bare(before), &table_of(&after.pass));
    match (&after.body, &before.points) {
        (Body::Seam(spans), _) => write_spans(table, before, spans),
        (Body::Points(points), Some(before)) => {
            if let Some(item) = table.get_mut("points") {
                if !item.is_table() {
                    *item = Item::Table(std::mem::take(item).into_table().unwrap_or_default());
                }
                if let Some(table) = item.as_table_mut() {
                    write_points(table, before, points);
                }
            }
        }
        // A pass does not change from points to a seam.
        (Body::Points(_), None) => {}
    }
}

fn write_spans(table: &mut Table, before: &Pass, spans: &[SeamSpan]) {
    let is_same = spans.len() == before.spans.len()
        && spans.iter().enumerate().all(|(i, s)| s.from == Some(i) && s.span == before.spans[i]);
    if is_same {
        return;
    }
    let from: Vec<Option<usize>> = spans.iter().map(|span| span.from).collect();
    each_table(table, "spans", &from, |i, table| {
        let before = from[i].map(|i| table_of(&before.spans[i])).unwrap_or_default();
        merge_table(table, &before, &table_of(&spans[i].span));
    });
}

/// Keys of a pass' points but for the points themselves and the events.
fn head(points: &Points) -> toml::Table {
    let mut table = table_of(&Points { start: Vec::new(), events: Vec::new(), spans: Vec::new(), ..points.clone() });
    table.remove("start");
    table.remove("spans");
    table
}

fn write_points(table: &mut Table, before: &Points, after: &PointsDraft) {
    merge_table(table, &head(before), &head(&after.head()));
    write_events(table, before, &after.events);
    let (arrays, of_speeds) = (arrays(table, "points"), arrays(table, "speeds"));
    let numbers = before.rows().map(|row| row.iter().map(|n| n.get()).collect()).collect();
    let start = table.get("start").and_then(Item::as_value);
    let written = Written::new(start, &arrays, numbers, &before.columns, &after.columns);
    if let (Some(new), Some(item)) = (written.start(&after.start), table.get_mut("start")) {
        *item = Item::Value(new);
    }
    write_rows(table, before, after, &written, WrittenSpeeds::new(before, after, &of_speeds));
}

/// The arrays at `key` of each span as they are written.
fn arrays(table: &Table, key: &str) -> Vec<Option<Array>> {
    let array = |item: Option<&Item>| item.and_then(Item::as_array).cloned();
    match table.get("spans") {
        Some(Item::ArrayOfTables(list)) => list.iter().map(|table| array(table.get(key))).collect(),
        Some(Item::Value(Value::Array(list))) => {
            let there = |value: &Value| value.as_inline_table()?.get(key)?.as_array().cloned();
            list.iter().map(there).collect()
        }
        _ => Vec::new(),
    }
}

fn write_rows(table: &mut Table, before: &Points, after: &PointsDraft, written: &Written, mut speeds: WrittenSpeeds) {
    let runs = row_runs(before.spans.iter().map(|span| span.points.len()));
    let head = |head: Option<toml::Table>| {
        let mut head = head.unwrap_or_default();
        head.remove("points");
        head.remove("speeds");
        head
    };
    let from: Vec<Option<usize>> = after.spans.iter().map(|span| span.from).collect();
    each_table(table, "spans", &from, |i, table| {
        let old = head(from[i].map(|i| table_of(&before.spans[i])));
        merge_table(table, &old, &head(after.spans[i].head().map(|head| table_of(&head))));
        speeds.write(table, after, i);
        let points = table.entry("points").or_insert_with(|| Item::Value(Array::new().into()));
        if let Some(array) = points.as_array_mut() {
            written.write(array, &after.spans[i].rows, from[i].map(|i| runs[i]));
        }
    });
}

fn write_events(table: &mut Table, before: &Points, events: &[EventDraft]) {
    let is_same = events.len() == before.events.len()
        && events.iter().enumerate().all(|(i, e)| e.from == Some(i) && e.event == before.events[i]);
    if is_same {
        return;
    }
    if events.is_empty() {
        table.remove("events");
        return;
    }
    let from: Vec<Option<usize>> = events.iter().map(|event| event.from).collect();
    each_table(table, "events", &from, |i, table| {
        let before = from[i].map(|i| table_of(&before.events[i])).unwrap_or_default();
        merge_table(table, &before, &table_of(&events[i].event));
    });
}
