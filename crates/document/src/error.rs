use seamwright_message::{Language, Message};
use std::fmt::{self, Write};
use std::ops::Range;

/// An error in a document, with its address.
///
/// Its `Display` fits a screen: the address, the fault, the line with the position marked, the allowed values, and
/// help.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DocumentError {
    /// File name as the user gave it.
    pub file: String,
    /// Line, from 1; 0 if the whole file is meant.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Path of the key, like `seam.nozzle.radius_mm`.
    pub key: String,
    /// The value found, as written.
    pub value: String,
    /// Description of the fault.
    pub message: Message,
    /// Allowed values.
    pub allowed: Option<Message>,
    /// A suggestion.
    pub help: Option<Message>,
    pub(crate) source_line: String,
    pub(crate) marked: usize,
}

impl std::error::Error for DocumentError {}

impl DocumentError {
    /// Returns the error in `language`, as `Display` prints it in that of the process.
    pub fn in_language(&self, language: Language) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = self.write(&mut text, language);
        text
    }

    fn write(&self, f: &mut impl Write, language: Language) -> fmt::Result {
        write!(f, "{}", self.file)?;
        if self.line > 0 {
            write!(f, ":{}:{}", self.line, self.column)?;
        }
        if !self.key.is_empty() {
            write!(f, ": {}", self.key)?;
            if !self.value.is_empty() {
                write!(f, " = {}", self.value)?;
            }
        }
        writeln!(f, ": {}", self.message.in_language(language))?;
        if self.line > 0 {
            let number = self.line.to_string();
            let margin = " ".repeat(number.len());
            writeln!(f, " {margin} |")?;
            writeln!(f, " {number} | {}", self.source_line)?;
            let mark = "^".repeat(self.marked.max(1));
            writeln!(f, " {margin} | {}{mark}", " ".repeat(self.column.saturating_sub(1)))?;
        }
        if let Some(allowed) = &self.allowed {
            let allowed = Message::new("document-allowed").message("allowed", allowed.clone());
            writeln!(f, "   {}", allowed.in_language(language))?;
        }
        if let Some(help) = &self.help {
            let help = Message::new("document-help").message("help", help.clone());
            writeln!(f, "   {}", help.in_language(language))?;
        }
        if !self.message.is_verbatim() {
            let code = Message::new("document-code").text("code", self.message.code.clone());
            writeln!(f, "   {}", code.in_language(language))?;
        }
        Ok(())
    }
}

impl fmt::Display for DocumentError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.write(f, Language::of_process())
    }
}

/// Line (from 1), column (from 1, in characters), the line's text and how many of its characters `span` covers.
pub(crate) fn place(text: &str, span: &Range<usize>) -> (usize, usize, String, usize) {
    let start = floor_char(text, span.start.min(text.len()));
    let line_start = text[..start].rfind('\n').map_or(0, |i| i + 1);
    let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
    let line = text[..start].matches('\n').count() + 1;
    let end = floor_char(text, span.end.clamp(start, line_end));
    let source = text[line_start..line_end].trim_end_matches('\r').replace('\t', " ");
    (line, text[line_start..start].chars().count() + 1, source, text[start..end].chars().count())
}

fn floor_char(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}
