use super::WrongView;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use ts_rs::TS;

/// `POST /api/form`: a text, and changes of its entries that are made first; nothing is saved.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FormText {
    /// TOML of a job, a program, a procedure or a machine.
    pub text: String,
    /// Changes, one after the other.
    #[serde(default)]
    pub changes: Vec<FormChange>,
}

/// A change of an entry; everything else of the text stays as it is. Paths are like `passes[0].points.start[2]`.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(tag = "op", rename_all = "snake_case", deny_unknown_fields)]
pub enum FormChange {
    /// Sets a value; a missing key is added.
    Set {
        /// Path of the value.
        path: String,
        /// Number, text, truth, list or table.
        #[ts(type = "unknown")]
        value: Value,
    },
    /// Adds a key with a value to begin with.
    Add {
        /// Path of the key.
        path: String,
    },
    /// Gives a table that is one of several kinds another kind; values that both have stay.
    Choose {
        /// Path of the table, the kind is its last key.
        path: String,
        /// The new kind.
        kind: String,
    },
    /// Removes a key, a table with all tables within it, or an element of a list.
    Remove {
        /// Its path.
        path: String,
    },
    /// Inserts an element into a list before the one at the path, or behind the last one.
    Insert {
        /// Path of the new element.
        path: String,
        /// A value; a table in a list of tables.
        #[ts(type = "unknown")]
        value: Value,
    },
    /// Moves an element of a list.
    Move {
        /// Path of the element.
        path: String,
        /// Its new index.
        to: usize,
    },
}

/// Its answer.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FormAnswer {
    /// The text with the changes.
    pub text: String,
    /// Its form; none if the text is not TOML.
    pub form: Option<FormView>,
    /// First fault that reading finds.
    pub wrong: Option<WrongView>,
}

/// Contents of a text, and additions that its format allows.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FormView {
    /// Tables in the order of the text.
    pub tables: Vec<FormTable>,
    /// Passes through points.
    pub passes: Vec<PointsView>,
}

/// A table with the entries under its header, or the root.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FormTable {
    /// Path of the table; empty for the root.
    pub path: String,
    /// Its values.
    pub entries: Vec<FormEntry>,
    /// Keys that it can still be given.
    pub addable: Vec<AddableView>,
    /// The kinds that the table can be of, if its last key is one of several; empty otherwise.
    pub kinds: Vec<String>,
    /// Whether the format allows to remove it.
    pub removable: bool,
}

/// A key with its value, and what the format says of it.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FormEntry {
    /// The key.
    pub key: String,
    /// Its path.
    pub path: String,
    /// The value.
    pub value: FormValue,
    /// Line, from 1.
    pub line: usize,
    /// Comment behind the value.
    pub comment: String,
    /// Description in the format.
    pub help: String,
    /// Allowed texts; empty if any text is allowed.
    pub choices: Vec<String>,
    /// Allowed numbers.
    pub range: Option<RangeView>,
}

/// Allowed numbers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, TS, JsonSchema)]
pub struct RangeView {
    /// Smallest number.
    pub min: Option<f64>,
    /// Whether the smallest number itself is excluded.
    pub open: bool,
    /// Largest number.
    pub max: Option<f64>,
}

/// A value.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum FormValue {
    /// A number.
    Number {
        /// The number.
        number: f64,
    },
    /// A text.
    Text {
        /// The text.
        text: String,
    },
    /// True or false.
    Truth {
        /// The value.
        truth: bool,
    },
    /// A short list.
    List {
        /// Its elements.
        items: Vec<FormValue>,
    },
    /// A list that is too long for a form.
    Long {
        /// Number of its elements.
        count: usize,
    },
    /// An inline table.
    Table {
        /// Its entries.
        entries: Vec<FormEntry>,
        /// Keys that it can still be given.
        addable: Vec<AddableView>,
    },
}

/// A key that a table can be given.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct AddableView {
    /// The key.
    pub key: String,
    /// Its path.
    pub path: String,
    /// Description in the format.
    pub help: String,
    /// Whether its value is a table.
    pub is_table: bool,
}

/// The points of a pass as they are written.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct PointsView {
    /// From 1.
    pub pass: usize,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Whether arc or beam is on.
    pub arc: bool,
    /// Columns that cubics have speeds of; empty without cubics.
    pub moving: Vec<String>,
    /// The start and the points.
    pub rows: Vec<PointRow>,
}

/// A point.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct PointRow {
    /// The way to it; empty for the start.
    pub along: String,
    /// Its span, from 1; 0 for the start.
    pub span: usize,
    /// A number for each column; null for an expression.
    pub numbers: Vec<Option<f64>>,
    /// Speeds of `moving` where a cubic ends or begins; null for an expression.
    pub speeds: Vec<Option<f64>>,
}
