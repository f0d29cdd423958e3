use seamwright_message::Message;
use std::fmt;

/// Invalid text in a part program, with its position.
///
/// Its `Display` fits a screen: the address, the fault, the line with the position marked, what is allowed, and help.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReadError {
    /// File name as the caller gave it.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// The line's text.
    pub text: String,
    /// Description of the fault.
    pub message: Message,
    /// Allowed values or words.
    pub allowed: Option<Message>,
    /// Operator action.
    pub cure: Option<Message>,
    marked: usize,
}

impl std::error::Error for ReadError {}

impl ReadError {
    /// Returns the address and the fault as one message.
    pub fn located(&self) -> Message {
        Message::new("post-located")
            .text("file", &self.file)
            .text("line", self.line.to_string())
            .text("column", self.column.to_string())
            .message("message", self.message.clone())
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(f, "{}:{}:{}: {}", self.file, self.line, self.column, self.message)?;
        let number = self.line.to_string();
        let margin = " ".repeat(number.len());
        writeln!(f, " {margin} |")?;
        writeln!(f, " {number} | {}", self.text)?;
        writeln!(f, " {margin} | {}{}", " ".repeat(self.column.saturating_sub(1)), "^".repeat(self.marked.max(1)))?;
        if let Some(allowed) = &self.allowed {
            writeln!(f, "   {}", Message::new("document-allowed").message("allowed", allowed.clone()))?;
        }
        if let Some(cure) = &self.cure {
            writeln!(f, "   {}", Message::new("document-help").message("help", cure.clone()))?;
        }
        Ok(())
    }
}

/// A range of the text: from this byte up to that one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Span {
    pub(crate) from: usize,
    pub(crate) to: usize,
}

/// A fault at a position, before its line and column are counted.
#[derive(Debug, Clone)]
pub(crate) struct Fault {
    pub(crate) span: Span,
    pub(crate) message: Message,
    allowed: Option<Message>,
    cure: Option<Message>,
    /// Whether the text is only unknown, so that a lenient reader may leave it out.
    pub(crate) unknown: bool,
}

/// A message, or the code of one without arguments.
pub(crate) struct Words(Message);

impl From<&'static str> for Words {
    fn from(code: &'static str) -> Self {
        Self(Message::new(code))
    }
}

impl From<Message> for Words {
    fn from(message: Message) -> Self {
        Self(message)
    }
}

/// Result of reading a part of a line. The fault is boxed, so that a good result stays small.
pub(crate) type Read<T = ()> = Result<T, Box<Fault>>;

impl Fault {
    /// Something is wrong.
    pub(crate) fn new(span: Span, message: impl Into<Words>) -> Box<Self> {
        Box::new(Self { span, message: message.into().0, allowed: None, cure: None, unknown: false })
    }

    /// Something is not understood.
    pub(crate) fn unknown(span: Span, message: impl Into<Words>) -> Box<Self> {
        let mut fault = Self::new(span, message);
        fault.unknown = true;
        fault
    }

    pub(crate) fn allowed(mut self: Box<Self>, allowed: impl Into<Words>) -> Box<Self> {
        self.allowed = Some(allowed.into().0);
        self
    }

    pub(crate) fn cure(mut self: Box<Self>, cure: impl Into<Words>) -> Box<Self> {
        self.cure = Some(cure.into().0);
        self
    }

    /// With line and column in `text`, which is called `file`.
    pub(crate) fn placed(self, file: &str, text: &str) -> ReadError {
        let start = floor_char(text, self.span.from.min(text.len()));
        let line_start = text[..start].rfind('\n').map_or(0, |i| i + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
        let end = floor_char(text, self.span.to.clamp(start, line_end));
        ReadError {
            file: file.to_owned(),
            line: text[..start].matches('\n').count() + 1,
            column: text[line_start..start].chars().count() + 1,
            text: text[line_start..line_end].trim_end_matches('\r').replace('\t', " "),
            message: self.message,
            allowed: self.allowed,
            cure: self.cure,
            marked: text[start..end].chars().count(),
        }
    }
}

/// The character boundary at or before byte `at`.
pub(crate) fn floor_char(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// A code of a modal group, of which a block may have one: marks it in `groups`.
pub(crate) fn once(groups: &mut u32, group: u32, span: Span) -> Read {
    if *groups & group != 0 {
        return Err(Fault::new(span, "post-same-group").cure("post-omit-one"));
    }
    *groups |= group;
    Ok(())
}
