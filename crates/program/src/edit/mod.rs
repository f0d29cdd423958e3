//! Edits of a program, as a panel and the command line make them. They change the document, so that comments and layout
//! stay, and are checked, so that a program stays valid.
//!
//! An [`Operation`] is made in a draft of the typed program. In it each pass, span, point and event knows its origin in
//! the document; differences are then written there. The text is read again: it must be a valid program equal to the
//! draft. [`Editor::undo`] restores the text byte by byte.

mod cubics;
mod draft;
mod format;
mod history;
mod merge;
mod mirror_and_offset;
mod operation;
mod pass_direction;
mod passes;
mod points;
mod reduce;
mod reordered_events;
mod report;
mod rows;
mod spans;
mod speeds;
mod values;
mod write;

pub use history::{History, Patch};
pub use mirror_and_offset::{Mirror, Offset};
pub use operation::Operation;
pub use pass_direction::{ReversePass, ShiftStart};
pub use passes::{
    AddEvent, AddPass, DeleteEvent, DeletePass, DuplicatePass, MovePass, SetOffset, SetPass, SetVariable,
};
pub use points::{DeletePoints, InsertPoint, SetPoint};
pub use reduce::Reduce;
pub use report::{Report, Touched};
pub use spans::{Interpolate, JoinSpans, SplitSpan};
pub use values::{Renumber, ScaleSpeed, SetProcess};

use crate::program::Program;
use draft::Draft;
use seamwright_document::{Document, DocumentError};
use seamwright_message::Message;

/// A program under edit: its text, its values, and its history.
#[derive(Debug, Clone)]
pub struct Editor {
    file: String,
    text: String,
    program: Document<Program>,
    history: History,
}

impl Editor {
    /// Opens a program's text, calling it `file` in errors.
    ///
    /// # Errors
    /// The first thing wrong with the program, with its address.
    pub fn new(file: &str, text: &str) -> Result<Self, DocumentError> {
        Self::with_history(file, text, History::default())
    }

    /// The same with the history of the text.
    ///
    /// # Errors
    /// As for [`Editor::new`].
    pub fn with_history(file: &str, text: &str, history: History) -> Result<Self, DocumentError> {
        Ok(Self { file: file.to_owned(), text: text.to_owned(), program: Program::read(file, text)?, history })
    }

    /// The document.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The program, with expressions as their numbers.
    pub fn program(&self) -> &Program {
        &self.program.value
    }

    /// History of the edits.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Makes an edit.
    ///
    /// # Errors
    /// The reason for a refusal: the operation refers to a missing object, or the result would be invalid. The document
    /// stays unchanged.
    pub fn apply(&mut self, operation: &Operation) -> Result<Report, DocumentError> {
        let (text, program, report) = self.edited(operation)?;
        let changed = text != self.text;
        if changed {
            self.history.push(Patch::between(report.words.clone(), &self.text, &text));
            (self.text, self.program) = (text, program);
        }
        Ok(Report { changed, ..report })
    }

    /// Makes several edits one after the other; each is in the history.
    ///
    /// # Errors
    /// The index of the first one refused, and the reason; then no edit is made.
    pub fn apply_all(&mut self, operations: &[Operation]) -> Result<Vec<Report>, (usize, DocumentError)> {
        let mut edited = self.clone();
        let reports = operations.iter().enumerate().map(|(i, o)| edited.apply(o).map_err(|e| (i, e)));
        let reports = reports.collect::<Result<_, _>>()?;
        *self = edited;
        Ok(reports)
    }

    fn edited(&self, operation: &Operation) -> Result<(String, Document<Program>, Report), DocumentError> {
        let mut draft = Draft::new(&self.program);
        let report = operation.apply(&mut draft)?;
        let meant = draft.program()?;
        let text = match operation {
            Operation::Format => format::formatted(&self.text, &self.program)?,
            _ => write::write(&self.text, &draft)?,
        };
        let program = Program::read(&self.file, &text).map_err(|mut e| {
            let refused = Message::new("program-edit-refused");
            e.help = Some(match e.help {
                Some(help) => {
                    let refused = Message::new("document-help").message("help", refused);
                    Message::new("program-help-and-help").message("first", help).message("second", refused)
                }
                None => refused,
            });
            e
        })?;
        if !draft.is_recomputed && program.value != meant {
            let message = Message::new("program-edit-layout");
            return Err(self.program.error_at("", message, Message::new("program-usual-layout")));
        }
        Ok((text, program, report))
    }

    /// Undoes the last edit: the text is byte by byte as before. Returns its description; `None` if there is nothing to
    /// undo.
    ///
    /// # Errors
    /// The text differs from that of the history.
    pub fn undo(&mut self) -> Result<Option<Message>, DocumentError> {
        if self.history.done().is_empty() { Ok(None) } else { self.step(History::undo).map(Some) }
    }

    /// Redoes the last edit that was undone. Returns its description; `None` if there is nothing to redo.
    ///
    /// # Errors
    /// The text differs from that of the history.
    pub fn redo(&mut self) -> Result<Option<Message>, DocumentError> {
        if self.history.undone().is_empty() { Ok(None) } else { self.step(History::redo).map(Some) }
    }

    fn step(&mut self, step: fn(&mut History, &str) -> Option<(String, Message)>) -> Result<Message, DocumentError> {
        let mut history = std::mem::take(&mut self.history);
        let before = history.done;
        let made = step(&mut history, &self.text).ok_or_else(|| {
            let message = Message::new("program-history-of-other-text");
            self.program.error_at("", message, Message::new("program-text-of-last-edit"))
        });
        let read = made.and_then(|(text, name)| Ok((Program::read(&self.file, &text)?, text, name)));
        if read.is_err() {
            history.done = before;
        }
        self.history = history;
        let name;
        (self.program, self.text, name) = read?;
        Ok(name)
    }
}
