use crate::document::build;
use seamwright_message::Message;
use std::fmt;
use std::ops::Range;

/// An error in a document, with its address.
///
/// Its `Display` fits a screen: the address, the fault, the line with the position marked, the allowed values, and
/// help.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
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
    /// A fault at the key `key` of a file as a whole.
    pub fn at_key(file: &str, key: impl Into<String>, message: Message) -> Self {
        Self { file: file.to_owned(), column: 1, key: key.into(), message, ..Self::default() }
    }

    /// A fault at a range of bytes of `text`, a file in another format; `key` is its address in the form of that format.
    pub fn in_text(file: &str, text: &str, span: &Range<usize>, key: impl Into<String>, message: Message) -> Self {
        Self { message, ..build(file, text, span, key.into()) }
    }

    /// Returns the whole error as one message, with a line for each part.
    pub fn to_message(&self) -> Message {
        let mut at = self.file.clone();
        if self.line > 0 {
            at += &format!(":{}:{}", self.line, self.column);
        }
        if !self.key.is_empty() {
            at += &format!(": {}", self.key);
            if !self.value.is_empty() {
                at += &format!(" = {}", self.value);
            }
        }
        let mut lines = vec![Message::new("document-error").text("at", at).message("message", self.message.clone())];
        if self.line > 0 {
            let number = self.line.to_string();
            let margin = " ".repeat(number.len());
            let mark = " ".repeat(self.column.saturating_sub(1)) + &"^".repeat(self.marked.max(1));
            lines.push(Message::verbatim(format!(" {margin} |")));
            lines.push(Message::verbatim(format!(" {number} | {}", self.source_line)));
            lines.push(Message::verbatim(format!(" {margin} | {mark}")));
        }
        let allowed = |allowed: &Message| Message::new("document-allowed").message("allowed", allowed.clone());
        lines.extend(self.allowed.as_ref().map(|text| allowed(text).indented()));
        let help = |help: &Message| Message::new("document-help").message("help", help.clone());
        lines.extend(self.help.as_ref().map(|text| help(text).indented()));
        if !self.message.is_verbatim() {
            lines.push(Message::new("document-code").text("code", self.message.code.clone()).indented());
        }
        Message::lines(lines)
    }
}

impl fmt::Display for DocumentError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(f, "{}", self.to_message())
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
