//! The entries of a text in the order in which they stand there, as a form shows them.

use crate::document::explain;
use crate::error::DocumentError;
use crate::key_path::with_key;
use crate::nesting::check_nesting;
use std::ops::Range;
use toml_edit::{Document, InlineTable, Item, Table, TableLike, TomlError, Value};

/// The keys that stand under one header, at the root, or before a dot in common.
#[derive(Debug, Clone, PartialEq)]
pub struct TableEntries {
    /// Path of the table, like `passes[0].points`; empty for the root.
    pub path: String,
    /// Keys of tables within it that are given elsewhere.
    pub tables: Vec<String>,
    /// Its values.
    pub entries: Vec<Entry>,
}

/// A key with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// Its path.
    pub path: String,
    /// The value.
    pub value: EntryValue,
    /// Line of the value, from 1.
    pub line: usize,
    /// Comment behind the value.
    pub comment: String,
}

/// A value.
#[derive(Debug, Clone, PartialEq)]
pub enum EntryValue {
    /// A finite number.
    Number(f64),
    /// A text, or the written form of what is no other kind.
    Text(String),
    /// True or false.
    Truth(bool),
    /// A list.
    List(Vec<EntryValue>),
    /// An inline table.
    Table(Vec<Entry>),
}

/// A text in TOML of any format, parsed once to be read and changed.
#[derive(Debug, Clone)]
pub struct TomlText {
    pub(crate) text: String,
    pub(crate) root: Table,
}

impl TomlText {
    /// Parses `text`, called `file` in errors.
    ///
    /// # Errors
    /// Wrong syntax, with its line.
    pub fn parse(file: &str, text: &str) -> Result<Self, DocumentError> {
        check_nesting(file, text)?;
        let document = Document::parse(text).map_err(|e: TomlError| explain(file, text, e.span(), e.message()))?;
        Ok(Self { text: text.to_owned(), root: document.into_table() })
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns its tables with their entries, in the order of the text.
    pub fn entries(&self) -> Vec<TableEntries> {
        let mut reader = Reader { text: &self.text, lines: line_starts(&self.text), found: Vec::new() };
        reader.table(&self.root, "", 0);
        reader.found.sort_by_key(|(at, _)| *at);
        reader.found.into_iter().map(|(_, table)| table).collect()
    }
}

/// The header of a table; none for those that only others' keys mention.
pub(crate) fn header(table: &Table) -> Option<Range<usize>> {
    table.span().filter(|span| !span.is_empty() && !table.is_implicit())
}

fn line_starts(text: &str) -> Vec<usize> {
    std::iter::once(0).chain(text.match_indices('\n').map(|(i, _)| i + 1)).collect()
}

struct Reader<'t> {
    text: &'t str,
    lines: Vec<usize>,
    /// Tables with their places in the text.
    found: Vec<(usize, TableEntries)>,
}

impl Reader<'_> {
    /// Adds a table and those within it; `above`: place of the header above, for tables without one.
    fn table(&mut self, table: &Table, path: &str, above: usize) {
        let header = header(table);
        let at = header.as_ref().map_or(above, |span| span.start);
        let mut own = TableEntries { path: path.to_owned(), tables: Vec::new(), entries: Vec::new() };
        for (key, item) in table.iter() {
            if let Item::Value(value) = item {
                own.entries.push(self.entry(key, &with_key(path, key), value));
            } else {
                own.tables.push(key.to_owned());
            }
        }
        if header.is_some() || path.is_empty() || !own.entries.is_empty() {
            self.found.push((at, own));
        }
        for (key, item) in table.iter() {
            let path = with_key(path, key);
            match item {
                Item::Table(inner) => self.table(inner, &path, at),
                Item::ArrayOfTables(list) => {
                    for (i, inner) in list.iter().enumerate() {
                        self.table(inner, &format!("{path}[{i}]"), at);
                    }
                }
                Item::Value(_) | Item::None => {}
            }
        }
    }

    fn entry(&self, key: &str, path: &str, value: &Value) -> Entry {
        let span = value.span().unwrap_or(0..0);
        let line = self.lines.partition_point(|start| *start <= span.start);
        let rest = self.text[span.end..].lines().next().unwrap_or_default();
        let comment = rest.trim_start().strip_prefix('#').unwrap_or_default().trim().to_owned();
        Entry { key: key.to_owned(), path: path.to_owned(), value: self.value(path, value), line, comment }
    }

    fn value(&self, path: &str, value: &Value) -> EntryValue {
        let number = |number: f64| number.is_finite().then_some(EntryValue::Number(number));
        let plain = match value {
            Value::Integer(n) => number(*n.value() as f64),
            Value::Float(n) => number(*n.value()),
            Value::Boolean(truth) => Some(EntryValue::Truth(*truth.value())),
            Value::String(text) => Some(EntryValue::Text(text.value().clone())),
            Value::Array(list) => {
                let item = |(i, item)| self.value(&format!("{path}[{i}]"), item);
                Some(EntryValue::List(list.iter().enumerate().map(item).collect()))
            }
            Value::InlineTable(table) => Some(EntryValue::Table(self.inline(path, table))),
            Value::Datetime(_) => None,
        };
        plain.unwrap_or_else(|| EntryValue::Text(self.text[value.span().unwrap_or(0..0)].to_owned()))
    }

    /// Entries of an inline table; a dotted key is a table within.
    fn inline(&self, path: &str, table: &InlineTable) -> Vec<Entry> {
        let values = TableLike::iter(table).filter_map(|(key, item)| Some((key, item.as_value()?)));
        values.map(|(key, value)| self.entry(key, &with_key(path, key), value)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_values_lines_and_comments_are_found() {
        let text = "a = 1 # one\n[t.u]\nb = \"x\\\"y\"\n[[p]]\nc = [1,\n 2] # two\n[[p.s]]\nd = true\n[[p]]\nf.g = 3\n[[p.s]]\n\
                    e = { f = -1.5e2 }\n";
        let tables = TomlText::parse("x.toml", text).unwrap().entries();
        let rows: Vec<_> = tables
            .iter()
            .flat_map(|table| table.entries.iter().map(|e| (e.path.as_str(), e.line, e.comment.as_str())))
            .collect();
        let expected = [
            ("a", 1, "one"),
            ("t.u.b", 3, ""),
            ("p[0].c", 5, "two"),
            ("p[0].s[0].d", 8, ""),
            ("p[1].f.g", 10, ""),
            ("p[1].s[0].e", 12, ""),
        ];
        assert_eq!(rows, expected);
        assert_eq!(tables[1].entries[0].value, EntryValue::Text("x\"y".to_owned()));
        let EntryValue::Table(inner) = &tables.last().unwrap().entries[0].value else { panic!() };
        assert_eq!((inner[0].path.as_str(), &inner[0].value), ("p[1].s[0].e.f", &EntryValue::Number(-150.0)));
    }

    #[test]
    fn wrong_syntax_has_its_line() {
        let error = TomlText::parse("x.toml", "a = 1\nb = [1, \n").unwrap_err();
        assert!(error.line >= 2 && !error.message.is_empty(), "{error}");
    }
}
