//! The form of a text: its entries, with what the format's JSON Schema says of them and allows beside them.

mod points;
mod schema;

use crate::document_kind::{Kind, kind_of};
use crate::limits::MAX_FORM_TABLES;
use crate::planner::{JOB, wrong_view};
use crate::wire::{FormAnswer, FormChange, FormEntry, FormTable, FormText, FormValue, FormView};
use schema::{Place, Schema};
use seamwright_document::{Change, DocumentError, Entry, EntryValue, Step, TableEntries, TomlText, path_of, steps};
use seamwright_machine::MachineFile;
use seamwright_message::Message;
use seamwright_program::{Procedure, Program};
use seamwright_weld::Job;
use serde_json::Value;
use std::sync::LazyLock;

/// Longest list that a form shows element by element.
const MAX_ITEMS: usize = 6;

/// A format of files: its schema, and the reader that judges a text.
struct Format {
    schema: Schema,
    fault: fn(&str) -> Option<DocumentError>,
}

impl Format {
    fn new<T: schemars::JsonSchema>(fault: fn(&str) -> Option<DocumentError>) -> Self {
        Self { schema: Schema::new(schemars::schema_for!(T).to_value()), fault }
    }
}

static JOBS: LazyLock<Format> = LazyLock::new(|| Format::new::<Job>(|text| Job::read(JOB, text).err()));
static PROGRAMS: LazyLock<Format> = LazyLock::new(|| Format::new::<Program>(|text| Program::read(JOB, text).err()));
static PROCEDURES: LazyLock<Format> =
    LazyLock::new(|| Format::new::<Procedure>(|text| Procedure::read(JOB, text).err()));
// A machine refers to other files; it is judged when it is saved or used.
static MACHINES: LazyLock<Format> = LazyLock::new(|| Format::new::<MachineFile>(|_| None));

fn format_of(tables: &[TableEntries]) -> &'static Format {
    match kind_of(|key| tables.iter().any(|table| table.path.is_empty() && has_key(table, key))) {
        Kind::Program => &PROGRAMS,
        Kind::Procedure => &PROCEDURES,
        Kind::Machine => &MACHINES,
        Kind::Job => &JOBS,
    }
}

fn has_key(table: &TableEntries, key: &str) -> bool {
    table.tables.iter().any(|of| of == key) || table.entries.iter().any(|of| of.key == key)
}

/// Makes the changes of a form in its text, and reads the form of the result.
///
/// # Errors
/// An invalid change: a path that the text lacks, or a value that does not fit there.
pub(crate) fn answer(form: FormText) -> Result<FormAnswer, DocumentError> {
    answered(form, format_of)
}

/// Finds the format of a text.
type FormatOf = fn(&[TableEntries]) -> &'static Format;

fn answered(form: FormText, format_of: FormatOf) -> Result<FormAnswer, DocumentError> {
    let mut text = match TomlText::parse(JOB, &form.text) {
        Err(error) if form.changes.is_empty() => {
            return Ok(FormAnswer { text: form.text, form: None, wrong: Some(wrong_view(&error)) });
        }
        parsed => parsed?,
    };
    let mut tables = text.entries();
    for change in form.changes {
        text = text.changed(JOB, &expanded(&tables, change, format_of)?)?;
        tables = text.entries();
    }
    let format = format_of(&tables);
    let views = tables.iter().filter_map(|table| Some(table_view(&format.schema, table, &steps(&table.path)?)));
    let mut counts = [0; 2];
    let shown = |view: &FormTable| {
        let count = &mut counts[usize::from(view.path.starts_with("passes["))];
        *count += 1;
        *count <= MAX_FORM_TABLES
    };
    let form = FormView { tables: views.filter(shown).collect(), passes: points::passes(&tables) };
    let wrong = (format.fault)(text.text()).map(|error| wrong_view(&error));
    Ok(FormAnswer { text: text.text().to_owned(), form: Some(form), wrong })
}

/// The changes of entries that a change of a form consists of.
fn expanded(tables: &[TableEntries], change: FormChange, format_of: FormatOf) -> Result<Vec<Change>, DocumentError> {
    Ok(match change {
        FormChange::Set { path, value } => vec![Change::Set { path, value }],
        FormChange::Remove { path } => vec![Change::Remove { path }],
        FormChange::Insert { path, value } => vec![Change::Insert { path, value }],
        FormChange::Move { path, to } => vec![Change::Move { path, to }],
        FormChange::Add { path } => {
            let value = start(&format_of(tables).schema, &path)?;
            vec![Change::Set { path, value }]
        }
        FormChange::Choose { path, kind } => chosen(&format_of(tables).schema, tables, &path, kind)?,
    })
}

