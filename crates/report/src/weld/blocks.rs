//! Blocks of the pages.

use crate::block::{Block, Table};
use crate::number::significant;
use crate::words::Words as _;
use seamwright_message::Language;

/// Formats lengths, times and positions.
pub(super) fn number(value: f64, language: Language) -> String {
    significant(value, 5, language)
}

/// Formats errors and deviations, for which two digits suffice.
pub(super) fn small(value: f64, language: Language) -> String {
    significant(value, 2, language)
}

pub(super) fn paragraph(text: &'static str, language: Language) -> Block {
    Block::Paragraph(language.words(text))
}

pub(super) fn figure(svg: String, caption: &'static str, language: Language) -> Block {
    Block::Figure { svg, caption: language.words(caption) }
}

pub(crate) fn table(caption: &str, head: &[String], rows: Vec<Vec<String>>, numeric: std::ops::Range<usize>) -> Block {
    Block::Table(Table {
        caption: caption.to_owned(),
        head: head.to_vec(),
        numeric: (0..head.len()).map(|i| numeric.contains(&i)).collect(),
        rows,
    })
}
