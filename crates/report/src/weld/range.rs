//! Ranges of figures, and their texts.

use crate::Language;
use crate::number::{from_to, number, significant};

/// Minimum and maximum of a figure.
#[derive(Debug, Clone, Copy)]
pub(super) struct Range {
    pub(super) min: f64,
    pub(super) max: f64,
}

impl From<(f64, f64)> for Range {
    fn from((min, max): (f64, f64)) -> Self {
        Self { min, max }
    }
}

impl Range {
    /// Returns the range of the values; from ∞ to -∞ if empty.
    pub(super) fn of(values: impl Iterator<Item = f64>) -> Self {
        let empty = Self { min: f64::INFINITY, max: f64::NEG_INFINITY };
        values.fold(empty, |range, v| Self { min: range.min.min(v), max: range.max.max(v) })
    }

    /// Formats the value, or the range of several.
    pub(super) fn text(self, language: Language) -> String {
        let [min, max] = [self.min, self.max].map(|value| number(value, language));
        if self.max > self.min { from_to(min, max, language) } else { min }
    }

    /// Formats the range to three digits.
    pub(super) fn short_text(self, language: Language) -> String {
        let [min, max] = [self.min, self.max].map(|value| significant(value, 3, language));
        if min == max { min } else { from_to(min, max, language) }
    }
}
