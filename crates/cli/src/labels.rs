//! Labels in columns of a terminal.

use seamwright_message::Message;
use std::fmt::{Display, Write as _};

/// Minimum width of the labels of a summary.
const MIN_WIDTH: usize = 12;

/// Labels whose width decides the width of all labels of a summary.
const LABELS: [&str; 14] = [
    "cli-label-machine",
    "cli-label-seam",
    "cli-label-speed",
    "cli-label-time",
    "cli-label-energy",
    "cli-label-clearance",
    "cli-label-takes",
    "cli-label-duty",
    "cli-label-cost",
    "cli-label-waits",
    "cli-label-transfers",
    "cli-label-wrote",
    "cli-label-path-error",
    "cli-label-tip-speed",
];

/// Returns `text` with spaces up to `width` columns.
pub(crate) fn padded(text: &str, width: usize) -> String {
    format!("{text}{}", " ".repeat(width.saturating_sub(columns(text))))
}

/// Number of columns that `text` takes: two for a Chinese character.
pub(crate) fn columns(text: &str) -> usize {
    let is_wide = |c: &char| matches!(c, '\u{2e80}'..='\u{a4cf}' | '\u{f900}'..='\u{faff}' | '\u{fe30}'..='\u{fe6f}' | '\u{ff00}'..='\u{ff60}');
    text.chars().count() + text.chars().filter(is_wide).count()
}

/// Width of the labels of a weld's summary in the language of the process.
pub(crate) fn width() -> usize {
    width_of(&LABELS, MIN_WIDTH)
}

/// Width of the widest of the labels `codes` in the language of the process, at least `min`.
pub(crate) fn width_of(codes: &[&'static str], min: usize) -> usize {
    codes.iter().map(|code| columns(&Message::new(code).to_string())).fold(min, usize::max)
}

pub(crate) fn line(text: &mut String, label: &str, value: impl Display) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "  {} {value}", padded(label, width()));
}

/// Adds an indented line with the label of this code to a summary.
pub(crate) fn labelled(text: &mut String, code: &'static str, value: impl Display) {
    line(text, &Message::new(code).to_string(), value);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_padded_to_columns() {
        assert_eq!(padded("seam", 6), "seam  ");
        assert_eq!(padded("焊缝", 6), "焊缝  ");
        assert_eq!(padded("довгий напис", 6), "довгий напис");
        assert_eq!(width(), MIN_WIDTH);
    }
}