/// The value that is added at a path.
fn start(schema: &Schema, path: &str) -> Result<Value, DocumentError> {
    let value = steps(path).and_then(|steps| schema.start_at(&steps));
    value.ok_or_else(|| DocumentError::at_key(JOB, path, Message::new("document-unfit-change")))
}

/// Another kind of a table: values that both kinds have stay.
fn chosen(schema: &Schema, tables: &[TableEntries], path: &str, kind: String) -> Result<Vec<Change>, DocumentError> {
    let mut to = steps(path).unwrap_or_default();
    to.pop();
    to.push(Step::Key(kind.clone()));
    let to = path_of(&to);
    let start = start(schema, &to)?;
    let has_same = |entry: &Entry| {
        matches!(
            (&entry.value, start.get(&entry.key)),
            (EntryValue::Number(_), Some(Value::Number(_))) | (EntryValue::Text(_), Some(Value::String(_)))
        )
    };
    let old = tables.iter().find(|table| table.path == path).map(|table| &table.entries[..]).unwrap_or_default();
    let (same, other): (Vec<&Entry>, Vec<&Entry>) = old.iter().partition(|entry| has_same(entry));
    let new = start.as_object().into_iter().flatten().filter(|(key, _)| same.iter().all(|entry| entry.key != **key));
    let set = new.map(|(key, value)| Change::Set { path: format!("{to}.{key}"), value: value.clone() });
    let removed = other.iter().map(|entry| Change::Remove { path: entry.path.clone() });
    Ok(removed.chain([Change::Rename { path: path.to_owned(), key: kind }]).chain(set).collect())
}

fn table_view(schema: &Schema, table: &TableEntries, steps: &[Step]) -> FormTable {
    let place = schema.at(steps);
    let own = table.entries.iter().map(|entry| entry.key.as_str());
    let present: Vec<&str> = own.chain(table.tables.iter().map(String::as_str)).collect();
    // The number of the format's version is nothing to choose.
    let shown = table.entries.iter().filter(|entry| !(steps.is_empty() && entry.key == "schema"));
    FormTable {
        path: table.path.clone(),
        entries: shown.map(|entry| entry_view(schema, &place, entry, steps)).collect(),
        addable: schema.addable(&place, steps, &present),
        kinds: schema.kinds(steps),
        removable: schema.is_removable(steps),
    }
}

fn entry_view(schema: &Schema, above: &Place<'_>, entry: &Entry, steps: &[Step]) -> FormEntry {
    let step = Step::Key(entry.key.clone());
    let (place, steps) = (schema.below(above, &step), [steps, &[step]].concat());
    // What a list allows is what its elements are.
    let mut single = place.clone();
    let mut value = &entry.value;
    while let EntryValue::List(items) = value {
        single = schema.below(&single, &Step::Nth(0));
        let Some(first) = items.first() else { break };
        value = first;
    }
    FormEntry {
        key: entry.key.clone(),
        path: entry.path.clone(),
        value: value_view(schema, &place, &entry.value, &steps),
        line: entry.line,
        comment: entry.comment.clone(),
        help: place.help(),
        choices: single.choices(),
        range: single.range(&entry.key),
    }
}

fn value_view(schema: &Schema, place: &Place<'_>, value: &EntryValue, steps: &[Step]) -> FormValue {
    match value {
        EntryValue::Number(number) => FormValue::Number { number: *number },
        EntryValue::Text(text) => FormValue::Text { text: text.clone() },
        EntryValue::Truth(truth) => FormValue::Truth { truth: *truth },
        EntryValue::List(items) if items.len() > MAX_ITEMS => FormValue::Long { count: items.len() },
        EntryValue::List(items) => {
            let item = |(i, item)| {
                let step = Step::Nth(i);
                value_view(schema, &schema.below(place, &step), item, &[steps, &[step]].concat())
            };
            FormValue::List { items: items.iter().enumerate().map(item).collect() }
        }
        EntryValue::Table(entries) => {
            let present: Vec<&str> = entries.iter().map(|entry| entry.key.as_str()).collect();
            FormValue::Table {
                entries: entries.iter().map(|entry| entry_view(schema, place, entry, steps)).collect(),
                addable: schema.addable(place, steps, &present),
            }
        }
    }
}

#[cfg(test)]
mod tests;
