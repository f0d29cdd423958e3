use schemars::JsonSchema;
use seamwright_message::{Language, Message};
use serde::{Serialize, Serializer};

/// Result of an edit.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Report {
    /// Description, in English words; also the edit's name in the history.
    #[serde(serialize_with = "in_english")]
    #[schemars(with = "String")]
    pub words: Message,
    /// False if the document was so already.
    pub changed: bool,
    /// Changed positions.
    pub touched: Vec<Touched>,
}

fn in_english<S: Serializer>(message: &Message, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&message.in_language(Language::English))
}

/// Part of a program that was edited, by its place after the edit.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Touched {
    /// The pass, from 1.
    pub pass: usize,
    /// The first and last span, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spans: Option<[usize; 2]>,
    /// The first and last point; 0 is the start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub points: Option<[usize; 2]>,
}

impl Report {
    pub(super) fn new(words: Message) -> Self {
        Self { words, changed: true, touched: Vec::new() }
    }

    pub(super) fn pass(self, pass: usize) -> Self {
        self.at(Touched { pass, spans: None, points: None })
    }

    pub(super) fn spans(self, pass: usize, first: usize, last: usize) -> Self {
        self.at(Touched { pass, spans: Some([first, last]), points: None })
    }

    pub(super) fn points(self, pass: usize, first: usize, last: usize) -> Self {
        self.at(Touched { pass, spans: None, points: Some([first, last]) })
    }

    pub(super) fn at(mut self, touched: Touched) -> Self {
        self.touched.push(touched);
        self
    }
}
