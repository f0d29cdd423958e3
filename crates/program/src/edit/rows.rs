//! Tables of points in a document: a line for each as a rule, with its comment behind it or above.

use super::draft::Row;
use super::merge::{number, replace};
use toml_edit::{Array, Value};

/// A point as it is written.
#[derive(Debug, Clone)]
struct Line {
    value: Value,
    /// Text before it, from the end of the line before.
    lead: String,
    /// Text behind its comma on its line.
    tail: String,
}

/// The points of a pass as they are written, and their numbers.
pub(super) struct Written {
    start: Line,
    lines: Vec<Line>,
    numbers: Vec<Vec<f64>>,
    /// For each column of the edited pass the one it was before.
    columns: Vec<Option<usize>>,
}

/// Rows of a document that follow each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct RowRun {
    pub(super) first: usize,
    pub(super) count: usize,
}

/// Text around the points of an array.
struct Around {
    opening: String,
    lead: String,
    ending: String,
}

impl Written {
    /// `numbers` are those of the points, the start first; `before` and `after` the names of the columns before and after
    /// the edit.
    pub(super) fn new(
        start: Option<&Value>,
        arrays: &[Option<Array>],
        numbers: Vec<Vec<f64>>,
        before: &[String],
        after: &[String],
    ) -> Self {
        let start = start.cloned().unwrap_or_else(|| Array::new().into());
        Self {
            start: Line { value: start, lead: String::new(), tail: String::new() },
            lines: arrays.iter().flatten().flat_map(lines).collect(),
            numbers,
            columns: after.iter().map(|name| before.iter().position(|c| c == name)).collect(),
        }
    }

    /// Whether these are the points `there` of the document.
    fn is_same(&self, rows: &[Row], there: RowRun) -> bool {
        let same = |(i, row): (usize, &Row)| {
            let old = there.first + i;
            row.from == Some(old) && row.numbers == self.numbers[old]
        };
        rows.len() == there.count && rows.iter().enumerate().all(same)
    }

    /// The start as it is to be written; `None` if it is unchanged.
    pub(super) fn start(&self, row: &Row) -> Option<Value> {
        if row.from == Some(0) && row.numbers == self.numbers[0] {
            return None;
        }
        let mut value = self.line(row).value;
        *value.decor_mut() = self.start.value.decor().clone();
        Some(value)
    }

    /// Points into their array, where they stood at `there` if they did.
    pub(super) fn write(&self, array: &mut Array, rows: &[Row], there: Option<RowRun>) {
        if there.is_some_and(|there| self.is_same(rows, there)) {
            return;
        }
        let around = around(array);
        let mut out = Array::new();
        *out.decor_mut() = array.decor().clone();
        let mut behind = around.opening;
        for row in rows {
            let Line { mut value, lead, tail } = self.line(row);
            let lead = match row.from {
                Some(1..) if !lead.is_empty() => lead,
                // On one line the first point has no space before it.
                _ if out.is_empty() && !around.lead.contains('\n') => String::new(),
                _ => around.lead.clone(),
            };
            value.decor_mut().set_prefix(joined(&behind, &lead));
            out.push_formatted(value);
            behind = tail;
        }
        out.set_trailing(joined(&behind, &around.ending));
        out.set_trailing_comma(array.trailing_comma() || array.is_empty());
        *array = out;
    }

    /// A point with its numbers, those that are as they were written so.
    fn line(&self, row: &Row) -> Line {
        let origin = row.from.filter(|i| *i < self.numbers.len());
        let old = match origin {
            Some(0) => Some(&self.start),
            Some(i) => self.lines.get(i - 1),
            None => None,
        };
        let items = old.and_then(|line| line.value.as_array());
        let mut array = items.cloned().unwrap_or_default();
        let whole = array.len() == row.numbers.len() && self.columns.iter().enumerate().all(|(i, c)| *c == Some(i));
        if !whole {
            array.clear();
        }
        for (i, new) in row.numbers.iter().enumerate() {
            let column = self.columns.get(i).copied().flatten();
            let same = origin.zip(column).is_some_and(|(o, c)| self.numbers[o].get(c) == Some(new));
            match (array.get_mut(i), same) {
                (Some(_), true) => {}
                (Some(there), false) => replace(there, number(*new)),
                (None, _) => {
                    let kept = items.filter(|_| same).and_then(|items| items.get(column.unwrap_or(i))).cloned();
                    array.push(kept.unwrap_or_else(|| number(*new)));
                }
            }
        }
        let suffix = old.map(|line| line.value.decor().suffix().cloned().unwrap_or_default());
        let mut value = Value::Array(array);
        if let Some(suffix) = suffix.filter(|_| origin != Some(0)) {
            value.decor_mut().set_suffix(suffix);
        } else {
            value.decor_mut().set_suffix("");
        }
        let (lead, tail) = old.map_or_else(Default::default, |line| (line.lead.clone(), line.tail.clone()));
        Line { value, lead, tail }
    }
}

/// Joins the end of a line and the start of the next; a comment ends with its line.
fn joined(tail: &str, lead: &str) -> String {
    let needs = tail.contains('#') && !lead.starts_with(['\n', '\r']);
    format!("{tail}{}{lead}", if needs { "\n" } else { "" })
}

/// Splits the text at the end of its first line.
fn at_line_end(text: &str) -> (&str, &str) {
    match text.find('\n') {
        Some(i) => text.split_at(if text[..i].ends_with('\r') { i - 1 } else { i }),
        None => ("", text),
    }
}

fn prefix(value: &Value) -> &str {
    value.decor().prefix().and_then(|raw| raw.as_str()).unwrap_or_default()
}

fn suffix(value: &Value) -> &str {
    value.decor().suffix().and_then(|raw| raw.as_str()).unwrap_or_default()
}

/// Text behind the last value, its comma included or not.
fn ending(array: &Array) -> String {
    let last = array.iter().last().filter(|_| !array.trailing_comma()).map_or("", suffix);
    format!("{last}{}", array.trailing().as_str().unwrap_or_default())
}

fn lines(array: &Array) -> Vec<Line> {
    let end = ending(array);
    let values: Vec<&Value> = array.iter().collect();
    let line = |(i, value): (usize, &&Value)| {
        let next = values.get(i + 1).map_or(end.as_str(), |next| prefix(next));
        let mut kept = (*value).clone();
        if i + 1 == values.len() && !array.trailing_comma() {
            kept.decor_mut().set_suffix("");
        }
        Line { value: kept, lead: at_line_end(prefix(value)).1.to_owned(), tail: at_line_end(next).0.to_owned() }
    };
    values.iter().enumerate().map(line).collect()
}

fn around(array: &Array) -> Around {
    let first = array.iter().next().map_or("", prefix);
    let (opening, lead) = at_line_end(first);
    let end = ending(array);
    let plain = |text: &str| text.rfind('\n').map_or_else(|| text.to_owned(), |i| text[i..].to_owned());
    if array.is_empty() {
        return Around { opening: String::new(), lead: "\n    ".to_owned(), ending: "\n".to_owned() };
    }
    // In an array on one line the first point has no space before it, the others have.
    let lead = if lead.contains('\n') { plain(lead) } else { array.get(1).map_or(" ", prefix).to_owned() };
    Around { opening: opening.to_owned(), lead, ending: at_line_end(&end).1.to_owned() }
}
