use crate::stored_message;
use rusqlite::Connection;
use rusqlite::functions::FunctionFlags;
use seamwright_message::Language;
use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

/// Maximum number of columns whose answer is remembered.
const MAX_REMEMBERED: usize = 10_000;

/// Answers for the text of the last search.
#[derive(Default)]
struct Search {
    text: String,
    lower_case: String,
    answers: HashMap<String, bool>,
}

/// Defines the SQL function `has_words(column, text)`: true if `text` is in the words of the column's message in any
/// language. Upper and lower case are the same. A query with a limit formats messages only until it is reached.
pub(super) fn define(db: &Connection) -> rusqlite::Result<()> {
    let search = Mutex::new(Search::default());
    let flags = FunctionFlags::SQLITE_UTF8 | FunctionFlags::SQLITE_DETERMINISTIC;
    db.create_scalar_function("has_words", 2, flags, move |context| {
        let mut search = search.lock().unwrap_or_else(PoisonError::into_inner);
        let (column, text) = (context.get_raw(0).as_str_or_null()?, context.get_raw(1).as_str()?);
        Ok(column.is_some_and(|column| search.has_words(column, text)))
    })
}

impl Search {
    fn has_words(&mut self, column: &str, text: &str) -> bool {
        if self.text != text {
            *self = Self { text: text.to_owned(), lower_case: text.to_lowercase(), answers: HashMap::new() };
        }
        if !column.starts_with('{') {
            return column.to_lowercase().contains(&self.lower_case);
        }
        if let Some(answer) = self.answers.get(column) {
            return *answer;
        }
        let message = stored_message::read(column.to_owned());
        let answer =
            Language::ALL.into_iter().any(|of| message.in_language(of).to_lowercase().contains(&self.lower_case));
        if self.answers.len() >= MAX_REMEMBERED {
            self.answers.clear();
        }
        self.answers.insert(column.to_owned(), answer);
        answer
    }
}
