use crate::part_program::Level;
use seamwright_message::Message;

/// Something that a lenient reader left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// The words.
    pub text: String,
    /// Reason why they were not understood.
    pub why: Message,
}

/// Options of the reader.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// Whether words that are not understood are listed and left out, instead of being errors.
    pub lenient: bool,
    /// Level at which the control interpolates at the start.
    pub level: Level,
    /// The row before the first block, as many numbers as the control has channels (mm, degrees); `None`: zeros.
    pub start: Option<Vec<f64>>,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self { lenient: false, level: Level::Joint, start: None }
    }
}
