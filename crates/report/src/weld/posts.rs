//! Verification of each part program written with the plan.

use super::blocks::{number, table};
use crate::block::Block;
use crate::names;
use crate::number::{Significant as _, fixed};
use crate::words::Words as _;
use seamwright_message::{Language, Message, Unit};
use seamwright_post::{Dialect, Verification};
use serde::Serialize;

/// A part program written with the plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PostFigures {
    /// Name of the control's language.
    pub dialect: &'static str,
    /// File name.
    pub file: String,
    /// Maximum allowed distance between the path of the blocks and the planned path of the torch tip, mm.
    pub tolerance_mm: f64,
    /// Comparison of the text, read back, with the plan.
    pub proof: Verification,
}

impl PostFigures {
    /// Creates the figures of a part program in the file `file`.
    pub fn new(dialect: Dialect, file: &str, tolerance_mm: f64, proof: Verification) -> Self {
        Self { dialect: dialect.name(), file: file.to_owned(), tolerance_mm, proof }
    }

    /// Returns text and table for the page.
    pub(super) fn blocks(&self, language: Language) -> [Block; 2] {
        let text = Message::new("report-program")
            .text("file", &self.file)
            .text("dialect", self.dialect)
            .count("n", self.proof.moves)
            .significant("tolerance", self.tolerance_mm, Unit::Mm, 5)
            .in_language(language);
        let worst = |worst: &Option<(f64, String)>, unit| match worst {
            Some((off, name)) => format!("{name} {}", quantity(*off, unit, 5).in_language(language)),
            None => "–".to_owned(),
        };
        let process = |(off, name): &(f64, String)| (*off, names::value_title(language, name));
        let rows = self.proof.passes.iter().map(|pass| {
            if pass.as_it_stands {
                let none = || language.words("report-as-in-program");
                return vec![pass.name.clone(), none(), none(), none(), none(), number(pass.arc_s, language), none()];
            }
            vec![
                pass.name.clone(),
                fixed(pass.tip_mm, 5, language),
                worst(&pass.linear, Unit::Mm),
                worst(&pass.rotary, Unit::Deg),
                quantity(pass.speed_percent.max(pass.speed_inside_percent), Unit::Percent, 2).in_language(language),
                format!("{} ({})", number(pass.arc_s, language), signed_percent(pass.time_percent, language)),
                worst(&pass.process.as_ref().map(process), Unit::Percent),
            ]
        });
        let head = [
            "report-column-pass",
            "report-column-tip-mm",
            "report-column-linear-axis",
            "report-column-rotary-axis",
            "report-column-tip-speed",
            "report-column-arc-on-s",
            "report-column-process-value",
        ];
        let caption = Message::new("report-caption-program").text("file", &self.file).in_language(language);
        let table = table(&caption, &head.map(|head| language.words(head)), rows.collect(), 1..7);
        [Block::Paragraph(text), table]
    }
}

fn quantity(value: f64, unit: Unit, decimals: u8) -> Message {
    Message::new("quantity").quantity("value", value, unit, decimals)
}

/// Formats a percentage with its sign, also of positive ones.
fn signed_percent(percent: f64, language: Language) -> String {
    let sign = if percent < 0.0 { "" } else { "+" };
    format!("{sign}{}", quantity(percent, Unit::Percent, 4).in_language(language))
}
